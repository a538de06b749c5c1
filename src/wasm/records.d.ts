/** Numbers, one after the other, or arrays of them: [x, y, z, x, y, z] or [[x, y, z], [x, y, z]]. */
export type Numbers = ArrayLike<number> | ArrayLike<ArrayLike<number>> | Floats;
/** An array that receives numbers, or an object of this memory. */
export type Output = FloatArray | Int32Array | Uint32Array | Uint8Array | Floats;

