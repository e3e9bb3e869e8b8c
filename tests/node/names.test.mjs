// A name hides no line that its figure tells it of: one inside an ellipse lies on no point of the outline.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { followed } from '../../web/draw/camera.js'
import { along, drawLabels, widthOf } from '../../web/draw/labels.js'
import { ellipsePoints, plane } from '../../web/draw/plot.js'
import { drawMap, ellipses, FOOT, seen } from '../../web/widgets/loop-closure/map.js'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

const box = { left: 0, top: 0, right: 600, bottom: 400 }
const paper = plane(box, [-3, 3], [-2, 2])

/** Whether the name of the middle lies on a point. */
function hides(points, taken) {
  /** @type {boolean | null} */
  let on = null
  /** @type {any} */
  const pen = {
    mark() {},
    text(_, { x, y, 'text-anchor': anchor }, words) {
      const width = widthOf(words)
      const left = anchor === 'start' ? x : anchor === 'end' ? x - width : x - width / 2
      on = points.some(([px, py]) => px > left && px < left + width && py > y - 9 && py < y)
    },
  }
  drawLabels(pen, box, [{ key: 'name', words: 'prediction', at: [300, 200], gap: 8 }], taken)
  return on
}

test('the name of an ellipse’s middle lies on no point of its outline, whatever its size and lean', () => {
  /** @type {any[]} */
  const blind = []
  for (const size of [0.1, 0.3, 0.6, 1, 1.5])
    for (const angle of [0, 0.7, 1.57, 2.4]) {
      const points = ellipsePoints({ semiMajor: size, semiMinor: size / 2, angle }, [0, 0], paper)
      assert.equal(hides(points, along(points)), false, `${size}, ${angle}`)
      blind.push(hides(points, []))
    }
  assert.ok(blind.includes(true), 'a name that is not told of the outline lies on one of them')
})

test('Close the loop: when the map is tugged, the names of landmarks lie on none of its ellipses', () => {
  const [width, height] = [560, 380]
  const lab = new core.LoopClosure({})
  lab.run(111)
  for (let step = 112; step <= 114; step++) {
    lab.run(1)
    const frame = lab.frame()
    /** @type {any} */
    const view = { memory: {}, elapsed: 0 }
    /** @type {{ words: string, left: number, right: number, y: number }[]} */
    const names = []
    /** @type {any} */
    const pen = {
      mark() {},
      draw: (act) => act(pen),
      window: (_, __, act) => act(pen),
      group: (_, __, act) => act(pen),
      text(key, { x, y, 'text-anchor': anchor }, words) {
        if (!/^name\d/.test(key)) return
        const wide = widthOf(words)
        const left = anchor === 'start' ? x : anchor === 'end' ? x - wide : x - wide / 2
        names.push({ words, left, right: left + wide, y })
      },
    }
    drawMap(/** @type {any} */ ({ pen, width, height }), frame, view)
    const box = { left: 0, top: 0, right: width, bottom: height - FOOT }
    const { plane } = followed(view, box, (axis) => seen(frame, axis))
    const points = ellipses(frame).flatMap(({ ellipse, at }) => ellipsePoints(ellipse, at, plane))
    assert.ok(names.length > 8 && points.length > 100, `${names.length} names, ${points.length} points`)
    const hiding = names.filter(({ left, right, y }) =>
      points.some(([px, py]) => px > left && px < right && py > y - 9 && py < y),
    )
    assert.deepEqual(
      hiding.map(({ words }) => words),
      [],
      `step ${step}`,
    )
  }
  lab.free()
})
