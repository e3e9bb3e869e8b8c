//! What several calls take: systems, steps, beliefs.

use crate::decode::Arg;
use crate::encode::{Arrays, record};
use estimate::dynamic::{Belief, Continuous, Discrete, System};
use estimate::{Code, Error, validate};
use nalgebra::DMatrix;
use wasm_bindgen::prelude::*;

pub(crate) fn number_or(value: &JsValue, name: &'static str, default: f64) -> Result<f64, Error> {
    let arg = Arg::new(value, name);
    if arg.is_undefined() { Ok(default) } else { arg.number() }
}

pub(crate) fn system_of(value: &JsValue) -> Result<System, Error> {
    system_of_arg(&Arg::new(value, "system"))
}

/// `{ F, G, H, V, W }`, or `{ letters: 'filterpy', F, B, H, Q, R }`.
pub(crate) fn system_of_arg(arg: &Arg<'_>) -> Result<System, Error> {
    let plain = arg.plain_fields(&["F", "G", "H", "V", "W"], |arrays| {
        Some((arrays.matrix()?, arrays.matrix()?, arrays.matrix()?, arrays.matrix()?, arrays.matrix()?))
    });
    if let Some((f, g, h, v, w)) = plain {
        return System::new(f, g, h, v, w).map_err(|e| e.within("system"));
    }
    let letters = arg.field("letters")?;
    let named = !letters.is_undefined();
    let theirs = ["B", "Q", "R"];
    let [g, v, w] = if named { theirs } else { ["G", "V", "W"] };
    if named {
        letters.word(&["filterpy"])?;
        arg.only(["letters", "F", "B", "H", "Q", "R"].into_iter())?;
    }
    let (f, h) = (arg.field("F")?.tall()?, arg.field("H")?.tall()?);
    let inputs = inputs_of(&arg.field(g)?, f.nrows())?;
    let (v, w) = (noise_of(arg, v, theirs[1])?, noise_of(arg, w, theirs[2])?);
    System::new(f, inputs, h, v, w).map_err(|mut error| {
        if let Some(i) = ["G", "V", "W"].iter().position(|ours| named && error.argument == *ours) {
            error.argument = theirs[i].into();
        }
        error.within("system")
    })
}

/// The matrix of the inputs of `n` states, which is left out where there are none.
pub(crate) fn inputs_of(arg: &Arg<'_>, n: usize) -> Result<DMatrix<f64>, Error> {
    if arg.is_undefined() { Ok(DMatrix::zeros(n, 0)) } else { arg.wide() }
}

/// A covariance of a system. Where another letter for it is there in its place, the error says so.
fn noise_of(system: &Arg<'_>, letter: &'static str, other: &'static str) -> Result<DMatrix<f64>, Error> {
    let noise = system.field(letter)?;
    if noise.is_undefined() && !system.field(other)?.is_undefined() {
        let hint = "is undefined: the process noise is V here and the reading's noise W; a system with Q and R says \
                    letters: 'filterpy'";
        return Err(Error::new(Code::Type, ["system.", letter].concat(), hint));
    }
    noise.matrix()
}

/// `{ F, G, V }`.
pub(crate) fn step_of(arg: &Arg<'_>) -> Result<Discrete, Error> {
    let plain =
        arg.plain_fields(&["F", "G", "V"], |arrays| Some((arrays.matrix()?, arrays.matrix()?, arrays.matrix()?)));
    let (f, g, v) = match plain {
        Some(matrices) => matrices,
        None => {
            arg.only(["F", "G", "V"].into_iter())?;
            let f = arg.field("F")?.matrix()?;
            let g = inputs_of(&arg.field("G")?, f.nrows())?;
            (f, g, arg.field("V")?.matrix()?)
        }
    };
    Ok(Discrete { f, g, v })
}

/// `{ A, B, Q }`.
pub(crate) fn continuous_of(value: &JsValue) -> Result<Continuous, Error> {
    let arg = Arg::new(value, "system");
    let plain =
        arg.plain_fields(&["A", "B", "Q"], |arrays| Some((arrays.matrix()?, arrays.matrix()?, arrays.matrix()?)));
    let (a, b, q) = match plain {
        Some(matrices) => matrices,
        None => {
            let a = arg.field("A")?.tall()?;
            let b = inputs_of(&arg.field("B")?, a.nrows())?;
            (a, b, arg.field("Q")?.matrix()?)
        }
    };
    Continuous::new(a, b, q).map_err(|e| e.within("system"))
}

/// `{ x, P }`.
pub(crate) fn belief_of(arg: &Arg<'_>) -> Result<Belief, Error> {
    let (x, p) = match arg.plain_fields(&["x", "P"], |arrays| Some((arrays.vector()?, arrays.matrix()?))) {
        Some(arrays) => arrays,
        None => (arg.field("x")?.vector()?, arg.field("P")?.matrix()?),
    };
    validate::belief(x, p).map_err(|e| e.within("belief"))
}

/// A belief as `{ x, P }`.
pub(crate) fn shown_belief(belief: &Belief) -> JsValue {
    let object = record(&[]);
    Arrays::default().vector(belief.x.as_slice()).matrix(&belief.p).put(&object, &["x", "P"]);
    object
}
