// Which tests a change can touch, for `scripts/test --changed`. Where only folders of figures and tests have changed,
// it is those tests; the tests that reach one of the figures, by its name or by a file of it, themselves or through
// what they import; and of those that go through all figures the tests of these figures. A browser that opens every
// figure for the sake of one is left to CI, which runs all tests at each push. Whatever else has changed may touch any
// test.
import { existsSync, readFileSync, readdirSync } from 'node:fs'
import path from 'node:path'
import { FIGURES } from '../target/figures.js'

const root = path.join(import.meta.dirname, '..')
const widgets = path.join(root, 'web/widgets')
/** What holds every file to something, and takes no time. */
const OF_ALL_FILES = new Set(['lines', 'circles'])
/** Files with words about every figure: who imports one is not about one of them. */
const OF_ALL_FIGURES = new Set(
  ['web/widgets/index.js', 'tests/browser/label-states.mjs', 'tests/node/kept-links.mjs'].map((file) =>
    path.join(root, file),
  ),
)
const LIST = /\b(WIDGETS|FIGURES|FIGURE_PAGES)\b/
/** The list itself, and not one figure of it by its name. */
const WHOLE_LIST = /\b(WIDGETS|FIGURES|FIGURE_PAGES)\b(?!\.[a-z]+\()(?!\.[a-z]+\b|\[')/

/** @type {Map<string, { text: string, imports: string[] }>} */
const read = new Map()

/** A file's text, and the files of the project that it imports. @param {string} file */
function fileOf(file) {
  if (!read.has(file)) {
    const text = readFileSync(file, 'utf8')
    const named = [...text.matchAll(/\b(?:from|import) '(\.\.?\/[^']+)'/g)].map(([, to]) =>
      path.resolve(path.dirname(file), to),
    )
    read.set(file, { text, imports: named.filter((one) => /\.m?js$/.test(one) && existsSync(one)) })
  }
  return read.get(file)
}

/** A file with all that it imports, directly or through others, without what is about every figure. */
function reachOf(/** @type {string} */ file, seen = new Set()) {
  if (seen.has(file) || OF_ALL_FIGURES.has(file)) return seen
  seen.add(file)
  for (const one of fileOf(file).imports) reachOf(one, seen)
  return seen
}

/** The name of the figure in whose folder a file is. @param {string} file */
const figureOf = (file) => {
  const [name, ...rest] = path.relative(widgets, file).split(path.sep)
  return rest.length > 0 && name !== '..' ? name : undefined
}

/** The ids under which the text shows figures, each with the figure's name: `['fig-bench', 'observer-bench']`. */
function idsOf() {
  const content = path.join(root, 'content')
  return readdirSync(content, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.md'))
    .map((file) => readFileSync(path.join(content, file), 'utf8'))
    .flatMap((text) => [...text.matchAll(/^:::figure\{#([\w-]+) widget="([\w-]+)"/gm)])
    .map(([, id, name]) => [id, name])
}

/** The figures that are drawn with these files of figures' folders, their own and others'. @param {string[]} changed */
function figuresOf(changed) {
  const files = changed.map((file) => path.join(root, file))
  const own = files.map(figureOf)
  const others = FIGURES.filter(({ name }) => {
    const folder = path.join(widgets, name)
    const all = existsSync(folder) ? readdirSync(folder, { recursive: true, encoding: 'utf8' }) : []
    return all.some((file) => file.endsWith('.js') && files.some((one) => reachOf(path.join(folder, file)).has(one)))
  })
  return FIGURES.filter((figure) => own.includes(figure.name) || others.includes(figure))
}

/** Ahead of a name that is meant: not of a word that something is compared with, or one of the words of a type. */
const NAMED = '(?<!(?:[!=]==|\\|) )'

/** The names of figures where a file speaks of them. @param {{ name: string, tag: string }[]} figures */
const namesOf = (figures) =>
  new RegExp(
    figures
      .flatMap(({ name, tag }) => [
        `${NAMED}'${name}'`,
        `${NAMED}'${tag}'`,
        `\\b(?:widgets|figure)/${name}/`,
        `\\bWIDGETS\\.${name}\\b`,
      ])
      .join('|') || '$^',
  )

/** Those, and the ids under which the text shows the figures. @param {{ name: string, tag: string }[]} figures */
function speaksOf(figures) {
  const ids = idsOf().filter(([, name]) => figures.some((figure) => figure.name === name))
  return new RegExp([namesOf(figures).source, ...ids.map(([id]) => `\\b${id}(?![\\w-])`)].join('|'))
}

/**
 * The titles, as patterns, of the tests in a file that speak of a figure, or of all of them under a title without its
 * name. Those whose title has the name of the figure are found by that.
 * @param {string} text of the file
 * @param {RegExp} speaks
 * @param {boolean} ofList whether those that go through the whole list are wanted
 */
function titlesOf(text, speaks, ofList) {
  return text.split(/\n(?=(?:test\(|for \())/).flatMap((chunk) =>
    chunk.split(/(?=^ *test\()/m).flatMap((part, at, parts) => {
      const title = /^ *test\(\s*(['"`])(.*?)\1,/s.exec(part)?.[2]
      if (title === undefined) return []
      const head = at > 0 && !parts[0].startsWith('test(') ? parts[0] : ''
      const named = /\$\{(tag|name)\}/.test(title) || (/\$\{at\}/.test(title) && /FIGURE_PAGES/.test(head))
      const body = part.split(new RegExp(`^${/^ */.exec(part)?.[0]}\\}`, 'm'))[0]
      if (named || !(speaks.test(head + body) || (ofList && WHOLE_LIST.test(body)))) return []
      const literal = title.split(/\$\{[^}]*\}/).map((words) => words.replace(/[.*+?^${}()|[\]\\/]/g, '\\$&'))
      return [`^${literal.join('.*')}$`]
    }),
  )
}

/**
 * @param {string} folder of the tests
 * @param {string[]} changed files, from the project's root
 * @returns {{ whole: string[], parts: string[], pattern: string } | null} the names of files to run whole, and of files
 *   to run the tests of whose titles have the pattern; null for all tests
 */
export function touched(folder, changed) {
  const ofFigures = changed.filter((file) => figureOf(path.join(root, file)))
  const tests = new Set(OF_ALL_FILES)
  for (const file of changed.filter((one) => !ofFigures.includes(one))) {
    const test = /^tests\/(?:node|browser)\/([a-z-]+)\.test\.mjs$/.exec(file)
    if (!test) return null
    if (path.basename(path.dirname(file)) === path.basename(folder)) tests.add(test[1])
  }
  const figures = figuresOf(ofFigures)
  const [names, speaks] = [namesOf(figures), speaksOf(figures)]
  const whole = []
  const parts = []
  const titles = figures.flatMap(({ name, tag }) => [`\\b${name}\\b`, `\\b${tag}\\b`])
  for (const name of readdirSync(folder).flatMap((file) => /(.*)\.test\.mjs$/.exec(file)?.[1] ?? [])) {
    const file = path.join(folder, `${name}.test.mjs`)
    const { text } = fileOf(file)
    const reached = [...reachOf(file)]
    const ofAll = LIST.test(text)
    const reaches =
      reached.some((one) => figures.some((figure) => figure.name === figureOf(one))) ||
      (!ofAll && reached.some((one) => one.startsWith(path.join(root, 'tests')) && names.test(fileOf(one).text)))
    if (tests.has(name) || reaches) whole.push(name)
    else if (ofAll && figures.length > 0) {
      parts.push(name)
      titles.push(...titlesOf(text, speaks, path.basename(folder) === 'node'))
    }
  }
  return { whole, parts, pattern: [...new Set(titles)].join('|') }
}
