//! Numbers of the corridor's loop over 500 seeds, by the right filter and by the one without cross-covariances.

use super::ensembles::percentiles;
use crate::ensembles::{SEEDS, loops};
use estimate::{Code, Error};
use filters::consistency::chi2_quantile;
use lab::{Lab, Listing};
use labs::{LoopClosure, LoopParams};

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    for (name, correlated) in [("right", true), ("apart", false)] {
        let runs = loops(correlated, SEEDS)?;
        let id = |part: &str| format!("ensemble.loop.{name}.{part}");
        to.by("chapter_kalman::ensembles::loops", None);
        percentiles(to, &id("nees"), &runs.nees, "the mean NEES of a lap; 3 is expected");
        percentiles(to, &id("error"), &runs.error, "the error of the position after a lap, m");
        percentiles(to, &id("sigma"), &runs.sigma, "one sigma of it in a coordinate as claimed, m");
        to.add(id("nees.mean"), runs.nees.mean(), "the mean of the runs' mean NEES")
            .add(id("above"), runs.above.median(), "median share of a lap's steps with NEES above its 95 % band")
            .add(
                id("shrinks"),
                runs.shrinks.median(),
                "median factor by which the closure shrinks the map's mean sigma",
            )
            .add(id("ghosts"), f64::from(runs.with_ghosts), "runs in which a landmark was founded twice")
            .add(id("wrong"), f64::from(runs.with_wrong), "runs with a wrong match");
    }
    closing(to)?;
    exercises(to)
}

/// The step that closes the loop in the figure's first run: by how much each landmark's σ falls, and what the square
/// says of the landmark that closes it.
fn closing(to: &mut Listing) -> Result<(), Error> {
    let off = |_| Error::new(Code::Limit, "loop", "is not closed within a lap");
    let mut lab = LoopClosure::new(LoopParams::default())?;
    let mut before = lab.frame();
    while lab.frame().closure.is_none() {
        before = lab.frame();
        lab.run(1)?;
    }
    let after = lab.frame();
    let closed = after.closure.map(|it| it.landmark).ok_or(()).map_err(off)?;
    let sigma = |p: &[[f64; 2]; 2]| (0.5 * (p[0][0] + p[1][1])).sqrt();
    let pairs = before.map.landmarks.iter().zip(&after.map.landmarks);
    let shares: Vec<f64> = pairs.map(|(was, is)| sigma(&is.p) / sigma(&was.p)).collect();
    let at = before.map.landmarks.iter().position(|it| it.truth == closed).ok_or(()).map_err(off)?;
    let row = before.correlation[at + 1].iter().enumerate().filter(|(other, _)| *other != at + 1);
    to.by("labs::LoopClosure", None)
        .add("loop.close.landmark", closed as f64 + 1.0, "the number of the landmark that closes the loop")
        .add("loop.close.own", 1.0 - shares[at], "by which share its own sigma falls in that step")
        .add("loop.close.most", 1.0 - shares.iter().copied().fold(f64::INFINITY, f64::min), "the largest such share")
        .add("loop.close.least", 1.0 - shares.iter().copied().fold(0.0, f64::max), "the smallest")
        .add(
            "loop.close.row",
            row.map(|(_, c)| c.abs()).fold(0.0, f64::max),
            "the largest correlation in its row before",
        );
    Ok(())
}

/// χ² of a right sighting has two degrees of freedom: it is above g with the probability exp(−g/2).
fn exercises(to: &mut Listing) -> Result<(), Error> {
    let rare = 1e-6;
    to.by("chapter_kalman::numbers::loops::exercises", None)
        .add("ex.ghost", -2.0 * libm::log(rare), "χ² that a right sighting exceeds once in a million")
        .add("ex.ghost.one", chi2_quantile(1, 1.0 - rare)?, "the same with one degree of freedom")
        .add("ex.ghost.half", -libm::log(rare), "the same with exp(−g) in place of exp(−g/2)");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn every_ellipse_shrinks_when_the_loop_closes_though_the_landmark_read_goes_with_no_other() {
        let mut listing = Listing::new();
        closing(&mut listing).expect("closed");
        let n: BTreeMap<_, _> = listing.numbers.into_iter().map(|n| (n.id, n.value)).collect();
        assert!(n["loop.close.least"] > 0.0 && n["loop.close.own"] < 0.01, "{}", n["loop.close.least"]);
        assert!(n["loop.close.most"] > 0.5 && n["loop.close.row"] < 0.15, "{}", n["loop.close.row"]);
    }
}
