/** The values that a lab gives its parameters. A phrase to try sets by them what another phrase has changed. */

/**
 * @param {any} lab @param {string[]} names none: of all parameters
 * @returns {Record<string, unknown>}
 */
export function usual(lab, ...names) {
  const all = /** @type {import('estimate-wasm').Parameter[]} */ (lab.constructor.parameters())
  return Object.fromEntries(
    all
      .filter(({ name }) => names.length === 0 || names.includes(name))
      .map(({ name, default: value }) => [name, value]),
  )
}
