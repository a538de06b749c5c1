
/** Component arrays for the functions named ...N: `width` arrays of `count` floats; x, y, z, w are the first. */
export class Columns extends Floats {
  constructor(width, count) {
    super(width * count);
    this.width = width;
    this.length = count;
  }
  /** Component i, not a copy. */
  column(i) {
    return this.array.subarray(i * this.length, (i + 1) * this.length);
  }
  get x() { return this.column(0); }
  get y() { return this.column(1); }
  get z() { return this.column(2); }
  get w() { return this.column(3); }
}

// The addresses of the components, at word i of the scratch memory.
function $c(i, columns, width, n) {
  if (expect(Columns, columns).width !== width || !(n <= columns.length))
    throw new RangeError(`nakawari: Columns of ${columns.width} x ${columns.length} instead of ${width} x ${n}`);
  for (let k = 0; k < width; k++)
    u32[at + i + k] = columns._p + 4 * k * columns.length;
  return (at + i) << 2;
}

function $c1(columns, n) {
  return u32[$c(255, columns, 1, n) >> 2];
}
