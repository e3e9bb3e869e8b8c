// A caption says what a picture shows, in at most two sentences; what to try stands in the text beside it.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'

const content = new URL('../../content/', import.meta.url)
const files = readdirSync(content, { recursive: true, encoding: 'utf8' }).filter(
  (name) => name.endsWith('.md') && name !== 'README.md',
)

/** The figures of a text: [id, caption]. @param {string} text */
const figures = (text) =>
  [...text.matchAll(/^:::figure\{#([\w-]+)[^\n]*\}\n(.*?)^:::$/gms)].map(([, id, caption]) => [id, caption])

/** Sentences of a caption: a number's point and the points of "e.g." end none. @param {string} caption */
const sentences = (caption) => caption.split(/[.!?](?:[*\])"”]|\{[^}]*\})*(?:\s+|$)/).filter((one) => one.trim() !== '')

test('every caption has one sentence or two', () => {
  const all = files.flatMap((name) => figures(readFileSync(new URL(name, content), 'utf8')))
  assert.ok(all.length >= 10, `${all.length} figures`)
  for (const [id, caption] of all) {
    const found = sentences(caption).length
    assert.ok(found === 1 || found === 2, `the caption of ${id} has ${found} sentences`)
  }
})

test('a third sentence is counted', () => {
  assert.equal(sentences('One is 0.5 m. *Two* ends in a star.* [Three](#x) is here.\n').length, 3)
})
