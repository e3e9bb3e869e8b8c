//! The markup of a formula as a tree: well-formed spans and MathML, read, changed and written.

use std::fmt::Write;

/// An element or a text of KaTeX's markup, which is XML.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A tag and what it holds.
    Element(Element),
    /// Text as it stands in the source.
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

/// In ems, to four decimals, without a zero before the point.
pub fn length(value: f64) -> String {
    let text = format!("{:.4}", value);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "" | "0" | "-0" => "0".into(),
        _ => format!("{}em", text.replacen("0.", ".", usize::from(text.trim_start_matches('-').starts_with("0.")))),
    }
}

/// The nodes of `html`, which is well formed.
pub fn parse(html: &str) -> Vec<Node> {
    let mut open = vec![Element::default()];
    let mut rest = html;
    while let Some(start) = rest.find('<') {
        let Some(end) = rest[start..].find('>').map(|end| start + end) else { break };
        let (text, tag) = (&rest[..start], &rest[start + 1..end]);
        rest = &rest[end + 1..];
        if !text.is_empty() {
            add(&mut open, Node::Text(text.into()));
        }
        if tag.starts_with('/') {
            if let (Some(done), true) = (open.pop(), !open.is_empty()) {
                add(&mut open, Node::Element(done));
            }
            continue;
        }
        let element = opened(tag.trim_end_matches('/'));
        if tag.ends_with('/') {
            add(&mut open, Node::Element(element));
        } else {
            open.push(element);
        }
    }
    if !rest.is_empty() {
        add(&mut open, Node::Text(rest.into()));
    }
    open.swap_remove(0).children
}

fn add(open: &mut [Element], node: Node) {
    if let Some(parent) = open.last_mut() {
        parent.children.push(node);
    }
}

/// An element from what stands between `<` and `>`.
fn opened(tag: &str) -> Element {
    let (name, mut rest) = tag.split_once(' ').unwrap_or((tag, ""));
    let mut element = Element { name: name.into(), ..Element::default() };
    while let Some((attribute, after)) = rest.split_once('=') {
        let quote = if after.starts_with('\'') { '\'' } else { '"' };
        let Some((value, after)) = after.get(1..).and_then(|value| value.split_once(quote)) else { break };
        match attribute.trim() {
            "class" => element.classes = value.split_whitespace().map(String::from).collect(),
            "style" => element.style = declarations(value),
            attribute => element.rest.push((attribute.into(), value.into())),
        }
        rest = after;
    }
    // KaTeX keeps attributes in a hash map: without an order, two builds of one formula would differ.
    element.rest.sort();
    element.style.sort();
    element
}

fn declarations(style: &str) -> Vec<(String, String)> {
    let parts = style.split(';').filter_map(|part| part.split_once(':'));
    parts.map(|(name, value)| (name.trim().into(), value.trim().into())).collect()
}

/// Writes a node.
pub fn write(node: &Node, out: &mut String) {
    let element = match node {
        Node::Text(text) => return out.push_str(text),
        Node::Element(element) => element,
    };
    out.push('<');
    out.push_str(&element.name);
    if !element.classes.is_empty() {
        let _ = write!(out, " class=\"{}\"", element.classes.join(" "));
    }
    let style = element.style.iter().map(|(name, value)| (name, em(value).map_or_else(|| value.clone(), length)));
    let style: Vec<String> = style
        .filter(|(name, value)| value != "0" || *name == "top")
        .map(|(name, value)| format!("{name}:{value}"))
        .collect();
    if !style.is_empty() {
        let _ = write!(out, " style=\"{}\"", style.join(";"));
    }
    for (name, value) in &element.rest {
        let _ = write!(out, " {name}=\"{value}\"");
    }
    out.push('>');
    element.children.iter().for_each(|child| write(child, out));
    let _ = write!(out, "</{}>", element.name);
}
