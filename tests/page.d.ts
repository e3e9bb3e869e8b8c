// What the tests take for granted of a page and of what they look up. Where it is not so, the test throws, and fails,
// at the line that reads it.

/** An element that a test names is there, and is of the kind that the test takes it for. */
interface ParentNode {
  querySelector(selectors: string): any
  querySelectorAll(selectors: string): NodeListOf<any>
}
interface NonElementParentNode {
  getElementById(id: string): any
}
interface Document {
  getElementById(id: string): any
  readonly activeElement: any
  elementFromPoint(x: number, y: number): any
}
interface Element {
  closest(selectors: string): any
  // A figure of the book.
  figure: any
  frame: any
  settled: any
}
interface Node {
  // Of a text.
  data: any
}
interface PerformanceEntry {
  // Of a shift of the layout, and of a resource.
  value: any
  initiatorType: any
}

// What is sought in a list, a text or a map is found.
interface Array<T> {
  at(index: number): T
  find(is: (value: T, index: number, all: T[]) => unknown, self?: any): T
  pop(): T
  shift(): T
}
interface Map<K, V> {
  get(key: K): V
}
interface RegExp {
  exec(text: string): RegExpExecArray
}
interface URLSearchParams {
  get(name: string): string
}
interface String {
  match(pattern: string | RegExp): RegExpMatchArray
}

/** Chromium's search in the page. */
declare function find(words: string): boolean
/** What pages that tests write keep: the messages of a frame, and the heights that it tells. */
declare const messages: any[]
declare const heights: number[]
