//! The filters of a caller's own models: f and h are JavaScript functions on arrays.

use crate::arguments::belief_of;
use crate::decode::{Arg, Outputs};
use crate::encode::{list, number_or_null, record, rows};
use crate::errors::{Refused, Thrown};
use crate::object::Held;
use estimate::dynamic::{
    ExtendedKalmanFilter as Extended, Gated, OwnReading, SIGMA_POINTS, UnscentedKalmanFilter as Unscented,
};
use estimate::validate::{MAX_OUTPUTS, MAX_STATES};
use estimate::{Code, Error};
use js_sys::{Array, Function};
use nalgebra::DMatrix;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("own_models.d.ts");

#[wasm_bindgen]
extern "C" {
    // May answer nothing, like the readers of `decode`: what throws leaves no place in the table of references.
    #[wasm_bindgen(catch, js_namespace = Reflect, js_name = apply)]
    fn apply(function: &Function, this: &JsValue, arguments: &Array) -> Result<Option<JsValue>, JsValue>;
}

/// An extended Kalman filter over models of your own: x(k+1) = f(x(k)) + v, y(k) = h(x(k)) + w. `f` and `h` are
/// functions from an array of numbers to one; their Jacobians F and H are functions from x to an array of rows, and are
/// taken by central differences where they are left out. What a function throws comes through, what it answers is
/// checked, and the filter is as it was in both cases.
#[wasm_bindgen]
#[repr(transparent)]
pub struct ExtendedKalmanFilter(Held);

const EXTENDED: &str = "ExtendedKalmanFilter";

#[wasm_bindgen]
impl ExtendedKalmanFilter {
    /// The filter with the belief before the first step.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "OwnStateOptions")] options: &JsValue,
    ) -> Result<ExtendedKalmanFilter, Thrown> {
        let belief = belief_of(&Arg::new(belief, "belief"))?;
        let angles = optional(&Arg::new(options, "options"), &["angles"], |it| angles_of(it, MAX_STATES))?;
        let filter = Extended::new(&belief, &angles.unwrap_or_default()).map_err(in_options)?;
        Ok(Self(Held::new(EXTENDED, filter)))
    }

    /// x = f(x), P = F P Fᵀ + V, with F = ∂f/∂x at the old x. What f needs beside x, an input or a span of time, it
    /// takes from around it.
    pub fn predict(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Model")] f: &JsValue,
        #[wasm_bindgen(js_name = V, unchecked_param_type = "Rows")] v: &JsValue,
        #[wasm_bindgen(js_name = F, unchecked_optional_param_type = "ModelJacobian")] jacobian: &JsValue,
    ) -> Result<(), Thrown> {
        let (f, v) = (function(f, "f")?, Arg::new(v, "V").matrix()?);
        let jacobian = given(jacobian, "F")?;
        self.0.write(EXTENDED, |filter: &mut Extended| {
            let mut f = |x: &[f64]| called(&f, x, "f(x)");
            match &jacobian {
                Some(jacobian) => filter.predict(&mut f, v, Some(&mut |x| slope(jacobian, x, "F(x)"))),
                None => filter.predict(&mut f, v, None),
            }
        })
    }

    /// Corrects the belief by the reading `y` of h, of noise covariance `W`. A part of y that is null was not read.
    #[wasm_bindgen(unchecked_return_type = "OwnUpdate")]
    pub fn update(
        &self,
        #[wasm_bindgen(unchecked_param_type = "PartialVector | Float64Array")] y: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Model")] h: &JsValue,
        #[wasm_bindgen(js_name = W, unchecked_param_type = "Rows")] w: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "OwnUpdateOptions")] options: &JsValue,
    ) -> Result<JsValue, Thrown> {
        let (reading, h) = (Told::new(y, w, options, &["angles", "gate", "H"])?, function(h, "h")?);
        let jacobian = match options.is_object() {
            true => Arg::new(options, "options").field("H")?.function()?,
            false => None,
        };
        let gated = self.0.write(EXTENDED, |filter: &mut Extended| {
            let mut h = |x: &[f64]| called(&h, x, "h(x)");
            let updated = match &jacobian {
                Some(jacobian) => filter.update(&reading.core(), &mut h, Some(&mut |x| slope(jacobian, x, "H(x)"))),
                None => filter.update(&reading.core(), &mut h, None),
            };
            updated.map_err(of_options)
        })?;
        Ok(shown(&gated))
    }

    /// The mean; angles in (−π, π].
    #[wasm_bindgen(getter, unchecked_return_type = "Vector")]
    pub fn x(&self) -> Result<JsValue, Thrown> {
        self.0.read(EXTENDED, |filter: &Extended| list(filter.x()))
    }

    /// The covariance.
    #[wasm_bindgen(getter = P, unchecked_return_type = "Matrix")]
    pub fn p(&self) -> Result<JsValue, Thrown> {
        self.0.read(EXTENDED, |filter: &Extended| rows(filter.p()))
    }

    /// Whether S and P of every step so far are right to 10⁻⁶ of their largest entries, for the Jacobians that were
    /// used.
    #[wasm_bindgen(getter)]
    pub fn conditioned(&self) -> Result<bool, Thrown> {
        self.0.read(EXTENDED, Extended::conditioned)
    }
}

/// An unscented Kalman filter over models of your own: x(k+1) = f(x(k)) + v, y(k) = h(x(k)) + w. It needs no Jacobian:
/// f and h are asked at 2n + 1 points. Otherwise it is as `ExtendedKalmanFilter`; P must be positive definite.
#[wasm_bindgen]
#[repr(transparent)]
pub struct UnscentedKalmanFilter(Held);

const UNSCENTED: &str = "UnscentedKalmanFilter";

#[wasm_bindgen]
impl UnscentedKalmanFilter {
    /// The filter with the belief before the first step.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "UnscentedOptions")] options: &JsValue,
    ) -> Result<UnscentedKalmanFilter, Thrown> {
        let belief = belief_of(&Arg::new(belief, "belief"))?;
        let mut points = SIGMA_POINTS;
        let angles = optional(&Arg::new(options, "options"), &["angles", "alpha", "beta", "kappa"], |it| {
            it.given("alpha", |a| a.number(), &mut points.alpha)?;
            it.given("beta", |a| a.number(), &mut points.beta)?;
            it.given("kappa", |a| a.number(), &mut points.kappa)?;
            angles_of(it, MAX_STATES)
        })?;
        let filter = Unscented::new(&belief, &angles.unwrap_or_default(), points).map_err(in_options)?;
        Ok(Self(Held::new(UNSCENTED, filter)))
    }

    /// The belief after x = f(x) + v, Cov v = V.
    pub fn predict(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Model")] f: &JsValue,
        #[wasm_bindgen(js_name = V, unchecked_param_type = "Rows")] v: &JsValue,
    ) -> Result<(), Thrown> {
        let (f, v) = (function(f, "f")?, Arg::new(v, "V").matrix()?);
        self.0.write(UNSCENTED, |filter: &mut Unscented| filter.predict(&mut |x| called(&f, x, "f(x)"), v))
    }

    /// Corrects the belief by the reading `y` of h, of noise covariance `W`. A part of y that is null was not read.
    #[wasm_bindgen(unchecked_return_type = "OwnUpdate")]
    pub fn update(
        &self,
        #[wasm_bindgen(unchecked_param_type = "PartialVector | Float64Array")] y: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Model")] h: &JsValue,
        #[wasm_bindgen(js_name = W, unchecked_param_type = "Rows")] w: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "UnscentedUpdateOptions")] options: &JsValue,
    ) -> Result<JsValue, Thrown> {
        let (reading, h) = (Told::new(y, w, options, &["angles", "gate"])?, function(h, "h")?);
        let update =
            |filter: &mut Unscented| filter.update(&reading.core(), &mut |x| called(&h, x, "h(x)")).map_err(of_options);
        self.0.write(UNSCENTED, update).map(|gated| shown(&gated))
    }

    /// The mean; angles in (−π, π].
    #[wasm_bindgen(getter, unchecked_return_type = "Vector")]
    pub fn x(&self) -> Result<JsValue, Thrown> {
        self.0.read(UNSCENTED, |filter: &Unscented| list(filter.x()))
    }

    /// The covariance.
    #[wasm_bindgen(getter = P, unchecked_return_type = "Matrix")]
    pub fn p(&self) -> Result<JsValue, Thrown> {
        self.0.read(UNSCENTED, |filter: &Unscented| rows(filter.p()))
    }
}

/// A reading, decoded before the filter is borrowed.
struct Told {
    y: Vec<Option<f64>>,
    w: DMatrix<f64>,
    angles: Vec<usize>,
    gate: Option<f64>,
}

impl Told {
    fn new(y: &JsValue, w: &JsValue, options: &JsValue, known: &[&'static str]) -> Result<Self, Error> {
        let (y, w) = (Arg::new(y, "y").reading().map(Outputs::parts)?, Arg::new(w, "W").matrix()?);
        let read = |it: &Arg<'_>| Ok((angles_of(it, MAX_OUTPUTS)?, it.field("gate")?.number_or_null()?));
        let (angles, gate) = optional(&Arg::new(options, "options"), known, read)?.unwrap_or_default();
        Ok(Self { y, w, angles, gate })
    }

    fn core(&self) -> OwnReading<'_> {
        OwnReading { y: &self.y, w: self.w.clone(), angles: &self.angles, gate: self.gate }
    }
}

/// What `read` finds in an object that may be left out.
fn optional<T>(
    options: &Arg<'_>,
    known: &[&'static str],
    read: impl FnOnce(&Arg<'_>) -> Result<T, Error>,
) -> Result<Option<T>, Error> {
    if options.is_undefined() {
        return Ok(None);
    }
    options.only(known.iter().copied())?;
    read(options).map(Some)
}

pub(crate) fn angles_of(options: &Arg<'_>, most: usize) -> Result<Vec<usize>, Error> {
    let mut angles = Vec::new();
    let read = |list: &Arg<'_>| list.entries()?.iter().map(|it| Ok(it.whole(0, most as u32 - 1)? as usize)).collect();
    options.given("angles", read, &mut angles)?;
    Ok(angles)
}

/// An error of the core about the options, which it knows by themselves.
fn in_options(error: Error) -> Error {
    match &*error.argument {
        "points" => Error::new(error.code, "options", error.message.clone()),
        argument if argument.starts_with("angles") => error.within("options"),
        _ => error.part_of("options", &["gate"]),
    }
}

fn of_options(refused: Refused) -> Refused {
    match refused {
        Refused::Ours(error) => Refused::Ours(in_options(error)),
        theirs => theirs,
    }
}

fn function(value: &JsValue, name: &'static str) -> Result<Function, Error> {
    given(value, name)?.ok_or_else(|| Error::new(Code::Type, name, "is undefined; it must be a function"))
}

fn given(value: &JsValue, name: &'static str) -> Result<Option<Function>, Error> {
    Arg::new(value, name).function()
}

/// What a caller's function answers at x, as an error calls it.
fn answer(function: &Function, x: &[f64], name: &'static str) -> Result<JsValue, Refused> {
    let answer = apply(function, &JsValue::UNDEFINED, &Array::of1(&list(x))).map_err(Refused::Theirs)?;
    answer.ok_or_else(|| Error::new(Code::Type, name, "is null or undefined: the function must answer").into())
}

pub(crate) fn called(function: &Function, x: &[f64], name: &'static str) -> Result<Vec<f64>, Refused> {
    Ok(Arg::new(&answer(function, x, name)?, name).short()?)
}

pub(crate) fn slope(function: &Function, x: &[f64], name: &'static str) -> Result<DMatrix<f64>, Refused> {
    Ok(Arg::new(&answer(function, x, name)?, name).matrix()?)
}

fn shown(Gated { accepted, judged }: &Gated) -> JsValue {
    record(&[
        ("outcome", if *accepted { "accepted" } else { "rejected" }.into()),
        ("innovation", list(judged.innovation.as_slice())),
        ("S", rows(&judged.s)),
        ("chi2", number_or_null(judged.chi2)),
    ])
}
