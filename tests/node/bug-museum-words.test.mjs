// What the Bug Museum says of a run is true of it, and nothing that it says gives a hidden bug away.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { buildSeeIt } from '../../web/widgets/bug-museum/see-it.js'
import { BUGS } from '../../web/widgets/bug-museum/words.js'
import { check, estimate, prints, sentences, widget } from './claims.mjs'

check(
  'bug-museum',
  {
    bug: ['none', 'late', 'asymmetric'],
    second: ['none', 'twice'],
    lot: [0, 3],
    pair: [false, true],
    guess: ['late'],
    committed: [false, true],
    many: [false, true],
  },
  [0, 1, 240, 250],
  () => {
    const why = (bug) => sentences(BUGS[bug].why)
    const bugs = ({ params, answer }) =>
      params.lot === 0 ? [params.bug, params.second] : answer ? [answer.bug, answer.second] : []
    const named = (frame, list) =>
      list ===
      bugs(frame)
        .filter((bug) => bug !== 'none')
        .map((bug) => `“${BUGS[bug].name}”`)
        .join(' and ')
    const beyond = ({ figures }) =>
      figures.filter(({ value, band: [low, high] }) => value === null || value < low || value > high).length
    return [
      [/^The filter has no bug\.$/, (frame) => frame.params.lot === 0 && bugs(frame).every((bug) => bug === 'none')],
      [/^The filter has (“.*”)\.$/, (frame, list) => frame.params.lot === 0 && named(frame, list)],
      [
        /^(A bug is|Two bugs are) hidden in the filter\.$/,
        ({ params, answer }, count) =>
          params.lot !== 0 && !params.committed && answer === null && (count === 'A bug is') === !params.pair,
      ],
      [
        /^(Right|No): it was (“.*”)\.$/,
        (frame, judged, list) => frame.answer.right === (judged === 'Right') && named(frame, list),
      ],
      [
        /^The run is at step (\d+) of 240; its figures are judged at the end\.$/,
        ({ driven }, step) => Number(step) === driven && driven < 240,
      ],
      [
        /^All 14 figures of this run lie within a right filter’s 95 % bands\.$/,
        (frame) => frame.driven >= 240 && beyond(frame) === 0,
      ],
      [
        /^(\d+) of 14 figures of this run (lies?) outside a right filter’s 95 % bands\.$/,
        (frame, out, lie) =>
          frame.driven >= 240 && beyond(frame) === Number(out) && (lie === 'lies') === (Number(out) === 1),
      ],
      [
        /^Of (\d+) seeds?, (\d+) % have a mean NEES outside its band\.$/,
        ({ seeds, figures }, count, share) =>
          Number(count) === seeds && prints(share, 100 * (figures[3].beyond[0] + figures[3].beyond[1])),
      ],
      [
        new RegExp(
          `^(?:${Object.keys(BUGS)
            .flatMap(why)
            .filter(Boolean)
            .map((text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'))
            .join('|')})$`,
        ),
        (frame) => frame.answer !== null,
      ],
    ]
  },
)

test('what the frame, the words and the link of a hidden bug hold is the same for every bug', async () => {
  const spec = await widget('bug-museum')
  const open = (params) => estimate.BugMuseum.from({ version: 1, lab: 'bug-museum', step: 240, params })
  const bugs = new Set()
  for (let lot = 1; lot < 60; lot += 1) {
    const [lab, answered] = [open({ lot }), open({ lot, committed: true })]
    const frame = lab.frame()
    bugs.add(answered.frame().answer.bug)
    assert.equal(frame.answer, null)
    assert.deepEqual({ ...lab.state().params, lot: 0 }, { ...open({}).state().params })
    const said = [
      spec.verdict(frame),
      ...Object.values(spec.describe(frame)),
      ...spec.readouts(frame).map(({ value }) => value),
    ].join(' ')
    for (const { name } of Object.values(BUGS)) assert.ok(name === 'none' || !said.includes(name), `${lot}: ${said}`)
    lab.free()
    answered.free()
  }
  assert.ok(bugs.size > 9, `${bugs.size} bugs were drawn`)
})

test('a bug that is a formula leads to the program that has it, and a setting says that it is none', () => {
  const { parseHTML } = createRequire(new URL('../../web/package.json', import.meta.url))('linkedom')
  const { document } = parseHTML('<!doctype html><html data-root="../"><body></body></html>')
  const { element, show } = /** @type {{ element: any, show: (params: any) => void }} */ (buildSeeIt(document))
  const settings = []
  for (const bug of Object.keys(BUGS)) {
    show({ bug, lot: 0 })
    const link = element.querySelector('a')
    if (bug === 'none') assert.ok(element.hidden && !link, 'the right filter has nothing to see')
    else if (link) {
      assert.equal(element.textContent, 'See it as a program')
      assert.equal(link.getAttribute('href'), `../kalman/filter/?program=${bug}#fig-filter`)
      const lab = estimate.WriteFilter.from({ version: 1, lab: 'write-filter', step: 0, params: { begin: bug } })
      const { bug: named, outcome, sentences } = lab.frame()
      // The one that a single step does not show is told by its last digits.
      if (bug === 'asymmetric') assert.ok(outcome === 'right' && sentences.join(' ').includes('“P is not symmetric”'))
      else assert.equal(named, bug)
      lab.free()
    } else {
      assert.equal(element.textContent, 'No formula: a setting of the world')
      settings.push(bug)
    }
  }
  assert.deepEqual(settings.sort(), ['frozen-jacobian', 'late', 'open-gate'])
  show({ bug: 'late', lot: 3 })
  assert.ok(element.hidden && element.textContent === '', 'what is hidden is not told')
})

test('where a page is not known, there is no way to a program', () => {
  const { parseHTML } = createRequire(new URL('../../web/package.json', import.meta.url))('linkedom')
  const { document } = parseHTML('<!doctype html><html><body></body></html>')
  const { element, show } = /** @type {{ element: any, show: (params: any) => void }} */ (buildSeeIt(document))
  show({ bug: 'transposed', lot: 0 })
  assert.ok(element.hidden && element.textContent === '')
})
