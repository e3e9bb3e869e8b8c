/** Three landmarks in a heap, and a robot that has forgotten its map: each step corrects all that it has founded. */
export const HEAP = {
  count: 3,
  forget: true,
  landmarks: [
    [2, 3],
    [2.3, 3],
    [2.6, 3],
  ],
}
