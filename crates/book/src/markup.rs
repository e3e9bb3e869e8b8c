//! The markup of a formula as a tree: well-formed spans and MathML, read, changed and written.

use std::collections::HashMap;
use std::fmt::Write;
use std::sync::LazyLock;

use roxmltree::Document;

use crate::html::{escape, escape_text};

/// An element or a text of KaTeX's markup, which is XML.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A tag and what it holds.
    Element(Element),
    /// Text.
    Text(String),
}

/// A tag, its attributes and what it holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Element {
    /// Its tag's name.
    pub name: String,
    /// Its classes.
    pub classes: Vec<String>,
    /// Declarations of its `style`.
    pub style: Vec<(String, String)>,
    /// Other attributes as they stood.
    pub rest: Vec<(String, String)>,
    /// What stands in it.
    pub children: Vec<Node>,
}

impl Node {
    /// The element, if it is one.
    pub fn element(&self) -> Option<&Element> {
        match self {
            Self::Element(element) => Some(element),
            Self::Text(_) => None,
        }
    }
}

impl Element {
    /// Whether it is of a class.
    pub fn has(&self, class: &str) -> bool {
        self.classes.iter().any(|own| own == class)
    }

    /// A declaration of its style.
    pub fn get(&self, property: &str) -> Option<&str> {
        self.style.iter().find(|(name, _)| name == property).map(|(_, value)| value.as_str())
    }

    /// Adds to a margin.
    pub fn widen(&mut self, side: &str, width: f64) {
        match self.style.iter_mut().find(|(name, _)| name == side) {
            Some((_, value)) => *value = length(em(value).unwrap_or_default() + width),
            None => self.style.push((side.into(), length(width))),
        }
    }

    /// Whether it is italic letters without any attribute, so that further letters can join it.
    pub fn is_letters(&self) -> bool {
        self.name == "i" && self.classes.is_empty() && self.rest.is_empty() && self.style.is_empty()
    }

    /// Whether it has no attribute but a margin behind it, so that it can join the letters before it.
    pub fn only_widens(&self) -> bool {
        self.classes.is_empty() && self.rest.is_empty() && self.style.iter().all(|(name, _)| name == "margin-right")
    }
}

/// The number of ems in `value`.
pub fn em(value: &str) -> Option<f64> {
    value.strip_suffix("em")?.parse().ok()
}

/// A length in ems.
pub fn length(value: f64) -> String {
    format!("{value}em")
}

/// A length in ems as the page has it: to two decimals, which is a tenth of a pixel, and without a zero before the
/// point.
fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "0" | "-0" => "0".into(),
        _ => format!("{}em", text.replacen("0.", ".", usize::from(text.trim_start_matches('-').starts_with("0.")))),
    }
}

/// The classes that `formulas.css` has for styles that many elements have, by style.
static CLASSES: LazyLock<HashMap<String, &str>> = LazyLock::new(|| {
    let rule = |rule: &'static str| {
        let rule = rule.rsplit("*/").next()?.trim();
        rule.strip_prefix('.')?.strip_suffix(" !important;")?.split_once(" {\n  ")
    };
    let rules = include_str!("../../../web/style/formulas.css").split('}').filter_map(rule);
    // As `short` writes a length.
    let short = |style: &str| style.replacen(": ", ":", 1).replacen(":0.", ":.", 1).replacen(":-0.", ":-.", 1);
    rules.map(|(class, style)| (short(style), class)).collect()
});

/// The nodes of `html`, which is well formed as XML is.
///
/// # Errors
/// A message when it is not.
pub fn parse(html: &str) -> Result<Vec<Node>, String> {
    let html = format!("<formula>{html}</formula>");
    let document = Document::parse(&html).map_err(|error| format!("the markup of a formula: {error}"))?;
    Ok(document.root_element().children().map(node).collect())
}

fn node(read: roxmltree::Node<'_, '_>) -> Node {
    if !read.is_element() {
        return Node::Text(read.text().unwrap_or_default().into());
    }
    let mut element = Element { name: read.tag_name().name().into(), ..Element::default() };
    for attribute in read.attributes() {
        match (attribute.name(), attribute.value()) {
            ("class", value) => element.classes = value.split_whitespace().map(String::from).collect(),
            ("style", value) => element.style = declarations(value),
            (name, value) => element.rest.push((name.into(), value.into())),
        }
    }
    // KaTeX keeps attributes in a hash map: without an order, two builds of one formula would differ.
    element.rest.sort();
    element.style.sort();
    element.children = read.children().map(node).collect();
    Node::Element(element)
}

fn declarations(style: &str) -> Vec<(String, String)> {
    let parts = style.split(';').filter_map(|part| part.split_once(':'));
    parts.map(|(name, value)| (name.trim().into(), value.trim().into())).collect()
}

/// Writes a node.
pub fn write(node: &Node, out: &mut String) {
    let element = match node {
        Node::Text(text) => return out.push_str(&escape_text(text)),
        Node::Element(element) => element,
    };
    out.push('<');
    out.push_str(&element.name);
    let style = element.style.iter().map(|(name, value)| (name, em(value).map_or_else(|| value.clone(), short)));
    let style: Vec<String> = style
        .filter(|(name, value)| value != "0" || *name == "top")
        .map(|(name, value)| format!("{name}:{value}"))
        .collect();
    let style = style.join(";");
    let class = CLASSES.get(style.as_str());
    let classes: Vec<&str> = element.classes.iter().map(String::as_str).chain(class.copied()).collect();
    if !classes.is_empty() {
        let _ = write!(out, " class=\"{}\"", classes.join(" "));
    }
    if !style.is_empty() && class.is_none() {
        let _ = write!(out, " style=\"{style}\"");
    }
    for (name, value) in &element.rest {
        let _ = write!(out, " {name}=\"{}\"", escape(value));
    }
    out.push('>');
    element.children.iter().for_each(|child| write(child, out));
    let _ = write!(out, "</{}>", element.name);
}
