//! Accents, exponents and indices without the tables that KaTeX lays them out in.

use crate::markup::{Element, Node, em, length};

/// The rows of a list that KaTeX lays out as a table: each with how far it is raised and what stands in it.
pub(super) fn places(table: &Element) -> Option<Vec<(&Element, f64, &Element)>> {
    let rows: Vec<&Element> = table.children.iter().filter_map(Node::element).collect();
    let list = rows.first()?.children.iter().find_map(|child| child.element().filter(|cell| cell.has("vlist")))?;
    let below = rows.get(1).and_then(|row| row.children.first()?.element());
    let nothing = |cell: &Element| cell.children.iter().all(|it| it.element().is_some_and(|it| it.children.is_empty()));
    if !table.has("vlist-t") || rows.len() > 2 || !below.is_none_or(nothing) {
        return None;
    }
    list.children.iter().map(|node| node.element().and_then(place)).collect()
}

fn place(place: &Element) -> Option<(&Element, f64, &Element)> {
    let [Node::Element(strut), Node::Element(content)] = place.children.as_slice() else { return None };
    let raised = -(em(place.get("top")?)? + em(strut.get("height")?)?);
    strut.has("pstrut").then_some((place, raised, content))
}

/// A letter and its hat as two boxes in one place, instead of a table.
pub fn accent(element: &Element) -> Option<Element> {
    let [Node::Element(table)] = element.children.as_slice() else { return None };
    if !element.has("katex-accent") {
        return None;
    }
    let places = places(table)?;
    let [(_, low, letter), (_, high, hat)] = places.as_slice() else { return None };
    if !hat.has("accent-body") || hat.has("accent-full") || low.abs() > 1e-9 {
        return None;
    }
    let mut hat = (*hat).clone();
    if (high - low).abs() > 1e-9 {
        hat.style.push(("top".into(), length(low - high)));
    } else if let Some(left) = hat.get("left").and_then(em) {
        // A centred box moves by half of its margin.
        hat.style = vec![("margin-left".into(), length(2.0 * left))];
    }
    let children = vec![Node::Element((*letter).clone()), Node::Element(hat)];
    Some(Element { name: "span".into(), classes: vec!["hat".into()], children, ..Element::default() })
}

/// An exponent or an index that stands alone as one element, instead of a table.
pub fn script(element: &Element) -> Option<Element> {
    let [Node::Element(table)] = element.children.as_slice() else { return None };
    if element.classes != ["msupsub"] {
        return None;
    }
    let places = places(table)?;
    let [(place, raised, content)] = places.as_slice() else { return None };
    let raised = *raised;
    if !content.has("katex-sizing") {
        return None;
    }
    let size = |prefix: &str| {
        content
            .classes
            .iter()
            .find_map(|class| class.strip_prefix(prefix)?.parse::<usize>().ok())
            .and_then(|n| SIZES.get(n))
    };
    let scale = size("size")? / size("reset-size")?;
    let mut script = Element { name: if raised > 0.0 { "sup" } else { "sub" }.into(), ..Element::default() };
    let usual = if raised > 0.0 { RAISED } else { LOWERED };
    if (raised - usual).abs() > 1e-9 || (scale - SCALE).abs() > 1e-9 {
        script.style.push(("vertical-align".into(), length(raised / scale)));
    }
    if (scale - SCALE).abs() > 1e-9 {
        script.style.push(("font-size".into(), length(scale)));
    }
    let right = place.get("margin-right").and_then(em).unwrap_or_default();
    if (right - GAP).abs() > 1e-9 || (scale - SCALE).abs() > 1e-9 {
        script.style.push(("margin-right".into(), length(right / scale)));
    }
    match place.get("margin-left").and_then(em) {
        Some(left) if left != 0.0 => script.style.push(("margin-left".into(), length(left / scale))),
        _ => {}
    }
    script.children = content.children.clone();
    Some(script)
}

/// KaTeX's font sizes, of `size1` to `size11`, in ems.
const SIZES: [f64; 12] = [0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2, 1.44, 1.728, 2.074, 2.488];
/// What `formulas.css` says of `sup` and `sub`: size, place and the space after, the latter two in the parent's ems.
const SCALE: f64 = 0.7;
const RAISED: f64 = 0.363;
const LOWERED: f64 = -0.15;
const GAP: f64 = 0.05;
