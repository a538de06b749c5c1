
/** The number of blocks of memory that objects hold, and the bytes of the whole memory. */
export function memory(): { blocks: number; bytes: number };

/** An object with blocks of the module's memory. They are released by dispose(), or after the object is collected. */
export class Owner {
  dispose(): void;
}

/** `count` floats in the module's memory. */
export class Floats extends Owner {
  constructor(count: number);
  readonly count: number;
  /** The floats themselves, not a copy. Read it again after an object was made: the memory may have moved. */
  readonly array: Float32Array;
}
