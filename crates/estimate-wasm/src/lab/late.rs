//! The classes of the labs whose figures stand late in the chapter.

use crate::decode::Arg;
use crate::encode::list;
use crate::errors::thrown;
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
    ) -> Result<JsValue, JsValue> {
        self.0.is(Self::CLASS.name)?;
        let whole = |value, name, least, most| Arg::new(value, name).whole(least, most).map_err(thrown);
        let most = labs::MAX_MAP_SIZE as u32;
        let (rows, columns) = (whole(rows, "rows", 1, most)?, whole(columns, "columns", 1, most)?);
        let row = whole(row, "row", 0, rows - 1)?;
        let [row, rows, columns] = [row, rows, columns].map(|number| number as usize);
        let values = Self::CLASS.lab(&self.0, |tune: &labs::Tune| tune.likelihood_row(row, rows, columns))?;
        Ok(list(&values))
    }
}
