//! The ways in which a fit moves its numbers: each by itself, all delays together, scale and offset of ranges against
//! one another, and on along the way of the last round.
//!
//! Two numbers that explain the same readings, as two delays do or the scale and the offset of ranges, make a ridge
//! along which neither leads up by itself.

use crate::drive::fitted::Fitted;
use crate::drive::row::{Drive, Event};
use alloc::vec::Vec;

/// A step that has led up is followed by a longer one, one that has not by a shorter one.
const LONGER: f64 = 1.6;
const SHORTER: f64 = 0.4;

/// A way, and how far its next step goes.
#[derive(Clone, Debug, PartialEq)]
struct Way {
    along: Vec<f64>,
    step: f64,
    first: f64,
    fine: f64,
}

/// Which way is gone next, and how far.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Moves {
    ways: Vec<Way>,
    bounds: Vec<[f64; 2]>,
    /// Which is gone now, and whether it was gone the one way already.
    now: usize,
    turned: bool,
    /// Where this round began.
    from: Vec<f64>,
}

impl Moves {
    /// The ways for numbers that are `at`, with delays of at most so much and ranges of about so many metres.
    pub fn new(numbers: &[Fitted], at: &[f64], bounds: &[[f64; 2]], [most, range]: [f64; 2]) -> Self {
        let n = numbers.len();
        let way = |along: Vec<f64>, number: &Fitted| {
            let first = number.first_step(most);
            Way { along, step: first, first, fine: number.fine() }
        };
        let unit = |i: usize| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
        let mut ways: Vec<Way> = numbers.iter().enumerate().map(|(i, number)| way(unit(i), number)).collect();
        let delays: Vec<f64> = numbers.iter().map(|number| if number.is_delay() { 1.0 } else { 0.0 }).collect();
        let mut of_delays = numbers.iter().filter(|number| number.is_delay());
        if let (Some(delay), Some(_)) = (of_delays.next(), of_delays.next()) {
            ways.push(way(delays, delay));
        }
        if [Fitted::Scale, Fitted::Offset].iter().all(|number| numbers.contains(number)) {
            let against = |number: &Fitted| match number {
                Fitted::Scale => 1.0,
                Fitted::Offset => -range,
                _ => 0.0,
            };
            ways.push(way(numbers.iter().map(against).collect(), &Fitted::Scale));
        }
        // On along the way of a round: none until one has been gone.
        ways.push(Way { along: alloc::vec![0.0; n], step: 1.0, first: 1.0, fine: f64::INFINITY });
        Self { ways, bounds: bounds.to_vec(), now: 0, turned: false, from: at.to_vec() }
    }

    /// The place to try next from `at`; `None` where it is no other.
    pub fn next(&self, at: &[f64]) -> Option<Vec<f64>> {
        let Way { along, step, .. } = &self.ways[self.now];
        let to = at.iter().zip(along).zip(&self.bounds);
        let to: Vec<f64> = to.map(|((at, along), [least, most])| (at + step * along).clamp(*least, *most)).collect();
        (to != at).then_some(to)
    }

    /// What came of it: whether it led up, to `at`.
    pub fn take(&mut self, up: bool, at: &[f64]) {
        let way = &mut self.ways[self.now];
        if up {
            way.step *= LONGER;
        } else if !self.turned {
            (way.step, self.turned) = (-way.step, true);
            return;
        } else {
            way.step *= -SHORTER;
        }
        (self.now, self.turned) = ((self.now + 1) % self.ways.len(), false);
        if self.now + 1 == self.ways.len()
            && let Some(on) = self.ways.last_mut()
        {
            on.along = at.iter().zip(&self.from).map(|(at, from)| at - from).collect();
            on.step = on.first;
        }
        if self.now == 0 {
            self.from = at.to_vec();
        }
    }

    /// Whether every step is fine.
    pub fn settled(&self) -> bool {
        self.ways.iter().all(|way| way.step.abs() < way.fine)
    }

    /// Begins again, as another search from here would.
    pub fn again(&mut self, at: &[f64]) {
        self.ways.iter_mut().for_each(|way| way.step = way.first);
        if let Some(on) = self.ways.last_mut() {
            on.along.fill(0.0);
        }
        (self.now, self.turned, self.from) = (0, false, at.to_vec());
    }
}

/// The mean of the ranges, m.
pub(crate) fn mean_range(drive: &Drive) -> f64 {
    let ranges = drive.rows.iter().filter_map(|row| match row.event {
        Event::Range { range, .. } | Event::RangeBearing { range, .. } => Some(range),
        _ => None,
    });
    let (sum, count) = ranges.fold((0.0, 0_u32), |(sum, count), range| (sum + range, count + 1));
    if count == 0 { 0.0 } else { sum / f64::from(count) }
}
