//! Checks the built site: every link leads to something, every id is given once, every tag is closed, and nothing is fetched
//! from other sites.

use std::collections::{BTreeMap, BTreeSet};

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
            let target = resolve(path, file);
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
    let mut parts: Vec<&str> = path.split('/').collect();
    parts.pop();
    for part in address.split('/') {
        match part {
            "." => {}
            ".." => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    let joined = parts.join("/");
    if (address == ".." || address == "." || address.ends_with("/..")) && !joined.is_empty() {
        format!("{joined}/")
    } else {
        joined
    }
}

fn parse(html: &str) -> Page {
    let mut page = Page::default();
    let mut open: Vec<String> = Vec::new();
    let mut rest = html;
    while let Some(start) = rest.find('<') {
        rest = &rest[start + 1..];
        if let Some(comment) = rest.strip_prefix("!--") {
            rest = comment.find("-->").map_or("", |end| &comment[end + 3..]);
            continue;
        }
        let end = tag_end(rest);
        let tag = &rest[..end];
        rest = rest.get(end + 1..).unwrap_or("");
        if tag.starts_with('!') || tag.starts_with('?') {
            continue;
        }
        if let Some(name) = tag.strip_prefix('/') {
            let name = name.trim();
            match open.pop() {
                Some(last) if last == name => {}
                last => {
                    page.faults.push(format!("</{name}> closes <{}>", last.unwrap_or_default()));
                    return page;
                }
            }
            continue;
        }
        let name = tag.split([' ', '\n', '/']).next().unwrap_or_default().to_string();
        attributes(&name, tag, &mut page);
        let inside = |outer: &str| open.iter().any(|element| element == outer);
        if BLOCKS.contains(&name.as_str()) && inside("p") {
            page.faults.push(format!("<{name}> stands in a paragraph"));
        }
        if name == "a" && (inside("a") || inside("button")) {
            page.faults.push(format!("a link in a link: <{tag}>"));
        }
        if !(VOID.contains(&name.as_str()) || tag.ends_with('/')) {
            // A script or a style holds no tags.
            if name == "script" || name == "style" {
                rest = rest.find(&format!("</{name}>")).map_or("", |end| &rest[end..]);
            }
            open.push(name);
        }
    }
    if !open.is_empty() {
        page.faults.push(format!("not closed: {}", open.join(", ")));
    }
    page
}

/// The end of a tag, quotes respected.
fn tag_end(text: &str) -> usize {
    let mut quote = None;
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (None, '>') => return at,
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if c == open => quote = None,
            _ => {}
        }
    }
    text.len()
}

fn attributes(name: &str, tag: &str, page: &mut Page) {
    let mut rest = tag;
    while let Some(at) = rest.find("=\"") {
        let key = rest[..at].rsplit([' ', '\n']).next().unwrap_or_default().to_string();
        let value = &rest[at + 2..];
        let end = value.find('"').unwrap_or(value.len());
        let text = value[..end].replace("&amp;", "&").replace("&quot;", "\"").replace("&#39;", "'");
        rest = value.get(end + 1..).unwrap_or("");
        match key.as_str() {
            "id" if !page.ids.insert(text.clone()) => page.faults.push(format!("the id `{text}` stands twice")),
            "href" | "src" => page.links.push((name.to_string(), key, text)),
            "aria-labelledby" | "aria-describedby" | "for" => page.links.push(("#ref".into(), key, text)),
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
            ("index.html", "<p id=\"a\"><a href=\"kalman/#b\">x</a><br></p>"),
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
        ];
        for (html, expected) in cases {
            let faults = check(&[("index.html", html)]);
            assert!(faults.iter().any(|fault| fault.contains(expected)), "{expected} in {faults:?}");
        }
    }
}
