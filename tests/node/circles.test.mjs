// No module imports another that imports it in turn: of each crate's Rust modules (a folder counts as the module it
// belongs to, tests left out) and of the page's scripts.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { existsSync, readFileSync, readdirSync } from 'node:fs'
import path from 'node:path'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../..', import.meta.url))
const below = (folder, ending) =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter(
    (name) => name.endsWith(ending) && !name.split(path.sep).includes('node_modules'),
  )

/** The circles of a graph, each once, as the names along it. @param {Map<string, Set<string>>} graph */
export function circles(graph) {
  const found = []
  const done = new Set()
  const visit = (name, way) => {
    const at = way.indexOf(name)
    if (at >= 0) return void found.push([...way.slice(at), name].join(' → '))
    if (done.has(name)) return
    for (const next of graph.get(name) ?? []) visit(next, [...way, name])
    done.add(name)
  }
  for (const name of graph.keys()) visit(name, [])
  return found
}

/** `a::{b, c::d}` as `a::b` and `a::c::d`. @param {string} tree @returns {string[]} */
function paths(tree) {
  const open = tree.indexOf('{')
  if (open < 0) return [tree.replace(/\s+as\s+\w+$/, '').trim()]
  const parts = ['']
  let depth = 0
  for (const letter of tree.slice(open + 1, tree.lastIndexOf('}'))) {
    if (letter === '{') depth++
    if (letter === '}') depth--
    if (letter === ',' && depth === 0) parts.push('')
    else parts[parts.length - 1] += letter
  }
  return parts
    .filter((part) => part.trim())
    .flatMap((part) => paths(part.trim()).map((rest) => tree.slice(0, open).trim() + rest))
}

/** What a crate's modules import of one another. @param {string} source its folder src */
function crateGraph(source) {
  const code = new Map(
    below(source, '.rs')
      .filter((name) => path.basename(name) !== 'tests.rs')
      .map((name) => {
        const [text] = readFileSync(path.join(source, name), 'utf8').split(/^\s*#\[cfg\(test\)\]/m)
        return [name.replace(/\.rs$/, '').split(path.sep), text.replace(/\/\/.*$/gm, '')]
      })
      .map((/** @type {any} */ [module, text]) => [module.join('::'), text]),
  )
  const top = (name) => name.split('::')[0]
  // A name that the crate hands out at its root, by the module it comes from.
  const handedOut = new Map()
  for (const [, tree] of (code.get('lib') ?? '').matchAll(/\bpub use ([^;]+);/g)) {
    for (const one of paths(tree)) handedOut.set(one.split('::').at(-1), top(one.replace(/^crate::/, '')))
  }
  const modules = new Set([...code.keys()].map(top))
  const graph = new Map()
  for (const [module, text] of code) {
    const here = top(module)
    if (here === 'lib' || here === 'main') continue
    const used = [...text.matchAll(/\buse ([^;]+);/g)].flatMap(([, tree]) => paths(tree))
    used.push(...[...text.matchAll(/\bcrate::\w+/g)].map(([one]) => one))
    for (const one of used) {
      let parts = one.split('::')
      if (parts[0] === 'super') {
        const ups = parts.findIndex((part) => part !== 'super')
        parts = ['crate', ...module.split('::').slice(0, -ups), ...parts.slice(ups)]
      }
      if (parts[0] !== 'crate') continue
      const there = modules.has(parts[1]) ? parts[1] : handedOut.get(parts[1])
      if (there === undefined || there === here) continue
      graph.set(here, (graph.get(here) ?? new Set()).add(there))
    }
  }
  return graph
}

/** What the page's scripts import of one another as they start; what is fetched later is no circle. */
function scriptGraph(folder) {
  const graph = new Map()
  for (const name of below(folder, '.js')) {
    const file = path.join(folder, name)
    const text = readFileSync(file, 'utf8').replace(/^\s*(\/\/|\/?\*).*$/gm, '')
    const used = [...text.matchAll(/^(?:import|export)\b[^'"`]*?['"](\.[^'"]+)['"]/gm)].map(([, one]) =>
      path.relative(folder, path.resolve(path.dirname(file), one)),
    )
    graph.set(name, new Set(used.filter((one) => existsSync(path.join(folder, one)))))
  }
  return graph
}

test('a circle is found', () => {
  assert.deepEqual(
    circles(
      new Map([
        ['a', new Set(['b'])],
        ['b', new Set(['c'])],
        ['c', new Set(['b'])],
      ]),
    ),
    ['b → c → b'],
  )
  assert.deepEqual(paths('crate::{a::{B, c::D}, e as f}'), ['crate::a::B', 'crate::a::c::D', 'crate::e'])
})

for (const crate of readdirSync(path.join(root, 'crates')).filter((name) =>
  existsSync(path.join(root, 'crates', name, 'src')),
)) {
  test(`the modules of ${crate} import one another without a circle`, () => {
    assert.deepEqual(circles(crateGraph(path.join(root, 'crates', crate, 'src'))), [])
  })
}

test('the scripts of the page import one another without a circle', () => {
  const graph = scriptGraph(path.join(root, 'web'))
  assert.ok(graph.size > 30 && [...graph.values()].some((used) => used.size > 3), 'the scripts are read')
  assert.deepEqual(circles(graph), [])
})
