import { check, number } from './claims.mjs'
import { BUGS } from '../../web/widgets/bug-museum/words.js'
import { GROUPS } from '../../web/widgets/write-filter/programs.js'

const BEGINS = GROUPS.flatMap(({ programs }) => programs.map(([begin]) => begin))
const BEGUN = ['x = F x + G u', "P = F P F' + V", "R = P H' / (H P H' + W)", 'x = x + R (y - H x)']
const OWN = [
  null,
  ...BEGUN.map((_, i) => BEGUN.slice(0, i + 1).join('\n')),
  "x = F x + G u\nP = F P F' + V + q\ny = S",
  'x = 1e9 F x\nP = V',
  'P = inv(0 P)\nx = F x',
]
/** Whether no line is marked, and each of these letters has its line or is told to lack one. */
const lacking = ({ line, sentences }, letters) =>
  line === null && sentences[0].includes(`${letters} by the reading yet`)
const named = (bug) => BUGS[bug].name

check('write-filter', { begin: BEGINS, text: OWN, seed: [1, 7], notation: ['choset', 'thrun'] }, [0, 1, 60], () => [
  [
    /^Nothing is written yet\.$/,
    ({ made, faults, outcome }) => made.length === 0 && faults.length === 1 && outcome === 'refused',
  ],
  [/^A step predicts the estimate, and a reading corrects it\.$/, ({ made }) => made.length === 0],
  [
    /^No filter yet: (one|\d+) faults?, the first in line (\d+)\.$/,
    ({ faults }, count, line) =>
      (count === 'one' ? 1 : number(count)) === faults.length && number(line) === faults[0].line,
  ],
  [
    /^No filter yet: line (\d+) has no value\.$/,
    ({ outcome, faults, line }, at) => outcome === 'refused' && faults.length === 0 && number(at) === line,
  ],
  [
    /^No filter yet: no line makes (\w+)(?:, and none (\w+))?\.$/,
    ({ made, faults, line }, ...names) =>
      faults.length === 1 && line === null && names.every((name) => !made.includes(name)),
  ],
  [
    /^Not finished: no line corrects (.+) by the reading yet\.$/,
    (frame, letters) => frame.outcome === 'unfinished' && lacking(frame, letters),
  ],
  [/^The museum’s bug “(.+)”\.$/, ({ outcome, bug }, name) => outcome === 'bug' && named(bug) === name],
  [/^See line (\d+)\.$/, ({ outcome, line }, at) => ['bug', 'wrong'].includes(outcome) && number(at) === line],
  [/^A right filter\.$/, ({ outcome, breaks }) => outcome === 'right' && !breaks],
  [
    /^A right filter, whose digits break where nothing is known\.$/,
    ({ outcome, breaks }) => outcome === 'right' && breaks,
  ],
  [
    /^Its P is not quite symmetric\.$/,
    ({ outcome, sentences }) =>
      outcome === 'right' && sentences.some((said) => said.includes('is not symmetric in its last digits')),
  ],
  [
    /^No Kalman filter: an observer with a fixed gain\.$/,
    ({ outcome, observer }) => outcome === 'wrong' && observer !== null,
  ],
  [/^Not a right filter\.$/, ({ outcome, observer }) => outcome === 'wrong' && observer === null],
  [
    /^Find the line at fault, and change it\.$/,
    ({ outcome, line, params: { begin, text } }) =>
      outcome === 'wrong' && line !== null && text === null && begin.startsWith('mend-'),
  ],
  [/^Its run ends early\.$/, ({ outcome, stopped }) => outcome === 'wrong' && stopped !== null],
])
