/** The lab that replays a log, for a page that may start no worker. */

import init, * as estimate from 'estimate-wasm/log'
import address from 'estimate-wasm/log/wasm'
import { loader } from '../../load/loader.js'

export const loadLog = loader(init, estimate, address)
