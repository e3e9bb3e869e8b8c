// What the cart and its copy say of innovation, nudge and error is true of their frames.
import { check, pattern, prints } from './claims.mjs'

/** Whether words such as “1.00 m/s too fast and 0.20 m behind” say how the copy stands. */
function stands(words, [position, speed]) {
  const said = (/** @type {RegExp} */ form, value, below) => {
    const [, size, word] = form.exec(words) ?? []
    return size ? prints(size, Math.abs(value)) && (word === below) === value < 0 : Math.abs(value) < 0.005
  }
  return said(/([\d.]+) m\/s too (slow|fast)/, speed, 'slow') && said(/([\d.]+) m (behind|ahead)/, position, 'behind')
}

check(
  'cart-copy',
  { position: [-1.5, -1, 0, 0.6], speed: [-1.5, 0, 0.25, 1], gain: [0, 0.5, 1, 3, 5], phase: [0, 6] },
  [0, 1, 2, 7, 300],
  () => [
    [
      /^The copy does what the cart does, and the innovation is 0\.$/,
      ({ error, innovation }) => Math.hypot(...error) < 0.008 && Math.abs(innovation) < 0.01,
    ],
    [/^Both speedometers show the same\.$/, ({ reading, expected }) => Math.abs(reading - expected) < 0.005],
    [
      /^The innovation is 0, so nothing is nudged: the copy stays (.+), whatever the gain\.$/,
      ({ error, nudge }, words) => stands(words, [error[0], 0]) && Math.hypot(...nudge) < 0.01 * 5,
    ],
    [/^The copy is (?:now )?(.+)\.$/, ({ error }, words) => stands(words, error)],
    [/^Press Step: both drive, you compare, the copy is nudged\.$/, ({ step, nudge }) => step === 0 && nudge[0] === 0],
    [
      /^The innovation is (\S+) m\/s, and at gain 0 nothing is nudged\.$/,
      ({ innovation, params, nudge }, said) => prints(said, innovation) && params.gain === 0 && nudge[1] === 0,
    ],
    [/^The innovation was (\S+) m\/s\.$/, ({ innovation, step }, said) => prints(said, innovation) && step > 0],
    [
      pattern(
        /^The nudge is K times that: (\S+) of it, (\S+) m\/s, for the copy’s speed, /,
        /and (\S+) m for its position\.$/,
      ),
      ({ nudge, K }, part, speed, position) =>
        prints(part, K[1]) && prints(speed, nudge[1]) && prints(position, nudge[0]),
    ],
  ],
)
