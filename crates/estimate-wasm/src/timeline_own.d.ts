/** A sensor of a time line that reads a function of the state, y = h(x) + w, Cov w = W; as many outputs as W has rows.
    It is linearized at the state that is expected when the reading was measured. What comes late has `h` asked again:
    it must answer the same for the same x. What it throws comes through, and the time line is as it was. */
export interface OwnTimelineSensor extends Omit<TimelineSensor, 'H'> {
  h: Model
  /** ∂h/∂x at x; by central differences where it is left out. */
  H?: ModelJacobian
  /** The indices of y, from 0, that are angles: their differences are taken the short way round. */
  angles?: number[]
}
export type AnyTimelineSensor = TimelineSensor | OwnTimelineSensor
