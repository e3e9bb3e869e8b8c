/** The scripts of the figures. Each is fetched when the first figure of its kind comes near the screen. */

/** @type {Record<string, () => Promise<import('../figure/spec.js').FigureSpec>>} */
export const WIDGETS = {
  'observability-probe': () => import('./observability-probe/index.js').then((module) => module.observabilityProbe),
  'kalman-picture': () => import('./kalman-picture/index.js').then((module) => module.kalmanPicture),
  'observer-bench': () => import('./observer-bench/index.js').then((module) => module.observerBench),
  'robot-log': () => import('./robot-log/index.js').then((module) => module.robotLog),
  'tune-me': () => import('./tune-me/index.js').then((module) => module.tuneMe),
  'close-loop': () => import('./close-loop/index.js').then((module) => module.closeLoop),
  'own-system': () => import('./own-system/index.js').then((module) => module.ownSystem),
  'odometry-hook': () => import('./odometry-hook/index.js').then((module) => module.odometryHook),
  'bug-museum': () => import('./bug-museum/index.js').then((module) => module.bugMuseum),
}
