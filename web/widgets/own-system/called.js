/** What each matrix may be called, and which of several names for one is meant. */

import { isScalar } from './matrices.js'
import { Fault } from './number.js'

/**
 * @typedef {{ matrix: number[][], line: number, from?: 0 | 1, uses: Set<string> }} Given `from`: what `[ ]` count from;
 *   `uses`: the names of which its formula is made
 */
/** @typedef {Record<string, Given>} Found by the name that the reader gave */
/** @typedef {'F' | 'G' | 'H' | 'V' | 'W'} Role */

/** What each matrix may be called: here, in control theory and in filterpy, in Thrun's book. */
export const CALLED = /** @type {Record<Role, string[]>} */ ({
  F: ['F', 'A'],
  G: ['G', 'B'],
  H: ['H', 'C'],
  V: ['V', 'Q', 'R'],
  W: ['W', 'R', 'Q'],
})
/** @param {string[]} letters */
const ofOneStep = (...letters) => letters.flatMap((each) => [`${each}d`, `${each}_d`, `${each}k`, `${each}_k`])
/** Names that say by themselves that they are of one step; the last of each are pykalman's. */
const STEPWISE = /** @type {Record<Role, string[]>} */ ({
  F: ['Phi', ...ofOneStep('A', 'F'), 'transition_matrices'],
  G: ['Gamma', ...ofOneStep('B', 'G')],
  H: [...ofOneStep('C', 'H'), 'observation_matrices'],
  V: [...ofOneStep('Q'), 'transition_covariance'],
  W: [...ofOneStep('R'), 'observation_covariance'],
})
export const ROLES = /** @type {Role[]} */ (Object.keys(CALLED))
const LETTERS = new Set(ROLES.flatMap((role) => [...CALLED[role], ...STEPWISE[role]]))
export const MEANT = /** @type {Record<Role, string>} */ ({
  F: 'what a step does to the state',
  G: 'what an input does',
  H: 'what a reading tells',
  V: 'the noise of the motion',
  W: 'the noise of a reading',
})

/** Whether a name may be that of a matrix of the system. @param {string} name */
export const isMatrix = (name) => LETTERS.has(name)
/** @param {string} name */
export const isInput = (name) => sure('G').includes(name)
/** @param {string} name */
export const isStepwise = (name) => ROLES.some((role) => STEPWISE[role].includes(name))
/** Names that are of this role alone. @param {Role} role */
const sure = (role) => [...(/[VW]/.test(role) ? [role] : CALLED[role]), ...STEPWISE[role]]

/** Many a script has a B that is no input: nothing tells it from one. @param {string} name */
export const renamed = (name) =>
  name === 'B' || isStepwise(name) ? ` Give ${name} another name if it is not that.` : ''

/** @param {Role} role @param {string} one @param {string} other */
const twice = (role, one, other) =>
  new Fault(`${one} and ${other} are both given, and both are ${MEANT[role]}.${renamed(other) || renamed(one)}`)

/** @param {Found} found @param {string} a @param {string} b */
const alike = (found, a, b) =>
  found[a].matrix.length === found[b].matrix.length && found[a].matrix[0].length === found[b].matrix[0].length

/**
 * Of names for one matrix the one that is meant: not a variable of another's formula; and of a system in continuous
 * time beside what one step does, the latter.
 * @param {Role} role @param {Found} found @param {boolean} stepwise whether F is of one step
 */
function chosen(role, found, stepwise) {
  const given = sure(role).filter((name) => found[name])
  let left = given.filter((name) => !given.some((other) => other !== name && found[other].uses.has(name)))
  // What shapes the noise of the motion is no input beside one that does not.
  const quiet = left.filter((name) => !/^(?:G|Gamma)$/.test(name) || !used(found, ['Q', ...sure('V')], name))
  if (quiet.length > 0) left = role === 'G' ? quiet : left
  const [usual, ...others] = left.filter((name) => !isStepwise(name))
  if (usual && others.length === 0 && left.length > 1) {
    // What has another size is another thing, such as a coefficient of drag that is called Cd.
    const steps = left.filter((name) => isStepwise(name) && alike(found, name, usual))
    if (steps.length === 0) left = [usual]
    // A single Phi may be an angle.
    else if (steps[0] === 'Phi' && isScalar(found.Phi.matrix)) throw twice(role, usual, 'Phi')
    else if (steps.length === 1 && (stepwise || role === 'F')) left = steps
    else if (role === 'H') left = [usual]
  }
  const inputs = left.filter((name) => !used(found, ['Q', ...sure('V')], name))
  if (role === 'G' && inputs.length === 1) left = inputs
  if (left.length === 0) left = given
  if (left.length > 1) throw twice(role, left[0], left[1])
  return /** @type {string | undefined} */ (left[0])
}

/** Whether a formula of these matrices has a name. @param {Found} found @param {string[]} of @param {string} name */
const used = (found, of, name) => of.some((each) => each !== name && found[each]?.uses.has(name))

/**
 * Whether F comes of another matrix of the motion, or its name says that it is of one step.
 * @param {Found} found @param {string | undefined} f
 */
export const ofStep = (found, f) =>
  f !== undefined && (isStepwise(f) || sure('F').some((name) => name !== f && found[f].uses.has(name)))

/**
 * Which letter stands for which matrix.
 * @param {Found} found @param {'Q' | 'R'} motion of Q and R, where their sizes do not tell
 * @returns {Partial<Record<Role, string>>}
 */
export function assigned(found, motion) {
  const of = /** @type {Partial<Record<Role, string>>} */ ({})
  for (const role of ROLES) {
    const name = chosen(role, found, ofStep(found, of.F))
    if (name) of[role] = name
  }
  const small = of.G && of.F && isScalar(found[of.G].matrix) && !isScalar(found[of.F].matrix)
  if (small && used(found, Object.keys(found), String(of.G))) delete of.G
  const rest = ['Q', 'R'].filter((letter) => found[letter])
  const other = motion === 'Q' ? 'R' : 'Q'
  if (!of.V && !of.W && rest.length > 0) {
    const sizes = [of.F, of.H].map((letter) => (letter ? found[letter].matrix.length : 0))
    const fit = (/** @type {string[]} */ names) =>
      names.every((name, i) => !found[name] || found[name].matrix.length === sizes[i])
    const turned = fit([other, motion]) && !fit([motion, other])
    const [v, w] = turned ? [other, motion] : [motion, other]
    if (found[v]) of.V = v
    if (found[w]) of.W = w
    return of
  }
  for (const letter of rest) {
    const role = letter === 'Q' ? 'V' : 'W'
    const name = of[role]
    if (!name) of[role] = letter
    // `V = G*Q*G'` keeps V, and `Q = G*W*G'` beside R leaves R.
    else if (used(found, [name, ...[of.F, of.H].map(String)], letter)) continue
    else if (found[letter].uses.has(name) || (name === 'W' && used(found, ['V', 'Q'], name))) of[role] = letter
    else if (!isStepwise(name) || !ofStep(found, of.F) || !alike(found, name, letter)) throw twice(role, name, letter)
  }
  return of
}

/**
 * The names that are none of the system's matrices: variables of the others' formulas, and what is of no use.
 * @param {Found} found @param {Partial<Record<Role, string>>} of
 */
export function leftOf(found, of) {
  const taken = Object.values(of)
  const left = Object.keys(found).filter((name) => !taken.includes(name))
  const variables = left.filter((name) => used(found, taken, name))
  return { variables, idle: left.filter((name) => !variables.includes(name)) }
}
