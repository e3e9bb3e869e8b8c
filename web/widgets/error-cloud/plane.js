/**
 * The plane of the errors: two hundred dots, the ellipse of their mean products, and the line of the regression. The
 * rectangle between the axes and the dot that is touched is its product.
 */

import { clear, drawLabels } from '../../draw/labels.js'
import { axes, ellipseLevel, ellipsePath, evenPlane, meaning, segment } from '../../draw/plot.js'
import { pixel } from '../../draw/path.js'
import { REACH } from './reach.js'
import { isLong, signed } from './words.js'

/** @typedef {import('estimate-wasm').ErrorCloudFrame} Frame */
/** @typedef {import('../../draw/plot.js').Plane} Plane */
/** @typedef {import('../../figure/spec.js').HandleSpec} HandleSpec */

/** How far the two lines go up and down, m/s. */
const LINE = 3.1

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawPlane({ pen, width, height }, frame, view) {
  const plane = evenPlane({ left: 40, top: 30, right: width - 12, bottom: height - 42 }, [0, 0], REACH)
  const grips = handles(plane, frame, view)
  pen.draw(() => {
    axes(pen, plane, { x: 'position error (m)', y: 'velocity error (m/s)', ticks: [6, 6], zero: true })
    ellipseLevel(pen, plane.box.left, plane.box.bottom + 32)
    pen.window('scene', plane.box, (to) => drawScene(to, plane, frame, width < 420 ? 1.8 : 2.5))
    names(pen, plane, frame, grips)
    pen.group('handles', {}, (to) => {
      for (const [key, grip] of Object.entries(grips)) view.handle(to, key, { ...grip, name: undefined })
    })
  })
}

/** @param {import('../../draw/pen.js').Pen} pen @param {Plane} plane @param {Frame} frame @param {number} r of a dot */
function drawScene(pen, plane, frame, r) {
  const { dots, ellipse, regression, longAxis, error } = frame
  const { x, y } = plane
  pen.mark('path', 'product', {
    ...meaning('area', 'posterior'),
    d: `M${x(0).toFixed(1)} ${y(0).toFixed(1)}H${x(error[0]).toFixed(1)}V${y(error[1]).toFixed(1)}H${x(0).toFixed(1)}Z`,
  })
  // A round dot for a product that adds, a bar for one that takes away.
  const [adds, takes] = [[], []].map(() => /** @type {string[]} */ ([]))
  for (const [a, b] of dots) {
    const at = `M${pixel(x(a) - r)} ${pixel(y(b))}`
    if (a * b > 0) adds.push(`${at}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`)
    else takes.push(`${at}h${2 * r}`)
  }
  pen.mark('path', 'adds', { ...meaning('full', 'prediction'), d: adds.join('') || 'M0 0' })
  pen.mark('path', 'takes', { ...meaning('line', 'prediction'), d: takes.join('') || 'M0 0' })
  pen.mark('path', 'ellipse', { ...meaning('outline', 'prediction'), d: ellipsePath(ellipse, [0, 0], plane) })
  const line = (/** @type {string} */ key, /** @type {number} */ slope, /** @type {string} */ shape) => {
    const high = Math.min(LINE, 100 / Math.max(1e-9, Math.abs(slope)))
    segment(pen, key, plane, [-slope * high, -high], [slope * high, high], meaning(shape))
  }
  if (isLong(frame)) line('axis', Math.max(-1e6, Math.min(1e6, longAxis)), 'way dashed')
  line('regression', regression, 'line')
}

/**
 * @param {import('../../draw/pen.js').Pen} pen @param {Plane} plane @param {Frame} frame
 * @param {Record<string, HandleSpec>} grips
 */
function names(pen, { x, y, box }, { regression, error, product }, grips) {
  const [px, py] = [x(error[0]), y(error[1])]
  const there = px > box.left && px < box.right && py > box.top && py < box.bottom
  drawLabels(
    pen,
    box,
    [
      ...(there
        ? [
            /** @type {import('../../draw/labels.js').Label} */ ({
              key: 'product-name',
              words: signed(product),
              at: [px, py],
              gap: 13,
              kin: 'posterior',
              sides: error[0] < 0 ? ['left', 'above-left', 'below-left'] : ['right', 'above-right', 'below-right'],
            }),
          ]
        : []),
      {
        key: 'major-name',
        words: 'tilt',
        at: grips.major.at,
        name: 'handle-name prediction',
        gap: 14,
        sides: ['right', 'below-right', 'above-left'],
      },
      {
        key: 'regression-name',
        words: 'regression',
        at: [x(regression * LINE), y(LINE)],
        gap: 8,
        sides: regression > 0 ? ['left', 'below-left', 'right'] : ['right', 'below-right', 'left'],
      },
    ],
    Object.values(grips).map(({ at }) => clear(at, 11)),
  )
}

/**
 * The two axes of the ellipse, and the dot that is touched.
 * @param {Plane} plane @param {Frame} frame @param {import('../../figure/spec.js').View} view
 * @returns {Record<string, HandleSpec>}
 */
function handles({ x, y, box }, { params, dots }, { limits }) {
  const { semiMajor, semiMinor, angle, dot } = params
  const [c, s] = [Math.cos(angle), Math.sin(angle)]
  const { least, greatest } = limits.semiMajor
  const length = (/** @type {number} */ value) => Math.max(least, Math.min(greatest, value))
  const last = dots.length - 1
  const look = (/** @type {number} */ at) => ({ dot: Math.max(0, Math.min(last, at)) })
  const words = (/** @type {number} */ value) => value.toFixed(2)
  const inside = (/** @type {number} */ px, /** @type {number} */ py) =>
    /** @type {[number, number]} */ ([
      Math.max(box.left, Math.min(box.right, px)),
      Math.max(box.top, Math.min(box.bottom, py)),
    ])
  const [a, b] = dots[dot]
  return {
    dot: {
      at: inside(x(a), y(b)),
      small: true,
      pressed: true,
      label: 'The error that is touched',
      kin: 'posterior',
      value: `${words(a)} metres and ${words(b)} metres a second, dot ${dot + 1} of ${dots.length}`,
      now: dot,
      min: 0,
      max: last,
      move: (px, py) => {
        const far = dots.map(([e, v]) => Math.hypot(x(e) - px, y(v) - py))
        return look(far.indexOf(Math.min(...far)))
      },
      nudge: (dx, dy) => look(dot + (dx || dy)),
      jump: (end) => look(end === 'home' ? 0 : last),
    },
    minor: {
      at: [x(-semiMinor * s), y(semiMinor * c)],
      small: true,
      label: 'Second axis of the ellipse',
      kin: 'prediction',
      value: `${words(semiMinor)} long`,
      now: semiMinor,
      min: least,
      max: greatest,
      move: (px, py) => ({ semiMinor: length(Math.abs(y.invert(py) * c - x.invert(px) * s)) }),
      nudge: (dx, dy) => ({ semiMinor: length(semiMinor + 0.05 * (dx || dy)) }),
      jump: (end) => ({ semiMinor: end === 'home' ? least : greatest }),
    },
    major: {
      at: [x(semiMajor * c), y(semiMajor * s)],
      label: 'First axis of the ellipse: tilt and length',
      kin: 'prediction',
      value: `${words(semiMajor)} long, at ${Math.round((angle * 180) / Math.PI)} degrees`,
      now: semiMajor,
      min: least,
      max: greatest,
      move: (px, py) => {
        const [dx, dy] = [x.invert(px), y.invert(py)]
        return { semiMajor: length(Math.hypot(dx, dy)), angle: Math.atan2(dy, dx) }
      },
      nudge: (dx, dy) => ({ angle: angle + (dx * Math.PI) / 180, semiMajor: length(semiMajor + 0.05 * dy) }),
      jump: (end) => ({ semiMajor: end === 'home' ? least : greatest }),
    },
  }
}
