/** What the two bells say: how the opinions weigh, and where the beam balances. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').TwoBellsFrame} Frame */

/** @param {Frame} frame */
export function verdict({ likely, weights: [expected, read], arms, params }) {
  const [prediction, reading] = [params.expected, params.reading].map((one) => fixed(one))
  const at = `{y}^{∗} = ${fixed(likely)} m/s`
  const times = expected / read
  if (Math.abs(times - 1) < 0.005)
    return `Both opinions weigh the same: the beam balances half way from ${prediction} to ${reading}, at ${at}.`
  const [heavy, light] = times > 1 ? ['prediction', 'reading'] : ['reading', 'prediction']
  const ways = arms.map((arm) => fixed(Math.abs(arm)))
  return (
    `The ${heavy} weighs ${fixed(Math.max(times, 1 / times))} times as much as the ${light}. The beam balances ` +
    `at ${at}, ${ways[0]} m/s from the prediction of ${prediction} and ${ways[1]} m/s from the reading of ${reading}.`
  )
}

/** @param {Frame} frame */
export function describe({ params, likely, variance }) {
  const bell = (/** @type {number} */ mean, /** @type {number} */ of) =>
    `${fixed(mean)} metres a second with a standard deviation of ${fixed(Math.sqrt(of))}`
  return {
    bells:
      `Two bells over the velocity: the prediction expects ${bell(params.expected, params.expectedVariance)}, ` +
      `the sensor reads ${bell(params.reading, params.noise)}. Their product is a bell ` +
      `about ${bell(likely, variance)}; ` +
      'there a beam with the two weights balances.',
  }
}
