//! Encoders' counters that jump: one of 16 bits begins anew at the end of its range, another was set anew. A jump is
//! found by its size beside all other steps of the file, and one that no range explains is asked about.

use crate::unit::Unit;
use core::f64::consts::TAU;

/// The ranges of counters, in bits, and of angles in radians.
const BITS: [i32; 7] = [12, 14, 15, 16, 24, 31, 32];
/// A step is at most this part of the range of its counter: then one over its end is told from it.
const PART: f64 = 8.0;
/// Over the end of the range the step is at most so many times the longest of the others.
const ALIKE: f64 = 2.0;
/// A step that took so many of the usual times is over a gap.
const GAP: f64 = 1.5;
/// So many times faster than nearly all other steps no wheel turns.
const ODD: f64 = 20.0;
/// A jump without a range is sought among so many rows at least.
const FEWEST: usize = 8;

/// A row of counts: its line, its time, and what the two encoders have counted.
pub(crate) type Count = (u32, f64, [f64; 2]);

/// A step that no motion makes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Jump {
    pub line: u32,
    /// 0 of the left encoder, 1 of the right one.
    pub side: usize,
    pub from: f64,
    pub to: f64,
    /// How long nothing was counted before it, s, where the counter may have gone round meanwhile.
    pub gap: Option<f64>,
}

/// Where the counters of a file jump.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Jumps {
    /// The range after which they begin anew, and how often they do.
    pub range: Option<(f64, usize)>,
    /// The other jumps, by line.
    pub odd: Vec<Jump>,
}

impl Jumps {
    /// The jumps of counts in a unit.
    pub fn of(counts: &[Count], unit: &Unit) -> Self {
        let period = period(counts);
        let step = |pair: &[Count]| [0, 1].map(|side| Step::new(pair, side, period));
        let steps: Vec<Step> = counts.windows(2).flat_map(step).collect();
        let ranges: Vec<f64> = match unit.name {
            "ticks" => BITS.iter().map(|bits| libm::exp2(f64::from(*bits))).collect(),
            "rad" | "deg" => vec![TAU],
            _ => Vec::new(),
        };
        let width = |side: usize| {
            let counted = counts.iter().map(|(_, _, counted)| counted[side]);
            counted.clone().fold(f64::NEG_INFINITY, f64::max) - counted.fold(f64::INFINITY, f64::min)
        };
        let widest = width(0).max(width(1));
        let found = ranges.into_iter().filter(|range| widest <= *range);
        let range = found.map(|range| (range, wraps(&steps, range))).find(|(_, wraps)| *wraps > 0);
        let Some((range, _)) = range else {
            let least = if unit.name == "ticks" { 1000.0 } else { 20.0 * TAU };
            return Self { range, odd: odd(&steps, counts.len(), least) };
        };
        Self { range: Some((range, wraps(&steps, range))), odd: round_unseen(&steps, range) }
    }

    /// What was counted between two rows.
    pub fn step(&self, from: f64, to: f64) -> f64 {
        let step = to - from;
        match self.range {
            Some((range, _)) if step.abs() > range / 2.0 => step - range.copysign(step),
            _ => step,
        }
    }

    /// Whether a row's counts began anew.
    pub fn begins_anew(&self, line: u32) -> bool {
        self.odd.binary_search_by_key(&line, |jump| jump.line).is_ok()
    }

    /// What is said of counters that begin anew.
    pub fn note(&self, name: &str, unit: &Unit) -> Option<String> {
        let (range, times) = self.range?;
        let times = if times == 1 { "once".into() } else { format!("{times} times") };
        Some(match unit.name {
            "ticks" => format!(
                "{name}: the counters begin anew after {range} ticks, {times}: a step over the end of their range is \
                 taken as the short one that it is."
            ),
            _ => format!("{name}: the wheels\u{2019} angles begin anew after a turn, {times}, and are counted on."),
        })
    }
}

/// From a row to the next.
struct Step {
    jump: Jump,
    way: f64,
    speed: f64,
    time: f64,
    /// How many of the usual times between rows it took.
    periods: f64,
}

impl Step {
    fn new(pair: &[Count], side: usize, period: f64) -> Self {
        let ((_, before, from), (line, after, to)) = (pair[0], pair[1]);
        let (from, to, time) = (from[side], to[side], after - before);
        let way = (to - from).abs();
        let speed = if time > 0.0 { way / time } else { way };
        let periods = if period > 0.0 { (time / period).max(1.0) } else { 1.0 };
        Self { jump: Jump { line, side, from, to, gap: None }, way, speed, time, periods }
    }
}

/// The time that is usual between two rows, s.
fn period(counts: &[Count]) -> f64 {
    let mut times: Vec<f64> = counts.windows(2).map(|pair| pair[1].1 - pair[0].1).filter(|time| *time > 0.0).collect();
    times.sort_unstable_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(0.0)
}

/// The longest step in the usual time that does not go over the end of a range.
fn longest(steps: &[Step], range: f64) -> f64 {
    let short = steps.iter().filter(|step| step.way <= range / 2.0);
    short.map(|step| step.way / step.periods).fold(0.0, f64::max)
}

/// How many steps go over the end of a range; 0 where the range does not explain all that are long.
fn wraps(steps: &[Step], range: f64) -> usize {
    let long = |step: &&Step| step.way > range / 2.0;
    let most = longest(steps, range);
    let short = |step: &Step| (step.way - range).abs() <= (ALIKE * most * step.periods).max(1.0);
    let sound = PART * most <= range && steps.iter().filter(long).all(short);
    if sound { steps.iter().filter(long).count() } else { 0 }
}

/// The steps over gaps in which a counter of this range may have gone round without a row of it.
fn round_unseen(steps: &[Step], range: f64) -> Vec<Jump> {
    let most = longest(steps, range);
    let unseen = steps.iter().filter(|step| step.periods > GAP && most * step.periods > range / 2.0);
    unseen.map(|step| Jump { gap: Some(step.time), ..step.jump }).collect()
}

/// The steps that are far longer than nearly all others, and longer than `least`.
fn odd(steps: &[Step], rows: usize, least: f64) -> Vec<Jump> {
    let mut speeds: Vec<f64> = steps.iter().map(|step| step.speed).filter(|speed| *speed > 0.0).collect();
    speeds.sort_unstable_by(f64::total_cmp);
    let Some(usual) = speeds.get(speeds.len() * 9 / 10).filter(|_| rows >= FEWEST) else { return Vec::new() };
    steps.iter().filter(|step| step.way > least && step.speed > ODD * usual).map(|step| step.jump).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::role::Quantity;
    use crate::unit::named;

    fn jumps(counted: impl Iterator<Item = f64>) -> Jumps {
        let counts: Vec<Count> = counted.enumerate().map(|(i, at)| (i as u32 + 2, i as f64 * 0.05, [at, at])).collect();
        Jumps::of(&counts, named(Quantity::Wheel, "ticks").expect("a unit"))
    }

    #[test]
    fn a_counter_of_any_width_is_counted_on_over_its_end() {
        for bits in BITS {
            let range = 2_f64.powi(bits);
            // 6 steps up to the end of the range, and 24 behind it, signed and without a sign.
            for low in [0.0, -range / 2.0] {
                let wrapped = |i: i32| low + (range - 900.0 + 150.0 * f64::from(i)).rem_euclid(range);
                let found = jumps((0..30).map(wrapped));
                assert_eq!(found.range, Some((range, 2)), "{bits} bits from {low}: the two of a row");
                assert_eq!(found.step(low + range - 100.0, low + 50.0), 150.0);
                assert_eq!(found.step(low + 50.0, low + range - 100.0), -150.0);
            }
        }
    }

    #[test]
    fn counters_that_were_set_anew_are_no_wrap_and_motion_is_neither() {
        // Set back to 0 at 41,100: no range of a counter is there.
        let anew = jumps((0..30).map(|i| if i < 24 { 37_500.0 + 150.0 * f64::from(i) } else { f64::from(i) }));
        assert_eq!((anew.range, anew.odd.len()), (None, 2));
        assert_eq!(anew.odd[0], Jump { line: 26, side: 0, from: 40_950.0, to: 24.0, gap: None });
        assert!(anew.begins_anew(26) && !anew.begins_anew(25));
        let steady = jumps((0..2000).map(|i| 150.0 * f64::from(i)));
        assert_eq!(steady, Jumps::default());
        // From rest to full speed within a row.
        let starts = jumps((0..40).map(|i| 900.0 * f64::from((i - 20).max(0))));
        assert_eq!(starts, Jumps::default());
        assert_eq!(jumps([0.0, 65_535.0].into_iter()).range, Some((65_536.0, 2)), "a step back from 0");
    }

    /// A counter of 16 bits that steps 839 ticks in 0.1 s, and counts nothing for so many steps.
    fn with_gap(gap: usize) -> Jumps {
        let rows = (0..600).filter(|i| !(200..200 + gap).contains(i));
        let counts: Vec<Count> = rows
            .enumerate()
            .map(|(row, i)| (row as u32 + 2, i as f64 * 0.1, [(839.0 * i as f64).rem_euclid(65_536.0); 2]))
            .collect();
        Jumps::of(&counts, named(Quantity::Wheel, "ticks").expect("a unit"))
    }

    #[test]
    fn over_a_gap_a_counter_is_counted_on_as_long_as_it_cannot_have_gone_round() {
        let short = with_gap(15);
        assert_eq!((short.range.map(|it| it.0), short.odd.as_slice()), (Some(65_536.0), &[][..]));
        let long = with_gap(200);
        assert_eq!(long.range.map(|it| it.0), Some(65_536.0));
        let lines: Vec<(u32, usize)> = long.odd.iter().map(|jump| (jump.line, jump.side)).collect();
        // Behind 200 rows and the header.
        assert_eq!(lines, [(202, 0), (202, 1)]);
        assert!(long.odd[0].gap.is_some_and(|gap| (gap - 20.1).abs() < 1e-9) && long.begins_anew(202));
    }
}
