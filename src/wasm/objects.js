
function take(bytes) {
  const block = bytes >= 0 && bytes < 2 ** 31 ? x.take(bytes) : 0;
  look();
  if (!block)
    throw new RangeError(`nakawari: no memory for ${bytes} bytes`);
  return block;
}

// Calls f with the addresses of copies of arrays: [array or null, floats, 1 if it is written].
function rows(list, f) {
  const blocks = [];
  try {
    for (const [array, floats, written] of list) {
      if (array !== null && !(array?.length >= floats) && !(written && array === undefined))
        throw new RangeError(`nakawari: ${array?.length ?? typeof array} instead of ${floats} numbers`);
      blocks.push(array ? take(4 * floats) : 0);
      for (let k = 0, s = blocks.at(-1) >> 2; array && k < floats; k++)
        f32[s + k] = array[k];
    }
    const result = f(blocks);
    list.forEach(([array, floats, written], i) => {
      for (let k = 0, s = blocks[i] >> 2; written && array && k < floats; k++)
        array[k] = f32[s + k];
    });
    return result;
  } finally {
    blocks.forEach(x.release);
  }
}
const $rows = rows;

let alive = 0;
const lost = new FinalizationRegistry(blocks => {
  blocks.forEach(block => x.release(block));
  alive -= blocks.length;
  blocks.length = 0;
});

/** The number of blocks of memory that objects hold, and the bytes of the whole memory. */
export const memory = () => ({ blocks: alive, bytes: x.memory.buffer.byteLength });

/** An object with blocks of the module's memory. They are released by dispose(), or after the object is collected. */
export class Owner {
  #blocks = [];
  constructor() {
    lost.register(this, this.#blocks, this);
  }
  /** @internal */
  _take(bytes) {
    const block = take(bytes);
    this.#blocks.push(block);
    alive++;
    return block;
  }
  /** @internal */
  _use() {
    if (this.#blocks.length === 0)
      throw new Error('nakawari: the object was disposed');
    return this;
  }
  dispose() {
    lost.unregister(this);
    this.#blocks.forEach(block => x.release(block));
    alive -= this.#blocks.length;
    this.#blocks.length = 0;
  }
}
if (Symbol.dispose)
  Owner.prototype[Symbol.dispose] = Owner.prototype.dispose;

/** `count` floats in the module's memory. */
export class Floats extends Owner {
  constructor(count) {
    super();
    this.count = count;
    /** @internal */
    this._p = this._take(count === 0 ? 4 : 4 * count);
  }
  /** The floats themselves, not a copy. Read it again after an object was made: the memory may have moved. */
  get array() {
    return new Float32Array(f32.buffer, this._use()._p, this.count);
  }
}

// Words of structures of C at word i of the scratch memory; returns their address.
function words(i, ...values) {
  for (let k = 0; k < values.length; k++)
    u32[at + i + k] = values[k];
  return (at + i) << 2;
}
const bad = () => u32[at + 255];
const badAt = () => words(255, 0);
// An object of a class of this part. Those of another part have addresses of another memory.
function expect(Class, object) {
  if (!(object instanceof Class))
    throw new TypeError(`nakawari: ${object?.constructor?.name ?? typeof object} is no ${Class.name} of this part`);
  return object._use();
}
const addressOf = (Class, object) => object === null ? 0 : expect(Class, object)._p;

// A copy of an array in a block of `owner`; 0 for none.
function store(owner, array, View = Float32Array) {
  if (!array)
    return 0;
  const block = owner._take(Math.max(array.length * View.BYTES_PER_ELEMENT, 4));
  new View(f32.buffer, block, array.length).set(array);
  return block;
}

// Memory for the time of one call.
function during(f) {
  const owner = new Owner();
  try {
    return f(owner);
  } finally {
    owner.dispose();
  }
}

const need = (what, have, count) => {
  if (!(have >= count))
    throw new RangeError(`nakawari: ${have} ${what} instead of ${count}`);
};
