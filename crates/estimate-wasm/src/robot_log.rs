//! A robot's log: read once, replayed by as many labs as one likes.

use crate::decode::Arg;
use crate::encode::{Row, record};
use crate::errors::Thrown;
use crate::lab::{AnyLab, RobotLog};
use crate::log_corrections;
use crate::log_file::texts;
use crate::log_opening;
use crate::log_readings::{own, readings};
use crate::object::Held;
use estimate::drive::{Opening, Settings, Summary, lacks, log_likelihood};
use estimate::validate::finite;
use estimate::{Code, Error, Landmark};
use js_sys::JsString;
use lab::{Lab, Params, Plain};
use labs::{LogParams, LoggedDrive};
use robot_log::{Corrections, Understood};
use std::cell::{OnceCell, RefCell};
use std::sync::{Arc, Weak};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What a log holds. */
export interface LogContents {
    /** All lines of the files that say something, landmarks and truth among them; comments and blank lines do not. */
    rows: number;
    /** The rows of motion and readings that these hold, which a replay takes: a line may have several. */
    steps: number;
    /** The first and the last time of these, seconds. */
    span: [number, number];
    /** The landmarks, at known places. */
    landmarks: Landmark[];
    /** What the files call the landmarks whose ids are 1, 2 and so on; empty where they have numbers. */
    names: string[];
    /** How the robot’s motion is logged: by odometry (D, O), or by rows that are held (V, S, T). */
    motion: "odometry" | "velocity";
    /** What no row of held motion reads. */
    lacks: "speed" | "turn rate" | null;
    /** Whether turn rates come from the encoders of two wheels alone: no gyro reads any. */
    wheels: boolean;
    /** How far apart these two wheels stand, metres, as was said; else null. */
    base: number | null;
    /** Whether headings are the courses of a receiver of positions. */
    course: boolean;
    /** What is read otherwise than its files have it. */
    corrections: LogCorrections;
    /** How many readings each sensor has; one without any is not there. */
    readings: { fix?: number; heading?: number; range?: number; bearing?: number };
    /** Of the sensors whose readings bring a σ of their own: how many do, and the least and the greatest of these. */
    own: { fix?: { count: number; sigmas: [number, number] }; heading?: { count: number; sigmas: [number, number] } };
    /** Whether a sighting has a bearing. */
    bearings: boolean;
    /** Whether it is known where the robot really was. */
    truth: boolean;
    /** Where the drive began by its first fixes, or without these by its first ranges, as parameters of a lab: null
        where neither tell it, or where the truth says it. */
    opening: LogOpening | null;
    /** What was left out of the log's files or added to them, in sentences. */
    notes: string[];
}
/**
 * Why a text is no log: an EstimateError with the code "log", and where the fault is; `file` counts from 0, the others
 * from 1. `line` and `column` are 0 where the fault is of all files together: no file has the robot's motion.
 */
export interface LogError extends EstimateError {
  code: "log";
  argument: "text";
  file: number;
  line: number;
  column: number;
}
export namespace RobotLog {
    /** Reads a log. What is no log throws a `LogError`, which says in which line and column. */
    function parse(text: string): DriveLog;
    /**
     * Σ −½ (ln det 2πS + νᵀS⁻¹ν) over the used readings that are stamped `from` or later, by the log's own clock, and
     * how many these are. It is what a search for noise levels and delays compares: a replay alone, without what a
     * figure shows. A sum rewards refusal, so a search has its gates off and a `from` behind every start that it tries.
     */
    function logLikelihood(
        log: DriveLog, params: Partial<LogParams>, from: number,
    ): { logLikelihood: number; used: number };
}
export interface RobotLog {
    /** All rows that are left. */
    runAll(): void;
    /**
     * Smooths the rows that are taken: the best track in the light of all their readings (Rauch, Tung and Striebel).
     * The log is replayed twice for it; a million rows take about a second, and less than 2 MB while it runs. The track
     * is `smoothed` of the frame, and what it says in the summary, until another row is taken or a parameter set.
     * A covariance that cannot be factored throws, naming the row, and leaves all as it was.
     */
    smooth(): void;
    /** What the replay says of itself so far. */
    summary(): LogSummary;
}
"#;

#[wasm_bindgen]
extern "C" {
    type Foreign;
    // One that may answer nothing: where it throws, it leaves nothing behind in the table of references.
    #[wasm_bindgen(method, catch)]
    fn handle(this: &Foreign) -> Result<Option<JsValue>, JsValue>;
}

thread_local! {
    /// The logs that are in use, by their handles.
    static LOGS: RefCell<Vec<(f64, Weak<LoggedDrive>)>> = const { RefCell::new(Vec::new()) };
}

/// A log that was read, kept in the module's memory until `free()` and for as long as a lab replays it.
#[wasm_bindgen]
#[repr(transparent)]
pub struct DriveLog(Held);

/// What a [`DriveLog`] holds.
struct LogContents {
    handle: f64,
    logged: Arc<LoggedDrive>,
    rows: usize,
    notes: Vec<String>,
    names: Vec<String>,
    base: Option<f64>,
    course: bool,
    corrections: Corrections,
    /// Where it began, once that was asked: a search.
    opening: OnceCell<Option<Opening>>,
}

const LOG: &str = "DriveLog";

#[wasm_bindgen]
impl DriveLog {
    /// What the log holds.
    #[wasm_bindgen(unchecked_return_type = "LogContents")]
    pub fn contents(&self) -> Result<JsValue, Thrown> {
        self.0.read(LOG, |held: &LogContents| {
            let (drive, [first, last]) = (held.logged.drive(), held.logged.span());
            let mut numbers = Vec::new();
            held.logged.drive().landmarks.write(&mut numbers);
            let landmarks = Row::new(&numbers).value(&<Vec<Landmark> as Plain>::SHAPE);
            record(&[
                ("rows", (held.rows as f64).into()),
                ("steps", held.logged.rows().into()),
                ("span", crate::encode::list(&[first, last])),
                ("landmarks", landmarks),
                ("motion", if drive.motion.is_odometry() { "odometry" } else { "velocity" }.into()),
                ("lacks", lacks(&drive.rows, drive.motion).map_or(JsValue::NULL, |lacking| lacking.name().into())),
                ("readings", readings(drive)),
                ("own", own(drive)),
                ("wheels", held.logged.is_by_wheels().into()),
                ("base", held.base.map_or(JsValue::NULL, Into::into)),
                ("course", held.course.into()),
                ("corrections", log_corrections::shown(&held.corrections)),
                ("bearings", held.logged.bearings().into()),
                ("truth", (!drive.truth.poses().is_empty()).into()),
                (
                    "opening",
                    log_opening::shown(*held.opening.get_or_init(|| log_opening::began(drive, &Settings::default()))),
                ),
                ("names", texts(&held.names)),
                ("notes", texts(&held.notes)),
            ])
        })
    }

    /// Where it began by its first readings as `params` read them; null where a truth says it, or they do not tell it.
    #[wasm_bindgen(unchecked_return_type = "LogOpening | null")]
    pub fn opening(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Partial<LogParams>")] params: &JsValue,
    ) -> Result<JsValue, Thrown> {
        self.0.is(LOG)?;
        let settings = log_opening::settings(params)?;
        self.0.read(LOG, |held: &LogContents| log_opening::shown(log_opening::began(held.logged.drive(), &settings)))
    }

    /// The number by which a lab knows this log.
    pub fn handle(&self) -> Result<f64, Thrown> {
        self.0.read(LOG, |held: &LogContents| held.handle)
    }
}

impl DriveLog {
    /// A log that was read.
    pub(crate) fn keep(read: Understood) -> Self {
        let robot_log::Log { drive, count } = read.log;
        let Understood { notes, landmarks: names, wheels, base, course, corrections, .. } = read;
        let logged = Arc::new(LoggedDrive::new(drive).by_wheels(wheels));
        let handle = LOGS.with_borrow_mut(|logs| {
            let handle = logs.last().map_or(1.0, |(last, _)| last + 1.0);
            logs.retain(|(_, log)| log.strong_count() > 0);
            logs.push((handle, Arc::downgrade(&logged)));
            handle
        });
        let opening = OnceCell::new();
        let held = LogContents { handle, logged, rows: count, notes, names, base, course, corrections, opening };
        Self(Held::new(LOG, held))
    }
}

/// The log behind a value of JavaScript.
pub(crate) fn logged(log: &JsValue) -> Result<Arc<LoggedDrive>, Error> {
    let handle = log.unchecked_ref::<Foreign>().handle().ok().flatten().and_then(|handle| handle.as_f64());
    let known = LOGS.with_borrow(|logs| {
        let (_, known) = logs.iter().find(|(known, _)| Some(*known) == handle)?;
        known.upgrade()
    });
    known.ok_or_else(|| Error::new(Code::Type, "log", "is no log; it must be what RobotLog.parse has answered"))
}

#[wasm_bindgen]
impl RobotLog {
    /// Reads a log. What is no log throws a `LogError`, which says in which line and column.
    pub fn parse(text: &JsValue) -> Result<DriveLog, Thrown> {
        let text = text_of(text)?;
        Ok(DriveLog::keep(robot_log::parse(&text)?.into()))
    }

    /// How likely the readings from a time on are under `params`.
    #[wasm_bindgen(js_name = logLikelihood)]
    pub fn log_likelihood(log: &JsValue, params: &JsValue, from: &JsValue) -> Result<JsValue, Thrown> {
        let log = logged(log)?;
        let params = LogParams::read(&mut Self::params(params)?.iter());
        let from = finite(Arg::new(from, "from").number()?, "from")?;
        let found = params.check().and_then(|()| log_likelihood(log.drive(), params.into(), from));
        let (sum, used) = found.map_err(|e| e.within("params"))?;
        Ok(record(&[("logLikelihood", sum.into()), ("used", used.into())]))
    }

    /// The log before its first row; what `params` leaves out takes its default.
    #[wasm_bindgen(constructor)]
    pub fn new(log: &JsValue, params: &JsValue) -> Result<RobotLog, Thrown> {
        let log = logged(log)?;
        Self::CLASS.open(params, &opener(&log)).map(Self)
    }

    /// The lab in a state that `state()` answered.
    pub fn from(log: &JsValue, state: &JsValue) -> Result<RobotLog, Thrown> {
        let log = logged(log)?;
        Self::CLASS.open_state(state, &opener(&log)).map(Self)
    }

    /// All rows that are left.
    #[wasm_bindgen(js_name = runAll)]
    pub fn run_all(&self) -> Result<(), Thrown> {
        Self::CLASS.advance(&self.0, labs::RobotLog::LAST_STEP)
    }

    /// Smooths the rows that are taken.
    pub fn smooth(&self) -> Result<(), Thrown> {
        Self::CLASS.change(&self.0, labs::RobotLog::smooth)
    }

    /// What the replay says of itself so far.
    pub fn summary(&self) -> Result<JsValue, Thrown> {
        let mut numbers = Vec::new();
        Self::CLASS.lab(&self.0, |lab: &labs::RobotLog| {
            lab.summary().write(&mut numbers);
            Ok(())
        })?;
        Ok(Row::new(&numbers).value(&Summary::SHAPE))
    }
}

impl RobotLog {
    /// The numbers of the parameters that `params` has; what it leaves out takes its default.
    pub(crate) fn params(params: &JsValue) -> Result<Vec<f64>, Error> {
        Self::CLASS.decode(&Arg::new(params, "params"), &LogParams::default().numbers())
    }
}

/// What makes a lab of this log.
fn opener(log: &Arc<LoggedDrive>) -> impl Fn(&[f64], u32) -> Result<AnyLab, Error> + '_ {
    |params, step| lab::open::<labs::RobotLog>(Arc::clone(log), params, step)
}

/// A text; one that is too long is refused before it is copied.
pub(crate) fn text_of(text: &JsValue) -> Result<String, Thrown> {
    match text.dyn_ref::<JsString>() {
        Some(string) if string.length() as usize > robot_log::MAX_BYTES => {
            let message = format!("the log has more than {} bytes", robot_log::MAX_BYTES);
            Err(robot_log::Error { file: 0, line: 1, column: 1, message }.into())
        }
        _ => Ok(Arg::new(text, "text").text()?),
    }
}
