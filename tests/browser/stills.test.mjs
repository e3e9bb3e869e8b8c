// Stills first: without scripts, without WebAssembly, or when the module cannot be fetched, every figure is a picture
// with words, and a failed one can be tried again.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import path from 'node:path'
import { PNG } from 'pngjs'
import { dist, FIGURE_PAGES, open, openFigure, PHONE, quiet } from './harness.mjs'
import { differenceOf } from './snapshots.mjs'

/**
 * How each figure's still is drawn: panels that show, drawn in the page or as images that have come, and how much they
 * hold.
 */
async function stills(page) {
  // Where scripts are on, an image waits until it is near the screen.
  await page.evaluate(() => {
    for (const image of document.querySelectorAll('.still > img')) image.loading = 'eager'
  })
  // A page without scripts answers questions, and draws no frame of its own accord.
  while (!(await page.evaluate(() => [...document.querySelectorAll('.still > img')].every((image) => image.complete))));
  return page.evaluate(() => {
    /** Of an image, the pixels that it inks, in hundreds. */
    const inked = (image) => {
      const canvas = document.createElement('canvas')
      Object.assign(canvas, { width: 300, height: 200 })
      const brush = canvas.getContext('2d')
      if (image.naturalWidth > 0) brush.drawImage(image, 0, 0, 300, 200)
      return brush.getImageData(0, 0, 300, 200).data.filter((value, i) => i % 4 === 3 && value > 60).length / 100
    }
    return [...document.querySelectorAll('figure.figure-widget')].map((figure) => {
      const panels = [...figure.querySelectorAll('.still > .panel')].filter((panel) => {
        const box = panel.getBoundingClientRect()
        return box.width > 100 && box.height > 80
      })
      return {
        id: figure.id,
        panels: panels.length,
        marks: Math.min(
          ...panels.map((panel) =>
            panel.localName === 'img' ? inked(panel) : panel.querySelectorAll('path, line, circle').length,
          ),
        ),
        words: figure.querySelector('.still-text')?.textContent.trim().length ?? 0,
        caption: figure.querySelector('figcaption')?.textContent.trim().length ?? 0,
      }
    })
  })
}

function judge(figures) {
  assert.ok(figures.length >= 1, 'there are figures')
  for (const { id, panels, marks, words, caption } of figures) {
    assert.ok(panels > 0 && marks > 5, `${id} is drawn: ${panels} panels, the least with ${marks} marks`)
    assert.ok(words > 40, `${id} is described`)
    assert.ok(caption > 20, `${id} has a caption`)
  }
}

test('with scripts off every figure is a still with words, and the page is whole', async (t) => {
  const page = await open(t, { scripts: false })
  judge(await stills(page))
  assert.equal(
    await page.locator('button:visible, input:visible, select:visible').count(),
    0,
    'nothing to press that would not answer',
  )
  const pictures = await page
    .locator('figure.figure-widget .still')
    .evaluateAll((all) => all.map((still) => still.innerHTML))
  assert.equal(new Set(pictures).size, pictures.length, 'each figure shows its own state')
  assert.ok((await page.locator('main p').count()) > 30)
})

test('drawings that are files follow the theme and the notation, and a search in the page finds their words', async (t) => {
  const page = await open(t, {
    expected: [/\.wasm|Failed to load|ERR_FAILED/i],
    prepare: (it) => it.route('**/*.wasm', (route) => route.abort()),
  })
  const gain = page.locator('#fig-bench .still > .panel-gain')
  await gain.scrollIntoViewIfNeeded()
  await page.locator('#fig-bench .figure-failure').waitFor()
  const shot = async () => {
    await page.waitForFunction(() =>
      [...document.querySelectorAll('#fig-bench .still > img')].every(
        (image) => image.complete && image.naturalWidth > 0,
      ),
    )
    await quiet(page)
    return PNG.sync.read(await gain.screenshot())
  }
  /** The brightness of most of its pixels, and of its ink. */
  const tones = ({ data }) => {
    const all = Array.from(
      { length: data.length / 4 },
      (_, i) => (data[4 * i] + data[4 * i + 1] + data[4 * i + 2]) / 3,
    ).sort((a, b) => a - b)
    const paper = all[all.length >> 1]
    return {
      paper,
      ink: Math.abs(all[0] - paper) > Math.abs(all[all.length - 1] - paper) ? all[0] : all[all.length - 1],
    }
  }
  const light = await shot()
  const day = tones(light)
  assert.ok(day.paper > 200 && day.ink < 150, JSON.stringify(day))
  await page.locator('[data-set-theme="dark"]').click()
  const dark = await shot()
  const night = tones(dark)
  assert.ok(night.paper < 50 && night.ink > 130, JSON.stringify(night))
  await page.locator('[data-set-notation="thrun"]').click()
  await page.waitForFunction(() => document.documentElement.dataset.letters === 'thrun')
  assert.ok(differenceOf(await shot(), dark).part > 0.005, 'R(k) became K')
  await page.locator('[data-set-notation="choset"]').click()
  await page.waitForFunction(() => document.documentElement.dataset.letters === 'choset')
  assert.equal(differenceOf(await shot(), dark).part, 0)
  const found = await page.evaluate(
    () => (
      getSelection().removeAllRanges(),
      find('gain R(k) and its knob g,') ? getSelection().anchorNode.parentElement.closest('figure')?.id : null
    ),
  )
  assert.equal(found, 'fig-bench')
})

/** How high a figure is, and which of its panels lie over one another. */
const laid = (page, part) =>
  page.locator('.widget').evaluate((widget, of) => {
    const boxes = [...widget.querySelectorAll(`${of} > .panel`)].map((panel) => [
      panel.getAttribute('class'),
      panel.getBoundingClientRect(),
    ])
    const over = boxes.flatMap(([name, a], i) =>
      boxes
        .slice(i + 1)
        .filter(([, b]) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1)
        .map(([other]) => `${name} and ${other}`),
    )
    return { height: widget.getBoundingClientRect().height, over }
  }, part)

for (const width of [320, 390, 768, 1280]) {
  test(`at ${width} px a still has the places and the height of the figure that comes to life`, {}, async (t) => {
    for (const at of FIGURE_PAGES) {
      let release
      const released = new Promise((resolve) => {
        release = resolve
      })
      const page = await open(t, {
        at,
        viewport: { width, height: 900 },
        prepare: (it) =>
          it.route('**/*.wasm', async (route) => {
            await released
            await route.continue()
          }),
      })
      await page.evaluate(() => document.fonts.ready)
      const still = await laid(page, '.still')
      release()
      await page.locator('.widget[data-state="live"]').waitFor()
      const live = await laid(page, '.live')
      assert.deepEqual([still.over, live.over], [[], []], at)
      // A sentence may be a line longer in the one than in the other.
      assert.ok(
        Math.abs(still.height - live.height) <= 30,
        `${at}: the still is ${still.height} px high, the figure ${live.height}`,
      )
    }
  })
}

test('a figure in a frame that is folded away keeps its drawing, and goes on where it was', async (t) => {
  const { page, it } = await openFigure(t, 'observer-bench')
  const sizes = () =>
    it.evaluate((widget) => [...widget.querySelectorAll('.live .panel')].map((panel) => panel.getAttribute('viewBox')))
  const before = await sizes()
  for (const width of ['1px', '90px']) {
    await page.locator('main').evaluate((main, to) => {
      main.style.width = to
    }, width)
    await it.getByRole('button', { name: 'Step' }).evaluate((button) => button.click())
    await quiet(page)
    assert.deepEqual(await sizes(), before, width)
    const negative = await it.evaluate(
      (widget) =>
        [...widget.querySelectorAll('.live svg [width], .live svg [height]')].filter(
          (part) => Number(part.getAttribute('width') ?? 0) < 0 || Number(part.getAttribute('height') ?? 0) < 0,
        ).length,
    )
    assert.equal(negative, 0, width)
  }
  await page.locator('main').evaluate((main) => {
    main.style.width = ''
  })
  await quiet(page)
  assert.deepEqual(await sizes(), before)
})

test('where the module cannot be fetched the figure says so, and tries again', async (t) => {
  const page = await open(t, {
    expected: [/\.wasm/, /failed to fetch|Failed to load|ERR_FAILED/i],
    prepare: (it) => it.route('**/*.wasm', (route) => route.abort()),
  })
  const bench = page.locator('observer-bench').first()
  await bench.scrollIntoViewIfNeeded()
  const again = bench.getByRole('button', { name: /try again/i })
  await again.waitFor()
  judge(await stills(page))
  assert.deepEqual(
    await bench.locator(':is(button, input, select):visible').allTextContents(),
    ['Try again'],
    'nothing else to press',
  )
  await page.unroute('**/*.wasm')
  await again.press('Enter')
  await page.locator('observer-bench[data-state="live"]').first().waitFor()
  assert.equal(await again.count(), 0)
  await page.waitForFunction(() => document.activeElement?.closest('observer-bench .live'))
})

// A figure's script is a part of the page's without a name; what tells it is a word that only it has.
const chunkOf = (word) => {
  const folder = path.join(dist, 'assets')
  const [name, ...more] = readdirSync(folder).filter(
    (file) =>
      /^[\w-]+\.js$/.test(file) &&
      !file.startsWith('page-') &&
      readFileSync(path.join(folder, file), 'utf8').includes(word),
  )
  assert.ok(name && more.length === 0, `one part holds ${word}`)
  return `**/${name}`
}

// Where the script that reloads a page is lost as well, the page is loaded again whatever is there.
for (const [what, word, reloads] of [
  ['its own script', 'Equivalent knob', false],
  ['the script of all figures', 'customElements.define(', true],
]) {
  test(`a figure without ${what} says so, and comes to life when it is there again`, async (t) => {
    const chunk = chunkOf(word)
    const page = await open(t, {
      expected: [/part-|Failed to load|ERR_FAILED/],
      prepare: (it) => it.route(chunk, (route) => route.abort()),
    })
    const bench = page.locator('observer-bench').first()
    await bench.scrollIntoViewIfNeeded()
    const again = bench.getByRole('button', { name: /try again/i })
    await again.waitFor()
    judge(await stills(page))
    // And fails again: the script is asked for once more, by this document or by the next.
    const name = chunk.slice('**/'.length)
    const lost = reloads
      ? page.waitForEvent('load')
      : page.waitForEvent('requestfailed', { predicate: (request) => request.url().endsWith(name) })
    await again.press('Enter')
    await lost
    await page.locator('observer-bench[data-state="failed"]').first().waitFor()
    await again.waitFor()
    await page.unroute(chunk)
    await again.press('Enter')
    // A browser that remembers the failure is not asked twice: the page is loaded again, at the figure.
    await page.locator('observer-bench[data-state="live"]').first().waitFor()
    assert.equal(await again.count(), 0)
    await page.waitForFunction(
      () => document.activeElement?.closest('observer-bench .live') || location.hash === '#fig-bench',
    )
    assert.ok(
      await bench.evaluate((it) => {
        const { top, bottom } = it.getBoundingClientRect()
        return top < innerHeight && bottom > 0
      }),
      'the reader is where the figure is',
    )
  })
}

test('with the script of the page lost it is a page without scripts', async (t) => {
  const page = await open(t, {
    viewport: PHONE,
    touch: true,
    expected: [/page-|Failed to load|ERR_FAILED/],
    prepare: async (it) => {
      await it.addInitScript(() => localStorage.setItem('notation', 'thrun'))
      await it.route('**/page-*.js', (route) => route.abort())
    },
  })
  await page.locator('.toc a').first().waitFor()
  assert.equal(
    await page.locator('button:visible, input:visible, select:visible').count(),
    0,
    'nothing to press that would not answer',
  )
  assert.equal(
    await page.locator('html').getAttribute('data-notation'),
    'choset',
    'the notation of the formulas in the page',
  )
  judge(await stills(page))
})

test('where there is no WebAssembly the figures are stills', async (t) => {
  const page = await open(t, {
    prepare: (it) =>
      it.addInitScript(() => {
        delete globalThis.WebAssembly
      }),
  })
  const bench = page.locator('observer-bench').first()
  await bench.scrollIntoViewIfNeeded()
  await bench.getByText(/WebAssembly/).waitFor()
  judge(await stills(page))
})

test('a figure works while it is near the screen, and the module is fetched once, when it is needed', async (t) => {
  const fetched = []
  const page = await open(t, {
    motion: 'no-preference',
    prepare: async (it) =>
      it.on('request', (request) => {
        if (request.url().endsWith('.wasm')) fetched.push(request.url())
      }),
  })
  // Before anyone scrolls, with the page at rest.
  await page.waitForLoadState('networkidle')
  assert.deepEqual(
    await page
      .locator('.widget')
      .evaluateAll((all) => all.filter((it) => it.getBoundingClientRect().top < innerHeight + 900).length),
    0,
    'no figure is near',
  )
  assert.deepEqual(fetched, [])
  const bench = page.locator('observer-bench').first()
  await bench.scrollIntoViewIfNeeded()
  await page.locator('observer-bench[data-state="live"]').first().waitFor()
  await bench.getByRole('button', { name: 'Play' }).click()
  const step = () => bench.evaluate((it) => it.frame.step)
  const start = await step()
  await page.waitForFunction((n) => document.querySelector('observer-bench').frame.step > n, start)
  // A hidden tab: here the document only says so, and frames would go on.
  const hide = (hidden) =>
    page.evaluate((it) => {
      Object.defineProperty(document, 'hidden', { configurable: true, get: () => it })
      document.dispatchEvent(new Event('visibilitychange'))
    }, hidden)
  await hide(true)
  await quiet(page)
  const hidden = await step()
  await quiet(page, 90)
  assert.equal(await step(), hidden, 'it rests while the tab is hidden')
  await hide(false)
  await page.waitForFunction((n) => document.querySelector('observer-bench').frame.step > n, hidden)
  await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight))
  await quiet(page)
  const left = await step()
  await quiet(page, 90)
  assert.ok((await step()) - left <= 1, 'it rests while it is out of sight')
  assert.equal(new Set(fetched).size, 1)
  assert.equal(fetched.length, 1)
})

test('questions and search whose scripts are lost leave nothing to press in vain, and say so', async (t) => {
  const [quizzes, search] = [chunkOf('"quiz:"'), chunkOf('search.json')]
  const page = await open(t, {
    expected: [/part-|Failed to load|ERR_FAILED/],
    prepare: async (it) => {
      for (const chunk of [quizzes, search]) await it.route(chunk, (route) => route.abort())
    },
  })
  await page.locator('.quiz').first().scrollIntoViewIfNeeded()
  await page.waitForFunction(() => document.querySelectorAll('.quiz[data-answered]').length > 0)
  assert.equal(await page.locator('.quiz button:visible').count(), 0)
  assert.ok(await page.locator('.quiz-answer summary').first().isVisible(), 'the answers can be opened')
  await page.locator('[data-open-search]').first().click()
  await page.getByText(/^The search could not be fetched/).waitFor()
})
