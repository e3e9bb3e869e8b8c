// What the cloud says of the error that is touched, and of all of them, is true of its frames.
import { check, pattern, prints } from './claims.mjs'

const products = (/** @type {{ dots: number[][] }} */ { dots }) =>
  dots.map(([position, velocity]) => position * velocity)
const sum = (/** @type {number[]} */ values) => values.reduce((all, value) => all + value, 0)
const mean = (/** @type {{ dots: number[][] }} */ frame, /** @type {(product: number) => boolean} */ which) =>
  sum(products(frame).filter(which)) / frame.dots.length

check(
  'error-cloud',
  {
    semiMajor: [0.3, 1.7230432137127605, 2],
    semiMinor: [0.3, 0.9116589735473306],
    angle: [0, 0.8795089160498338, Math.PI / 2, 2.3],
    dot: [0, 40, 185, 199],
  },
  [0],
  () => [
    [
      pattern(
        /^The product of the error you touch is \+?(\S+) m²\/s(, of an error at the edge of the drawing or beyond)?, /,
        /and a two-hundredth of it, \+?(\S+), goes into P12\.$/,
      ),
      (frame, product, beyond, share) => {
        const [position, velocity] = frame.dots[frame.params.dot]
        return (
          Boolean(beyond) === (Math.abs(velocity) >= 3.4 || Math.abs(position) >= 4.5) &&
          prints(product, position * velocity) &&
          prints(share, (position * velocity) / frame.dots.length)
        )
      },
    ],
    [
      pattern(
        /^The (\d+) dots with a positive product add ([\d.]+), /,
        /the other (\d+) take away ([\d.]+): P12 = (\S+)\.$/,
      ),
      (frame, count, adds, others, takes, all) =>
        Number(count) === products(frame).filter((product) => product > 0).length &&
        Number(others) === frame.dots.length - Number(count) &&
        prints(
          adds,
          mean(frame, (product) => product > 0),
        ) &&
        prints(takes, -mean(frame, (product) => product <= 0)) &&
        prints(
          all,
          mean(frame, () => true),
        ),
    ],
  ],
)
