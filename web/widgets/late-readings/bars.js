/** What each way costs, over many seeds: the error that it leaves as a bar, and NEES, which says whether it knows. */

import { meaning } from '../../draw/plot.js'
import { fixed } from '../../draw/numbers.js'
import { WAYS } from './sensors.js'

/** Left and right of the bars, pixels. */
const [LEFT, RIGHT] = [116, 96]

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {import('estimate-wasm').LateFrame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawCosts({ pen, width, height }, { params, ways: own }, { aside }) {
  const { seeds, ways } = aside ?? { seeds: 0, ways: own }
  const row = (height - 48) / WAYS.length
  const most = Math.max(...ways.map((/** @type {{ rms: number }} */ { rms }) => rms))
  pen.draw(() => {
    const of = seeds === 0 ? 'this run' : `${seeds} seeds`
    pen.text('title', { class: 'plot-title', x: 0, y: 16 }, `RMS error over ${of}`)
    pen.text('nees', { class: 'plot-title', x: width, y: 16, 'text-anchor': 'end' }, 'NEES, 2 is right')
    for (const [i, { value, label }] of WAYS.entries()) {
      const y = 34 + i * row
      const { rms, nees } = ways[i]
      const chosen = value === params.way
      const long = Math.max(1, ((width - LEFT - RIGHT) * rms) / most)
      pen.text(`name${i}`, { class: chosen ? 'label' : 'tick', x: 0, y: y + row / 2 }, label)
      pen.mark('rect', `bar${i}`, {
        ...meaning('full', chosen ? 'posterior' : null),
        x: LEFT,
        y: y + row / 2 - 12,
        width: long,
        height: 16,
      })
      pen.text(`rms${i}`, { class: 'tick', x: LEFT + long + 5, y: y + row / 2 }, `${fixed(rms, 2)} m`)
      pen.text(`nees${i}`, { class: 'tick', x: width, y: y + row / 2, 'text-anchor': 'end' }, fixed(nees, 1))
    }
  })
}
