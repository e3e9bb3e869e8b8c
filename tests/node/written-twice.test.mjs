// Numbers that Rust and JavaScript both need stand in each of them once, and are the same.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { SEEDS } from '../../web/figure/ensemble.js'
import { LAST_STEP, MOST_STEPS } from '../../web/figure/state-in-url.js'

/** The number that a constant of a Rust file is. @param {string} file below crates @param {string} name */
function constant(file, name) {
  const text = readFileSync(new URL(`../../crates/${file}`, import.meta.url), 'utf8')
  return Number(new RegExp(`const ${name}: u32 = ([\\d_]+);`).exec(text)?.[1].replaceAll('_', ''))
}

test('the last step of a lab, that of a log, and the seeds of an ensemble are those of the core', () => {
  assert.deepEqual(
    { LAST_STEP, MOST_STEPS, SEEDS },
    {
      LAST_STEP: constant('lab/src/lab.rs', 'MAX_STEP'),
      MOST_STEPS: constant('labs/src/robot_log.rs', 'LAST_STEP'),
      SEEDS: constant('labs/src/ensemble.rs', 'SEEDS'),
    },
  )
})
