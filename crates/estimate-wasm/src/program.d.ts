/** How a program is read. */
export interface ProgramOptions {
  /** Whose letters it is in: R is the gain in Choset's and a noise in the others. "choset" where it is left out. */
  notation?: 'choset' | 'thrun' | 'common'
  /** What it filters: a linear system, or the chapter's robot. "linear" where it is left out. */
  world?: 'linear' | 'robot'
}
/** One fault of a program. */
export interface ProgramFault {
  /** The line, from 1. */
  line: number
  /** Where it begins in its line, from 1, in characters. */
  column: number
  /** How many characters it takes. */
  length: number
  /** What is wrong, in a sentence. */
  message: string
}
/** What a robot's step stands on: one sighting of a landmark that is known. */
export interface RobotSystem {
  /** The covariance of the motion's noise, 3 × 3. */
  V: Rows
  /** The covariance of a sighting, of range and bearing, 2 × 2. */
  W: Rows
  /** Where the landmark stands, x and y. */
  landmark: Vector | Float64Array
  /** χ² beyond which a sighting is refused, for programs that ask. */
  gate?: number
}
/** One step of a program. */
export interface ProgramStep {
  /** The new estimate. */
  x: Vector
  /** Its covariance. It is what the program made, and need not be one. */
  P: Matrix
  /** ν, where the program makes it under that name; else null. */
  innovation: Vector | null
  /** S, where the program makes it. */
  S: Matrix | null
  /** The gain, where the program makes it. */
  R: Matrix | null
}
/** What a line of a program has made. */
export interface ProgramLine {
  /** The line, from 1. */
  line: number
  /** The name that it makes. */
  name: string
  /** Its value behind the line; a number is [[x]]. */
  value: Matrix
}
/** What is said of a program. */
export interface ProgramVerdict {
  /**
   * `right`, a `bug` that real code has had, `wrong` in another way, `unfinished` where what stands there is right and
   * no line corrects x or P by the reading yet, or `refused`: with faults, or without a value.
   */
  outcome: 'right' | 'bug' | 'wrong' | 'unfinished' | 'refused'
  /** Which bug, by the word of the chapter's museum. */
  bug: string | null
  /** The line to look at, from 1, where one can be told. */
  line: number | null
  /** Why, with numbers. */
  sentences: string[]
}
/** What a program calls each quantity: by their names in a system and in a step's answer. */
export type ProgramLetters = Record<
  'x' | 'P' | 'u' | 'y' | 'V' | 'W' | 'F' | 'G' | 'H' | 'innovation' | 'S' | 'R',
  string
>
/** A part of a program's formula. */
export interface ProgramFormula {
  /**
   * `number`, `name`, or what is done with the parts: `plus minus times over under negative power part end row stack
   * inv eye zeros diag sqrt sin cos atan2 exp wrap det trace norm chol sym transpose abs length array jac f h`.
   * A `part` has the whole, then first and last row, first and last column; `end` is the last.
   */
  word: string
  /** The number, or the exponent of a `power`. */
  number: number
  /** The name; of `jac` the one by which is differentiated. */
  name: string
  /** Rows and columns; null without sizes, and of a multiple of I, which has the size of what it stands beside. */
  sides: [number, number] | null
  /** What it is made of, in the order in which it is written. */
  parts: ProgramFormula[]
}
/** A line of a program: `name = value`, or `name[…] = value`. */
export interface ProgramStatement {
  name: string
  /** Which part of the name, a formula whose word is `part`; null where the line makes the whole. */
  part: ProgramFormula | null
  value: ProgramFormula
  /** Its first and last line in the text, from 1. */
  lines: [number, number]
}
