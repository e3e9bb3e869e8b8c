//! Formulas that are one symbol: a letter, a number, a letter with an index. They are text, in KaTeX's faces, and need
//! neither MathML nor boxes: what is drawn is what is read, found and copied.

use crate::markup::{Element, Node};

/// The most characters of a symbol.
const MOST: usize = 8;

/// The formula `nodes` as one element of class `katex`, if text says all of it.
pub fn symbol(nodes: &[Node]) -> Option<Node> {
    let [Node::Element(katex)] = nodes else { return None };
    let [Node::Element(_), Node::Element(html)] = katex.children.as_slice() else { return None };
    let [Node::Element(base)] = html.children.as_slice() else { return None };
    if !katex.has("katex") || !html.has("katex-html") || !base.has("base") {
        return None;
    }
    let mut count = 0;
    if !base.children.iter().all(|node| plain(node, &mut count)) || count == 0 || count > MOST {
        return None;
    }
    let mut symbol = match base.children.as_slice() {
        // Letters alone carry the class themselves.
        [Node::Element(letters)] if letters.name == "i" && letters.classes.is_empty() => letters.clone(),
        children => Element { name: "span".into(), children: children.to_vec(), ..Element::default() },
    };
    symbol.classes = vec!["katex".into()];
    Some(Node::Element(symbol))
}

/// Whether `node` reads as it looks: letters, digits, an index, a mark such as the star of `x*`; no operators, and no
/// exponents, which would read as factors. Counts its characters.
fn plain(node: &Node, count: &mut usize) -> bool {
    let element = match node {
        Node::Text(text) => {
            *count += text.chars().count();
            return text.chars().all(|c| c.is_alphanumeric() || "∞∗′−.()■".contains(c));
        }
        Node::Element(element) => element,
    };
    if !element.style.iter().all(|(name, _)| name.starts_with("margin-")) {
        return false;
    }
    let allowed = match element.name.as_str() {
        "i" | "sub" => element.classes.is_empty(),
        "sup" => {
            matches!(element.children.as_slice(), [Node::Text(mark)] if ["−", "+", "∗", "′"].contains(&mark.as_str()))
        }
        "span" => match element.classes.as_slice() {
            [] => element.rest.iter().all(|(name, _)| name == "data-number"),
            [class] => class.starts_with("term-") || ["mathbf", "mathrm", "amsrm"].contains(&class.as_str()),
            _ => false,
        },
        _ => false,
    };
    allowed && element.children.iter().all(|child| plain(child, count))
}

#[cfg(test)]
mod tests {
    use super::super::slim;

    fn formula(drawn: &str) -> String {
        slim(&format!(
            "<span class=\"katex\"><span class=\"katex-mathml\"><math><mi>x</mi></math></span>\
             <span class=\"katex-html\" aria-hidden=\"true\"><span class=\"katex-base\"><span class=\"katex-strut\" \
             style=\"height:0.5em;\"></span>{drawn}</span></span></span>"
        ))
        .unwrap()
        .html
    }

    #[test]
    fn a_letter_is_one_element() {
        assert_eq!(formula("<span class=\"mord mathnormal\">x</span>"), "<i class=\"katex\">x</i>");
        assert_eq!(
            formula("<span class=\"enclosing term-truth\"><span class=\"mord\">Ω</span></span>"),
            "<span class=\"katex\"><span class=\"term-truth\">Ω</span></span>"
        );
    }

    #[test]
    fn an_operator_or_an_exponent_keeps_its_mathml() {
        let operator = formula("<span class=\"mord mathnormal\">x</span><span class=\"mbin\">+</span><span>1</span>");
        assert!(operator.contains("<math>"), "{operator}");
        let exponent = formula("<span class=\"mord mathnormal\">x</span><sup>2</sup>");
        assert!(exponent.contains("<math>"), "{exponent}");
    }
}
