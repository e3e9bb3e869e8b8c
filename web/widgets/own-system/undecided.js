/** What the numbers of a system leave undecided within the tolerance, and what would decide it. */

/** @typedef {import('estimate-wasm').OwnFrame} Frame */

const UNDECIDED = 'undecided'

/** Whether the filter’s covariance has a limit is not known: what is computed of it is that of rounding. */
export const limitIsOpen = (/** @type {Frame} */ { badlyScaled, limit }) => badlyScaled || limit === UNDECIDED

/**
 * Whether an eigenvalue dies out is not known: no gain moves it, and the tolerance does not tell on which side of the
 * circle it lies.
 * @param {Frame} frame @param {number} i of the eigenvalue
 */
export const endIsOpen = ({ detectable, eigenvalues }, i) => detectable === UNDECIDED && eigenvalues[i].fixed

/** An eigenvalue that is 0 stays there where F is singular, whatever is seen of it. */
const NOUGHT = 1e-6

/**
 * Whether the system is observable. Where an eigenvalue stays whatever the gain, it is so by no more than the digits of
 * the numbers.
 * @param {Frame} frame
 */
export const observed = ({ observable, eigenvalues }) =>
  observable === 'yes' && eigenvalues.some(({ fixed, modulus }) => fixed && modulus > NOUGHT) ? UNDECIDED : observable

/** @param {Frame} frame */
export function wouldDecide(frame) {
  const { badlyScaled, detectable, noise } = frame
  if (badlyScaled || ![observed(frame), detectable, noise.reachable].includes(UNDECIDED)) return ''
  return 'More digits of the numbers, or a smaller tolerance where they are exact, may decide what is undecided.'
}
