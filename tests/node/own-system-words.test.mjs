import { check } from './claims.mjs'
import { claims } from './own-system-claims.mjs'

const four = (rows) => Array.from({ length: 4 }, (_, i) => Array.from({ length: 4 }, (_, j) => rows[i]?.[j] ?? 0))
/** A place and its speed, every half second. */
const CONSTANT_VELOCITY = four([
  [1, 0.5],
  [0, 1],
])

check(
  'own-system',
  {
    f: [
      CONSTANT_VELOCITY,
      four([
        [0.5, 0],
        [0, 1],
      ]),
      four([
        [1, 0],
        [0, 1 + 1e-11],
      ]),
      four([
        [1.2, 0],
        [0, 0.3],
      ]),
      four([
        [1, 1e12],
        [0, 1],
      ]),
      four([
        [1e20, 0.1],
        [0, 1],
      ]),
    ],
    h: [four([[1, 0]]), four([[0, 1]]), four([[1, 1]])],
    v: [
      four([]),
      four([
        [0.01, 0.02],
        [0.02, 0.04],
      ]),
      four([
        [0, 0],
        [0, 1],
      ]),
      four([
        [1, 0],
        [0, 1],
      ]),
    ],
    gain: ['filter', 'hand', 'placement'],
    logTolerance: [-14, -9, -1],
  },
  [0, 60],
  claims,
)

// A reading without noise, and kicks along one line: from some of them no filter that trusts the reading recovers.
check(
  'own-system',
  {
    f: [CONSTANT_VELOCITY],
    v: [0.1, 0.125, 0.15].map((place) =>
      four([
        [place * place, 0.5 * place],
        [0.5 * place, 0.25],
      ]),
    ),
    w: [four([[0]]), four([[0.5]])],
    spread: [
      [0, 0],
      [1, 0],
      [1, 1],
    ].map((spread) => [...spread, 1, 1, 1, 1, 1, 1, 1]),
    gain: ['filter', 'hand'],
  },
  [0, 60],
  claims,
)

// What one step does, and rates that are given as that.
check(
  'own-system',
  {
    f: [
      four([
        [0, 1],
        [-4, -0.4],
      ]),
      four([[0, 1]]),
      four([
        [0, 1],
        [9.81, 0],
      ]),
      CONSTANT_VELOCITY,
    ],
    h: [four([[1, 0]]), four([[0, 1]])],
    period: [0, 0.01],
    gain: ['filter', 'hand'],
  },
  [0, 60],
  claims,
)
