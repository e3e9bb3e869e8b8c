// What the cloud says of the error that is touched, and of all of them, is true of its frames.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { check, estimate, pattern, prints, widget } from './claims.mjs'

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

test('without a lean the two variances stay, and leant the other way the covariance is the opposite', async () => {
  const spec = await widget('error-cloud')
  const open = (params) => estimate.ErrorCloud.from({ version: 1, lab: spec.name, step: 0, params })
  const after = (params, name) => {
    const lab = open(params)
    const changed = { ...lab.frame().params, ...spec.tries.find((one) => one.name === name).change(lab.frame(), lab) }
    const { P } = open(changed).frame()
    return { changed, P, before: lab.frame().P }
  }
  const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a}, ${b}`)
  for (const params of [{}, { angle: 2.4 }, { angle: -1.1, semiMajor: 0.4 }]) {
    const { P, before } = after(params, 'upright')
    for (const [a, b] of [
      [P[0][0], before[0][0]],
      [P[1][1], before[1][1]],
      [P[0][1], 0],
    ])
      near(a, b)
    near(after(params, 'other').P[0][1], -before[0][1])
  }
  // From upright it is the usual ellipse that leans the other way.
  const usual = open({}).frame().P
  const { P } = after(after({}, 'upright').changed, 'other')
  for (const [i, j, sign] of [
    [0, 0, 1],
    [1, 1, 1],
    [0, 1, -1],
  ])
    near(P[i][j], sign * usual[i][j])
})
