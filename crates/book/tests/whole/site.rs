//! The book itself: it builds, nothing in it leads astray, and its numbers move with what they are computed from.

use std::collections::BTreeSet;

use book::Diagnostics;
use chapter_kalman::{givens::Givens, numbers::numbers};

use crate::{DIST, load, root};

#[test]
fn every_link_leads_somewhere_and_nothing_is_fetched_from_elsewhere() {
    let faults = DIST.faults();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_page_carries_the_policy_and_no_script_of_its_own() {
    for (path, html) in DIST.pages() {
        assert!(html.contains("http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';"), "{path}");
        assert!(!html.contains("<style"), "{path}");
        for script in html.split("<script").skip(1) {
            assert!(
                script.split('>').next().is_some_and(|tag| tag.contains("src=\"")),
                "{path} has a script of its own"
            );
        }
        assert_eq!(html.matches("<h1").count(), 1, "{path}");
        assert!(html.contains("<html lang=\"en\""), "{path}");
    }
}

#[test]
fn formulas_carry_mathml_and_their_drawing_is_hidden_from_readers() {
    let html = &DIST.pages()["kalman/index.html"];
    let formulas = html.matches("<span class=\"katex\"><math").count();
    assert!(formulas > 400, "{formulas}");
    assert_eq!(html.matches("<math").count(), formulas);
    let drawn = |tag: &str| tag.starts_with("<span class=\"katex-html") && tag.ends_with(" aria-hidden=\"true\"");
    assert_eq!(
        html.split('>').filter_map(|piece| piece.rfind('<').map(|at| &piece[at..])).filter(|tag| drawn(tag)).count(),
        formulas
    );
    // Formulas of one symbol are text that is drawn and read alike.
    let symbols = html.matches("class=\"katex\"").count() - formulas;
    assert!(symbols > 200, "{symbols}");
}

#[test]
fn every_question_is_asked_and_every_work_is_cited() {
    let diagnostics = Diagnostics::default();
    let site = load(numbers(&Givens::default()).expect("computed"), &diagnostics);
    let pages = book::pages(&root(), &site.config.chapters[0]).expect("the chapter is there");
    let texts = book::texts(&site, &pages, Some(15), &diagnostics);
    let mut asked: BTreeSet<_> = texts.iter().flat_map(|text| text.used.quizzes.clone()).collect();
    let mut works: BTreeSet<_> = texts.iter().flat_map(|text| text.used.references.clone()).collect();
    for page in &site.config.pages {
        let path = format!("content/pages/{}.md", page.slug);
        let file = (path.clone(), std::fs::read_to_string(root().join(&path)).expect("the page is there"));
        let used = book::text(&site, &[file], None, &format!("{}/", page.slug), &diagnostics).used;
        asked.extend(used.quizzes);
        works.extend(used.references);
    }
    let never: Vec<_> = site.quizzes.keys().filter(|id| !asked.contains(*id)).collect();
    assert!(never.is_empty(), "never asked: {never:?}");
    let cited: Vec<_> = site.references.keys().filter(|key| !works.contains(*key)).collect();
    assert!(cited.is_empty(), "never cited: {cited:?}");
}

#[test]
fn every_computed_number_of_the_page_says_where_it_comes_from() {
    let html = &DIST.pages()["kalman/numbers/index.html"];
    let entries = html.matches("class=\"number-entry\"").count();
    assert!(entries > 100, "{entries}");
    assert_eq!(html.matches("class=\"number-source\"").count(), entries);
}

/// The chapter's hand-worked steps, rendered from `givens`: each number with its digits.
fn hand_steps(givens: &Givens) -> BTreeSet<String> {
    let diagnostics = Diagnostics::default();
    let site = load(numbers(givens).expect("computed"), &diagnostics);
    let files = book::files(&root(), "content/kalman").expect("the chapter is there");
    let files: Vec<_> = files.into_iter().filter(|(path, _)| path.contains("hand-steps")).collect();
    assert_eq!(files.len(), 1);
    let body = book::text(&site, &files, Some(15), "kalman/", &diagnostics).body;
    // A number names its entry in `data-number`, or in its address where it is a link.
    let body = body.replace("href=\"numbers/#number-", "data-number=\"");
    let digits = |part: &str| {
        let (id, rest) = part.split_once('"')?;
        // In a formula the digits are in spans of their own.
        let end = rest.find("</a>").filter(|end| *end < 60).unwrap_or(rest.len().min(400));
        let text: String =
            rest[..end].split('<').filter_map(|piece| piece.split_once('>')).map(|(_, text)| text).collect();
        Some(format!("{id} {}", text.split_whitespace().next().unwrap_or_default()))
    };
    body.split("data-number=\"").skip(1).filter_map(digits).collect()
}

#[test]
fn the_page_moves_with_a_matrix_a_reading_and_the_first_belief() {
    let before = hand_steps(&Givens::default());
    assert!(before.len() > 20, "{before:?}");
    let moved = |change: fn(&mut Givens)| {
        let mut givens = Givens::default();
        change(&mut givens);
        let after = hand_steps(&givens);
        let changed: BTreeSet<String> =
            before.difference(&after).filter_map(|line| line.split(' ').next()).map(String::from).collect();
        changed
    };
    let matrix = moved(|givens| givens.velocity.f[(0, 1)] = 0.6);
    assert!(matrix.contains("step1.P.11") && matrix.contains("step2.P.11"), "{matrix:?}");
    let reading = moved(|givens| givens.readings[1] += 0.1);
    assert!(reading.contains("step2.x.1") && !reading.contains("step1.x.1"), "{reading:?}");
    let belief = moved(|givens| givens.belief.p[(1, 1)] = 3.0);
    assert!(belief.contains("step1.R.1") && belief.contains("step1.S"), "{belief:?}");
}

#[test]
fn each_widget_has_a_page_that_leads_back_to_its_place() {
    let pages = DIST.pages();
    for figure in labs::FIGURES {
        let (widget, tag) = (figure.name(), figure.tag());
        let html = &pages[&format!("figure/{widget}/index.html")];
        assert_eq!(html.matches(&format!("<{tag} class=\"widget\"")).count(), 1, "{widget}");
        let id = html.split("data-figure=\"").nth(1).and_then(|rest| rest.split('"').next()).unwrap_or_default();
        let place = html.split("<a href=\"../../").nth(1).and_then(|rest| rest.split_once(&format!("#{id}\">")));
        let (page, _) = place.unwrap_or_else(|| panic!("{widget}: no link to {id}"));
        let page = format!("{page}index.html");
        assert!(pages[&page].contains(&format!("data-figure=\"{id}\"")), "{widget}: {id} in {page}");
        assert_eq!(html.matches("<a ").count(), 1, "{widget}: its caption has no links of its own");
    }
}
