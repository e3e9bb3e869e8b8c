/** A program as MATLAB. A reader’s language reads its lines as they are: nearly all of them are its own. */

import { head, identifiers, ofEachStep, remarks, source, TOLERANCE } from './frame.js'
import { helpersOf } from './helpers.js'
import { all } from './node.js'
import { printer } from './ranks.js'
import { RESERVED } from './reserved.js'

/** @typedef {import('./node.js').Node} Node */
/** @typedef {import('./ranks.js').Ranked} Ranked */

/** @type {Record<string, string>} */
const HELPERS = {
  wrap: `function angle = wrap(angle)
% An angle in (-pi, pi].
angle = angle - 2*pi*round(angle/(2*pi));
end
`,
  Symmetric: `function a = Symmetric(a)
a = (a + a')/2;
end
`,
  cholesky: `function l = cholesky(a)
% The lower triangle with l*l' = a.
l = chol(a, 'lower');
end
`,
  f: `function x = f(x, u)
% Where the robot is after a move: along its heading, then the turn.
x = [x(1) + u(1)*cos(x(3)); x(2) + u(1)*sin(x(3)); wrap(x(3) + u(2))];
end
`,
  h: `function y = h(x, l)
% Range and bearing of a landmark, the bearing from the landmark.
d = x(1:2) - l;
y = [norm(d); wrap(atan2(d(2), d(1)) - x(3))];
end
`,
}
/** @type {Record<string, string[]>} */
const NEED = { f: ['wrap'], h: ['wrap'] }

/** @param {string} one @param {number} [rank] @returns {Ranked} */
const of = (one, rank = 5) => [one, rank]
/** @param {number} from @param {number} to @param {number} last */
function slice(from, to, last) {
  if (to - from === 1) return String(to)
  return from === 0 && to === last ? ':' : `${from + 1}:${to}`
}
/** @param {number[]} ends @param {[number, number]} whole */
function place([top, bottom, left, right], [rows, columns]) {
  if (columns === 1) return `(${slice(top, bottom, rows)})`
  return `(${slice(top, bottom, rows)}, ${slice(left, right, columns)})`
}

/** @param {(name: string) => string} name @param {Set<string>} called */
export function matlabPrinter(name, called) {
  const call = (/** @type {string} */ one) => (/** @type {Node} */ it, /** @type {(part: Node) => string} */ text) => {
    called.add(one)
    return of(`${one}(${it.parts.map((part) => text(part)).join(', ')})`)
  }
  const infix =
    (/** @type {string} */ sign) =>
    (/** @type {Node} */ it, /** @type {(part: Node, least: number) => string} */ text) =>
      of(`${text(it.parts[0], 2)}${sign}${text(it.parts[1], 3)}`, 2)
  /** @type {Parameters<typeof printer<Node>>[0]} */
  const words = {
    number: (it) => of(String(it.number)),
    pi: () => of('pi'),
    name: (it) => of(name(it.name)),
    eye: (it) => of(`eye(${it.sides[0]})`),
    zeros: (it) => of(`zeros(${it.sides.join(', ')})`),
    negative: ({ parts: [a] }, text) => of(`-${text(a, 4)}`, 3),
    times: infix('*'),
    over: infix('/'),
    under: infix('\\'),
    transpose: ({ parts: [a] }, text) => of(`${text(a, 4)}'`, 4),
    power: ({ parts: [a], number }, text) => of(`${text(a, 4)}^${number < 0 ? `(${number})` : number}`, 4),
    // MATLAB takes a part of a name, not of a formula.
    part: ({ parts: [a], ends = [] }, text) => of(`${text(a, 5)}${place(ends, a.sides)}`, 4),
    row: (it, text) => of(`[${it.parts.map((part) => text(part)).join(', ')}]`),
    stack: (it, text) => {
      const rows = it.parts.map((row) => (row.word === 'row' ? row.parts : [row]))
      return of(`[${rows.map((row) => row.map((part) => text(part)).join(', ')).join('; ')}]`)
    },
    hypot: ({ parts: [a, b] }, text) => of(`norm([${text(a)}; ${text(b)}])`),
    chol: call('cholesky'),
    sym: call('Symmetric'),
  }
  for (const one of 'inv diag sqrt sin cos exp abs atan2 norm det trace wrap f h'.split(' ')) words[one] = call(one)
  return printer(words)
}

/** @param {number[][]} m */
function data(m) {
  const [rows, columns] = [m.length, m[0]?.length ?? 1]
  if (rows * columns === 0) return `zeros(${rows}, ${columns})`
  return `[${m.map((row) => row.join(', ')).join('; ')}]`
}

/**
 * Lines in which a part is always one of a name: a formula of which a part is taken gets a name of its own first.
 * @param {import('./sized.js').Line[]} lines
 */
function named(lines) {
  let count = 0
  return lines.flatMap((line) => {
    /** @type {import('./sized.js').Line[]} */
    const before = []
    /** @param {Node} it @returns {Node} */
    const of = (it) => {
      const parts = it.parts.map(of)
      if (it.word !== 'part' || parts[0].word === 'name') return { ...it, parts }
      const name = `part${(count += 1)}`
      before.push({ ...line, name, part: null, sides: parts[0].sides, value: parts[0] })
      return { ...it, parts: [{ word: 'name', name, number: 0, parts: [], sides: parts[0].sides }] }
    }
    const value = [...all(line.value)].some((it) => it.word === 'part') ? of(line.value) : line.value
    return [...before, { ...line, value }]
  })
}

/** The program’s lines, and what they call. @param {import('./frame.js').Frame} frame */
export function matlabLines(frame) {
  const { given, x, P } = frame
  const lines = named(frame.lines)
  const names = identifiers([x, P, ...given, ...lines.map((line) => line.name)], RESERVED.matlab, HELPERS)
  const name = (/** @type {string} */ one) => names.get(one) ?? one
  /** @type {Set<string>} */
  const called = new Set()
  const text = matlabPrinter(name, called)
  const body = lines.map(({ name: made, part, sides, value, lines: [from, to] }) => {
    const i = frame.lines.findIndex((line) => line.lines[0] === from && line.lines[1] === to && line.name === made)
    const { remark } = i < 0 ? { remark: '' } : source(frame, i)
    const said = i < 0 ? [] : remarks(frame, i).map((words) => `% ${words}\n`)
    const filled = `${name(made)}${part ? place(part, sides) : ''}`
    return `${said.join('')}${filled} = ${text(value)};${remark && ` % ${remark}`}\n`
  })
  return { body: body.join(''), name, called }
}

/** @param {import('./frame.js').Frame} frame */
export function matlab(frame) {
  const { given, x, P, start, constants, varying, steps } = frame
  const { body, name, called } = matlabLines(frame)
  const helpers = helpersOf(HELPERS, NEED, called).map((one) => `\n${HELPERS[one]}`)
  const inputs = [x, P, ...given].map(name).join(', ')
  const outputs = `[${name(x)}, ${name(P)}]`
  return `${head('%', frame, 'It needs no toolbox: matlab -batch filter')}
${constants.map(([one, m]) => `${name(one)} = ${data(m)};\n`).join('')}% ${ofEachStep(varying.map(name))}
steps = {
${steps.map((step) => `    ${step.map(data).join(', ')}\n`).join('')}};
${name(x)} = ${data(start[0])};
${name(P)} = ${data(start[1])};
for k = 1:size(steps, 1)
${varying.map((one, i) => `    ${name(one)} = steps{k, ${i + 1}};\n`).join('')}    ${outputs} = step(${inputs});
    expected = [steps{k, ${varying.length + 1}}, steps{k, ${varying.length + 2}}];
    off = max([max(abs(${name(x)} - expected(:, 1)))/max(1, max(abs(expected(:, 1)))), ...
        max(max(abs(${name(P)} - expected(:, 2:end))))/max(1, max(max(abs(expected(:, 2:end)))))]);
    if ~(off <= ${TOLERANCE})
        error('Step %d is off by %g.', k, off);
    end
end
fprintf('Steps that are right: %d.\\n', size(steps, 1));

function ${outputs} = step(${inputs})
% The estimate and its covariance behind one step.
${body}end
${helpers.join('')}`
}
