// The faces of the formulas, as they are cut, hold every sign that the chapter's formulas show. A sign that is in no
// face is drawn as an empty box.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'

const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8')

/** The ranges of each face of the built style sheet; none where a face is whole. */
const faces = [
  ...read('target/fonts/formulas.css').matchAll(
    /font-family:(\w+);font-weight:(\d+);font-style:(\w+)[^}]*?(?:unicode-range:([^;}]*))?}/g,
  ),
].map(([, family, weight, style, range]) => ({
  key: `${family} ${weight} ${style}`,
  runs: range?.split(',').map((run) =>
    run
      .slice(2)
      .split('-')
      .map((code) => parseInt(code, 16)),
  ),
}))

test('every sign that a formula shows is in the face it is set in', () => {
  const missing = []
  for (const [key, letters] of Object.entries(JSON.parse(read('web/build/letters.json')))) {
    const parts = faces.filter((face) => face.key === key)
    if (!key.startsWith('KaTeX') || parts.length === 0) continue
    for (const letter of letters) {
      const code = letter.codePointAt(0)
      const held = parts.some(({ runs }) => !runs || runs.some(([from, to = from]) => code >= from && code <= to))
      if (!held) missing.push(`${key}: ${letter} U+${code.toString(16)}`)
    }
  }
  assert.ok(faces.length > 10, 'the faces are found')
  assert.deepEqual(missing, [])
})
