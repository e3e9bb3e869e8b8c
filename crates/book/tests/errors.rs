//! What is wrong with a page is said with its file and line.

mod common;

/// Each text with a complaint it must draw.
const CASES: [(&str, &str); 40] = [
    ("a\n\n:::nothing\n:::\n", "page.md:3: unknown directive `:::nothing`"),
    ("a\n\n:::margin\nb\n", "page.md:3: `:::margin` is not closed"),
    ("a\n\n:::\n", "page.md:3: `:::` closes nothing"),
    (":::figure{#f}\n:::\n", "page.md:1: `:::figure` needs `widget`"),
    (":::figure{#f widget=\"x\"}\n:::\n", "page.md:1: no widget is called `x`"),
    (":::figure{#f widget=\"observer-bench\" start='x'}\n:::\n", "page.md:1: `start` is no JSON object"),
    (":::margin{kind=\"x\"}\n:::\n", "page.md:1: `:::margin` has no `kind`"),
    (":::note{kind=\"x\"}\n:::\n", "page.md:1: no note is of kind `x`"),
    (":::note{kind=\"aside}\n:::\n", "page.md:1: a quote is not closed"),
    ("::step[a]\n", "page.md:1: `::step` stands in a derivation"),
    ("::leap[a]\n", "page.md:1: unknown directive `::leap`"),
    (":::derivation{#d title=\"t\"}\n::after[x]\n:::\n", "page.md:2: `::after` follows the steps"),
    (":::hint\nx\n:::\n", "page.md:1: `:::hint` stands in an exercise"),
    (
        ":::exercise{#e title=\"t\" kind=\"x\" difficulty=\"9\"}\n:::\n",
        "page.md:1: difficulty is 1, 2, 3 or 4, not `9`",
    ),
    ("a\n{{number nope .3f}}\n", "page.md:2: unknown number `nope`"),
    ("{{number step1.nope .3f}}\n", "there are step1.S, step1.nu"),
    ("{{number step1.S 3f}}\n", "page.md:1: unknown number format `3f`"),
    ("{{number step1.S int}}\n", "page.md:1: 2.6 is not a whole number"),
    ("{{number step1.S}}\n", "needs an id and a format"),
    ("$x = {{number nope .3f}}$\n", "page.md:1: unknown number `nope`"),
    ("{{nope x}}\n", "page.md:1: unknown directive `{{nope}}`"),
    ("{{ref nope}}\n", "page.md:1: nothing here has the id `nope`"),
    ("[a](#nope)\n", "page.md:1: nothing here has the id `nope`"),
    ("[@nope]\n", "page.md:1: unknown citation `@nope`"),
    ("[a]{.term key=\"nope\"}\n", "page.md:1: unknown glossary key `nope`"),
    ("[a]{.nope}\n", "page.md:1: unknown class `.nope`"),
    ("[**a.**]{#id}\n", "page.md:1: `**` makes nothing bold here"),
    ("{{listing crates/nope.rs#a}}\n", "page.md:1: no source `crates/nope.rs`"),
    ("a\n\n{{listing crates/demo/src/lib.rs#nope}}\n", "page.md:3: no anchor `nope` in crates/demo/src/lib.rs"),
    ("{{output nope}}\n", "page.md:1: no output of `nope`"),
    (":::quiz{id=\"nope\"}\n:::\n", "page.md:1: unknown quiz `nope`"),
    (
        ":::figure{#fig-bench widget=\"observer-bench\"}\n:::\n:::quiz{id=\"foot\"}\n:::\n:::quiz{id=\"foot\"}\n:::\n",
        "page.md:5: the id `quiz-foot` is taken by page.md:3",
    ),
    (":::quiz{id=\"foot\"}\n:::\n", "content/quizzes/feet.toml:6: nothing here has the id `fig-bench`"),
    ("## A {#a}\n\n## B {#a}\n", "page.md:3: the id `a` is taken by page.md:1"),
    ("## A\n", "page.md:1: this heading has no {#id}"),
    ("# A {#a}\n", "page.md:1: headings of a page are ##, ### or ####"),
    ("a\n$\\nonsense$\n", "page.md:2: TeX:"),
    ("a\nb $c\n", "page.md:2: `$` is not closed"),
    (":::contents{page=\"nope\"}\n:::\n", "page.md:1: no part of this chapter is called `nope`"),
    ("a <b>c</b>\n", "page.md:1: raw HTML `<b>`"),
];

#[test]
fn every_fault_is_reported_where_it_stands() {
    for (markdown, expected) in CASES {
        let (_, errors) = common::render(markdown);
        assert!(errors.contains(expected), "{markdown:?} should say\n  {expected}\nand says\n  {errors}");
    }
}

#[test]
fn faults_are_reported_together() {
    let (_, errors) = common::render("{{ref a}}\n\n{{ref b}}\n\n{{ref c}}\n");
    assert!(errors.ends_with("3 errors in the content"), "{errors}");
}
