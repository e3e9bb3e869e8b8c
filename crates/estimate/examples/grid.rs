//! Examines a million ordinary systems, and prints what it counted. It ends with an error when an answer is wrong, or a
//! refusal not true.
//!
//! ```sh
//! cargo run --release -p robot-motion-estimate --example grid [systems]
//! ```

#[path = "../tests/grid/mod.rs"]
mod grid;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let systems = std::env::args().nth(1).map_or(Ok(1_000_000), |systems| systems.parse())?;
    let count = grid::examine(systems, 1);
    println!("{count:#?}");
    if count.wrong == 0 { Ok(()) } else { Err(format!("{} wrong answers", count.wrong).into()) }
}
