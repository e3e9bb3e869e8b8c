// What the two carts say of their readings is true of their frames.
import { check, pattern, prints } from './claims.mjs'

const farthest = (/** @type {{ readings: number[][] }} */ { readings: [first, second] }) =>
  Math.max(...first.map((value, k) => Math.abs(second[k] - value)))

/** Whether “stand 1.00 m apart and differ by 0.50 m/s in speed” says how the carts start. */
function starts(words, { start: [first, second] }) {
  const [position, speed] = [second[0] - first[0], second[1] - first[1]].map(Math.abs)
  const [, metres] = /stand ([\d.]+) m apart/.exec(words) ?? []
  const [, faster] = /differ by ([\d.]+) m\/s in speed/.exec(words) ?? []
  return (metres ? prints(metres, position) : position === 0) && (faster ? prints(faster, speed) : speed === 0)
}

check(
  'two-carts',
  { position: [-2, -0.05, 0, 1, 1.35], speed: [-1, -0.05, 0, 0.5, 1], sensor: ['velocity', 'position'] },
  [0, 3],
  () => [
    [
      /^The carts start alike: drag the second one away\.$/,
      (frame) => frame.start[1].every((value) => value === 0) && farthest(frame) === 0,
    ],
    [
      pattern(
        /^The carts (.+), and all (\d+) readings are the same: /,
        /no filter can tell from them which cart it rides on\.$/,
      ),
      (frame, words, all) =>
        starts(words, frame) && Number(all) === frame.readings[1].length && farthest(frame) === 0 && frame.rank === 1,
    ],
    [
      /^The carts (.+), and the readings differ by up to ([\d.]+) (m\/s|m): they tell the carts apart\.$/,
      (frame, words, most, unit) =>
        starts(words, frame) &&
        prints(most, farthest(frame)) &&
        farthest(frame) > 0.01 &&
        (unit === 'm') === (frame.params.sensor === 'position'),
    ],
    [
      /^They show the speed, and not the metres between\.$/,
      ({ rank, unseen, readings: [first, second], start }) =>
        rank === 1 && unseen[0] === 1 && first.every((value, k) => Math.abs(second[k] - value - start[1][1]) < 1e-12),
    ],
  ],
)
