//! Texts that hold a log and are no table: sentences of receivers (NMEA 0183), tags (GPX, KML) and objects (JSON). How
//! each is known, and how a table is got out of it.

/// What a text that begins so is, and the way to a table.
pub(crate) fn refusal(text: &str) -> Option<(&'static str, &'static str)> {
    let start = text.trim_start();
    let end = (0..=4000.min(start.len())).rev().find(|end| start.is_char_boundary(*end)).unwrap_or(0);
    let head = &start[..end];
    if start.starts_with('<') && start[1..].starts_with(|c: char| c.is_ascii_alphabetic() || matches!(c, '?' | '!')) {
        return Some(tagged(head));
    }
    object(start).or_else(|| sentences(text))
}

fn tagged(head: &str) -> (&'static str, &'static str) {
    let has = |tag: &str| head.contains(tag);
    match () {
        () if has("<gpx") => {
            ("a track in GPX", "`gpsbabel -t -i gpx -f FILE -o unicsv,utc=0 -F track.csv` writes one with its times")
        }
        () if has("<kml") => (
            "a way in KML",
            "`gpsbabel -t -i kml -f FILE -o unicsv,utc=0 -F track.csv` writes one, with times if the file has any",
        ),
        () if has("<TrainingCenterDatabase") => {
            ("a track in TCX", "`gpsbabel -t -i gtrnctr -f FILE -o unicsv,utc=0 -F track.csv` writes one")
        }
        () if has("<html") || has("<!DOCTYPE html") || has("<!doctype html") => {
            ("a web page", "save the file that the page links to, not the page")
        }
        () => ("a text of tags (XML)", "save it as CSV where it comes from"),
    }
}

/// Objects in braces, one on each line, or in one list.
fn object(start: &str) -> Option<(&'static str, &'static str)> {
    let (first, rest) = start.split_at_checked(1)?;
    let second = rest.trim_start().chars().next().unwrap_or(' ');
    let whole = |line: &&str| line.starts_with('{') && line.ends_with('}');
    let each = start.lines().map(str::trim).filter(|line| !line.is_empty()).take(2).filter(whole).count() == 2;
    match (first, second) {
        ("{", '"' | '}') if each => Some((
            "JSON, an object on each line",
            "`jq -rs '(.[0]|keys_unsorted) as $k | $k, (.[]|[.[$k[]]]) | @csv' FILE > log.csv` writes one with a \
             column for each key",
        )),
        ("[", '{') => Some((
            "JSON, a list of objects",
            "`jq -r '(.[0]|keys_unsorted) as $k | $k, (.[]|[.[$k[]]]) | @csv' FILE > log.csv` writes one with a \
             column for each key",
        )),
        ("{", '"' | '}') | ("[", '[' | ']') => {
            Some(("JSON", "`jq` writes lists in it as rows with `@csv`, a row for each time, below a line of names"))
        }
        _ => None,
    }
}

/// Sentences as `$GPRMC,…`, which may stand behind a stamp of the program that wrote them down.
fn sentences(text: &str) -> Option<(&'static str, &'static str)> {
    const KINDS: [&str; 8] = ["GGA", "RMC", "GLL", "VTG", "GSA", "GSV", "GNS", "ZDA"];
    let sentence = |line: &str| {
        let (before, behind) = line.split_once('$')?;
        let kind = behind.get(2..5).filter(|_| behind.get(5..6) == Some(","))?;
        KINDS.contains(&kind).then(|| before.trim().is_empty())
    };
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).take(40).collect();
    let found: Vec<bool> = lines.iter().filter_map(|line| sentence(line)).collect();
    if found.is_empty() || 2 * found.len() < lines.len() {
        return None;
    }
    Some(match found.iter().all(|alone| *alone) {
        true => (
            "sentences of a receiver (NMEA)",
            "`gpsbabel -t -i nmea -f FILE -o unicsv,utc=0 -F gps.csv` writes one with its times",
        ),
        false => (
            "sentences of a receiver (NMEA) behind other words",
            "`grep -o '\\$G.*' FILE > gps.nmea`, then `gpsbabel -t -i nmea -f gps.nmea -o unicsv,utc=0 -F gps.csv` \
             writes one with the receiver\u{2019}s times",
        ),
    })
}
