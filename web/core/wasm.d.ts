declare module 'estimate-wasm/wasm' {
  /** Where the module's binary lies, relative to the script that imports this. */
  const address: string
  export default address
}
