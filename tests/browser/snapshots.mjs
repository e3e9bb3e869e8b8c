// Pictures kept as references: compared with a tolerance, since a browser's release moves a few pixels of its text.
import assert from 'node:assert/strict'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import path from 'node:path'
import pixelmatch from 'pixelmatch'
import { PNG } from 'pngjs'
import { root } from './places.mjs'

const kept = path.join(root, 'tests/browser/snapshots')
const results = path.join(root, 'target/snapshots')
/** The part of the pixels that may differ visibly. */
const TOLERANCE = 0.02

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
    assert.fail(`${name} is ${now.width} × ${now.height}, the reference ${then.width} × ${then.height}: see target/snapshots/`)
  }
  const [width, height] = [Math.min(now.width, then.width), Math.min(now.height, then.height)]
  const [a, b] = [crop(now, width, height), crop(then, width, height)]
  const difference = new PNG({ width, height })
  const differing = pixelmatch(a.data, b.data, difference.data, width, height, { threshold: 0.2 })
  if (differing > TOLERANCE * width * height) {
    keep('now', shot)
    keep('difference', PNG.sync.write(difference))
    assert.fail(`${name} differs in ${((100 * differing) / (width * height)).toFixed(1)} % of its pixels: see target/snapshots/`)
  }
}

function crop(png, width, height) {
  if (png.width === width && png.height === height) return png
  const out = new PNG({ width, height })
  PNG.bitblt(png, out, 0, 0, width, height, 0, 0)
  return out
}
