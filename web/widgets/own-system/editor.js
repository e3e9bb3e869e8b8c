/**
 * Where the reader types or pastes a system. What is typed goes to the lab as soon as it is a system; until then the
 * fault is named and the figure keeps the last one.
 */

import { button, part } from '../../draw/dom.js'
import { copied } from '../../figure/clipboard.js'
import { writeHtml } from '../../draw/words.js'
import { javascript, numpy, rust } from './copy-as.js'
import { choose, select, textBox, write } from './fields.js'
import { givenName, lettersOf } from './names.js'
import { MATRICES, PRESETS, paramsOf, partOf, sizeOf } from './presets.js'
import { faultOf, numberOf, readSystem } from './read.js'
import { grown, keyOf, same, wordsOf, written } from './typed-system.js'

/**
 * @typedef {(patch: Record<string, unknown>, make?: (frame: any, lab: any) => Record<string, unknown>) => void} Change
 */

const MOST = 4
const MEANINGS = /** @type {Record<string, import('../../draw/words.js').Words>} */ ({
  F: '*F*{also F}: what a step does',
  G: '*G*{also G}: what an input does',
  H: '*H*{also H}: what a reading tells',
  V: '*V*{also V}: noise of a step',
  W: '*W*{also W}: noise of a reading',
  K: '*K*{also K}: the gain by hand',
})
const SIZES = [
  { name: 'states', label: 'States', from: 1 },
  { name: 'inputs', label: 'Inputs', from: 0 },
  { name: 'readings', label: 'Readings', from: 1 },
]
const LANGUAGES = { Rust: rust, JavaScript: javascript, numpy }

/** @param {Document} document @param {Change} change */
export function buildEditor(document, change) {
  const element = document.createElement('div')
  element.setAttribute('class', 'own-editor')
  const top = part(document, element, 'div', 'own-row')
  const preset = select(document, top, 'Preset', ['your own', ...PRESETS.map(({ name }) => name)])
  preset.addEventListener('change', () => {
    const chosen = PRESETS[preset.selectedIndex - 1]
    if (chosen) propose('', () => paramsOf(chosen))
  })
  const sizes = SIZES.map(({ name, label, from }) => {
    const input = select(
      document,
      top,
      label,
      Array.from({ length: MOST + 1 - from }, (_, i) => String(i + from)),
    )
    input.addEventListener('change', () => {
      const count = input.selectedIndex + from
      propose('', ({ params }) => ({ [name]: count, ...grown(name, count, params) }))
    })
    return { name, from, input }
  })

  const names = part(document, element, 'div', 'own-row')
  const named = Array.from({ length: MOST }, (_, i) => {
    const label = part(document, names, 'label', 'control own-name')
    writeHtml(part(document, label, 'span', 'control-name'), `Name of *x*_${i + 1}`)
    const input = textBox(document, label)
    input.setAttribute('maxlength', '12')
    input.addEventListener('input', () =>
      change({}, ({ params }) => ({
        names: params.names.map((/** @type {number[]} */ name, /** @type {number} */ j) =>
          j === i ? lettersOf(input.value) : name,
        ),
      })),
    )
    return { label, input }
  })

  const grids = part(document, element, 'div', 'own-grids')
  const matrices = [...MATRICES, 'K'].map((name) => {
    const group = part(document, grids, 'div', 'own-matrix')
    group.setAttribute('role', 'group')
    writeHtml(part(document, group, 'span', 'control-name'), MEANINGS[name])
    group.setAttribute('aria-label', `Matrix ${name}`)
    const grid = part(document, group, 'div', 'own-cells')
    const cells = Array.from({ length: MOST }, (_, i) =>
      Array.from({ length: MOST }, (_, j) => {
        const input = textBox(document, grid)
        input.setAttribute('inputmode', 'decimal')
        input.setAttribute('aria-label', `${name}, row ${i + 1}, column ${j + 1}`)
        input.addEventListener('input', () => typed(name, i, j))
        return input
      }),
    )
    const none = part(document, group, 'span', 'own-none')
    none.textContent = 'none'
    return { name, group, grid, cells, none }
  })

  const fault = part(document, element, 'p', 'own-fault')
  fault.setAttribute('role', 'status')
  const tools = part(document, element, 'div', 'own-row own-tools')
  button(document, tools, 'Paste a system', () => openPaste(), 'quiet')
  for (const [language, write] of Object.entries(LANGUAGES))
    button(
      document,
      tools,
      `Copy as ${language}`,
      () => change({}, (frame) => (give(language, write(frame)), {})),
      'quiet',
    )
  const box = part(document, element, 'div', 'own-box')

  /** Where the fault is: in a matrix that is typed, or in what is pasted. */
  let wrong = ''
  /** The system that the reader has made here last, and the one that is shown. */
  let [made, shown] = ['', '']
  /**
   * Where a system is pasted, and the system that its text was last.
   * @type {{ area: HTMLTextAreaElement, is: string } | null}
   */
  let pasted = null

  /** @param {string} name @param {number} i @param {number} j */
  function typed(name, i, j) {
    const { cells } = /** @type {typeof matrices[0]} */ (matrices.find((each) => each.name === name))
    // A covariance is symmetric: the other of two entries follows.
    if ((name === 'V' || name === 'W') && i !== j) write(cells[j][i], cells[i][j].value)
    propose(name, ({ params }) => {
      let first = ''
      const [rows, columns] = sizeOf(name, params)
      const entries = params[name.toLowerCase()].map((/** @type {number[]} */ row) => [...row])
      for (let r = 0; r < rows; r += 1) {
        for (let c = 0; c < columns; c += 1) {
          entries[r][c] = numberOf(cells[r][c].value)
          const bad = !Number.isFinite(entries[r][c])
          cells[r][c].toggleAttribute('aria-invalid', false)
          if (bad) cells[r][c].setAttribute('aria-invalid', 'true')
          if (bad) first ||= `${name}, row ${r + 1}, column ${c + 1}: ${faultOf(cells[r][c].value)}`
        }
      }
      if (first) throw new Error(first)
      return { [name.toLowerCase()]: entries }
    })
  }

  /**
   * Asks the lab whether a change makes a system, and makes it if so.
   * @param {string} name the matrix that is being typed, if one, or `paste`
   * @param {(frame: any) => Record<string, unknown>} make
   */
  function propose(name, make) {
    change({}, (frame, lab) => {
      try {
        const patch = make(frame)
        lab.constructor.from({ ...lab.state(), params: { ...frame.params, ...patch }, step: 0 }).free()
        say('', '')
        made = keyOf({ ...frame.params, ...patch })
        return patch
      } catch (error) {
        say(name, wordsOf(error))
        return {}
      }
    })
  }

  /** @param {string} name @param {string} words */
  function say(name, words) {
    wrong = words === '' ? '' : name
    if (fault.textContent !== words) fault.textContent = words
    element.toggleAttribute('data-wrong', words !== '')
    for (const { name: each, group, cells } of matrices) {
      if (each !== wrong) cells.flat().forEach((cell) => cell.removeAttribute('aria-invalid'))
      // An entry that is no number is marked itself; of a matrix that the lab refuses, every entry may be at fault.
      group.toggleAttribute(
        'data-wrong',
        each === wrong && !cells.flat().some((cell) => cell.hasAttribute('aria-invalid')),
      )
    }
  }

  function openPaste() {
    const title = 'F, G, H, V and W in JSON, MATLAB or numpy notation, read while you type'
    const area = openBox(title, '', () => {
      pasted = null
      if (wrong === 'paste') say('', '')
    })
    area.rows = 7
    area.spellcheck = false
    change({}, ({ params }) => {
      pasted = { area, is: keyOf(params) }
      area.value = written(params)
      return {}
    })
    area.addEventListener('input', () => {
      const read = readSystem(area.value)
      const unused = read.ok ? read.unused.map((name) => name.slice(0, 20)) : []
      if (area.previousSibling)
        area.previousSibling.textContent = unused.length > 0 ? `${title}. Not used: ${unused.join(', ')}` : title
      if (!read.ok) return say('paste', `${read.line > 0 ? `Line ${read.line}: ` : ''}${read.fault}`)
      propose('paste', () => paramsOf(read.system))
      if (wrong === '') pasted = { area, is: made }
    })
    area.focus()
    area.select()
  }

  /** @param {string} language @param {string} text */
  async function give(language, text) {
    const name = wrong === '' ? `The system in ${language}` : `The last system without a fault, in ${language}`
    if (wrong === 'paste') say('', '')
    pasted = null
    const area = openBox(name, 'own-code', () => {})
    area.readOnly = true
    area.rows = 10
    area.value = text
    area.focus({ preventScroll: true })
    area.select()
    if ((await copied(text)) && area.previousSibling) area.previousSibling.textContent = `${name}, copied`
  }

  /** @param {string} name @param {string} kind @param {() => void} closed */
  function openBox(name, kind, closed) {
    box.replaceChildren()
    const label = part(document, box, 'label', 'own-paste')
    part(document, label, 'span', 'control-name').textContent = name
    const area = /** @type {HTMLTextAreaElement} */ (part(document, label, 'textarea', kind))
    button(document, box, 'Close', () => {
      box.replaceChildren()
      closed()
    })
    return area
  }

  return {
    element,
    /** @param {any} params */
    show(params) {
      const now = keyOf(params)
      // A system that comes from elsewhere takes the place of what could not be read here.
      const foreign = shown !== '' && now !== shown && now !== made
      if (foreign) say('', '')
      if (pasted && pasted.is !== now) {
        pasted.area.value = written(params)
        pasted.is = now
      }
      shown = now
      const chosen = PRESETS.findIndex((one) => same(paramsOf(one), params)) + 1
      choose(preset, chosen)
      for (const { name, from, input } of sizes) choose(input, params[name] - from)
      named.forEach(({ label, input }, i) => {
        label.toggleAttribute('hidden', i >= params.states)
        if (document.activeElement !== input) write(input, givenName(params, i))
      })
      for (const { name, group, grid, cells, none } of matrices) {
        const [rows, columns] = sizeOf(name, params)
        group.toggleAttribute('hidden', name === 'K' && params.gain !== 'hand')
        grid.setAttribute('style', `--columns:${Math.max(1, columns)}`)
        none.toggleAttribute('hidden', columns > 0)
        const entries = partOf(name, params)
        cells.forEach((row, i) =>
          row.forEach((cell, j) => {
            cell.toggleAttribute('hidden', i >= rows || j >= columns)
            // What is being typed stays as it is typed, and so does what could not be read.
            if (i >= rows || j >= columns || name === wrong || (document.activeElement === cell && !foreign)) return
            if (numberOf(cell.value) !== entries[i][j] || cell.value === '') write(cell, String(entries[i][j]))
          }),
        )
      }
    },
  }
}
