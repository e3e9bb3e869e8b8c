//! The part of KaTeX's style sheet that the site keeps (`web/build/build.mjs`).

use std::sync::LazyLock;

use crate::markup::Node;

/// The changes of size that the style sheet keeps of KaTeX's hundred.
const SIZES: [[&str; 2]; 3] = [["reset-size6", "size3"], ["reset-size6", "size1"], ["reset-size3", "size1"]];

/// Classes of KaTeX whose rules the style sheet leaves out (`web/build/build.mjs`), as no formula of the book needs
/// them.
static LEFT_OUT: LazyLock<Vec<String>> = LazyLock::new(|| {
    serde_json::from_str(include_str!("../../../../web/style/katex-left-out.json")).expect("a list of classes")
});

/// Refuses what the style sheet would not draw.
///
/// # Errors
/// A message that names the class.
pub fn known(node: &Node) -> Result<(), String> {
    let Node::Element(element) = node else { return Ok(()) };
    if let Some(class) = element.classes.iter().find(|class| LEFT_OUT.contains(class)) {
        return Err(format!("TeX: the style sheet leaves `{class}` out (web/style/katex-left-out.json)"));
    }
    let changes = element.classes.iter().any(|class| class.starts_with("reset-size"));
    if changes && !SIZES.iter().any(|size| size.iter().all(|class| element.has(class))) {
        return Err(format!("TeX: the style sheet has no change of size `{}`", element.classes.join(" ")));
    }
    element.children.iter().try_for_each(known)
}
