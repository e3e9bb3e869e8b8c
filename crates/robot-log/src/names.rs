//! The names of columns as words: in small letters, without accents, parted at points, blanks, capitals and digits.

use crate::nested::BELOW;
use crate::role::Quantity;
use crate::unit::{self, Unit};
use crate::vocabulary::{FORBIDDEN, SigmaWords, Way, ways};
use core::cmp::Ordering;

/// The name of a column.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Name {
    /// All its words, units among them.
    pub words: Vec<String>,
    /// How many of them are the name; the others stand below it, and make it no longer.
    own: usize,
    /// How many of the first ones all columns of its table have: a topic's, as in `GPS_Lat`, `GPS_Lon`.
    shared: usize,
}

impl Name {
    pub fn new(name: &str) -> Self {
        let own = name.split(BELOW).next().map_or(0, |own| words(own).len());
        Self { words: words(name), own, shared: 0 }
    }

    /// The names of a table's columns.
    pub fn all(names: &[String]) -> Vec<Self> {
        let mut all: Vec<Self> = names.iter().map(|name| Self::new(name)).collect();
        let first = all.first().and_then(|name| name.words.first()).cloned();
        let shared =
            all.len() > 1 && all.iter().all(|name| name.words.len() > 1 && name.words.first() == first.as_ref());
        all.iter_mut().for_each(|name| name.shared = usize::from(shared));
        all
    }

    pub fn has(&self, word: &str) -> bool {
        self.words.iter().any(|it| it == word)
    }

    pub fn has_one(&self, words: &[&str]) -> bool {
        words.iter().any(|word| self.has(word))
    }

    /// Whether it has one of these besides what all columns of its table have.
    pub fn has_one_itself(&self, words: &[&str]) -> bool {
        self.words.iter().skip(self.shared).any(|word| words.contains(&word.as_str()))
    }

    /// Its words but for these.
    pub fn without(&self, words: &[&str]) -> Self {
        let left = |range: &[String]| range.iter().filter(|it| !words.contains(&it.as_str())).cloned().collect();
        let (all, own): (Vec<String>, Vec<String>) = (left(&self.words), left(&self.words[..self.own]));
        Self { words: all, own: own.len(), shared: 0 }
    }

    /// Whether words stand below the name.
    pub fn has_below(&self) -> bool {
        self.own < self.words.len()
    }

    /// The unit that the name says, of those of a quantity.
    pub fn unit(&self, quantity: Quantity) -> Option<&'static Unit> {
        unit::written(quantity, &self.words).map(|(unit, _)| unit)
    }

    /// The words without those of its unit; all of them where nothing else is left.
    pub fn base(&self, quantity: Quantity) -> Vec<&str> {
        let range = unit::written(quantity, &self.words).map_or(0..0, |(_, range)| range);
        let base = |range: core::ops::Range<usize>| {
            let all = self.words.iter().enumerate().filter(move |(i, _)| !range.contains(i));
            all.map(|(_, word)| word.as_str()).collect::<Vec<_>>()
        };
        let without = base(range);
        if without.is_empty() { base(0..0) } else { without }
    }
}

/// The columns that a value may be in: none, one that is certain, or several that fit equally well.
pub(crate) fn candidates(value: &str, quantity: Quantity, names: &[Name]) -> Vec<usize> {
    let forbidden = FORBIDDEN.iter().find(|(name, _)| *name == value).map_or(&[][..], |(_, words)| *words);
    let fits: Vec<usize> = (0..names.len())
        .filter(|i| !names[*i].has_one(forbidden))
        // How accurate is no acceleration: `h_acc`.
        .filter(|i| value.starts_with("sigma") || !is_acceleration(&names[*i]))
        .filter(|i| value.starts_with("sigma") || !is_spread(&names[*i]))
        .collect();
    // What a wheel does is neither the robot's speed nor its turn rate.
    let wheels = if matches!(value, "v" | "omega") { of_wheels(names) } else { Vec::new() };
    let fits: Vec<usize> = fits.into_iter().filter(|i| !wheels.contains(i)).collect();
    for way in ways(value) {
        let mut found: Vec<usize> = fits.iter().copied().filter(|i| follows(way, &names[*i], quantity)).collect();
        // What says no more than it must fits best.
        found.sort_by(|a, b| longer(&names[*a], &names[*b], quantity));
        let best = found.iter().take_while(|i| longer(&names[**i], &names[found[0]], quantity).is_eq()).count();
        found.truncate(best);
        if !found.is_empty() {
            return found;
        }
    }
    if value == "omega" { upward(names).into_iter().collect() } else { Vec::new() }
}

/// The column of a turn rate that is called by its axis and its unit alone: `z_rad_s`, where `z_rad` is an angle.
fn upward(names: &[Name]) -> Option<usize> {
    let is_rate = |name: &Name| name.unit(Quantity::AngleRate).is_some() && name.base(Quantity::Angle) != ["z"];
    names.iter().position(|name| name.base(Quantity::AngleRate) == ["z"] && is_rate(name))
}

/// The columns of the left and the right one of two wheels, where there are both.
fn of_wheels(names: &[Name]) -> Vec<usize> {
    let [left, right] = ["left", "right"].map(|side| candidates(side, Quantity::Wheel, names));
    if left.is_empty() || right.is_empty() { Vec::new() } else { [left, right].concat() }
}

fn longer(a: &Name, b: &Name, quantity: Quantity) -> Ordering {
    let length = |name: &Name| name.base(quantity).len().min(name.own);
    length(a).cmp(&length(b))
}

fn follows(way: Way<'_>, name: &Name, quantity: Quantity) -> bool {
    match way {
        Way::Whole(words) => name.base(quantity).into_iter().skip(name.shared).eq(words.split(' ')),
        Way::First(word) => name.words.first().is_some_and(|first| first == word),
        Way::Within(words) => words.split(' ').all(|word| name.has(word)),
    }
}

/// Whether a text is a unit of some quantity and nothing else.
pub(crate) fn is_unit(text: &str) -> bool {
    use Quantity::{Angle, AngleRate, Length, Speed, Time};
    let words = words(text);
    [Time, Length, Speed, Angle, AngleRate]
        .into_iter()
        .any(|quantity| unit::written(quantity, &words).is_some_and(|(_, range)| range.len() == words.len()))
}

/// How far a number may be off.
pub(crate) fn is_spread(name: &Name) -> bool {
    name.has_one(&SigmaWords::ALL)
}

/// Metres in a second in a second: never a speed.
pub(crate) fn is_acceleration(name: &Name) -> bool {
    let pair = |a: &str, b: &str| name.words.windows(2).any(|it| it[0] == a && it[1] == b);
    name.has_one(&["acc", "accel", "acceleration", "accelerometer", "beschleunigung", "aceleracion", "accelerazione"])
        || name.words.iter().any(|word| word.ends_with("s²"))
        || pair("s", "2")
}

/// The words of a column's name.
fn words(name: &str) -> Vec<String> {
    let mut spaced = String::new();
    let mut before = ' ';
    let mut chars = name.chars().peekable();
    while let Some(c) = chars.next() {
        let parts = (before.is_lowercase() && c.is_uppercase())
            // The last capital of several begins a word: `GPSTime`.
            || (before.is_uppercase() && c.is_uppercase() && chars.peek().is_some_and(|next| next.is_lowercase()))
            || (before.is_alphabetic() && c.is_ascii_digit())
            || (before.is_ascii_digit() && c.is_alphabetic());
        if parts {
            spaced.push(' ');
        }
        before = c;
        match c {
            '°' => spaced.push_str(" deg "),
            'µ' | 'μ' => spaced.push('u'),
            c if c.is_alphanumeric() => spaced.extend(c.to_lowercase().map(without_accent)),
            _ => spaced.push(' '),
        }
    }
    spaced.split_whitespace().flat_map(with_axis).map(String::from).collect()
}

/// A word, and the axis that is written to it without a mark: `posx`, `vely`.
fn with_axis(word: &str) -> impl Iterator<Item = &str> {
    const WRITTEN: [&str; 7] = ["pos", "vel", "acc", "gyro", "gyr", "gps", "mag"];
    let at = word.strip_suffix(['x', 'y', 'z']).filter(|stem| WRITTEN.contains(stem)).map_or(word.len(), str::len);
    let (stem, axis) = word.split_at(at);
    [stem, axis].into_iter().filter(|part| !part.is_empty())
}

fn without_accent(c: char) -> char {
    match c {
        'à' | 'á' | 'â' | 'ä' => 'a',
        'è' | 'é' | 'ê' | 'ë' => 'e',
        'ì' | 'í' | 'î' | 'ï' => 'i',
        'ò' | 'ó' | 'ô' | 'ö' => 'o',
        'ù' | 'ú' | 'û' | 'ü' => 'u',
        'ñ' => 'n',
        'ç' => 'c',
        c => c,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_parted_into_words_and_its_unit_is_known() {
        assert_eq!(words("twist.twist.linear.x"), ["twist", "twist", "linear", "x"]);
        assert_eq!(words("GyrZ"), ["gyr", "z"]);
        assert_eq!(words("GPS_GPSTime"), ["gps", "gps", "time"]);
        assert_eq!(words("TimeUS"), ["time", "us"]);
        assert_eq!(words("velx"), ["vel", "x"]);
        assert_eq!(words("d1"), ["d", "1"]);
        assert_eq!(words("Longitud (°)"), ["longitud", "deg"]);
        assert_eq!(words("Vitesse_lacet [°/s]"), ["vitesse", "lacet", "deg", "s"]);
        for (name, quantity, unit) in [
            ("speed_m_s", Quantity::Speed, Some("m/s")),
            ("speed (km/h)", Quantity::Speed, Some("km/h")),
            ("TimeUS", Quantity::Time, Some("us")),
            ("t [µs]", Quantity::Time, Some("us")),
            ("gyro_rad[2]", Quantity::AngleRate, Some("rad/s")),
            ("Drehrate in Grad", Quantity::AngleRate, Some("deg/s")),
            ("acc m/s^2", Quantity::Length, Some("m")),
            ("speed", Quantity::Speed, None),
        ] {
            assert_eq!(Name::new(name).unit(quantity).map(|unit| unit.name), unit, "{name}");
        }
    }

    #[test]
    fn whole_parts_are_matched_and_never_an_orientation_or_an_acceleration() {
        let of = |value: &str, quantity, names: &[&str]| {
            candidates(value, quantity, &names.iter().map(|name| Name::new(name)).collect::<Vec<_>>())
        };
        let odometry = [
            "pose.pose.position.x",
            "pose.pose.orientation.z",
            "pose.pose.orientation.w",
            "twist.twist.linear.x",
            "twist.twist.angular.x",
            "twist.twist.angular.z",
            "twist.covariance.0",
        ];
        assert_eq!(of("v", Quantity::Speed, &odometry), [3]);
        assert_eq!(of("omega", Quantity::AngleRate, &odometry), [5]);
        assert_eq!(of("x", Quantity::Length, &odometry), [0]);
        assert_eq!(of("heading", Quantity::Heading, &odometry), []);
        let imu = ["orientation.w", "angular_velocity.z", "linear_acceleration.x", "a (m/s^2)"];
        assert_eq!(of("omega", Quantity::AngleRate, &imu), [1]);
        assert_eq!(of("v", Quantity::Speed, &imu), []);
        assert_eq!(of("v", Quantity::Speed, &["gps_speed", "wheel_speed"]), [0, 1]);
        assert_eq!(of("v", Quantity::Speed, &["roll_vel", "pitch_vel", "yaw_vel"]), []);
        assert_eq!(of("omega", Quantity::AngleRate, &["roll_vel", "pitch_vel", "yaw_vel"]), [2]);
        assert_eq!(of("v", Quantity::Speed, &["wheel speed", "speed (m/s)"]), [1]);
    }

    #[test]
    fn the_topic_before_all_names_of_a_table_says_nothing() {
        let names = Name::all(&["GPS_Lat", "GPS_EPH", "GPS_EPV"].map(String::from));
        assert_eq!(candidates("sigma", Quantity::Length, &names), [1]);
        assert_eq!(candidates("x", Quantity::Length, &Name::all(&["gyro_x", "gyro_y"].map(String::from))), []);
    }
}
