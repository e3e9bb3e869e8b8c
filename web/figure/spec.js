/**
 * The types of a widget: plain data and pure functions, in the order state, model, view, controls. `figure/figure.js`
 * runs it in a browser, `figure/still.js` draws it in Node.
 */

/** @typedef {Record<string, import('estimate-wasm').Parameter>} Limits what the lab knows of each parameter */

/**
 * @typedef {object} Beat how far the animation of a step has come
 * @property {'predict' | 'update' | 'rest'} name
 * @property {number} t from 0 to 1, eased
 *
 * @typedef {object} HandleSpec a place the reader can move
 * @property {[number, number]} at pixels in its panel
 * @property {string} label what it moves, for screen readers
 * @property {import('../draw/words.js').Words} [name] what it moves, written beside it
 * @property {[number, number]} [nameAt] where the name stands, from the middle of the handle; right of it if not given
 * @property {string} value its value in words
 * @property {boolean} [small] drawn small; the finger has the same room
 * @property {boolean} [pressed] whether it goes to where its panel is pressed
 * @property {import('../draw/plot.js').Kin} [kin]
 * @property {number} [now] `aria-valuenow`; of a handle with two values, the one that Home and End change
 * @property {number} [min]
 * @property {number} [max]
 * @property {(x: number, y: number) => Record<string, unknown>} move pixels in its panel → a change of parameters;
 * `step` among
 *   them is none, the run goes there
 * @property {(dx: number, dy: number) => Record<string, unknown>} nudge what an arrow key changes: (±1, 0) or (0, ±1),
 * y upwards,
 *   times 10 with Shift and for the Page keys; the widget decides how far one step goes
 * @property {(end: 'home' | 'end') => Record<string, unknown>} [jump] what Home and End change
 *
 * @typedef {object} View what a drawing may know besides the frame
 * @property {any} previous the frame of the step before, or null
 * @property {Beat} beat
 * @property {number} elapsed milliseconds since the last drawing; infinite for the first and for a still
 * @property {Record<string, any>} memory what the figure keeps between two drawings, its cameras, and beside them
 * `far`, the frame of this run that has come farthest; empty at first, and for a still
 * @property {Limits} limits how far each parameter goes
 * @property {any} aside what has been computed beside the run, as far as it has come; null before
 * @property {(pen: import('../draw/pen.js').Pen, key: string, handle: HandleSpec) => void} handle draws a handle; alive
 * only in a browser
 *
 * @typedef {object} PanelSpec
 * @property {string} name
 * @property {number} width on a wide page, pixels
 * @property {number | ((frame: any) => number)} height
 * @property {boolean} [handles] whether something in it can be dragged
 * @property {(frame: any) => boolean} [shown] whether it is there; always if not given, and the first panel always is
 * @property {boolean} [aside] whether it shows what is computed beside the run
 * @property {(panel: import('./shell.js').Panel, frame: any, view: View) => boolean | void} draw true while it still
 * moves;
 *   `frame.params` are what the reader has asked for: while a long run is computed the rest of the frame is of the run
 * before
 *
 * @typedef {object} Try
 * @property {string} name unique
 * @property {import('../draw/words.js').Words} label
 * @property {(frame: any, lab: any) => Record<string, unknown>} change parameters, and `step` where the run is to go to
 * one
 * @property {(frame: any) => boolean} [shown] whether it fits what the reader has; always if not given
 *
 * @typedef {Widget & import('../widgets/index.js').Listed} FigureSpec a widget, with what the list of figures says of
 * it
 *
 * @typedef {object} Widget
 * @property {{ params: Record<string, any>, step: number }} start the state it opens in
 * @property {number} [still] the step of the still, which readers without scripts see and paper has; the start's if not
 * given
 * @property {import('./layout.js').Layout} layout where the panels stand
 * @property {Try[]} [tries] what to try: phrases that set the figure
 * @property {import('../draw/words.js').Words} [invite] what the button over the first panel says at step 0; it plays
 * @property {number} [lap] play stops at each multiple of so many steps
 * @property {(frame: any) => number} [end] the step that a run has no more behind: play stops there, and begins the run
 * anew from there
 * @property {(far: any, frame: { step: number }) => boolean} [whole] whether a run that is changed is computed as far
 * as it had come, in `far`, while the screen shows a step of before: what it draws of the whole run stays whole
 * @property {(id: string, given: string | undefined, spec: FigureSpec) => Promise<Opened>} [open] opens the run where
 * the lab is not in the page
 * @property {Aside} [aside] what is computed beside the run and is no part of its frame
 * @property {string} [log] the log that its lab replays, in the repository
 * @property {Stages} [stages] what a figure that opens small in the text shows later
 * @property {boolean} seeded whether `seed` is among the parameters
 * @property {boolean} [slow] whether it often computes for longer than a moment: a line is kept for how far it is
 * @property {boolean} [timeless] a lab without steps: no Play, Step, Reset, speed
 * @property {number} [pace] steps a second at speed 1; 2 if not given
 * @property {number} [stride] steps of one press on Step; 1 if not given
 * @property {boolean} [beats] whether a step is animated in two beats
 * @property {PanelSpec[]} panels the first is the one that the reader watches and drags: it is drawn first in every
 * turn, and its
 *   camera may move between two frames
 * @property {(frame: any) => Record<string, string>} describe each panel in words; empty for one that is not there
 * @property {import('./controls.js').Control[]} controls
 * @property {(frame: any) => import('./shell.js').Readout[]} readouts the same keys each time
 * @property {(frame: any) => import('../draw/words.js').Words} [verdict] the state in one sentence, shown; every σ is
 * set as a symbol
 * @property {(frame: any, previous: any) => string} announce what has changed, for screen readers
 * @property {(frame: any) => Record<string, any[]>} series columns of the CSV
 */

/**
 * @typedef {object} Stages A figure may open small in the text and grow as the text comes to its parts: at stage 1 it
 * has what is not named here, at stage 3 all. On its own page, on paper and without scripts it is whole.
 * @property {Record<string, 2 | 3>} panels the stage from which a panel is there
 * @property {Record<string, 2 | 3>} hand the same of a control, or of `tries`, `readouts`, `tools`, `speed`, `seed`
 * @property {import('../draw/words.js').Words[]} grow what the buttons say that lead to stage 2 and to stage 3
 */

/**
 * @typedef {object} Aside
 * @property {(lab: any) => any} whole computes all of it at once, for a still
 * @property {(changed: () => void) => Beside} open begins it; `changed` is called when there is more of it
 *
 * @typedef {object} Beside what is being computed beside a run
 * @property {any} value what `view.aside` gives to the panels, another object after each change
 * @property {import('./progress.js').Work | null} progress how far it has come; null when nothing is left to compute
 * @property {(frame: any) => void} follow tells it which frame is on the screen
 * @property {() => void} cancel gives the rest up
 */

/** @typedef {{ ok: true, run: any, mangled: boolean } | { ok: false, why: string }} Opened */

export {}
