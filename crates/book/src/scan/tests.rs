use super::*;
use crate::piece::{NumberRef, Tex};

fn scanned(text: &str) -> (Scanned, Vec<String>) {
    let diagnostics = Diagnostics::default();
    let scanned = scan(text, &Place::new("a.md", 1), &diagnostics);
    let errors = match diagnostics.check() {
        Err(crate::BuildError::Content(list)) => list.iter().map(ToString::to_string).collect(),
        _ => Vec::new(),
    };
    (scanned, errors)
}

fn pieces(text: &str) -> Vec<Piece> {
    let (scanned, errors) = scanned(text);
    assert_eq!(errors, Vec::<String>::new());
    let piece = |(mark, _)| match mark {
        Mark::Piece(piece) => Some(piece),
        _ => None,
    };
    scanned.marks.into_iter().filter_map(piece).collect()
}

#[test]
fn a_formula_keeps_its_bars_and_its_numbers() {
    let (scanned, _) = scanned("| a | $x(k \\mid k) = |y|$ |\n");
    assert_eq!(scanned.text, "| a | \u{e000}0\u{e001} |\n");
    let number = NumberRef { id: "step1.S".into(), format: ".1f".into() };
    let tex = vec![Tex::Source("S = ".into()), Tex::Number(number.clone()), Tex::Source(String::new())];
    assert_eq!(pieces("$S = {{number step1.S .1f}}$"), [Piece::Math(tex)]);
    assert_eq!(pieces("{{number step1.S .1f}}"), [Piece::Number(number)]);
}

#[test]
fn code_is_left_alone_and_a_dollar_can_be_escaped() {
    assert_eq!(pieces("`{{number x .1f}} $x$` costs \\$5\n\n```\n:::note\n$x$\n```\n"), []);
}

#[test]
fn lines_are_counted_through_display_math_and_spans() {
    let (scanned, _) = scanned("one\n$$\na\n$$\n[two\nlines]{.term key=\"x\"} $z$\n");
    let lines: Vec<_> = scanned.marks.iter().map(|(_, place)| place.line).collect();
    assert_eq!(lines, [2, 5, 5, 6]);
    assert_eq!(scanned.lines, [1, 2, 5, 6]);
}

#[test]
fn directives_name_their_errors() {
    let (_, errors) = scanned("ok\n\n{{nothing x}} and [@a] and $open\n\n::leap[x]\n");
    assert_eq!(errors.len(), 3, "{errors:?}");
    assert!(errors[0].starts_with("a.md:3: "), "{errors:?}");
    assert!(errors[2].starts_with("a.md:5: unknown directive `::leap`"), "{errors:?}");
}

#[test]
fn citations_and_links_are_told_apart() {
    assert_eq!(pieces("[text](#id) [^1]"), []);
    assert_eq!(pieces("[@a, §8.2; @b]"), [Piece::Cite(vec![("a".into(), Some("§8.2".into())), ("b".into(), None)])]);
}
