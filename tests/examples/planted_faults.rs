//! Prints what a verdict names first in logs with one planted fault, and in logs without any:
//! `cargo run -p chapter-tests --example planted_faults`. A number behind it takes other logs: those from there on.

use chapter_tests::planted::{Case, EACH, FAULTS, SOUND, judged, planted, sound};
use estimate::Error;
use estimate::drive::{Fault, Size, Standing};

fn main() -> Result<(), Error> {
    let from = std::env::args().nth(1).and_then(|word| word.parse().ok()).unwrap_or(0);
    for (how, even) in [("Rates are held from row to row.", false), ("Rates change evenly, as in tables.", true)] {
        println!("{how}");
        let names = FAULTS.map(Fault::name);
        println!("| planted | {} | none | its number | sure | gain | within 2 σ |", names.join(" | "));
        println!("|---|{}---|---|---|---|---|", "---|".repeat(names.len()));
        for fault in FAULTS.map(Some).into_iter().chain([None]) {
            let cases: Vec<Case> = match fault {
                Some(fault) => (from..from + EACH).map(|n| planted(fault, n, even)).collect(),
                None => (from..from + SOUND).map(|n| sound(n, even)).collect(),
            };
            row(fault, &cases)?;
        }
    }
    Ok(())
}

/// What is named first in the logs of one fault.
fn row(fault: Option<Fault>, cases: &[Case]) -> Result<(), Error> {
    let mut named = [0; 8];
    let (mut number, mut sure, mut gain, mut within) = (0, 0, 0.0, 0);
    for case in cases {
        let judgement = judged(&case.log)?;
        let first = &judgement.suspects[0];
        let cleared = first.standing == Standing::Cleared;
        let at = FAULTS.iter().position(|kind| *kind == first.fault && !cleared).unwrap_or(7);
        named[at] += 1;
        number += u32::from(!cleared && Some(first.fault) == fault && first.number == case.number);
        sure += u32::from(first.standing == Standing::Sure);
        let own = judgement.suspects.iter().find(|s| Some(s.fault) == fault && s.number == case.number);
        if let Some(own) = own {
            gain += own.gain;
            let Size { now, value, sigma, .. } = own.sizes[0];
            // A σ is claimed e^size times too large.
            let (off, sigma) = match fault {
                Some(Fault::Sigma) => ((value / now).ln() + case.size, sigma / value),
                _ => (value - now - case.size, sigma),
            };
            within += u32::from(off.abs() < 2.0 * sigma);
        }
    }
    let name = fault.map_or("none", Fault::name);
    let counts: Vec<String> = named.iter().map(ToString::to_string).collect();
    println!("| {name} | {} | {number} | {sure} | {:.1} | {within} |", counts.join(" | "), gain / cases.len() as f64);
    Ok(())
}
