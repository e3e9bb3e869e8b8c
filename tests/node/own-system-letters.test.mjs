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
