/** Cuts the faces down to the letters the page uses; the result is kept until a font or the letters change. */

import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { join } from 'node:path'
import subsetFont from 'subset-font'

const find = createRequire(import.meta.url)

const range = (from, to) => String.fromCodePoint(...Array.from({ length: to - from + 1 }, (_, i) => from + i))
const LATIN = range(0x20, 0x7e) + range(0xa0, 0xff) + 'ŁłŒœŠšŽžĆćČč–—‘’‚“”„†•…‰‹›€™−×÷≤≥≠≈∞√∂∑∏∫◊°²³µ⁰¹⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉←↑→↓↔⇒'
const GREEK = 'ΓΔΘΛΞΠΣΦΨΩαβγδεζηθικλμνξπρσςτυφχψω'
const MARKS = '\u0302\u0303\u0304\u0307'

const SERIF = '@fontsource-variable/source-serif-4/files/source-serif-4'
const FACES = [
  ['serif-upright', [`${SERIF}-latin-wght-normal.woff2`], LATIN, { wght: { min: 400, max: 700 } }],
  ['serif-italic', [`${SERIF}-latin-wght-italic.woff2`], LATIN, { wght: { min: 400, max: 700 } }],
  ['serif-greek', [`${SERIF}-greek-wght-normal.woff2`], GREEK, { wght: 400 }],
  ['serif-greek-italic', [`${SERIF}-greek-wght-italic.woff2`], GREEK, { wght: 400 }],
  ['sans', ['@fontsource-variable/source-sans-3/files/source-sans-3-latin-wght-normal.woff2'], LATIN + MARKS, { wght: { min: 400, max: 700 } }],
  ['mono', ['@fontsource-variable/source-code-pro/files/source-code-pro-latin-wght-normal.woff2'], LATIN, { wght: { min: 400, max: 600 } }],
]

/**
 * @param {string} folder where the cut faces lie
 * @returns {Promise<string>} the folder
 */
export async function subsetFonts(folder) {
  mkdirSync(folder, { recursive: true })
  for (const [name, [file], letters, axes] of FACES) {
    const source = readFileSync(find.resolve(file))
    const stamp = createHash('sha256').update(source).update(letters).update(JSON.stringify(axes)).digest('hex')
    const [at, mark] = [join(folder, `${name}.woff2`), join(folder, `${name}.stamp`)]
    if (existsSync(at) && existsSync(mark) && readFileSync(mark, 'utf8') === stamp) continue
    writeFileSync(at, await subsetFont(source, letters, { targetFormat: 'woff2', variationAxes: axes }))
    writeFileSync(mark, stamp)
  }
  return folder
}

