//! Which column of a file each value of its role is in, and in which unit.

use crate::axes::{axes, third_axis};
use crate::clock::{dated, day_beside, found_fraction, is_seconds, stamped};
use crate::fields::Line;
use crate::heading;
use crate::lists;
use crate::names::{Name, candidates};
use crate::quaternion;
use crate::role::{Quantity, Role, Value};
use crate::row::number;
use crate::sigma;
use crate::source::{Known, Source};
use crate::stamp;
use crate::table::LOOKED_AT;
use crate::true_names::sought;
use crate::unit::{ANGLE_VARIANCE, DATE, QUATERNION, Unit, VARIANCE, named};
use crate::vocabulary::VARIANCES;
use crate::wide;

/// Finds the columns and units of a file's role: by names, or, where no column has a name, in the usual order.
pub(crate) fn columns(source: &mut Source, file: &str, text: &str) {
    let values = source.role.values();
    source.columns = vec![None; values.len()];
    source.units = vec![None; values.len()];
    source.headings = Known::Guessed;
    source.doubts = vec![Vec::new(); values.len()];
    let nameless = source.table.as_ref().is_some_and(|table| table.nameless);
    for (i, value) in values.iter().enumerate() {
        let found = if nameless { Vec::new() } else { found(source, value, file, text) };
        match found.as_slice() {
            [one] => source.columns[i] = Some(*one),
            several => source.doubts[i] = several.to_vec(),
        }
    }
    // A role that a reader has chosen is tried in its usual order where no name says anything.
    let unknown = source.columns.iter().all(Option::is_none) && source.doubts.iter().all(Vec::is_empty);
    let needed = values.iter().filter(|value| !value.optional).count();
    if unknown && source.names.len() >= needed && !matches!(source.role, Role::Sensors | Role::Ranges) {
        for (i, value) in values.iter().enumerate().take(source.names.len()) {
            let kept = !value.optional || matches!(value.name, "bearing" | "x" | "y" | "heading");
            source.columns[i] = kept.then_some(i);
        }
    }
    swap_axes(source, file);
    for i in 0..values.len() {
        source.units[i] = unit(source, i, file, text);
    }
}

/// The columns that a value may be in.
pub(crate) fn found(source: &Source, value: &Value, file: &str, text: &str) -> Vec<usize> {
    let names = &sought(source.role, value.name, &source.names);
    let of = |value: &str, quantity| candidates(value, quantity, names);
    let mut found = of(value.name, value.quantity);
    match value.name {
        "time" => {
            found.retain(|at| !is_seconds(&names[*at]) || found_fraction(names, *at).is_some() || !stamped(names));
            // Beside a counter of milliseconds the time may be that of a clock, its digits in one number.
            let counter = names.iter().position(|name| name.words == ["millis"]);
            found.extend(counter.filter(|at| !found.contains(at)));
            // Beside the clocks of several sensors, the time of the row may be the one that is written as a date.
            if found.len() > 1 {
                let dated = dated(source, text).filter(|at| !found.contains(at));
                found = dated.into_iter().chain(found.iter().copied()).collect();
            }
        }
        "fraction" => {
            let time = source.columns.first().copied().flatten();
            found = time.and_then(|time| found_fraction(names, time)).into_iter().collect();
        }
        "day" => found = day_beside(source, text).into_iter().collect(),
        // An angular velocity is a velocity too.
        "v" => {
            let turns = of("omega", Quantity::AngleRate);
            found.retain(|at| !turns.contains(at));
            // One part of a velocity is not the speed.
            let is_part = |name: &Name, one: &str, axis: &str| name.has(one) || (name.has("vel") && name.has(axis));
            let beside = names.iter().position(|name| is_part(name, "vy", "y") && !name.has("angular"));
            if let ([at], Some(other)) = (found.as_slice(), beside)
                && is_part(&names[*at], "vx", "x")
            {
                found.push(other);
            }
        }
        "omega" if clockwise(names, file) => found.extend(third_axis(names).filter(|_| found.is_empty())),
        "omega" => {
            // The w behind an x, a y and a z is a quaternion's.
            found.retain(|at| quaternion::columns(names, *at).is_none());
            if let Some(axes) = axes(&file.to_lowercase(), names) {
                found = axes;
            }
        }
        "left" | "right" if found.is_empty() => found = wide::of_wheels(names, file).unwrap_or_default(),
        "sigma" => found.retain(|at| sigma::is_of_position(names, *at)),
        "sigma of heading" => found = sigma::of_heading(names, source.column("heading"), found),
        // Beside coordinates a bearing is the course.
        "heading" if found.is_empty() && !of("latitude", Quantity::Coordinate).is_empty() => {
            found = of("bearing", Quantity::Angle);
            // A steering angle is none.
            found.retain(|at| names[*at].has_one(&["bearing", "azimuth", "peilung"]));
        }
        // Where a robot's place is, its orientation is of the same frame; an inertial sensor's own may begin anywhere.
        "heading" if found.is_empty() && !of("x", Quantity::Length).is_empty() => {
            found.extend(quaternion::first(names));
        }
        "first range" => {
            let called = source.called.first().map(|(_, at)| *at);
            let first = called.or_else(|| Some(wide::group(names)?.first()?.1));
            found = first.into_iter().collect();
        }
        // Coordinates say all that metres would, and the axes of a gyroscope are no place.
        "x" | "y" if matches!(source.role, Role::Sensors | Role::Truth) => {
            let global = ["latitude", "longitude"].iter().all(|it| !of(it, Quantity::Coordinate).is_empty());
            if global || axes(&file.to_lowercase(), names).is_some() {
                found.clear();
            }
            // A receiver's place beside the robot's: only the reader knows which is meant.
            let received = |name: &Name| name.has_one(&["gps", "gnss", "rtk"]) && name.has(value.name);
            if let [at] = found.as_slice()
                && names.iter().filter(|name| received(name)).count() == 1
                && !received(&names[*at])
            {
                found.extend(names.iter().position(received));
            }
        }
        _ => {}
    }
    found
}

/// Whether a column is one of the four of a quaternion.
fn is_part(names: &[Name], w: usize, column: usize) -> bool {
    quaternion::columns(names, w).is_some_and(|columns| columns.contains(&column))
}

/// Whether a file's axes point forward, right and down, as those of flight controllers do: PX4 and ArduPilot.
pub(crate) fn clockwise(names: &[Name], file: &str) -> bool {
    let file = file.to_lowercase();
    let px4 = ["vehicle_", "sensor_combined", "sensor_gps", "sensor_gyro", "estimator_"];
    // Others count microseconds as well: a log of ArduPilot has more of its names.
    let called = |words: &[&str]| names.iter().any(|name| name.words == words);
    let ardupilot = called(&["time", "us"]) && (called(&["gyr", "z"]) || called(&["spd"]) || called(&["g", "crs"]));
    let px4 = names.iter().any(|name| name.words == ["timestamp"]) && px4.iter().any(|topic| file.contains(topic));
    ardupilot || px4
}

/// Whether a file is of a motion capture.
fn captured(names: &[Name], file: &str) -> bool {
    const CALLED: [&str; 6] = ["mocap", "motion_capture", "vicon", "optitrack", "qualisys", "motive"];
    let file = file.to_lowercase();
    CALLED.iter().any(|called| file.contains(called)) || names.iter().any(|name| name.has_one(&CALLED))
}

/// In a frame of north, east and down the first axis is north.
fn swap_axes(source: &mut Source, file: &str) {
    if clockwise(&source.names, file)
        && let (Some(x), Some(y)) = (source.role.index("x"), source.role.index("y"))
    {
        source.columns.swap(x, y);
    }
}

/// The unit of a value's column: by its name, else by its numbers; `None` where neither says it.
pub(crate) fn unit(source: &Source, at: usize, file: &str, text: &str) -> Option<&'static Unit> {
    let value = &source.role.values()[at];
    let column = source.columns[at]?;
    let (table, name) = (source.table.as_ref()?, source.names.get(column)?);
    let said = name.unit(value.quantity);
    use Quantity::{Angle, AngleRate, AngleSpread, Heading, Length, SigmaWords, Speed};
    let measured = matches!(value.quantity, Length | SigmaWords | Speed | AngleRate | Angle | AngleSpread | Heading);
    // A unit that stands there and is not known is asked about.
    if table.units && name.has_below() && measured && said.is_none() {
        return None;
    }
    let lines: Vec<Line<'_>> = table.lines(text).filter_map(Result::ok).take(LOOKED_AT).collect();
    let listed = |line: &Line<'_>| lists::parts(line.fields[column].text).iter().filter_map(|it| number(it)).collect();
    let numbers: Vec<f64> = lines.iter().flat_map(|line| -> Vec<f64> { listed(line) }).collect();
    let most = numbers.iter().filter(|number| number.is_finite()).fold(0.0_f64, |most, it| most.max(it.abs()));
    let usual = |name| named(value.quantity, name);
    let down = clockwise(&source.names, file);
    // Far from a full turn at first, a heading may pass it later on; and who stands at first turns then.
    let whole = || table.column(text, column).filter_map(|(_, text)| number(text)).filter(|it| it.is_finite());
    match value.quantity {
        Quantity::Number => None,
        Quantity::Time => {
            let dated = lines.iter().find(|line| !line.fields[column].text.is_empty());
            if dated.is_some_and(|line| stamp::seconds(line.fields[column].text).is_some()) {
                return usual(DATE);
            }
            let said = said.filter(|unit| unit.name != DATE);
            if down && name.words == ["timestamp"] && most > 1e5 && !numbers.iter().any(|it| it.fract() != 0.0) {
                return usual("us");
            }
            said.or_else(|| by_rate(&numbers).and_then(usual))
        }
        // The first of May, or the fifth of January: where both can be meant, it is asked.
        Quantity::Day => match stamp::orders(lines.iter().map(|line| line.fields[column].text)).as_slice() {
            [one] => usual(one),
            _ => None,
        },
        Quantity::Fraction => said.or_else(|| usual("ns")),
        Quantity::Length => {
            // Metres from one row to the next, to a landmark, and across a map.
            let far = match value.name {
                "distance" => 20.0,
                "range" | "first range" => 1000.0,
                _ => 5000.0,
            };
            let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
            let widest = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max) - least;
            let size = if matches!(value.name, "x" | "y") { widest } else { most };
            said.or_else(|| if size > far { None } else { usual("m") })
        }
        Quantity::SigmaWords if name.has_one(&VARIANCES) => usual(VARIANCE),
        Quantity::SigmaWords => said.or_else(|| if most > 200.0 { None } else { usual("m") }),
        // A ship's speed, over ground or through the water, is often in knots.
        Quantity::Speed => {
            said.or_else(|| if most > 30.0 || name.has_one(&["sog", "stw"]) { None } else { usual("m/s") })
        }
        // A ship's rate of turn: to starboard it counts above 0, and often in degrees a minute.
        Quantity::AngleRate if name.has_one(&["rot"]) || name.has("rate") && name.has("of") => None,
        Quantity::AngleRate => {
            let degrees = match said {
                Some(unit) if unit.name == "deg/min" => {
                    return usual(if down { "deg/min clockwise" } else { unit.name });
                }
                Some(unit) => unit.name == "deg/s",
                None if most > 20.0 => true,
                // Faster than half a turn in a second: few robots are, and degrees may be meant.
                None if whole().fold(most, |most, it| most.max(it.abs())) > 3.5 => return None,
                None => false,
            };
            usual(match (degrees, down) {
                (false, false) => "rad/s",
                (true, false) => "deg/s",
                (false, true) => "rad/s clockwise",
                (true, true) => "deg/s clockwise",
            })
        }
        Quantity::AngleSpread if name.has_one(&VARIANCES) => usual(ANGLE_VARIANCE),
        // How accurate a heading is, is written as the heading is: a phone's are degrees.
        Quantity::AngleSpread if said.is_none() && source.is_in_degrees("heading") => usual("deg"),
        Quantity::Angle | Quantity::AngleSpread => {
            let turn = if value.name == "turn" { 3.2 } else { 7.0 };
            said.or_else(|| usual(if most > turn { "deg" } else { "rad" }))
        }
        Quantity::Heading if quaternion::first(&source.names).is_some_and(|w| is_part(&source.names, w, column)) => {
            usual(QUATERNION)
        }
        Quantity::Heading => {
            let has_latitude = !candidates("latitude", Quantity::Coordinate, &source.names).is_empty();
            // What a robot reckons has nothing to do with them.
            let global = has_latitude && source.role != Role::Reckoned;
            // Phones write -1 where they know none.
            let (furthest, below) = whole()
                .fold((most, false), |(most, below), it| (most.max(it.abs()), below || (it < 0.0 && it != -1.0)));
            let of = [down, global, captured(&source.names, file), below];
            heading::unit(name, said, [most, furthest], of).and_then(usual)
        }
        Quantity::Coordinate => {
            // Both are in one unit: near Greenwich a longitude is small in any.
            let other = |i: &usize| source.role.values()[*i].quantity == Quantity::Coordinate;
            let both: Vec<usize> = (0..source.columns.len()).filter(other).filter_map(|i| source.columns[i]).collect();
            let of = |line: &Line<'_>| {
                both.iter().filter_map(|at| number(line.fields[*at].text)).fold(0.0_f64, |most, it| most.max(it.abs()))
            };
            let most = lines.iter().map(of).fold(0.0_f64, f64::max);
            said.or_else(|| usual(if most > 1e5 { "1e-7 deg" } else { "deg" }))
        }
        Quantity::Wheel => {
            let ticks = name.has_one(&["encoder", "enc"]) || file.to_lowercase().contains("encoder");
            said.or_else(|| if ticks { usual("ticks") } else { None })
        }
    }
}

/// The unit of times whose rows come, in the middle, so far apart; a robot's log has a row in five seconds at least.
/// Of gaps between 5 and 20 nobody knows whether they are seconds or milliseconds.
fn by_rate(times: &[f64]) -> Option<&'static str> {
    let mut gaps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).filter(|gap| *gap > 0.0).collect();
    gaps.sort_unstable_by(f64::total_cmp);
    let since_1970 = times.first().map_or(0.0, |time| time.abs());
    // Dates as spreadsheets and MATLAB count them, whose rows are seconds apart and no millionth of one.
    let is_day = |gap: f64| gap < 1e-4 && (2e4..1e6).contains(&since_1970);
    Some(match gaps.get(gaps.len().saturating_sub(1) / 2) {
        _ if since_1970 > 1e17 => "ns",
        _ if since_1970 > 1e14 => "us",
        _ if since_1970 > 1e11 => "ms",
        Some(gap) if is_day(*gap) => "days",
        Some(gap) if *gap > 1e6 => "ns",
        Some(gap) if *gap > 2e3 => "us",
        Some(gap) if *gap > 20.0 => "ms",
        Some(gap) if *gap > 5.0 => return None,
        _ => "s",
    })
}
