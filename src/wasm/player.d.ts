/** This part opens clips; `nakawari/clips` builds them. */
export type ClipSource = Uint8Array;

