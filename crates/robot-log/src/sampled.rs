//! Whether rates were read in equal steps: then the robot changed them on the way from row to row, and the mean of two
//! rows leads from one to the other. What is written only when it changes is held until the next row instead.

use crate::way::Way;
use estimate::drive::{Drive, Event, Motion};

/// Steps are equal within this part of their median, of which they may be once, twice or three times as long: now and
/// then a row is lost. Rows at one time are one.
const WITHIN: f64 = 0.35;
const LOST: i32 = 3;
/// At least this part of the steps is equal so, and they are at least this part of the time.
const PART: f64 = 0.85;
const TIME: f64 = 0.5;

/// What is said where they were not.
const HELD: &str = "The rows of the motion come at uneven times, as those of a log that writes what changes do: each \
                    speed and turn rate is held until the next.";

/// Whether the rows of a rate come in equal steps.
fn is_sampled(drive: &Drive, of: fn(&Event) -> bool) -> bool {
    let times: Vec<f64> = drive.rows.iter().filter(|row| of(&row.event)).map(|row| row.time).collect();
    let mut steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0).collect();
    steps.sort_by(f64::total_cmp);
    let Some(median) = steps.get(steps.len() / 2) else { return true };
    let equal = |step: &&f64| (1..=LOST).any(|times| (**step - f64::from(times) * median).abs() < WITHIN * median);
    let (count, time) = steps.iter().filter(equal).fold((0, 0.0), |(count, time), step| (count + 1, time + step));
    f64::from(count) >= PART * steps.len() as f64 && time >= TIME * steps.iter().sum::<f64>()
}

/// Has the rates of a drive change from row to row if they were read in equal steps, a mean over a step from its middle
/// on; else they are held, and that is said.
pub(crate) fn changed(drive: &mut Drive, way: &Way) -> Option<String> {
    if drive.motion != Motion::Velocity {
        return None;
    }
    let even = [Event::has_speed, Event::has_turn_rate].into_iter().all(|of| is_sampled(drive, of));
    if even {
        drive.motion = Motion::EvenVelocity;
        way.to_the_middle(&mut drive.rows);
    }
    (!even).then(|| HELD.into())
}
