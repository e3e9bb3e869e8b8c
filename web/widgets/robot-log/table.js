/** A log's replay as a table, written in the worker a part at a time; between two parts it reads its messages. */

import { wordsOf } from '../../load/worker-server.js'

/** Rows that are written in one go. */
const ROWS = 5000

/**
 * @param {any} module with `LogTable`
 * @param {any} log
 * @param {{ params: any, table: string }} wish
 * @param {(act: () => void) => void} soon calls back once waiting messages have been read
 * @returns {Promise<{ kind: 'table', text: Blob } | { kind: 'no-table', message: string }>}
 */
export async function tableOf(module, log, { params, table: kind }, soon) {
  try {
    const table = new module.LogTable(log, params, kind)
    const parts = []
    for (let part = table.next(ROWS); part !== undefined; part = table.next(ROWS)) {
      parts.push(part)
      await new Promise((resolve) => soon(() => resolve(undefined)))
    }
    table.free()
    return { kind: 'table', text: new Blob(parts, { type: 'text/csv' }) }
  } catch (error) {
    return { kind: 'no-table', message: wordsOf(error) }
  }
}
