/** What a sign between two matrices means, in MATLAB and in numpy. */

import { added, combined, divided, inverse, isScalar, times } from './matrices.js'
import { Fault, refuse } from './number.js'

/** @typedef {number[][]} Matrix */
/** @typedef {import('./expression.js').Scope} Scope */

const OLD = '“*” is a product for np.matrix, and goes entry by entry for np.array; write @ or np.multiply(…).'

/** With numpy `*` goes entry by entry. @param {Matrix} a @param {Matrix} b @param {string} sign @param {Scope} scope */
export function multiplied(a, b, sign, { numpy, old }) {
  const scaled = isScalar(a) || isScalar(b)
  if (sign === '@') return times(a, b)
  if (sign.endsWith('*')) {
    if (old && !scaled) throw new Fault(OLD)
    if (sign === '.*' || numpy || scaled) return combined(a, b, (x, y) => x * y, 'product')
    return times(a, b)
  }
  if (sign.endsWith('\\')) {
    if (numpy) refuse(sign)
    return sign === '.\\' || isScalar(a) ? divided(b, a) : times(inverse(a), b)
  }
  return sign === './' || numpy || isScalar(b) ? divided(a, b) : times(a, inverse(b))
}

/** What `Q += …` makes of Q. @param {Matrix} before @param {Matrix} by @param {string} sign @param {Scope} scope */
export function changed(before, by, sign, scope) {
  const after = /[-+]/.test(sign) ? added(before, by, sign) : multiplied(before, by, sign, scope)
  const [one, other] = [before, after].map((m) => `${m.length} × ${m[0].length}`)
  if (one === other || isScalar(before)) return after
  throw new Fault(`a change may not make a ${other} matrix of a ${one}.`)
}
