/**
 * The page for a log of the reader's own: files are chosen, dropped or pasted and go to the worker of the figure, which
 * reads them. What it has understood is shown for correction, what is wrong is shown where it stands. Nothing is sent
 * anywhere.
 */

import { save } from '../figure/save.js'
import { part } from '../draw/dom.js'
import { fetchWithPatience } from '../load/timeouts.js'
import { WIDGETS } from '../widgets/index.js'
import { awaken } from './figures.js'
import { takeAlong } from './log-along.js'
import { Answer, PASTED } from './log-answer.js'
import { NONE, isCorrected, markOf, written } from './log-corrections.js'
import { Bench } from './log-bench.js'
import { shortName } from './file-name.js'
import { EXAMPLES, PUZZLE, addressOf } from './log-examples.js'
import { FileForm } from './log-files.js'
import { Forms } from './log-forms.js'
import { openedBy } from './log-numbers.js'
import { printReport } from './log-print.js'
import { readingBar } from './log-reading.js'
import { Report } from './log-report.js'
import { sight } from './log-sight.js'

/** Larger files are refused before they are read, bytes. */
const MOST_BYTES = 64_000_000
const GIVEN_UP = 'Reading was given up. The figure keeps the previous log.'

export function ownLog() {
  const place = document.querySelector('.own-log')
  if (place) new OwnLog(/** @type {HTMLElement} */ (place))
}

class OwnLog {
  /** @param {HTMLElement} place */
  constructor(place) {
    this.figure = /** @type {HTMLElement & { figure: any }} */ (place.querySelector('robot-log'))
    const report = /** @type {HTMLElement} */ (place.querySelector('.log-report'))
    this.forms = new Forms(this.figure, () => this.run())
    this.bench = new Bench(this.figure, this.forms.box, {
      change: this.forms.change,
      follow: () => this.forms.follow(),
      fit: this.forms.fitTogether,
      settled: this.forms.settled,
      stop: this.forms.stopFit,
      may: () => this.held !== undefined && this.set === this.held,
      reread: (corrections) => this.reread({ corrections }),
    })
    this.forms.keep = (patch, before) => this.bench.mend.keep(patch, before)
    this.report = new Report(report, {
      table: (kind) => this.download(kind),
      print: () => printReport(this.figure),
    })
    // The page has the controls from the start, so that nothing moves when this script comes.
    this.choose(place)
    this.text = /** @type {HTMLTextAreaElement} */ (place.querySelector('.log-paste textarea'))
    this.press(place, '.log-paste button', () => this.pasted())
    this.examples(place)
    this.answer = new Answer(/** @type {HTMLElement} */ (place.querySelector('.log-answer')), this.text)
    this.form = new FileForm(/** @type {HTMLElement} */ (place.querySelector('.log-files')), (change) =>
      this.reread(change),
    )
    /** The question that brought the files that the form shows. @type {number | undefined} */
    this.set = undefined
    /** The one that brought the files of the log that the figure shows. @type {number | undefined} */
    this.held = undefined
    /** The files of the log, as they are read. @type {import('estimate-wasm').LogFile[]} */
    this.files = []
    /** What the page corrected in them before it wrote them. @type {import('estimate-wasm').LogCorrections | null} */
    this.mark = null
    this.along = takeAlong(this.report.box, {
      run: () => this.run(),
      files: () => this.files,
      isLog: () => this.set === this.held,
      mark: () => this.mark,
      reread: (change) => this.reread(change),
      change: (patch) => this.forms.change(patch),
    })
    /** How often the reader has given up a reading. */
    this.given = 0
    this.dropped()
    // A name with a letter that the page has not shown yet would fetch a face later on: from now on nothing is fetched.
    for (const face of document.fonts) if (/Plain|Code|Text/.test(face.family)) face.load().catch(() => {})
    this.figure.addEventListener('frame', () => this.show())
    this.run().then(
      ({ contents }) => {
        if (!this.report.contents) this.hold(contents, [EXAMPLES.mower.file])
        if (!this.answer.box.hasChildNodes())
          this.answer.say(`The figure shows the mower’s log until you open another. ${this.facts()}`)
        this.show()
      },
      () => {},
    )
    const wanted = EXAMPLES[new URL(location.href).searchParams.get('example') ?? '']
    if (wanted) this.open(wanted)
  }

  // What the reader gives.

  /** @param {Element} box @param {string} selector of its button @param {() => void} press */
  press(box, selector, press) {
    box.querySelector(selector)?.addEventListener('click', press)
  }

  /** @param {Element} place */
  choose(place) {
    const input = /** @type {HTMLInputElement} */ (place.querySelector('.log-drop input'))
    /** @type {HTMLElement | null} */
    this.chooser = place.querySelector('.log-drop button')
    this.press(place, '.log-drop button', () => input.click())
    input.addEventListener('change', () => {
      if (input.files?.length) this.give([...input.files])
      // The same file may be chosen again once it has been mended.
      input.value = ''
    })
  }

  pasted() {
    const { value } = this.text
    if (value.trim() === '')
      return this.answer.say('The box has no rows. Paste rows of a log or of a table into it first.')
    this.give([new File([value], PASTED)])
  }

  /** @param {Element} place */
  examples(place) {
    for (const box of place.querySelectorAll('.log-example')) {
      const one = EXAMPLES[/** @type {HTMLElement} */ (box).dataset.example ?? '']
      this.press(box, 'button', () => this.open(one))
      const link = /** @type {HTMLAnchorElement} */ (box.querySelector('a'))
      link.href = addressOf(one).href
      link.download = one.file
    }
  }

  /** Takes files that are dropped anywhere: a browser would leave the page for them. */
  dropped() {
    const over = (/** @type {DragEvent} */ event) => {
      if (!event.dataTransfer?.types.includes('Files')) return
      event.preventDefault()
      document.documentElement.toggleAttribute('data-dragged', event.type === 'dragover')
      if (event.type === 'drop' && event.dataTransfer.files.length > 0) this.give([...event.dataTransfer.files])
    }
    for (const kind of /** @type {const} */ (['dragover', 'dragleave', 'drop'])) document.addEventListener(kind, over)
  }

  /** @param {(typeof EXAMPLES)[string]} one of ours */
  async open(one) {
    this.answer.say(`Fetching ${one.file} …`)
    try {
      const bytes = await fetchWithPatience(addressOf(one)).then((answer) => answer.arrayBuffer())
      await this.give([new File([bytes], one.file)], one.exercise)
    } catch {
      this.answer.say(`${one.file} could not be fetched.`)
    }
  }

  // What the worker makes of it.

  /**
   * Settings among the files are taken once the others have been read.
   * @param {File[]} given @param {boolean} [exercise] whether one asks about them
   */
  give(given, exercise) {
    const files = given.map((file) =>
      shortName(file.name) === file.name ? file : new File([file], shortName(file.name)),
    )
    const bytes = files.reduce((sum, { size }) => sum + size, 0)
    if (bytes > MOST_BYTES)
      return this.answer.say(`The files have ${Math.ceil(bytes / 1e6)} MB; at most ${MOST_BYTES / 1e6} MB can be read.`)
    const read = (/** @type {File[]} */ log) => this.take({ kind: 'files', files: log, exercise })
    return this.along.give(files, read, this.answer.tell.bind(this.answer))
  }

  /** @param {import('../widgets/robot-log/remote-run.js').Question} question */
  async take(question) {
    const { given } = this
    const bring = question.kind === 'files' ? sight() : () => {}
    const bar = readingBar(question.kind === 'files' ? question.files : [], () => this.giveUp())
    this.answer.begin(bar.box)
    try {
      const run = await this.run()
      if (given !== this.given) return this.answer.end(bar.box)
      run.onreading = bar.show
      const answer = await run.read(question)
      if (question.kind === 'files') this.mark = await markOf(question.files[0])
      this.answer.end(bar.box)
      this.set = answer.set
      this.form.show(answer.files)
      this.files = answer.files
      if (answer.kind === 'log') this.understood(answer, answer.set !== this.held, run.asks)
      else if (answer.kind === 'no-log') this.answer.wrong(answer)
      else this.answer.say(`${answer.message ?? answer.why} The figure keeps the previous log.`)
      this.figure.figure.ask()
      bring(this.answer.box)
      await this.along.arrived()
    } catch (error) {
      this.answer.end(bar.box)
      this.answer.say(error instanceof Error ? error.message : 'The log could not be read.')
      bring(this.answer.box)
    }
  }

  /** Gives up whatever is being read or waits to be. */
  giveUp() {
    this.given += 1
    this.answer.bar = null
    this.answer.say(GIVEN_UP)
    this.figure.figure?.run?.giveUp()
    // The button that had the focus is gone.
    if (document.activeElement === document.body) this.chooser?.focus({ preventScroll: true })
  }

  /**
   * The figure's run, once the figure is alive.
   * @returns {Promise<import('../widgets/robot-log/remote-run.js').RemoteRun>}
   */
  async run() {
    const { figure } = this
    await awaken(figure, WIDGETS)
    if (figure.dataset.state === 'still') figure.figure.start()
    while (!figure.figure?.run) {
      if (figure.dataset.state === 'failed')
        throw new Error('The figure below could not start, and reads no log. Try again there first.')
      await new Promise((resolve) => setTimeout(resolve, 50))
    }
    return figure.figure.run
  }

  /** @param {any} contents @param {string[]} names of the files @param {import('estimate-wasm').LogFile[]} [files] */
  hold(contents, names, files = []) {
    this.report.take(contents, names, files)
    this.forms.take(contents)
    this.bench.begin(contents)
  }

  /** Shows the frame that is there, among the figure's panels and below it. */
  show() {
    const { run } = this.figure.figure
    this.bench.show(run.frame)
    this.report.show(this.figure.figure)
    this.forms.show(run.frame)
  }

  /** What the log holds, in sentences. */
  facts() {
    return this.report
      .facts()
      .map(([name, value]) => `${name}: ${value}.`)
      .join(' ')
  }

  /**
   * @param {any} answer
   * @param {boolean} other whether it is another log, and not the same one read otherwise
   * @param {boolean} asks whether an exercise asks about it
   */
  understood({ set, contents, files, parameters }, other, asks) {
    this.held = set
    const added = files.filter((/** @type {any} */ { again }) => again === null)
    const names = added.map((/** @type {any} */ { name }) => name)
    this.hold(contents, names, files)
    const told = this.forms.begin(contents, parameters, other, names)
    const begins = contents.opening ? ` The filter starts where the first ${openedBy(contents)} say.` : ''
    this.answer.say(`${this.facts()}${begins}`)
    const notes = asks ? [PUZZLE, ...contents.notes] : contents.notes
    for (const note of notes) part(document, this.answer.box, 'p', '').textContent = note
    this.answer.lead()
    if (told) this.answer.offer(told, () => this.forms.change(told.patch))
    // The figure may be far from the window, and takes no turns by itself there: the report below must not stay behind.
    this.forms.follow()
    if (isCorrected(contents)) this.answer.correct(() => this.reread({ corrections: NONE }))
  }

  /** Reads the files of the log otherwise. @param {import('../widgets/robot-log/change.js').Change} change */
  reread(change) {
    return this.take({ kind: 'reading', set: this.set, change })
  }

  // What the reader takes away.

  /** @param {'track' | 'innovations' | 'log'} kind */
  async download(kind) {
    const run = await this.run()
    const { text, message } = await run.table(kind)
    const rows = text && kind === 'log' ? written(text, run.contents.corrections) : text
    if (!rows) return this.report.say(message)
    save(`${kind}.csv`, 'text/csv', rows)
    this.report.saved(kind)
  }
}
