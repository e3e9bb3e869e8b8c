// Pictures kept as references. What may differ is counted against the reference's ink: most of a figure is paper, and
// one that had lost every curve would differ in a hundredth of its pixels.
import assert from 'node:assert/strict'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import path from 'node:path'
import pixelmatch from 'pixelmatch'
import { PNG } from 'pngjs'
import { root } from './places.mjs'

const kept = path.join(root, 'tests/browser/snapshots')
const results = path.join(root, 'target/snapshots')
/**
 * The part of the ink that may differ visibly. Two runs of one browser do not differ at all; another machine's may a
 * little. A picture with much gray, as that of a map, has less colour for its ink, and may differ less.
 */
export const tolerance = (/** @type {PNG} */ whole) => Math.min(0.01, colour(whole) / 5)

/** How much of a picture's ink is coloured. */
export const colour = (/** @type {PNG} */ whole) => differenceOf(paled(whole), whole).part

/** Compares `shot` (a PNG) with the reference `name`; with UPDATE_SNAPSHOTS=1 it becomes the reference. */
export function compare(shot, name) {
  const file = path.join(kept, `${name}.png`)
  if (process.env.UPDATE_SNAPSHOTS === '1') {
    mkdirSync(kept, { recursive: true })
    writeFileSync(file, shot)
    return
  }
  assert.ok(existsSync(file), `no reference ${name}.png: UPDATE_SNAPSHOTS=1 ./scripts/test browser makes it`)
  const [now, then] = [PNG.sync.read(shot), PNG.sync.read(readFileSync(file))]
  const keep = (what, png) => {
    mkdirSync(results, { recursive: true })
    writeFileSync(path.join(results, `${name}.${what}.png`), png)
  }
  if (Math.abs(now.width - then.width) > 2 || Math.abs(now.height - then.height) > 0.03 * then.height) {
    keep('now', shot)
    assert.fail(
      `${name} is ${now.width} × ${now.height}, the reference ${then.width} × ${then.height}: see target/snapshots/`,
    )
  }
  const { part, difference } = differenceOf(now, then)
  if (part > tolerance(then)) {
    keep('now', shot)
    keep('difference', PNG.sync.write(difference))
    assert.fail(`${name} differs in ${(100 * part).toFixed(1)} % of its ink: see target/snapshots/`)
  }
}

/** How much of the ink of `then` is another in `now`, and a picture of where. */
export function differenceOf(now, then) {
  const [width, height] = [Math.min(now.width, then.width), Math.min(now.height, then.height)]
  const [a, b] = [crop(now, width, height), crop(then, width, height)]
  const difference = new PNG({ width, height })
  const differing = pixelmatch(a.data, b.data, difference.data, width, height, { threshold: 0.2 })
  return { part: differing / pixelsOf(b).inked, difference }
}

/** The reference `name`. */
export const reference = (name) => PNG.sync.read(readFileSync(path.join(kept, `${name}.png`)))

/** A picture without what is coloured in it. */
function paled(whole) {
  const pale = crop(whole, whole.width, whole.height)
  const { paper } = pixelsOf(whole)
  const pixels = new Uint32Array(pale.data.buffer, pale.data.byteOffset, pale.data.length / 4)
  for (let i = 0; i < pixels.length; i++) {
    const [red, green, blue] = [pale.data[4 * i], pale.data[4 * i + 1], pale.data[4 * i + 2]]
    if (Math.max(red, green, blue) - Math.min(red, green, blue) > 50) pixels[i] = paper
  }
  return pale
}

/** How many pixels are not of the background, the colour most of them have. */
function pixelsOf({ data }) {
  const counts = new Map()
  const pixels = new Uint32Array(data.buffer, data.byteOffset, data.length / 4)
  for (let i = 0; i < pixels.length; i++) counts.set(pixels[i], (counts.get(pixels[i]) ?? 0) + 1)
  const [paper, count] = [...counts].reduce((most, entry) => (entry[1] > most[1] ? entry : most))
  return { paper, inked: pixels.length - count }
}

function crop(png, width, height) {
  const out = new PNG({ width, height })
  PNG.bitblt(png, out, 0, 0, width, height, 0, 0)
  return out
}
