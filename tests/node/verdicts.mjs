// A suspect and a judgement of a log, as the core gives them, with what a test says of its own.

/** A delay of the positions that is sure. @param {Record<string, unknown>} given @returns {any} */
export const suspect = (given) => ({
  fault: 'clock',
  name: 'delayFix',
  sensor: null,
  sizes: [{ now: 0, value: 0.35, sigma: 0.021 }],
  gain: 20,
  excess: 15,
  standing: 'sure',
  mended: null,
  own: false,
  flat: null,
  with: null,
  landmarks: null,
  claims: null,
  times: null,
  dilution: null,
  ...given,
})

/** @param {unknown[]} suspects @param {Record<string, unknown>} [more] @returns {any} */
export const judgement = (suspects, more) => ({
  suspects,
  readings: 2067,
  rows: 1000,
  tried: [9, 9],
  against: null,
  ungated: false,
  beside: false,
  thinning: null,
  arcs: null,
  period: 0.1,
  ownDelay: 0.05,
  pace: 1.5,
  halfTurn: 0,
  noise: { nis: null, refused: null, correlated: null },
  gaps: [],
  other: false,
  ...more,
})
