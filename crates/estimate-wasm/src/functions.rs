//! The linear functions: decode, call, encode.

use crate::arguments::{belief_of, continuous_of, number_or, shown_belief, system_of};
use crate::decode::{Arg, Outputs};
use crate::encode::{Arrays, list, number_or_null, record, rows, shown};
use crate::errors::Thrown;
use estimate::dynamic::{self, Discrete, Replayed};
use estimate::validate::{MAX_INPUTS, MAX_OUTPUTS};
use estimate::{Error, kf};
use js_sys::{Array, Float64Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("functions.d.ts");

/// They are among the labs' types, where there are labs.
#[cfg(not(feature = "labs"))]
#[wasm_bindgen(typescript_custom_section)]
const TYPES_OF_THE_CORE: &str = lab::written(&[&[lab::OF_THE_CORE]]).as_str();

/// One Kalman step (eqs. 8.26–8.32): predict with the input `u`, correct with the reading `y`.
#[wasm_bindgen(js_name = kalmanStep, unchecked_return_type = "KalmanStep")]
pub fn kalman_step(
    #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem")] system: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] u: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] y: &JsValue,
) -> Result<JsValue, Thrown> {
    let (system, belief) = (system_of(system)?, belief_of(&Arg::new(belief, "belief"))?);
    let (u, y) = (Arg::new(u, "u").vector()?, Arg::new(y, "y").vector()?);
    let step = kf::kalman_step(&system, &belief, &u, &y)?;
    let conditioned = step.conditioned(&system, &belief);
    let kf::KalmanStep { predicted, innovation, s, r, posterior, .. } = step;
    let answer = record(&[("predicted", shown_belief(&predicted)), ("conditioned", conditioned.into())]);
    Arrays::default()
        .vector(innovation.as_slice())
        .matrix(&s)
        .matrix(&r)
        .vector(posterior.x.as_slice())
        .matrix(&posterior.p)
        .put(&answer, &["innovation", "S", "R", "x", "P"]);
    Ok(answer)
}

/// A `kalmanStep` for each row of a log of at most 100 000 steps (of a large system as many as keep steps · (n + p)³
/// within 138 240 000, which is 10 000 at 16 states and 8 outputs), in one call where thousands would cross over one by
/// one. `inputs` holds u of every step row by row, `readings` y. A log with gaps has an array of at most 10 000 rows
/// for `readings`, of which some are null, or have parts that are. Refused at one step, the log is refused.
#[wasm_bindgen(js_name = kalmanReplay, unchecked_return_type = "KalmanReplay")]
pub fn kalman_replay(
    #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem")] system: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Float64Array")] inputs: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Float64Array | (PartialVector | Float64Array | null)[]")] readings: &JsValue,
) -> Result<JsValue, Thrown> {
    let (system, belief) = (system_of(system)?, belief_of(&Arg::new(belief, "belief"))?);
    let most = |each: usize| (dynamic::MAX_LOG * each) as u32;
    let inputs = Arg::new(inputs, "inputs").floats(most(MAX_INPUTS))?;
    let readings = Arg::new(readings, "readings");
    let replayed = match readings.array()? {
        true => dynamic::kalman_replay_partly(&system, &belief, &inputs, &with_gaps(&readings, system.h.nrows())?)?,
        false => dynamic::kalman_replay(&system, &belief, &inputs, &readings.floats(most(MAX_OUTPUTS))?)?,
    };
    let Replayed { x, variances, p, conditioned, log_likelihood } = replayed;
    let floats = |numbers: &[f64]| Float64Array::from(numbers).into();
    Ok(record(&[
        ("x", floats(&x)),
        ("variances", floats(&variances)),
        ("P", rows(&p)),
        ("conditioned", conditioned.into()),
        ("logLikelihood", number_or_null(log_likelihood)),
    ]))
}

/// The best track afterwards (Rauch, Tung and Striebel): the belief after each row of a log in the light of all its
/// readings. `us` and `ys` hold an input and a reading for each row; a reading that is null, or has parts that are, was
/// not made, or not whole. A system without inputs may have an empty `us`. From the last row with a reading on, the
/// answer is the filter's. At most 10 000 rows (of a large system fewer, as in `kalmanReplay`), and n² + n numbers of
/// memory for each.
#[wasm_bindgen(js_name = kalmanSmooth, unchecked_return_type = "Belief[]")]
pub fn kalman_smooth(
    #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem")] system: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "(Vector | Float64Array)[]")] us: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "(PartialVector | Float64Array | null)[]")] ys: &JsValue,
) -> Result<JsValue, Thrown> {
    let (system, belief) = (system_of(system)?, belief_of(&Arg::new(belief, "belief"))?);
    let inputs = Arg::new(us, "us").entries()?.iter().map(Arg::short).collect::<Result<Vec<_>, Error>>()?;
    let readings = with_gaps(&Arg::new(ys, "ys"), system.h.nrows())?;
    let track = dynamic::kalman_smooth(&system, &belief, &inputs, &readings)?;
    Ok(track.iter().map(shown_belief).collect::<Array>().into())
}

/// The readings of `p` outputs, row by row; one that is null has no part.
fn with_gaps(rows: &Arg<'_>, p: usize) -> Result<Vec<Vec<Option<f64>>>, Error> {
    let row = |y: &Arg<'_>| if y.is_null() { Ok(vec![None; p]) } else { y.reading().map(Outputs::parts) };
    rows.entries()?.iter().map(row).collect()
}

/// What a system in continuous time, x' = A x + B u + noise of density Q, is over `dt` seconds, zero or more:
/// F = e^{A dt}, G = ∫ e^{As} B ds, V = ∫ e^{As} Q e^{Aᵀs} ds. At most 16 states and 8 inputs.
#[wasm_bindgen(unchecked_return_type = "DiscreteSystem")]
pub fn discretize(
    #[wasm_bindgen(unchecked_param_type = "ContinuousSystem")] system: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "number")] dt: &JsValue,
) -> Result<JsValue, Thrown> {
    let Discrete { f, g, v } = continuous_of(system)?.discretize(Arg::new(dt, "dt").number()?)?;
    let answer = record(&[]);
    Arrays::default().matrix(&f).matrix(&g).matrix(&v).put(&answer, &["F", "G", "V"]);
    Ok(answer)
}

/// One step of the observer with the fixed gain `K`: F x + G u + K (y − H (F x + G u)).
#[wasm_bindgen(js_name = observerStep, unchecked_return_type = "Vector")]
pub fn observer_step(
    #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem")] system: &JsValue,
    #[wasm_bindgen(js_name = K, unchecked_param_type = "Rows")] k: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] x: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] u: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] y: &JsValue,
) -> Result<JsValue, Thrown> {
    let (k, x) = (Arg::new(k, "K").matrix()?, Arg::new(x, "x").vector()?);
    let (system, u, y) = (system_of(system)?, Arg::new(u, "u").vector()?, Arg::new(y, "y").vector()?);
    Ok(list(dynamic::observer_step(&system, k, x, u, y)?.as_slice()))
}

/// The eigenvalues of (I − KH)F, by decreasing modulus, then decreasing imaginary part.
#[wasm_bindgen(js_name = errorEigenvalues, unchecked_return_type = "Complex[]")]
pub fn error_eigenvalues(
    #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem")] system: &JsValue,
    #[wasm_bindgen(js_name = K, unchecked_param_type = "Rows")] k: &JsValue,
) -> Result<JsValue, Thrown> {
    Ok(shown(&dynamic::error_eigenvalues(&system_of(system)?, Arg::new(k, "K").matrix()?)?))
}

/// The observability rank of (F, H) under a tolerance relative to the largest singular value (1e-9 when left out); at
/// most 16 states and 8 outputs.
#[wasm_bindgen(unchecked_return_type = "Observability")]
pub fn observability(
    #[wasm_bindgen(js_name = F, unchecked_param_type = "Rows")] f: &JsValue,
    #[wasm_bindgen(js_name = H, unchecked_param_type = "Rows")] h: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] tolerance: &JsValue,
) -> Result<JsValue, Thrown> {
    let tolerance = number_or(tolerance, "tolerance", 1e-9)?;
    let seen = dynamic::observability(Arg::new(f, "F").tall()?, Arg::new(h, "H").tall()?, tolerance)?;
    Ok(record(&[
        ("rank", seen.rank.into()),
        ("n", seen.n.into()),
        ("singularValues", list(&seen.singular_values)),
        ("nullspace", seen.nullspace.iter().map(|v| list(v.as_slice())).collect::<Array>().into()),
    ]))
}

/// The limit of the gain from P(0 | 0) = `P0`, by doubling the number of steps. With `maxIterations`, or a tolerance,
/// what so many single steps come to: at most 100 000 (of a large system fewer, as in `kalmanReplay`), tolerance 1e-12
/// when left out. Running out of iterations is an answer. The package's entry `filters` takes single steps alone,
/// 10 000 of them when nothing is said.
#[wasm_bindgen(js_name = steadyStateGain, unchecked_return_type = "SteadyState")]
pub fn steady_state_gain(
    #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem")] system: &JsValue,
    #[wasm_bindgen(js_name = P0, unchecked_param_type = "Rows")] p0: &JsValue,
    #[wasm_bindgen(js_name = maxIterations, unchecked_optional_param_type = "number")] max_iterations: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] tolerance: &JsValue,
) -> Result<JsValue, Thrown> {
    let a = Arg::new(max_iterations, "maxIterations");
    // A tenth of the weight of the entry without labs, which goes without.
    #[cfg(feature = "analysis")]
    if a.is_undefined() && tolerance.is_undefined() {
        let limit = dynamic::steady_state(&system_of(system)?, Arg::new(p0, "P0").matrix()?)?;
        return Ok(record(&[
            ("R", rows(&limit.r)),
            ("P", rows(&limit.p)),
            ("converged", limit.converged.into()),
            ("gainConverged", limit.gain_converged.into()),
            ("iterations", limit.steps.into()),
            ("dependsOnStart", limit.depends_on_start.into()),
        ]));
    }
    let iterations = if a.is_undefined() { 10_000 } else { a.whole(1, estimate::riccati::MAX_ITERATIONS as u32)? };
    let tolerance = number_or(tolerance, "tolerance", 1e-12)?;
    let (system, p0) = (system_of(system)?, Arg::new(p0, "P0").matrix()?);
    let limit = dynamic::steady_state_gain(&system, p0, iterations as usize, tolerance)?;
    Ok(record(&[
        ("R", rows(&limit.r)),
        ("P", rows(&limit.p)),
        ("converged", limit.converged.into()),
        ("gainConverged", limit.gain_converged.into()),
        ("iterations", limit.iterations.into()),
    ]))
}

/// R(1), …, R(steps) from P(0 | 0) = `P0`; at most 10 000 steps.
#[wasm_bindgen(js_name = gainSchedule, unchecked_return_type = "Matrix[]")]
pub fn gain_schedule(
    #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem")] system: &JsValue,
    #[wasm_bindgen(js_name = P0, unchecked_param_type = "Rows")] p0: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "number")] steps: &JsValue,
) -> Result<JsValue, Thrown> {
    let steps = Arg::new(steps, "steps").whole(1, estimate::riccati::MAX_STEPS as u32)?;
    let gains = dynamic::gain_schedule(&system_of(system)?, Arg::new(p0, "P0").matrix()?, steps as usize)?;
    Ok(gains.iter().map(rows).collect::<Array>().into())
}

/// The ellipse {x : xᵀP⁻¹x = radius²} of a 2×2 covariance; the radius is 1 when left out.
#[wasm_bindgen(js_name = covarianceEllipse, unchecked_return_type = "Ellipse")]
pub fn covariance_ellipse(
    #[wasm_bindgen(js_name = P, unchecked_param_type = "Rows")] p: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] radius: &JsValue,
) -> Result<JsValue, Thrown> {
    Ok(shown(&dynamic::covariance_ellipse(Arg::new(p, "P").matrix()?, number_or(radius, "radius", 1.0)?)?))
}

/// The point of Ω = {x : Hx = y} nearest to `x` in the Euclidean metric; at most 16 states and 8 outputs.
#[wasm_bindgen(js_name = euclideanFoot, unchecked_return_type = "Vector")]
pub fn euclidean_foot(
    #[wasm_bindgen(js_name = H, unchecked_param_type = "Rows")] h: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] x: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] y: &JsValue,
) -> Result<JsValue, Thrown> {
    let (h, x, y) = (Arg::new(h, "H").tall()?, Arg::new(x, "x").vector()?, Arg::new(y, "y").vector()?);
    Ok(list(dynamic::euclidean_foot(h, x, y)?.as_slice()))
}

/// The point of Ω = {x : Hx = y} nearest to `x` in the Mahalanobis metric of `P`; at most 16 states and 8 outputs.
#[wasm_bindgen(js_name = mahalanobisFoot, unchecked_return_type = "Vector")]
pub fn mahalanobis_foot(
    #[wasm_bindgen(js_name = H, unchecked_param_type = "Rows")] h: &JsValue,
    #[wasm_bindgen(js_name = P, unchecked_param_type = "Rows")] p: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] x: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] y: &JsValue,
) -> Result<JsValue, Thrown> {
    let (h, p) = (Arg::new(h, "H").tall()?, Arg::new(p, "P").matrix()?);
    Ok(list(dynamic::mahalanobis_foot(h, p, Arg::new(x, "x").vector()?, Arg::new(y, "y").vector()?)?.as_slice()))
}

/// y*, the most likely output: where the product of N(Hx, HPHᵀ) and N(y, W) peaks (Theorem 8.2.1); at most 16
/// states and 8 outputs.
#[wasm_bindgen(js_name = mostLikelyOutput, unchecked_return_type = "Vector")]
pub fn most_likely_output(
    #[wasm_bindgen(js_name = H, unchecked_param_type = "Rows")] h: &JsValue,
    #[wasm_bindgen(js_name = P, unchecked_param_type = "Rows")] p: &JsValue,
    #[wasm_bindgen(js_name = W, unchecked_param_type = "Rows")] w: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] x: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] y: &JsValue,
) -> Result<JsValue, Thrown> {
    let (h, p, w) = (Arg::new(h, "H").tall()?, Arg::new(p, "P").matrix()?, Arg::new(w, "W").matrix()?);
    let (x, y) = (Arg::new(x, "x").vector()?, Arg::new(y, "y").vector()?);
    Ok(list(dynamic::most_likely_output(h, p, w, x, y)?.as_slice()))
}
