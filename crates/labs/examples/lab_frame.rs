//! Reads a lab's state from standard input, in the form a copied link carries it (`[version, lab, step, parameters]`),
//! and prints the frame this machine's own code computes for it, for the test that compares every readout of a figure
//! in the page with it. A number that is not finite is printed as null.

mod world;

use lab::{Lab, Params, Shape, Shown};
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
        read(&parameter.shape, &params[parameter.name], &mut numbers)
            .ok_or_else(|| format!("no {}", parameter.name))?;
    }
    Ok(P::read(&mut numbers.iter()))
}

/// Appends the numbers of a parameter, every one of which must be there.
fn read(shape: &Shape, value: &Value, to: &mut Vec<f64>) -> Option<()> {
    match shape {
        Shape::Number | Shape::Whole => to.push(value.as_f64()?),
        Shape::Flag => to.push(f64::from(value.as_bool()?)),
        Shape::Word(words) => to.push(words.iter().position(|word| value == word)? as f64),
        Shape::Maybe(_) if value.is_null() => to.push(0.0),
        Shape::Maybe(inner) => {
            to.push(1.0);
            read(inner, value, to)?;
        }
        Shape::Exactly(n, entry) => {
            let entries = value.as_array().filter(|entries| entries.len() == *n)?;
            entries.iter().try_for_each(|each| read(entry, each, to))?;
        }
        Shape::Each(names, inner) => {
            let of = |name| if value.is_object() { value.get(name) } else { Some(value) };
            names.iter().try_for_each(|name| read(inner, of(name)?, to))?;
        }
        Shape::Text | Shape::List(_) | Shape::Record(..) | Shape::Sparse(..) => return None,
    }
    Some(())
}
