/** What the page calls what a log’s file is read as, its values and what encoders need. */

/** What a file is read as. @type {Record<string, string>} */
export const ROLES = {
  log: 'a log in this book’s format',
  velocities: 'velocities',
  odometry: 'odometry',
  encoders: 'encoders of two wheels',
  reckoned: 'odometry as poses: x, y and heading',
  sensors: 'sensors: speed, turn rate, position, heading',
  sightings: 'sightings of landmarks',
  ranges: 'ranges, a column for each landmark',
  landmarks: 'landmarks',
  truth: 'the true track',
  barcodes: 'barcodes',
  undecided: 'choose what it is',
  unused: 'not used',
}
/** What values and units are called where that is not their own name. @type {Record<string, string>} */
export const NAMES = {
  omega: 'ω',
  us: 'µs',
  sigma: 'σ of the position',
  'sigma of heading': 'σ of the heading',
  'landmark x': 'x of the landmark',
  'landmark y': 'y of the landmark',
  fraction: 'fraction of the second',
  'first range': 'first of the ranges',
  date: 'date or time of day',
  day: 'day of the time',
  quaternion: 'quaternion: x, y, z, w',
}
/** What encoders need besides, and its unit. @type {['ticks' | 'radius' | 'base', string][]} */
export const WHEELS = [
  ['ticks', 'ticks in one turn of a wheel'],
  ['radius', 'radius of a wheel, m'],
  ['base', 'distance between the wheels, m'],
]
/** From where each number of encoders is counted. @type {Record<string, string>} */
export const COUNTINGS = {
  total: 'from the start of the log',
  step: 'since the row before',
  restarted: 'from 0 again at each jump',
}
