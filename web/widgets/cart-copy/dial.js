/** A speedometer: zero is upward, forward to the right. */

import { clear, drawLabels } from '../../draw/labels.js'
import { meaning } from '../../draw/plot.js'
import { fixed } from '../../draw/numbers.js'

/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Kin} Kin */
/** @typedef {{ x: number, y: number, r: number }} Face its middle and its radius, pixels */

/** The speed at either end of the face, m/s, and the angle there. */
const FASTEST = 4
const SWEEP = (100 * Math.PI) / 180

/** @param {number} width @param {number} height of the panel */
export function faceOf(width, height) {
  const r = Math.min(0.21 * width, 0.25 * height)
  return { x: 0, y: 40 + r, r }
}

/** @param {number} speed */
const angle = (speed) => (SWEEP * Math.max(-FASTEST, Math.min(FASTEST, speed))) / FASTEST

/** A point of the face. @param {Face} face @param {number} speed @param {number} part of the radius */
function on({ x, y, r }, speed, part) {
  const a = angle(speed)
  return /** @type {[number, number]} */ ([x + part * r * Math.sin(a), y - part * r * Math.cos(a)])
}

/** The end of a needle. @param {Face} face @param {number} speed */
export const tip = (face, speed) => on(face, speed, 0.8)

/** The speed that a needle shows which points there. @param {Face} face @param {number} px @param {number} py */
export const speedAt = ({ x, y }, px, py) => (FASTEST * Math.atan2(px - x, y - py)) / SWEEP

/**
 * @param {Pen} pen
 * @param {string} key
 * @param {Face} face
 * @param {string} title
 * @param {(readonly [string, Kin, number])[]} needles key, meaning and speed of each
 * @param {[number, number] | null} [gap] two speeds whose difference is the innovation
 */
export function drawDial(pen, key, face, title, needles, gap = null) {
  const { x, y, r } = face
  const [from, to] = [on(face, -FASTEST, 1), on(face, FASTEST, 1)]
  const small = r < 72
  pen.group(key, {}, (into) => {
    const arc = `M${from[0].toFixed(1)} ${from[1].toFixed(1)}A${r} ${r} 0 1 1 ${to[0].toFixed(1)} ${to[1].toFixed(1)}`
    into.mark('path', 'face', { class: 'axis', d: arc })
    for (let speed = -FASTEST; speed <= FASTEST; speed += small ? 2 : 1) {
      const [[ax, ay], [bx, by], [tx, ty]] = [on(face, speed, 1), on(face, speed, 0.93), on(face, speed, 1.13)]
      into.mark('line', `tick${speed}`, { class: 'axis', x1: ax, y1: ay, x2: bx, y2: by })
      if (speed % 2 === 0)
        into.text(`speed${speed}`, { class: 'tick', x: tx, y: ty + 4, 'text-anchor': 'middle' }, fixed(speed, 0))
    }
    into.text('title', { class: 'plot-title', x, y: 14, 'text-anchor': 'middle' }, title)
    if (gap && Math.abs(gap[1] - gap[0]) > 0.02) {
      const [[ax, ay], [bx, by]] = [on(face, gap[0], 0.62), on(face, gap[1], 0.62)]
      const round = `A${(0.62 * r).toFixed(1)} ${(0.62 * r).toFixed(1)} 0 0 ${gap[1] > gap[0] ? 1 : 0}`
      into.mark('path', 'gap', {
        ...meaning('curve', 'measurement'),
        d: `M${ax.toFixed(1)} ${ay.toFixed(1)}${round} ${bx.toFixed(1)} ${by.toFixed(1)}`,
      })
    }
    for (const [name, kin, speed] of needles) {
      const [bx, by] = tip(face, speed)
      into.mark('line', name, {
        ...meaning(kin === 'prediction' ? 'way dashed' : 'line', kin),
        x1: x,
        y1: y,
        x2: bx,
        y2: by,
      })
    }
    into.mark('circle', 'hub', { class: 'corner', cx: x, cy: y, r: 3.5 })
    const said = gap ? `innovation ${fixed(gap[1] - gap[0])}` : `${fixed(needles[0][2])} m/s`
    drawLabels(
      into,
      { left: x - 1.3 * r, right: x + 1.3 * r, top: y + 2, bottom: y + 0.5 * r + 20 },
      [{ key: 'said', words: said, at: [x, y + 6], gap: 9, kin: 'measurement', sides: ['below'] }],
      [clear([x, y], 5)],
    )
  })
}
