//! How many times what is there a sensor reads, and the units that make it so.

use crate::drive::fitted::Fitted;
use crate::drive::suspect::Suspect;

/// A factor this near to that between two units asks for them: wheels and clocks have errors of their own beside it.
const NEAR: f64 = 0.02;
/// Units that are taken for one another, and how many of the first make one of the second.
const SPEEDS: [([&str; 2], f64); 6] = [
    (["km/h", "m/s"], 3.6),
    (["mph", "m/s"], 3.6 / 1.609_344),
    (["kn", "m/s"], 3.6 / 1.852),
    (["ft/s", "m/s"], 1.0 / 0.3048),
    (["km/h", "mph"], 1.609_344),
    (["km/h", "kn"], 1.852),
];
const LENGTHS: [([&str; 2], f64); 1] = [(["ft", "m"], 1.0 / 0.3048)];

/// How many times what is there is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// Where the readings are likeliest.
    pub value: f64,
    /// Its standard deviation; infinite where the readings do not tell it.
    pub sigma: f64,
    /// What the filter takes it for as it is set.
    pub set: f64,
    /// The unit that it may be in, and the one in which it is then taken.
    pub unit: Option<[&'static str; 2]>,
}

impl Suspect {
    /// How many times too much is read, of a suspect that is a scale. The settings have of ranges what is read beyond
    /// one, and of the speed what is driven beyond one for each that is read: the inverse.
    pub fn times(&self) -> Option<Times> {
        let size = self.sizes.first()?;
        let (now, value) = (1.0 + size.now, 1.0 + size.value);
        let (times, units): (_, &[_]) = match self.number? {
            Fitted::Scale => (Times { value, sigma: size.sigma, set: now, unit: None }, &LENGTHS),
            Fitted::SpeedScale => {
                let sigma = size.sigma / (value * value);
                (Times { value: 1.0 / value, sigma, set: 1.0 / now, unit: None }, &SPEEDS)
            }
            _ => return None,
        };
        let near = |ratio: f64| (times.value / ratio - 1.0).abs() < NEAR && !size.end;
        let unit = units.iter().find_map(|&([is, taken], ratio)| match (near(ratio), near(1.0 / ratio)) {
            (true, _) => Some([is, taken]),
            (_, true) => Some([taken, is]),
            _ => None,
        });
        Some(Times { unit, ..times })
    }
}
