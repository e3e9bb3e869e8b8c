export interface Check {
  /** The chapter's numbering, from 1. */
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
