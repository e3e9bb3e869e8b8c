/** Cuts the faces down to the letters the page uses; the result is kept until a font or the letters change. */

import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { join } from 'node:path'
import subsetFont from 'subset-font'

const find = createRequire(import.meta.url)

const range = (from, to) => String.fromCodePoint(...Array.from({ length: to - from + 1 }, (_, i) => from + i))
const ASCII = range(0x20, 0x7e)
const MORE = range(0xa0, 0xff) + 'ŁłŒœŠšŽžĆćČč–—‘’‚“”„†•…‰‹›€™−×÷≤≥≠≈∞√∂∑∏∫◊°²³µ⁰¹⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉←↑→↓↔⇒'
const LATIN = ASCII + MORE
const GREEK = 'ΓΔΘΛΞΠΣΦΨΩαβγδεζηθικλμνξπρσςτυφχψω'
const MARKS = '\u0302\u0303\u0304\u0307'

const SERIF = '@fontsource-variable/source-serif-4/files/source-serif-4'
const FACES = [
  ['serif-upright', [`${SERIF}-latin-wght-normal.woff2`], LATIN, { wght: { min: 400, max: 700 } }],
  ['serif-italic', [`${SERIF}-latin-wght-italic.woff2`], LATIN, { wght: 400 }],
  ['serif-greek', [`${SERIF}-greek-wght-normal.woff2`], GREEK, { wght: 400 }],
  ['serif-greek-italic', [`${SERIF}-greek-wght-italic.woff2`], GREEK, { wght: 400 }],
  ['sans', ['@fontsource-variable/source-sans-3/files/source-sans-3-latin-wght-normal.woff2'], LATIN + MARKS, { wght: { min: 400, max: 700 } }],
  ['mono', ['@fontsource-variable/source-code-pro/files/source-code-pro-latin-wght-normal.woff2'], ASCII + MORE, { wght: 400 }],
]

/** KaTeX's faces, whole where a formula may need any sign of them, else down to letters, digits and the signs in use. */
const LETTERS = range(0x30, 0x39) + range(0x41, 0x5a) + range(0x61, 0x7a)
const SIGNS = '±×÷¬ˉˆ˙˜ˇ´`¨˘˚^¯·°…′‵ℓℏℜℑ℘ℵ←↑→↓↔↕↦↩↪⇐⇑⇒⇓⇔⟵⟶⟷⟸⟹⟺∀∂∃∅∇∈∉∋∏∐∑−∓∗∘∙√∝∞∠∣∥∧∨∩∪∫∮∼≀≃≅≈≍≐≠≡≤≥≪≫≺≻⊂⊃⊆⊇⊎⊓⊔⊕⊖⊗⊘⊙⊢⊣⊤⊥⊨⋀⋁⋂⋃⋄⋅⋆⋮⋯⋱⌈⌉⌊⌋⟨⟩⟮⟯—–‖†‡\u200b\u0338\u20d7'
const KATEX = {
  'AMS-Regular': `${LETTERS}⊞⊟⊠⊡■□◼★∁∄∅∖≜≦≧⩽⩾⪅⪆`, 'Caligraphic-Bold': LETTERS, 'Caligraphic-Regular': LETTERS, 'Fraktur-Bold': LETTERS, 'Fraktur-Regular': LETTERS,
  'Main-Bold': ASCII + GREEK + SIGNS, 'Main-BoldItalic': ASCII + GREEK, 'Main-Italic': ASCII + GREEK, 'Main-Regular': ASCII + GREEK + SIGNS, 'Math-BoldItalic': `${LETTERS}${GREEK}ϵϑϕϖϱς∂ıȷℓ`,
  'Math-Italic': `${ASCII}${GREEK}ϵϑϕϖϱς∂ıȷℓ`, 'SansSerif-Bold': ASCII, 'SansSerif-Italic': ASCII, 'SansSerif-Regular': ASCII, 'Script-Regular': LETTERS, 'Typewriter-Regular': ASCII,
  'Size1-Regular': '', 'Size2-Regular': '', 'Size3-Regular': '', 'Size4-Regular': '',
}
for (const [name, letters] of Object.entries(KATEX)) FACES.push([`KaTeX_${name}`, [`katex/dist/fonts/KaTeX_${name}.woff2`], letters, {}])

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
    writeFileSync(at, letters ? await subsetFont(source, letters, { targetFormat: 'woff2', variationAxes: axes }) : source)
    writeFileSync(mark, stamp)
  }
  return folder
}

