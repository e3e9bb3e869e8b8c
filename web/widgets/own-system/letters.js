/** The letters of other books: whether the matrices that were given make a system, and what was read as what. */

import { CALLED, MEANT, ROLES, assigned, isStepwise, leftOf, renamed } from './called.js'
import { turned } from './matrices.js'
import { Fault, hintOf } from './number.js'

/** @typedef {import('./called.js').Found} Found */
/** @typedef {import('./called.js').Role} Role */
/** @typedef {Partial<Record<Role, { name: string, line: number }>>} Places what each is called in a text, and where */

const MOST = /** @type {const} */ ({ states: 9, others: 8 })
const EXPECTED = 'Write F = …, G = …, H = …, V = …, W = …, or A, B, C, Q, R, in JSON, MATLAB or numpy notation.'

/**
 * How a reader means Q and R: which of them is the noise of the motion.
 * @typedef {'Q' | 'R'} Motion
 */

/** As a notation of this book has it: Thrun’s R is of the motion, and of all others Q is. @param {string} notation */
export const motionIn = (notation) => /** @type {Motion} */ (notation === 'thrun' ? 'R' : 'Q')

/** @param {Found} found @param {Motion} motion */
function whole(found, motion) {
  if (Object.keys(found).length === 0) throw new Fault(`No matrix was found. ${EXPECTED}`)
  const of = assigned(found, motion)
  for (const role of /** @type {Role[]} */ (['F', 'H', 'V', 'W']))
    if (!of[role]) throw new Fault(`${missing(role, of, motion)}, ${MEANT[role]}, is missing.`)
  return of
}

/**
 * The letter that a reader would look for.
 * @param {Role} role @param {Partial<Record<Role, string>>} of @param {Motion} motion
 */
function missing(role, of, motion) {
  if (role === 'F' || role === 'H') return of.F === 'A' || of.H === 'C' ? CALLED[role][1] : role
  const [given] = [of.V, of.W].filter((letter) => letter === 'Q' || letter === 'R')
  if (given) return given === 'Q' ? 'R' : 'Q'
  if (isStepwise(of.V ?? of.W ?? '')) return role === 'V' ? 'Q' : 'R'
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
 * @returns {{ system: Record<Role, number[][]>, of: Partial<Record<Role, string>>, as: string, noises: Noises | null,
 *   places: Places, variables: string[], idle: string[] }}
 */
export function systemOf(found, text, motion, at) {
  const of = whole(found, motion)
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
  // In MATLAB’s dlqe and kalman, Q is of a noise that G takes to the state.
  const shaped = (/** @type {Role} */ role) =>
    role === 'V' && m.G && m.V.length === inputs && m.V[0].length === inputs
      ? ` Write ${of.V} = ${of.G}*${of.V}*${of.G}' if ${of.G} takes it to the state.`
      : ''
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
    const [beside, whole] = [`with ${of.F} ${n} × ${n} it needs`, `to be ${height} × ${width}`]
    const why = {
      F: 'it has to be square',
      G: `${beside} ${n} rows`,
      H: `${beside} ${n} columns`,
      V: `${beside} ${whole}`,
      W: `with ${of.H} ${p} × ${n} it needs ${whole}`,
    }[role]
    if (rows !== height || columns !== width)
      throw new Fault(`${name} is ${rows} × ${columns}; ${why}.${hintOf(text)}${renamed(name)}${shaped(role)}`)
  }
  at(0)
  const other = ROLES.filter((role) => of[role] && of[role] !== role)
  const as = other.length > 0 ? `${other.map((role) => of[role]).join(', ')} read as ${other.join(', ')}` : ''
  const place = (/** @type {string[]} */ [role, name]) => [role, { name, line: found[name].line }]
  const places = Object.fromEntries(Object.entries(of).map(place))
  const system = /** @type {any} */ ({ G: m.F.map(() => []), ...m })
  return { system, of, as, noises: noisesOf(of, found), places, ...leftOf(found, of) }
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
