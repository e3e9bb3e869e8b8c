/** The worker that reads and replays logs. What it is sent stays in it: it fetches its module and nothing else. */

import init, * as estimate from 'estimate-wasm/log'
import address from 'estimate-wasm/log/wasm'
import { loader } from '../../load/loader.js'
import { serve } from './server.js'

serve(/** @type {any} */ (self), loader(init, estimate, address))
