/**
 * Cuts each font file into two subsets: the letters that the built pages show (letters.json, written by
 * `scripts/letters`) and all other letters that a text may need. A page fetches the first subset, and the second only
 * if a letter of it occurs. The subsets are kept until a font or the letters change.
 */

import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { join } from 'node:path'
import subsetFont from 'subset-font'

const find = createRequire(import.meta.url)
/** Family, weight and style of a face → the letters seen in it. @type {Record<string, string>} */
const SEEN = JSON.parse(readFileSync(new URL('letters.json', import.meta.url), 'utf8'))

const range = (from, to) => String.fromCodePoint(...Array.from({ length: to - from + 1 }, (_, i) => from + i))
const ASCII = range(0x20, 0x7e)
const MORE = `${range(0xa0, 0xff)}ŁłŒœŠšŽžĆćČč–—‘’‚“”„†•…‰‹›€™−×÷≤≥≠≈∞√∂∑∏∫◊°²³µ⁰¹⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉←↑→↓↔⇒`
const LATIN = ASCII + MORE
const GREEK = 'ΓΔΘΛΞΠΣΦΨΩαβγδεζηθικλμνξπρσςτυφχψω'
const MARKS = '\u0302\u0303\u0304\u0307'
/** The OpenType features that the style sheets turn on, and those that browsers apply by themselves. */
const FEATURES = [
  'calt',
  'ccmp',
  'kern',
  'liga',
  'locl',
  'mark',
  'mkmk',
  'rlig',
  'rvrn',
  'onum',
  'lnum',
  'tnum',
  'pnum',
]

/**
 * @typedef {object} Face
 * @property {string} name of its file
 * @property {string} family
 * @property {string} weight as in a style sheet
 * @property {string} style
 * @property {string} source
 * @property {string} always letters that belong to the first subset even if no page shows them: a control or a search
 * may
 * @property {string} letters all letters of both subsets; if empty, the font is left whole
 * @property {string} display the `font-display` of its rule
 * @property {Record<string, unknown>} axes
 */

const OURS = '@fontsource-variable'
/** @type {Face[]} */
const TEXT = [
  [
    'serif-upright',
    'Text',
    '400 700',
    'normal',
    'source-serif-4/files/source-serif-4-latin-wght-normal',
    ASCII,
    LATIN,
    { wght: { min: 400, max: 700 } },
  ],
  [
    'serif-italic',
    'Text',
    '400',
    'italic',
    'source-serif-4/files/source-serif-4-latin-wght-italic',
    ASCII,
    LATIN,
    { wght: 400 },
  ],
  [
    'serif-greek',
    'Text',
    '400 700',
    'normal',
    'source-serif-4/files/source-serif-4-greek-wght-normal',
    '',
    GREEK,
    { wght: 400 },
  ],
  [
    'serif-greek-italic',
    'Text',
    '400 700',
    'italic',
    'source-serif-4/files/source-serif-4-greek-wght-italic',
    '',
    GREEK,
    { wght: 400 },
  ],
  [
    'sans',
    'Plain',
    '400 700',
    'normal',
    'source-sans-3/files/source-sans-3-latin-wght-normal',
    ASCII + MARKS,
    LATIN + MARKS,
    { wght: { min: 400, max: 700 } },
  ],
  [
    'mono',
    'Code',
    '400',
    'normal',
    'source-code-pro/files/source-code-pro-latin-wght-normal',
    ASCII,
    LATIN,
    { wght: 400 },
  ],
].map((/** @type {any[]} */ [name, family, weight, style, source, always, letters, axes]) => ({
  name,
  family,
  weight,
  style,
  source: `${OURS}/${source}.woff2`,
  always,
  letters,
  display: 'fallback',
  axes,
}))

/**
 * KaTeX's faces, whole where a formula may need any sign of them, else down to letters, digits and the signs in use.
 */
const LETTERS = range(0x30, 0x39) + range(0x41, 0x5a) + range(0x61, 0x7a)
// U+E020 is KaTeX's own: the stroke of ≠.
const SIGNS =
  '±×÷¬ˉˆ˙˜ˇ´`¨˘˚^¯·°…′‵ℓℏℜℑ℘ℵ' +
  '←↑→↓↔↕↦↩↪⇐⇑⇒⇓⇔⟵⟶⟷⟸⟹⟺' +
  '∀∂∃∅∇∈∉∋∏∐∑−∓∗∘∙√∝∞∠∣∥∧∨∩∪∫∮∼≀≃≅≈≍≐≠≡≤≥≪≫≺≻⊂⊃⊆⊇⊎⊓⊔⊕⊖⊗⊘⊙⊢⊣⊤⊥⊨⋀⋁⋂⋃⋄⋅⋆⋮⋯⋱' +
  '⌈⌉⌊⌋⟨⟩⟮⟯—–‖†‡\u00a0\u200b\u0338\u20d7\ue020'
const KATEX = {
  'AMS-Regular': `${LETTERS}⊞⊟⊠⊡■□◼★∁∄∅∖≜≦≧⩽⩾⪅⪆`,
  'Caligraphic-Bold': LETTERS,
  'Caligraphic-Regular': LETTERS,
  'Fraktur-Bold': LETTERS,
  'Fraktur-Regular': LETTERS,
  'Main-Bold': ASCII + GREEK + SIGNS,
  'Main-BoldItalic': ASCII + GREEK,
  'Main-Italic': ASCII + GREEK,
  'Main-Regular': ASCII + GREEK + SIGNS,
  'Math-BoldItalic': `${LETTERS}${GREEK}ϵϑϕϖϱς∂ıȷℓ`,
  'Math-Italic': `${ASCII}${GREEK}ϵϑϕϖϱς∂ıȷℓ`,
  'SansSerif-Bold': ASCII,
  'SansSerif-Italic': ASCII,
  'SansSerif-Regular': ASCII,
  'Script-Regular': LETTERS,
  'Typewriter-Regular': ASCII,
  'Size1-Regular': '',
  'Size2-Regular': '',
  'Size3-Regular': '',
  'Size4-Regular': '',
}
/** @type {Face[]} */
const FORMULAS = Object.entries(KATEX).map(([face, letters]) => {
  const [family, cut] = face.split('-')
  return {
    name: `KaTeX_${face}`,
    family: `KaTeX_${family}`,
    weight: cut.startsWith('Bold') ? '700' : '400',
    style: cut.endsWith('Italic') ? 'italic' : 'normal',
    source: `katex/dist/fonts/KaTeX_${face}.woff2`,
    always: '',
    letters,
    display: 'block',
    axes: {},
  }
})

/**
 * The faces and two style sheets that name them, `text.css` and `formulas.css`.
 * @param {string} folder where they lie
 * @returns {Promise<string>} the folder
 */
export async function subsetFonts(folder) {
  mkdirSync(folder, { recursive: true })
  for (const [sheet, faces] of Object.entries({ text: TEXT, formulas: FORMULAS })) {
    let css = ''
    for (const face of faces) css += await cut(folder, face)
    writeFileSync(join(folder, `${sheet}.css`), css)
  }
  return folder
}

/**
 * Rules of faces that a picture holds in itself, as data, because it can fetch nothing.
 * @param {string} folder where the cut faces are kept
 * @param {string} name of the picture
 * @param {Record<string, Set<string>>} letters the picture's, by family and style as in `Plain normal`
 */
export async function heldFaces(folder, name, letters) {
  mkdirSync(folder, { recursive: true })
  let css = ''
  for (const face of TEXT) {
    const its = [...(letters[`${face.family} ${face.style}`] ?? [])]
      .filter((letter) => face.letters.includes(letter))
      .sort()
    if (its.length === 0) continue
    const rule = await part(
      folder,
      { ...face, axes: { wght: 400 } },
      readFileSync(find.resolve(face.source)),
      `${name}-${face.name}`,
      its,
    )
    css += rule
      .trim()
      .replace(
        /url\((.+?)\)/,
        (_, file) => `url(data:font/woff2;base64,${readFileSync(join(folder, file)).toString('base64')})`,
      )
  }
  return css
}

/**
 * Cuts one font file and returns its rules. Where two rules hold a letter, browsers take the later one.
 * @param {string} folder
 * @param {Face} face
 */
async function cut(folder, face) {
  const source = readFileSync(find.resolve(face.source))
  const seen = new Set([
    ...face.always,
    ...Object.entries(SEEN)
      .filter(([key]) => isOf(face, key))
      .map(([, letters]) => letters)
      .join(''),
  ])
  const known = new Set(face.letters)
  const first = [...seen].filter((letter) => !known.size || known.has(letter)).sort()
  const second = [...known].filter((letter) => !seen.has(letter)).sort()
  let css = ''
  if (second.length || !known.size) css += await part(folder, face, source, `${face.name}-more`, second)
  if (first.length) css += await part(folder, face, source, face.name, first)
  return css
}

/** Whether `key`, as in `Text 600 normal`, is set in this face. @param {Face} face @param {string} key */
function isOf({ family, weight, style }, key) {
  const [, its, at, slant] = /** @type {RegExpMatchArray} */ (key.match(/^(\S+) (\d+) (\w+)$/))
  // A font with one weight or without italics serves for the others too: the browser makes it bold or slanted.
  if (its !== family || (slant !== style && family !== 'Code')) return false
  return family.startsWith('KaTeX') ? at === weight : true
}

/**
 * @param {string} folder @param {Face} face @param {Buffer} source
 * @param {string} name
 * @param {string[]} letters none: the face whole
 * @returns {Promise<string>} its rule
 */
async function part(folder, { family, weight, style, display, axes }, source, name, letters) {
  const text = letters.join('')
  const options = { targetFormat: 'woff2', variationAxes: axes, keepFeatures: FEATURES, noHinting: true }
  const stamp = createHash('sha256').update(source).update(text).update(JSON.stringify(options)).digest('hex')
  const [at, mark] = [join(folder, `${name}.woff2`), join(folder, `${name}.stamp`)]
  if (!existsSync(at) || !existsSync(mark) || readFileSync(mark, 'utf8') !== stamp) {
    writeFileSync(at, text ? await subsetFont(source, text, options) : source)
    writeFileSync(mark, stamp)
  }
  const within = text ? `;unicode-range:${runs(letters)}` : ''
  return (
    `@font-face{font-family:${family};font-weight:${weight};font-style:${style};font-display:${display};` +
    `src:url(${name}.woff2) format("woff2")${within}}\n`
  )
}

/** As a style sheet writes them: `U+41-5A,U+2212`. @param {string[]} letters in order */
function runs(letters) {
  /** @type {[number, number][]} */
  const found = []
  for (const code of letters.map((letter) => /** @type {number} */ (letter.codePointAt(0))).sort((a, b) => a - b)) {
    const last = found[found.length - 1]
    if (last && code === last[1] + 1) last[1] = code
    else found.push([code, code])
  }
  return found.map(([from, to]) => `U+${from.toString(16)}${to > from ? `-${to.toString(16)}` : ''}`).join()
}
