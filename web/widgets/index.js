/** The scripts of the figures. Each is fetched when the first figure of its kind comes near the screen. */

/** @type {Record<string, () => Promise<import('../core/spec.js').FigureSpec>>} */
export const WIDGETS = {
  'observability-probe': () => import('./observability-probe.js').then((module) => module.observabilityProbe),
  'kalman-picture': () => import('./kalman-picture.js').then((module) => module.kalmanPicture),
  'observer-bench': () => import('./observer-bench.js').then((module) => module.observerBench),
  'robot-log': () => import('./robot-log.js').then((module) => module.robotLog),
  'tune-me': () => import('./tune-me.js').then((module) => module.tuneMe),
  'close-loop': () => import('./close-loop.js').then((module) => module.closeLoop),
  'own-system': () => import('./own-system.js').then((module) => module.ownSystem),
  'odometry-hook': () => import('./odometry-hook.js').then((module) => module.odometryHook),
  'bug-museum': () => import('./bug-museum.js').then((module) => module.bugMuseum),
}
