/** The plane: a prediction, the line of a reading, the reader's dot on it, and an ellipse that grows to the line. */

import { fixed } from '../../draw/numbers.js'
import { along, clear, drawLabels } from '../../draw/labels.js'
import {
  axes,
  clipLine,
  dot,
  ellipsePath,
  ellipsePoints,
  evenPlane,
  halves,
  meaning,
  segment,
} from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').TouchFrame} Frame */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** The middle of the axes, and how far they reach from it to the nearer edge. */
const CENTRE = /** @type {[number, number]} */ ([4, 3.65])
const REACH = 1.85
/** The ellipse begins so small, and grows by so much in a second, in standard deviations. */
const SEED = 0.25
const A_SECOND = 0.8
/** The ring of a handle while it is held, pixels. */
const HELD = 14
/** Two dots nearer than this lie on one another, m. */
const COVERS = 0.1

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @returns {boolean} whether the ellipse still grows
 */
export function drawPlane({ pen, width, height }, frame, view) {
  const plane = evenPlane({ left: 44, top: 30, right: width - 14, bottom: height - 42 }, CENTRE, REACH)
  const radius = grown(frame, view)
  const touches = frame.params.grown && radius >= frame.touchRadius
  pen.draw(() => {
    axes(pen, plane, { x: 'position (m)', y: 'velocity (m/s)', ticks: [6, 4] })
    pen.window('scene', plane.box, (to) => {
      const line = clipLine(frame.H, frame.reading, plane)
      if (line) segment(to, 'omega', plane, ...line, meaning('line', 'measurement'))
      to.mark('path', 'ellipse', {
        ...meaning('outline', 'prediction'),
        d: ellipsePath(frame.ellipse, frame.mean, plane, radius),
      })
      if (touches) segment(to, 'off', plane, frame.guess, frame.touch, meaning('track', 'posterior'))
    })
    dot(pen, 'mean', plane, frame.mean, meaning('hollow', 'prediction'))
    if (touches) {
      // Where another dot lies on it, a ring of it is to be seen.
      const covered = Math.min(...[frame.guess, frame.touch].map(([across]) => Math.abs(frame.below[0] - across)))
      dot(pen, 'gray-foot', plane, frame.below, { ...meaning('foot', 'truth'), r: covered < COVERS ? 8 : 4 })
      dot(pen, 'touch', plane, frame.touch, { ...meaning('full', 'posterior'), r: 6 })
    }
    const grip = guess(plane, frame, view)
    names(pen, plane, frame, radius, touches, grip.at)
    pen.group('handles', {}, (to) => view.handle(to, 'guess', grip))
  })
  return frame.params.grown && !touches
}

/** The radius on the screen. @param {Frame} frame @param {import('../../figure/spec.js').View} view */
function grown({ params, touchRadius }, { memory, elapsed }) {
  const from = memory.radius ?? SEED
  memory.radius = params.grown ? Math.min(touchRadius, from + (A_SECOND * elapsed) / 1000) : SEED
  return memory.radius
}

/**
 * @param {import('../../draw/pen.js').Pen} pen @param {Plane} plane @param {Frame} frame
 * @param {number} radius @param {boolean} touches @param {[number, number]} guess
 */
function names(pen, plane, frame, radius, touches, guess) {
  const { x, y, box } = plane
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([x(p[0]), y(p[1])])
  const narrow = box.right - box.left < 420
  const off = frame.off
  drawLabels(
    pen,
    box,
    [
      {
        key: 'guess-name',
        words: 'your dot',
        at: guess,
        gap: 18,
        kin: 'measurement',
        sides: off < 0 ? ['below', 'below-left'] : ['below', 'below-right'],
      },
      ...(touches
        ? [
            /** @type {import('../../draw/labels.js').Label} */ ({
              key: 'touch-name',
              words: 'purple foot',
              at: at(frame.touch),
              kin: 'posterior',
              sides: off < 0 ? ['below-right', 'below'] : ['below-left', 'below'],
            }),
            ...(apart(frame)
              ? [
                  /** @type {import('../../draw/labels.js').Label} */ ({
                    key: 'gray-name',
                    words: 'gray foot',
                    at: at(frame.below),
                    kin: 'truth',
                    gap: 12,
                    sides: ['above-right', 'above', 'above-left'],
                  }),
                ]
              : []),
          ]
        : []),
      {
        key: 'mean-name',
        words: 'prediction',
        at: at(frame.mean),
        kin: 'prediction',
        gap: 8,
        sides: ['above-right', 'above', 'right'],
      },
      {
        key: 'radius-name',
        words: `${fixed(radius)} *σ*`,
        at: [x(frame.mean[0]), y(frame.mean[1] + radius * halves(frame.ellipse)[1])],
        kin: 'prediction',
        gap: 8,
        sides: ['above', 'above-right'],
      },
      {
        key: 'omega-name',
        words: narrow ? 'Ω' : 'Ω: {H}*x* = {y}',
        at: [box.right - (narrow ? 14 : 50), y(frame.reading)],
        gap: 5,
        kin: 'measurement',
        sides: ['above'],
      },
    ],
    [
      clear(at(frame.mean), 6),
      clear(guess, HELD),
      ...(touches ? [clear(at(frame.touch), 7)] : []),
      ...along(ellipsePoints(frame.ellipse, frame.mean, plane, radius)),
    ],
  )
}

/** Whether the gray foot stands apart from the purple one. @param {Frame} frame */
const apart = ({ below, touch }) => Math.abs(below[0] - touch[0]) > 0.25

/**
 * The reader's dot, which stays on the line; after a move the ellipse is small again.
 * @param {Plane} plane @param {Frame} frame @param {import('../../figure/spec.js').View} view
 * @returns {import('../../figure/spec.js').HandleSpec}
 */
function guess({ x, y }, { params, below, guess: at }, { limits }) {
  const { least, greatest } = limits.guess
  const put = (/** @type {number} */ place) => ({ guess: Math.max(least, Math.min(greatest, place)), grown: false })
  return {
    at: [x(below[0] + params.guess), y(below[1])],
    label: 'Your dot on the line',
    kin: 'measurement',
    value: `at ${at[0].toFixed(2)} metres, ${at[1].toFixed(2)} metres a second`,
    now: params.guess,
    min: least,
    max: greatest,
    move: (px) => put(x.invert(px) - below[0]),
    nudge: (dx, dy) => put(params.guess + 0.05 * (dx || dy)),
    jump: (end) => put(end === 'home' ? least : greatest),
  }
}
