// guard.mjs FACE BINARY: puts a guard between JavaScript's face of the module, as wasm-bindgen writes it, and the
// binary. A fault of the module itself (the engine calls it a trap) leaves its memory in the middle of a change. From
// then on each call is refused by name, and `free` does nothing: an answer could be wrong, and after some hundreds of
// faults the module would have no stack left.
//
// Each export has a function of its own: the engine then knows what it calls, which makes a call several times as quick
// as through one function for all.
import { readFileSync, writeFileSync } from 'node:fs'

const [face, binary] = process.argv.slice(2)
const exported = WebAssembly.Module.exports(new WebAssembly.Module(readFileSync(binary)))
const names = exported.filter(({ kind }) => kind === 'function').map(({ name }) => name)
// What else begins so is for the face alone, and is called only in the course of a call from outside.
const calls = names.filter((name) => !name.startsWith('__'))
const frees = names.filter((name) => /^__wbg_.+_free$/.test(name))
/** As many as the longest list of arguments has; what is beyond an export's own is dropped. */
const given = 'a, b, c, d, e, f'

const guard = `
let fault;
function met(error, name) {
    if (error instanceof WebAssembly.RuntimeError) {
        fault = error;
        const what = 'the module met a fault of its own in ' + name + ' (' + error.message + ')';
        error.message = what + ' and must be loaded again';
    }
    return error;
}
function refused() {
    return new WebAssembly.RuntimeError(fault.message, { cause: fault });
}
function guarded(raw) {
    return {
        ...raw,
${frees.map((name) => `        ${name}(a, b) { if (!fault) raw.${name}(a, b); },`).join('\n')}
${calls
  .map(
    (name) => `        ${name}(${given}) {
            if (fault) throw refused();
            try { return raw.${name}(${given}); } catch (error) { throw met(error, '${name}'); }
        },`,
  )
  .join('\n')}
    };
}
`

const text = readFileSync(face, 'utf8')
const taken = /\bwasm = (\w+)\.exports;/g
const times = text.match(taken)?.length ?? 0
if (times !== 1)
  throw new Error(`${face} takes the module's exports ${times} times; the guard stands where they are taken once`)
const longest = calls.map((name) => new RegExp(`wasm\\.${name}\\(([^()]*)\\)`).exec(text)?.[1].split(',').length ?? 0)
if (Math.max(...longest) > given.split(',').length)
  throw new Error(`${face} calls an export with more arguments than the guard hands on`)
writeFileSync(face, text.replace(taken, 'wasm = guarded($1.exports);') + guard)
