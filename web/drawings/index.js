/**
 * Drawings that do not move: each is drawn once, when the book is built, from a frame of its lab.
 */

import { drawing as covariance } from './covariance.js'

/**
 * @typedef {object} Drawing
 * @property {string} lab the class of its lab in the module
 * @property {string} name the lab's name in a state
 * @property {number} width
 * @property {number} height
 * @property {(pen: import('../draw/pen.js').Pen, frame: any) => void} draw
 * @property {(frame: any) => string} describe what it shows in words
 */

/** @type {Record<string, Drawing>} */
export const DRAWINGS = { covariance }
