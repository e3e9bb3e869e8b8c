export interface Check {
  /** 1 to 13, the chapter's numbering. */
  id: number
  title: string
  /** What the chapter claims. */
  expected: Vector
  /** The same numbers, computed just now. */
  actual: Vector
  /** The largest difference allowed. */
  tolerance: number
  passed: boolean
}
