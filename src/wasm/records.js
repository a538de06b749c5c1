
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
  const place = used, end = used + Math.ceil(bytes / 16) * 16;
  if (bytes >= 0 && end <= arenaBytes) {
    used = end;
    return arena + place;
  }
  blocks.push(take(bytes));
  return blocks.at(-1);
}
// Working memory, as an nkw_work, for the time of one call.
function $work(bytes) {
  const place = temporary(8), block = temporary(bytes + 16), data = Math.ceil(block / 16) * 16;
  u32.set([data, bytes], place >> 2);
  return place;
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

// Throws for an object of another part, and for one of this part that is not a struct of this type.
function refuse(value, type) {
  const own = value instanceof Owner;
  if (typeof value?._use === 'function' && !(own && (!type || type.replace(/_(view|span)$/, '') === value._data)))
    throw new TypeError(`nakawari: ${value.constructor.name} ${own ? `is no ${type}` : 'of another part'}`);
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
  refuse(array);
  if (kind === 'v')
    throw new TypeError(`nakawari: ${name} is not of an object of the package`);
  const flat = typeof kind === 'string' ? flatten(array) : array;
  need(`elements of ${name}`, flat.length, n);
  const block = temporary(n * sizeOf(kind));
  if (kind === 'f' && n < 64)
    for (let k = 0; k < n; k++)
      f32[(block >> 2) + k] = flat[k];
  else if (typeof kind === 'string')
    new arrayOf[kind](f32.buffer, block, n).set(flat.length === n ? flat : Array.prototype.slice.call(flat, 0, n));
  else
    for (let k = 0; k < n; k++)
      put(kind, block + k * kind[0], flat[k]);
  return block;
}

function putOne(at, kind, value) {
  if (typeof kind === 'string' && typeof (value ?? 0) === 'object')
    throw new TypeError('nakawari: an object instead of a number');
  if (kind === 'f')
    f32[at >> 2] = value ?? 0;
  else if (kind === 'u' || kind === 'i')
    u32[at >> 2] = value ?? 0; // modulo 2^32
  else if (typeof kind !== 'string')
    put(kind, at, value);
  else
    data()[setters[kind]](at, value ?? (kind === 'q' ? 0n : 0), true);
}

function putField(at, kind, n, value) {
  if (n === 1)
    return putOne(at, kind, value);
  const size = sizeOf(kind);
  need('values of a field', (value ?? { length: n }).length, n);
  for (let k = 0; k < n; k++)
    putOne(at + k * size, kind, value?.[k]);
}

// Writes a record. An object of the package has the struct in its memory, or is an array that the struct names.
function put(layout, at, value) {
  if (value instanceof Owner && value._type === layout[1])
    return void u8.copyWithin(at, value._use()._p, value._p + layout[0]);
  refuse(value, layout[1]);
  if (value !== undefined && value !== null && typeof value !== 'object')
    throw new TypeError(`nakawari: ${typeof value} instead of ${layout[1]}`);
  const r = value instanceof Owner
    ? { data: value, jointCount: value.jointCount, format: value.format, halfLife: value.halfLife,
      duration: value.duration }
    : { ...value };
  for (let k = 2; k < layout.length; k++)
    if (layout[k][4])
      r[layout[k][0]] ??= layout[k][4](r);
  for (let k = 2; k < layout.length; k++) {
    const [name, offset, kind, n] = layout[k];
    if (typeof n === 'function')
      putOne(at + offset, 'u', arrayAt(kind, r[name], n(r), name));
    else
      putField(at + offset, kind, n, r[name]);
  }
}

function getOne(at, kind) {
  return kind === 'f' ? f32[at >> 2] : kind === 'u' ? u32[at >> 2] : kind === 'i' ? u32[at >> 2] | 0
    : typeof kind !== 'string' ? get(kind, at)
    : data()[setters[kind].replace('set', 'get')](at, true);
}

function getField(at, kind, n) {
  const size = sizeOf(kind);
  return n > 1 ? Array.from({ length: n }, (_, k) => getOne(at + k * size, kind)) : getOne(at, kind);
}

// The record at an address, without its arrays.
function get(layout, at) {
  const record = {};
  for (let k = 2; k < layout.length; k++) {
    const [name, offset, kind, n] = layout[k];
    if (typeof n !== 'function')
      record[name] = getField(at + offset, kind, n);
  }
  return record;
}

// For generated functions: the address of a record, of an array, and what they become.
function $i(layout, value) {
  if (value === undefined)
    throw new TypeError(`nakawari: no ${layout[1].slice(4)}`);
  if (value === null)
    return 0;
  if (value instanceof Owner && value._type === layout[1])
    return value._use()._p;
  const block = temporary(layout[0]);
  put(layout, block, value);
  return block;
}
function $a(kind, array, n, name) {
  if (array === undefined || (array === null && typeof kind !== 'string'))
    throw new TypeError(`nakawari: no ${name}`);
  return arrayAt(kind, array, n, name);
}
const $m = layout => temporary(layout[0]);
const $g = (layout, out, at) => out && Object.assign(out, get(layout, at));
// The address of an array that receives n values, with its present ones; then $v reads them back.
function $o(kind, array, n) {
  if (!array || array instanceof Owner)
    return arrayAt(kind, array, n);
  refuse(array);
  if (typeof kind === 'string' && typeof array[0] === 'object')
    throw new TypeError('nakawari: an array that receives numbers has arrays');
  const block = temporary(n * sizeOf(kind));
  for (let k = 0; k < n; k++)
    putOne(block + k * sizeOf(kind), kind, array[k]);
  return block;
}
function $v(kind, array, at, n) {
  if (array instanceof Owner)
    return;
  for (let k = 0; array && k < n; k++)
    array[k] = getOne(at + k * sizeOf(kind), kind);
}
// The number of elements of n numbers in an array.
const lengthOf = (array, n) => array instanceof Owner ? array.count / n : Math.floor(flatten(array).length / n);
