/**
 * Where the reader types or pastes a system. What is typed goes to the lab as soon as it is a system; until then the
 * fault is named and the figure keeps the last one.
 */

import { button, part } from '../../draw/dom.js'
import { writeHtml } from '../../draw/words.js'
import { buildBoxes } from './boxes.js'
import { javascript, numpy, rust } from './copy-as.js'
import { choose, select, textBox, write } from './fields.js'
import { buildGrid } from './grid.js'
import { givenName, lettersOf } from './names.js'
import { MATRICES, MOST, PRESETS, paramsOf, partOf, runOf, sizeOf } from './presets.js'
import { buildQuestion, buildTime } from './time.js'
import { faultOf, numberOf } from './number.js'
import { grown, keyOf, same, wordsOf } from './typed-system.js'

/**
 * @typedef {(patch: Record<string, unknown>, make?: (frame: any, lab: any) => Record<string, unknown>) => void} Change
 * @typedef {(name: string, make: (frame: any) => Record<string, unknown>, places?: import('./letters.js').Places) =>
 *   void} Propose
 */

const SIZES = [
  { name: 'states', label: 'States', from: 1, to: MOST },
  { name: 'inputs', label: 'Inputs', from: 0, to: 8 },
  { name: 'readings', label: 'Readings', from: 1, to: 8 },
]
const LANGUAGES = { Rust: rust, JavaScript: javascript, numpy }

/** @param {Document} document @param {Change} change */
export function buildEditor(document, change) {
  const element = document.createElement('div')
  element.setAttribute('class', 'own-editor')
  // What a reader begins with stands first, so that a phone shows it without scrolling.
  const begin = part(document, element, 'div', 'own-row own-begin')
  const preset = select(document, begin, 'Preset', ['your own', ...PRESETS.map(({ name }) => name)])
  preset.addEventListener('change', () => {
    const chosen = PRESETS[preset.selectedIndex - 1]
    if (!chosen) return
    // A preset takes the place of what could not be read.
    say('', '')
    propose('', () => paramsOf(chosen))
  })
  button(document, begin, 'Paste a system', () => boxes.paste())
  const paste = part(document, element, 'div', 'own-box')

  const top = part(document, element, 'div', 'own-row')
  const sizes = SIZES.map(({ name, label, from, to }) => {
    const input = select(
      document,
      top,
      label,
      Array.from({ length: to + 1 - from }, (_, i) => String(i + from)),
    )
    input.addEventListener('change', () => {
      const count = input.selectedIndex + from
      propose('', ({ params }) => ({ [name]: count, ...grown(name, count, params) }))
    })
    return { name, from, input }
  })
  const time = buildTime(document, top, (name, make) => propose(name, make))

  const grids = part(document, element, 'div', 'own-grids')
  const matrices = [...MATRICES, 'P', 'K'].map((name) => buildGrid(document, grids, name, (i, j) => typed(name, i, j)))

  const question = buildQuestion(document, element, propose, () => time.focus())
  const fault = part(document, element, 'p', 'own-fault')
  fault.setAttribute('role', 'status')

  const names = part(document, element, 'div', 'own-row')
  const named = Array.from({ length: MOST }, (_, i) => {
    const label = part(document, names, 'label', 'control own-name')
    writeHtml(part(document, label, 'span', 'control-name'), `Name of *x*_${i + 1}`)
    const input = textBox(document, label)
    input.setAttribute('maxlength', '12')
    input.addEventListener('input', () =>
      change({}, ({ params }) => ({
        names: Array.from({ length: Math.max(params.names.length, i + 1) }, (_, j) =>
          j === i ? lettersOf(input.value) : (params.names[j] ?? lettersOf('')),
        ),
      })),
    )
    return { label, input }
  })

  const tools = part(document, element, 'div', 'own-row own-tools')
  /** Where the fault is: in a matrix that is typed, or in what is pasted. */
  let wrong = ''
  /** The system that the reader has made here last, and the one that is shown. */
  let [made, shown] = ['', '']
  for (const [language, write] of Object.entries(LANGUAGES))
    button(
      document,
      tools,
      `Copy as ${language}`,
      () => change({}, (frame) => (boxes.give(language, write(frame)), {})),
      'quiet',
    )
  const desk = { change, say, propose, wrong: () => wrong, made: () => made }
  const boxes = buildBoxes(document, { paste, give: part(document, element, 'div', 'own-box') }, desk)

  /** @param {string} name @param {number} i @param {number} j */
  function typed(name, i, j) {
    const grid = /** @type {typeof matrices[0]} */ (matrices.find((each) => each.name === name))
    const cells = grid.cells()
    // A covariance is symmetric: the other of two entries follows.
    if ((name === 'V' || name === 'W') && i !== j) write(cells[j][i], cells[i][j].value)
    propose(name, ({ params }) => {
      let first = ''
      const [rows, columns] = sizeOf(name, params)
      const entries = Array.from({ length: MOST }, (_, r) =>
        Array.from({ length: MOST }, (_, c) => params[name.toLowerCase()]?.[r]?.[c] ?? 0),
      )
      for (let r = 0; r < rows; r += 1) {
        for (let c = 0; c < columns; c += 1) {
          const text = grid.textOf(cells[r][c])
          entries[r][c] = numberOf(text)
          const bad = !Number.isFinite(entries[r][c])
          cells[r][c].toggleAttribute('aria-invalid', false)
          if (bad) cells[r][c].setAttribute('aria-invalid', 'true')
          const place = name === 'P' ? `The variance of state ${c + 1}` : `${name}, row ${r + 1}, column ${c + 1}`
          if (bad) first ||= `${place}: ${faultOf(text)}`
        }
      }
      if (first) throw new Error(first)
      if (name !== 'P') return { [name.toLowerCase()]: entries }
      return { start: 1, spread: [...entries[0].slice(0, columns), ...Array(MOST - columns).fill(1)] }
    })
  }

  /**
   * Asks the lab whether a change makes a system, and makes it if so: with a run that is as long as its slowest error.
   * @type {Propose}
   */
  function propose(name, make, places) {
    change({}, (frame, lab) => {
      try {
        const patch = make(frame)
        const tried = lab.constructor.from({ ...lab.state(), params: { ...frame.params, ...patch }, step: 0 })
        const { runLength } = tried.frame()
        tried.free()
        // A paste that is not understood stays so, whatever else is changed.
        if (name === 'paste' || wrong !== 'paste') say('', '')
        made = keyOf({ ...frame.params, ...patch })
        return { ...patch, ...runOf(runLength) }
      } catch (error) {
        say(name, wordsOf(error, places))
        return {}
      }
    })
  }

  /** @param {string} name @param {string} words */
  function say(name, words) {
    wrong = words === '' ? '' : name
    // What is wrong with a paste is said beside it.
    const [beside, ofPaste] = name === 'paste' ? ['', words] : [words, '']
    if (fault.textContent !== beside) fault.textContent = beside
    boxes.say(ofPaste)
    if (words === '') element.removeAttribute('data-wrong')
    else element.setAttribute('data-wrong', name)
    time.mark(wrong)
    for (const { name: each, group, cells } of matrices) {
      const all = cells().flat()
      if (each !== wrong) all.forEach((cell) => cell.removeAttribute('aria-invalid'))
      // An entry that is no number is marked itself; of a matrix that the lab refuses, every entry may be at fault.
      group.toggleAttribute('data-wrong', each === wrong && !all.some((cell) => cell.hasAttribute('aria-invalid')))
    }
  }

  return {
    element,
    /** @param {any} params @param {import('estimate-wasm').OwnFrame} frame */
    show(params, frame) {
      const now = keyOf(params)
      // A system that comes from elsewhere takes the place of what could not be read here.
      const foreign = shown !== '' && now !== shown && now !== made
      if (foreign) say('', '')
      boxes.show(params, now)
      shown = now
      const chosen = PRESETS.findIndex((one) => same(paramsOf(one), params)) + 1
      choose(preset, chosen)
      for (const { name, from, input } of sizes) choose(input, params[name] - from)
      time.show(params, foreign)
      question.show(frame.looksLikeRates)
      named.forEach(({ label, input }, i) => {
        label.toggleAttribute('hidden', i >= params.states)
        if (document.activeElement !== input) write(input, givenName(params, i))
      })
      for (const matrix of matrices)
        matrix.show(partOf(matrix.name, params), sizeOf(matrix.name, params), {
          hidden: matrix.name === 'K' && params.gain !== 'hand',
          wrong: matrix.name === wrong,
          foreign,
          continuous: params.continuous,
        })
    },
  }
}
