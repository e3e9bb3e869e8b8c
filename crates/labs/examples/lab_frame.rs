//! Reads a lab's state from standard input, in the form a copied link carries it (`[version, lab, step, parameters]`),
//! and prints the frame this machine's own code computes for it, for the test that compares every readout of a figure
//! in the page with it. A number that is not finite is printed as null.

mod read;
mod world;

use lab::{Lab, Params, Shown};
use labs::*;
use serde_json::Value;
use std::error::Error;
use std::io::Read;
use world::Sample;

type Answer<T> = Result<T, Box<dyn Error>>;

fn main() -> Answer<()> {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text)?;
    let (version, lab, step, params): (u32, String, u32, Value) = serde_json::from_str(&text)?;
    if version != 1 {
        return Err(format!("a state of version {version}; this knows version 1").into());
    }
    print(&lab, step, &params)
}

macro_rules! print_one {
    ($($module:ident::$lab:ident $(of $world:ident)? in $build:literal $(, was $was:literal)?;)*) => {
        fn print(lab: &str, step: u32, params: &Value) -> Answer<()> {
            match lab {
                $($lab::NAME => print_frame::<$lab>(step, params),)*
                _ => Err(format!("there is no lab {lab}").into()),
            }
        }
    };
}

labs::figures!(print_one);

fn print_frame<L: Lab<World: Sample>>(step: u32, params: &Value) -> Answer<()> {
    let lab = L::at(Sample::sample(L::NAME)?, given(params)?, step)?;
    println!("{}", serde_json::to_string(&Shown(&lab.frame()))?);
    Ok(())
}

fn given<P: Params>(params: &Value) -> Answer<P> {
    let mut numbers = Vec::new();
    for parameter in P::PARAMETERS {
        read::read(&parameter.shape, &params[parameter.name], &mut numbers)
            .ok_or_else(|| format!("no {}", parameter.name))?;
    }
    Ok(P::read(&mut numbers.iter()))
}
