//! Prints what the ensembles say: the figures beside which the chapter quotes its single runs.

use labs::ensembles::{SEEDS, probe, slam};

fn main() -> Result<(), estimate::Error> {
    for landmarks in [1, 2] {
        let e = probe(landmarks, SEEDS)?;
        let [trace, nees] = [&e.trace, &e.nees].map(|s| [0.05, 0.5, 0.9, 0.95].map(|p| s.percentile(p)));
        println!("probe, {landmarks}: trace {trace:.4?} mean NEES {nees:.2?} (5, 50, 90, 95 %)");
    }
    for found in [50.0, 30.0, 20.0, 15.0, 12.0, 9.21] {
        let e = slam(found, SEEDS)?;
        println!(
            "slam, found above {found}: matched {} to {}, median {}; worst {:.3?} m, {:.2?} sigma; spurious {} in {} runs, wrong {}",
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
    Ok(())
}
