// Every reader of text meets sound texts with a mark, a NUL, half of a surrogate or a separator anywhere in them: it
// reads them or says in words of its own what is wrong. TEXTS=10000000 tries as many with each, FUZZ_SEED=7 others.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { readState, withState } from '../../web/figure/state-in-url.js'
import { numberOf, readSystem } from '../../web/widgets/own-system/read.js'
import { dice as seeded, spoiltText } from './nonsense.mjs'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const TEXTS = Number(process.env.TEXTS ?? 20_000)
const SEED = Number(process.env.FUZZ_SEED ?? 1)

/**
 * Hands spoilt texts to a reader, which answers whether it has read one.
 *
 * @param {string} who @param {string[]} sound texts that it reads
 * @param {(text: string) => boolean} read throws where the reader broke its promise
 * @param {number} [count] of texts
 */
function fuzz(who, sound, read, count = TEXTS) {
  test(`${who} reads a spoilt text, or says what is wrong with it`, (t) => {
    for (const text of sound) assert.ok(read(text), `${JSON.stringify(text)} is sound`)
    const dice = seeded(SEED)
    let [taken, refused] = [0, 0]
    for (let i = 0; i < count; i++) {
      const text = spoiltText(dice.pick(sound), dice)
      try {
        if (read(text)) taken++
        else refused++
      } catch (error) {
        throw new Error(`${who} of ${JSON.stringify(text)}: ${error}`, { cause: error })
      }
    }
    t.diagnostic(`${taken} read, ${refused} refused`)
    assert.ok(taken > count / 100 && refused > count / 100, `${taken} read and ${refused} refused`)
  })
}

/** Whether `read` answers; what it throws must say where the fault of the text is. @param {() => any} read */
function answers(read) {
  try {
    read().free()
    return true
  } catch (error) {
    const { name, code, line, message } = error
    if (name !== 'EstimateError' || code !== 'log' || !Number.isInteger(line) || message.length < 10) throw error
    return false
  }
}

const LOGS = [
  '# a log\nL,7,3,4\nO,0.5,0.1,0.02\nR,0.5,7,4.9\nO,1,0.1,0\nB,1,7,4.8,0.1\nG,1,0,0,0\n',
  '\r\nO,0,1,0\r\nO,1,1,0\r\n',
  'V,0,0.5,1\nV,1,0.5,1',
]
fuzz('RobotLog.parse', LOGS, (text) => answers(() => core.RobotLog.parse(text)))

const TABLES = [
  'time_ms,v,omega\n0,0.4,0.05\n100,0.4,0.05\n',
  '# Time [s]    v [m/s]    omega [rad/s]\n0.05 \t 2.0 \t 0.1\n0.1\t2\t0.1\n',
  '"t";"x";"y"\n0;1,5;2\n1;2;2\n',
]
fuzz('LogFiles', TABLES.slice(0, 2), (text) => {
  const files = new core.LogFiles()
  try {
    return answers(() => {
      files.add(text.slice(0, 9), text)
      // A table beside it: the two are read together.
      files.add('truth.csv', TABLES[2])
      return files.read()
    })
  } finally {
    files.free()
  }
})

const SYSTEMS = [
  '{"F": [[1, 0.5], [0, 1]], "G": [[0], [0.5]], "H": [[1, 0]], "V": [[0.01, 0], [0, 0.01]], "W": [[0.5]]}',
  'F = [1 0.5; 0 1];\nG = [0; .5] % the input\nH = [1, 0]\nV = [0.2 0.05\n 0.05 0.1]\nW = 1/2',
  'import numpy as np\nF = np.array([[1., 1/2], [0, 1]])\nH = np.array([[1, 0]])\nV = 1e-2 * np.eye(2)\nW = 1',
  "F =\n\n   1.0e-02 *\n\n    100    50\n      0   100\n\nH = [1;0]'; V = diag([0.01 0.01]); W = .5;\n",
]
fuzz('A system', SYSTEMS, (text) => {
  const { ok, fault, system } = /** @type {any} */ (readSystem(text))
  if (!ok) {
    // What is said where no reason was found.
    assert.notEqual(fault, 'The text could not be read.')
    assert.ok(fault.length > 10)
    return false
  }
  const [n, p, m] = [system.F.length, system.H.length, system.G[0].length]
  const shapes = /** @type {Record<string, [number, number]>} */ ({
    F: [n, n],
    G: [n, m],
    H: [p, n],
    V: [n, n],
    W: [p, p],
  })
  for (const [name, [rows, columns]] of Object.entries(shapes)) {
    assert.equal(system[name].length, rows, name)
    assert.ok(system[name].every((/** @type {number[]} */ row) => row.length === columns && row.every(Number.isFinite)))
  }
  return true
})

fuzz('A number', ['0.5', '-1/3', '−2e-3', '1e300/3', ' .25 '], (text) => {
  const number = numberOf(text)
  assert.ok(!Number.isNaN(number) || !/^\s*\d+\s*$/.test(text))
  return Number.isFinite(number)
})

const PAGE = 'https://example.org/kalman/?fig-bench='
const state = new core.ObserverBench().state()
/** A link to a state is two texts, one in the other: the state's, and what the address holds of it. */
const LINKS = [PAGE + new URL(withState(PAGE, 'fig-bench', state)).searchParams.get('fig-bench')]
const opened = (/** @type {string} */ address) => {
  const read = readState(address, 'fig-bench', 'observer-bench')
  if (read === 'mangled' || read === null) return false
  try {
    core.ObserverBench.from(read).free()
    return true
  } catch (error) {
    if (error.name !== 'EstimateError') throw error
    return false
  }
}
fuzz('A link', LINKS, (address) => URL.canParse(address) && opened(address))
const NUMBERS = [JSON.stringify([state.version, state.lab, state.step, state.params])]
fuzz('The state in a link', NUMBERS, (text) => {
  const url = new URL(PAGE)
  url.searchParams.set('fig-bench', Buffer.from(text).toString('base64url'))
  return opened(url.href)
})

const PROGRAM = new core.WriteFilter().state()
const PROGRAMS = ['kalman', 'joseph', 'ekf', 'twice'].map((begin) => {
  const lab = core.WriteFilter.from({ ...PROGRAM, step: 0, params: { ...PROGRAM.params, begin } })
  const { text } = lab.frame()
  lab.free()
  return `${begin}\n${text}`
})
/** A program is read and judged when its link opens, which takes three thousandths of a second. */
const FEWER = Math.ceil(TEXTS / 40)
fuzz(
  'A link with a program',
  PROGRAMS,
  (written) => {
    const [begin, ...lines] = written.split('\n')
    const params = { ...PROGRAM.params, begin, text: lines.join('\n') }
    const link = withState('https://example.org/kalman/filter/', 'fig-filter', { ...PROGRAM, step: 2, params })
    const read = readState(link, 'fig-filter', 'write-filter')
    if (read === 'mangled' || read === null) return false
    try {
      const lab = core.WriteFilter.from(read)
      const { outcome, faults, sentences, text } = lab.frame()
      lab.free()
      const last = text.split('\n').length
      for (const { line, message } of faults) assert.ok(line >= 1 && line <= last && message.length > 10, message)
      assert.ok(sentences.length > 0 && sentences.every((/** @type {string} */ said) => said.length > 10))
      assert.ok(faults.length === 0 || outcome === 'refused')
      return faults.length === 0
    } catch (error) {
      if (error.name !== 'EstimateError') throw error
      return false
    }
  },
  FEWER,
)
