
// Structs of C as objects. A layout is [bytes, type, fields ...], a field [name, offset, kind, n, default]: n values of
// a kind f i u h b d q v or of another layout; for a pointer to an array, n is a function of the record that returns
// its length. v are bytes of an object of the package.
const arrayOf = { f: Float32Array, i: Int32Array, u: Uint32Array, h: Uint16Array, b: Uint8Array, d: Float64Array,
  q: BigInt64Array };
const setters = { f: 'setFloat32', i: 'setInt32', u: 'setUint32', h: 'setUint16', b: 'setUint8', d: 'setFloat64',
  q: 'setBigInt64' };
const sizeOf = kind => arrayOf[kind]?.BYTES_PER_ELEMENT ?? kind[0];

// Memory for the time of one call: a part of the arena, or a block.
const arenaBytes = 65536, blocks = [];
let arena = 0, used = 0, view;
function temporary(bytes) {
  arena ||= take(arenaBytes);
  const place = used, end = used + Math.ceil(bytes / 8) * 8;
  if (end <= arenaBytes) {
    used = end;
    return arena + place;
  }
  blocks.push(take(bytes));
  return blocks.at(-1);
}
function $t(f) {
  const before = used, count = blocks.length;
  try {
    return f();
  } finally {
    used = before;
    blocks.splice(count).forEach(x.release);
  }
}

function data() {
  if (view?.buffer !== f32.buffer)
    view = new DataView(f32.buffer);
  return view;
}

// Numbers of arrays within arrays.
const flatten = array => array[0]?.length === undefined ? array : Array.from(array).flatMap(a => [...flatten(a)]);

// The address of a copy of an array of at least n values, or of the values of an object in this memory; 0 for null.
function arrayAt(kind, array, n, name = 'array') {
  if (array === null || array === undefined)
    return 0;
  if (array instanceof Owner) {
    need(`floats of ${name}`, array.count ?? array.floats, n);
    return array._use()._p;
  }
  if (kind === 'v')
    throw new TypeError(`nakawari: ${name} is not of an object of the package`);
  const flat = typeof kind === 'string' ? flatten(array) : array;
  need(`elements of ${name}`, flat.length, n);
  const block = temporary(n * sizeOf(kind));
  if (typeof kind === 'string')
    new arrayOf[kind](f32.buffer, block, n).set(flat.length === n ? flat : Array.prototype.slice.call(flat, 0, n));
  else
    for (let k = 0; k < n; k++)
      put(kind, block + k * kind[0], flat[k]);
  return block;
}

function putField(at, kind, n, value) {
  if (typeof kind !== 'string')
    for (let k = 0; k < n; k++)
      put(kind, at + k * kind[0], n > 1 ? value?.[k] : value);
  else
    for (let k = 0; k < n; k++)
      data()[setters[kind]](at + k * sizeOf(kind), (n > 1 ? value?.[k] : value) ?? (kind === 'q' ? 0n : 0), true);
}

// Writes a record. An object of the package has the struct in its memory, or is an array that the struct names.
function put(layout, at, value) {
  if (value instanceof Owner && value._type === layout[1])
    return void u8.copyWithin(at, value._use()._p, value._p + layout[0]);
  const r = value instanceof Owner
    ? { data: value, jointCount: value.jointCount, format: value.format, halfLife: value.halfLife,
      duration: value.duration }
    : { ...value };
  for (const [name, , , , usual] of layout.slice(2))
    if (usual)
      r[name] ??= usual(r);
  for (const [name, offset, kind, n] of layout.slice(2))
    if (typeof n === 'function')
      putField(at + offset, 'u', 1, arrayAt(kind, r[name], n(r), name));
    else
      putField(at + offset, kind, n, r[name]);
}

function getField(at, kind, n) {
  const one = k => typeof kind === 'string' ? data()[setters[kind].replace('set', 'get')](at + k * sizeOf(kind), true)
    : get(kind, at + k * kind[0]);
  return n > 1 ? Array.from({ length: n }, (_, k) => one(k)) : one(0);
}

// The record at an address, without its arrays.
function get(layout, at) {
  return Object.fromEntries(layout.slice(2).filter(field => typeof field[3] !== 'function')
    .map(([name, offset, kind, n]) => [name, getField(at + offset, kind, n)]));
}

// For generated functions: the address of a record, of an array, and what they become.
function $i(layout, value) {
  if (!value)
    return 0;
  if (value instanceof Owner && value._type === layout[1])
    return value._use()._p;
  const block = temporary(layout[0]);
  put(layout, block, value);
  return block;
}
const $a = arrayAt;
const $m = layout => temporary(layout[0]);
const $g = (layout, out, at) => out && Object.assign(out, get(layout, at));
// The address of an array that receives n values, with its present ones; then $v reads them back.
function $o(kind, array, n) {
  if (!array || array instanceof Owner)
    return arrayAt(kind, array, n);
  if (typeof kind === 'string' && typeof array[0] === 'object')
    throw new TypeError('nakawari: an array that receives numbers has arrays');
  const block = temporary(n * sizeOf(kind));
  for (let k = 0; k < n; k++)
    putField(block + k * sizeOf(kind), kind, 1, array[k]);
  return block;
}
function $v(kind, array, at, n) {
  if (array instanceof Owner)
    return;
  for (let k = 0; array && k < n; k++)
    array[k] = getField(at + k * sizeOf(kind), kind, 1);
}
// The number of elements of n numbers in an array.
const lengthOf = (array, n) => array instanceof Owner ? array.count / n : Math.floor(flatten(array).length / n);
