// The class Program: a filter as lines of formulas, beside kalmanStep and the localizer, and what is said of faults.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { CHAPTER, ROBOT } from './program-exports.mjs'
import { belief, rail } from './rail.mjs'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const { Program } = core

/** @param {any} a @param {any} b */
function near(a, b) {
  const [found, wanted] = [a, b].map((value) => [value].flat(2))
  assert.equal(found.length, wanted.length)
  found.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 1e-12, `${found} and ${wanted}`))
}

const thrown = (act) => {
  try {
    act()
  } catch (error) {
    return `${error.name} ${error.code} ${error.argument}: ${error.message}`
  }
  return 'nothing was thrown'
}

test('the chapter’s lines are a kalmanStep', () => {
  const program = new Program(CHAPTER)
  assert.deepEqual(program.faults, [])
  let ours = belief
  let theirs = belief
  for (const y of [4.2, 6.4, 8.1]) {
    const step = program.step(rail, theirs, [0.1], [y])
    const exact = core.kalmanStep(rail, ours, [0.1], [y])
    near(step.x, exact.x)
    near(step.P, exact.P)
    near(step.innovation, exact.innovation)
    near(step.S, exact.S)
    near(step.R, exact.R)
    ;[ours, theirs] = [exact, step]
  }
  const lines = program.lines(rail, belief, [0.1], [4.2])
  assert.deepEqual(
    lines.map(({ line, name }) => [line, name]),
    [
      [1, 'x'],
      [2, 'P'],
      [3, 'nu'],
      [4, 'S'],
      [5, 'R'],
      [6, 'x'],
      [7, 'P'],
    ],
  )
  assert.deepEqual(lines[5].value.flat(), program.step(rail, belief, [0.1], [4.2]).x)
})

test('the robot’s lines are a step of the localizer', () => {
  const start = {
    x: [0.2, -0.1, 3.1],
    P: [
      [0.02, 0.001, 0],
      [0.001, 0.03, 0.002],
      [0, 0.002, 0.01],
    ],
  }
  const V = [
    [4e-4, 0, 0],
    [0, 4e-4, 0],
    [0, 0, 9e-4],
  ]
  const W = [
    [0.01, 0],
    [0, 9e-4],
  ]
  const localizer = new core.EkfLocalizer(start, [{ id: 1, x: 2, y: 1 }], { W, gate: null })
  localizer.predict([0.3, 0.1], V)
  localizer.update({ range: 2.5, bearing: -2.6 + 2 * Math.PI - 2 * Math.PI, landmark: 1 })
  const program = new Program(ROBOT, { world: 'robot' })
  const step = program.step({ V, W, landmark: [2, 1] }, start, [0.3, 0.1], [2.5, -2.6])
  near(step.x, localizer.belief().x)
  near(step.P, localizer.belief().P)
})

test('faults come all at once, with their places', () => {
  const { faults } = new Program('x = F x + H\nP = F P F + \nR = K')
  assert.deepEqual(
    faults.map(({ line, column }) => [line, column]),
    [
      [1, 5],
      [2, 13],
      [3, 5],
    ],
  )
  assert.equal(faults[0].message, 'F x is n×1 and H is p×n: both sides of a sum have one size.')
  assert.match(faults[2].message, /K is the gain in Thrun’s letters/)
  assert.deepEqual(new Program('mu = A mu\nSigma = A Sigma Aᵀ + R', { notation: 'thrun' }).faults, [])
})

test('a judgement names what is wrong', () => {
  const { outcome, sentences } = new Program(CHAPTER).judge()
  assert.equal(outcome, 'right')
  assert.match(sentences[0], /^Right: x and P are those of a right filter in all 12 cases/)
  const transposed = new Program(CHAPTER.replace('F P Fᵀ', 'Fᵀ P F')).judge()
  assert.deepEqual([transposed.outcome, transposed.bug, transposed.line], ['bug', 'transposed', 2])
  const wrong = new Program(CHAPTER.replace('P − R H P', 'P')).judge()
  assert.deepEqual([wrong.outcome, wrong.bug, wrong.line], ['wrong', null, 7])
  assert.equal(new Program('x = ').judge().outcome, 'refused')
})

test('bad input is refused by name', () => {
  assert.match(
    thrown(() => new Program(7)),
    /EstimateError type text: .* must be a text/,
  )
  assert.match(
    thrown(() => new Program('a'.repeat(20_001))),
    /limit text/,
  )
  assert.match(
    thrown(() => new Program('', { notation: 'greek' })),
    /type options.notation/,
  )
  assert.match(
    thrown(() => new Program('', { letters: 'thrun' })),
    /type options.letters/,
  )
  const program = new Program(CHAPTER)
  const step = (...given) => thrown(() => program.step(...given))
  assert.match(step(rail, belief, [0], [NaN]), /not-finite y/)
  assert.match(step(rail, belief, [0, 0], [1]), /shape u/)
  assert.match(step(rail, { ...belief, P: [[1]] }, [0], [1]), /shape belief/)
  assert.match(step({ V: rail.V }, belief, [0], [1]), /type system/)
  const empty = new Program('x = ')
  assert.match(
    thrown(() => empty.step(rail, belief, [0], [1])),
    /shape program: .*line 1: Here a formula/,
  )
  const singular = new Program('x = x\nP = P\nA = inv(0 P)')
  assert.match(
    thrown(() => singular.step(rail, belief, [0], [1])),
    /not-positive-semidefinite program: .*line 3/,
  )
  const robot = new Program(ROBOT, { world: 'robot' })
  assert.match(
    thrown(() => robot.step(rail, belief, [0], [1])),
    /type system.F/,
  )
})
