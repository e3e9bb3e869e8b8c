//! The half of a formula that is read: MathML without what only a drawing would need.

use crate::markup::{Element, Node};

/// Attributes of MathML that change the drawing only.
const DRAWN: [&str; 14] = [
    "stretchy",
    "separator",
    "fence",
    "lspace",
    "rspace",
    "minsize",
    "maxsize",
    "rowspacing",
    "columnspacing",
    "columnalign",
    "width",
    "height",
    "voffset",
    "accent",
];

/// Elements of MathML that put their children in a row without an `mrow`.
const ROWS: [&str; 7] = ["math", "semantics", "mrow", "mtd", "mstyle", "mpadded", "msqrt"];

/// Drops the attributes and wrappers that say nothing to a reader.
pub fn read(element: &mut Element) {
    element.rest.retain(|(name, value)| {
        name != "xmlns"
            && !DRAWN.contains(&name.as_str())
            && (name.as_str(), value.as_str()) != ("mathvariant", "normal")
    });
    let row = ROWS.contains(&element.name.as_str());
    let mut children = Vec::new();
    for mut child in std::mem::take(&mut element.children) {
        if let Node::Element(inner) = &mut child {
            read(inner);
            let bare = inner.classes.is_empty() && inner.rest.iter().all(|(name, _)| STYLED.contains(&name.as_str()));
            let fence = matches!(inner.name.as_str(), "semantics")
                || matches!(inner.name.as_str(), "mrow" | "mstyle" | "mpadded") && bare;
            let blank = matches!(inner.name.as_str(), "mspace" | "mtext") && inner.children.iter().all(is_blank);
            match inner.name.as_str() {
                "annotation" => continue,
                _ if row && blank => continue,
                _ if fence && (row || inner.children.len() == 1) => {
                    children.append(&mut inner.children);
                    continue;
                }
                _ => {}
            }
        }
        children.push(child);
    }
    element.children = children;
}

/// Attributes of `mstyle` that change the drawing only.
const STYLED: [&str; 3] = ["scriptlevel", "displaystyle", "mathsize"];

fn is_blank(node: &Node) -> bool {
    matches!(node, Node::Text(text) if text.chars().all(char::is_whitespace))
}
