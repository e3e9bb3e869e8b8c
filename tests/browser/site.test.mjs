// The built files: every address in them resolves, relative and inside the site, so any sub-path of any host will do.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createHash } from 'node:crypto'
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs'
import { homedir } from 'node:os'
import path from 'node:path'
import { WORKER_POLICY } from '../../scripts/static-server.mjs'
import { dist, root } from './places.mjs'

const files = readdirSync(dist, { recursive: true })
  .map(String)
  .filter((file) => statSync(path.join(dist, file)).isFile())
const html = files.filter((file) => file.endsWith('.html'))
const text = new Map(html.map((file) => [file, readFileSync(path.join(dist, file), 'utf8')]))
const anchors = new Map()
/** What every page may do, and nothing else. */
const POLICY =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; style-src-attr 'unsafe-inline'; " +
  "font-src 'self'; img-src 'self' data:; connect-src 'self'; manifest-src 'self'; worker-src 'self'; " +
  "base-uri 'none'; form-action 'none'"
/** The page for lost addresses has its script and its style inside, each named by its hash. */
const POLICY_OF_LOST =
  "default-src 'none'; script-src '#'; style-src '#'; connect-src 'self'; img-src data:; base-uri 'none'; " +
  "form-action 'none'"
const unescaped = (value) =>
  value
    .replace(/&amp;/g, '&')
    .replace(/&#x27;|&#39;/g, "'")
    .replace(/&quot;/g, '"')
    .replace(/&#x2F;|&#47;/gi, '/')

/** The ids of a page. */
function idsOf(file) {
  if (!anchors.has(file))
    anchors.set(file, new Set([...text.get(file).matchAll(/\sid="([^"]*)"/g)].map((match) => unescaped(match[1]))))
  return anchors.get(file)
}

test('every link, script, style and picture of every page is there', () => {
  const broken = []
  for (const file of html) {
    for (const [, , raw] of text.get(file).matchAll(/<[^>]*?\s(href|src)="([^"]*)"/g)) {
      const address = unescaped(raw)
      if (/^(https?:|mailto:|data:)/.test(address)) continue
      if (address.startsWith('/')) {
        broken.push(`${file}: ${address} is not relative`)
        continue
      }
      const [where, fragment] = address.split('#')
      let target = path.posix.normalize(
        path.posix.join(path.posix.dirname(file), decodeURIComponent(where.split('?')[0])),
      )
      if (where.split('?')[0] === '') target = file
      else if (
        where.endsWith('/') ||
        target === '.' ||
        (existsSync(path.join(dist, target)) && statSync(path.join(dist, target)).isDirectory())
      )
        target = path.posix.join(target, 'index.html')
      if (target.startsWith('..') || !existsSync(path.join(dist, target)))
        broken.push(`${file}: ${address} leads nowhere`)
      else if (fragment && text.has(target) && !idsOf(target).has(decodeURIComponent(fragment)))
        broken.push(`${file}: ${address} has no such place`)
    }
  }
  assert.deepEqual(broken.slice(0, 40), [])
})

test('no page gives two things the same id', () => {
  const twice = []
  for (const file of html) {
    const ids = [...text.get(file).matchAll(/<[a-zA-Z][^>]*\sid="([^"]*)"/g)].map((match) => match[1])
    const seen = new Set()
    for (const id of ids) seen.has(id) ? twice.push(`${file}#${id}`) : seen.add(id)
  }
  assert.deepEqual(twice.slice(0, 20), [])
})

test('every page carries the strict policy, a title, a description and a language', () => {
  for (const file of html) {
    const page = text.get(file)
    const policy = /http-equiv="Content-Security-Policy" content="([^"]*)"/i.exec(page)?.[1] ?? ''
    if (file === '404.html') assert.equal(policy.replace(/'sha256-[A-Za-z0-9+/]{43}='/g, "'#'"), POLICY_OF_LOST, file)
    else assert.equal(policy, POLICY, file)
    assert.match(page, /<html[^>]* lang="en"/, file)
    assert.match(page, /<title>[^<]{4,}<\/title>/, file)
    if (!file.startsWith('source/')) assert.match(page, /<meta name="description" content="[^"]{20,}"/, file)
    // What stands inside a page is named in its policy by its hash; only the page for lost addresses has any.
    for (const [, tag, body] of page.matchAll(/<(script|style)(?![^>]*\ssrc=)[^>]*>([\s\S]+?)<\/\1>/g)) {
      assert.equal(file, '404.html', `${file} has an inline ${tag}`)
      assert.ok(
        policy.includes(`'sha256-${createHash('sha256').update(body).digest('base64')}'`),
        `${file}: an inline ${tag} that the policy does not name`,
      )
    }
    assert.doesNotMatch(page, /<[^>]+\son[a-z]+="/, `${file} has an inline handler`)
  }
})

test('the page on hosting prints that policy', () => {
  const words = unescaped(text.get('hosting/index.html').replace(/<[^>]*>/g, ''))
  assert.ok(words.includes(`Content-Security-Policy: ${POLICY}\n`))
})

test('the page on hosting prints the policy of workers', () => {
  const words = unescaped(text.get('hosting/index.html').replace(/<[^>]*>/g, ''))
  assert.ok(words.includes(`Content-Security-Policy: ${WORKER_POLICY}\n`))
})

test('nothing in the site names a folder of the machine that built it, or where its sources came from', () => {
  const words = [homedir(), root, 'registry/src'].filter((word) => word.length > 1)
  const named = files.flatMap((file) => {
    const bytes = readFileSync(path.join(dist, file))
    return words.filter((word) => bytes.includes(`${word}/`)).map((word) => `${file}: ${word}`)
  })
  assert.deepEqual(named, [])
})

test('nothing in the site names another host to load from', () => {
  const loads = []
  const foreign = [
    /<(?:script|link|img|iframe|source)[^>]*(?:src|href)="https?:[^"]*"/,
    /url\(["']?https?:[^)]*\)/,
    /@import[^;]*https?:[^;]*/,
  ]
  const pattern = new RegExp(foreign.map(({ source }) => source).join('|'), 'g')
  for (const file of files.filter((name) => /\.(html|css)$/.test(name))) {
    const body = readFileSync(path.join(dist, file), 'utf8')
    for (const [found] of body.matchAll(pattern)) {
      if (!/rel="(canonical|license|author)"/.test(found)) loads.push(`${file}: ${found}`)
    }
  }
  assert.deepEqual(loads, [])
})
