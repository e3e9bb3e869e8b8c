/** A program that a reader has written, as a program of another language. */

import { c } from './copy/c.js'
import { frameOf } from './copy/frame.js'
import { javascript } from './copy/javascript.js'
import { matlab } from './copy/matlab.js'
import { Refusal } from './copy/node.js'
import { numpy } from './copy/numpy.js'
import { rust } from './copy/rust.js'

/**
 * `steps` is how many of its world’s first ten are its test: fewer where the program has no value in the next.
 * @typedef {{ language: string, label: string, file: string, text: string, steps: number }} Copy
 */

const LANGUAGES = [
  { language: 'rust', label: 'Rust', file: 'main.rs', write: rust },
  { language: 'javascript', label: 'JavaScript', file: 'filter.mjs', write: javascript },
  { language: 'numpy', label: 'numpy', file: 'filter.py', write: numpy },
  { language: 'matlab', label: 'MATLAB', file: 'filter.m', write: matlab },
  { language: 'c', label: 'C', file: 'filter.c', write: c },
]

/**
 * The program in each language, as a whole program whose test is the first steps of its world; or, where there is
 * none, why.
 * @param {import('estimate-wasm').Program} program @param {string} text what it was read from
 * @param {import('./copy/frame.js').World} world
 * @returns {{ copies: Copy[], why: string }}
 */
export function copies(program, text, world) {
  const [fault] = program.faults
  if (fault) return { copies: [], why: `Line ${fault.line} has a fault: ${fault.message}` }
  try {
    const frame = frameOf(program, text, world)
    const steps = frame.steps.length
    return { copies: LANGUAGES.map(({ write, ...copy }) => ({ ...copy, text: write(frame), steps })), why: '' }
  } catch (error) {
    if (!(error instanceof Refusal)) throw error
    return { copies: [], why: `This program cannot be copied: ${error.message.replace(/\.+$/, '')}.` }
  }
}
