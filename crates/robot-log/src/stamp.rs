//! Stamps that are dates or times of day: ISO 8601 with its zones, as programs and spreadsheets write it.

use crate::unit::{DAY_FIRST, MONTH_FIRST, YEAR_FIRST};

/// Seconds since the first of January 1970 in UTC, of `2026-05-01T12:00:00.5+02:00`; a blank may stand for the `T`, and
/// without a zone it is UTC. Slashes may part the date, and stand for the `T` then. Of a time of day alone,
/// `12:00:00.5`, the seconds since midnight.
pub(crate) fn seconds(text: &str) -> Option<f64> {
    let text = text.trim();
    if let Some(of_day) = time_of_day(text) {
        return Some(of_day);
    }
    // Points part a date whose day stands first, as in `01.05.2026 12:00:00,5`.
    if let Some((date, clock)) = text.split_once([' ', 'T']).filter(|(date, _)| date.contains('.')) {
        let (clock, zone) = zone(clock.trim());
        return Some(day(date, DAY_FIRST)? + time_of_day(clock.trim())? - zone?);
    }
    let (date, rest) = text.split_at_checked(10)?;
    let mark = if date.contains('/') { '/' } else { '-' };
    let mut fields = date.split(mark);
    let mut field = |digits: usize| whole(fields.next()?, digits);
    let (year, month, day) = (field(4)?, field(2)?, field(2)?);
    if fields.next().is_some() || !(1..=12).contains(&month) || !(1..=days_of(year, month)).contains(&day) {
        return None;
    }
    let rest = rest.strip_prefix(['T', 't', ' ', '_', mark]).filter(|_| mark == '/' || !rest.starts_with('-'))?;
    let (clock, zone) = zone(rest.trim());
    Some(86_400.0 * days(year, month, day) as f64 + time_of_day(clock.trim())? - zone?)
}

/// Seconds from 1970 to the beginning of a day, which is written in this order; without marks, 20260501, as well.
pub(crate) fn day(text: &str, order: &str) -> Option<f64> {
    let text = text.trim();
    let eight = text.len() == 8 && text.bytes().all(|b| b.is_ascii_digit());
    let parts: Vec<&str> = match order {
        YEAR_FIRST if eight => vec![&text[..4], &text[4..6], &text[6..]],
        _ if eight => vec![&text[..2], &text[2..4], &text[4..]],
        _ => text.split(['-', '.', '/']).collect(),
    };
    let [first, second, third] = parts.as_slice() else { return None };
    let (year, month, day) = match order {
        YEAR_FIRST => (first, second, third),
        DAY_FIRST => (third, second, first),
        _ => (third, first, second),
    };
    let short = |text: &str| whole(text, 2).or_else(|| whole(text, 1));
    let (year, month, day) = (whole(year, 4)?, short(month)?, short(day)?);
    let there = (1..=12).contains(&month) && (1..=days_of(year, month)).contains(&day);
    there.then(|| 86_400.0 * days(year, month, day) as f64)
}

/// The orders in which all these days can be read.
pub(crate) fn orders<'t>(all: impl Iterator<Item = &'t str> + Clone) -> Vec<&'static str> {
    let fits = |order: &&str| all.clone().next().is_some() && all.clone().all(|text| day(text, order).is_some());
    [YEAR_FIRST, DAY_FIRST, MONTH_FIRST].into_iter().filter(fits).collect()
}

/// Whether the text is a time of day without its date: what comes after midnight is less than what came before.
pub(crate) fn is_time_of_day(text: &str) -> bool {
    time_of_day(text.trim()).is_some()
}

/// `12:00`, `12:00:00`, `12:00:00.5` or `12:00:00,5`; 60 is a leap second.
fn time_of_day(text: &str) -> Option<f64> {
    let mut fields = text.splitn(3, ':');
    let (hour, minute) = (whole(fields.next()?, 2)?, whole(fields.next()?, 2)?);
    let second = match fields.next() {
        None => 0.0,
        Some(text) => {
            let at = text.find(['.', ',']).unwrap_or(text.len());
            let (seconds, fraction) = (whole(&text[..at], 2)?, text.get(at + 1..).unwrap_or("0"));
            if fraction.is_empty() || !fraction.bytes().all(|b| b.is_ascii_digit()) {
                return None;
            }
            seconds as f64 + format!("0.{fraction}").parse::<f64>().ok()?
        }
    };
    (hour < 24 && minute < 60 && second < 61.0).then_some(3600.0 * hour as f64 + 60.0 * minute as f64 + second)
}

/// The time before its zone, and the seconds by which the zone is ahead of UTC.
fn zone(text: &str) -> (&str, Option<f64>) {
    if let Some(clock) = text.strip_suffix(['Z', 'z']).or_else(|| text.strip_suffix("UTC")) {
        return (clock, Some(0.0));
    }
    let Some(at) = text.rfind(['+', '-']) else { return (text, Some(0.0)) };
    let (sign, digits) = (if text[at..].starts_with('-') { -1.0 } else { 1.0 }, text[at + 1..].replace(':', ""));
    let ahead = match digits.len() {
        2 => whole(&digits, 2).map(|hours| 3600 * hours),
        4 => whole(&digits, 4).filter(|all| all % 100 < 60).map(|all| 3600 * (all / 100) + 60 * (all % 100)),
        _ => None,
    };
    (&text[..at], ahead.filter(|ahead| *ahead < 86_400).map(|ahead| sign * ahead as f64))
}

/// A whole number of so many digits.
fn whole(text: &str, digits: usize) -> Option<i64> {
    (text.len() == digits && text.bytes().all(|b| b.is_ascii_digit())).then(|| text.parse().ok())?
}

fn days_of(year: i64, month: i64) -> i64 {
    match month {
        2 if year % 4 == 0 && (year % 100 != 0 || year % 400 == 0) => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

/// Days since the first of January 1970, of a date in the Gregorian calendar; years begin in March here, so that the
/// leap day is the last of its year.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let year = if month < 3 { year - 1 } else { year };
    let (era, of_era, of_year) =
        (year.div_euclid(400), year.rem_euclid(400), (153 * ((month + 9) % 12) + 2) / 5 + day - 1);
    146_097 * era + 365 * of_era + of_era / 4 - of_era / 100 + of_year - 719_468
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_seconds_of_the_unix_clock_whatever_their_zone() {
        for (text, expected) in [
            ("1970-01-01T00:00:00Z", Some(0.0)),
            ("2026-05-01T12:00:00.25Z", Some(1_777_636_800.25)),
            ("2026-05-01T14:00:00,25+02:00", Some(1_777_636_800.25)),
            ("2026-05-01 05:30:00.25-0630", Some(1_777_636_800.25)),
            ("2026-05-01 12:00", Some(1_777_636_800.0)),
            ("2024-02-29T00:00:00+00", Some(1_709_164_800.0)),
            ("2026/05/01 12:00", Some(1_777_636_800.0)),
            ("2026/05/01/12:00:00.25", Some(1_777_636_800.25)),
            ("01.05.2026 12:00:00,25", Some(1_777_636_800.25)),
            ("1.5.2026 14:00+02:00", Some(1_777_636_800.0)),
            ("31.04.2026 12:00", None),
            ("0.5 12:00", None),
            ("2026-05/01 12:00", None),
            ("2026-05-01-12:00", None),
            ("1969-12-31T23:59:59Z", Some(-1.0)),
            ("23:59:59.5", Some(86_399.5)),
            ("2023-02-29T00:00:00Z", None),
            ("2026-13-01T00:00:00Z", None),
            ("2026-05-01T24:00:00Z", None),
            ("2026-05-01T12:00:00+2:00", None),
            ("2026-05-01", None),
            ("12", None),
            ("2026-05-0é T12", None),
            ("", None),
        ] {
            assert_eq!(seconds(text), expected, "{text}");
        }
    }

    #[test]
    fn a_day_is_read_in_its_order_and_in_no_other() {
        let may = 1_777_593_600.0;
        for (text, order, expected) in [
            ("2026-05-01", YEAR_FIRST, Some(may)),
            ("20260501", YEAR_FIRST, Some(may)),
            ("1.5.2026", DAY_FIRST, Some(may)),
            ("05/01/2026", "month, day, year", Some(may)),
            ("2026-05-01", DAY_FIRST, None),
            ("31.04.2026", DAY_FIRST, None),
            ("1.5.26", DAY_FIRST, None),
            ("", YEAR_FIRST, None),
        ] {
            assert_eq!(day(text, order), expected, "{text}");
        }
        assert_eq!(orders(["01/05/2026", "13/05/2026"].into_iter()), [DAY_FIRST]);
        assert_eq!(orders(["01/05/2026", "02/05/2026"].into_iter()).len(), 2, "nobody knows");
        assert!(orders([].into_iter()).is_empty());
    }
}
