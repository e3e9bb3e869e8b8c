//! A small site that the tests render: its data files are fixtures, its numbers, sources and stills are set here.

use std::path::{Path, PathBuf};

use book::{Apart, Diagnostics, Number, Outputs, Site, Still, Stills};
use lab::Check;

/// The folder of fixtures.
pub fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures")
}

/// The small site.
pub fn site(diagnostics: &Diagnostics) -> Site {
    let number = |id: &str, value, check| Number {
        id: id.into(),
        value,
        about: "a number.".into(),
        source: "demo::half".into(),
        check,
    };
    let numbers = [
        number("step1.nu", -1.3, Some(1)),
        number("step1.S", 2.6, Some(1)),
        number("step3.P.11", 1.8729851418280055, None),
        number("step3.S", 1.0, None),
        number("share", 0.00945, None),
    ];
    let apart = Apart::new("observer-bench", "<img src=\"picture.svg#phase\" alt=\"\">".into(), "<svg></svg>".into());
    let still = Still { svg: "<svg viewBox=\"0 0 4 3\"></svg>".into(), words: "A still.".into(), apart: Some(apart) };
    let stills: Stills = [("observer-bench".to_string(), still)].into();
    let outputs = Outputs::fixed([("demo", "x < 1\n")]);
    let root = fixtures().join("site");
    let mut site = Site::load(&root, numbers.into_iter().collect(), labs::FIGURES, outputs, stills, diagnostics)
        .expect("the fixtures are there");
    let source = "//! Demo.\n\n// ANCHOR: half\n/// Half of `x`.\npub fn half(x: f64) -> f64 {\n    x / 2.0\n}\n\
        // ANCHOR_END: half\n";
    site.checks = [1, 7].map(|id| Check::new(id, "A check", vec![1.0], vec![1.0], 0.0)).into();
    site.sources.insert("crates/demo/src/lib.rs", source);
    site
}

/// `markdown` as the only file of a chapter: its body, and the complaints.
#[allow(dead_code)] // not every test renders a page
pub fn render(markdown: &str) -> (String, String) {
    let diagnostics = Diagnostics::default();
    let site = site(&diagnostics);
    let file = ("page.md".to_string(), markdown.to_string());
    let text = book::text(&site, &[file], Some(7), "one/", &diagnostics);
    let errors = diagnostics.check().err().map(|error| error.to_string()).unwrap_or_default();
    (text.body + &text.numbers, errors)
}
