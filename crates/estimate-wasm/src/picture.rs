//! The Picture's class.

use crate::decode::Arg;
use crate::lab::{Decoded, lab_class};
use estimate::{Code, Error};
use labs::PictureParams;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export interface PictureParams {
    /** The prediction: m, m/s. */
    mean: Vector;
    /** Half-axes of its ellipse, 0.05 to 10; either may be the longer. */
    semiMajor: number;
    semiMinor: number;
    /** Angle of the first axis, radians. */
    angle: number;
    /** The reading y. */
    reading: number;
    /** Its variance W, 0 to 100. */
    noise: number;
    /** Turn of the sensor, radians: H = [−sin, cos]. */
    tilt: number;
}
/** A step from the prediction onto a line. */
export interface Foot {
    at: Vector;
    /** HΔx − ν */
    residual: number;
    /** ⟨a, Δx⟩ for the unit vector a along the line, in either metric. */
    euclidean: number;
    mahalanobis: number;
    /** ‖Δx‖ in the metric of P, and the equidistant ellipse of that size. */
    distance: number;
    ellipse: Ellipse;
}
export interface PictureFrame {
    step: number;
    params: PictureParams;
    predicted: BenchBelief;
    posterior: BenchBelief;
    H: Vector;
    /** The unit vector along Ω. */
    along: Vector;
    innovation: number;
    S: number;
    R: Vector;
    /** H x and H P Hᵀ: the output that the prediction expects. */
    expectedOutput: number;
    expectedVariance: number;
    mostLikelyOutput: number;
    euclideanFoot: Foot;
    mahalanobisFoot: Foot;
    /** The Mahalanobis foot on Ω*: the Kalman update. */
    update: Foot;
    P: Matrix;
}
"#;

impl Decoded for labs::Picture {
    fn decode(arg: &Arg<'_>, base: PictureParams) -> Result<PictureParams, Error> {
        arg.only(&["mean", "semiMajor", "semiMinor", "angle", "reading", "noise", "tilt"])?;
        let mut params = base;
        let two = |a: &Arg<'_>| {
            let numbers = a.numbers()?;
            numbers.try_into().map_err(|_| Error::new(Code::Shape, "params.mean", "has two entries"))
        };
        arg.given("mean", two, &mut params.mean)?;
        arg.given("semiMajor", |a| a.number(), &mut params.semi_major)?;
        arg.given("semiMinor", |a| a.number(), &mut params.semi_minor)?;
        arg.given("angle", |a| a.number(), &mut params.angle)?;
        arg.given("reading", |a| a.number(), &mut params.reading)?;
        arg.given("noise", |a| a.number(), &mut params.noise)?;
        arg.given("tilt", |a| a.number(), &mut params.tilt)?;
        Ok(params)
    }
}

lab_class! {
    "A prediction, the states that explain a reading, and the two ways of stepping onto them.",
    Picture: labs::Picture, "Partial<PictureParams>", "PictureFrame", "LabState<PictureParams>"
}
