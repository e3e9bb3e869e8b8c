/**
 * Where the reader writes: the names that the world gives, the text with its marks, its faults, and why it is judged as
 * it is. What is typed goes to the lab when typing rests; until its answer is there, the marks are those of the text
 * before.
 */

import { button, part } from '../../draw/dom.js'
import { buildCopies } from './copies.js'
import { faultOf, keep, last, textOf } from './kept.js'
import { GROUPS, isBegin, opened, stepsOf } from './programs.js'
import { isEmpty, isRiddle, lacks, reasons } from './words.js'

/** Typing rests after this long, milliseconds. */
const REST_MS = 300
/** Lines that the box has at least, and the most before it scrolls. */
const [LEAST, MOST] = [9, 22]
const LETTERS = /** @type {const} */ ([
  ['choset', 'Choset’s'],
  ['thrun', 'Thrun’s'],
  ['common', 'the common ones'],
])

/** @typedef {import('estimate-wasm').WriteFrame} Frame */
/** @typedef {import('estimate-wasm').WriteParams} Params */
/** @typedef {import('./kept.js').Own} Own */
/**
 * @typedef {(patch: Record<string, unknown>, make?: (frame: any, lab: any) => Record<string, unknown>) => void} Change
 */

/** @param {Document} document @param {Change} change */
export function buildEditor(document, change) {
  const element = document.createElement('div')
  element.setAttribute('class', 'write-editor')
  const names = part(document, element, 'p', 'write-names')
  const row = part(document, element, 'div', 'write-row')
  const begin = choice(document, row, 'Begin with', GROUPS)
  begin.addEventListener('change', () => {
    const chosen = begin.value
    if (isBegin(chosen)) change({ ...opened(chosen), ...textOf(chosen) })
  })
  const letters = choice(document, row, 'Letters', [{ group: '', programs: LETTERS }])
  letters.addEventListener('change', () => change({ notation: letters.value }))
  const box = part(document, element, 'div', 'write-box')
  const gutter = part(document, box, 'pre', 'write-gutter')
  gutter.setAttribute('aria-hidden', 'true')
  const area = /** @type {HTMLTextAreaElement} */ (part(document, box, 'textarea', 'write-text'))
  for (const [name, value] of Object.entries({
    'aria-label': 'The program, a formula on each line',
    wrap: 'off',
    spellcheck: 'false',
    autocapitalize: 'off',
    autocomplete: 'off',
    autocorrect: 'off',
    maxlength: '2000',
  }))
    area.setAttribute(name, value)
  const fold = part(document, element, 'p', 'write-row')
  /** The text that “As it began” took away, until another is typed. @type {{ begin: string, own: Own } | null} */
  let taken = null
  const isBack = (/** @type {Params} */ { begin, text }) => text === null && taken?.begin === begin
  const anew = button(
    document,
    fold,
    'As it began',
    () => {
      change({}, ({ params: { begin, text, notation } }) => {
        const held = taken
        const back = text === null && held && held.begin === begin ? held.own : null
        taken = text === null ? null : { begin, own: { text, notation } }
        keep(begin, back)
        return back ?? { text: null }
      })
    },
    'quiet',
  )
  const faults = part(document, element, 'ol', 'write-faults')
  const why = part(document, element, 'div', 'write-why')
  const inOthers = buildCopies(document, element, change)

  /** What the box holds, by the parameters it came from or went to. */
  let shown = ''
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let resting
  /** @type {Frame | null} */
  let frame = null

  const send = () => {
    clearTimeout(resting)
    resting = undefined
    const [text, fault] = [area.value, faultOf(area.value)]
    if (fault !== '') return list([{ line: 1, column: 1, message: fault }])
    change({}, ({ params }) => {
      shown = keyOf({ ...params, text })
      keep(params.begin, { text, notation: params.notation })
      return { text }
    })
  }
  area.addEventListener('input', () => {
    taken = null
    fit(area.value)
    clearTimeout(resting)
    resting = setTimeout(send, REST_MS)
  })
  area.addEventListener('change', () => {
    if (resting !== undefined) send()
  })
  area.addEventListener('scroll', () => {
    gutter.scrollTop = area.scrollTop
  })

  /** The numbers of the lines, those of faults marked. @param {string} text @param {Frame | null} [of] */
  function fit(text, of = null) {
    const count = text.split('\n').length
    area.setAttribute('rows', String(Math.min(MOST, Math.max(LEAST, count + 1))))
    const wrong = new Set(of === null || isEmpty(of) || lacks(of) ? [] : of.faults.map(({ line }) => line))
    const told = of && of.faults.length === 0 && of.outcome !== 'right' && !isRiddle(of)
    if (told && of.line !== null) wrong.add(of.line)
    gutter.replaceChildren(
      ...Array.from({ length: count }, (_, i) => {
        const mark = document.createElement('span')
        if (wrong.has(i + 1)) mark.setAttribute('class', 'is-wrong')
        mark.textContent = `${wrong.has(i + 1) ? '▸' : ' '}${String(i + 1).padStart(2)}\n`
        return mark
      }),
    )
  }

  /** @param {{ line: number, column: number, message: string }[]} all @param {boolean} [placed] */
  function list(all, placed = true) {
    faults.replaceChildren(
      ...all.map(({ line, column, message }) => {
        const one = document.createElement('li')
        if (placed) part(document, one, 'b', '').textContent = `Line ${line}, column ${column}: `
        one.append(message)
        return one
      }),
    )
  }

  if (typeof window !== 'undefined') watch(element, change)
  return {
    element,
    /** @param {Params} params @param {Frame} now */
    show(params, now) {
      choose(begin, params.begin)
      choose(letters, params.notation)
      anew.hidden = params.text === null && !isBack(params)
      anew.textContent = isBack(params) ? 'Back to yours' : 'As it began'
      // While a run is computed the frame is older than what was asked for.
      if (keyOf(now.params) !== keyOf(params)) return
      inOthers.show(now)
      const key = keyOf(params)
      if (key !== shown && resting === undefined) {
        shown = key
        if (area.value !== now.text || area.textContent === '') {
          area.textContent = now.text
          area.value = now.text
        }
      }
      if (frame !== null && keyOf(frame.params) === key && frame.stopped?.message === now.stopped?.message) return
      frame = now
      if (resting === undefined) fit(now.text, now)
      writeNames(document, names, now)
      list(isEmpty(now) ? [] : now.faults, !lacks(now))
      why.replaceChildren()
      for (const words of reasons(now)) part(document, why, 'p', '').textContent = words
      if (now.faults.length > 0 && !isEmpty(now) && !lacks(now)) area.setAttribute('aria-invalid', 'true')
      else area.removeAttribute('aria-invalid')
    },
  }
}

/** Which program the parameters say. @param {Params} params */
const keyOf = ({ begin, text, notation }) => JSON.stringify([begin, text, notation])

/**
 * Follows the page: the address names a program, the browser has kept one, and the page's letters change.
 * @param {HTMLElement} element @param {Change} change
 */
function watch(element, change) {
  const named = (/** @type {string} */ address) => new URL(address, location.href).searchParams.get('program')
  const open = (/** @type {string | null} */ name) => {
    if (!isBegin(name)) return false
    const exercise = GROUPS.slice(2).some(({ programs }) => programs.some(([begin]) => begin === name))
    change({ ...opened(name), ...(exercise ? textOf(name) : null) })
    return true
  }
  const state = [...new URL(location.href).searchParams.keys()].some((key) => key.startsWith('fig-'))
  if (!state && !open(named(location.href))) {
    const before = last()
    const own = before && textOf(before)
    if (before && own) change({ begin: before, ...own, step: stepsOf(before) })
  }
  document.addEventListener('click', (event) => {
    const link = /** @type {Element | null} */ (event.target)?.closest?.('a')
    if (!element.isConnected || !link || link.origin + link.pathname !== location.origin + location.pathname) return
    if (event.ctrlKey || event.metaKey || event.shiftKey || !open(named(link.href))) return
    event.preventDefault()
    element.closest('figure')?.scrollIntoView({ block: 'start' })
    element.querySelector('textarea')?.focus({ preventScroll: true })
  })
  const root = document.documentElement
  let page = 'choset'
  const follow = () => {
    const notation = root.dataset.notation ?? 'choset'
    if (notation === page) return
    page = notation
    change({}, ({ params }, lab) =>
      params.notation === notation ? {} : { notation, text: params.text === null ? null : lab.textIn(notation) },
    )
  }
  new MutationObserver(follow).observe(root, { attributeFilter: ['data-notation'] })
  follow()
}

/** @param {Document} document @param {Element} into @param {Frame} frame */
function writeNames(document, into, { given, world, params }) {
  const code = (/** @type {string} */ words) => {
    const name = document.createElement('code')
    name.textContent = words
    return name
  }
  const [x, p] = given
  const nu = params.notation === 'choset' ? 'nu, S and R' : 'nu, S and K'
  const [typed, printed] = params.notation === 'thrun' ? ["A Sigma A'", 'AΣAᵀ'] : ["F P F'", 'FPFᵀ']
  into.replaceChildren(
    'Given: ',
    ...given.flatMap(({ name, about, size }, i) => {
      const one = code(name)
      one.setAttribute('title', about)
      return [i > 0 ? ', ' : '', one, ` ${size.replace(/\((.*)\)/, '$1')}`]
    }),
    world === 'linear' ? ' (n states, p readings, m inputs)' : ', f(x, u), h(x, l)',
    '. Make the new ',
    code(x.name),
    ' and ',
    code(p.name),
    `; ${nu} count if they are named. Type ${typed} with blanks for ${printed}, inv(S) for S⁻¹, # before a remark.`,
  )
}

/**
 * @param {Document} document @param {Element} into @param {string} words
 * @param {readonly { group: string, programs: readonly (readonly [string, string])[] }[]} groups
 */
function choice(document, into, words, groups) {
  const label = part(document, into, 'label', 'control')
  part(document, label, 'span', 'control-name').textContent = words
  const input = /** @type {HTMLSelectElement} */ (part(document, label, 'select', ''))
  for (const { group, programs } of groups) {
    const under = group === '' ? input : part(document, input, 'optgroup', '')
    if (group !== '') under.setAttribute('label', group)
    for (const [value, name] of programs) {
      const option = part(document, under, 'option', '')
      option.setAttribute('value', value)
      option.textContent = name
    }
  }
  return input
}

/** @param {HTMLSelectElement} input @param {string} value */
function choose(input, value) {
  for (const option of input.querySelectorAll('option'))
    option.toggleAttribute('selected', option.getAttribute('value') === value)
  if (input.value !== value) input.value = value
}
