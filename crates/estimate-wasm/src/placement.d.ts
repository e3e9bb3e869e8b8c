export interface Placement {
  /** The gain. */
  K: Matrix
  /** The eigenvalues that no gain moves, by decreasing modulus. */
  fixed: Complex[]
}
