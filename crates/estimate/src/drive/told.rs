//! How well a log tells the numbers that a fit has found: by how fast the likelihood falls beside them.
//!
//! At distances where the log-likelihood has fallen by 2, which are two standard deviations of a number by itself,
//! second differences are the entries of the Hessian; less its inverse is the covariance of the numbers together.
//!
//! Of a σ that may as well be smaller the greatest that is about as likely is looked for.

use crate::drive::fitted::Fitted;
use alloc::vec::Vec;
use nalgebra::{Cholesky, DMatrix};

/// The fall at which the curvature is taken, and the least on either side that is enough.
const FALL: f64 = 2.0;
const ENOUGH: f64 = 0.5;
/// How often a distance is doubled to find that fall.
const DOUBLINGS: u32 = 12;
/// How often the way to the greatest σ that is about as likely is halved.
const HALVINGS: u32 = 6;

/// What is known of one number.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Side {
    distance: f64,
    /// The likelihoods at the distance above and below.
    values: [Option<f64>; 2],
    doublings: u32,
    /// Whether its likelihood has corners: that of a delay has one wherever a reading passes a row of motion. A place
    /// that is as likely on one side may lie behind such a corner, and is looked for farther off.
    corners: bool,
    is_sigma: bool,
}

/// How far above what was found a σ that may as well be smaller is about as likely.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Edge {
    of: usize,
    /// Between which distances it lies.
    within: [f64; 2],
    halvings: u32,
}

impl Edge {
    fn middle(&self) -> f64 {
        self.within.iter().sum::<f64>() / 2.0
    }
}

/// A look around the numbers that were found.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Told {
    best: f64,
    bounds: Vec<[f64; 2]>,
    sides: Vec<Side>,
    /// The likelihoods with two numbers at their distances above, for each pair.
    pairs: Vec<f64>,
    /// Looked for behind all pairs.
    edges: Vec<Edge>,
}

impl Told {
    pub fn new(numbers: &[Fitted], bounds: &[[f64; 2]], best: f64) -> Self {
        let side = |number: &Fitted| Side {
            distance: number.fine(),
            values: [None; 2],
            doublings: 0,
            corners: number.is_delay(),
            is_sigma: number.is_sigma(),
        };
        let sides: Vec<Side> = numbers.iter().map(side).collect();
        let mut told = Self { best, bounds: bounds.to_vec(), sides, pairs: Vec::new(), edges: Vec::new() };
        told.look_for_edges();
        told
    }

    /// Once all pairs are known, the σ whose edge is to be found are.
    fn look_for_edges(&mut self) {
        if self.pair(self.pairs.len()).is_some() || self.open().is_some() {
            return;
        }
        let edge = |(of, side): (usize, &Side)| match side.values {
            [Some(above), Some(below)] if side.is_sigma && self.near(below) && !self.near(above) => {
                Some(Edge { of, within: [0.0, side.distance], halvings: 0 })
            }
            _ => None,
        };
        self.edges = self.sides.iter().enumerate().filter_map(edge).collect();
    }

    /// Whether a likelihood is about as great as that of what was found.
    fn near(&self, value: f64) -> bool {
        self.best - value < ENOUGH
    }

    /// How far above what was found each σ that may as well be smaller is about as likely; none before that is known.
    pub fn edges(&self) -> impl Iterator<Item = (usize, f64)> {
        self.edges.iter().filter(|edge| edge.halvings == HALVINGS).map(|edge| (edge.of, edge.within[0]))
    }

    /// The most likelihoods that it asks for.
    pub fn most(numbers: usize) -> u32 {
        let n = numbers as u32;
        n * (2 * DOUBLINGS + 2 + HALVINGS) + n * n.saturating_sub(1) / 2
    }

    /// The next place whose likelihood is asked for; `None` behind the last.
    pub fn next(&self, at: &[f64]) -> Option<Vec<f64>> {
        let mut place = at.to_vec();
        if let Some(i) = self.open() {
            let sign = if self.sides[i].values[0].is_none() { 1.0 } else { -1.0 };
            place[i] = (at[i] + sign * self.sides[i].distance).clamp(self.bounds[i][0], self.bounds[i][1]);
            return Some(place);
        }
        if let Some((i, j)) = self.pair(self.pairs.len()) {
            for k in [i, j] {
                place[k] = at[k] + self.sides[k].distance;
            }
            return Some(place);
        }
        let edge = self.edges.iter().find(|edge| edge.halvings < HALVINGS)?;
        place[edge.of] = at[edge.of] + edge.middle();
        Some(place)
    }

    /// Takes the likelihood at that place.
    pub fn take(&mut self, value: f64) {
        let Some(i) = self.open() else { return self.take_further(value) };
        let side = &mut self.sides[i];
        if side.values[0].is_some() {
            let farther = side.corners && self.best - value < ENOUGH && side.doublings < DOUBLINGS;
            side.values[1] = Some(value);
            if farther {
                (side.distance, side.doublings, side.values) = (2.0 * side.distance, side.doublings + 1, [None; 2]);
            }
        } else if self.best - value < FALL && side.doublings < DOUBLINGS {
            (side.distance, side.doublings) = (2.0 * side.distance, side.doublings + 1);
        } else {
            side.values[0] = Some(value);
        }
        self.look_for_edges();
    }

    /// Takes the likelihood of a pair, or of a way to an edge.
    fn take_further(&mut self, value: f64) {
        if self.pair(self.pairs.len()).is_some() {
            self.pairs.push(value);
            return self.look_for_edges();
        }
        let near = self.near(value);
        if let Some(edge) = self.edges.iter_mut().find(|edge| edge.halvings < HALVINGS) {
            edge.within[usize::from(!near)] = edge.middle();
            edge.halvings += 1;
        }
    }

    /// The first number whose sides are not both known.
    fn open(&self) -> Option<usize> {
        self.sides.iter().position(|side| side.values[1].is_none())
    }

    /// The n-th pair of numbers.
    fn pair(&self, n: usize) -> Option<(usize, usize)> {
        let pairs = (0..self.sides.len()).flat_map(|i| (i + 1..self.sides.len()).map(move |j| (i, j)));
        pairs.into_iter().nth(n)
    }

    /// The standard deviation of each number; `None` of one that the log does not tell, and of all before the look is
    /// complete.
    pub fn sigmas(&self) -> Vec<Option<f64>> {
        let n = self.sides.len();
        let none = alloc::vec![None; n];
        if self.pairs.len() < n * (n - 1) / 2 {
            return none;
        }
        let fall = |side: &Side| match side.values {
            [Some(above), Some(below)] => self.best - (above + below) / 2.0,
            _ => 0.0,
        };
        // A σ at the least that is tried has no side below: how far down it goes, the log does not tell.
        let one_sided = |side: &Side| side.values.iter().flatten().any(|value| self.near(*value));
        let told: Vec<usize> = (0..n).filter(|i| !one_sided(&self.sides[*i])).collect();
        let entry = |a: usize, b: usize| {
            let (i, j) = (told[a].min(told[b]), told[a].max(told[b]));
            let (one, other) = (&self.sides[i], &self.sides[j]);
            if i == j {
                return 2.0 * fall(one) / (one.distance * one.distance);
            }
            let at = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))).position(|pair| pair == (i, j));
            let both = at.map_or(self.best, |at| self.pairs[at]);
            let [above, beside] = [one, other].map(|side| side.values[0].unwrap_or(self.best));
            -(both - above - beside + self.best) / (one.distance * other.distance)
        };
        let information = DMatrix::from_fn(told.len(), told.len(), entry);
        let by_itself = |a: usize| 1.0 / libm::sqrt(entry(a, a));
        let together = Cholesky::new(information.clone()).map(|factor| factor.inverse());
        let mut sigmas = none;
        for (a, i) in told.iter().enumerate() {
            // Where corners spoil the differences, each is as well known as it would be by itself, at best.
            let sigma = together.as_ref().map_or(by_itself(a), |all| libm::sqrt(all[(a, a)]));
            sigmas[*i] = Some(sigma).filter(|sigma| sigma.is_finite());
        }
        sigmas
    }
}
