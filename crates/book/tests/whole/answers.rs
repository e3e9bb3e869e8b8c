//! A book built without answers: none of its files holds the words of one, or a number that only an answer has.

use book::Diagnostics;
use std::collections::BTreeSet;

use crate::{DIST, NUMBERS, build, load, root};

/// Words with one space between them.
fn flat(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Long runs of plain words in Markdown: what no formula, number or mark interrupts, so that HTML shows it as it is.
fn runs(markdown: &str) -> Vec<String> {
    let parts = markdown.split(|c: char| !(c.is_ascii_alphanumeric() || " \n,.;:".contains(c)));
    parts.map(flat).filter(|run| run.len() > 30 && run.contains(' ')).collect()
}

/// The questions of `content/quizzes/`.
fn questions() -> Vec<toml::Value> {
    let files = std::fs::read_dir(root().join("content/quizzes")).expect("questions");
    let read = |file: std::io::Result<std::fs::DirEntry>| {
        let text = std::fs::read_to_string(file.expect("an entry").path()).expect("a file of questions");
        let mut table: toml::Table = text.parse().expect("questions");
        let Some(toml::Value::Array(quizzes)) = table.remove("quiz") else { panic!("no questions") };
        quizzes
    };
    files.flat_map(read).collect()
}

/// The words of the answers: reasons and explanations of the questions, and worked answers of the exercises.
fn words_of_answers() -> Vec<String> {
    let mut words = Vec::new();
    for quiz in &questions() {
        words.extend(runs(quiz["why"].as_str().expect("a reason")));
        for kind in ["choice", "near", "condition"] {
            for part in quiz.get(kind).and_then(toml::Value::as_array).into_iter().flatten() {
                words.extend(part.get("why").and_then(toml::Value::as_str).into_iter().flat_map(runs));
            }
        }
    }
    let parts = ["content/kalman", "content/kalman/exercises"].map(|folder| book::files(&root(), folder));
    for (_, text) in parts.into_iter().flat_map(|files| files.expect("the chapter")) {
        for answer in text.split(":::answer").skip(1) {
            words.extend(runs(answer.split("\n:::").next().unwrap_or_default()));
        }
    }
    words
}

/// What a page shows, without its tags: colours part the words of code.
fn shown(html: &str) -> String {
    let text: String = html.split('<').map(|part| part.split_once('>').map_or(part, |(_, text)| text)).collect();
    flat(
        &text
            .replace("&lt;", "<")
            .replace("&gt;", ">")
            .replace("&quot;", "\"")
            .replace("&#x27;", "'")
            .replace("&amp;", "&"),
    )
}

/// The lines of code that solve an exercise and stand nowhere else in its file, by the file's path.
fn code_of_answers(site: &book::Site) -> Vec<(String, String)> {
    let mut lines = Vec::new();
    for (path, text) in site.sources.iter().filter(|(_, text)| text.contains("// ANCHOR: answer")) {
        let answer = site.sources.listing(path, Some("answer")).expect("an answer").code;
        let long = answer.lines().map(str::trim).filter(|line| line.len() > 20 && text.matches(line).count() == 1);
        lines.extend(long.map(|line| (path.to_string(), line.to_string())));
    }
    lines
}

#[test]
fn a_book_without_answers_holds_no_word_of_them_and_no_number_that_only_they_have() {
    let diagnostics = Diagnostics::default();
    let mut site = load(NUMBERS.clone(), &diagnostics);
    let pages = book::pages(&root(), &site.config.chapters[0]).expect("the chapter");
    let words = words_of_answers();
    // The words are found where they are: otherwise finding none of them would say nothing. (A list or a table parts
    // some.)
    let bodies = book::texts(&site, &pages, Some(15), &diagnostics).into_iter().map(|text| text.body);
    let whole = flat(&bodies.collect::<String>());
    let found = words.iter().filter(|run| whole.contains(run.as_str())).count();
    assert!(words.len() > 100 && found > words.len() * 3 / 4, "{found} of {}", words.len());

    let code = code_of_answers(&site);
    let page = |path: &str| format!("source/{path}.html");
    assert!(code.len() > 10, "{code:?}");
    for (path, line) in &code {
        let html = String::from_utf8(DIST.files[&page(path)].clone()).expect("text");
        assert!(shown(&html).contains(line), "the whole book shows {line}");
    }

    site.answers = false;
    let dist = build(&site, &diagnostics);
    assert!(dist.faults().is_empty(), "{}", dist.faults().join("\n"));

    let texts = ["kalman/index.html", "kalman/exercises/index.html"].map(|path| dist.files[path].clone());
    let chapter = String::from_utf8(texts.concat()).expect("text");
    assert!(chapter.matches("class=\"quiz-open\"").count() > 10, "the questions are asked");
    for left in ["data-key", "data-score", "quiz-answer", "Worked answer", "data-unlocks"] {
        assert!(!chapter.contains(left), "{left}");
    }
    for (path, bytes) in &dist.files {
        let Ok(text) = std::str::from_utf8(bytes) else { continue };
        let visible = if path.ends_with(".html") { shown(text) } else { String::new() };
        for (_, line) in &code {
            assert!(!visible.contains(line), "{path} shows {line}");
        }
        let text = flat(text);
        for run in &words {
            assert!(!text.contains(run), "{path} says: {run}");
        }
    }

    // A number that the questions ask for, and that the text does not print besides, is listed nowhere.
    let used: BTreeSet<_> =
        book::texts(&site, &pages, Some(15), &diagnostics).into_iter().flat_map(|text| text.used.numbers).collect();
    let questions = questions();
    let asked = questions.iter().filter_map(|quiz| quiz.get("answer"));
    let asked = asked.filter_map(toml::Value::as_str).flat_map(|ids| ids.split(',')).map(str::trim);
    let hidden: Vec<_> = asked.filter(|id| !used.contains(*id)).collect();
    assert!(hidden.len() > 5, "{hidden:?}");
    for (path, bytes) in &dist.files {
        let Ok(text) = std::str::from_utf8(bytes) else { continue };
        for id in &hidden {
            assert!(!text.contains(&format!("number-{id}\"")), "{path} lists {id}");
        }
    }
}
