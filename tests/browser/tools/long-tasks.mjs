// The longest tasks of the page's own thread while a page comes up, and what each was spent on: scripts by function,
// styles, layout, paint. Milliseconds of each kind's own time; beside a task's length stands how long the processor
// worked on it, which a busy machine does not stretch. Prints; fails on nothing.
//   node tests/browser/tools/long-tasks.mjs [PAGE] [LEAST ms]
import { chromium } from 'playwright-core'
import { serve } from '../../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, DESKTOP, chromiumPath, dist } from '../places.mjs'

const [at = 'figure/robot-log/', least = '50'] = process.argv.slice(2)
const site = await serve({ folder: dist, base: BASE })
const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
const page = await browser.newPage({ viewport: DESKTOP })
await browser.startTracing(page, {
  categories: ['toplevel', 'devtools.timeline', 'v8', 'disabled-by-default-devtools.timeline'],
})
await page.goto(site.url + at)
// Nothing is asked of the page meanwhile: what the driver brings into a page for a question takes a long task itself.
await new Promise((resolve) => setTimeout(resolve, 5000))
const { traceEvents: all } = JSON.parse(String(await browser.stopTracing()))
await browser.close()
await site.close()

const mains = new Set(
  all
    .filter(({ name, args }) => name === 'thread_name' && args.name === 'CrRendererMain')
    .map(({ pid, tid }) => `${pid} ${tid}`),
)
const spans = all
  .filter(({ ph, dur, pid, tid }) => ph === 'X' && dur > 0 && mains.has(`${pid} ${tid}`))
  .sort((a, b) => a.ts - b.ts || b.dur - a.dur)
const start = spans[0].ts
const tasks = spans.filter(({ name, dur }) => name === 'ThreadControllerImpl::RunTask' && dur >= 1000 * Number(least))
for (const task of tasks.sort((a, b) => b.dur - a.dur)) {
  const own = new Map()
  const open = []
  for (const span of spans.filter(
    ({ pid, tid, ts, dur }) => pid === task.pid && tid === task.tid && ts >= task.ts && ts + dur <= task.ts + task.dur,
  )) {
    while (open.length && open.at(-1).ts + open.at(-1).dur <= span.ts) open.pop()
    const parent = open.at(-1)
    if (parent) own.set(parent.label, own.get(parent.label) - span.dur)
    const { data } = span.args
    const label = [span.name, data?.functionName, data?.url?.split('/').pop()].filter(Boolean).join(' ')
    own.set(label, (own.get(label) ?? 0) + span.dur)
    open.push({ ...span, label })
  }
  const parts = [...own]
    .filter(([, time]) => time > 2000)
    .sort((a, b) => b[1] - a[1])
    .map(([label, time]) => `${(time / 1000).toFixed(0)} ${label}`)
  console.log(
    `${(task.dur / 1000).toFixed(0)} ms, ${((task.tdur ?? 0) / 1000).toFixed(0)} of the processor, ` +
      `at ${((task.ts - start) / 1000).toFixed(0)} ms: ${parts.join('; ')}`,
  )
}
if (tasks.length === 0) console.log(`no task above ${least} ms`)
