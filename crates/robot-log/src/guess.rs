//! What a file probably is: a role, its columns and its units, by what its columns are called, by its name, and by its
//! numbers.

use crate::role::{Quantity, Role, Units};
use crate::row::number;
use crate::source::Source;
use crate::table::Table;

/// The rows whose numbers are looked at.
const LOOKED_AT: usize = 200;

/// Words in a column's name by which a value is known: the first that fits is taken, and all words of an entry must be
/// there.
const WORDS: [(&str, &[&str]); 12] = [
    ("time", &["time", "t", "timestamp", "stamp", "sec", "secs", "seconds", "clock", "zeit"]),
    ("omega", &["omega", "ω", "w", "wz", "yaw rate", "yawrate", "turn rate", "angular", "gyro", "rotational"]),
    ("v", &["v", "vx", "speed", "forward", "linear", "velocity", "vel"]),
    ("distance", &["distance", "dist", "d", "ds", "travelled", "traveled"]),
    ("turn", &["turn", "dtheta", "dyaw", "dheading", "rotation", "delta theta", "delta heading", "delta yaw"]),
    ("barcode", &["barcode", "code"]),
    ("landmark", &["landmark", "beacon", "anchor", "tag", "marker", "feature", "subject", "id", "barcode"]),
    ("range", &["range", "r", "rho", "ρ", "distance", "dist"]),
    ("bearing", &["bearing", "azimuth", "beta", "phi", "φ", "angle"]),
    ("x", &["x", "east", "easting"]),
    ("y", &["y", "north", "northing"]),
    ("heading", &["heading", "theta", "θ", "yaw", "orientation"]),
];

/// Words in a file's name, and the role that they speak for.
const FILES: [(&str, Role); 13] = [
    ("landmark", Role::Landmarks),
    ("beacons", Role::Landmarks),
    ("map", Role::Landmarks),
    ("barcode", Role::Barcodes),
    ("truth", Role::Truth),
    ("gps", Role::Truth),
    ("measure", Role::Sightings),
    ("sight", Role::Sightings),
    ("range", Role::Sightings),
    ("observ", Role::Sightings),
    ("odom", Role::Velocities),
    ("veloc", Role::Velocities),
    ("motion", Role::Velocities),
];

/// Roles in the order in which they are tried: a file of sightings has a time too, and a file of the truth may have
/// speeds.
const ORDER: [Role; 6] =
    [Role::Barcodes, Role::Landmarks, Role::Sightings, Role::Velocities, Role::Odometry, Role::Truth];

/// How a file is read unless the reader says otherwise.
pub(crate) fn guess(name: &str, text: &str) -> Source {
    let table = Table::new(text).filter(|_| !is_log(text));
    let Some(table) = table else {
        return Source { role: Role::Log, table: None, columns: Vec::new(), units: Units::default() };
    };
    let role = role(name, &table.names);
    let columns = columns(role, &table.names);
    let units = units(text, &table, role, &columns);
    Source { role, table: Some(table), columns, units }
}

/// Whether a text is in the book's own format, or is meant to be: a row begins with a letter, or it is no text at all.
fn is_log(text: &str) -> bool {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let rows = || text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')).take(40);
    let letter = |line: &str| {
        let mut letters = line.trim_start_matches(['"', '\'']).chars();
        let first = letters.next().is_some_and(|c| "LGOVSTRBPH".contains(c));
        first && letters.next().is_some_and(|c| !c.is_alphanumeric() && c != '_')
    };
    let strange = rows().any(|line| line.contains(['\0', '\u{fffd}']));
    let letters = rows().filter(|line| letter(line)).count();
    strange || (letters > 0 && 2 * letters >= rows().count())
}

fn role(name: &str, names: &[String]) -> Role {
    let name = name.to_lowercase();
    let said: Vec<Role> = FILES.iter().filter(|(word, _)| name.contains(word)).map(|(_, role)| *role).collect();
    let timed = column("time", names).is_some();
    let fits = |role: &Role| {
        let values = role.values();
        let found = values.iter().all(|value| value.optional || column(value.name, names).is_some());
        found && (values[0].name == "time") == timed
    };
    let fitting: Vec<Role> = ORDER.into_iter().filter(fits).collect();
    // Odometry in a file's name may mean velocities.
    fitting
        .iter()
        .find(|role| said.contains(role))
        .or(fitting.first())
        .or(said.first())
        .copied()
        .unwrap_or(Role::Unused)
}

/// The column of each value of a role: by its name, or, where no column has a name that is known, by the usual order.
pub(crate) fn columns(role: Role, names: &[String]) -> Vec<Option<usize>> {
    let values = role.values();
    let known: Vec<Option<usize>> = values.iter().map(|value| column(value.name, names)).collect();
    if known.iter().all(Option::is_none) && names.len() >= values.iter().filter(|value| !value.optional).count() {
        return (0..values.len()).map(|i| (i < names.len()).then_some(i)).collect();
    }
    known
}

/// The column of a value, by its name.
fn column(value: &str, names: &[String]) -> Option<usize> {
    let words = WORDS.iter().find(|(name, _)| *name == value).map_or(&[][..], |(_, words)| words);
    let has = |name: &String, entry: &str| {
        let tokens = tokens(name);
        entry.split(' ').all(|word| tokens.iter().any(|token| token == word))
    };
    // An angular velocity is a velocity too.
    let turns = (value == "v").then(|| column("omega", names)).flatten();
    let fits = |word: &str| names.iter().enumerate().position(|(i, name)| Some(i) != turns && has(name, word));
    words.iter().find_map(|word| fits(word))
}

/// The words of a column's name in small letters, units among them.
fn tokens(name: &str) -> Vec<String> {
    let mut spaced = String::new();
    let mut small = false;
    for c in name.chars() {
        if small && c.is_uppercase() {
            spaced.push(' ');
        }
        small = c.is_lowercase();
        spaced.extend(if c.is_alphanumeric() { c } else { ' ' }.to_lowercase());
    }
    spaced.split_whitespace().map(String::from).collect()
}

/// The units, by what the columns are called, else by their numbers.
fn units(text: &str, table: &Table, role: Role, columns: &[Option<usize>]) -> Units {
    let mut units = Units::default();
    for (value, column) in role.values().iter().zip(columns) {
        let Some(column) = *column else { continue };
        let said = tokens(&table.names[column]);
        let says = |words: &[&'static str]| words.iter().find(|word| said.iter().any(|token| token == *word)).copied();
        let rows = table.lines(text).filter_map(Result::ok).take(LOOKED_AT);
        let numbers: Vec<f64> = rows.filter_map(|line| number(line.fields[column].text)).collect();
        let most = numbers.iter().fold(0.0_f64, |most, number| most.max(number.abs()));
        match value.quantity {
            Quantity::Time => {
                let unit = says(&["ms", "us", "ns", "s"]).or_else(|| {
                    let words =
                        [("milliseconds", "ms"), ("millis", "ms"), ("microseconds", "us"), ("nanoseconds", "ns")];
                    words.into_iter().find(|(word, _)| said.iter().any(|token| token == word)).map(|(_, unit)| unit)
                });
                units.time = unit.unwrap_or_else(|| by_rate(&numbers));
            }
            Quantity::Length | Quantity::Speed => {
                // Metres in a second, from one row to the next, to a landmark, and across a map.
                let far = match value.name {
                    "v" => 30.0,
                    "distance" => 20.0,
                    "range" => 1000.0,
                    _ => 5000.0,
                };
                let unit = says(&["mm", "cm", "m"]).unwrap_or(if most > far { "mm" } else { "m" });
                if unit != "m" {
                    units.length = unit;
                }
            }
            Quantity::Angle | Quantity::AngleRate => {
                let degrees = says(&["deg", "degrees", "degree", "dps"]).is_some() || table.names[column].contains('°');
                let radians = says(&["rad", "radians", "rads"]).is_some();
                let turn = match value.name {
                    "omega" => 20.0,
                    "turn" => 3.2,
                    _ => 7.0,
                };
                if degrees || (!radians && most > turn) {
                    units.angle = "deg";
                }
            }
            Quantity::Number => {}
        }
    }
    units
}

/// The unit of times whose rows come, in the middle, so far apart. A robot's log has a row in 5 seconds at least.
fn by_rate(times: &[f64]) -> &'static str {
    let mut gaps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).filter(|gap| *gap > 0.0).collect();
    gaps.sort_by(f64::total_cmp);
    match gaps.get(gaps.len().saturating_sub(1) / 2) {
        Some(gap) if *gap > 1e6 => "ns",
        Some(gap) if *gap > 2e3 => "us",
        Some(gap) if *gap > 5.0 => "ms",
        _ => "s",
    }
}
