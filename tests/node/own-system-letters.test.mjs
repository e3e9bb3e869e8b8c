// Q and R of a pasted system: which of them is the noise of a step is told by sizes, by letters or by the reader.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { motionIn, wordsOfNoises } from '../../web/widgets/own-system/letters.js'
import { readSystem } from '../../web/widgets/own-system/read.js'

test('where the sizes do not tell, Q and R mean what the reader’s letters have them mean, and it is said', () => {
  const text = 'A=[1 1;0 1]; C=[1 0;0 1]; R=[4 0;0 9]; Q=[0.1 0;0 0.2]'
  for (const [notation, V, words] of /** @type {[string, number, string][]} */ ([
    ['thrun', 4, 'R as the noise of a step and Q as the noise of a reading, as in Thrun’s letters; '],
    ['common', 0.1, 'Q as the noise of a step and R as the noise of a reading, as is common; in Thrun’s letters '],
    ['choset', 0.1, 'Q as the noise of a step and R as the noise of a reading, as is common; in Thrun’s letters '],
  ])) {
    const { system, as, noises } = /** @type {any} */ (readSystem(text, motionIn(notation)))
    assert.deepEqual(
      [notation, system.V[0][0], system.W[0][0], noises.told],
      [notation, V, V === 4 ? 0.1 : 4, 'letters'],
    )
    assert.equal(as, `A, C, ${V === 4 ? 'R, Q' : 'Q, R'} read as F, H, V, W`)
    assert.ok(wordsOfNoises(noises).startsWith(words), wordsOfNoises(noises))
    assert.match(wordsOfNoises(noises), /the other way round, and their sizes fit both$/)
  }
  // Where they tell, no letters turn them, and where one noise has a letter of its own, nothing is open.
  for (const motion of /** @type {const} */ (['Q', 'R'])) {
    const told = (/** @type {string} */ text) => {
      const { system, noises, fault } = /** @type {any} */ (readSystem(`F = [1 1; 0 1]; H = [1 0]; ${text}`, motion))
      return [system?.V[0][0] ?? fault, wordsOfNoises(noises, system?.continuous)]
    }
    const [q, r] = ['Q as the noise of a step and R', 'R as the noise of a step and Q']
    const [one, two] = ['Q = [2 0; 0 2]; R = 3', 'R = [2 0; 0 2]; Q = 3']
    assert.deepEqual(told(one), [2, `${q} as the noise of a reading, as their sizes tell`])
    assert.deepEqual(told(two), [2, `${r} as the noise of a reading, as their sizes tell`])
    assert.deepEqual(told('V = eye(2); R = 3'), [1, 'R as the noise of a reading'])
    assert.deepEqual(told('Q = eye(2); W = 3'), [1, 'Q as the noise of a step'])
    assert.match(told(`${one}; T = 1; c2d(sys, T)`)[1], /^Q as the noise of a second and R as the noise of a reading/)
    assert.deepEqual(told('V = eye(2); W = 3')[1], '')
  }
  assert.equal(
    /** @type {any} */ (readSystem('A = [1 1; 0 1]; C = eye(2); Q = eye(2)')).fault,
    'R, the noise of a reading, is missing.',
  )
  const missing = readSystem('A = [1 1; 0 1]; C = eye(2); Q = eye(2)', 'R')
  assert.equal(!missing.ok && missing.fault, 'R, the noise of the motion, is missing.')
  const both = readSystem('A = [1 1; 0 1]; C = eye(2)', 'R')
  assert.equal(!both.ok && both.fault, 'R, the noise of the motion, is missing.')
})

test('matrices that are written in the call of a system are read, and what is not read there is named', () => {
  const [A, noises] = ['A = [0 1; -4 -0.4]\n', '\nQ = eye(2)\nR = 1\nT = 0.1']
  const whole = /** @type {any} */ (readSystem(`${A}B = [0; 1]\nC = [1 0]${noises}\nc2d(ss(A, B, C, 0), T)`))
  for (const text of [
    `${A}C = [1 0]\nsys = ss(A, [0; 1], C, 0)${noises}`,
    `sys = ss([0 1; -4 -0.4], [0; 1], [1 0], 0)${noises}`,
    `${A}in = [0; 1]\nout = [1 0]\nsys = ss(A, in, out, 0)${noises}`,
    `a = [0 1; -4 -0.4]\nsys = ss(a, [0; 1], [1 0], 0)${noises}`,
    `d = c2d(ss([0 1; -4 -0.4], [0; 1], [1 0], 0), 0.1)${noises.replace('T = 0.1', '')}`,
    `${A}d = signal.cont2discrete((A, [[0], [1]], [[1, 0]], 0), dt=0.1)${noises.replace('T = 0.1', '')}`,
    `d = signal.StateSpace([[0, 1], [-4, -0.4]], [[0], [1]], [[1, 0]], 0).to_discrete(0.1)${noises.slice(0, -8)}`,
    `${A}sys = ss(A, [0; 1], ...\n [1 0], 0)${noises}`,
  ]) {
    const { system, unused, fault } = /** @type {any} */ (readSystem(text))
    assert.deepEqual([text, system, unused], [text, whole.system, []], fault)
  }
  const read = (/** @type {string} */ text) => /** @type {any} */ (readSystem(text))
  const other = read(`${A}B = [0; 1]\nC = [1 0]\nsys = ss(A, [0; 2], C, 0)${noises}`)
  assert.deepEqual([other.system.G, other.unused], [[[0], [1]], ['B of the call']])
  assert.deepEqual(read(`${A}C = [1 0]\nsys = ss(A, Bc, C, 0)${noises}`).unused, ['Bc'])
  assert.deepEqual(read(`${A}C = [1 0]\nsys = ss(A, [], C, [])${noises}`).system.G, [[], []])
  for (const [call, line, fault] of /** @type {[string, number, RegExp][]} */ ([
    ['ss(A, [0; 1], C, 1)', 3, /^D is not 0/],
    ['ss(A, [0; q], C, 0)', 3, /^B, row 2, column 1: “q” is not a number\.$/],
    ['ss(A, [0; 1; 2], C, 0)', 3, /^B is 3 × 1; with A 2 × 2 it needs 2 rows\. Give B another name/],
  ])) {
    const found = read(`${A}C = [1 0]\nsys = ${call}${noises}`)
    assert.deepEqual([call, found.ok, found.line], [call, false, line], found.fault)
    assert.match(found.fault, fault)
  }
})
