//! The scale on which a figure is drawn: its 95 % band is the middle third, and what lies beyond fits in, however far
//! out.

use super::bands::BANDS;

/// Parts of the scale in which runs are counted.
pub(super) const PARTS: usize = 30;
/// How long the scale is.
const LENGTH: f64 = 3.0;

/// Where a value of figure `i` stands, from 0 to 3: from 1 to 2 within the band. A band's width beyond it is half of
/// the third there, and of what is left each further width takes less. A value that is no number stands at the end.
pub(super) fn place(i: usize, value: f64) -> f64 {
    let [_, low, high, _] = BANDS[i];
    let beyond = |off: f64| if off.is_finite() { off / (off + high - low) } else { 1.0 };
    if value < low {
        1.0 - beyond(low - value)
    } else if value > high || value.is_nan() {
        2.0 + beyond(value - high)
    } else if high > low {
        1.0 + (value - low) / (high - low)
    } else {
        1.5
    }
}

/// The part of the scale in which the value lies.
pub(super) fn part(i: usize, value: f64) -> usize {
    ((place(i, value) * (PARTS as f64 / LENGTH)) as usize).min(PARTS - 1)
}
