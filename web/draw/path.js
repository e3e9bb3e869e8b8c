/**
 * Writes short path data: tenths of a pixel, each point relative to the one before, and no point that lies within a
 * sixth of a pixel of the line. The browser reads such data at every frame. The page carries its stills in whole
 * pixels.
 */

/** How far a line may pass from a point that is left out, pixels, and how many places a pixel has. */
let near = 0.16
let places = 10
const MOST = 1e5
/** The text of the common steps, by their length in tenths of a pixel. */
const STEPS = Array.from({ length: 4001 }, (_, i) => short((i - 2000) / 10))

/** @param {number} value */
function short(value) {
  return String(Math.round(value * 10) / 10).replace(/^(-?)0\./, '$1.')
}

/** @param {number} tenths */
function written(tenths) {
  return STEPS[tenths + 2000] ?? short(tenths / 10)
}

/** Rounds to a place of a pixel, and keeps within what a browser can draw. @param {number} value */
export function pixel(value) {
  return Math.round(Math.max(-MOST, Math.min(MOST, value)) * places) / places
}

/** From now on, draws in whole pixels: for a still, which a reader sees for a moment or on paper. */
export function coarse() {
  near = 0.5
  places = 1
}

/** Writes one path, point by point. */
export class Outline {
  data = ''
  x = 0
  y = 0
  /** The last step. */
  dx = 0
  dy = 0
  open = false

  /** Starts a line. @param {number} x @param {number} y */
  move(x, y) {
    this.x = Math.round(pixel(x) * 10)
    this.y = Math.round(pixel(y) * 10)
    const second = written(this.y)
    this.data += `M${written(this.x)}${second.startsWith('-') ? '' : ' '}${second}`
    this.open = false
  }

  /** Adds a straight line. @param {number} x @param {number} y */
  line(x, y) {
    const dx = Math.round(pixel(x) * 10) - this.x
    const dy = Math.round(pixel(y) * 10) - this.y
    if (dx === 0 && dy === 0) return
    this.data += (this.open ? (dx < 0 ? '' : ' ') : 'l') + written(dx) + (dy < 0 ? '' : ' ') + written(dy)
    this.open = true
    this.x += dx
    this.y += dy
  }

  /**
   * Adds a cubic curve.
   * @param {number} ax @param {number} ay first control point
   * @param {number} bx @param {number} by second control point
   * @param {number} x @param {number} y end
   */
  curve(ax, ay, bx, by, x, y) {
    const [x0, y0] = [this.x, this.y]
    this.open = false
    this.data += 'c'
    this.lean(ax, ay, false)
    this.lean(bx, by, true)
    this.lean(x, y, true)
    this.x = x0 + this.dx
    this.y = y0 + this.dy
  }

  /** @param {number} x @param {number} y @param {boolean} apart */
  lean(x, y, apart) {
    this.dx = Math.round(pixel(x) * 10) - this.x
    this.dy = Math.round(pixel(y) * 10) - this.y
    this.data += (apart && this.dx >= 0 ? ' ' : '') + written(this.dx) + (this.dy < 0 ? '' : ' ') + written(this.dy)
  }
}

/** Room for the points of one line, in pixels; it grows when a line needs more. */
let across = new Float64Array(2048)
let down = new Float64Array(2048)

/**
 * A line through points in data units. A point is left out where the line between its neighbours passes near enough.
 * This is written for speed: a figure draws thousands of points in every frame, often before the browser has compiled
 * the code.
 * @param {number} count
 * @param {import('./scale.js').Scale} x
 * @param {ArrayLike<number>} xs
 * @param {import('./scale.js').Scale} y
 * @param {ArrayLike<number>} ys it breaks where one is not finite, or has no logarithm
 */
export function polyline(count, x, xs, y, ys) {
  if (across.length < count) {
    across = new Float64Array(2 * count)
    down = new Float64Array(2 * count)
  }
  x.all(xs, count, across)
  y.all(ys, count, down)
  return traced(count)
}

/** @param {number[][]} points @param {import('./scale.js').Scale} x @param {import('./scale.js').Scale} y */
export function pairs(points, x, y) {
  const count = points.length
  if (across.length < count) {
    across = new Float64Array(2 * count)
    down = new Float64Array(2 * count)
  }
  for (let i = 0; i < count; i += 1) {
    across[i] = points[i][0]
    down[i] = points[i][1]
  }
  x.all(across, count, across)
  y.all(down, count, down)
  return traced(count)
}

/**
 * Keeps a point only where the line needs it. From the last point kept, each point after it narrows the directions in
 * which a
 * straight line passes near all of them. @param {number} count */
function traced(count) {
  const out = new Outline()
  let fromX = 0,
    fromY = 0,
    lastX = 0,
    lastY = 0
  let leftX = 0,
    leftY = 0,
    rightX = 0,
    rightY = 0,
    far = -1
  let going = false
  for (let i = 0; i < count; i += 1) {
    const px = across[i]
    const py = down[i]
    if (!(px - px === 0 && py - py === 0)) {
      if (going && far > 0) out.line(lastX, lastY)
      going = false
      continue
    }
    if (!going) {
      out.move(px, py)
      fromX = lastX = px
      fromY = lastY = py
      far = -1
      going = true
      continue
    }
    let vx = px - fromX
    let vy = py - fromY
    let length = Math.sqrt(vx * vx + vy * vy)
    if (far >= 0 && (length < far - near || leftX * vy - leftY * vx > 0 || rightX * vy - rightY * vx < 0)) {
      out.line(lastX, lastY)
      fromX = lastX
      fromY = lastY
      far = -1
      vx = px - fromX
      vy = py - fromY
      length = Math.sqrt(vx * vx + vy * vy)
    }
    if (length > near) {
      const sx = (-vy / length) * near
      const sy = (vx / length) * near
      if (far < 0 || leftX * (vy + sy) - leftY * (vx + sx) < 0) {
        leftX = vx + sx
        leftY = vy + sy
      }
      if (far < 0 || rightX * (vy - sy) - rightY * (vx - sx) > 0) {
        rightX = vx - sx
        rightY = vy - sy
      }
      if (length > far) far = length
    }
    lastX = px
    lastY = py
  }
  if (going && far > 0) out.line(lastX, lastY)
  return out.data
}
