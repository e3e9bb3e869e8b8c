/** The unit disc with the eigenvalues of (I − KH)F; where the reader places them, with handles. */

import { fixed } from '../../draw/numbers.js'
import { clear, drawLabels, rim } from '../../draw/labels.js'
import { dot, evenPlane, meaning } from '../../draw/plot.js'
import { decimalsOf } from './names.js'
import { MOST } from './presets.js'

/** @typedef {import('estimate-wasm').OwnFrame} Frame */
/** @typedef {import('../../figure/spec.js').HandleSpec} HandleSpec */

const REACH = 1.32
/** A pole this near to the real line is put on it, in its own units. */
const SNAP = 0.05

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawDisc({ pen, width, height }, frame, view) {
  const plane = evenPlane({ left: 14, top: 30, right: width - 14, bottom: height - 12 }, [0, 0], REACH)
  const { x, y, box } = plane
  const inside = (/** @type {number} */ value, /** @type {number} */ low, /** @type {number} */ high) =>
    Math.max(low, Math.min(high, value))
  const seen = frame.eigenvalues.map((value) => {
    const at = /** @type {[number, number]} */ ([
      inside(value.re, x.invert(box.left + 7), x.invert(box.right - 7)),
      inside(value.im, y.invert(box.bottom - 7), y.invert(box.top + 7)),
    ])
    return { ...value, at, off: at[0] !== value.re || at[1] !== value.im }
  })
  const placing = frame.params.gain === 'placement' && frame.placed === true
  pen.draw(() => {
    pen.text('title', { class: 'plot-title', x: box.left, y: 16 }, 'eigenvalues of (*I* − {K}{H}){F}')
    pen.mark('circle', 'disc', { class: 'disc', cx: x(0), cy: y(0), r: x(1) - x(0) })
    pen.mark('line', 'real', { class: 'zero', x1: box.left, x2: box.right, y1: y(0), y2: y(0) })
    pen.mark('line', 'imaginary', { class: 'zero', x1: x(0), x2: x(0), y1: box.top, y2: box.bottom })
    pen.mark('circle', 'rim', { class: 'disc-rim', cx: x(0), cy: y(0), r: x(1) - x(0) })
    seen.forEach(({ at, fixed: stays, modulus, off }, i) => {
      if (stays) pen.mark('circle', `ring${i}`, { class: 'pinned-ring', cx: x(at[0]), cy: y(at[1]), r: 11 })
      dot(pen, `dot${i}`, plane, at, {
        ...meaning(`eigenvalue${modulus >= 1 ? ' outside' : ''}${off ? ' hollow' : ''}`),
        r: 5.5,
      })
    })
    const pairs = decimalsOf(seen, 2)
    const decimals = Math.max(3, pairs)
    const written = (/** @type {{ re: number, im: number }} */ { re, im }) =>
      im > 0 ? `${fixed(re, pairs)} ± ${fixed(im, pairs)} i` : fixed(re, decimals)
    const shown = seen.filter(
      (one, i) =>
        one.im >= 0 &&
        !seen.slice(0, i).some((other) => (other.im === 0) === (one.im === 0) && written(other) === written(one)),
    )
    const labels = shown.map((value, i) => ({
      key: `name${i}`,
      at: /** @type {[number, number]} */ ([x(value.at[0]), y(value.at[1])]),
      gap: placing ? 15 : 11,
      name: `eigenvalue-name${value.modulus >= 1 ? ' outside' : ''}`,
      words: written(value),
      sides: /** @type {import('../../draw/labels.js').Side[]} */ (['above', 'below']),
    }))
    const taken = seen.map(({ at }) => clear([x(at[0]), y(at[1])], placing ? 11 : 7))
    drawLabels(pen, box, labels, [...taken, ...rim([x(0), y(0)], x(1) - x(0))])
    if (frame.params.gain !== 'placement') return
    pen.group('handles', {}, (into) =>
      poles(frame).forEach((pole) => view.handle(into, `pole${pole.index}`, handleOf(pole, plane, frame))),
    )
  })
}

/**
 * The poles that the reader sets, as the lab reads them: one off the real line takes the place of the next for its
 * conjugate.
 * @param {Frame} frame
 */
function poles({ params, movable }) {
  const found = []
  for (let index = 0; index < movable; index += 1) {
    const [re, im] = params.poles[index] ?? [0, 0]
    const pair = im !== 0 && index + 1 < movable
    found.push({ index, re, im: pair ? Math.abs(im) : 0, room: index + 1 < movable })
    if (pair) index += 1
  }
  return found
}

/**
 * @param {{ index: number, re: number, im: number, room: boolean }} pole
 * @param {import('../../draw/plot.js').Plane} plane
 * @param {Frame} frame
 * @returns {HandleSpec}
 */
function handleOf({ index, re, im, room }, { x, y }, { params }) {
  const rounded = (/** @type {number} */ value) => Math.round(Math.max(-1.3, Math.min(1.3, value)) * 100) / 100
  const put = (/** @type {number} */ toRe, /** @type {number} */ toIm) => {
    const next = Array.from({ length: Math.max(params.poles.length, index + 2) }, (_, i) => [
      ...(params.poles[i] ?? [0, 0]),
    ]).slice(0, MOST)
    const up = room && Math.abs(toIm) >= SNAP ? Math.abs(rounded(toIm)) : 0
    next[index] = [rounded(toRe), up]
    // A pair that comes back to the real line becomes two eigenvalues beside one another.
    if (im !== 0 && up === 0) next[index + 1] = [rounded(toRe), 0]
    return { poles: next }
  }
  return {
    at: [x(re), y(im)],
    small: true,
    label: `Eigenvalue ${index + 1}${im ? ' and its conjugate' : ''}`,
    value: im ? `${fixed(re, 2)} ± ${fixed(im, 2)} i` : fixed(re, 2),
    now: re,
    min: -1.3,
    max: 1.3,
    move: (px, py) => put(x.invert(px), y.invert(py)),
    nudge: (dx, dy) =>
      put(re + 0.01 * dx, dy === 0 ? im : im === 0 ? SNAP * Math.sign(dy) : im + 0.01 * dy < SNAP ? 0 : im + 0.01 * dy),
    jump: (end) => put(end === 'home' ? -0.95 : 0.95, im),
  }
}
