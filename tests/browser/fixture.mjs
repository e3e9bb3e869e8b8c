// For tests of what a page does, whatever stands on it: `open` opens a chapter of two sections, a tenth of the real
// one.
import { serveInstead } from './harness.mjs'
import { fixture } from './places.mjs'

export * from './harness.mjs'

serveInstead(fixture)
