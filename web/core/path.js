/**
 * Path data as short as the eye allows: points to a tenth of a pixel, none where a straight line passes within a sixth of
 * one, and steps instead of places. What a picture weighs in the page, and what a browser reads at every frame.
 */

const NEAR = 0.16
const MOST = 1e5
/** A tenth of a pixel as it is written, for the steps that are common. */
const STEPS = Array.from({ length: 4001 }, (_, i) => short((i - 2000) / 10))

/** @param {number} value */
function short(value) {
  return String(Math.round(value * 10) / 10).replace(/^(-?)0\./, '$1.')
}

/** @param {number} tenths */
function written(tenths) {
  return STEPS[tenths + 2000] ?? short(tenths / 10)
}

/** To a tenth of a pixel, and no farther off than a drawing can reach. @param {number} value */
export function pixel(value) {
  return Math.round(Math.max(-MOST, Math.min(MOST, value)) * 10) / 10
}

/** Writes one path, point by point. */
export class Outline {
  data = ''
  x = 0
  y = 0
  open = false

  /** Starts a line. @param {number} x @param {number} y */
  move(x, y) {
    this.x = Math.round(pixel(x) * 10)
    this.y = Math.round(pixel(y) * 10)
    const second = written(this.y)
    this.data += `M${written(this.x)}${second.startsWith('-') ? '' : ' '}${second}`
    this.open = false
  }

  /** Goes on straight. @param {number} x @param {number} y */
  line(x, y) {
    const [dx, dy] = [Math.round(pixel(x) * 10) - this.x, Math.round(pixel(y) * 10) - this.y]
    if (dx === 0 && dy === 0) return
    const [first, second] = [written(dx), written(dy)]
    this.data += `${this.open ? (dx < 0 ? '' : ' ') : 'l'}${first}${dy < 0 ? '' : ' '}${second}`
    this.open = true
    this.x += dx
    this.y += dy
  }

  /**
   * Goes on in a curve.
   * @param {number} ax @param {number} ay where it leans at first
   * @param {number} bx @param {number} by where it leans at last
   * @param {number} x @param {number} y where it ends
   */
  curve(ax, ay, bx, by, x, y) {
    this.data += 'c'
    this.step(ax, ay)
    this.step(bx, by)
    ;[this.x, this.y] = this.step(x, y)
    this.open = false
  }

  /** @param {number} x @param {number} y */
  step(x, y) {
    const at = /** @type {[number, number]} */ ([Math.round(pixel(x) * 10), Math.round(pixel(y) * 10)])
    const [dx, dy] = [at[0] - this.x, at[1] - this.y]
    const before = dx < 0 || this.data.endsWith('c') ? '' : ' '
    this.data += `${before}${written(dx)}${dy < 0 ? '' : ' '}${written(dy)}`
    return at
  }
}

/**
 * A line through `count` points in pixels. A point is left out where the straight line from the last one kept to the next
 * passes near enough: each new point narrows the directions in which that holds.
 * @param {number} count
 * @param {(i: number) => number} x
 * @param {(i: number) => number} y not finite where the line breaks
 */
export function polyline(count, x, y) {
  const out = new Outline()
  let [fromX, fromY, lastX, lastY] = [0, 0, 0, 0]
  let [leftX, leftY, rightX, rightY, far] = [0, 0, 0, 0, -1]
  let going = false
  for (let i = 0; i < count; i += 1) {
    const [px, py] = [x(i), y(i)]
    if (!Number.isFinite(px) || !Number.isFinite(py)) {
      if (going && far > 0) out.line(lastX, lastY)
      going = false
      continue
    }
    if (!going) {
      out.move(px, py)
      ;[fromX, fromY, lastX, lastY, far, going] = [px, py, px, py, -1, true]
      continue
    }
    let [vx, vy] = [px - fromX, py - fromY]
    let length = Math.sqrt(vx * vx + vy * vy)
    const within = far < 0 || (length >= far - NEAR && leftX * vy - leftY * vx <= 0 && rightX * vy - rightY * vx >= 0)
    if (!within) {
      out.line(lastX, lastY)
      ;[fromX, fromY, far] = [lastX, lastY, -1]
      ;[vx, vy] = [px - fromX, py - fromY]
      length = Math.sqrt(vx * vx + vy * vy)
    }
    if (length > NEAR) {
      const [sx, sy] = [(-vy / length) * NEAR, (vx / length) * NEAR]
      if (far < 0 || leftX * (vy + sy) - leftY * (vx + sx) < 0) [leftX, leftY] = [vx + sx, vy + sy]
      if (far < 0 || rightX * (vy - sy) - rightY * (vx - sx) > 0) [rightX, rightY] = [vx - sx, vy - sy]
      far = Math.max(far, length)
    }
    ;[lastX, lastY] = [px, py]
  }
  if (going && far > 0) out.line(lastX, lastY)
  return out.data
}
