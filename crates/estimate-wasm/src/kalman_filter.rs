//! The linear Kalman filter's class, for programs that filter as they read.

use crate::arguments::{belief_of, step_of, system_of};
use crate::decode::{Arg, Outputs};
use crate::encode::{list, number_or_null, rows};
use crate::errors::Thrown;
use crate::object::Held;
use estimate::Error;
use estimate::dynamic::{KalmanFilter as Filter, LastReading};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("kalman_filter.d.ts");

/// A Kalman filter that holds its system and its belief: x(k+1) = F x(k) + G u(k) + v, y(k) = H x(k) + w, with Cov v =
/// V and Cov w = W. An input or a reading is an array of numbers or a Float64Array.
#[wasm_bindgen]
#[repr(transparent)]
pub struct KalmanFilter(pub(crate) Held);

pub(crate) const CLASS: &str = "KalmanFilter";

#[wasm_bindgen]
impl KalmanFilter {
    /// The filter of `system` with the belief before the first step.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "System | FilterpySystem")] system: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "GivenBelief")] belief: &JsValue,
    ) -> Result<KalmanFilter, Thrown> {
        let filter = Filter::new(&system_of(system)?, &belief_of(&Arg::new(belief, "belief"))?)?;
        Ok(Self(Held::new(CLASS, filter)))
    }

    /// x = F x + G u, P = F P Fᵀ + V. A system without inputs needs no `u`. A `step` has the F, G and V of this call,
    /// as `discretize` gives them for the time since the last: rows of a log need not lie equally far apart.
    pub fn predict(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "Vector | Float64Array")] u: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "GivenStep")] step: &JsValue,
    ) -> Result<(), Thrown> {
        let u = if u.is_undefined() { Vec::new() } else { Arg::new(u, "u").short()? };
        if step.is_undefined() {
            return self.0.write(CLASS, |filter: &mut Filter| filter.predict(&u));
        }
        let step = step_of(&Arg::new(step, "step"))?;
        let blame = |e: Error| e.part_of("step", &["F", "G", "V"]);
        self.0.write(CLASS, |filter: &mut Filter| filter.predict_over(&u, step).map_err(blame))
    }

    /// Corrects the belief by the reading `y`. A part of it that is null was not read: its row of H, and its row and
    /// column of W, are left aside. Where all are null nothing was read, and `nis` is null. A `sensor` has the H and W
    /// of this call, with as many rows as `y` has parts: several sensors may so correct one belief.
    pub fn update(
        &self,
        #[wasm_bindgen(unchecked_param_type = "PartialVector | Float64Array")] y: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "LinearSensor")] sensor: &JsValue,
    ) -> Result<(), Thrown> {
        let y = Arg::new(y, "y").reading()?;
        if !sensor.is_undefined() {
            let sensor = Arg::new(sensor, "sensor");
            sensor.only(["H", "W"].into_iter())?;
            let (h, w) = (sensor.field("H")?.tall()?, sensor.field("W")?.matrix()?);
            let (y, blame) = (y.parts(), |e: Error| e.part_of("sensor", &["H", "W"]));
            return self.0.write(CLASS, |filter: &mut Filter| filter.update_by(&y, h, w).map_err(blame));
        }
        self.0.write(CLASS, |filter: &mut Filter| match &y {
            Outputs::Whole(y) => filter.update(y),
            Outputs::Partial(y) => filter.update_partly(y),
        })
    }

    /// Predicts with `u` and corrects by `y`, both or neither: a `kalmanStep`, to the last bit. Parts of `y` may be
    /// null.
    pub fn step(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Vector | Float64Array")] u: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "PartialVector | Float64Array")] y: &JsValue,
    ) -> Result<(), Thrown> {
        let (u, y) = (Arg::new(u, "u").short()?, Arg::new(y, "y").reading()?);
        self.0.write(CLASS, |filter: &mut Filter| match &y {
            Outputs::Whole(y) => filter.step(&u, y),
            Outputs::Partial(y) => filter.step_partly(&u, y),
        })
    }

    /// The mean.
    #[wasm_bindgen(getter, unchecked_return_type = "Vector")]
    pub fn x(&self) -> Result<JsValue, Thrown> {
        self.read(|filter| list(filter.x()))
    }

    /// The covariance.
    #[wasm_bindgen(getter = P, unchecked_return_type = "Matrix")]
    pub fn p(&self) -> Result<JsValue, Thrown> {
        self.read(|filter| rows(&filter.belief().p))
    }

    /// Whether S, P and x of every step so far are right to 10⁻⁶ of their largest entries; x to that part of the
    /// largest standard deviation where this is more. False once the scales of P, V and W were too far apart for
    /// doubles.
    #[wasm_bindgen(getter)]
    pub fn conditioned(&self) -> Result<bool, Thrown> {
        self.0.read(CLASS, Filter::conditioned)
    }

    /// Σ −½(ln det 2πS + νᵀS⁻¹ν) over all readings; null where they are not `conditioned`, an S was too near to
    /// singular, or the sum is too large for a number.
    #[wasm_bindgen(getter = logLikelihood, unchecked_return_type = "number | null")]
    pub fn log_likelihood(&self) -> Result<JsValue, Thrown> {
        self.read(|filter| number_or_null(filter.log_likelihood()))
    }

    /// The normalized innovation squared νᵀS⁻¹ν of the last reading; null before the first, where all its parts were
    /// null, and where S was too near to singular.
    #[wasm_bindgen(getter, unchecked_return_type = "number | null")]
    pub fn nis(&self) -> Result<JsValue, Thrown> {
        self.read(|filter| number_or_null(filter.nis()))
    }

    /// The innovation y − H x of the last reading, of the parts that were read; null before the first, and where all
    /// its parts were null.
    #[wasm_bindgen(getter, unchecked_return_type = "Vector | null")]
    pub fn innovation(&self) -> Result<JsValue, Thrown> {
        self.of_last(|last| list(last.innovation.as_slice()))
    }

    /// Its covariance H P Hᵀ + W; null as the innovation is.
    #[wasm_bindgen(getter = S, unchecked_return_type = "Matrix | null")]
    pub fn s(&self) -> Result<JsValue, Thrown> {
        self.of_last(|last| rows(&last.s))
    }

    /// The gain P Hᵀ S⁻¹ that corrected the belief (Thrun: K); null as the innovation is.
    #[wasm_bindgen(getter = R, unchecked_return_type = "Matrix | null")]
    pub fn r(&self) -> Result<JsValue, Thrown> {
        self.of_last(|last| rows(&last.r))
    }

    /// A part of what the last reading has told.
    #[inline(never)]
    fn of_last(&self, shown: fn(&LastReading) -> JsValue) -> Result<JsValue, Thrown> {
        self.read(|filter| filter.last().as_ref().map_or(JsValue::NULL, shown))
    }

    fn read(&self, shown: impl FnOnce(&Filter) -> JsValue) -> Result<JsValue, Thrown> {
        self.0.read(CLASS, shown)
    }
}
