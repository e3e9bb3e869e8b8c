// The figure in which a reader writes a filter, beside its words: exercises are solved by their answers and by nothing
// before, bugs typed by hand are named, worlds are counted in chunks, and what the browser keeps comes back.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { keyOf, unmet } from '../../web/page/answer.js'
import { faultOf, keep, last, textOf } from '../../web/widgets/write-filter/kept.js'
import { GROUPS, isBegin, stepsOf } from '../../web/widgets/write-filter/programs.js'
import { reasons } from '../../web/widgets/write-filter/words.js'
import { Counting, worlds } from '../../web/widgets/write-filter/worlds.js'
import { Server } from '../../web/widgets/write-filter/server.js'
import { estimate, widget } from './claims.mjs'

const { parseHTML } = createRequire(new URL('../../web/package.json', import.meta.url))('linkedom')
const page = parseHTML(readFileSync(new URL('../../dist/kalman/filter/index.html', import.meta.url), 'utf8')).document
const BEGINS = GROUPS.flatMap(({ programs }) => programs.map(([begin]) => begin))

/** @param {Record<string, unknown>} params @param {number} [step] */
function frameOf(params, step = 0) {
  const lab = estimate.WriteFilter.from({ version: 1, lab: 'write-filter', step, params })
  const frame = lab.frame()
  lab.free()
  return frame
}

test('the list of programs is the lab’s', () => {
  const [{ words }] = estimate.WriteFilter.parameters()
  assert.deepEqual([...BEGINS].sort(), [...words].sort())
  for (const { world, programs } of GROUPS)
    for (const [begin] of programs) assert.equal(frameOf({ begin }).world, world, begin)
  assert.ok(isBegin('kalman') && !isBegin('toString') && !isBegin(null))
  assert.deepEqual([stepsOf('kalman'), stepsOf('ekf')], [60, 240])
})

test('each exercise is solved by its answer, and not by the program that it begins with', () => {
  const exercises = [...page.querySelectorAll('.exercise')]
  assert.ok(exercises.length >= 8)
  for (const exercise of exercises) {
    const begin = exercise.id.replace('ex-filter-', '')
    const link = [...exercise.querySelectorAll('a')].find((a) => a.getAttribute('href')?.includes('?program='))
    assert.equal(link?.getAttribute('href'), `?program=${begin}#fig-filter`, exercise.id)
    const key = keyOf(exercise.querySelector('.quiz'))
    const text = exercise.querySelector('pre').textContent.trim()
    assert.deepEqual(unmet(key, frameOf({ begin, text })), [], `${exercise.id}: ${frameOf({ begin, text }).sentences}`)
    for (const other of BEGINS)
      assert.notDeepEqual(
        unmet(key, frameOf({ begin: other })),
        [],
        `${exercise.id} is solved by ${other} as it begins`,
      )
  }
})

/** What an exercise asks for and a program does not have. */
function asked(/** @type {string} */ begin, /** @type {string} */ text) {
  const form = page.querySelector(`#ex-filter-${begin} .quiz`)
  const frame = frameOf({ begin, text })
  assert.equal(frame.outcome, 'right', `${text}\n${frame.sentences}`)
  const { conditions = [] } = keyOf(form)
  return unmet(keyOf(form), frame).map((i) => conditions[i].path)
}

test('a gain by another name is one, and so is a division by a matrix where numbers are asked for', () => {
  const after = (...lines) => ['x = F x + G u', "P = F P F' + V", ...lines].join('\n')
  const gain = after("K = P H'/(H P H' + W)", 'x = x + K (y - H x)', 'P = P - K H P')
  assert.deepEqual(asked('information', gain), ['namesGain'])
  const inside = after("x = x + P H'/(H P H' + W) (y - H x)", "P = inv(inv(P) + H' inv(W) H)")
  assert.deepEqual(asked('information', inside), ['namesGain'])
  const none = after("P = inv(inv(P) + H' inv(W) H)", "x = x + P H' (W \\ (y - H x))")
  assert.deepEqual(asked('information', none), [])
  assert.deepEqual(asked('sequential', `two = eye(2) y\n${gain}`), ['divides'])
  assert.deepEqual(asked('sequential', `two = eye(2) y\n${none}`), ['divides'])
})

test('an exercise that asks for the line at fault does not name it before a line is changed', async () => {
  const spec = await widget('write-filter')
  const said = (frame) => [spec.verdict(frame), spec.announce(frame, frame), ...reasons(frame)].join(' ')
  for (const begin of ['mend-1', 'mend-2', 'mend-3']) {
    const frame = frameOf({ begin }, 30)
    assert.ok(frame.line !== null, begin)
    assert.doesNotMatch(said(frame), /line \d/i, begin)
    assert.match(said(frameOf({ begin, text: `${frame.text}\n` }, 30)), /line \d/i, begin)
  }
})

test('of a program that does not run no step and no NEES is said, and the plane shows the right filter', async () => {
  const spec = await widget('write-filter')
  const value = (frame, name) => spec.readouts(frame).find(({ key }) => key === name).value
  const running = frameOf({ begin: 'kalman' }, 60)
  assert.deepEqual([value(running, 'step'), value(running, 'nees') === '–'], ['60', false])
  for (const params of [{ begin: 'fill' }, { begin: 'empty' }, { begin: 'empty', text: 'x = F x + (' }]) {
    const frame = frameOf(params, 60)
    assert.deepEqual([value(frame, 'step'), value(frame, 'nees')], ['–', '–'], JSON.stringify(params))
    assert.deepEqual([frame.truth, frame.right, frame.ellipse], [running.truth, running.right, null])
    assert.equal(spec.describe(frame).run, 'The run waits for a program without faults.')
  }
  const ended = frameOf({ begin: 'empty', text: 'x = 1e6 F x\nP = V' }, 60)
  assert.match(spec.describe(ended).run, /^The program’s run ends after step [1-9]\d*\.$/)
})

test('the chapter lists each exercise of its pages once, and the page of exercises those with programs', () => {
  const of = (/** @type {string} */ at) =>
    parseHTML(readFileSync(new URL(`../../dist/kalman/${at}index.html`, import.meta.url), 'utf8')).document
  const ids = (/** @type {any} */ document, /** @type {string} */ which) =>
    [...document.querySelectorAll(which)].map(({ id }) => id).sort()
  const [chapter, exercises] = [of(''), of('exercises/')]
  const programs = ids(page, '.exercise')
  assert.deepEqual(ids(chapter, '.exercise-elsewhere'), [...ids(exercises, '.exercise'), ...programs].sort())
  assert.deepEqual(ids(exercises, '.exercise-elsewhere'), programs)
  for (const part of ['algorithms', 'wrong', 'exercises'])
    assert.ok(chapter.querySelectorAll(`section[data-part="${part}"] [id^="ex-filter-"]`).length >= 2, part)
})

test('Run it and See it lead to programs that there are', () => {
  const chapter = readFileSync(new URL('../../dist/kalman/index.html', import.meta.url), 'utf8')
  const programs = (html) => [...html.matchAll(/\?program=([\w-]+)#fig-filter/g)].map(([, name]) => name)
  assert.deepEqual(programs(chapter), ['kalman', 'ekf'])
  const shown = programs(page.toString())
  const bugs = GROUPS[1].programs.map(([begin]) => begin).filter((begin) => begin !== 'ekf')
  assert.equal(bugs.length, 10)
  for (const name of [...bugs, ...shown]) assert.ok(isBegin(name), name)
  assert.deepEqual(
    bugs.filter((bug) => !shown.includes(bug)),
    [],
  )
})

const ROBOT = `F = jac(f, x)\nx = f(x, u)\nP = F P F' + V\nH = jac(h, x)\nnu = y - h(x, l)\nnu[2] = wrap(nu[2])
S = H P H' + W\nR = P H' inv(S)\nx = x + R nu\nx[3] = wrap(x[3])\nP = sym(P - R H P)`

test('the ten bugs typed by hand are named, with their lines', () => {
  for (const [bug, old, wrong, line] of /** @type {[string, string, string, number][]} */ ([
    ['unwrapped-innovation', 'nu[2] = wrap(nu[2])\n', '', 5],
    ['unwrapped-heading', 'x[3] = wrap(x[3])\n', '', 9],
    ['wrong-derivative', 'nu = y', 'r = norm(x[1:2] - l)\nH[2, 3] = -1 / r^2\nnu = y', 6],
    ['transposed', "F P F'", "F' P F", 3],
    ['degrees', '+ W', '+ [W[1, 1], 0; 0, (180 / pi)^2 W[2, 2]]', 7],
    ['deviation', '+ W', '+ diag(sqrt(diag(W)))', 7],
    ['step-length', '+ V', '+ V 16', 3],
    ['short-form', "R = P H' inv(S)", "R = 13/10 P H' / S", 8],
    ['twice', 'sym(P - R H P)', `P - R H P\n${ROBOT.slice(ROBOT.indexOf('H = jac'))}`, 13],
  ])) {
    const text = ROBOT.replace(old, wrong)
    assert.notEqual(text, ROBOT, bug)
    const frame = frameOf({ begin: 'extend', text })
    assert.deepEqual([frame.outcome, frame.bug, frame.line], ['bug', bug, line], frame.sentences.join(' '))
  }
  const frame = frameOf({ begin: 'extend', text: ROBOT.replace('sym(P - R H P)', 'P - R H P') })
  assert.equal(frame.outcome, 'right')
  assert.match(reasons(frame).join(' '), /the museum’s bug “P is not symmetric”/)
})

test('a text that is no parameter is refused by name', () => {
  const refused = (text, code) =>
    assert.throws(
      () => frameOf({ text }),
      ({ name, code: said, argument }) => name === 'EstimateError' && said === code && argument === 'state.params.text',
    )
  refused('a'.repeat(2001), 'limit')
  refused('ν'.repeat(1001), 'limit')
  refused('x = F x\u0007', 'type')
  refused(7, 'type')
  assert.equal(frameOf({ text: 'ν'.repeat(1000) }).text.length, 1000)
  assert.match(faultOf('ν'.repeat(1001)), /2002 bytes/)
  assert.match(faultOf('\u0007'), /control character/)
  assert.equal(faultOf('x = F x\n\tP'), '')
})

/** A server whose clock moves by `tick` at each look, with what it has told and what waits. */
function serving(tick) {
  /** @type {any[][]} */
  const [told, waiting] = [[], []]
  let now = 0
  const server = new Server(
    estimate,
    (message) => told.push(message),
    (act) => waiting.push(act),
    () => (now += tick),
  )
  return { server, told, waiting }
}

test('worlds are counted in chunks, as at once, and a later program replaces an earlier one', () => {
  const { server, told, waiting } = serving(2)
  server.take({ kind: 'count', id: 1, params: { begin: 'kalman' } })
  assert.equal(waiting.length, 1, 'it waits between chunks')
  server.take({ kind: 'count', id: 2, params: { begin: 'forget' } })
  while (waiting.length) waiting.shift()()
  assert.equal(told.filter(({ id }) => id === 1).length, 1)
  const lab = estimate.WriteFilter.from({ version: 1, lab: 'write-filter', step: 0, params: { begin: 'forget' } })
  assert.deepEqual(told.at(-1), { kind: 'found', id: 2, found: worlds.whole(lab) })
  assert.equal(told.at(-1).found.count, 500)
  lab.free()
  const before = told.length
  server.take({ kind: 'count', id: 3, params: { begin: 'kalman' } })
  server.take({ kind: 'cancel' })
  while (waiting.length) waiting.shift()()
  assert.equal(told.length, before + 1)
  server.take({ kind: 'count', id: 4, params: { begin: 'nothing' } })
  assert.equal(told.at(-1).kind, 'refused')
})

test('the figure asks for the worlds of each program once, and takes none that it no longer shows', async () => {
  const sent = []
  /** @type {any} */
  const port = { post: (message) => sent.push(message), onmessage: null }
  let changes = 0
  const counting = new Counting(
    () => (changes += 1),
    async () => port,
  )
  const shown = (begin) => frameOf({ begin })
  counting.follow(shown('kalman'))
  counting.follow(shown('kalman'))
  await new Promise((resolve) => setImmediate(resolve))
  assert.deepEqual(
    sent.map(({ kind, id }) => [kind, id]),
    [['count', 1]],
  )
  port.onmessage({ kind: 'found', id: 1, found: { count: 20 } })
  assert.deepEqual([counting.value, counting.progress], [{ count: 20 }, { step: 20, of: 500, unit: 'world' }])
  counting.follow(shown('empty'))
  assert.deepEqual([counting.value, counting.progress], [null, null])
  port.onmessage({ kind: 'found', id: 1, found: { count: 40 } })
  assert.equal(counting.value, null)
  counting.follow(shown('joseph'))
  counting.cancel()
  await new Promise((resolve) => setImmediate(resolve))
  assert.deepEqual(
    sent.map(({ kind }) => kind),
    ['count', 'cancel', 'count', 'cancel'],
  )
  assert.equal(counting.progress, null)
  assert.ok(changes >= 2)
})

test('what the browser has kept comes back, and nothing else does', () => {
  assert.equal(last(), null)
  keep('fill', { text: 'x = F x', notation: 'thrun' })
  assert.equal(last(), 'fill')
  assert.deepEqual(textOf('fill'), { text: 'x = F x', notation: 'thrun' })
  keep('fill', null)
  assert.equal(textOf('fill'), null)
  keep('mend-1', { text: 'x'.repeat(2001), notation: 'choset' })
  assert.equal(textOf('mend-1'), null)
})
