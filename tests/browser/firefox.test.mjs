// The second engine: every widget comes alive, moves and keeps its digits in Firefox, without a complaint, driven over
// WebDriver BiDi with the keyboard. Skipped where there is no Firefox (FIREFOX names one that is not in the usual
// places).
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { once } from 'node:events'
import { createServer } from 'node:http'
import { createRequire } from 'node:module'
import path from 'node:path'
import { FIGURES } from '../../target/figures.js'
import { carFrames, carStates, framesThere } from './car-frames.mjs'
import { alive, browser, complaints, firefox, go, page, site, wait, waitIn } from './firefox.mjs'
import { holdReplays } from './held-replays.mjs'
import { root, tagOf } from './places.mjs'

const notice = 'no Firefox here; Debian: apt-get install firefox-esr'
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

// Before any test, since cargo may have to compile it, or to wait for another cargo: no test's time is spent on that.
const native = firefox
  ? execFileSync('cargo', ['run', '--quiet', '--locked', '--example', 'digests', '-p', 'labs'], {
      cwd: root,
      encoding: 'utf8',
    })
  : ''

for (const tag of ['odometry-hook', 'observer-bench', 'observability-probe']) {
  test(`${tag} steps in Firefox`, { skip: firefox ? false : notice }, async () => {
    await alive(tag)
    const step = await page.evaluate((name) => document.querySelector(name).frame.step, tag)
    await page.evaluate(
      (name) =>
        [...document.querySelectorAll(`${name} .live button`)].find((button) => button.textContent === 'Step').focus(),
      tag,
    )
    await page.keyboard.press('Enter')
    await wait((name, n) => document.querySelector(name).frame.step > n, tag, step)
  })
}

test('the keys turn the knob in Firefox', { skip: firefox ? false : notice }, async () => {
  await alive('observer-bench')
  await page.evaluate(() => document.querySelector('observer-bench .live input[type=range]').focus())
  const gain = await page.evaluate(() => document.querySelector('observer-bench').frame.params.gain)
  await page.keyboard.press('ArrowRight')
  await wait((g) => document.querySelector('observer-bench').frame.params.gain > g, gain)
})

test('the keys move the prediction of the picture in Firefox, to the frame that Node computes', {
  skip: firefox ? false : notice,
}, async () => {
  await alive('picture')
  await page.evaluate(() => document.querySelector('lab-picture .live [role=slider][aria-label="Prediction"]').focus())
  const {
    mean: [x],
  } = await page.evaluate(() => document.querySelector('lab-picture').frame.params)
  await page.keyboard.press('ArrowRight')
  await wait((from) => {
    const { frame, settled } = document.querySelector('lab-picture')
    return settled && frame.params.mean[0] > from
  }, x)
  const there = await page.evaluate(() => document.querySelector('lab-picture').frame)
  const lab = new core.Picture()
  lab.set(there.params)
  assert.deepEqual(there, lab.frame())
})

for (const [name, lab, handle] of [
  ['tune', 'Tune', 'The filter’s noise'],
  ['loop-closure', 'LoopClosure', 'Gate'],
]) {
  test(`the keys drive ${name} in Firefox, to the frame that Node computes`, {
    skip: firefox ? false : notice,
  }, async () => {
    // On its own page no question locks it.
    await go(`figure/${name}/`)
    const tag = tagOf(name)
    await alive(tag)
    const button = await page.evaluateHandle(
      (name) =>
        [...document.querySelectorAll(`${name} .live button`)].find(({ textContent }) => textContent === 'Step') ??
        null,
      tag,
    )
    if (button.asElement()) {
      await page.evaluate((step) => step.focus(), button)
      for (let step = 1; step <= 3; step++) {
        await page.keyboard.press('Enter')
        await wait((name, n) => document.querySelector(name).frame.step === n, tag, step)
      }
    } else {
      assert.equal(name, 'tune', 'it has no steps')
    }
    const before = await page.evaluate((name) => JSON.stringify(document.querySelector(name).frame.params), tag)
    await page.evaluate(
      (name, label) => document.querySelector(`${name} .live [role=slider][aria-label="${label}"]`).focus(),
      tag,
      handle,
    )
    await page.keyboard.press('ArrowRight')
    await wait(
      (name, was) => {
        const { frame, settled } = document.querySelector(name)
        return settled && JSON.stringify(frame.params) !== was
      },
      tag,
      before,
    )
    const [state, frame] = await page.evaluate((name) => {
      const { state, frame } = document.querySelector(name)
      return [state, frame].map((one) => JSON.stringify(one))
    }, tag)
    assert.deepEqual(JSON.parse(frame), JSON.parse(JSON.stringify(core[lab].from(JSON.parse(state)).frame())))
  })
}

test('a figure lives in a sandboxed frame of another origin in Firefox, and tells its height', {
  skip: firefox ? false : notice,
}, async () => {
  const src = `${site.url}figure/observer-bench/`
  const html = `<!doctype html><title>Somebody else's page</title>
    <iframe src="${src}" title="A figure" sandbox="allow-scripts" width="800" height="900"></iframe>
    <script>heights = []; addEventListener('message', ({ data }) => heights.push(data.height))</script>`
  const server = createServer((_, response) =>
    response.writeHead(200, { 'content-type': 'text/html' }).end(html),
  ).listen(0, '127.0.0.1')
  await once(server, 'listening')
  const other = await browser.newPage()
  try {
    other.on('console', (message) => {
      if (message.type() === 'error') complaints.push(message.text())
    })
    const { port } = /** @type {import('node:net').AddressInfo} */ (server.address())
    await other.goto(`http://127.0.0.1:${port}/`)
    const frame = other.frames()[1]
    await waitIn(frame, () => document.querySelector('observer-bench').settled)
    assert.equal(await frame.evaluate(() => self.origin), 'null')
    await frame.evaluate(() => document.querySelector('observer-bench .live input[type=range]').focus())
    const gain = await frame.evaluate(() => document.querySelector('observer-bench').frame.params.gain)
    await other.keyboard.press('ArrowRight')
    await waitIn(frame, (g) => document.querySelector('observer-bench').frame.params.gain > g, gain)
    assert.ok((await other.evaluate(() => heights)).every((height) => Number.isInteger(height) && height > 300))
  } finally {
    await other.close()
    server.closeAllConnections()
    server.close()
  }
})

test('no formula has to be scrolled in Firefox', { skip: firefox ? false : notice }, async () => {
  const wide = await page.evaluate(async () => {
    document.querySelectorAll('main > article > section').forEach((part) => {
      part.style.contentVisibility = 'visible'
    })
    await document.fonts.ready
    for (let i = 0; i < 3; i++) await new Promise((resolve) => requestAnimationFrame(resolve))
    const wide = [...document.querySelectorAll('.equation-body')]
      .filter((box) => box.scrollWidth > box.clientWidth + 1)
      .map((box) => box.textContent.slice(0, 60))
    document.querySelectorAll('main > article > section').forEach((part) => {
      part.style.contentVisibility = ''
    })
    return wide
  })
  assert.deepEqual(wide, [])
})

const digests = native
  .trim()
  .split('\n')
  .map((line) => line.split(' '))

test('10,000 rows of the log have the same hash in a worker of Firefox', {
  skip: firefox ? false : notice,
}, async () => {
  const runs = digests.filter(([name]) => name === 'robot-log')
  assert.ok(runs.length > 0)
  for (const [name, hash, given] of runs) {
    const code = Buffer.from(JSON.stringify([1, name, 10_000, JSON.parse(given)])).toString('base64url')
    await go(`figure/${name}/?fig-log=${code}`)
    await alive(name)
    await wait(() => document.querySelector('robot-log').frame?.step === 10_000)
    assert.equal(await page.evaluate(() => document.querySelector('robot-log').figure.run.digest), hash, given)
  }
})

test('the car’s log has the frames in Firefox that Node computes, to the bit', {
  skip: firefox ? false : notice,
}, async () => {
  await go('figure/car-log/')
  await alive('car-log')
  assert.deepEqual(JSON.parse(await page.evaluate(framesThere, carStates)), carFrames())
})

test('10,000 steps have the same hash in Firefox', { skip: firefox ? false : notice }, async () => {
  // Those over a log are compared above.
  const shown = (/** @type {string[]} */ [name]) => !FIGURES.find((figure) => figure.name === name).world
  let shownOn
  for (const [name, hash, given] of digests.filter(shown)) {
    // On its own page, since not every figure is in the chapter.
    if (shownOn !== name) await go(`figure/${name}/`)
    shownOn = name
    await alive(name)
    const there = await page.evaluate(
      (tag, params) => {
        const lab = new (document.querySelector(tag).figure.lab.constructor)(params)
        lab.run(10_000)
        return lab.digest()
      },
      tagOf(name),
      JSON.parse(given),
    )
    assert.equal(there, hash, `${name} with ${given}`)
  }
})

test('in Firefox a log that is dropped is filtered in a worker, and a long replay is given up', {
  skip: firefox ? false : notice,
}, async () => {
  await go('log/')
  await alive('robot-log')
  const drop = (name, rows) =>
    page.evaluate(
      (file, parts) => {
        const data = new DataTransfer()
        data.items.add(
          new File(
            [
              typeof parts === 'string'
                ? parts
                : `L,1,0,10\n${Array.from({ length: parts }, (_, i) => `O,${i},0.1,0.01\nR,${i},1,10\n`).join('')}`,
            ],
            file,
          ),
        )
        document
          .querySelector('h1')
          .dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
      },
      name,
      rows,
    )
  const shows = (rows) =>
    wait((n) => {
      const { frame, settled } = document.querySelector('robot-log')
      return settled && frame.rows === n
    }, rows)
  await wait(() => !!document.querySelector('.log-example a[href]'))
  await drop('small.csv', 'L,7,3,4\nO,0.5,0.1,0.02\nR,0.5,7,4.9\nO,1,0.1,0\nR,1,7,4.8\n')
  await shows(4)
  await page.evaluate(() => document.querySelector('robot-log .live input[type=checkbox]').focus())
  for (const used of [0, 2]) {
    await page.keyboard.press(' ')
    await wait((n) => {
      const { frame, settled } = document.querySelector('robot-log')
      return settled && frame.params.sightings === n > 0 && frame.summary.used === n
    }, used)
  }
  await drop('broken.csv', 'O,0,0,0\nO,1,x,0\n')
  await wait(() => document.querySelector('.log-answer').textContent.includes('broken.csv, line 2, character 5'))
  await page.evaluate(holdReplays)
  await drop('long.csv', 900_000)
  await wait(() => !!document.querySelector('robot-log .progress:not([hidden])'))
  await page.evaluate(() => document.querySelector('robot-log .progress button').click())
  await shows(4)
})

test('Firefox had nothing to complain about', { skip: firefox ? false : notice }, async () => {
  // While the page still streams in, Firefox may lay a formula out between one of its children and the next, and says
  // so. What counts is the page as it stands.
  const parts = { msub: 2, msup: 2, msubsup: 3, mfrac: 2, munder: 2, mover: 2, munderover: 3 }
  const half = (complaint) =>
    Object.keys(parts).some((tag) => complaint.includes(`Incorrect number of children for <${tag}/>`))
  assert.deepEqual(
    complaints.filter((complaint) => !half(complaint)),
    [],
  )
  const lacking = await page.evaluate(
    (wanted) =>
      Object.entries(wanted).flatMap(([tag, count]) =>
        [...document.querySelectorAll(tag)].filter((one) => one.children.length !== count),
      ).length,
    parts,
  )
  assert.equal(lacking, 0)
})
