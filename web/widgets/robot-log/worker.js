/** The worker that reads and replays logs. What it is sent stays in it: it fetches its module and nothing else. */

import init, * as estimate from 'estimate-wasm/of/robot-log'
import address from 'wasm-of/robot-log'
import { loader } from '../../load/loader.js'
import { serve } from './server.js'

serve(/** @type {any} */ (self), loader(init, estimate, address))
