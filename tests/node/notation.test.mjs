// The letters of each notation: the figures' labels have those of the formulas, and no letter of a notation means two
// things.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { SYMBOLS, held, unmarked } from '../../web/draw/words.js'

const macros = readFileSync(new URL('../../content/macros.toml', import.meta.url), 'utf8')
/** The switched symbols, each in Choset's, Thrun's and the common letters. */
const formulas = Object.fromEntries(
  [...macros.matchAll(/^(\w+)\s*= \{ choset = '([^']*)', thrun = '([^']*)'(?:, common = '([^']*)')? \}$/gm)].map(
    ([, name, choset, thrun, common = choset]) => [name, [choset, thrun, common]],
  ),
)

/** TeX of one symbol as the signs that it draws. */
const drawn = (tex) =>
  tex
    .replace(/\\(?:pred|post|meas|truth)\{(.*)\}/, '$1')
    .replace(/\\tilde y/, 'ỹ')
    .replace(/\\Sigma/, 'Σ')
    .replace(/\\nu/, 'ν')
    .replace(/[_{}]/g, '')

test('a label writes a symbol as the formulas do, in every notation', () => {
  assert.ok(Object.keys(SYMBOLS).length > 8)
  for (const [name, readings] of Object.entries(SYMBOLS)) {
    // A time in words, and a covariance at a time, have no macro.
    if (['k', 'Pk', 'Pstart'].includes(name)) continue
    assert.ok(formulas[name], `\\${name} is a macro`)
    assert.deepEqual(readings.map(unmarked), formulas[name].map(drawn), name)
  }
})

test('no letter means two things in one notation', () => {
  const different = [
    'F',
    'G',
    'H',
    'V',
    'W',
    'K',
    'R',
    'x',
    'u',
    'y',
    'vn',
    'wn',
    'zz',
    'CC',
    'xh',
    'P',
    'innov',
    'Obs',
  ]
  for (const n of [0, 1, 2]) {
    const letters = different.map((name) => formulas[name][n].replace(/\\(?:pred|post|meas|truth)\{(.*)\}/, '$1'))
    const twice = letters.filter((letter, i) => letters.indexOf(letter) !== i)
    assert.deepEqual([letters.length, twice], [different.length, []])
    assert.ok(!letters.includes('S'), "S is the innovation's covariance")
  }
})

test('a unit stays on the line of its number, and nothing else is held', () => {
  assert.equal(
    held('It is 95 % of 3 m, at 2 m/s; 4 more, 7 sightings.'),
    'It is 95\u00a0% of 3\u00a0m, at 2\u00a0m/s; 4 more, 7 sightings.',
  )
})
