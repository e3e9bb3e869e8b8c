//! What is said of a log that was read and still looks strange: sentences for its reader.

use crate::cells::{Cells, NoRange};
use crate::columns::clockwise;
use crate::ended::{begun_late, ended, ended_readings};
use crate::error::Error;
use crate::guess;
use crate::names::{Name, candidates};
use crate::role::{Quantity, Role};
use crate::sensed::{MISSED, READ};
use crate::source::Source;
use crate::stamps::Stamps;
use estimate::drive::{Drive, Event, Gaps, Missing, Row};

pub(crate) const HEADED: &str = "The truth has no heading; the first 0.2 m of its way gives the first one.";

/// What is counted while a file is read.
#[derive(Clone, Debug, Default)]
pub(crate) struct Counts {
    /// The times of its rows.
    pub stamps: Stamps,
    /// What two encoders had counted.
    pub counted: Option<[f64; 2]>,
    /// The pose that was reckoned last.
    pub reckoned: Option<[f64; 3]>,
    /// Fixes, and the headings of the same file.
    pub fixes: Repeats<[f64; 2]>,
    pub headings: Repeats<f64>,
    /// Rows, or ranges of rows, without a number.
    pub missing: usize,
    /// Ranges of 0, of −1 and without an end, by which sensors say that there was no echo or no answer.
    pub zero: usize,
    pub minus_one: usize,
    pub infinite: usize,
    /// Ranges of less than 0 by less than a metre: noise beside a landmark.
    pub negative: usize,
    /// Speeds and courses of −1, which says that they are not known.
    pub unknown: usize,
    /// Headings whose quaternion is tilted so far that they may be another axis's.
    pub tilted: usize,
    /// Headings of 65535, which says the same.
    pub no_heading: usize,
    /// Fixes at latitude and longitude 0.
    pub nowhere: usize,
    /// Standard deviations that are not above 0.
    pub without_sigma: usize,
}

/// What a file reads again and again, and which of it is the one before to the last digit.
#[derive(Clone, Debug, Default)]
pub(crate) struct Repeats<T> {
    before: Option<T>,
    pub count: usize,
    /// The rows of the log that are such copies.
    pub copies: Vec<usize>,
}

impl<T: PartialEq> Repeats<T> {
    /// Counts what becomes the log's row of this index.
    pub fn take(&mut self, it: T, row: usize) {
        self.count += 1;
        if self.before.as_ref() == Some(&it) {
            self.copies.push(row);
        }
        self.before = Some(it);
    }

    /// Whether each is written again until the next one comes: most are the one before.
    pub fn holds(&self) -> bool {
        self.count >= 5 && 2 * self.copies.len() > self.count
    }
}

impl Counts {
    /// A range that was not read.
    pub fn without(&mut self, none: NoRange) -> Result<(), Error> {
        match none {
            NoRange::Missing => self.missing += 1,
            NoRange::Zero => self.zero += 1,
            NoRange::MinusOne => self.minus_one += 1,
            NoRange::Infinite => self.infinite += 1,
            NoRange::Negative => self.negative += 1,
        }
        Ok(())
    }

    /// A standard deviation that the row has of its own; one that is not above 0 is none.
    pub fn sigma(&mut self, cells: Cells<'_>, value: &str) -> Result<Option<f64>, Error> {
        let given = cells.given(value)?;
        let sound = given.filter(|sigma| *sigma > 0.0);
        self.without_sigma += usize::from(given.is_some() && sound.is_none());
        Ok(sound)
    }

    /// The rows that were measured once and written again. Headings count only where the fixes beside them are written
    /// so: a compass of few digits reads the same twice and has measured twice.
    pub fn copies(&self) -> Vec<usize> {
        let Self { fixes, headings, .. } = self;
        match (fixes.holds(), headings.holds()) {
            (true, true) => fixes.copies.iter().chain(&headings.copies).copied().collect(),
            (true, false) => fixes.copies.clone(),
            _ => Vec::new(),
        }
    }

    /// What was strange in a file.
    pub fn notes(&self, name: &str, shared: bool) -> Vec<String> {
        let Self { fixes, headings, missing, unknown, nowhere, without_sigma, .. } = self;
        let (missing, unknown, nowhere, without_sigma) = (*missing, *unknown, *nowhere, *without_sigma);
        let Self { zero, minus_one, infinite, .. } = *self;
        let mut notes = self.stamps.notes(name);
        if fixes.holds() {
            let told = |copies: usize, count: usize, what| format!("{copies} of {count} {what}");
            let copies = told(fixes.copies.len(), fixes.count, "positions");
            let beside = if headings.holds() {
                format!(" and {}", told(headings.copies.len(), headings.count, "headings"))
            } else {
                String::new()
            };
            notes.push(format!(
                "{name}: {copies}{beside} are the one before to the last digit, and are left out: what is written \
                 again in each row until the next one comes was measured once."
            ));
        }
        if missing > 0 && !shared {
            notes.push(format!("{name}: {} without a number left out.", readings(missing)));
        }
        let ranges = [(zero, "0"), (minus_one, "\u{2212}1"), (infinite, "infinity")];
        for (count, what) in ranges.into_iter().filter(|(count, _)| *count > 0) {
            let what =
                if count == 1 { format!("1 range of {what} is") } else { format!("{count} ranges of {what} are") };
            notes.push(format!("{name}: {what} left out: so a sensor says that it has no reading."));
        }
        if self.negative > 0 {
            let what = if self.negative == 1 { "1 range" } else { &format!("{} ranges", self.negative) };
            notes.push(format!(
                "{name}: {what} below 0 left out: no distance is, but beside a landmark noise makes one."
            ));
        }
        if unknown > 0 {
            notes.push(format!(
                "{name}: {} of \u{2212}1 left out: so a receiver says that it does not know the speed or the course.",
                readings(unknown)
            ));
        }
        if self.no_heading > 0 {
            notes.push(format!(
                "{name}: {} of 65535 left out: so MAVLink says that the heading is not known.",
                readings(self.no_heading)
            ));
        }
        if 2 * self.tilted > self.stamps.rows {
            notes.push(format!(
                "{name}: its quaternions are tilted by more than 60\u{b0}, as those of a camera that looks ahead: the \
                 heading is that of their axis of x. Leave it out (its column \u{2013}) if the robot points elsewhere."
            ));
        }
        if nowhere > 0 {
            notes.push(format!("{name}: {} at latitude 0, longitude 0 left out: there was no fix.", readings(nowhere)));
        }
        if without_sigma > 0 {
            notes.push(format!("{name}: {without_sigma} \u{3c3} not above 0; the setting\u{2019}s is taken instead."));
        }
        notes
    }
}

/// Of a message of odometry the poses are no truth and no sensor's; the axes of flight controllers are their own.
pub(crate) fn frame(file: &str, source: &Source) -> Option<String> {
    if source.role == Role::Velocities && guess::is_own_pose(&source.names) {
        let what = "its poses are what the robot has reckoned from these velocities, and are not read.";
        return Some(format!("{file}: {what}"));
    }
    let turned = source.units.iter().flatten().any(|unit| unit.name.ends_with("clockwise"));
    let what = "read with the axes of PX4 and ArduPilot, forward, right and down: its turn rates are clockwise.";
    (turned && clockwise(&source.names, file)).then(|| format!("{file}: {what}"))
}

/// What is said of a file that is not used.
pub(crate) fn unused(file: &str, names: &[Name]) -> String {
    let scan = names.iter().any(|name| name.has("angle") && name.has("increment"));
    let none = |value, quantity| candidates(value, quantity, names).is_empty();
    let read = [("latitude", Quantity::Coordinate), ("v", Quantity::Speed), ("omega", Quantity::AngleRate)];
    let untimed = none("time", Quantity::Time) && read.into_iter().any(|(value, quantity)| !none(value, quantity));
    let why = match (scan, untimed) {
        (true, _) => ": a laser scan does not say which landmark it saw",
        (_, true) => {
            ": none of its columns is known for the time of its rows. If one is, say what the file is read as, and \
             choose that column"
        }
        _ => "",
    };
    format!("{file} is not used{why}")
}

/// Lines about a file and units, which stand above its rows beside the names.
pub(crate) fn words(name: &str, lines: usize) -> Option<String> {
    let what = if lines == 1 { "line" } else { "lines" };
    (lines > 0).then(|| format!("{name}: {lines} {what} of words above the numbers left out."))
}

/// What was left out of a log: sightings of a barcode in no list, and sightings of what no file places; and what comes
/// of that where no other reading is left.
pub(crate) fn left_out(unlisted: usize, left_out: usize, mapped: bool, rows: &[Row]) -> Vec<String> {
    let mut notes = Vec::new();
    if unlisted > 0 {
        notes.push(format!("{} left out: no list has the barcode.", readings(unlisted)));
    }
    if left_out > 0 && mapped {
        notes.push(format!("{} left out: another robot was seen.", readings(left_out)));
    }
    if left_out > 0 && !mapped {
        let left_out = readings(left_out);
        let comes = if rows.iter().any(|row| !row.event.is_motion()) { "" } else { " This is dead reckoning." };
        notes.push(format!("{left_out} left out: no file says where the landmarks are.{comes}"));
    }
    notes
}

/// Where something is missing for longest, what comes of that, and how many such gaps there are.
fn missed(what: &str, count: u32, longest: [f64; 2], comes: &str) -> String {
    let [begin, end] = longest.map(|time| (10.0 * time).round() / 10.0);
    let more = if count > 1 { format!(" This is the longest of {count} such gaps.") } else { String::new() };
    format!("No {what} from {begin} to {end} s after the first row: {comes}{more}")
}

/// What no row of motion reads, and what the filter does without.
pub(crate) fn lacking(drive: &Drive) -> Option<String> {
    let (what, taken, number, really) = match estimate::drive::lacks(&drive.rows, drive.motion)? {
        Missing::TurnRate => ("turn rate", "drive straight on", "turn", "much it turns"),
        _ => ("speed", "stand", "distance", "far it goes"),
    };
    Some(format!(
        "The log has no {what}: between readings the robot is taken to {taken}, and the \u{3c3} of the {number} has to \
         cover how {really}."
    ))
}

/// Where no motion was read: the replay goes on with what it has, and says so.
pub(crate) fn gaps(drive: &Drive) -> Vec<String> {
    let note = |Gaps { what, count, longest, .. }: Gaps| {
        let (rows, held) = match what {
            Missing::Held => ("rows of motion", "the last speed and turn rate are held meanwhile"),
            Missing::Speed => ("speed", "the last one is held meanwhile"),
            Missing::TurnRate => ("turn rate", "the last one is held meanwhile"),
            Missing::Odometry => ("rows of motion", "the row after it is taken for the whole way and turn since"),
        };
        let guess = "What is estimated there is a guess; cut the log at the gap to judge it without.";
        missed(rows, count, longest, &format!("{held}. {guess}"))
    };
    let gaps = estimate::drive::gaps(&drive.rows, drive.motion).into_iter().map(note);
    let readings = unread(&drive.rows).into_iter().chain(ended_readings(&drive.rows));
    gaps.chain(ended(drive)).chain(begun_late(drive)).chain(readings).collect()
}

/// Where no fix was read, or no heading: the motion alone leads on there.
fn unread(rows: &[Row]) -> Vec<String> {
    let note = |(what, is): &(&str, fn(&Event) -> bool)| {
        let (count, longest) = estimate::drive::gaps_of(rows, MISSED, *is)?;
        let led = "meanwhile the motion leads the estimate on, and other readings if there are any.";
        Some(missed(what, count, longest, led))
    };
    READ[..2].iter().filter_map(note).collect()
}

/// A last row that is not read.
pub(crate) fn cut(file: &str, line: u32) -> String {
    format!(
        "{file}: it ends within line {line}, which has fewer fields or digits than those above: that row may be cut, \
         and is left out."
    )
}

/// What is strange about the times of a drive, and in which file. A wrong column, a wrong unit or a second clock shows
/// here.
pub(crate) fn times<'f>(drive: &Drive, file: impl Fn(&Row) -> Option<&'f str>) -> Option<String> {
    let span = |is: fn(&Event) -> bool| {
        let mut times = drive.rows.iter().filter(|row| is(&row.event)).map(|row| row.time);
        let first = times.next()?;
        Some([first, times.next_back().unwrap_or(first)])
    };
    let motion = span(Event::is_motion)?;
    let truth = drive.truth.poses().first().zip(drive.truth.poses().last()).map(|(a, b)| [a.time, b.time]);
    let apart = |other: Option<[f64; 2]>| other.is_some_and(|[from, to]| to < motion[0] || motion[1] < from);
    let within = |is: fn(&Event) -> bool| drive.rows.iter().find(|row| is(&row.event)).and_then(&file);
    let read = READ.map(|(what, is)| (span(is), what, within(is)));
    if let Some((_, what, file)) = [(truth, "true positions", None)].into_iter().chain(read).find(|it| apart(it.0)) {
        let name = file.map_or(String::new(), |file| format!(" of {file}"));
        return Some(format!(
            "The {what}{name} are all before the motion or after it: is another clock or unit meant?"
        ));
    }
    let rows = drive.rows.iter().filter(|row| row.event.is_motion()).count();
    (rows > 1 && motion[0] == motion[1])
        .then(|| "All rows of motion have the same time: is it in another column?".into())
}

fn readings(count: usize) -> String {
    if count == 1 { "1 reading".into() } else { format!("{count} readings") }
}
