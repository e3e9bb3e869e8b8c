// The camera of a map keeps in sight what has to be seen, also while that grows by little at a time.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { followed } from '../../web/draw/camera.js'
import { seen } from '../../web/widgets/loop-closure/map.js'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const box = (right, bottom) => ({ left: 0, top: 0, right, bottom })
/** As wide as its map, wider and narrower. */
const BOXES = [box(560, 360), box(560, 300), box(480, 400)]
/** The radius of a mark, pixels. */
const MARK = 5

/** Where a point lies on the panel when the camera has arrived. */
function arrived(view, values, box) {
  for (;;) {
    const { plane, moving } = followed(view, box, values)
    if (!moving) return plane
  }
}

test('a value that wanders out by small steps is never beyond the edge', () => {
  const view = { memory: {}, elapsed: 16 }
  for (let far = 1; far < 2; far += 0.01) {
    const { x } = arrived(view, () => [[-1, far]], BOXES[0])
    assert.ok(x(far) <= BOXES[0].right - MARK && x(-1) >= MARK, `${far}: ${x(far)}`)
  }
})

test('Close the loop keeps every sighting in sight, from the start to the end of the lap', () => {
  for (const box of BOXES) {
    const lab = new core.LoopClosure({})
    const view = { memory: {}, elapsed: 16 }
    for (let step = 0; step < 130; step += 1) {
      const frame = lab.frame()
      const { x, y } = arrived(view, (axis) => seen(frame, axis), box)
      for (const { at } of frame.sightings) {
        const [across, down] = [x(at[0]), y(at[1])]
        assert.ok(
          across >= MARK && across <= box.right - MARK && down >= MARK && down <= box.bottom - MARK,
          `${box.right} × ${box.bottom}, step ${step}: ${across}, ${down}`,
        )
      }
      lab.run(1)
    }
    assert.ok(lab.frame().step === 130)
    lab.free()
  }
})

test('the map of another run is fitted anew, and not that of the same run or of one still computed', () => {
  /** @type {any} */
  const view = { memory: {}, elapsed: 16 }
  const at = (far, frame) => {
    for (;;) {
      const { plane, moving } = followed(view, BOXES[0], () => [[-1, far]], frame)
      if (!moving) return plane.x.domain[1] - plane.x.domain[0]
    }
  }
  const [first, second] = [
    { params: { bias: 1 }, tracks: {} },
    { params: { bias: 2 }, tracks: {} },
  ]
  const wide = at(2, first)
  assert.equal(at(1, { ...first, tracks: {} }), wide, 'a step of the same run')
  assert.equal(at(1, { params: second.params, tracks: view.memory.mapOf.tracks }), wide, 'asked for, and not there yet')
  assert.ok(at(1, second) < 0.8 * wide, 'another run')
  assert.deepEqual(Object.keys(view.memory).sort(), ['map', 'mapOf'], 'what the plots remember is theirs')
})
