//! One row of a log, read from its fields.

use crate::error::Error;
use crate::fields::{Field, Line};
use estimate::Landmark;
use estimate::drive::{Event, Pose, Row};

/// The greatest time of a row, seconds either side of 0. Unix times fit, and differences of times keep a microsecond.
pub const MAX_TIME: f64 = 1e11;

/// The letters, as an error lists them.
const LETTERS: &str = "L, G, D, O, V, S, T, VE, SE, TE, R, B, P or H";

/// A row as it is read, where a sighting names its landmark by id and may stand before it.
pub(crate) enum Read {
    Landmark(Landmark),
    Truth(Pose),
    /// Whether it was driven evenly.
    Motion(Row, bool),
    /// A reading of the robot's own position or heading.
    Pose(Row),
    /// The row has no landmark's index yet.
    Sighting(Row, u32),
}

/// The row of a line.
///
/// # Errors
/// The letter is unknown, a field is missing, superfluous or no finite number, a range is negative, a standard
/// deviation is not above 0, an id is no whole number, a time is out of bounds.
pub(crate) fn read(line: &Line<'_>) -> Result<Read, Error> {
    let letter = line.fields[0];
    let form = match letter.text {
        "L" => "L,id,x,y",
        "G" => "G,t,x,y,theta",
        "D" => "D,t,distance,turn",
        "O" => "O,t,distance,turn",
        "V" => "V,t,v,omega",
        "S" => "S,t,v",
        "T" => "T,t,omega",
        "VE" => "VE,t,v,omega",
        "SE" => "SE,t,v",
        "TE" => "TE,t,omega",
        "P" => "P,t,x,y[,sigma]",
        "H" => "H,t,theta[,sigma]",
        "R" => "R,t,id,range",
        "B" => "B,t,id,range,bearing",
        _ => return Err(unknown_letter(line)),
    };
    let names: Vec<&str> = form.split(',').map(|name| name.trim_end_matches('[')).collect();
    let (most, found) = (names.len(), line.fields.len());
    let least = most - usize::from(form.ends_with(']'));
    if !(least..=most).contains(&found) {
        let column = line.fields.get(most).map_or(line.end, |extra| extra.column);
        let wanted = if least < most { format!("{least} or {most}") } else { most.to_string() };
        let message = format!("the row has {found} fields; {wanted} were expected: {form}");
        return Err(Error::new(line.number, column, message));
    }
    let number = |i: usize| finite(line, line.fields[i], names[i]);
    let time = || in_bounds(line, line.fields[1], number(1)?);
    let id = |i: usize| whole(line, line.fields[i]);
    let range = |i: usize| not_negative(line, line.fields[i], number(i)?);
    let sigma = |i: usize| line.fields.get(i).map(|field| deviation(line, *field)).transpose();
    Ok(match letter.text {
        "L" => Read::Landmark(Landmark { id: id(1)?, x: number(2)?, y: number(3)? }),
        "G" => Read::Truth(Pose { time: time()?, x: number(2)?, y: number(3)?, theta: number(4)? }),
        even @ ("D" | "O") => {
            let row = Row::new(time()?, Event::Odometry { distance: number(2)?, turn: number(3)? });
            Read::Motion(row, even == "D")
        }
        even @ ("V" | "VE") => {
            let row = Row::new(time()?, Event::Velocity { v: number(2)?, omega: number(3)? });
            Read::Motion(row, even == "VE")
        }
        even @ ("S" | "SE") => Read::Motion(Row::new(time()?, Event::Speed { v: number(2)? }), even == "SE"),
        even @ ("T" | "TE") => Read::Motion(Row::new(time()?, Event::TurnRate { omega: number(2)? }), even == "TE"),
        "P" => Read::Pose(Row::new(time()?, Event::Position { x: number(2)?, y: number(3)?, sigma: sigma(4)? })),
        "H" => Read::Pose(Row::new(time()?, Event::Heading { theta: number(2)?, sigma: sigma(3)? })),
        "R" => {
            let (time, id) = (time()?, id(2)?);
            Read::Sighting(Row::new(time, Event::Range { landmark: 0, range: range(3)? }), id)
        }
        _ => {
            let (time, id) = (time()?, id(2)?);
            let event = Event::RangeBearing { landmark: 0, range: range(3)?, bearing: number(4)? };
            Read::Sighting(Row::new(time, event), id)
        }
    })
}

/// What stands where a row's letter was expected: a quoted letter and another separator get a word of their own.
fn unknown_letter(line: &Line<'_>) -> Error {
    let Field { text, column } = line.fields[0];
    let separator = text.chars().find(|c| matches!(c, ';' | '\t' | ' ' | '|'));
    let message = match separator {
        _ if text.starts_with(['"', '\'']) => quoted(text),
        Some(' ') => "blanks were found between the fields; fields are parted by commas".into(),
        Some('\t') => "tabs were found between the fields; fields are parted by commas".into(),
        Some(found) => format!("'{found}' was found between the fields; fields are parted by commas"),
        None if text.is_empty() => format!("the line begins with an empty field; {LETTERS} was expected"),
        None => format!("{} is no row's letter; {LETTERS} was expected", shown(text)),
    };
    Error::new(line.number, column, message)
}

/// A number; in a table whose fields no commas part, a comma may be its decimal point.
pub(crate) fn number(text: &str) -> Option<f64> {
    text.parse().ok().or_else(|| {
        let (whole, fraction) = text.split_once(',')?;
        fraction.starts_with(|c: char| c.is_ascii_digit()).then(|| format!("{whole}.{fraction}").parse().ok())?
    })
}

pub(crate) fn finite(line: &Line<'_>, field: Field<'_>, name: &str) -> Result<f64, Error> {
    let wrong = |message: String| Error::new(line.number, field.column, message);
    match number(field.text) {
        Some(number) if number.is_finite() => Ok(number),
        _ if field.text.is_empty() => Err(wrong(format!("{name} is missing; a number was expected"))),
        _ if field.text.starts_with(['"', '\'']) => Err(wrong(quoted(field.text))),
        _ => Err(wrong(format!("{name} is {}; a finite number was expected", shown(field.text)))),
    }
}

pub(crate) fn in_bounds(line: &Line<'_>, field: Field<'_>, time: f64) -> Result<f64, Error> {
    if time.abs() <= MAX_TIME {
        // -0 becomes 0, so that the two are one time.
        return Ok(time + 0.0);
    }
    // Unix times of our days in other units.
    let unit = [("milli", 1e3), ("micro", 1e6), ("nano", 1e9)].into_iter().find(|(_, factor)| {
        let seconds = time.abs() / factor;
        (1e8..=MAX_TIME).contains(&seconds)
    });
    let meant = unit.map_or(String::new(), |(name, factor)| {
        format!("; it looks like a Unix time in {name}seconds: choose that unit, or divide by {factor:e}")
    });
    let message = format!("the time is {}; times within {MAX_TIME:e} s were expected{meant}", shown(field.text));
    Err(Error::new(line.number, field.column, message))
}

fn not_negative(line: &Line<'_>, field: Field<'_>, range: f64) -> Result<f64, Error> {
    if range >= 0.0 {
        return Ok(range);
    }
    let message = format!("the range is {}; a range of at least 0 was expected", shown(field.text));
    Err(Error::new(line.number, field.column, message))
}

/// A row's own standard deviation, which the brackets of its form name.
pub(crate) fn deviation(line: &Line<'_>, field: Field<'_>) -> Result<f64, Error> {
    match finite(line, field, "sigma")? {
        sigma if sigma > 0.0 => Ok(sigma),
        _ => {
            let message = format!("sigma is {}; a standard deviation above 0 was expected", shown(field.text));
            Err(Error::new(line.number, field.column, message))
        }
    }
}

/// A whole number below 2³², as digits alone: `5.0` and `+5` would name a landmark that no `L` row writes so.
fn whole(line: &Line<'_>, field: Field<'_>) -> Result<u32, Error> {
    let digits = !field.text.is_empty() && field.text.bytes().all(|b| b.is_ascii_digit());
    field.text.parse().ok().filter(|_| digits).ok_or_else(|| {
        let message = match field.text {
            text if text.starts_with(['"', '\'']) => quoted(text),
            text => format!("the landmark's id is {}; a whole number below 2^32 was expected", shown(text)),
        };
        Error::new(line.number, field.column, message)
    })
}

fn quoted(text: &str) -> String {
    format!("{} is quoted; fields are written without quotes", shown(text))
}

/// A field as an error quotes it: the beginning of a long one.
fn shown(text: &str) -> String {
    const MOST: usize = 20;
    match text.char_indices().nth(MOST) {
        _ if text.is_empty() => "empty".into(),
        None => format!("'{text}'"),
        Some((cut, _)) => format!("'{}…'", &text[..cut]),
    }
}
