// From 320 px up nothing makes a page scroll sideways; what is wide scrolls inside its own box.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { FIGURE_PAGES, PAGES, PHONE, figure, layOut, open, unlock, walkDown, quiet } from './harness.mjs'

/** How far the page goes on beyond its right edge, and what stands there. */
const beyond = (page) =>
  page.evaluate(() => {
    const wide = document.documentElement.clientWidth
    const boxed = (element) => {
      for (let up = element.parentElement; up; up = up.parentElement) {
        if (/auto|scroll|hidden|clip/.test(getComputedStyle(up).overflowX)) return true
      }
      return false
    }
    const right = (element) => Math.round(element.getBoundingClientRect().right)
    return {
      over: document.documentElement.scrollWidth - wide,
      culprits: [...document.querySelectorAll('body *')]
        .filter((element) => right(element) > wide + 1 && !boxed(element))
        .slice(0, 8)
        .map((it) => `${it.tagName.toLowerCase()}.${it.getAttribute('class') ?? ''} → ${right(it)}`),
    }
  })

for (const at of [...PAGES, ...FIGURE_PAGES]) {
  for (const widths of [
    [320, 390],
    [768, 900, 1280],
  ]) {
    test(`/${at} fits ${widths.join(', ')} px`, async (t) => {
      const touch = widths[0] < 500
      const page = await open(t, { at, viewport: { width: widths[0], height: 800 }, touch })
      await walkDown(page)
      for (const width of widths) {
        await page.setViewportSize({ width, height: 800 })
        await layOut(page)
        const { over, culprits } = await beyond(page)
        assert.ok(over <= 0, `${over} px too wide at ${width} px:\n${culprits.join('\n')}`)
        if (touch || !at.startsWith('figure/')) continue
        const reach = await page.evaluate(() => {
          const [panel, controls] = ['.live .panel', '.live .controls'].map((part) =>
            document.querySelector(part).getBoundingClientRect(),
          )
          return Math.round(Math.max(panel.bottom, controls.bottom) - Math.min(panel.top, controls.top))
        })
        assert.ok(reach < 1700, `${width} px: ${reach} px from the first panel to the last control it moves`)
      }
    })
  }
}

for (const at of PAGES) {
  test(`/${at}: the footer begins where the text does, and no name of code is broken in a table`, async (t) => {
    const page = await open(t, { at })
    for (const width of [390, 768, 1024, 1280, 1440]) {
      await page.setViewportSize({ width, height: 800 })
      const { text, footer, broken } = await page.evaluate(() => ({
        text: document.querySelector('main :is(h1, h2)').getBoundingClientRect().left,
        footer: document.querySelector('.site-footer a').getBoundingClientRect().left,
        broken: [...document.querySelectorAll('main :is(td, th) > code')]
          .filter((code) => /^[^\s,-]+$/.test(code.textContent) && code.getClientRects().length > 1)
          .map((code) => code.textContent),
      }))
      assert.ok(Math.abs(text - footer) <= 12, `${width} px: the text begins at ${text}, the footer at ${footer}`)
      assert.deepEqual(broken, [], `${width} px`)
    }
  })
}

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

test('a line never begins with the mark behind a formula, nor ends with the one before it, and no formula loses its full stop', async (t) => {
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

test('on a phone letters and colours stand in one row below the name of the book and the search', async (t) => {
  const page = await open(t, { at: 'log/', viewport: PHONE, touch: true })
  const tops = await page.locator('.site-header').evaluate((head) =>
    ['.site-place', '[data-open-search]', '[data-set-notation]', '[data-set-theme]'].map((part) => {
      const { top, height } = head.querySelector(part).getBoundingClientRect()
      return Math.round((top + height / 2) / 8)
    }),
  )
  const [name, search, letters, colours] = tops
  assert.ok(name === search && letters === colours && letters > name, tops.join(', '))
})

test('the contents called up on a phone are whole', async (t) => {
  const page = await open(t, { viewport: { width: 320, height: 640 }, touch: true })
  await page.locator('[data-open-contents]').tap()
  const cut = await page
    .locator('.toc[data-open] :is(a, .toc-number)')
    .evaluateAll((all) => all.filter((part) => part.getBoundingClientRect().left < 0).map((part) => part.textContent))
  assert.deepEqual(cut, [])
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

for (const tag of ['observer-bench', 'odometry-hook', 'observability-probe']) {
  test(`the page stays where it is while the ${tag} plays`, async (t) => {
    const page = await open(t, { motion: 'no-preference' })
    const widget = await figure(page, tag)
    await unlock(page, await widget.getAttribute('data-figure'))
    await widget.getByRole('button', { name: 'Play' }).click()
    // Where the figure fills the window there is nothing else to hold the place by.
    await widget.evaluate((element) =>
      scrollTo({ top: scrollY + element.getBoundingClientRect().top - 20, behavior: 'instant' }),
    )
    const places = await page.evaluate(async () => {
      const seen = new Set()
      for (const until = performance.now() + 3000; performance.now() < until; ) {
        await new Promise((resolve) => requestAnimationFrame(resolve))
        seen.add(scrollY)
      }
      return [...seen]
    })
    assert.equal(places.length, 1, `it was at ${places}`)
  })
}

test('a box that goes on beyond an edge fades there', async (t) => {
  const page = await open(t, { viewport: { width: 390, height: 844 }, touch: true })
  const box = page.locator('pre.scroll-box').first()
  await box.scrollIntoViewIfNeeded()
  await page.waitForFunction((element) => element.hasAttribute('tabindex'), await box.elementHandle())
  const marks = () =>
    box.evaluate((element) => [
      element.hasAttribute('data-before'),
      element.hasAttribute('data-after'),
      getComputedStyle(element).maskImage !== 'none',
    ])
  assert.deepEqual(await marks(), [false, true, true])
  await box.evaluate((element) => element.scrollTo({ left: element.scrollWidth }))
  await page.waitForFunction((element) => element.hasAttribute('data-before'), await box.elementHandle())
  assert.deepEqual(await marks(), [true, false, true])
  await page.setViewportSize({ width: 2000, height: 900 })
  await box.evaluate((element) => {
    element.style.width = '3000px'
  })
  await page.waitForFunction((element) => !element.hasAttribute('data-before'), await box.elementHandle())
  assert.deepEqual(await marks(), [false, false, false])
})

for (const [at, id] of [
  ['kalman/', '#fig-odometry'],
  ['system/', '#fig-own'],
  ['log/', '#fig-own-log'],
])
  test(`/${at}: a figure takes the room that there is beside the column`, async (t) => {
    const page = await open(t, { at })
    for (const [width, least] of [
      [768, 690],
      [900, 820],
      [1024, 660],
      [1280, 890],
      [1440, 960],
    ]) {
      await page.setViewportSize({ width, height: 900 })
      const { left, right, over } = await page.locator(id).evaluate((figure) => ({
        ...figure.getBoundingClientRect().toJSON(),
        over: document.documentElement.scrollWidth - innerWidth,
      }))
      assert.ok(
        right - left >= least && left >= 0 && right <= width && over <= 0,
        `${width} px: from ${left} to ${right}`,
      )
    }
  })

// Until our faces are here each size of letters asks the system for a face, and on Linux the page waits for each
// answer.
test('the page of a figure asks for its faces at once, and its drawings set letters in few sizes', async (t) => {
  for (const at of FIGURE_PAGES) {
    const page = await open(t, { at })
    const early = await page.evaluate(async () => {
      await document.fonts.ready
      const linked = [...document.querySelectorAll('link[rel=preload][as=font]')].map(({ href }) => href)
      return performance
        .getEntriesByType('resource')
        .filter(({ name, initiatorType }) => linked.includes(name) && initiatorType === 'link')
        .map(({ name }) => name.match(/assets\/(.*)-/)[1])
    })
    assert.deepEqual(early.sort(), ['sans', 'serif-italic', 'serif-upright'], at)
    const loaded = await page.evaluate(() =>
      [...document.fonts].filter(({ status }) => status === 'loaded').map(({ family, style }) => `${family} ${style}`),
    )
    for (const face of ['Plain normal', 'Text normal', 'Text italic'])
      assert.ok(loaded.includes(face), `${at} uses ${face}`)
    const drawn = await page
      .locator('.panel')
      .evaluateAll((all) => [...new Set(all.map((panel) => getComputedStyle(panel).textRendering))])
    assert.deepEqual(drawn, ['geometricprecision'], at)
  }
})

test('statements of one display stand below one another on a phone, and what letters mean has room at every width', async (t) => {
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
  await layOut(page)
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
