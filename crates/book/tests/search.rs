//! The search knows the words of a page, section by section.

mod common;

use book::Diagnostics;

#[test]
fn a_section_is_found_by_its_words_and_symbols_and_by_no_tag() {
    let markdown = "## First $x^2$ {#first}\n\nLet $\\F$ be *one*'s & {{number step1.S .1f}}, `code`.\n\n$$\ny = x\n\
        $$\n\n\
        ## Second {#second}\n\n:::note{kind=\"aside\" title=\"Aside\"}\nNext.\n:::\n";
    let diagnostics = Diagnostics::default();
    let site = common::site(&diagnostics);
    let file = ("page.md".to_string(), markdown.to_string());
    let found = book::text(&site, &[file], Some(7), "one/", &diagnostics).search;
    let found: Vec<_> =
        found.iter().map(|found| (found.id.as_str(), found.title.as_str(), found.text.as_str())).collect();
    let first = ("one/#first", "First x²", "Let F be one’s & 2.6, code. y = x");
    assert_eq!(found, [first, ("one/#second", "Second", "Aside Next.")]);
}

#[test]
fn the_page_of_a_figure_has_choset_s_letters_and_no_links() {
    let markdown = ":::figure{#fig widget=\"observer-bench\" title=\"Turn $\\F$\" start='{\"step\": 2}'}\n\
        See {{ref fig}}, [the prediction]{.prediction} and $\\F^2 = {{number step1.S .1f}}$.\n:::\n";
    let diagnostics = Diagnostics::default();
    let site = common::site(&diagnostics);
    let file = ("page.md".to_string(), markdown.to_string());
    let figures = book::text(&site, &[file], Some(7), "one/", &diagnostics).figures;
    let [figure] = figures.as_slice() else { panic!("one figure: {figures:?}") };
    assert_eq!((figure.id.as_str(), figure.widget.as_str(), figure.name.as_str()), ("fig", "observer-bench", "Turn F"));
    assert_eq!((figure.label.as_str(), figure.start.as_deref()), ("Figure\u{a0}1", Some("{\"step\": 2}")));
    assert!(figure.caption.contains("<span class=\"ref\">Figure\u{a0}1</span>"), "{}", figure.caption);
    assert!(!figure.caption.contains("<a ") && !figure.caption.contains("data-other"), "{}", figure.caption);
}

#[test]
fn code_is_found_apart_from_the_text() {
    let markdown =
        "## One {#one}\n\nBefore `x`.\n\n{{listing crates/demo/src/lib.rs#half}}\n\n```sh\nserve it\n```\n\nAfter.\n";
    let diagnostics = Diagnostics::default();
    let site = common::site(&diagnostics);
    let file = ("page.md".to_string(), markdown.to_string());
    let found = book::text(&site, &[file], Some(7), "one/", &diagnostics).search;
    let [section] = found.as_slice() else { panic!("one section: {found:?}") };
    assert_eq!(section.text, "Before x. After.");
    assert!(section.code.starts_with("crates/demo/src/lib.rs ") && section.code.contains("pub fn"), "{}", section.code);
    assert!(section.code.ends_with("serve it"), "{}", section.code);
}

#[test]
fn no_line_breaks_between_a_number_and_its_unit() {
    let markdown =
        "## One {#one}\n\nA bias of 0.5 % over 30 cm, {{number step1.S .1f}} m, at $2$ s; in 2 ways, “30 s”.\n";
    let diagnostics = Diagnostics::default();
    let site = common::site(&diagnostics);
    let file = ("page.md".to_string(), markdown.to_string());
    let html = book::text(&site, &[file], Some(7), "one/", &diagnostics).body;
    for bound in ["0.5\u{a0}%", "30\u{a0}cm,", "\u{a0}m, at", "\u{a0}s;", "30\u{a0}s”"] {
        assert!(html.contains(bound), "{bound}: {html}");
    }
    assert!(html.contains("in 2 ways"));
}
