/** The handles on the line of time: the camera's reading in hand, and the two ends of a gap. */

/** @typedef {import('estimate-wasm').LateFrame} Frame */
/** @typedef {import('../../figure/spec.js').HandleSpec} HandleSpec */

/** So far above or below its row, pixels, a reading is taken out of the run. */
const OUT = 30

/**
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').Limits} limits
 * @param {import('../../draw/plot.js').Plane} plane
 * @param {{ measured: number, came: number, height: number }} rows
 * @returns {Record<string, HandleSpec>}
 */
export function handlesOf(frame, limits, plane, rows) {
  const { params, picked, sensors } = frame
  const { x, box } = plane
  const clamp = (/** @type {number} */ value, /** @type {number} */ low, /** @type {number} */ high) =>
    Math.max(low, Math.min(high, value))
  /** @type {Record<string, HandleSpec>} */
  const grips = {}
  if (params.gap) Object.assign(grips, ofGap(frame, limits, plane))
  if (!picked) return grips
  const period = sensors[2].period
  const choose = (/** @type {number} */ number) => ({
    picked: clamp(Math.round(number), 0, picked.of - 1),
    ownDelay: null,
    removed: false,
  })
  grips.which = {
    at: [x(picked.measured), rows.height - rows.measured],
    small: true,
    kin: 'measurement',
    label: 'Which of the camera’s readings is in hand',
    value:
      `number ${picked.number + 1} of ${picked.of}, ` +
      (picked.missing
        ? `in the gap at ${picked.measured.toFixed(2)} s: never measured`
        : `measured at ${picked.measured.toFixed(2)} s`),
    now: picked.number + 1,
    min: 1,
    max: picked.of,
    move: (px) => choose(x.invert(px) / period - 1),
    nudge: (dx, dy) => choose(picked.number + (dx || dy)),
    jump: (to) => choose(to === 'home' ? 0 : picked.of - 1),
  }
  // What was never measured never comes.
  if (picked.missing) return grips
  const { step, greatest: most } = limits.ownDelay
  const delay = picked.came - picked.measured
  const comes = (/** @type {number} */ wanted) => ({
    ownDelay: Number((Math.round(clamp(wanted, 0, most) / step) * step).toFixed(2)),
    removed: false,
  })
  const row = rows.height - rows.came
  grips.came = {
    at: [Math.min(x(picked.came), box.right), params.removed ? row - OUT / 2 : row],
    kin: 'measurement',
    label: 'When that reading came; up takes it out',
    value: params.removed
      ? `taken out; it came after ${delay.toFixed(2)} s`
      : `${delay.toFixed(2)} s after it was measured`,
    now: delay,
    min: 0,
    max: most,
    move: (px, py) => (Math.abs(py - row) > OUT ? { removed: true } : comes(x.invert(px) - picked.measured)),
    nudge: (dx, dy) => (dy > 0 ? { removed: !params.removed } : dy < 0 ? { removed: false } : comes(delay + step * dx)),
    jump: (to) => comes(to === 'home' ? 0 : most),
  }
  return grips
}

/**
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').Limits} limits
 * @param {import('../../draw/plot.js').Plane} plane
 * @returns {Record<string, HandleSpec>}
 */
function ofGap({ params, end }, limits, { x, box }) {
  const [a, b] = /** @type {[number, number]} */ (params.gap)
  const [from, to] = [Math.min(a, b), Math.max(a, b)]
  const { step } = limits.gap
  const snap = (/** @type {number} */ value) => Number((Math.round(value / step) * step).toFixed(2))
  const keep = (/** @type {number} */ value, /** @type {number} */ low, /** @type {number} */ high) =>
    Math.max(low, Math.min(high, snap(value)))
  const ends = /** @type {const} */ ([
    ['from', from, 'Where the gap begins', (/** @type {number} */ value) => [keep(value, 0, to), to]],
    ['to', to, 'Where the gap ends', (/** @type {number} */ value) => [from, keep(value, from, end)]],
  ])
  return Object.fromEntries(
    ends.map(([key, at, label, gap]) => [
      `gap-${key}`,
      {
        at: /** @type {[number, number]} */ ([x(at), box.top + 8]),
        small: true,
        label,
        value: `at ${at.toFixed(2)} s`,
        now: at,
        min: 0,
        max: end,
        move: (px) => ({ gap: gap(x.invert(px)) }),
        nudge: (dx, dy) => ({ gap: gap(at + 2 * step * (dx || dy)) }),
        jump: (to) => ({ gap: gap(to === 'home' ? 0 : end) }),
      },
    ]),
  )
}
