// The frames of the car's log as Node computes them, for another engine to answer with the same bits.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { root } from './places.mjs'

const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

/** What is set, for each of the frames: all fixes; a delay and what is learned, gated; a delay and a tunnel. */
const SETTINGS = [
  { fixes: 'all' },
  { fixes: 'second', delay: 0.5, learn: true, gate: true },
  { delay: 0.5, learn: false, gate: false, tunnel: true },
]
/** @type {{ version: 1, lab: string, step: number, params: object }[]} */
export const carStates = SETTINGS.map((params) => ({ version: 1, lab: 'car-log', step: 0, params }))

/** The frame of each state, as JSON holds it. */
export function carFrames() {
  const log = core.CarLog.parse(readFileSync(path.join(root, 'content/logs/car.csv'), 'utf8'))
  return carStates.map((state) => JSON.parse(JSON.stringify(core.CarLog.from(log, state).frame())))
}

/** In the page: the same frames from the figure's own lab, as one text. @param {any} states */
export const framesThere = (states) => {
  const Lab = /** @type {any} */ (document.querySelector('car-log')).figure.lab.constructor
  return JSON.stringify(states.map((/** @type {any} */ state) => Lab.from(state).frame()))
}
