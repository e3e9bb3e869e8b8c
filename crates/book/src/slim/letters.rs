//! A formula in a line of plain text, for the excerpts of the search: `x̂⁻`, `10²⁴`, `(A)⁻¹`, `[a, b; c, d]`.

use crate::markup::{Element, Node};

/// The letters of the MathML in `nodes`.
pub fn letters(nodes: &[Node]) -> String {
    nodes.iter().map(node).collect()
}

fn node(node: &Node) -> String {
    match node {
        Node::Text(text) => text.chars().filter(|c| !('\u{2061}'..='\u{2064}').contains(c)).collect(),
        Node::Element(element) => words(element),
    }
}

fn words(element: &Element) -> String {
    let parts: Vec<String> = element.children.iter().map(node).collect();
    match (element.name.as_str(), parts.as_slice()) {
        _ if element.has("katex-html") => String::new(),
        ("mo", [sign]) if matches!(sign.as_str(), "=" | "≈" | "≤" | "≥" | "<" | ">" | "∈" | "←" | "→" | "⟺") =>
        {
            format!(" {sign} ")
        }
        ("mo", [comma]) if comma == "," || comma == ";" => format!("{comma} "),
        ("msup", [base, power]) => format!("{base}{}", small(power, SUPER, "^")),
        ("msub" | "munder", [base, index]) => format!("{base}{}", small(index, SUB, "_")),
        ("msubsup" | "munderover", [base, index, power]) => {
            format!("{base}{}{}", small(index, SUB, "_"), small(power, SUPER, "^"))
        }
        ("mover", [base, mark]) => match mark.as_str() {
            "^" | "ˆ" => format!("{base}\u{302}"),
            "ˉ" | "¯" => format!("{base}\u{304}"),
            "˙" => format!("{base}\u{307}"),
            "~" | "˜" => format!("{base}\u{303}"),
            _ => base.clone(),
        },
        ("mfrac", [above, below]) => format!("{}/{}", whole(above), whole(below)),
        ("msqrt", parts) => format!("√{}", whole(&parts.concat())),
        ("mtable", rows) => rows.join("; "),
        ("mtr", cells) => {
            cells.iter().map(|cell| cell.trim()).filter(|cell| !cell.is_empty()).collect::<Vec<_>>().join(" ")
        }
        (_, parts) => parts.concat(),
    }
}

/// In brackets where it is more than one sign or number.
fn whole(part: &str) -> String {
    let one = part.chars().count() == 1 || part.chars().all(|c| c.is_ascii_digit() || c == '.');
    if one { part.into() } else { format!("({part})") }
}

type Signs = [(&'static str, &'static str); 2];
const SUPER: Signs = [("0123456789+−-()=nkTt", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻⁽⁾⁼ⁿᵏᵀᵗ"), ("∗*", "**")];
const SUB: Signs = [("0123456789+−-()=ijkprtx", "₀₁₂₃₄₅₆₇₈₉₊₋₋₍₎₌ᵢⱼₖₚᵣₜₓ"), ("∞", "∞")];

/// An exponent or an index in small signs where all its letters have one, else behind `mark`.
fn small(part: &str, signs: Signs, mark: &str) -> String {
    let sign = |c: char| {
        signs.iter().find_map(|(from, to)| {
            let at = from.chars().position(|known| known == c)?;
            to.chars().nth(at)
        })
    };
    let found: Option<String> = part.chars().map(sign).collect();
    found.unwrap_or_else(|| format!("{mark}{}", whole(part)))
}

#[cfg(test)]
mod tests {
    use crate::slim::slim;

    fn letters(math: &str) -> String {
        slim(&format!(
            "<span class=\"katex\"><span class=\"katex-mathml\"><math>{math}</math></span>\
             <span class=\"katex-html\" aria-hidden=\"true\">drawn</span></span>"
        ))
        .unwrap()
        .letters
    }

    #[test]
    fn exponents_indices_and_accents_stand_where_a_reader_expects_them() {
        assert_eq!(letters("<msup><mn>10</mn><mn>24</mn></msup><mi>I</mi>"), "10²⁴I");
        assert_eq!(letters("<msup><mi>P</mi><mo>−</mo></msup><msup><mi>H</mi><mi>T</mi></msup>"), "P⁻Hᵀ");
        assert_eq!(letters("<msub><mi>P</mi><mn>12</mn></msub>"), "P₁₂");
        assert_eq!(letters("<mover><mi>x</mi><mo>^</mo></mover><mo>=</mo><mn>1</mn>"), "x\u{302} = 1");
        assert_eq!(letters("<msup><mi>e</mi><mrow><mi>a</mi><mi>b</mi></mrow></msup>"), "e^(ab)");
        assert_eq!(letters("<mfrac><mn>1</mn><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow></mfrac>"), "1/(a+b)");
    }

    #[test]
    fn a_matrix_is_read_row_by_row() {
        let row = |a, b| format!("<mtr><mtd><mn>{a}</mn></mtd><mtd><mn>{b}</mn></mtd></mtr>");
        let matrix = format!("<mo>[</mo><mtable>{}{}</mtable><mo>]</mo>", row(1, 2), row(3, 4));
        assert_eq!(letters(&matrix), "[1 2; 3 4]");
    }
}
