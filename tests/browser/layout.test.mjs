// From 320 px up nothing makes a page scroll sideways; what is wide scrolls inside its own box.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { FIGURE_PAGES, PAGES, PHONE, figure, layOut, open, pageOf, unlock, walkDown } from './harness.mjs'
import { WIDGETS } from '../../web/widgets/index.js'

/** Figures that can play, known before the first test: nothing is awaited after that. */
const PLAYED = []
for (const [tag, load] of Object.entries(WIDGETS)) if (!(await load()).timeless) PLAYED.push(tag)

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
          const parts = ['.live .panel', '.live .controls'].map((part) => document.querySelector(part))
          // A small figure may have handles alone.
          const boxes = parts.filter(Boolean).map((part) => part.getBoundingClientRect())
          const [tops, bottoms] = [boxes.map(({ top }) => top), boxes.map(({ bottom }) => bottom)]
          return Math.round(Math.max(...bottoms) - Math.min(...tops))
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

for (const tag of PLAYED) {
  test(`the page stays where it is while the ${tag} plays`, async (t) => {
    const page = await open(t, { at: pageOf(tag), motion: 'no-preference' })
    const widget = await figure(page, tag)
    await unlock(page, await widget.getAttribute('data-figure'))
    await widget.getByRole('button', { name: 'Play' }).waitFor()
    // Watched from the press on, in one go: a short run might have come to its end before a second look.
    const { places, steps } = await widget.evaluate(async (host) => {
      // Where the figure fills the window there is nothing else to hold the place by. What stands above it is laid out
      // as it comes near, and moves it: it is brought back until it stays.
      for (let stays = 0; stays < 3; ) {
        const before = host.getBoundingClientRect().top
        scrollTo({ top: scrollY + before - 20, behavior: 'instant' })
        await new Promise((resolve) => requestAnimationFrame(resolve))
        stays = host.getBoundingClientRect().top === before ? stays + 1 : 0
      }
      const [places, steps] = [new Set([scrollY]), new Set([host.frame.step])]
      const play = [...host.querySelectorAll('button')].find(({ textContent }) => textContent.trim() === 'Play')
      play.click()
      const { run } = host.figure
      for (let frames = 0; frames < 120 || (steps.size < 4 && run.playing); frames += 1) {
        await new Promise((resolve) => requestAnimationFrame(resolve))
        places.add(scrollY)
        steps.add(host.frame.step)
      }
      return { places: [...places], steps: steps.size }
    })
    assert.ok(steps > 3, `it played: ${steps} steps were seen`)
    assert.equal(places.length, 1, `it was at ${places}`)
  })
}

test('a box that goes on beyond an edge fades there', async (t) => {
  const page = await open(t, { at: 'kalman/rust/', viewport: { width: 390, height: 844 }, touch: true })
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
    // A small figure may have no letter of the reader's.
    const italic = (await page.locator('.symbol, em').count()) > 0
    for (const face of ['Plain normal', 'Text normal', ...(italic ? ['Text italic'] : [])])
      assert.ok(loaded.includes(face), `${at} uses ${face}`)
    const drawn = await page
      .locator('.panel')
      .evaluateAll((all) => [...new Set(all.map((panel) => getComputedStyle(panel).textRendering))])
    assert.deepEqual(drawn, ['geometricprecision'], at)
  }
})
