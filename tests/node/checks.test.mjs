// The chapter's checks on the module that readers get: each passes, prints what the text prints, and is the same asked
// for alone. What `tests/thirteen_checks.rs` asserts of exact values is asserted of the same code there.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { estimate } from './claims.mjs'

const printed = JSON.parse(readFileSync(new URL('../printed_by_checks.json', import.meta.url), 'utf8'))

test('each check passes in the shipped module, and its numbers are those that the text prints', () => {
  const all = estimate.chapterChecks()
  assert.deepEqual(
    all.map(({ id }) => id),
    Array.from({ length: 13 }, (_, i) => i + 1),
  )
  for (const { id, passed, actual, title } of all) {
    assert.ok(passed, title)
    if (!(id in printed)) continue
    const { of, from, numbers } = printed[id]
    assert.equal(actual.length, of, title)
    numbers.forEach((number, i) =>
      assert.ok(Math.abs(actual[from + i] - number) <= 1e-3, `${title}: ${actual[from + i]} is printed ${number}`),
    )
  }
  // Two ways of computing Jacobians agree within a tolerance, and no text prints their gaps.
  assert.deepEqual(
    all.map(({ id }) => id).filter((id) => !(id in printed)),
    [8],
  )
})

test('one check by its number is that check of the thirteen, to the last bit', () => {
  for (const check of estimate.chapterChecks()) assert.deepEqual(estimate.chapterCheck(check.id), check)
  for (const id of [0, 14, -1, 2 ** 40])
    assert.throws(() => estimate.chapterCheck(id), { name: 'EstimateError', code: 'index', argument: 'id' })
  for (const id of ['1', null, undefined, 1.5])
    assert.throws(() => estimate.chapterCheck(id), { name: 'EstimateError', code: 'type', argument: 'id' })
})
