//! Every number of the prose that the mathematics determines is computed: a decimal typed into `content/` is either on
//! the closed list of given constants (`content/constants.toml`, each with its reason) or a name, as an equation number
//! is.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn content() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../content")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The Markdown files and the questions.
fn prose() -> Vec<(PathBuf, String)> {
    let mut folders = vec![content()];
    let mut files = vec![content().join("glossary.toml")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("content is there") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") && !path.ends_with("LICENSE.md")
                || folder.ends_with("quizzes")
            {
                files.push(path);
            }
        }
    }
    files.sort();
    files.into_iter().map(|file| (file.clone(), read(&file))).collect()
}

/// Everything between `open` and the next `close` blanked out.
fn without(text: &str, open: &str, close: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, tail)) = rest.split_once(open) {
        out.push_str(before);
        out.push(' ');
        let (inside, after) = tail.split_once(close).unwrap_or((tail, ""));
        out.extend(inside.matches('\n'));
        rest = after;
    }
    out + rest
}

/// The decimals that a line spells out: digits, a point, digits, standing alone. `§8.2` and `J.5` are names.
fn decimals(line: &str) -> Vec<String> {
    let chars: Vec<char> = line.chars().collect();
    let part = |c: char| c.is_ascii_digit() || c == '.';
    let mut found = Vec::new();
    let mut at = 0;
    while at < chars.len() {
        if !part(chars[at]) {
            at += 1;
            continue;
        }
        let end = (at..chars.len()).find(|&i| !part(chars[i])).unwrap_or(chars.len());
        let word: String = chars[at..end].iter().collect();
        let word = word.trim_end_matches('.');
        let named = at > 0 && (chars[at - 1].is_alphanumeric() || chars[at - 1] == '§');
        let unit = chars.get(end).is_some_and(|c| c.is_alphabetic());
        if word.matches('.').count() == 1 && !word.starts_with('.') && !named && !unit {
            found.push(word.to_string());
        }
        at = end;
    }
    found
}

/// Quoted decimals of `constants.toml`.
fn allowed() -> BTreeSet<String> {
    let text = read(&content().join("constants.toml"));
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("reason") && !line.starts_with('#'));
    lines.flat_map(|line| line.split('"').skip(1).step_by(2).map(String::from).collect::<Vec<_>>()).collect()
}

/// What a question's answer is held against: how far off it may be, and between what a figure's value must lie.
const BOUNDS: [&str; 4] = ["tolerance", "within", "least", "most"];

/// The decimals of a file, with their lines.
fn spelled_out(text: &str) -> Vec<(usize, String)> {
    let text = without(&without(text, "```", "```"), "{{", "}}");
    let mut found = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let line = without(&without(&without(line, "`", "`"), "](", ")"), "eq=\"", "\"");
        if !BOUNDS.iter().any(|bound| line.starts_with(bound)) && !line.starts_with('#') {
            found.extend(decimals(&line).into_iter().map(|decimal| (i + 1, decimal)));
        }
    }
    found
}

#[test]
fn every_decimal_in_the_prose_is_computed_or_given() {
    let allowed = allowed();
    let mut strays = Vec::new();
    let mut used = BTreeSet::new();
    for (file, text) in prose() {
        for (line, decimal) in spelled_out(&text) {
            if !allowed.contains(&decimal) {
                strays.push(format!("{}:{line}: {decimal}", file.display()));
            }
            used.insert(decimal);
        }
    }
    assert!(strays.is_empty(), "typed, and neither computed nor given:\n{}", strays.join("\n"));
    let idle: Vec<_> = allowed.difference(&used).collect();
    assert!(idle.is_empty(), "on the list of constants, and nowhere in the prose: {idle:?}");
}

#[test]
fn every_given_constant_has_its_reason() {
    let text = read(&content().join("constants.toml"));
    let count = |key: &str| text.lines().filter(|line| line.starts_with(key)).count();
    assert!(count("value ") > 0);
    assert_eq!(count("value "), text.matches("[[constant]]").count());
    assert_eq!(count("reason"), count("value ") + text.matches("\n[labels]").count());
    assert!(text.lines().filter(|line| line.starts_with("reason")).all(|line| line.len() > 30));
}

#[test]
fn a_stray_decimal_is_seen_and_a_name_is_not() {
    let found = |text: &str| spelled_out(text).into_iter().map(|(_, decimal)| decimal).collect::<Vec<_>>();
    assert_eq!(found("it is 0.482, or $-1.3$."), ["0.482", "1.3"]);
    assert_eq!(found("§8.2.6 and §8.2 and J.5.1, 30 of 31. `0.5` {{number a.b.11 .3f}}"), Vec::<String>::new());
    assert_eq!(spelled_out("a\n```\n1.5\n```\n2.5"), [(5, "2.5".to_string())]);
    assert_eq!(found("0.5$ s and 0.40 m, (8.24)"), ["0.5", "0.40", "8.24"]);
}
