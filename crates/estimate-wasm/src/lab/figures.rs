//! The classes of the labs with simulated robots.

use crate::decode::Arg;
use crate::errors::thrown;
use wasm_bindgen::prelude::*;

lab_class! {
    "The rail robot of §8.2.6 under an observer whose gain the reader sets, or the filter does.",
    ObserverBench: labs::ObserverBench, "Partial<BenchParams>", "BenchFrame", "LabState<BenchParams>"
}

lab_class! {
    "A loop of the corridor on encoders with a biased wheel, with or without fixes from the mapped corners.",
    OdometryHook: labs::OdometryHook, "Partial<HookParams>", "HookFrame", "LabState<HookParams>"
}

lab_class! {
    "Rusty on a square in room A: which landmarks does it take to know where it is?",
    ObservabilityProbe: labs::ObservabilityProbe, "Partial<ProbeParams>", "ProbeFrame", "LabState<ProbeParams>"
}

lab_class! {
    "A prediction, the states that explain a reading, and the two ways of stepping onto them.",
    Picture: labs::Picture, "Partial<PictureParams>", "PictureFrame", "LabState<PictureParams>"
}

#[wasm_bindgen]
impl ObservabilityProbe {
    /// Where landmark `j` (from 0) must stand to be in line with the estimate and the nearest other landmark shown.
    #[wasm_bindgen(js_name = collinearPoint, unchecked_return_type = "Vector")]
    pub fn collinear_point(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] j: &JsValue,
    ) -> Result<JsValue, JsValue> {
        self.0.is(Self::CLASS.name)?;
        let j = Arg::new(j, "j").whole(0, 2).map_err(thrown)?;
        let point = Self::CLASS.lab(&self.0, |probe: &labs::ObservabilityProbe| probe.collinear_point(j))?;
        Ok(crate::encode::list(&point))
    }
}
