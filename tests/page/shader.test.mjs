// SPDX-License-Identifier: MIT
// The WGSL shaders of docs/examples/shaders: Chromium compiles both and runs the compute shader; its vertices are those
// of the formulas in binary64.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import test from 'node:test';

const { NKW_BUILD: build, NKW_ROOT: root, NKW_CHROMIUM: chromium } = process.env;
const VERTICES = 200, JOINTS = 16, FLOATS = 14;

/** Numbers of mulberry32 in -1..1. */
function numbers(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2147483648 - 1;
  };
}

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const scale = (a, s) => a.map(x => x * s);
const unit = a => scale(a, 1 / Math.hypot(...a));
const sum = (...vectors) => vectors.reduce((a, b) => a.map((x, i) => x + b[i]));

/** One vertex of 14 floats, moved by the blend of four matrices, in binary64. */
function moved(vertex, weights, palette) {
  const m = new Array(16).fill(0), total = weights[0] + weights[1] + weights[2] + weights[3];
  for (let k = 0; k < 4; k++)
    for (let e = 0; e < 16; e++)
      m[e] += weights[k] * palette[16 * weights[4 + k] + e];
  const [a, b, c, t] = [0, 4, 8, 12].map(at => m.slice(at, at + 3)), side = Math.sign(dot(a, cross(b, c)));
  const turn = v => unit(sum(scale(a, v[0]), scale(b, v[1]), scale(c, v[2])));
  const [p, n, tangent, bitangent] = [0, 3, 6, 9].map(at => vertex.slice(at, at + 3));
  const point = scale(sum(scale(a, p[0]), scale(b, p[1]), scale(c, p[2]), t), 1 / total);
  const normal = unit(scale(sum(scale(cross(b, c), n[0]), scale(cross(c, a), n[1]), scale(cross(a, b), n[2])), side));
  return [...point, ...normal, ...turn(tangent), ...turn(bitangent), ...vertex.slice(12)];
}

/** In the page: compiles the sources, runs the second one on the buffers, returns its messages and its floats. */
async function run({ sources, buffers, draw, bytes, groups }) {
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter)
    return null;
  const device = await adapter.requestDevice(), messages = [];
  const modules = sources.map(code => device.createShaderModule({ code }));
  for (const module of modules)
    messages.push(...(await module.getCompilationInfo()).messages.map(m => m.message));
  const pipeline = device.createComputePipeline({ layout: 'auto', compute: { module: modules[1], entryPoint: 'main' } });
  const filled = (data, usage) => {
    const buffer = device.createBuffer({ size: data.byteLength, usage: usage | GPUBufferUsage.COPY_DST });
    device.queue.writeBuffer(buffer, 0, data);
    return buffer;
  };
  const result = device.createBuffer({ size: bytes, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC });
  const read = device.createBuffer({ size: bytes, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
  const stored = buffers.map(b => filled(new Float32Array(b), GPUBufferUsage.STORAGE));
  const all = [...stored, result, filled(new Uint32Array(draw), GPUBufferUsage.UNIFORM)];
  const encoder = device.createCommandEncoder(), pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0),
    entries: all.map((buffer, binding) => ({ binding, resource: { buffer } })) }));
  pass.dispatchWorkgroups(groups);
  pass.end();
  encoder.copyBufferToBuffer(result, 0, read, 0, bytes);
  device.queue.submit([encoder.finish()]);
  await read.mapAsync(GPUMapMode.READ);
  return { messages, floats: [...new Float32Array(read.getMappedRange())] };
}

test('the WGSL shaders compile, and the compute shader has the vertices of the formulas', async t => {
  const browser = await createRequire(`${build}/`)('playwright-core').chromium.launch({ executablePath: chromium,
    args: ['--no-sandbox', '--enable-unsafe-webgpu', '--enable-features=Vulkan', '--use-webgpu-adapter=swiftshader'] });
  t.after(() => browser.close());
  const page = await browser.newPage(), address = 'https://shaders.test/';
  await page.route(address, route => route.fulfill({ contentType: 'text/html', body: '<!doctype html>' }));
  await page.goto(address);
  const number = numbers(7), floats = count => Array.from(Float32Array.from({ length: count }, number));
  const palette = floats(JOINTS * 16).map((x, i) => i % 4 === 3 ? (i % 16 === 15 ? 1 : 0) : x + (i % 5 === 0 ? 1.5 : 0));
  const source = floats(VERTICES * FLOATS), weights = [];
  for (let i = 0; i < VERTICES; i++)
    weights.push(...floats(4).map(w => Math.fround(Math.abs(w) + 0.1)),
      ...floats(4).map(x => Math.floor((x + 1) / 2 * JOINTS) % JOINTS));
  const text = name => readFileSync(`${root}/docs/examples/shaders/${name}.wgsl`, 'utf8');
  const got = await page.evaluate(run, { sources: [text('skin_vertex'), text('skin_compute')],
    buffers: [source, weights, palette], draw: [0, VERTICES, 0, 0, 0], bytes: 4 * VERTICES * FLOATS,
    groups: Math.ceil(VERTICES / 64) });
  if (!got)
    return t.skip('this Chromium has no WebGPU adapter');
  assert.deepEqual(got.messages, []);
  for (let i = 0; i < VERTICES; i++) {
    const want = moved(source.slice(i * FLOATS, (i + 1) * FLOATS), weights.slice(8 * i, 8 * i + 8), palette);
    want.forEach((x, k) => assert.ok(Math.abs(got.floats[i * FLOATS + k] - x) <= 1e-4 * Math.max(1, Math.abs(x)),
      `vertex ${i}, float ${k}: ${got.floats[i * FLOATS + k]}, not ${x}`));
  }
});
