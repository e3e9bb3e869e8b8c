// Which tests `scripts/test --changed` runs after a change in a figure's folder: those that reach the figure by its
// name or by a file of it, be it through a helper, and of the tests over all figures those of this figure.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import path from 'node:path'
import { touched } from '../touched.mjs'

const [node, browser] = [import.meta.dirname, path.join(import.meta.dirname, '../browser')]

/** What a change of figures touches. @returns {NonNullable<ReturnType<typeof touched>>} */
const some = (folder, files) => {
  const found = touched(folder, files)
  assert.ok(found, 'not all tests')
  return found
}
/** A changed file, and tests that read what is in it: the folder, and the names. */
const ROWS = [
  ['robot-log/words.js', browser, 'log-along log-delay log-faults log-kept log-reading log-sensors log-sight log'],
  ['robot-log/verdict.js', node, 'verdict-words verdict worker robot-log-words robot-log-server log-bench log-export'],
  ['own-system/words.js', node, 'own-system-letters own-system-sums own-system-words own-system paste'],
  ['own-system/editor.js', browser, 'own-system own-system-letters'],
  ['write-filter/copy.js', node, 'copied-programs write-filter write-filter-words'],
  ['loop-closure/map.js', node, 'camera loop-closure-words'],
  ['bug-museum/words.js', node, 'bug-museum-words write-filter-words write-filter'],
  ['bug-museum/words.js', browser, 'museum write-filter'],
  ['observer-bench/phase.js', node, 'scale observer-bench-words'],
  ['observer-bench/phase.js', browser, 'bench'],
]
for (const [file, folder, names] of ROWS) {
  test(`a change of ${file} runs the tests of ${path.basename(folder)} that reach it`, () => {
    const whole = some(folder, [`web/widgets/${file}`]).whole
    for (const name of names.split(' ')) assert.ok(whole.includes(name), `${name} is left out`)
  })
}

/** A changed figure, a test over all figures, and how a title of the figure's begins there. */
const TITLES = [
  ['odometry-hook', node, 'tries', 'the figure that learns the wheel opens in a state that every phrase changes'],
  ['picture', node, 'tries', 'a phrase of the Picture shows the same after any other'],
  ['robot-log', node, 'drawn', 'a panel of a log says why it is empty, and one alone says what to do'],
  ['robot-log', node, 'drawn', 'the claimed 2 σ of dead reckoning stays in its panel'],
  ['touch', node, 'drawn', 'the touch draws numbers alone, in every state'],
  ['two-bells', node, 'words', 'no readout of a figure is empty or wrong in kind, in any state'],
  ['observer-bench', browser, 'embed', 'in a frame a link is shown where the clipboard is closed, and'],
  ['observability-probe', browser, 'embed', 'a long run in a frame is computed in slices, without a worker'],
  ['tune', browser, 'embed', 'in a frame the likelihood’s map is filled in slices, without a worker, and'],
  [
    'observer-bench',
    browser,
    'embed',
    "a figure's own page takes a theme of its address, and is whole without scripts",
  ],
  ['observer-bench', browser, 'stages', 'a link to a state opens the whole figure, and so does its own page'],
  ['observer-bench', browser, 'stages', 'on a phone the ellipse stays in sight while the knob is turned, and one'],
  ['observer-bench', browser, 'firefox', 'the keys turn the knob in Firefox'],
]
for (const [figure, folder, name, begins] of TITLES) {
  test(`a change of ${figure} runs “${begins.slice(0, 50)}…” of ${name}`, () => {
    const { whole, parts, pattern } = some(folder, [`web/widgets/${figure}/words.js`])
    assert.ok(!whole.includes(name) && parts.includes(name))
    const text = readFileSync(path.join(folder, `${name}.test.mjs`), 'utf8')
    const at = text.indexOf(begins)
    // What a loop makes of its title is written whole in the row.
    const title = at < 0 ? begins : text.slice(at, text.indexOf(`${text[at - 1]},`, at))
    assert.match(title, new RegExp(pattern))
  })
}

test('no browser opens every figure for a change of one, and a word that is compared is no name of a figure', () => {
  const { whole, pattern } = some(browser, ['web/widgets/touch/words.js'])
  assert.ok(whole.includes('small') && !whole.includes('own-time'), `${whole}`)
  assert.doesNotMatch('on a phone held across, each figure’s picture stays in sight', new RegExp(pattern))
})
