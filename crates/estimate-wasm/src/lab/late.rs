//! What some labs can do beside the rest.

use super::{LateReadings, ObservabilityProbe, Tune};
use crate::decode::Arg;
use crate::encode::list;
use crate::errors::Thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export interface Tune {
    /**
     * One row of a map of the log-likelihood over all noise levels that the filter can take: `columns` values of `logQ`
     * at one of `rows` values of `logW`, each at the middle of its cell. Row 0 has the least W; `rows` and `columns`
     * are at most 200. It depends on the seed and the length of the log alone.
     */
    likelihoodRow(row: number, rows: number, columns: number): Vector;
}
export interface LateReadings {
    /**
     * What each way costs over `count` seeds, at most 500, from `first` on: for each seed the RMS error in metres and
     * the mean NEES as new, dropped, and gone back, six numbers. The run's own seed and way do not count.
     */
    seeds(first: number, count: number): Vector;
}
export interface ObservabilityProbe {
    /** Where landmark `j` (from 0) must stand to be in line with the estimate and the nearest other landmark shown. */
    collinearPoint(j: number): Vector;
}
"#;

#[wasm_bindgen]
impl Tune {
    /// One row of the map, as its type says.
    #[wasm_bindgen(js_name = likelihoodRow)]
    pub fn likelihood_row(&self, row: &JsValue, rows: &JsValue, columns: &JsValue) -> Result<JsValue, Thrown> {
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

#[wasm_bindgen]
impl ObservabilityProbe {
    /// A point in line with two others, as its type says.
    #[wasm_bindgen(js_name = collinearPoint)]
    pub fn collinear_point(&self, j: &JsValue) -> Result<JsValue, Thrown> {
        self.0.is(Self::CLASS.name)?;
        let j = Arg::new(j, "j").whole(0, 2)?;
        let point = Self::CLASS.lab(&self.0, |probe: &labs::ObservabilityProbe| probe.collinear_point(j))?;
        Ok(list(&point))
    }
}

#[wasm_bindgen]
impl LateReadings {
    /// The costs of some seeds, as its type says.
    pub fn seeds(&self, first: &JsValue, count: &JsValue) -> Result<JsValue, Thrown> {
        self.0.is(Self::CLASS.name)?;
        let first = Arg::new(first, "first").whole(0, u32::MAX)?;
        let count = Arg::new(count, "count").whole(1, labs::ensemble::SEEDS)?;
        let costs = Self::CLASS.lab(&self.0, |lab: &labs::LateReadings| lab.seeds(first, count))?;
        Ok(list(&costs))
    }
}
