//! The museum of bugs over many seeds: the bands of the right filter, the symptoms of each bug, and whether the bugs
//! are told apart by the symptom table alone.

use chapter_kalman::ensembles::{Distribution, FIGURES, PANELS, SEEDS, Sight, Symptoms, diagnosed, museum_runs};
use labs::Bug;
use labs::bug_museum::MuseumParams;

/// The seeds of the bands are none of those that are judged by them.
const CALIBRATION: (u32, u32) = (100_000, 4000);
/// Nor are the seeds of the table any of those that are diagnosed with it.
const TABLE: u32 = 10_000;

fn main() -> Result<(), estimate::Error> {
    let judged = MuseumParams::default().seed;
    let right = museum_runs([Bug::None; 2], CALIBRATION.0, CALIBRATION.1)?;
    for i in 0..FIGURES {
        let spread = Distribution::new(right.iter().map(|run| run[i]));
        let quantiles = [0.005, 0.025, 0.975, 0.995].map(|p| spread.percentile(p));
        let variance = right.iter().map(|run| (run[i] - spread.mean()).powi(2)).sum::<f64>() / right.len() as f64;
        println!("    {quantiles:?}, // {i}: {:?}", [spread.mean(), variance.sqrt()]);
    }
    let all: Vec<Bug> = [Bug::None].into_iter().chain(Bug::ALL).collect();
    let mut table = Vec::new();
    for bug in &all {
        let runs = museum_runs([*bug, Bug::None], judged, SEEDS)?;
        let symptoms = Symptoms::of(&runs);
        print!("{:22}", format!("{bug:?}"));
        for (panel, (_, figures)) in PANELS.iter().enumerate() {
            let mark = match symptoms.panel(panel) {
                Sight::Invisible => "-",
                Sight::InMany => "o",
                Sight::InOne => "*",
            };
            let shares: Vec<String> = figures
                .iter()
                .map(|&i| {
                    let median = Distribution::new(runs.iter().map(|run| run[i])).median();
                    let [below, above] = symptoms.beyond[i].map(|share| 100.0 * share);
                    format!("{median:.3} {below:.1}/{above:.1}")
                })
                .collect();
            print!(" {mark}[{}]", shares.join(", "));
        }
        println!();
        table.push((*bug, Symptoms::of(&museum_runs([*bug, Bug::None], TABLE, SEEDS)?)));
    }
    for together in [1, 5] {
        println!("diagnosed from {together} runs:");
        for bug in &all {
            let runs = museum_runs([*bug, Bug::None], judged, SEEDS)?;
            let named: Vec<Option<Bug>> = runs.chunks_exact(together).map(|some| diagnosed(&table, some)).collect();
            let share = |other: Bug| {
                named.iter().filter(|name| **name == Some(other)).count() as f64 / named.len() as f64 * 100.0
            };
            let others: Vec<String> = all
                .iter()
                .filter(|other| *other != bug && share(**other) >= 1.0)
                .map(|other| format!("{other:?} {:.0}", share(*other)))
                .collect();
            println!("{:22} {:.1} %; taken for {}", format!("{bug:?}"), share(*bug), others.join(", "));
        }
    }
    Ok(())
}
