/**
 * The log-likelihood of the car's fixes against the delay of its speed: computed beside the run, a delay at a time. The
 * reader's own delay is a handle on it.
 */

import { fixed } from '../../draw/numbers.js'
import { axes, meaning, plane as planeOf, seriesPath } from '../../draw/plot.js'
import { rounded } from '../../draw/scale.js'
import { empty } from '../../draw/statistics.js'
import { InParts, inOne } from '../../figure/in-parts.js'
import { carLab } from './open.js'

/** @typedef {import('estimate-wasm').CarFrame} Frame */
/** @typedef {{ delays: number[], values: number[] }} Curve as far as it has come */

/** The delays of the curve, seconds. */
const [FROM, TO, STEP] = [-0.5, 1.5, 0.1]
const DELAYS = Array.from({ length: Math.round((TO - FROM) / STEP) + 1 }, (_, i) =>
  Number((FROM + i * STEP).toFixed(2)),
)

/**
 * Begins anew where the filter is told something else than a delay.
 * @type {import('../../figure/in-parts.js').Task<Curve>}
 */
export const tracing = {
  parts: DELAYS.length,
  unit: 'delay',
  each: 1,
  stays: false,
  about: (params) => JSON.stringify({ ...params, delay: 0 }),
  wanted: ({ fixes }) => fixes !== 'none',
  compute: (lab, from) => [lab.likelihood(DELAYS[from])],
  value: (values) => ({ delays: DELAYS.slice(0, values.length), values: [...values] }),
}

/** @type {import('../../figure/spec.js').Aside} */
export const curve = {
  whole: (lab) => inOne(tracing, lab),
  open: (changed) =>
    new InParts(tracing, changed, async (params) =>
      (await carLab()).from({ version: 1, lab: 'car-log', step: 0, params }),
    ),
}

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawCurve({ pen, width, height }, { params, logLikelihood }, view) {
  const box = { left: 58, top: 26, right: width - 14, bottom: height - 38 }
  /** @type {Curve} */
  const { delays, values } = view.aside ?? { delays: [], values: [] }
  const own = logLikelihood ?? 0
  const [low, high] = [Math.min(own, ...values), Math.max(own, ...values)]
  const room = Math.max(1, 0.06 * (high - low))
  const plane = planeOf(box, [FROM, TO], rounded(low - room, high + room, 4))
  const held = (/** @type {number} */ delay) => Math.max(FROM, Math.min(TO, delay))
  const { step } = view.limits.delay
  const to = (/** @type {number} */ delay) => ({ delay: Number((Math.round(held(delay) / step) * step).toFixed(2)) })
  pen.draw(() => {
    axes(pen, plane, { title: 'log-likelihood of the fixes', x: 'delay of the speed, s', ticks: [5, 4] })
    if (logLikelihood === null) empty(pen, plane, 'no fix is used')
    pen.mark('path', 'curve', { ...meaning('curve', 'measurement'), d: seriesPath(plane, delays, values) })
    pen.group('handles', {}, (into) =>
      view.handle(into, 'delay', {
        at: [plane.x(held(params.delay)), plane.y(own)],
        kin: 'measurement',
        label: 'Delay of the speed',
        value: `${fixed(params.delay, 2)} s`,
        now: params.delay,
        min: FROM,
        max: TO,
        move: (px) => to(plane.x.invert(px)),
        nudge: (dx, dy) => to(params.delay + step * (dx || dy)),
        jump: (end) => to(end === 'home' ? FROM : TO),
      }),
    )
  })
}
