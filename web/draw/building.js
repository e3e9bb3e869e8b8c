/** The Apartment from above, as the maps of the figures draw it: rooms, walls and robots. */

import { dot, meaning, pointsPath } from './plot.js'

/** @typedef {import('./pen.js').Pen} Pen */
/** @typedef {import('./plot.js').Plane} Plane */

const NOSE = 17

/** @param {Pen} pen @param {Plane} plane @param {import('estimate-wasm').World} world */
export function drawBuilding(pen, plane, { rooms, walls }) {
  const { x, y } = plane
  for (const room of rooms) {
    const [left, top] = [x(room.x), y(room.y + room.height)]
    pen.mark('rect', `room${room.name}`, {
      class: 'room',
      x: left,
      y: top,
      width: x(room.x + room.width) - left,
      height: y(room.y) - top,
    })
  }
  pen.mark('path', 'walls', {
    class: 'wall',
    'stroke-opacity': 0.4,
    d: walls
      .map(([x1, y1, x2, y2]) =>
        pointsPath(plane, [
          [x1, y1],
          [x2, y2],
        ]),
      )
      .join(''),
  })
}

/**
 * A robot with its heading.
 * @param {Pen} pen
 * @param {string} key
 * @param {Plane} plane
 * @param {number[]} pose
 * @param {string} shape
 * @param {import('./plot.js').Kin} kin
 */
export function drawRobot(pen, key, plane, [px, py, heading], shape, kin) {
  const [x, y] = [plane.x(px), plane.y(py)]
  pen.mark('line', `${key}-nose`, {
    ...meaning('line', kin),
    x1: x,
    y1: y,
    x2: x + NOSE * Math.cos(heading),
    y2: y - NOSE * Math.sin(heading),
  })
  dot(pen, `${key}-body`, plane, [px, py], { ...meaning(shape, kin), r: 6.5 })
}
