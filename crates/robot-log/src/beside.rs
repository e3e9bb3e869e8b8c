//! What the files of a log say of one another: how the landmarks are called to which a table has a column of ranges
//! each, and which of several tables with a speed is the one that is driven by.

use crate::file::File;
use crate::frames::Frame;
use crate::heading::is_course;
use crate::log::MAX_LANDMARKS;
use crate::names::candidates;
use crate::other_clock::{OtherClock, Times, join};
use crate::own::Own;
use crate::question::Question;
use crate::role::{Quantity, Role};
use crate::row::{self, MAX_TIME};
use crate::source::Source;
use crate::wgs84::Origin;
use crate::wide;

/// Looks for the names of landmarks among the columns of the others; a table that has them is one of ranges, but for
/// the file whose role a reader has said just now.
pub(crate) fn names(files: &mut [File], said: Option<usize>) {
    let placed = |file: &&File| file.role() == Role::Landmarks;
    let called: Vec<String> = files.iter().filter(placed).flat_map(File::landmarks).collect();
    let there = files.iter().any(|file| placed(&file));
    for (at, file) in files.iter_mut().enumerate().filter(|(_, file)| file.role() != Role::Landmarks) {
        file.call(&called, there, said == Some(at));
    }
}

/// Leaves out the file that was added where one before it has the same text: each of its rows would count twice.
pub(crate) fn same(files: &mut [File], at: usize) {
    let (before, rest) = files.split_at_mut(at);
    let Some(file) = rest.first_mut() else { return };
    if let Some(other) = before.iter().find(|other| other.text() == file.text()) {
        file.set_role(Role::Unused);
        file.source.same_as = Some(other.name().to_string());
    }
}

/// Leaves out the speed that a receiver of positions has besides, where another table says how the robot moved: two
/// speeds would be held in turn. Of a file whose role was said just now alone: of others the reader may have chosen it.
pub(crate) fn speeds(files: &mut [File], said: Option<usize>) {
    let first = |files: &[File]| {
        let driven = files.iter().filter(|file| file.has_speed());
        driven.max_by_key(|file| (file.turns(), file.text().lines().count())).map(|file| file.name().to_string())
    };
    let Some(name) = first(files) else { return };
    let looked = files.iter_mut().enumerate().filter(|(at, _)| said.is_none_or(|said| said == *at));
    looked.filter(|(_, file)| file.name() != name).for_each(|(_, file)| file.leave_speed(&name));
}

/// What is said where several tables still have a speed.
pub(crate) fn note(files: &[File]) -> Option<String> {
    let with: Vec<&str> = files.iter().filter(|file| file.has_speed()).map(File::name).collect();
    let [first, .., last] = with.as_slice() else { return None };
    Some(format!(
        "{first} and {last} both have a speed, and each leads until the next of either: leave one out (its column \
         \u{2013}) if they are of one time."
    ))
}

/// Whether the turns come from encoders of wheels alone: then there is no gyro. And how far apart these stand, m.
pub(crate) fn wheels(files: &[File]) -> (bool, Option<f64>) {
    let turning: Vec<&File> = files.iter().filter(|file| file.role().moves() && file.turns()).collect();
    let alone = !turning.is_empty() && turning.iter().all(|file| file.role() == Role::Encoders);
    (alone, turning.first().filter(|_| alone).and_then(|file| file.wheels().base))
}

/// The first file whose headings are the courses of the receiver whose positions stand beside them.
pub(crate) fn course(files: &[File]) -> Option<&File> {
    files.iter().filter(|file| file.role() == Role::Sensors).find(|file| {
        let heading = file.source.column("heading").and_then(|at| file.source.names.get(at));
        Places::of(&file.source).is_some() && heading.is_some_and(is_course)
    })
}

/// What is said of such a file.
pub(crate) fn course_note(file: &File) -> String {
    format!(
        "{}: its course is read as the robot\u{2019}s heading. It is that where the antenna stands above the point \
         about which the robot turns; elsewhere it runs ahead of the robot in each turn, or behind.",
        file.name()
    )
}

/// How the places of a file are said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Places {
    /// In latitude and longitude.
    Global,
    /// In metres.
    Metric,
}

impl Places {
    /// Those of a file, as it is read; `None` of one without any.
    fn of(source: &Source) -> Option<Self> {
        let has = |value: &str| source.column(value).is_some();
        match source.role {
            Role::Sensors | Role::Truth | Role::Landmarks if has("latitude") => Some(Self::Global),
            Role::Sensors | Role::Truth | Role::Landmarks if has("x") => Some(Self::Metric),
            _ => None,
        }
    }
}

/// How the fixes of a log say their places: in metres, in latitude and longitude.
fn fixes(files: &[File]) -> [bool; 2] {
    let has = |places| {
        let said = |file: &File| file.role() == Role::Sensors && Places::of(&file.source) == Some(places);
        files.iter().any(said)
    };
    [has(Places::Metric), has(Places::Global)]
}

/// Finds the truths whose places are counted from another point than those of the fixes, and what else is in metres
/// beside latitudes and longitudes.
pub(crate) fn frames(files: &mut [File]) {
    let [metric, global] = fixes(files);
    let other = |file: &File| file.role() != Role::Truth && Places::of(&file.source) == Some(Places::Global);
    let any = files.iter().any(other);
    for file in files.iter_mut() {
        let (places, truth) = (Places::of(&file.source), file.role() == Role::Truth);
        file.source.beside = any && !truth && places == Some(Places::Metric);
        let places = places.filter(|_| truth);
        file.source.foreign = match places {
            Some(Places::Metric) => global,
            Some(Places::Global) => metric && !global,
            None => false,
        };
    }
}

/// The one truth of a log that is compared with its fixes, and whether its frame may be another one: not where both are
/// in latitude and longitude. A log in the book's own format says itself where it was.
pub(crate) fn compared(files: &[File]) -> Option<(usize, bool)> {
    let mut truths = files.iter().enumerate().filter(|(_, file)| file.role() == Role::Truth);
    let (at, truth) = truths.next().filter(|_| truths.next().is_none())?;
    let [metric, global] = fixes(files);
    let alone = (metric || global) && !files.iter().any(|file| file.role() == Role::Log);
    let places = Places::of(&truth.source).filter(|_| alone)?;
    Some((at, metric || places == Places::Metric))
}

/// The clock of each file beside that of the motion: of the others that say how the robot moved, where one says that
/// too. The first of those has the log's clock.
pub(crate) fn clocks(files: &[File], times: &[Times]) -> Vec<Option<OtherClock>> {
    let moves = |at: usize| times[at].motion.is_some();
    let first = (0..files.len()).find(|at| moves(*at));
    let of_one = |at: usize| files[at].again().unwrap_or(at);
    let said = |at: usize| (files[at].role(), ["v", "omega"].map(|value| files[at].source.column(value).is_some()));
    let motion = |but: usize| {
        let others = (0..files.len()).filter(|at| of_one(*at) != of_one(but));
        others.filter_map(|at| times[at].motion).reduce(join)
    };
    let clock = |at: usize| {
        let first = first.filter(|first| of_one(*first) != of_one(at))?;
        // Parts of one log follow one another.
        let part = moves(at) && said(at) == said(first);
        Some(OtherClock::new(times[at].all.filter(|_| !part)?, motion(at)?))
    };
    (0..files.len()).map(clock).collect()
}

/// What is said of landmarks and fixes in metres beside latitudes and longitudes.
pub(crate) fn origins(files: &[File]) -> Vec<String> {
    let metric = files.iter().filter(|file| file.source.beside);
    let said = files.iter().find_map(File::origin).map(|origin| origin.to_string());
    let origin = said.unwrap_or_else(|| "the first latitude and longitude".to_string());
    let said = |file: &File| {
        let name = file.name();
        format!(
            "{name}: its x and y are taken as metres east and north of {origin}; if its origin or its axes are others, \
             they do not belong together."
        )
    };
    metric.map(said).collect()
}

impl File {
    /// Which frame its places are in, as it was said; `None` where that has not been said.
    pub fn frame(&self) -> Option<Frame> {
        self.source.said_frame()
    }

    /// Where its origin lies, where that was said.
    pub(crate) fn origin(&self) -> Option<Origin> {
        match self.source.said_frame() {
            Some(Frame::At([latitude, longitude])) => Some(Origin::said(latitude, longitude)),
            _ => None,
        }
    }

    /// What brings a truth onto the log's fixes, where it has a frame or a clock of its own
    /// ([`Files::compare`](crate::Files::compare)).
    pub fn own(&self) -> Option<&Own> {
        self.source.own.as_ref()
    }

    /// Its clock beside that of the motion; `None` of a file without times, and of the one that has the log's.
    pub fn other_clock(&self) -> Option<&OtherClock> {
        self.source.other_clock.as_ref()
    }

    /// What is added to its times, s, as it was said; `None` where that has not been said, or cannot be.
    pub fn clock_shift(&self) -> Option<f64> {
        self.source.said_clock_shift()
    }

    pub(crate) fn set_clock_shift(&mut self, seconds: f64) -> bool {
        let there = self.source.other_clock.is_some() && seconds.abs() <= MAX_TIME;
        if there {
            self.source.clock_shift = Some(seconds);
        }
        there
    }

    /// Whether its places are counted from another point than those of the log's fixes: then that is asked.
    pub fn is_foreign(&self) -> bool {
        self.source.foreign
    }

    /// Whether its places are in metres beside latitudes and longitudes of others: their origin is asked.
    pub fn is_beside(&self) -> bool {
        self.source.beside
    }

    pub(crate) fn set_frame(&mut self, frame: Frame) -> bool {
        let may_be = self.source.may_be(frame);
        if may_be {
            self.source.frame = Some(frame);
        }
        may_be
    }

    /// What the landmarks of its rows are called, where these are no numbers.
    fn landmarks(&self) -> Vec<String> {
        let (Some(table), Some(at)) = (&self.source.table, self.source.column("landmark")) else { return Vec::new() };
        let lines = table.lines(self.text()).filter_map(Result::ok).take(MAX_LANDMARKS);
        let fields = lines.filter_map(|line| line.fields.get(at).map(|field| field.text.to_string()));
        fields.filter(|text| !text.is_empty() && row::number(text).is_none()).collect()
    }

    /// Learns what the landmarks of other files are called: a table with columns of these names is one of ranges, and
    /// one whose columns differ by a number alone may be one, where landmarks are there.
    fn call(&mut self, landmarks: &[String], there: bool, said: bool) {
        let found = wide::called(&self.source.names, landmarks);
        let timed = !candidates("time", Quantity::Time, &self.source.names).is_empty();
        let open = matches!(self.role(), Role::Unused | Role::Undecided) && timed;
        let numbered = there && wide::numbered(&self.source.names);
        let changed = found != self.source.called;
        self.source.called = found;
        // What a file is read once more for is known, and what is there already is left out.
        if self.again.is_some() || self.source.same_as.is_some() {
            return;
        }
        if changed && !self.source.called.is_empty() && ((open && !said) || self.role() == Role::Ranges) {
            self.set_role(Role::Ranges);
        } else if self.role() == Role::Unused && timed && numbered && !said {
            self.set_role(Role::Undecided);
            let ask = "Are its columns the ranges to landmarks, one for each? Else leave it out.";
            self.source.undecided = Some(Question { words: ask.into(), answers: &[Role::Ranges, Role::Unused] });
        }
    }

    /// Whether it says how fast the robot was.
    pub(crate) fn has_speed(&self) -> bool {
        match self.role() {
            Role::Velocities | Role::Odometry | Role::Encoders | Role::Reckoned => true,
            Role::Sensors => self.source.column("v").is_some(),
            _ => false,
        }
    }

    /// Whether it says how the robot turned besides.
    pub(crate) fn turns(&self) -> bool {
        self.role() != Role::Sensors || self.source.column("omega").is_some()
    }

    /// Leaves out the speed of a receiver of positions, for that of the file of this name.
    fn leave_speed(&mut self, other: &str) {
        let source = &mut self.source;
        let receiver = source.role == Role::Sensors && (source.column("x").or(source.column("latitude"))).is_some();
        if receiver && source.column("v").is_some() && source.column("omega").is_none() {
            source.driven_by = Some(other.to_string());
            self.set_column("v", None);
        }
    }

    /// What is said of the speed that is left out.
    pub(crate) fn left_speed(&self) -> Option<String> {
        let other = self.source.driven_by.as_ref().filter(|_| self.source.column("v").is_none())?;
        let name = self.name();
        Some(format!(
            "{name}: its speed is not used, as {other} says how the robot moved; to use it, choose its column."
        ))
    }
}
