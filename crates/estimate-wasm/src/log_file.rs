//! A file of a log as the page shows it: how it is read, and what it asks.

use crate::encode::{list, record};
use js_sys::Array;
use robot_log::{Counting, Error, File, Files, Frame, OtherClock, Own, Rigid, Role, WHEEL_NUMBERS, units_of};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What a file of a log is. */
export type LogRole = "log" | "velocities" | "odometry" | "encoders" | "reckoned" | "sensors" | "sightings" | "ranges"
    | "landmarks" | "truth" | "barcodes" | "undecided" | "unused";
/** A value that a file's role has. */
export interface LogValue {
    name: string;
    /** Whether a file may do without it. */
    optional: boolean;
    /** The column it is read from, counted from 0. */
    column: number | null;
    /** The unit it is read in: null where it has none, or where that has to be said. */
    unit: string | null;
    /** The units it may be in. */
    units: string[];
    /** Whether its column or its unit has to be said. */
    asked: boolean;
    /** Three values of its column, as they stand in the file. */
    samples: string[];
}
/** Ticks of a turn of the wheel, its radius and the distance between the wheels in m, and how the encoders count. */
export interface LogWheels {
    ticks: number | null;
    radius: number | null;
    base: number | null;
    counting: "total" | "step" | "restarted" | null;
}
/** The rows of several robots or tags in one file, which a column tells apart. */
export interface LogSeveral {
    /** The column, counted from 0. */
    column: number;
    /** What stands in it, and in how many rows. */
    values: { value: string; rows: number }[];
    /** Whose rows are read; null where all are, and where that is asked. */
    only: string | null;
    /** Whether it has to be said whose rows are read. */
    asked: boolean;
}
/** What brings a truth onto the log's fixes: mirrored (y against itself), turned about its origin, then shifted. */
export interface LogOwn {
    /** Whether its frame is another one than the fixes'; else mirrored is false and turn and shift are 0. */
    framed: boolean;
    mirrored: boolean;
    /** rad, counter-clockwise. */
    turn: number;
    /** m. */
    shift: [number, number];
    /** How far its stamps are shifted, s; 0 where its clock is the log's. */
    delay: number;
}
/** Which frame and clock a truth has: those of the fixes; another origin, and the truth is moved onto the fixes, or the
    origin is said; or its own, and the truth is turned, shifted and shifted in time onto the fixes. */
export interface LogOrigin {
    /** Null where it has to be said. */
    said: "same" | "moved" | "at" | "own" | null;
    /** Where its origin is "at", as it was said: latitude and longitude, degrees. */
    origin: [number, number] | null;
    /** Whether its places are counted from another point than the fixes', as their units say: it may be "moved", or
        "at" a point. */
    foreign: boolean;
    /** Whether its places are in metres beside latitudes and longitudes, and no truth's: they may be "at" a point. */
    beside: boolean;
    /** What the fixes and the motion tell: it may be "own"; else null. */
    own: LogOwn | null;
}
/** The clock of a file beside that of the motion. */
export interface LogClock {
    /** What is added to its times, s; null where nothing has been said. */
    said: number | null;
    /** Whether it has to be said: its times do not meet the motion's, or begin and end as much later or earlier. */
    asked: boolean;
    /** The quarters of an hour, days, or GPS time's 18 s that bring its times into the motion's; else null. */
    zone: number | null;
    /** What lets it begin with the motion, s. */
    together: number;
    /** The least and the most by which it meets the motion, s. */
    meets: [number, number];
}
/** What is wrong with a file, and where: line and character are counted from 1. */
export interface LogFault {
    line: number;
    column: number;
    message: string;
}
/** How a file of a log is read. */
export interface LogFile {
    name: string;
    role: LogRole;
    /**
     * Where among the files the one stands that is read once more as this one, as a table is that holds the motion,
     * ranges or positions besides; null of a file that was added.
     */
    again: number | null;
    /** What its columns are called; empty of a log in the book's own format. */
    header: string[];
    values: LogValue[];
    /** The columns from which nothing is read, here or where the file is read once more, counted from 0. */
    unread: number[];
    /** What encoders need besides; null of another file. */
    wheels: LogWheels | null;
    /** What of them has to be said in the unit of its columns; empty of another file. */
    needs: ("ticks" | "radius" | "base" | "counting")[];
    /** The rows of several robots; null where no column tells such apart. */
    several: LogSeveral | null;
    /** The frame of a truth that does not lie on the fixes; null of a file that is not asked. */
    frame: LogOrigin | null;
    /** Its clock beside that of the motion; null of a file without times, and of the one that has the log's. */
    clock: LogClock | null;
    /** What has to be said before the file can be read: a guess that is not certain chooses nothing. */
    asks: string[];
    /** The roles that the question of what the file is names as its answers; empty where any may be one. */
    answers: LogRole[];
    /** What follows from how it is read, in words, such as "20 Hz, 0 to 120 s, turned 2 turns". */
    follows: string;
    /** What is wrong with it whatever the other files are, as far as that is known: the first fault of its rows. */
    fault: LogFault | null;
}
"#;

pub(crate) const COUNTINGS: [(&str, Counting); 3] =
    [("total", Counting::Total), ("step", Counting::Step), ("restarted", Counting::Restarted)];
pub(crate) const FRAMES: [(&str, Frame); 3] = [("same", Frame::Same), ("moved", Frame::Moved), ("own", Frame::Own)];

pub(crate) fn texts<T: AsRef<str>>(all: impl IntoIterator<Item = T>) -> JsValue {
    all.into_iter().map(|text| JsValue::from_str(text.as_ref())).collect::<Array>().into()
}

/// The rows of several robots in a file.
fn several(file: &File) -> JsValue {
    let Some((column, values)) = file.several() else { return JsValue::NULL };
    let each = values.iter().map(|(value, rows)| record(&[("value", value.into()), ("rows", (*rows as f64).into())]));
    record(&[
        ("column", (column as u32).into()),
        ("values", each.collect::<Array>().into()),
        ("only", file.only().flatten().map_or(JsValue::NULL, Into::into)),
        ("asked", file.only().is_none().into()),
    ])
}

/// Which frame and clock a truth has.
fn origin(file: &File) -> JsValue {
    if !file.is_foreign() && !file.is_beside() && file.own().is_none() {
        return JsValue::NULL;
    }
    let origin = if let Some(Frame::At(origin)) = file.frame() { Some(origin) } else { None };
    let said = FRAMES.iter().find(|(_, frame)| file.frame() == Some(*frame)).map(|(name, _)| *name);
    record(&[
        ("said", said.or(origin.map(|_| "at")).map_or(JsValue::NULL, Into::into)),
        ("origin", origin.map_or(JsValue::NULL, |origin| list(&origin))),
        ("foreign", file.is_foreign().into()),
        ("beside", file.is_beside().into()),
        ("own", file.own().map_or(JsValue::NULL, own)),
    ])
}

/// What may be added to the times of a file, and what is.
fn clock(OtherClock { asked, zone, together, meets, .. }: &OtherClock, said: Option<f64>) -> JsValue {
    let number = |number: Option<f64>| number.map_or(JsValue::NULL, Into::into);
    record(&[
        ("said", number(said)),
        ("asked", (*asked).into()),
        ("zone", number(*zone)),
        ("together", (*together).into()),
        ("meets", list(meets)),
    ])
}

/// What brings a truth onto the fixes.
fn own(own: &Own) -> JsValue {
    let frame = own.frame.unwrap_or(Rigid { mirrored: false, turn: 0.0, shift: [0.0; 2] });
    record(&[
        ("framed", own.frame.is_some().into()),
        ("mirrored", frame.mirrored.into()),
        ("turn", frame.turn.into()),
        ("shift", frame.shift.map(JsValue::from_f64).into_iter().collect::<Array>().into()),
        ("delay", own.delay.into()),
    ])
}

/// How a file is read. Of one in the book's own format that is the whole log, whether it is wrong is said where it is
/// read.
pub(crate) fn shown(files: &Files, at: usize) -> JsValue {
    let (file, whole) = (&files.files()[at], files.files().len() == 1);
    let columns = file.columns().iter().zip(file.units());
    let values = file.role().values().iter().zip(columns).enumerate().map(|(i, (value, (column, unit)))| {
        record(&[
            ("name", value.name.into()),
            ("optional", value.optional.into()),
            ("column", column.map_or(JsValue::NULL, |column| (column as u32).into())),
            ("unit", unit.map_or(JsValue::NULL, |unit| unit.name.into())),
            ("units", texts(units_of(value.quantity).iter().map(|unit| unit.name))),
            ("asked", file.is_asked(i).into()),
            ("samples", texts(column.map_or(Vec::new(), |column| file.samples(column)))),
        ])
    });
    let wheels = || {
        let said = |counting| COUNTINGS.iter().find(|(_, it)| *it == counting).map(|(name, _)| *name);
        let counting = file.wheels().counting.and_then(said);
        let numbers = WHEEL_NUMBERS.map(|name| (name, file.wheels().number(name).map_or(JsValue::NULL, Into::into)));
        let [ticks, radius, base] = numbers;
        record(&[ticks, radius, base, ("counting", counting.map_or(JsValue::NULL, Into::into))])
    };
    let (follows, faulty) = if whole && file.role() == Role::Log { (String::new(), None) } else { file.alone() };
    let fault = |Error { line, column, message, .. }| {
        record(&[("line", line.into()), ("column", column.into()), ("message", message.into())])
    };
    record(&[
        ("name", file.name().into()),
        ("role", file.role().name().into()),
        ("again", file.again().map_or(JsValue::NULL, |of| (of as u32).into())),
        ("header", texts(file.header())),
        ("values", values.collect::<Array>().into()),
        ("unread", files.unread(at).into_iter().map(|at| JsValue::from(at as u32)).collect::<Array>().into()),
        ("several", several(file)),
        ("wheels", if file.role() == Role::Encoders { wheels() } else { JsValue::NULL }),
        ("needs", texts(file.needs())),
        ("frame", origin(file)),
        ("clock", file.other_clock().map_or(JsValue::NULL, |other| clock(other, file.clock_shift()))),
        ("asks", texts(file.asks())),
        ("answers", texts(file.answers().iter().map(|role| role.name()))),
        ("follows", follows.into()),
        ("fault", faulty.map_or(JsValue::NULL, fault)),
    ])
}
