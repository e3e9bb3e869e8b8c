declare module 'module-builds' {
  /**
   * Each build of the module, whole or with the labs of some figures: its script, which fetches it. The list's first is
   * at hand.
   */
  export const BUILDS: Record<
    string,
    () => Promise<{ load: () => Promise<import('./loader.js').Loaded<typeof import('estimate-wasm')>> }>
  >
}

declare module 'estimate-wasm/of/*' {
  /** The build that has the lab of a figure. */
  export * from 'estimate-wasm'
  export { default } from 'estimate-wasm'
}

declare module 'wasm-of/*' {
  /** Where its binary lies, relative to the script that imports this. */
  const address: string
  export default address
}

declare module '*-worker' {
  /** Where the script of a figure's worker lies, relative to the script that imports this. */
  const address: string
  export default address
}

declare module '*.csv' {
  /** Where the log lies, relative to the script that imports this. */
  const address: string
  export default address
}
