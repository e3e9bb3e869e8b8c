//! Whether rates were read in equal steps: then the robot changed them on the way from row to row, and the mean of two
//! rows leads from one to the other. What is written only when it changes is held until the next row instead.

use estimate::drive::{Drive, Event, Motion};

/// At least this part of the steps is within so many times their median, either way. Rows at one time are one.
const PART: f64 = 0.9;
const TIMES: f64 = 2.5;

/// What is said where they were not.
const HELD: &str = "The rows of the motion come at uneven times, as those of a log that writes what changes do: each \
                    speed and turn rate is held until the next.";

/// Whether the rows of a rate come in equal steps.
fn is_sampled(drive: &Drive, of: fn(&Event) -> bool) -> bool {
    let times: Vec<f64> = drive.rows.iter().filter(|row| of(&row.event)).map(|row| row.time).collect();
    let mut steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0).collect();
    steps.sort_by(f64::total_cmp);
    let Some(median) = steps.get(steps.len() / 2) else { return true };
    let [short, long] = [median / TIMES, median * TIMES].map(|end| steps.partition_point(|step| *step < end));
    (long - short) as f64 >= PART * steps.len() as f64
}

/// Has the rates of a drive change from row to row if they were read in equal steps; else they are held, and that is
/// said.
pub(crate) fn changed(drive: &mut Drive) -> Option<String> {
    if drive.motion != Motion::Velocity {
        return None;
    }
    let even = [Event::has_speed, Event::has_turn_rate].into_iter().all(|of| is_sampled(drive, of));
    if even {
        drive.motion = Motion::EvenVelocity;
    }
    (!even).then(|| HELD.into())
}
