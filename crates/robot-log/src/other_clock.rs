//! Whether a file has another clock than the motion: its times do not meet those, or begin and end as much later. By
//! how much it is another one nobody but the reader knows.

use estimate::drive::Row;

/// A quarter of an hour, a day, and as far as zones of time are apart, s.
const QUARTER: f64 = 900.0;
const DAY: f64 = 86_400.0;
const ZONES: f64 = 50_400.0;
/// This part of the shorter of two spans is common where a shift by whole quarters of an hour, or by whole days, is
/// meant.
const COMMON: f64 = 0.9;
/// A file of at least so many seconds that begins and ends later by more than so many, and by the same but for so many,
/// has another clock.
const LONG: f64 = 20.0;
const LATE: f64 = 5.0;
const ALIKE: f64 = 1.5;
/// So many seconds GPS time is ahead of UTC, since 2017.
const GPS: f64 = 18.0;

/// From when to when something was read, s.
pub(crate) type Span = [f64; 2];

/// When the rows of a file were, and when those of them that say how the robot moved; `None` where there are none.
/// Which of the rows of all files are its own: from one to before another.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Times {
    pub all: Option<Span>,
    pub motion: Option<Span>,
    pub rows: [usize; 2],
}

/// From when to when there are rows that say how the robot moved.
pub(crate) fn spanned(rows: &[Row]) -> Option<Span> {
    rows.iter().filter(|row| row.event.is_motion()).map(|row| [row.time; 2]).reduce(join)
}

/// The span of two.
pub(crate) fn join(a: Span, b: Span) -> Span {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// The clock of a file beside that of the motion, and what may be added to its times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OtherClock {
    /// Its own times, and those of the motion, s.
    pub spans: [[f64; 2]; 2],
    /// Whether it is another one, as far as its times tell: they do not meet those of the motion, or both begin and end
    /// as much later, or earlier.
    pub asked: bool,
    /// The whole quarters of an hour, or the whole days, that bring its times into the motion's, s, or the seconds that
    /// GPS time is ahead by; `None` where none do.
    pub zone: Option<f64>,
    /// What lets it begin with the motion, s.
    pub together: f64,
    /// The least and the most by which it meets the motion, s.
    pub meets: [f64; 2],
}

impl OtherClock {
    pub(crate) fn new(own: Span, motion: Span) -> Self {
        let [late, ends] = [own[0] - motion[0], own[1] - motion[1]];
        let length = |[from, to]: Span| to - from;
        let shorter = length(own).min(length(motion));
        let apart = own[0] > motion[1] || motion[0] > own[1];
        let shifted = shorter > LONG && late.abs() > LATE && (late - ends).abs() < ALIKE;
        let common = |by: f64| (own[1] + by).min(motion[1]) - (own[0] + by).max(motion[0]);
        // The middles are nearest to one another where the most is common.
        let between = 0.5 * (motion[0] + motion[1] - own[0] - own[1]);
        let whole = [QUARTER, DAY].map(|unit| unit * libm::round(between / unit));
        let within = |by: &f64| *by != 0.0 && common(*by) >= COMMON * shorter;
        let leap = Some(GPS * between.signum()).filter(|by| shifted && (by - between).abs() < ALIKE);
        let zones = [leap, Some(whole[0]).filter(|by| by.abs() <= ZONES), Some(whole[1])];
        let zone = zones.into_iter().flatten().find(within);
        let meets = [motion[0] - own[1], motion[1] - own[0]];
        Self { spans: [own, motion], asked: apart || shifted, zone, together: -late, meets }
    }

    /// What is asked of it.
    pub(crate) fn question(&self) -> Option<String> {
        let [own, motion] = self.spans;
        let lie = match () {
            () if !self.asked => return None,
            () if own[1] < motion[0] => format!("end {:.1} s before the motion begins", motion[0] - own[1]),
            () if own[0] > motion[1] => format!("begin {:.1} s after the motion ends", own[0] - motion[1]),
            () => {
                let side = if own[0] > motion[0] { "later" } else { "earlier" };
                let [begin, end] = [own[0] - motion[0], own[1] - motion[1]].map(f64::abs);
                format!("begin {begin:.1} s {side} than the motion, and end {end:.1} s {side}")
            }
        };
        Some(format!(
            "Its times {lie}: how many seconds are to be added to them? If it is of another day, leave the file out; \
             if its times are in another column or unit, choose that."
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_hours_and_days_are_found_where_they_bring_one_into_the_other() {
        let zone = |own: Span, motion: Span| {
            let clock = OtherClock::new(own, motion);
            clock.asked.then_some(clock.zone)
        };
        assert_eq!(zone([3600.0, 3700.0], [1.0, 99.0]), Some(Some(-3600.0)));
        assert_eq!(zone([0.0, 100.0], [19_800.0, 19_900.0]), Some(Some(19_800.0)));
        assert_eq!(zone([43_200.0, 43_300.0], [1_700_006_400.0 + 7200.0, 1_700_006_400.0 + 7300.0]), Some(None));
        let noon = 86_400.0 * 19_676.0 + 43_200.0;
        assert_eq!(zone([43_200.0, 43_300.0], [noon, noon + 100.0]), Some(Some(86_400.0 * 19_676.0)));
        assert_eq!(zone([0.0, 100.0], [1_700_000_123.0, 1_700_000_223.0]), Some(None));
        assert_eq!(zone([0.0, 100.0], [99.0, 300.0]), None);
    }

    #[test]
    fn a_file_that_begins_and_ends_as_much_later_has_another_clock_and_18_s_are_gps_time() {
        let asked = |own: Span| {
            let clock = OtherClock::new(own, [0.0, 300.0]);
            clock.asked.then_some(clock.zone)
        };
        assert_eq!(asked([18.0, 317.5]), Some(Some(-18.0)));
        assert_eq!(asked([-18.4, 281.0]), Some(Some(18.0)));
        assert_eq!(asked([7.0, 307.5]), Some(None));
        for sound in [[0.5, 299.0], [2.5, 302.0], [20.0, 300.0], [4.5, 304.5], [-10.0, 310.0]] {
            assert_eq!(asked(sound), None, "{sound:?}");
        }
        assert!(!OtherClock::new([5.0, 15.0], [0.0, 10.0]).asked, "so short a file may begin anywhere");
    }
}
