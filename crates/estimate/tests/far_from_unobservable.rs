//! A pair far from every one that is not observable is said to be observable; one that a change within the tolerance
//! makes unobservable is not. The distance is looked for here over a grid of the complex plane.

use estimate::dynamic::{System, detectability, movable, noise_reach, riccati_limit};
use estimate::{RiccatiLimit, Verdict};
use nalgebra::{DMatrix, DVector, dmatrix};

const TOLERANCE: f64 = 1e-9;
/// What is farther, as a part of the size of F and H, is far.
const FAR: f64 = 1e-3;

/// Numbers in [0, 1) that look like chance and are the same everywhere.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.next()
    }

    /// Turns and single states along the diagonal, neither of which gives to another, some coupled.
    fn dynamics(&mut self, n: usize) -> DMatrix<f64> {
        let mut f = DMatrix::zeros(n, n);
        let mut i = 0;
        while i < n {
            let size = self.between(0.3, 1.05);
            if i + 1 < n && self.next() < 0.6 {
                let angle = self.between(0.02, 3.0);
                let (c, s) = (size * angle.cos(), size * angle.sin());
                f.view_mut((i, i), (2, 2)).copy_from(&dmatrix![c, s; -s, c]);
                i += 2;
            } else {
                f[(i, i)] = size;
                i += 1;
            }
        }
        if self.next() < 0.3 && n > 2 {
            f[(0, n - 1)] += self.between(-1.0, 1.0);
        }
        f
    }

    fn outputs(&mut self, p: usize, n: usize) -> DMatrix<f64> {
        DMatrix::from_fn(p, n, |_, _| if self.next() < 0.3 { 0.0 } else { self.between(-2.0, 2.0) })
    }

    /// In other coordinates, x = Tz with T a reflection, or as they are.
    fn turned(&mut self, f: DMatrix<f64>, h: DMatrix<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
        if self.next() < 0.5 {
            return (f, h);
        }
        let n = f.nrows();
        let v = DVector::from_fn(n, |_, _| self.between(0.1, 1.0));
        let t = DMatrix::identity(n, n) - &v * v.transpose() * (2.0 / v.norm_squared());
        (&t * f * &t, h * t)
    }
}

/// The least singular value of [F − zI; H] for F and H of size 1, at the eigenvalues of F, over a grid, and downhill
/// from the least of these.
fn distance(f: &DMatrix<f64>, h: &DMatrix<f64>) -> f64 {
    let (n, p) = (f.nrows(), h.nrows());
    let (f, h) = (f / f.norm(), h / h.norm());
    let at = |(re, im): (f64, f64)| {
        let mut real = DMatrix::zeros(2 * (n + p), 2 * n);
        let shifted = &f - DMatrix::identity(n, n) * re;
        for side in 0..2 {
            real.view_mut((side * n, side * n), (n, n)).copy_from(&shifted);
            real.view_mut((2 * n + side * p, side * n), (p, n)).copy_from(&h);
        }
        for i in 0..n {
            (real[(i, n + i)], real[(n + i, i)]) = (im, -im);
        }
        real.singular_values().min()
    };
    let grid = (0..12).flat_map(|i| (0..6).map(move |j| (-1.0 + 2.0 * f64::from(i) / 11.0, f64::from(j) / 5.0)));
    let own = f.complex_eigenvalues();
    let places = own.iter().map(|z| (z.re, z.im)).chain(grid);
    let mut best = places.map(|z| (at(z), z)).reduce(|a, b| if b.0 < a.0 { b } else { a }).expect("places");
    let mut step = 0.1;
    while step > 1e-6 {
        let (re, im) = best.1;
        let around = [(re + step, im), (re - step, im), (re, im + step), (re, im - step)];
        match around.map(|z| (at(z), z)).into_iter().find(|found| found.0 < best.0) {
            Some(found) => best = found,
            None => step *= 0.5,
        }
    }
    best.0
}

fn turn_beside(cos: f64, sin: f64, alone: f64) -> DMatrix<f64> {
    dmatrix![cos, sin, 0.0; -sin, cos, 0.0; 0.0, 0.0, alone]
}

#[test]
fn a_turn_beside_a_state_that_dies_out_is_observable() {
    let (c, s) = (0.07_f64.cos(), 0.07_f64.sin());
    let h = dmatrix![1.0, 0.0, 1.0];
    for f in [turn_beside(c, s, 0.9), turn_beside(0.99755, 0.06994, 0.9), turn_beside(c, s, 0.5)] {
        assert!(distance(&f, &h) > 0.01);
        let seen = detectability(f.clone(), h.clone(), TOLERANCE).expect("found");
        assert_eq!((seen.observable, seen.detectable), (Verdict::Yes, Verdict::Yes), "{f}");
        assert!(seen.unseen.is_empty());
        assert_eq!(movable(f.clone(), h.clone(), TOLERANCE).expect("found").count(), 3, "{f}");
        let system = |v: [f64; 3]| {
            let v = DMatrix::from_diagonal(&DVector::from_row_slice(&v));
            System::new(f.clone(), DMatrix::zeros(3, 0), h.clone(), v, dmatrix![0.04]).expect("sound")
        };
        let limit = |v| riccati_limit(&system(v), TOLERANCE).expect("found");
        assert_eq!(limit([1e-3, 1e-3, 0.02]), RiccatiLimit::FromEveryStart, "{f}");
        // The turn, which no noise moves.
        let still = noise_reach(f.clone(), system([0.0, 0.0, 0.02]).v, TOLERANCE).expect("found");
        assert_eq!((still.reachable, still.unreached.len()), (Verdict::No, 2), "{f}");
        // Rounded, it dies out.
        let rounded = f[(0, 0)] != c;
        let expected = if rounded { RiccatiLimit::FromEveryStart } else { RiccatiLimit::FromLargeStart };
        assert_eq!(limit([0.0, 0.0, 0.02]), expected, "{f}");
    }
}

#[test]
fn two_hundred_pairs_far_from_every_unobservable_one_are_decided() {
    let mut chance = Chance(7);
    let mut decided = [0; 7];
    for index in 0.. {
        let n = 2 + index % 5;
        let p = 1 + usize::from(chance.next() < 0.3);
        let (f, h) = (chance.dynamics(n), chance.outputs(p, n));
        let (f, h) = chance.turned(f, h);
        if h.amax() == 0.0 || distance(&f, &h) < FAR {
            continue;
        }
        let seen = detectability(f.clone(), h.clone(), TOLERANCE).expect("found");
        assert_eq!((seen.observable, seen.detectable), (Verdict::Yes, Verdict::Yes), "{f}{h}");
        assert_eq!(movable(f.clone(), h.clone(), TOLERANCE).expect("found").count(), n, "{f}{h}");
        decided[n] += 1;
        if decided.iter().sum::<usize>() == 200 {
            break;
        }
    }
    assert!(decided[2..].iter().all(|count| *count >= 20), "{decided:?}");
}

#[test]
fn pairs_that_a_change_within_the_tolerance_hides_stay_undecided() {
    let mut chance = Chance(11);
    for index in 0..60 {
        let n = 2 + index % 5;
        let mut f = chance.dynamics(n);
        // Two states that go alike but for a part of the tolerance, and are read in a sum.
        let alike = chance.between(0.3, 1.05);
        for i in [n - 2, n - 1] {
            f.row_mut(i).fill(0.0);
            f.column_mut(i).fill(0.0);
            f[(i, i)] = alike + if i == n - 1 { chance.between(0.05, 0.5) * TOLERANCE } else { 0.0 };
        }
        let h = DMatrix::from_fn(1, n, |_, _| chance.between(0.5, 2.0));
        let (f, h) = chance.turned(f, h);
        assert!(distance(&f, &h) < TOLERANCE);
        let seen = detectability(f.clone(), h.clone(), TOLERANCE).expect("found");
        assert_eq!(seen.observable, Verdict::Undecided, "{f}{h}");
    }
}

/// Each state is seen in the one before it, a hundredth of it; the last one, by way of all of them, is not.
#[test]
fn a_chain_whose_links_are_seen_and_whose_end_is_not_stays_undecided() {
    let chain = |link: f64| {
        let f = DMatrix::from_fn(6, 6, |i, j| match i.abs_diff(j) {
            0 => i as f64,
            1 => link,
            _ => 0.0,
        });
        let h = dmatrix![1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        (distance(&f, &h), detectability(f, h, TOLERANCE).expect("found").observable)
    };
    let (near, found) = chain(0.01);
    assert!(near < 1e-11, "{near:e}");
    assert_eq!(found, Verdict::Undecided);
    let (far, found) = chain(0.5);
    assert!(far > 1e-5, "{far:e}");
    assert_eq!(found, Verdict::Yes);
}
