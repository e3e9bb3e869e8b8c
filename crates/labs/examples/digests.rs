//! Runs each lab for 10,000 steps (that of the log for as many rows), as it opens and as a reader may set it, and
//! prints the hash of every number it records, for the test that compares this machine's own code with wasm in Node and
//! in browsers.

mod world;

use lab::{Lab, Shown};
use labs::*;
use world::Sample;

fn print<L: Lab<World: Sample>>() -> Result<(), Box<dyn std::error::Error>> {
    for params in L::tried() {
        let given = serde_json::to_string(&Shown(&params))?;
        let lab = L::at(Sample::sample(L::NAME)?, params, 10_000)?;
        println!("{} {:016x} {given}", L::NAME, lab.digest());
    }
    Ok(())
}

macro_rules! print_each {
    ($($module:ident::$lab:ident $(of $world:ident)? in $build:literal $(, was $was:literal)?;)*) => {
        fn main() -> Result<(), Box<dyn std::error::Error>> {
            $(print::<$lab>()?;)*
            Ok(())
        }
    };
}

labs::figures!(print_each);
