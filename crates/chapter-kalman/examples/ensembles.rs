//! Prints what the ensembles say: the figures beside which the chapter quotes its single runs.

use chapter_kalman::ensembles::{SEEDS, fits, loops, probe, slam};

fn main() -> Result<(), estimate::Error> {
    for landmarks in [1, 2] {
        let e = probe(landmarks, SEEDS)?;
        let [trace, nees] = [&e.trace, &e.nees].map(|s| [0.05, 0.5, 0.9, 0.95].map(|p| s.percentile(p)));
        println!("probe, {landmarks}: trace {trace:.4?} mean NEES {nees:.2?} (5, 50, 90, 95 %)");
    }
    for found in [50.0, 30.0, 20.0, 15.0, 12.0, 9.21] {
        let e = slam(found, SEEDS)?;
        println!(
            "slam, found above {found}: matched {} to {}, median {}; worst {:.3?} m, {:.2?} sigma; spurious {} in {} \
                runs, wrong {}",
            e.matched.min(),
            e.matched.max(),
            e.matched.median(),
            [0.05, 0.5, 0.95].map(|p| e.worst.percentile(p)),
            [0.05, 0.5, 0.95].map(|p| e.sigma.percentile(p)),
            e.spurious,
            e.with_spurious,
            e.wrong
        );
    }
    for correlated in [true, false] {
        let e = loops(correlated, SEEDS)?;
        let [nees, error, sigma, above, shrinks] =
            [&e.nees, &e.error, &e.sigma, &e.above, &e.shrinks].map(|s| [0.05, 0.5, 0.95].map(|p| s.percentile(p)));
        println!(
            "loop, correlated {correlated}: mean NEES {nees:.2?}, of all {:.2}; error {error:.3?} m, claimed \
                {sigma:.3?} m; above {above:.2?}; \
             shrinks {shrinks:.2?}; ghosts in {} runs, wrong in {}",
            e.nees.mean(),
            e.with_ghosts,
            e.with_wrong
        );
    }
    for length in [25, 50, 100, 200, 400, 1000] {
        let e = fits(length, SEEDS)?;
        let [q, w, axis, along] =
            [&e.sigma_q, &e.sigma_w, &e.axis, &e.along_ratio].map(|s| [0.05, 0.5, 0.95].map(|p| s.percentile(p)));
        println!(
            "fit, {length}: covered {:.3}, within {:.3}, distance {:.2}; sigma q {q:.3?} W {w:.3?}; axis {axis:.2?}, \
                along q/W {along:.2?}; \
             held {}",
            e.covered,
            e.within,
            e.distance.mean(),
            e.held
        );
    }
    Ok(())
}
