/**
 * What the browser keeps of each question: the answer that stands, and how many tries there were until the right one.
 * Both are kept under the question's id and a hash of its content, so a changed question is asked again.
 */

import { forgetAll, recall, remember } from './storage.js'

const KEPT = 'quiz:'
const TRIES = 'tries:'
/** The answer of a reader who asked to be shown. */
export const SHOWN = 'shown'

/** @param {HTMLElement} question @param {string} prefix */
function nameOf({ dataset }, prefix) {
  return `${prefix}${dataset.quiz}:${dataset.hash}`
}

/** The answer that stands, or null. @param {HTMLElement} question */
export function standing(question) {
  return recall(nameOf(question, KEPT))
}

/** @param {HTMLElement} question @param {string | null} answer null takes it back; the tries stay */
export function keep(question, answer) {
  remember(nameOf(question, KEPT), answer)
}

/** Counts a try, unless the right answer was given before. @param {HTMLElement} question @param {boolean} right */
export function count(question, right) {
  const { tries, right: before } = tried(question)
  if (!before) remember(nameOf(question, TRIES), `${tries + 1}${right ? ' right' : ''}`)
}

/** @param {HTMLElement} question */
export function tried(question) {
  const [, tries, right] = /^(\d{1,6})( right)?$/.exec(recall(nameOf(question, TRIES)) ?? '') ?? []
  return {
    answered: tries !== undefined,
    right: right !== undefined,
    tries: Number(tries ?? 0),
    shown: standing(question) === SHOWN,
  }
}

export function forgetRecords() {
  forgetAll(KEPT)
  forgetAll(TRIES)
}
