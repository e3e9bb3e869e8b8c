//! Each `fixtures/pages/*.md` renders to the `.html` beside it, formulas shortened to `[…]`.
//! `UPDATE_SNAPSHOTS=1 cargo test -p book --test snapshots` writes them anew; read the difference before you keep it.

mod common;

/// Every formula as the MathML's letters in brackets.
fn shorten(html: &str) -> String {
    let mut out = String::new();
    let mut rest = html;
    while let Some(start) = rest.find("<math") {
        // KaTeX opens up to three spans before the MathML, and its visible half follows.
        let opening = rest[..start].rfind("<span class=\"katex\">").expect("KaTeX's span");
        let opening = rest[..opening].strip_suffix("<span class=\"katex-display\">").map_or(opening, str::len);
        let end = start + rest[start..].find("</math>").expect("the end of the MathML");
        let letters: String =
            rest[start..end].split('<').filter_map(|part| part.split_once('>')).map(|(_, text)| text).collect();
        out += &rest[..opening];
        out += &format!("[{letters}]");
        let mut depth = rest[opening..end].matches("<span").count();
        let mut at = end;
        while depth > 0 {
            let close = at + rest[at..].find("</span>").expect("a closed span");
            depth += rest[at..close].matches("<span").count();
            depth -= 1;
            at = close + "</span>".len();
        }
        rest = &rest[at..];
    }
    out + rest
}

#[test]
fn every_page_renders_as_it_did() {
    let folder = common::fixtures().join("pages");
    let update = std::env::var_os("UPDATE_SNAPSHOTS").is_some();
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("fixtures").flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|extension| extension != "md") {
            continue;
        }
        count += 1;
        let (body, errors) = common::render(&std::fs::read_to_string(&path).expect("a page"));
        assert_eq!(errors, "", "{}", path.display());
        let actual = shorten(&body);
        let expected = path.with_extension("html");
        if update {
            std::fs::write(&expected, &actual).expect("written");
        }
        let expected = std::fs::read_to_string(expected).unwrap_or_default();
        assert_eq!(actual, expected, "{}", path.display());
    }
    assert_eq!(count, 5);
}
