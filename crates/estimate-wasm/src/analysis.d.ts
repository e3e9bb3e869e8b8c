/** Whether something holds of a system, and of every system within the tolerance; "undecided" where it holds of some of
    them only. */
export type Verdict = 'yes' | 'no' | 'undecided'
export interface Detectability {
  /** Whether every direction of the state is seen. */
  observable: Verdict
  /** Whether every direction that is not seen dies out by itself. */
  detectable: Verdict
  /** Orthonormal directions that count as unseen: less is seen of them than the tolerance. */
  unseen: Vector[]
  /** The eigenvalues of F along them, by decreasing modulus; no gain moves them. */
  modes: Complex[]
}
export interface Reachability {
  /** Whether every combination of the states is moved. */
  reachable: Verdict
  /** Whether every combination that is not moved dies out by itself. */
  stabilizable: Verdict
  /** Orthonormal c for which cᵀx counts as not moved. */
  unreached: Vector[]
  /** The eigenvalues of F that belong to them, by decreasing modulus. */
  modes: Complex[]
}
/** "from-every-start": one limit from every P(0 | 0), and the error of the limit gain dies out. "from-large-start": a
    limit from every P(0 | 0) that is not smaller than it. "none": P grows without bound. "depends-on-start": it depends
    on P(0 | 0) and V. "undecided": the tolerance does not decide. */
export type RiccatiLimit = 'from-every-start' | 'from-large-start' | 'none' | 'depends-on-start' | 'undecided'
