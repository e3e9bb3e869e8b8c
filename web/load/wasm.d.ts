declare module 'estimate-wasm/wasm' {
  /** Where the module's binary lies, relative to the script that imports this. */
  const address: string
  export default address
}

declare module 'estimate-wasm/late/wasm' {
  /** Where the binary with the labs of the late figures lies, relative to the script that imports this. */
  const address: string
  export default address
}

declare module 'estimate-wasm/system/wasm' {
  /** Where the binary with the lab of a reader's own system lies, relative to the script that imports this. */
  const address: string
  export default address
}

declare module 'estimate-wasm/log/wasm' {
  /** Where the binary with the lab of logs lies, relative to the script that imports this. */
  const address: string
  export default address
}

declare module 'tune-me-worker' {
  /** Where the worker's script lies, relative to the script that imports this. */
  const address: string
  export default address
}

declare module 'robot-log-worker' {
  /** Where the worker's script lies, relative to the script that imports this. */
  const address: string
  export default address
}

declare module '*.csv' {
  /** Where the log lies, relative to the script that imports this. */
  const address: string
  export default address
}

declare module 'estimate-wasm/figures/wasm' {
  /** Where the binary with the labs alone lies, relative to the script that imports this. */
  const address: string
  export default address
}
