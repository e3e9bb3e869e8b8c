/** A figure's state in an address, with its version and to the last digit; what is read from an address is checked. */

export const VERSION = 1
/** The last step that a lab runs to. */
export const LAST_STEP = 100_000
/** The last step of any lab: a log may be longer. */
export const MOST_STEPS = 2_000_000
const MAX_LENGTH = 7000

/** @typedef {{ version: number, lab: string, params: Record<string, unknown>, step: number }} State */

/**
 * The page's address with this figure's state in it, and in no other way changed.
 * @param {string} address
 * @param {string} figure the figure's id
 * @param {State} state
 */
export function withState(address, figure, state) {
  const url = new URL(address)
  const bytes = new TextEncoder().encode(JSON.stringify([state.version, state.lab, state.step, state.params]))
  const text = btoa(String.fromCharCode(...bytes))
    .replace(/\+/g, '-')
    .replace(/\//g, '_')
    .replace(/=+$/, '')
  url.searchParams.set(figure, text)
  url.hash = figure
  return url.href
}

/**
 * The state an address holds for a figure: `null` when there is none, `'mangled'` when there is one that cannot be
 * read. The lab itself still decides whether it accepts the parameters.
 * @param {string} address
 * @param {string} figure
 * @param {string} [lab] any if not given
 * @returns {State | null | 'mangled'}
 */
export function readState(address, figure, lab) {
  const text = new URL(address).searchParams.get(figure)
  if (text === null) return null
  if (text.length > MAX_LENGTH || !/^[\w-]+$/.test(text)) return 'mangled'
  try {
    const bytes = Uint8Array.from(atob(text.replace(/-/g, '+').replace(/_/g, '/')), (letter) => letter.charCodeAt(0))
    const value = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes))
    if (!Array.isArray(value) || value.length !== 4) return 'mangled'
    const [version, name, step, params] = value
    const whole = Number.isInteger(step) && step >= 0 && step <= MOST_STEPS
    const object = typeof params === 'object' && params !== null && !Array.isArray(params)
    if (version !== VERSION || (lab !== undefined && name !== lab) || !whole || !object) return 'mangled'
    return { version, lab: name, step, params }
  } catch {
    return 'mangled'
  }
}
