/** The readings of each cart, step by step, on a strip of its own. On the second strip the first one's stand behind. */

import { axes, dot, meaning, plane as planeOf, seriesPath } from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').TwoCartsFrame} Frame */

/** What a strip shows, in the sensor's unit: the first that is far enough, so that it seldom changes. */
const REACHES = /** @type {[number, number][]} */ ([
  [-3.2, 3.2],
  [-2.5, 6.5],
  [-11, 15],
])

/** @param {import('../../figure/shell.js').Panel} panel @param {Frame} frame */
export function drawStrips({ pen, width, height }, { params, readings }) {
  const all = readings.flat()
  const [low, high] = [Math.min(...all), Math.max(...all)]
  const up = REACHES.find(([from, to]) => from < low && high < to) ?? [low, high]
  const unit = params.sensor === 'velocity' ? 'm/s' : 'm'
  const steps = readings[0].map((_, k) => k)
  const tall = height / 2
  pen.draw(() => {
    for (const [i, words] of ['first', 'second'].entries()) {
      const box = { left: 40, top: i * tall + 24, right: width - 12, bottom: (i + 1) * tall - 22 }
      const plane = planeOf(box, [-0.4, steps.length - 0.6], up)
      pen.group(words, {}, (to) => {
        axes(to, plane, { title: `${words} cart: readings (${unit}) at step *k*`, ticks: [8, 3] })
        to.window('strip', box, (into) => {
          if (i > 0)
            into.mark('path', 'other', {
              ...meaning('curve dashed', 'truth'),
              d: seriesPath(plane, steps, readings[0]),
            })
          into.mark('path', 'line', { ...meaning('curve', 'measurement'), d: seriesPath(plane, steps, readings[i]) })
          for (const k of steps)
            dot(into, `reading${k}`, plane, [k, readings[i][k]], { ...meaning('full', 'measurement'), r: 3.5 })
        })
      })
    }
  })
}
