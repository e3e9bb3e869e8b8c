/** How the files of a log are read, in words, for a report: what each is, its columns and units, and what was said. */

import { COUNTINGS, NAMES, ROLES, WHEELS } from './log-file-names.js'
import { clocksOf, framesOf } from './log-file-words.js'

/** @typedef {import('estimate-wasm').LogFile} LogFile */

/** A column that a value is read from, and its unit. @param {LogFile} file @returns {string[]} */
const columnsOf = ({ header, values }) =>
  values.flatMap(({ name, column, unit }) => {
    if (column === null) return []
    const from = header[column] || `column ${column + 1}`
    return [`${NAMES[name] ?? name} from ${from}${unit === null ? '' : `, ${NAMES[unit] ?? unit}`}`]
  })

/** What encoders were said to be. @param {LogFile} file @returns {string[]} */
function wheelsOf({ wheels, needs }) {
  if (!wheels) return []
  const numbers = WHEELS.filter(([name]) => needs.includes(name) && wheels[name] !== null)
  const counted = needs.includes('counting') && wheels.counting !== null
  return [
    ...numbers.map(([name, words]) => `${words}: ${wheels[name]}`),
    ...(counted ? [`counted ${COUNTINGS[wheels.counting ?? '']}`] : []),
  ]
}

/** Whose rows are read, by which clock and in which frame. @param {LogFile} file @returns {string[]} */
function saidOf({ header, several, clock, frame }) {
  const shift = clock?.said ?? null
  const frames = frame ? framesOf(frame).find(([one]) => one === frame.said) : undefined
  return [
    ...(several && several.only !== null ? [`only rows of which ${header[several.column]} is ${several.only}`] : []),
    ...(clock && shift !== null ? [`its clock: ${clocksOf(clock).find(([one]) => one === shift)?.[1]}`] : []),
    ...(frames ? [frames[1]] : []),
  ]
}

/** Each file’s name and how it is read. @param {LogFile[]} files @returns {[string, string][]} */
export const readings = (files) =>
  files.map((file) => [
    file.name,
    `${[ROLES[file.role], ...columnsOf(file), ...wheelsOf(file), ...saidOf(file)].join('; ')}.`,
  ])
