// How far a reader of the chapter's first half has to read from one thing to move to the next: the picture at the head,
// then the figures. Two screens of 900 px at most, or three on a phone: its column holds two thirds of the words that a
// wide one has in the same height. Lists the ways: node tests/browser/run.mjs distances
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { open } from './harness.mjs'

/** The part of the text behind the first half. */
const BEHIND = 'ekf'
const SCREEN = 900
/** The screens of a way at most, by the page's width, px. */
const MOST = { 1440: 2, 390: 3 }

for (const [width, most] of Object.entries(MOST)) {
  test(`at ${width} px there is something to move every ${most} screens of the first half`, async (t) => {
    const touch = Number(width) < 700
    const page = await open(t, { viewport: { width: Number(width), height: SCREEN }, touch })
    await page.locator('.vignette .handle').waitFor({ state: 'attached' })
    // What is closed stays closed: a reader of the text does not read it.
    const places = await page.evaluate(async (behind) => {
      for (const part of document.querySelectorAll('.chapter > section')) part.style.contentVisibility = 'visible'
      await document.fonts.ready
      const end = document.querySelector(`[data-part=${behind}]`).getBoundingClientRect().top + scrollY
      return [...document.querySelectorAll('.vignette, .widget'), null]
        .map((it) => {
          if (!it) return { name: 'the end of the first half', top: end, bottom: end }
          const { top, bottom } = it.getBoundingClientRect()
          const name = it.closest('figure')?.querySelector('.figure-title')?.textContent.trim() ?? 'the head'
          return { name, top: top + scrollY, bottom: bottom + scrollY }
        })
        .filter(({ top }) => top <= end)
        .sort((a, b) => a.top - b.top)
    }, BEHIND)
    const ways = places.map(({ name, top }, i) => ({ name, pixels: Math.round(top - (places[i - 1]?.bottom ?? 0)) }))
    for (const { name, pixels } of ways)
      t.diagnostic(`${pixels} px, ${(pixels / SCREEN).toFixed(1)} screens to ${name}`)
    assert.ok(ways.length > 10, `${ways.length} ways`)
    assert.deepEqual(
      ways.filter(({ pixels }) => pixels > most * SCREEN),
      [],
    )
  })
}
