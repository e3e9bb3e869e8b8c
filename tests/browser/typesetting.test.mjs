// Text, formulas and tables are set for the eye: at every width nothing is torn, cut or scrolled that need not be.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { layOut, open, quiet, walkDown } from './harness.mjs'

test('on a phone each letter of the table of letters is whole, and what it means has the whole width', async (t) => {
  const page = await open(t, { viewport: { width: 390, height: 800 } })
  for (const width of [320, 390, 600]) {
    await page.setViewportSize({ width, height: 800 })
    const faults = await page.evaluate(async () => {
      const part = document.querySelector('[data-part="notation"]')
      part.style.contentVisibility = 'visible'
      await document.fonts.ready
      return [...part.querySelectorAll('tbody tr')].flatMap((row) => {
        const cells = [...row.children].map((cell) => ({
          words: cell.textContent,
          over: cell.scrollWidth - cell.clientWidth,
          ...cell.getBoundingClientRect().toJSON(),
        }))
        const meaning = cells.pop()
        const whole = row.getBoundingClientRect().width
        return [
          ...cells.filter(({ over }) => over > 1).map(({ words, over }) => `${words} is ${over} px too wide`),
          ...(meaning.width < 0.9 * whole || meaning.top < cells.at(-1).bottom - 1
            ? [`${meaning.words.slice(0, 30)} takes ${Math.round(meaning.width)} of ${Math.round(whole)} px`]
            : []),
        ]
      })
    })
    assert.deepEqual(faults, [], `${width} px`)
  }
})

test('no line begins with the mark behind a formula or ends with the one before, no full stop is cut', async (t) => {
  const page = await open(t)
  for (const width of [320, 390, 768, 1280]) {
    await page.setViewportSize({ width, height: 800 })
    await layOut(page)
    // Wide displays are set smaller once the new width is known.
    await quiet(page)
    const { torn, cut, seen } = await page.evaluate(() => {
      /** The text in the same block next to an element, before or behind it. */
      const beside = (element, step) => {
        const walker = document.createTreeWalker(
          element.closest('p, li, dd, td, th, figcaption, summary, div'),
          NodeFilter.SHOW_TEXT,
        )
        walker.currentNode = element
        let node = step === 'previousNode' ? walker.previousNode() : walker.nextNode()
        while (node && element.contains(node)) node = walker[step]()
        return node
      }
      const place = (node, at) => {
        const range = document.createRange()
        range.setStart(node, at)
        range.setEnd(node, at + 1)
        return range.getBoundingClientRect()
      }
      let seen = 0
      const torn = [...document.querySelectorAll('main .katex')].flatMap((formula) => {
        if (formula.closest('.katex-display') || !formula.checkVisibility()) return []
        const boxes = [...formula.querySelectorAll('.base')]
        const [first, last] = [
          (boxes[0] ?? formula).getClientRects()[0],
          [...(boxes.at(-1) ?? formula).getClientRects()].at(-1),
        ]
        /** @type {any[]} */
        const [behind, before] = [beside(formula, 'nextNode'), beside(formula, 'previousNode')]
        const found = []
        if (/^[.,;:!?)’”-]/.test(behind?.data ?? '')) {
          seen++
          if (place(behind, 0).left < last.right - 2) found.push(`${formula.textContent} | ${behind.data.slice(0, 12)}`)
        }
        if (/[([‘“]$/.test(before?.data ?? '')) {
          seen++
          if (place(before, before.data.length - 1).right > first.left + 2)
            found.push(`${before.data.slice(-12)} | ${formula.textContent}`)
        }
        return found
      })
      // A formula that is too wide by its full stop alone would show no sign that there is more.
      const cut = [...document.querySelectorAll('.equation-body')]
        .filter((box) => {
          const over = box.scrollWidth - box.clientWidth
          return over > 0 && over < 24
        })
        .map((box) => `${box.scrollWidth - box.clientWidth} px: ${box.textContent.slice(-40)}`)
      return { torn, cut, seen }
    })
    assert.ok(seen > 150, `${seen} marks at ${width} px`)
    assert.deepEqual(torn, [], `torn at ${width} px`)
    assert.deepEqual(cut, [], `cut at ${width} px`)
  }
})

test('a line of the text is as long as an eye can follow', async (t) => {
  const page = await open(t)
  await page.evaluate(() => document.fonts.ready)
  // The letters between one line's box and the next, in paragraphs of words alone; a paragraph's last line ends where
  // it will.
  const lengths = await page.evaluate(() =>
    [...document.querySelectorAll('.chapter > section > p')].flatMap((p) => {
      if (p.querySelector('.katex, .number, .formula-numbers')) return []
      const lines = new Map()
      const walker = document.createTreeWalker(p, NodeFilter.SHOW_TEXT)
      for (let node; (node = walker.nextNode()); ) {
        for (let i = 0; i < node.data.length; i++) {
          const range = document.createRange()
          range.setStart(node, i)
          range.setEnd(node, i + 1)
          const box = range.getBoundingClientRect()
          if (node.data[i] !== '\u00ad' && box.width > 0)
            lines.set(Math.round(box.bottom / 8), (lines.get(Math.round(box.bottom / 8)) ?? 0) + 1)
        }
      }
      return [...lines.values()].slice(0, -1)
    }),
  )
  const median = lengths.sort((a, b) => a - b)[Math.floor(lengths.length / 2)]
  t.diagnostic(`${lengths.length} lines, ${median} characters in the middle`)
  assert.ok(lengths.length > 50)
  assert.ok(median >= 60 && median <= 75, `${median} characters`)
})

test('on a phone statements of a display stand in a column; what letters mean has room at every width', async (t) => {
  const page = await open(t, { viewport: { width: 390, height: 844 }, touch: true })
  await walkDown(page)
  const boxes = await page.locator('.chapter .statements').evaluateAll((all) =>
    all
      .filter((box) => box.checkVisibility())
      .map((box) => {
        const range = document.createRange()
        const widths = [...box.querySelectorAll('.katex-html')].map((formula) => {
          range.selectNodeContents(formula)
          return range.getBoundingClientRect().width
        })
        return {
          fits: Math.max(...widths) < box.clientWidth,
          scrolls: box.scrollWidth > box.clientWidth + 1,
          words: box.textContent.slice(0, 40),
        }
      }),
  )
  assert.ok(boxes.filter(({ fits }) => fits).length >= 8, `${boxes.length} displays of several statements`)
  assert.deepEqual(
    boxes.filter(({ fits, scrolls }) => fits && scrolls),
    [],
  )
  for (const width of [320, 390, 700, 900, 1100, 1280]) {
    await page.setViewportSize({ width, height: 900 })
    const narrow = await page
      .locator('[data-part=notation] > .table-box tbody td:last-child')
      .evaluateAll((all) => Math.min(...all.map((cell) => cell.clientWidth)))
    assert.ok(narrow >= 230, `${width} px: ${narrow}`)
  }
})

test('on a phone no formula and no table has to be scrolled in any letters, and on a desk no listing', async (t) => {
  const page = await open(t, { viewport: { width: 390, height: 844 }, touch: true })
  const wide = (selector) =>
    page
      .locator(selector)
      .evaluateAll((all) =>
        all
          .filter((box) => box.scrollWidth > box.clientWidth + 1)
          .map((box) => `${box.scrollWidth} px in ${box.clientWidth}: ${box.textContent.slice(0, 60)}`),
      )
  await layOut(page)
  for (const notation of ['Choset', 'Thrun', 'Common']) {
    await page
      .locator(`[data-set-notation]`, { hasText: notation })
      .first()
      .evaluate((button) => button.click())
    await page.waitForFunction((it) => document.documentElement.dataset.letters === it, notation.toLowerCase())
    await layOut(page)
    assert.deepEqual(await wide('main :is(.equation-body, .table-box)'), [], notation)
  }
  await page.setViewportSize({ width: 1440, height: 900 })
  await page.goto(new URL('rust/', page.url()).href)
  await layOut(page)
  assert.ok((await page.locator('.chapter > section > .listing > pre').count()) > 10)
  assert.deepEqual(await wide('.chapter > section > .listing > pre'), [])
})

test('no note in the margin pushes the next heading down', async (t) => {
  const page = await open(t, { viewport: { width: 1440, height: 900 } })
  await layOut(page)
  const holes = await page.evaluate(() => {
    return [...document.querySelectorAll('.chapter :is(h2, h3, h4)')].flatMap((heading) => {
      let before = heading.previousElementSibling ?? heading.parentElement.previousElementSibling?.lastElementChild
      while (before && getComputedStyle(before).float !== 'none') before = before.previousElementSibling
      const hole = before ? heading.getBoundingClientRect().top - before.getBoundingClientRect().bottom : 0
      return hole > 120 ? [`${Math.round(hole)} px before ${heading.textContent}`] : []
    })
  })
  assert.deepEqual(holes, [])
})
