//! Numbers of systems with an unseen direction: in which of them the variance grows, and how fast.

use crate::givens::Givens;
use estimate::Error;
use filters::linear;
use lab::Listing;
use nalgebra::{Matrix1, Matrix2, RowVector2};

/// Steps after which a variance that settles has settled, and one that grows has reached its rate.
const LONG: u32 = 20_000;

/// Two states, of which the sensor reads the second.
struct Case {
    f: Matrix2<f64>,
    v: Matrix2<f64>,
    w: f64,
}

impl Case {
    /// P₁₁ after `LONG` updates from `p`, and what the last step added to it.
    fn end(&self, p: &Matrix2<f64>) -> Result<[f64; 2], Error> {
        let (mut p, mut last) = (*p, 0.0);
        for _ in 0..LONG {
            last = p[(0, 0)];
            let predicted = linear::predicted_covariance(&self.f, &p, &self.v)?;
            p = linear::gain(&predicted, &RowVector2::new(0.0, 1.0), &Matrix1::new(self.w))?.p;
        }
        Ok([p[(0, 0)], p[(0, 0)] - last])
    }
}

pub(super) fn list(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let (rail, p0) = (&givens.velocity, &givens.belief.p);
    let (f, w) = (rail.f, rail.w[0]);
    let kicked = Matrix2::from_diagonal_element(0.0) + Matrix2::new(0.0, 0.0, 0.0, rail.v[(1, 1)]);
    let no_noise = Case { f, v: Matrix2::zeros(), w }.end(p0)?;
    let kicks_alone = Case { f, v: kicked, w }.end(p0)?;
    let decaying = Case { f: Matrix2::new(0.5, 0.0, 0.0, 1.0), v: Matrix2::identity(), w: 1.0 }.end(p0)?;
    to.by("chapter_kalman::numbers::detectability::list", None)
        .add("unseen.no_noise.growth", no_noise[1], "what P₁₁ gains a step in the long run when V = 0, m²: T²W")
        .add("unseen.kicks.growth", kicks_alone[1], "the same when V kicks the velocity alone, m²")
        .add("unseen.decaying.limit", decaying[0], "the limit of P₁₁ for F = diag(½, 1), H = [0 1], V = I, W = 1: 4/3");

    // An exact reading leaves a segment: P⁺ = P⁻ − RHP⁻ with W = 0. One prediction later it may have width again.
    let predicted = linear::predicted_covariance(&f, p0, &rail.v)?;
    let segment = linear::gain(&predicted, &rail.h, &Matrix1::new(0.0))?.p;
    let revived = linear::predicted_covariance(&f, &segment, &kicked)?;
    to.add("segment.det", segment.determinant(), "det P⁺ after an exact reading").add(
        "segment.revived.det",
        revived.determinant(),
        "det P⁻ one step later with V = diag(0, V₂₂)",
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn an_unseen_variance_grows_or_not_as_f_on_the_unseen_direction_decides() {
        let mut listing = Listing::new();
        list(&Givens::default(), &mut listing).expect("computed");
        let n: BTreeMap<_, _> = listing.numbers.into_iter().map(|n| (n.id, n.value)).collect();
        // V = 0: after k readings the velocity's variance is W/k, and k steps of it are (kT)²W/k. The rate nears T²W
        // like 1/k.
        assert!((n["unseen.no_noise.growth"] - 0.125).abs() < 1e-4);
        // The velocity's own limit is as with the full V. The position then gains T²W a step: see the text.
        assert!((n["unseen.kicks.growth"] - 0.125).abs() < 1e-9);
        assert!((n["unseen.decaying.limit"] - 4.0 / 3.0).abs() < 1e-12);
        assert!(n["segment.det"].abs() < 1e-15);
        assert!((n["segment.revived.det"] - 0.1175).abs() < 1e-12);
    }
}
