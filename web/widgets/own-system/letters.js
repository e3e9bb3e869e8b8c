/** The letters of other books: which of the matrices that were given is which here. */

import { turned } from './matrices.js'
import { Fault, hintOf } from './number.js'

/** @typedef {{ matrix: number[][], line: number, from: 0 | 1 }} Given `from`: what `[ ]` count from */
/** @typedef {Record<string, Given>} Found by the letter that the reader gave */
/** @typedef {'F' | 'G' | 'H' | 'V' | 'W'} Role */
/** @typedef {Partial<Record<Role, { name: string, line: number }>>} Places what each is called in a text, and where */

/** What each matrix may be called: here, in control theory and in filterpy, in Thrun's book. */
export const CALLED = /** @type {Record<Role, string[]>} */ ({
  F: ['F', 'A'],
  G: ['G', 'B'],
  H: ['H', 'C'],
  V: ['V', 'Q', 'R'],
  W: ['W', 'R', 'Q'],
})
export const ROLES = /** @type {Role[]} */ (Object.keys(CALLED))
export const LETTERS = [...new Set(ROLES.flatMap((role) => CALLED[role]))]
const MEANT = /** @type {Record<Role, string>} */ ({
  F: 'what a step does to the state',
  G: 'what an input does',
  H: 'what a reading tells',
  V: 'the noise of the motion',
  W: 'the noise of a reading',
})
const MOST = /** @type {const} */ ({ states: 9, others: 8 })
const EXPECTED = 'Write F = …, G = …, H = …, V = …, W = …, or A, B, C, Q, R, in JSON, MATLAB or numpy notation.'

/**
 * How a reader means Q and R: which of them is the noise of the motion.
 * @typedef {'Q' | 'R'} Motion
 */

/** As a notation of this book has it: Thrun’s R is of the motion, and of all others Q is. @param {string} notation */
export const motionIn = (notation) => /** @type {Motion} */ (notation === 'thrun' ? 'R' : 'Q')

/**
 * Which letter stands for which matrix.
 * @param {Found} found @param {Motion} motion of Q and R, where their sizes do not tell
 * @returns {Partial<Record<Role, string>>}
 */
function assigned(found, motion) {
  if (Object.keys(found).length === 0) throw new Fault(`No matrix was found. ${EXPECTED}`)
  const of = /** @type {Partial<Record<Role, string>>} */ ({})
  for (const role of /** @type {Role[]} */ (['F', 'G', 'H'])) {
    const given = CALLED[role].filter((letter) => found[letter])
    if (given.length > 1)
      throw new Fault(
        `${given[0]} and ${given[1]} are both given, and both are ${MEANT[role]}.${renamed(role, given[1])}`,
      )
    if (given.length > 0) of[role] = given[0]
  }
  if (found.V) of.V = 'V'
  if (found.W) of.W = 'W'
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
  } else if (rest.length > 0) {
    for (const letter of rest) {
      const role = letter === 'Q' ? 'V' : 'W'
      const instead = of.V && !of.W && letter === 'Q' ? null : role
      if (!instead || of[instead])
        throw new Fault(`${of[role] ?? role} and ${letter} are both given, and both are ${MEANT[role]}.`)
      of[instead] = letter
    }
  }
  for (const role of /** @type {Role[]} */ (['F', 'H', 'V', 'W']))
    if (!of[role]) throw new Fault(`${missing(role, of, motion)}, ${MEANT[role]}, is missing.`)
  return of
}

/** Many a script has a B that is no input: nothing tells it from one. @param {Role} role @param {string} name */
const renamed = (role, name) => (role === 'G' && name === 'B' ? ' Give B another name if it is not that.' : '')

/**
 * The letter that a reader would look for.
 * @param {Role} role @param {Partial<Record<Role, string>>} of @param {Motion} motion
 */
function missing(role, of, motion) {
  if (role === 'F' || role === 'H') return of.F === 'A' || of.H === 'C' ? CALLED[role][1] : role
  const [given] = [of.V, of.W].filter((letter) => letter === 'Q' || letter === 'R')
  if (given) return given === 'Q' ? 'R' : 'Q'
  if (of.F !== 'A' && of.G !== 'B') return role
  return (role === 'V') === (motion === 'Q') ? 'Q' : 'R'
}

/**
 * What Q and R were taken for, and what told so: their sizes, the reader’s letters, or what the other noise is called.
 * @typedef {{ V?: Motion, W?: Motion, told: 'sizes' | 'letters' | 'rest' }} Noises
 */

/** @param {Partial<Record<Role, string>>} of @param {Found} found @returns {Noises | null} */
function noisesOf(of, found) {
  const [V, W] = /** @type {(Motion | undefined)[]} */ (
    [of.V, of.W].map((letter) => (letter === 'Q' || letter === 'R' ? letter : undefined))
  )
  if (!V && !W) return null
  const same = found[String(of.F)].matrix.length === found[String(of.H)].matrix.length
  return { V, W, told: !V || !W ? 'rest' : same ? 'letters' : 'sizes' }
}

/**
 * The same in words, for whoever has Q or R in mind as another book has them.
 * @param {Noises | null} noises @param {boolean} [continuous]
 */
export function wordsOfNoises(noises, continuous = false) {
  if (!noises) return ''
  const { V, W, told } = noises
  const step = `the noise of a ${continuous ? 'second' : 'step'}`
  if (!V || !W) return V ? `${V} as ${step}` : `${W} as the noise of a reading`
  const taken = `${V} as ${step} and ${W} as the noise of a reading, `
  if (told === 'sizes') return `${taken}as their sizes tell`
  return V === 'R'
    ? `${taken}as in Thrun’s letters; elsewhere it is the other way round, and their sizes fit both`
    : `${taken}as is common; in Thrun’s letters it is the other way round, and their sizes fit both`
}

/**
 * The matrices, if they fit one another, and what they were called where that is not what they are called here.
 * @param {Found} found @param {string} text @param {Motion} motion
 * @param {(line: number) => void} at tells where the fault is
 * @returns {{ system: Record<Role, number[][]>, as: string, noises: Noises | null, places: Places }}
 */
export function systemOf(found, text, motion, at) {
  const of = assigned(found, motion)
  const m = /** @type {Record<string, number[][]>} */ (
    Object.fromEntries(Object.entries(of).map(([role, letter]) => [role, found[letter].matrix]))
  )
  const n = m.F.length
  // In numpy a row of numbers has no direction: it is taken as the one that fits.
  if (m.G?.length === 1 && n > 1 && m.G[0].length === n) m.G = turned(m.G)
  const p = m.H.length
  const inputs = m.G?.[0]?.length ?? 0
  const sizes = /** @type {Record<Role, [number, number]>} */ ({
    F: [n, n],
    G: [n, inputs],
    H: [p, n],
    V: [n, n],
    W: [p, p],
  })
  for (const role of ROLES.filter((each) => m[each])) {
    const name = String(of[role])
    at(found[name].line)
    const [rows, columns] = [m[role].length, m[role][0].length]
    const [high, wide] = { F: [9, 9], G: [9, 8], H: [8, 9], V: [9, 9], W: [8, 8] }[role]
    if (rows > high || columns > wide)
      throw new Fault(
        `${name} is ${rows} × ${columns}; at most ${MOST.states} states, and ${MOST.others} inputs and readings, ` +
          `are shown here.${hintOf(text)}`,
      )
    const [height, width] = sizes[role]
    const why =
      role === 'F'
        ? 'it has to be square'
        : `with ${of.F} ${n} × ${m.F[0].length} and ${of.H} ${p} × ${m.H[0].length} it needs to be ${height} × ${width}`
    if (rows !== height || columns !== width)
      throw new Fault(`${name} is ${rows} × ${columns}; ${why}.${hintOf(text)}${renamed(role, name)}`)
  }
  at(0)
  const other = ROLES.filter((role) => of[role] && of[role] !== role)
  const as = other.length > 0 ? `${other.map((role) => of[role]).join(', ')} read as ${other.join(', ')}` : ''
  const place = (/** @type {string[]} */ [role, name]) => [role, { name, line: found[name].line }]
  const places = Object.fromEntries(Object.entries(of).map(place))
  const system = /** @type {any} */ ({ G: m.F.map(() => []), ...m })
  return { system, as, noises: noisesOf(of, found), places }
}

/**
 * The variances of the start: the diagonal of a matrix, a list, or one number for all.
 * @param {number[][]} m @param {number} n @param {string} name
 */
export function spreadOf(m, n, name) {
  const flat = m.flat()
  if (flat.some((entry) => entry < 0 && m.length === 1)) throw new Fault(`${name}: a variance is not negative.`)
  if (flat.length === 1) return Array(n).fill(flat[0])
  if ((m.length === 1 || m[0].length === 1) && flat.length === n) return flat
  if (m.length !== n || m[0].length !== n)
    throw new Fault(`${name} is ${m.length} × ${m[0].length}; there are ${n} states.`)
  if (m.some((row, i) => row.some((entry, j) => i !== j && entry !== 0)))
    throw new Fault(`${name}: only the diagonal of the start can be set here; the other entries must be 0.`)
  if (m.some((row, i) => row[i] < 0)) throw new Fault(`${name}: a variance is not negative.`)
  return m.map((row, i) => row[i])
}
