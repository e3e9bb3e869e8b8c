//! A file whose times do not meet those of the motion: its clock is another one, and nobody but the reader knows by how
//! much.

use estimate::drive::Row;

/// A quarter of an hour, a day, and as far as zones of time are apart, s.
const QUARTER: f64 = 900.0;
const DAY: f64 = 86_400.0;
const ZONES: f64 = 50_400.0;
/// This part of the shorter of two spans is common where a shift by whole quarters of an hour, or by whole days, is
/// meant.
const COMMON: f64 = 0.9;

/// From when to when something was read, s.
pub(crate) type Span = [f64; 2];

/// When the rows of a file were, and when those of them that say how the robot moved; `None` where there are none.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Times {
    pub all: Option<Span>,
    pub motion: Option<Span>,
}

/// From when to when there are rows that say how the robot moved.
pub(crate) fn spanned(rows: &[Row]) -> Option<Span> {
    rows.iter().filter(|row| row.event.is_motion()).map(|row| [row.time; 2]).reduce(join)
}

/// The span of two.
pub(crate) fn join(a: Span, b: Span) -> Span {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// How the times of a file lie that do not meet those of the motion, and what may be added to them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OtherClock {
    /// Its own times, and those of the motion, s.
    pub spans: [[f64; 2]; 2],
    /// The whole quarters of an hour, or the whole days, that bring its times into the motion's, s; `None` where none
    /// do.
    pub zone: Option<f64>,
    /// What lets it begin with the motion, s.
    pub together: f64,
    /// The least and the most by which it meets the motion, s.
    pub meets: [f64; 2],
}

impl OtherClock {
    /// `None` where the two meet.
    pub(crate) fn new(own: Span, motion: Span) -> Option<Self> {
        if own[0] <= motion[1] && motion[0] <= own[1] {
            return None;
        }
        let together = motion[0] - own[0];
        let length = |[from, to]: Span| to - from;
        let common = |by: f64| (own[1] + by).min(motion[1]) - (own[0] + by).max(motion[0]);
        let shorter = length(own).min(length(motion));
        // The middles are nearest to one another where the most is common.
        let between = 0.5 * (motion[0] + motion[1] - own[0] - own[1]);
        let whole = [QUARTER, DAY].map(|unit| unit * libm::round(between / unit));
        let within = |by: &f64| *by != 0.0 && common(*by) >= COMMON * shorter;
        let zone = [Some(whole[0]).filter(|by| by.abs() <= ZONES), Some(whole[1])].into_iter().flatten().find(within);
        Some(Self { spans: [own, motion], zone, together, meets: [motion[0] - own[1], motion[1] - own[0]] })
    }

    /// What is asked of it.
    pub(crate) fn question(&self) -> String {
        let [own, motion] = self.spans;
        let (apart, lie) = match own[1] < motion[0] {
            true => (motion[0] - own[1], "end"),
            false => (own[0] - motion[1], "begin"),
        };
        let other = if lie == "end" { "before the motion begins" } else { "after the motion ends" };
        format!(
            "Its times {lie} {apart:.1} s {other}: how many seconds are to be added to them? If it is of another day, \
             leave the file out; if its times are in another column or unit, choose that."
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_hours_and_days_are_found_where_they_bring_one_into_the_other() {
        let zone = |own: Span, motion: Span| OtherClock::new(own, motion).map(|other| other.zone);
        assert_eq!(zone([3600.0, 3700.0], [1.0, 99.0]), Some(Some(-3600.0)));
        assert_eq!(zone([0.0, 100.0], [19_800.0, 19_900.0]), Some(Some(19_800.0)));
        assert_eq!(zone([43_200.0, 43_300.0], [1_700_006_400.0 + 7200.0, 1_700_006_400.0 + 7300.0]), Some(None));
        let noon = 86_400.0 * 19_676.0 + 43_200.0;
        assert_eq!(zone([43_200.0, 43_300.0], [noon, noon + 100.0]), Some(Some(86_400.0 * 19_676.0)));
        assert_eq!(zone([0.0, 100.0], [1_700_000_123.0, 1_700_000_223.0]), Some(None));
        assert_eq!(zone([0.0, 100.0], [99.0, 300.0]), None);
    }
}
