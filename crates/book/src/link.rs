//! Checks the built site: every link leads to something, every id is given once, every tag is closed, and nothing is
//! fetched from other sites.

use std::collections::{BTreeMap, BTreeSet};

use html5gum::{DefaultEmitter, StartTag, Token, Tokenizer};

/// The ids and links of a page, and what is wrong with its tags.
#[derive(Debug, Default)]
struct Page {
    ids: BTreeSet<String>,
    /// Element, attribute, address.
    links: Vec<(String, String, String)>,
    faults: Vec<String>,
}

/// Elements that have no end.
const VOID: [&str; 8] = ["meta", "link", "br", "hr", "img", "input", "col", "wbr"];

/// Elements that may not stand in a paragraph.
const BLOCKS: [&str; 14] =
    ["p", "div", "figure", "section", "table", "ul", "ol", "dl", "details", "form", "blockquote", "h2", "h3", "pre"];

/// What is wrong with the site's pages, given by path and text; `files` are all paths there are.
pub fn faults(pages: &BTreeMap<String, String>, files: &BTreeSet<String>) -> Vec<String> {
    let parsed: BTreeMap<&str, Page> = pages.iter().map(|(path, text)| (path.as_str(), parse(text))).collect();
    let mut faults = Vec::new();
    for (path, page) in &parsed {
        faults.extend(page.faults.iter().map(|fault| format!("{path}: {fault}")));
        for (element, attribute, address) in &page.links {
            let fault = |what: &str| format!("{path}: <{element} {attribute}=\"{address}\"> {what}");
            if element == "#ref" {
                if !page.ids.contains(address) {
                    faults.push(format!("{path}: {attribute}=\"{address}\" names no element"));
                }
                continue;
            }
            if address.contains("://") || address.starts_with("mailto:") || address.starts_with("data:") {
                if element != "a" && !address.starts_with("data:") {
                    faults.push(fault("fetches from elsewhere"));
                }
                continue;
            }
            if address.starts_with('/') {
                faults.push(fault("is not relative: the site must work below any path"));
                continue;
            }
            let (file, id) = address.split_once('#').map_or((address.as_str(), None), |(file, id)| (file, Some(id)));
            // What stands behind a question mark is for the page's script.
            let target = resolve(path, file.split('?').next().unwrap_or(file));
            let target = match target.as_str() {
                "" => "index.html".to_string(),
                folder if folder.ends_with('/') => format!("{folder}index.html"),
                file => file.to_string(),
            };
            if !files.contains(&target) {
                faults.push(fault("leads nowhere"));
            } else if let (Some(id), Some(target)) = (id, parsed.get(target.as_str()))
                && !target.ids.contains(id)
            {
                faults.push(fault("names an id that is not there"));
            }
        }
    }
    faults
}

/// The path `address` leads to from the page at `path`.
fn resolve(path: &str, address: &str) -> String {
    if address.is_empty() {
        return path.to_string();
    }
    let folder = path.rfind('/').map_or("", |end| &path[..=end]);
    let mut parts = Vec::new();
    for part in folder.split_terminator('/').chain(address.split('/')) {
        match part {
            "." => {}
            ".." => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    // An address that ends in dots names a folder.
    if matches!(address.rsplit('/').next(), Some("." | "..")) && !parts.is_empty() {
        parts.push("");
    }
    parts.join("/")
}

fn parse(html: &str) -> Page {
    let mut page = Page::default();
    let mut open: Vec<String> = Vec::new();
    let mut emitter = DefaultEmitter::default();
    // What stands in a script or a style holds no tags.
    emitter.naively_switch_states(true);
    for Ok(token) in Tokenizer::new_with_emitter(html, emitter) {
        match token {
            Token::StartTag(tag) => {
                let name = text(&tag.name);
                attributes(&name, &tag, &mut page);
                let inside = |outer: &str| open.iter().any(|element| element == outer);
                if BLOCKS.contains(&name.as_str()) && inside("p") {
                    page.faults.push(format!("<{name}> stands in a paragraph"));
                }
                if name == "a" && (inside("a") || inside("button")) {
                    page.faults.push("a link in a link".into());
                }
                if !(VOID.contains(&name.as_str()) || tag.self_closing) {
                    open.push(name);
                }
            }
            Token::EndTag(tag) => {
                let (name, last) = (text(&tag.name), open.pop().unwrap_or_default());
                if name != last {
                    page.faults.push(format!("</{name}> closes <{last}>"));
                    return page;
                }
            }
            Token::Error(error) => page.faults.push(format!("HTML: {}", *error)),
            Token::String(_) | Token::Comment(_) | Token::Doctype(_) => {}
        }
    }
    if !open.is_empty() {
        page.faults.push(format!("not closed: {}", open.join(", ")));
    }
    page
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn attributes(name: &str, tag: &StartTag<()>, page: &mut Page) {
    for (key, value) in &tag.attributes {
        let (key, value) = (text(key), text(value));
        match key.as_str() {
            "id" if !page.ids.insert(value.clone()) => page.faults.push(format!("the id `{value}` stands twice")),
            "href" | "src" => page.links.push((name.to_string(), key, value)),
            "aria-labelledby" | "aria-describedby" | "for" => page.links.push(("#ref".into(), key, value)),
            _ if key.starts_with("on") => page.faults.push(format!("a handler in the page: {key}")),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(pages: &[(&str, &str)]) -> Vec<String> {
        let pages: BTreeMap<_, _> = pages.iter().map(|(path, text)| (path.to_string(), text.to_string())).collect();
        let files = pages.keys().cloned().collect();
        faults(&pages, &files)
    }

    #[test]
    fn a_sound_site_has_no_faults() {
        let pages = [
            ("index.html", "<p id=\"a\"><a href=\"kalman/?a=1#b\">x</a><br></p>"),
            (
                "kalman/index.html",
                "<p id=\"b\"><a href=\"../\">x</a> <a href=\"#b\">y</a> <a href=\"https://x.org\">z</a></p>",
            ),
        ];
        assert_eq!(check(&pages), Vec::<String>::new());
    }

    #[test]
    fn a_script_inside_a_page_is_not_read_as_markup() {
        let page = "<style>a > b {}</style><script>for (i = 0; i<n; i++) { s = '<p href=\"x\">' }</script><p></p>";
        assert_eq!(check(&[("index.html", page)]), Vec::<String>::new());
        assert!(!check(&[("index.html", "<script>1<2")]).is_empty());
    }

    #[test]
    fn every_kind_of_fault_is_found() {
        let cases = [
            ("<a href=\"x.html\">x</a>", "leads nowhere"),
            ("<a href=\"#x\">x</a>", "not there"),
            ("<a href=\"/x\">x</a>", "not relative"),
            ("<p id=\"a\"></p><p id=\"a\"></p>", "stands twice"),
            ("<script src=\"https://cdn.x/y.js\"></script>", "elsewhere"),
            ("<p><div></div></p>", "in a paragraph"),
            ("<p><em></p>", "closes"),
            ("<p>", "not closed"),
            ("<a href=\"#a\" id=\"a\"><a href=\"#a\">x</a></a>", "a link in a link"),
            ("<p onclick=\"x\"></p>", "handler"),
            ("<p title=\"a\" title=\"b\"></p>", "HTML: duplicate-attribute"),
        ];
        for (html, expected) in cases {
            let faults = check(&[("index.html", html)]);
            assert!(faults.iter().any(|fault| fault.contains(expected)), "{expected} in {faults:?}");
        }
    }
}
