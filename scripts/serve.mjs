// Serves dist/ for ./scripts/serve, which has checked the arguments: node scripts/serve.mjs [--watch] [PORT]
// With --watch it looks at the sources twice a second, runs scripts/build when one has changed, and tells the open
// pages.
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { serve } from './static-server.mjs'
import { Rebuilder } from './rebuild.mjs'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const watching = process.argv.includes('--watch')
const [wanted] = process.argv.slice(2).filter((word) => word !== '--watch')
const rebuilder = watching ? new Rebuilder(root) : undefined

const first = wanted === undefined ? 8015 : Number(wanted)
// Without a wish, the next free port will do.
for (let at = first; ; at++) {
  try {
    const { url } = await serve({ folder: path.join(root, 'dist'), port: at, live: rebuilder })
    console.log(
      `\n  The chapter is at ${url}kalman/   (the cover: ${url})\n` +
        `  ${watching ? 'Sources are watched. ' : ''}Ctrl-C stops.\n`,
    )
    break
  } catch (error) {
    if (error?.code === 'EADDRINUSE' && wanted === undefined && at < first + 50) continue
    console.error(`✗ Cannot serve dist/ on port ${at}: ${error?.message ?? error}`)
    process.exit(1)
  }
}
rebuilder?.watch()
