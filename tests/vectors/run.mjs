// SPDX-License-Identifier: CC0-1.0
// node run.mjs [--all] ADAPTER.mjs FILE.json...: runs vectors against the functions that ADAPTER exports by their group's
// name. Arguments come in the order of the group, those of one number as a number, others as an array; a function
// returns its results as an array of numbers and arrays. Format: docs/vectors.md.
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const all = process.argv[2] === "--all";
const [adapter, ...files] = process.argv.slice(all ? 3 : 2);
const functions = await import(pathToFileURL(resolve(adapter)).href);
const special = { nan: NaN, inf: Infinity, "-inf": -Infinity };
const number = (x) => (typeof x === "string" ? special[x] : x);

// The largest difference of got times sign from want; infinite where only one is a NaN.
function difference(got, want, sign) {
  if (got.length !== want.length) return Infinity;
  let largest = 0;
  want.forEach((w, i) => {
    const g = sign * got[i];
    const d = (Number.isNaN(g) && Number.isNaN(w)) || g === w ? 0 : Math.abs(g - w);
    largest = Math.max(largest, Number.isNaN(d) ? Infinity : d);
  });
  return largest;
}

function holds(compare, got, want, bound) {
  if (compare === "nan") return got.some(Number.isNaN);
  if (compare === "unit") return Math.abs(Math.hypot(...got) - 1) <= bound;
  const d = difference(got, want, 1);
  if (compare === "exact") return d === 0;
  return (compare === "sign" ? Math.min(d, difference(got, want, -1)) : d) <= bound;
}

const counts = {};
let failed = 0, skipped = 0;
for (const file of files) {
  for (const group of JSON.parse(readFileSync(file, "utf8")).groups) {
    const f = functions[group.name];
    if (!f) {
      skipped += group.cases.length;
      continue;
    }
    for (const c of group.cases) {
      const values = group.in.map((a) => c.in[a.name].map(number));
      const results = f(...values.map((v, i) => (group.in[i].count === "1" ? v[0] : v)));
      group.out.forEach((o, i) => {
        const got = [results[i]].flat(), want = c.out[o.name].map(number), bound = group.tolerance * (c.size[i] ?? c.size[0]);
        const right = holds(c.check ?? o.compare, got, want, bound);
        counts[c.class] = (counts[c.class] ?? 0) + (right ? 1 : 0);
        if (right) return;
        failed++;
        console.log(`FAILED ${group.name} ${c.name} ${o.name}, bound ${bound}:\n  got  ${got}\n  want ${want}`);
      });
    }
  }
}
const passed = Object.entries(counts).map(([kind, n]) => `${n} ${kind}`).join(", ");
console.log(`passed: ${passed || "none"}; ${failed} failed; ${skipped} cases without a function`);
process.exit(failed || !passed || (all && skipped) ? 1 : 0);
