/** The program in other languages, behind a fold: written when it opens, with the run's first steps as its test. */

import { button, part } from '../../draw/dom.js'
import { copied } from '../../figure/clipboard.js'

/** @typedef {import('estimate-wasm').WriteFrame} Frame */
/** @typedef {import('estimate-wasm').WriteWorld} World */
/** @typedef {import('./copy.js').Copy} Copy */

/** @param {Document} document @param {Element} into @param {import('./editor.js').Change} change */
export function buildCopies(document, into, change) {
  const fold = /** @type {HTMLDetailsElement} */ (part(document, into, 'details', 'more write-copies'))
  part(document, fold, 'summary', '').textContent = 'Copy as Rust, JavaScript, numpy, MATLAB or C'
  const inside = part(document, fold, 'div', '')
  const said = part(document, inside, 'p', 'write-said')
  said.setAttribute('role', 'status')
  const row = part(document, inside, 'div', 'write-row')
  const label = part(document, row, 'label', 'control')
  part(document, label, 'span', 'control-name').textContent = 'Language'
  const language = /** @type {HTMLSelectElement} */ (part(document, label, 'select', ''))
  const area = /** @type {HTMLTextAreaElement} */ (part(document, inside, 'textarea', 'own-code'))
  area.setAttribute('aria-label', 'The program in that language')
  area.setAttribute('readonly', '')
  area.setAttribute('rows', '12')
  area.setAttribute('wrap', 'off')
  for (const one of [row, area]) one.setAttribute('hidden', '')
  /** @type {Copy[]} */
  let all = []
  /** Counts what was asked for: an answer to an earlier question is none. */
  let asked = 0

  const chosen = () => all[Math.max(0, language.selectedIndex)]
  const show = () => {
    const copy = chosen()
    area.value = copy?.text ?? ''
    row.hidden = area.hidden = copy === undefined
    if (!copy) return
    const steps = copy.steps === 1 ? 'step' : `${copy.steps} steps`
    said.textContent = `${copy.file}: its test is the first ${steps} of this run.`
  }
  language.addEventListener('change', show)
  button(
    document,
    row,
    'Copy',
    async () => {
      area.select()
      said.textContent = (await copied(area.value)) ? `${chosen()?.file} is copied.` : 'Press the keys for copying.'
    },
    'quiet',
  )

  const ask = () =>
    change({}, (frame, lab) => {
      write(frame, lab.world())
      return {}
    })

  /** @param {Frame} frame @param {World} world */
  async function write(frame, world) {
    const which = (asked += 1)
    const { copies, why } = await copiesOf(frame, world).catch(failed)
    if (which !== asked) return
    const before = language.selectedIndex
    all = copies
    language.replaceChildren()
    for (const copy of copies) part(document, language, 'option', '').textContent = copy.label
    if (copies[before]) language.selectedIndex = before
    said.textContent = why
    show()
  }

  let shown = ''
  fold.addEventListener('toggle', () => {
    shown = ''
    if (fold.open) ask()
  })
  return {
    /** Another program, or another world. @param {Frame} frame */
    show({ text, params }) {
      const key = JSON.stringify([text, params.notation, params.begin, params.seed])
      if (!fold.open || key === shown) return
      shown = key
      ask()
    },
  }
}

/** What is said where a script does not come. @param {Error} error */
const failed = ({ message }) => ({ copies: /** @type {Copy[]} */ ([]), why: `Nothing can be copied: ${message}.` })

/** @param {Frame} frame @param {World} world @returns {Promise<ReturnType<typeof import('./copy.js').copies>>} */
async function copiesOf({ text, params, world: kind }, world) {
  // Only a browser has the build, and few readers ask for a copy.
  const [{ copies }, { loadLab }] = await Promise.all([import('./copy.js'), import('../../load/modules.js')])
  const loaded = await loadLab('write-filter')
  if (!loaded.ok) return { copies: [], why: `Nothing can be copied: ${loaded.why}.` }
  const program = new loaded.module.Program(text, { notation: params.notation, world: kind })
  try {
    return copies(program, text, worldOfCopy(world))
  } finally {
    program.free()
  }
}

/** A lab's world as a copy has it. @param {World} world @returns {import('./copy/frame.js').World} */
export const worldOfCopy = ({ system, belief, steps }) =>
  /** @type {any} */ ({ system: given(system), belief, steps: steps.map(given) })

/** Without what is null. @template T @param {T} fields */
const given = (fields) =>
  Object.fromEntries(Object.entries(/** @type {any} */ (fields)).filter(([, value]) => value !== null))
