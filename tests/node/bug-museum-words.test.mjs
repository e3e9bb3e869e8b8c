// What the Bug Museum says of a run is true of it, and nothing that it says gives a hidden bug away.
import { test } from 'node:test'
import assert from 'node:assert/strict'
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
