// From 320 px up nothing makes a page scroll sideways; what is wide scrolls inside its own box.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { FIGURE_PAGES, PAGES, figure, open, unlock, walkDown } from './harness.mjs'

for (const at of [...PAGES, ...FIGURE_PAGES]) {
  for (const width of [320, 390, 768, 1280]) {
    test(`/${at} fits ${width} px`, async (t) => {
      const page = await open(t, { at, viewport: { width, height: 800 }, touch: width < 500 })
      await walkDown(page)
      await page.evaluate(() => document.querySelectorAll('details').forEach((block) => { block.open = true }))
      const { over, culprits } = await page.evaluate(() => {
        const wide = document.documentElement.clientWidth
        const boxed = (element) => {
          for (let up = element.parentElement; up; up = up.parentElement) {
            if (/auto|scroll|hidden|clip/.test(getComputedStyle(up).overflowX)) return true
          }
          return false
        }
        return {
          over: document.documentElement.scrollWidth - wide,
          culprits: [...document.querySelectorAll('body *')]
            .filter((element) => element.getBoundingClientRect().right > wide + 1 && !boxed(element))
            .slice(0, 8)
            .map((element) => `${element.tagName.toLowerCase()}.${element.getAttribute('class') ?? ''} → ${Math.round(element.getBoundingClientRect().right)}`),
        }
      })
      assert.ok(over <= 0, `${over} px too wide:\n${culprits.join('\n')}`)
    })
  }
}

test('the contents called up on a phone are whole', async (t) => {
  const page = await open(t, { viewport: { width: 320, height: 640 }, touch: true })
  await page.locator('[data-open-contents]').tap()
  const cut = await page.locator('.toc[data-open] :is(a, .toc-number)').evaluateAll((all) => all.filter((part) => part.getBoundingClientRect().left < 0).map((part) => part.textContent))
  assert.deepEqual(cut, [])
})

test('a line of the text is as long as an eye can follow', async (t) => {
  const page = await open(t)
  await page.evaluate(() => document.fonts.ready)
  // The letters between one line's box and the next, in paragraphs of words alone; a paragraph's last line ends where it will.
  const lengths = await page.evaluate(() => [...document.querySelectorAll('.chapter > section > p')].flatMap((p) => {
    if (p.querySelector('.katex, .number, .formula-numbers')) return []
    const lines = new Map()
    const walker = document.createTreeWalker(p, NodeFilter.SHOW_TEXT)
    for (let node; (node = walker.nextNode());) {
      for (let i = 0; i < node.data.length; i++) {
        const range = document.createRange()
        range.setStart(node, i)
        range.setEnd(node, i + 1)
        const box = range.getBoundingClientRect()
        if (node.data[i] !== '\u00ad' && box.width > 0) lines.set(Math.round(box.bottom / 8), (lines.get(Math.round(box.bottom / 8)) ?? 0) + 1)
      }
    }
    return [...lines.values()].slice(0, -1)
  }))
  const median = lengths.sort((a, b) => a - b)[Math.floor(lengths.length / 2)]
  t.diagnostic(`${lengths.length} lines, ${median} characters in the middle`)
  assert.ok(lengths.length > 50)
  assert.ok(median >= 60 && median <= 75, `${median} characters`)
})

for (const tag of ['observer-bench', 'odometry-hook', 'observability-probe']) {
  test(`the page stays where it is while the ${tag} plays`, async (t) => {
    const page = await open(t, { motion: 'no-preference' })
    const widget = await figure(page, tag)
    await unlock(page, await widget.getAttribute('data-figure'))
    await widget.getByRole('button', { name: 'Play' }).click()
    // Where the figure fills the window there is nothing else to hold the place by.
    await widget.evaluate((element) => scrollTo({ top: scrollY + element.getBoundingClientRect().top - 20, behavior: 'instant' }))
    const places = await page.evaluate(async () => {
      const seen = new Set()
      for (const until = performance.now() + 3000; performance.now() < until;) {
        await new Promise((resolve) => requestAnimationFrame(resolve))
        seen.add(scrollY)
      }
      return [...seen]
    })
    assert.equal(places.length, 1, `it was at ${places}`)
  })
}
