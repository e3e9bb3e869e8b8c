// Seeded nonsense: valid arguments with a few places spoilt, for the fuzz test of the module's exports.

/** A small seeded generator (mulberry32): the same nonsense at every run. */
export function dice(seed) {
  let a = seed >>> 0
  const uniform = () => {
    a = (a + 0x6d2b79f5) >>> 0
    let t = Math.imul(a ^ (a >>> 15), 1 | a)
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296
  }
  const below = (n) => Math.floor(uniform() * n)
  const pick = (list) => list[below(list.length)]
  const normal = () => Math.sqrt(-2 * Math.log(1 - uniform())) * Math.cos(2 * Math.PI * uniform())
  return { uniform, below, pick, normal }
}

const NUMBERS = [
  NaN,
  Infinity,
  -Infinity,
  1e308,
  -1e308,
  5e-324,
  2.2e-310,
  -0,
  0,
  -1,
  0.5,
  1.7,
  1e-8,
  1e24,
  4294967296,
  2 ** 53 + 2,
]
/** @type {unknown[]} */
const OTHERS = [
  undefined,
  null,
  '3',
  '',
  'NaN',
  true,
  {},
  [],
  [[]],
  [1],
  [[1]],
  [[1, 2], [3]],
  [[NaN]],
  'range',
  () => 1,
  10n,
  new Date(0),
  new Float64Array([1, 2]),
  { x: 1 },
  { valueOf: () => 7 },
  new Array(5),
  [undefined],
  Symbol.iterator,
  new Map([['x', 1]]),
]

/**
 * Characters that readers of text fall over: marks, NULs, halves of surrogates, and what some take for the end of a
 * line.
 */
const AWKWARD = [
  ...'\ufeff\0\u2028\u2029\u0085\v\f\u200b\ufffd\u00a0\r\n\t"\'\\,;[({%#=-−',
  '\ud83d',
  '\ude00',
  '\u{1f600}',
]

/**
 * `text` with one to three places spoilt, each anywhere: an awkward character comes in, or a piece is lost or stands
 * twice.
 *
 * @param {string} text
 */
export function spoiltText(text, dice) {
  let spoilt = text
  for (let times = 1 + dice.below(3); times > 0; times--) {
    const at = dice.below(spoilt.length + 1)
    const end = Math.min(spoilt.length, at + dice.below(12))
    const chance = dice.uniform()
    const instead = chance < 0.7 ? dice.pick(AWKWARD) : chance < 0.85 ? '' : spoilt.slice(at, end).repeat(2)
    spoilt = spoilt.slice(0, at) + instead + spoilt.slice(chance < 0.5 ? at : end)
  }
  return spoilt
}

/** Something that does not belong where a number, or anything, was asked for. */
export function junk(dice) {
  return copy(dice.uniform() < 0.6 ? dice.pick(NUMBERS) : dice.pick(OTHERS))
}

/**
 * A deep copy of the argument list `args` with up to three places spoilt; now and then none, or one too few or too
 * many.
 */
export function spoil(args, dice) {
  const spoilt = copy(args)
  for (let times = dice.below(4); times > 0 && spoilt.length > 0; times--) {
    const at = dice.below(spoilt.length)
    spoilt[at] = spoilOnce(spoilt[at], dice)
  }
  const chance = dice.uniform()
  if (chance < 0.04) spoilt.pop()
  else if (chance < 0.08) spoilt.push(junk(dice))
  return spoilt
}

function copy(value) {
  if (Array.isArray(value)) return value.map(copy)
  if (value && typeof value === 'object' && Object.getPrototypeOf(value) === Object.prototype) {
    return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, copy(inner)]))
  }
  return value
}

function spoilOnce(value, dice) {
  if (typeof value === 'string' && dice.uniform() < 0.7) return spoiltText(value, dice)
  if (value instanceof Float64Array && value.length > 0 && dice.uniform() < 0.5) {
    const floats = value.slice()
    floats[dice.below(floats.length)] = dice.pick(NUMBERS)
    return floats
  }
  const inside = value !== null && typeof value === 'object' ? Object.keys(value) : []
  if (inside.length === 0 || ArrayBuffer.isView(value) || dice.uniform() < 0.12) return junk(dice)
  const key = dice.pick(inside)
  if (Array.isArray(value)) {
    const chance = dice.uniform()
    if (chance < 0.08) return value.concat([copy(value[0])])
    if (chance < 0.16) return value.slice(0, -1)
    if (chance < 0.19 && value.length < 100 && !(value[0]?.length > 100))
      return Array.from({ length: 10_000 }, () => copy(value[0]))
  } else if (dice.uniform() < 0.1) {
    delete value[key]
    return value
  } else if (dice.uniform() < 0.05) {
    value.unknown = 1
    return value
  }
  value[key] = spoilOnce(value[key], dice)
  return value
}

/**
 * The matrices among the arguments `args`, however deep: where each stands, and the arguments with another in its
 * place.
 */
export function matrices(args) {
  const found = []
  const walk = (value, keys) => {
    if (Array.isArray(value) && (Array.isArray(value[0]) || value[0] instanceof Float64Array)) {
      const put = (matrix) => {
        const others = copy(args)
        keys.slice(0, -1).reduce((inner, key) => inner[key], others)[keys.at(-1)] = matrix
        return others
      }
      found.push({ place: keys.join('.'), put })
    } else if (value !== null && typeof value === 'object' && !ArrayBuffer.isView(value)) {
      for (const key of Object.keys(value)) walk(value[key], [...keys, key])
    }
  }
  args.forEach((value, i) => walk(value, [String(i)]))
  return found
}

/** A random symmetric positive definite n×n matrix, its scale spread over many decades. */
export function covariance(n, dice) {
  const factor = Array.from({ length: n }, () => Array.from({ length: n }, dice.normal))
  const scale = 10 ** (dice.uniform() * 8 - 6)
  const p = factor.map((a) => factor.map((b) => scale * a.reduce((sum, ai, i) => sum + ai * b[i], 0)))
  p.forEach((row, i) => {
    row[i] += scale * 1e-3
  })
  return p
}

/** Why `p` is no covariance, or null: symmetric, and no eigenvalue below −1e-12 of the largest (Jacobi rotations). */
export function notCovariance(p) {
  const n = p.length
  const largest = Math.max(...p.flat().map(Math.abs))
  if (!p.flat().every(Number.isFinite)) return 'not finite'
  const a = p.map((row) => row.slice())
  for (let i = 0; i < n; i++)
    for (let j = 0; j < i; j++) if (Math.abs(a[i][j] - a[j][i]) > 1e-9 * largest) return 'not symmetric'
  if (largest === 0) return null
  for (const row of a) for (let j = 0; j < n; j++) row[j] /= largest
  for (let sweep = 0; sweep < 60; sweep++) {
    let off = 0
    for (let p = 0; p < n; p++) {
      for (let q = p + 1; q < n; q++) {
        off += a[p][q] ** 2
        if (Math.abs(a[p][q]) < 1e-300) continue
        const theta = (a[q][q] - a[p][p]) / (2 * a[p][q])
        const t = Math.sign(theta || 1) / (Math.abs(theta) + Math.hypot(theta, 1))
        const c = 1 / Math.hypot(t, 1)
        const s = t * c
        for (let k = 0; k < n; k++) [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]]
        for (let k = 0; k < n; k++) [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]]
      }
    }
    if (off < 1e-30) break
  }
  const eigenvalues = a.map((row, i) => row[i])
  const [least, most] = [Math.min(...eigenvalues), Math.max(...eigenvalues)]
  return least >= -1e-12 * most ? null : `eigenvalue ${least / most} of the largest`
}
