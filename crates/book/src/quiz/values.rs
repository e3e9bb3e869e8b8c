//! Answers that are numbers: one, or the entries of a vector.

use serde_json::json;

use super::{Answer, Kind, RawNear, Reader};
use crate::config::Text;
use crate::number::Format;

/// A right number or vector, and how it is compared with a reader's.
#[derive(Clone, Debug)]
pub struct Values {
    /// Ids of the right numbers: one, or one for each entry.
    pub ids: Vec<String>,
    /// Their values.
    pub right: Vec<f64>,
    /// How far off an entry may be; of the unit vector if `direction`.
    pub tolerance: f64,
    /// The least and the greatest number that is right, where it is not the tolerance that says so.
    pub bounds: Option<[f64; 2]>,
    /// Whether sign and length do not matter.
    pub direction: bool,
    /// How an entry is printed.
    pub format: Format,
    /// Its unit.
    pub unit: String,
    /// Wrong answers worth recognising, tried in order.
    pub near: Vec<Near>,
}

/// A wrong answer with its reason.
#[derive(Clone, Debug)]
pub struct Near {
    /// The wrong value, entry by entry.
    pub value: Vec<f64>,
    /// Why it is wrong, in Markdown.
    pub why: Text,
}

impl Values {
    pub(super) fn key(&self) -> serde_json::Value {
        let near: Vec<_> = self.near.iter().map(|near| &near.value).collect();
        let Self { right, unit, tolerance, direction, .. } = self;
        let mut key =
            json!({ "values": right, "unit": unit, "tolerance": tolerance, "direction": direction, "near": near });
        if let Some(bounds) = self.bounds {
            key["bounds"] = json!(bounds);
        }
        key
    }

    /// What a reader is asked and told.
    pub(super) fn parts(&self) -> Vec<String> {
        let mut parts = vec![self.print(&self.right), self.tolerance.to_string(), self.unit.clone()];
        parts.extend(self.bounds.map(|bounds| format!("{bounds:?}")));
        parts.extend(self.direction.then(|| "direction".to_string()));
        parts.extend(self.near.iter().flat_map(|near| [self.print(&near.value), near.why.markdown.clone()]));
        parts
    }

    /// A number as it is, a vector in brackets.
    pub fn print(&self, value: &[f64]) -> String {
        let entries: Vec<_> = value.iter().map(|&entry| self.format.html(entry).unwrap_or_default()).collect();
        if entries.len() == 1 { entries.concat() } else { format!("[{}]", entries.join(", ")) }
    }

    /// Whether the page would take it for right.
    fn takes(&self, value: &[f64]) -> bool {
        match (self.bounds, value) {
            (Some([least, most]), [one]) => (least..=most).contains(one),
            _ => self.gap(value) <= self.tolerance,
        }
    }

    /// The largest distance between entries; of unit vectors, with the better sign, if only the direction counts.
    fn gap(&self, value: &[f64]) -> f64 {
        let length = |v: &[f64]| if self.direction { v.iter().map(|x| x * x).sum::<f64>().sqrt() } else { 1.0 };
        let (a, b) = (length(value), length(&self.right));
        let gap =
            |sign: f64| value.iter().zip(&self.right).map(|(x, y)| (sign * x / a - y / b).abs()).fold(0.0, f64::max);
        if self.direction { gap(1.0).min(gap(-1.0)) } else { gap(1.0) }
    }
}

impl Reader<'_> {
    pub(super) fn values(&self) -> Result<Answer, String> {
        let raw = self.asked;
        let vector = raw.kind == Kind::Vector;
        self.only(if vector {
            &["answer", "tolerance", "near", "direction"]
        } else {
            &["answer", "tolerance", "near", "least", "most"]
        })?;
        let ids = raw.answer.as_ref().ok_or("the answer is missing: the id of a number")?;
        let ids: Vec<_> = ids.split(',').map(|id| id.trim().to_string()).collect();
        if vector != (ids.len() > 1) {
            return Err(format!("{} entries; a number has one, a vector more", ids.len()));
        }
        let right = ids.iter().map(|id| Ok(self.numbers.get(id)?.value)).collect::<Result<Vec<_>, String>>()?;
        if raw.direction && right.iter().all(|&entry| entry == 0.0) {
            return Err("a vector of zeros has no direction".into());
        }
        let bounds = match (&raw.least, &raw.most) {
            (Some(least), Some(most)) => Some([self.value(least)?, self.value(most)?]),
            (None, None) => None,
            _ => return Err("`least` and `most` go together".into()),
        };
        let tolerance = raw.tolerance.filter(|&tolerance| tolerance > 0.0).ok_or("a positive tolerance is missing")?;
        let format = Format::parse(raw.format.as_deref().unwrap_or(".3f"))?;
        let (unit, direction) = (raw.unit.clone(), raw.direction);
        let mut values = Values { ids, right, tolerance, bounds, direction, format, unit, near: Vec::new() };
        // A reader who copies what the page prints has to be right.
        let printed = values.right.iter().map(|&entry| Ok(format.html(entry)?.replace('\u{2212}', "-")));
        let printed: Vec<f64> = printed.collect::<Result<Vec<_>, String>>()?.iter().flat_map(|it| it.parse()).collect();
        if printed.len() == values.right.len() && !values.takes(&printed) {
            return Err(format!(
                "the answer as it is printed, {}, misses by more than the tolerance",
                values.print(&printed)
            ));
        }
        values.near = raw.near.iter().filter_map(|raw| self.near(raw, &values)).collect();
        Ok(Answer::Values(values))
    }

    fn near(&self, RawNear { value: text, why }: &RawNear, values: &Values) -> Option<Near> {
        self.needs_reason(text, why);
        let value = text.markdown.split(',').map(|id| self.value(id.trim())).collect::<Result<Vec<f64>, _>>();
        let value = self.diagnostics.ok(&text.place, value)?;
        let report = |what: &str| self.diagnostics.report(&text.place, format!("`{}` {what}", text.markdown));
        if value.len() != values.right.len() {
            report("has not as many entries as the answer");
        } else if values.takes(&value) {
            report("is wrong by no more than the tolerance: a right answer");
        }
        Some(Near { value, why: why.clone() })
    }

    /// A value as it stands, or the computed number of this id.
    pub(super) fn value(&self, text: &str) -> Result<f64, String> {
        text.parse().or_else(|_| self.numbers.get(text).map(|number| number.value))
    }
}
