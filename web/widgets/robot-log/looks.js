/**
 * What a reader looks at in a log, which changes nothing of the replay: a stretch of time, one sensor or landmark, one
 * reading, and the replay A that was kept for comparison. A run hands it to the panels with its frame.
 */

/** @typedef {import('estimate-wasm').LogFrame} LogFrame */
/**
 * @typedef {{ sensor: string, landmark: number | null, bearing: boolean }} Source
 * `bearing` where its bearings are meant
 */
/**
 * @typedef {object} Looks
 * @property {[number, number] | null} window from when to when, seconds since the log's first row
 * @property {Source | null} source whose innovations; null of all
 * @property {number | null} touched when the reading was that the reader has touched, seconds since the log's first row
 * @property {LogFrame | null} kept A
 */
/** @typedef {'wheels' | 'base' | 'course' | 'landmarks' | 'corrections' | 'readings'} Known what it may have besides */
/** @typedef {Partial<Pick<import('estimate-wasm').LogContents, Known>>} More */
/** @typedef {{ motion: string, names: string[] } & More} Log what panels need of a log’s contents */
/**
 * @typedef {LogFrame & { looks?: Looks, log?: (Log & { span: [number, number] }) | null }} Frame
 * with the contents of its log, one object for a log
 */

/** @type {Looks} */
export const NOTHING = { window: null, source: null, touched: null, kept: null }

/** @param {Frame} frame @returns {Looks} */
export const looksOf = ({ looks }) => looks ?? NOTHING

/** The stretch of time that is shown, seconds. @param {Frame} frame @returns {[number, number]} */
export const spanOf = (frame) => looksOf(frame).window ?? [0, Math.max(frame.duration, 0.06)]

/** Which innovations are shown, as a test of their numbers. @param {LogFrame} frame @param {Source | null} source */
export function belongs({ innovations: { sensor, landmark } }, source) {
  return (/** @type {number} */ i) =>
    !source || (sensor[i] === source.sensor && (source.landmark === null || landmark[i] === source.landmark))
}

/** Their numbers, ν/√S. @param {LogFrame} frame @param {Source | null} source */
export function numbersOf({ innovations: { normalized, second } }, source) {
  return source?.bearing ? second.map((value) => value ?? Number.NaN) : normalized
}

/** The number of the reading that was touched, among the frame's innovations; −1 of none. @param {Frame} frame */
export function touchedIn(frame) {
  const { touched, source } = looksOf(frame)
  if (touched === null) return -1
  const { time } = frame.innovations
  const far = (/** @type {number} */ i) => Math.abs(time[i] - touched)
  const mine = nearest(frame, source, far)
  return mine >= 0 && far(mine) < 1e-6 ? mine : nearest(frame, null, far)
}

/** @param {LogFrame} frame @param {Source | null} source @param {(i: number) => number} far */
export function nearest(frame, source, far) {
  const mine = belongs(frame, source)
  const numbers = numbersOf(frame, source)
  let [best, least] = [-1, Infinity]
  for (let i = 0; i < frame.innovations.time.length; i += 1) {
    if (!mine(i) || !Number.isFinite(numbers[i])) continue
    const distance = far(i)
    if (distance < least) [best, least] = [i, distance]
  }
  return best
}

const NAMES = /** @type {Record<string, string>} */ ({
  fix: 'positions',
  heading: 'headings',
  range: 'ranges',
  bearing: 'ranges',
})

/** What a landmark is called: by its file, or by its number. @param {{ log?: Log | null }} frame @param {number} id */
export function landmarkName({ log }, id) {
  return log?.names[id - 1] ?? String(id)
}

/** @param {Source} source @param {Frame} frame */
export function nameOf({ sensor, landmark, bearing }, frame) {
  const what = bearing ? 'bearings' : NAMES[sensor]
  return landmark === null ? what : `${what} of ${landmarkName(frame, landmark)}`
}

/** Every sensor and landmark of which there are readings. @param {LogFrame} frame @returns {Source[]} */
export function sourcesOf({ summary: { sensors }, byLandmark }) {
  const each = /** @type {const} */ (['fix', 'heading', 'range', 'bearing']).filter((sensor) => sensors[sensor])
  const places = byLandmark.filter(({ used, refused }) => used + refused > 0)
  return each.flatMap((sensor) => {
    const of = (/** @type {boolean} */ bearing) => {
      const landmarks = sensor === 'range' || sensor === 'bearing' ? places : []
      return [null, ...landmarks.map(({ id }) => id)].map((landmark) => ({ sensor, landmark, bearing }))
    }
    return sensor === 'bearing' ? [...of(false), ...of(true)] : of(false)
  })
}
