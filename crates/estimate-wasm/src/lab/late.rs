//! The classes of the labs whose figures stand late in the chapter.

use crate::decode::Arg;
use crate::encode::list;
use crate::errors::Thrown;
use wasm_bindgen::prelude::*;

lab_class! {
    "Range–bearing SLAM around the corridor with a sensor of short reach: a loop that is closed, with or without cross-covariances.",
    LoopClosure: labs::LoopClosure, "Partial<LoopParams>", "LoopFrame", "LabState<LoopParams>"
}

lab_class! {
    "A log of the rail robot whose noise levels are hidden, and a filter whose noise levels the reader chooses. It has no steps.",
    Tune: labs::Tune, "Partial<TuneParams>", "TuneFrame", "LabState<TuneParams>"
}

#[wasm_bindgen]
impl Tune {
    /// One row of a map of the log-likelihood over all noise levels that the filter can take: `columns` values of `logQ` at one
    /// of `rows` values of `logW`, each at the middle of its cell. Row 0 has the least W; `rows` and `columns` are at most 200.
    /// It depends on the seed and the length of the log alone.
    #[wasm_bindgen(js_name = likelihoodRow, unchecked_return_type = "Vector")]
    pub fn likelihood_row(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] row: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] rows: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] columns: &JsValue,
    ) -> Result<JsValue, Thrown> {
        self.0.is(Self::CLASS.name)?;
        let whole = |value, name, least, most| Arg::new(value, name).whole(least, most);
        let most = labs::MAX_MAP_SIZE as u32;
        let (rows, columns) = (whole(rows, "rows", 1, most)?, whole(columns, "columns", 1, most)?);
        let row = whole(row, "row", 0, rows - 1)?;
        let [row, rows, columns] = [row, rows, columns].map(|number| number as usize);
        let values = Self::CLASS.lab(&self.0, |tune: &labs::Tune| tune.likelihood_row(row, rows, columns))?;
        Ok(list(&values))
    }
}

lab_class! {
    "A filter with a bug in it, chosen or drawn by lot, beside what a right filter's panels show.",
    BugMuseum: labs::BugMuseum, "Partial<MuseumParams>", "MuseumFrame", "LabState<MuseumParams>"
}

lab_class! {
    "Rusty on a square in room A: which landmarks does it take to know where it is?",
    ObservabilityProbe: labs::ObservabilityProbe, "Partial<ProbeParams>", "ProbeFrame", "LabState<ProbeParams>"
}

#[wasm_bindgen]
impl ObservabilityProbe {
    /// Where landmark `j` (from 0) must stand to be in line with the estimate and the nearest other landmark shown.
    #[wasm_bindgen(js_name = collinearPoint, unchecked_return_type = "Vector")]
    pub fn collinear_point(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] j: &JsValue,
    ) -> Result<JsValue, Thrown> {
        self.0.is(Self::CLASS.name)?;
        let j = Arg::new(j, "j").whole(0, 2)?;
        let point = Self::CLASS.lab(&self.0, |probe: &labs::ObservabilityProbe| probe.collinear_point(j))?;
        Ok(list(&point))
    }
}
