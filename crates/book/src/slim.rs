//! KaTeX's answer made slim: the same picture from a third of the elements.
//!
//! The drawn half loses what no style rule looks at, its spaces become margins of the sign beside them, and an exponent
//! or index that stands alone becomes one `sup` or `sub` where KaTeX lays out a table of seven boxes. The read half
//! (MathML) loses what only a drawing would need. `web/style/formulas.css` knows the elements this makes.

use crate::markup::{Element, Node, em, length, parse, write};

/// Classes that no style rule mentions.
const INERT: [&str; 10] = ["mord", "mopen", "mclose", "mbin", "mrel", "mpunct", "minner", "mop", "mtight", "enclosing"];

/// Whose children the style rules count on, so that these stay what they are.
const STRICT: [&str; 8] = ["hat", "delim-size1", "delim-size4", "katex-inner", "clap", "llap", "rlap", "mfrac"];

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

/// Elements of MathML whose children stand in a row of their own accord.
const ROWS: [&str; 7] = ["math", "semantics", "mrow", "mtd", "mstyle", "mpadded", "msqrt"];

/// `html` as KaTeX wrote it, slim.
pub fn slim(html: &str) -> String {
    let mut nodes = parse(html);
    for node in &mut nodes {
        visit(node);
    }
    let mut out = String::with_capacity(html.len() / 2);
    nodes.iter().for_each(|node| write(node, &mut out));
    out
}

fn visit(node: &mut Node) {
    let Node::Element(element) = node else { return };
    if element.name == "math" {
        read(element);
    } else if element.has("katex-html") {
        draw(element, false);
    } else {
        element.children.iter_mut().for_each(visit);
    }
}

// The half that is read.

fn read(element: &mut Element) {
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

// The half that is drawn.

/// `strict`: the style rules count on the elements among `element`'s children.
fn draw(element: &mut Element, strict: bool) {
    if let Some(simple) = script(element).or_else(|| accent(element)) {
        *element = simple;
    }
    strut(element);
    if element.has("vlist") {
        element.children.iter_mut().for_each(hang);
    }
    let list = element.has("vlist");
    let children = std::mem::take(&mut element.children);
    for child in spaced(children) {
        let Node::Element(mut child) = child else {
            element.children.push(child);
            continue;
        };
        let holds = list || STRICT.iter().any(|class| child.has(class)) || child.has("katex-accent");
        draw(&mut child, holds);
        let usual = usual(&child);
        if child.classes.iter().any(|class| INERT.contains(&class.as_str())) {
            let bare = child.classes.iter().all(|class| INERT.contains(&class.as_str()));
            child.classes.retain(|class| !INERT.contains(&class.as_str()));
            if bare && !strict && child.style.is_empty() && child.rest.is_empty() {
                element.children.append(&mut child.children);
                continue;
            }
        }
        if child.has("delimcenter") && child.get("top").and_then(em).is_none_or(|top| top == 0.0) {
            child.classes.retain(|class| class != "delimcenter");
            child.style.retain(|(name, _)| name != "top");
        }
        if let Some(class) = usual {
            child.classes.push(class.into());
            child.style.clear();
        }
        if child.name == "span" && child.classes == ["mathnormal"] {
            child.name = "i".into();
            child.classes.clear();
        }
        element.children.push(Node::Element(child));
    }
    join(&mut element.children);
}

/// A space becomes a margin of a sign beside it: of an operator if there is one, else of the sign before.
fn spaced(children: Vec<Node>) -> Vec<Node> {
    let mut out: Vec<Node> = Vec::with_capacity(children.len());
    let mut children = children.into_iter().peekable();
    let mut gap = 0.0;
    while let Some(mut child) = children.next() {
        if gap != 0.0 {
            match sign(&mut child) {
                Some(sign) => sign.widen("margin-left", gap),
                None => out.push(blank(gap)),
            }
            gap = 0.0;
        }
        let Some(width) = space(&child) else {
            out.push(child);
            continue;
        };
        let mut before = out.last_mut().and_then(sign);
        let follows = children.peek_mut().and_then(sign).is_some_and(|next| is_operator(next));
        match &mut before {
            Some(before) if is_operator(before) || !follows => before.widen("margin-right", width),
            _ if follows => gap = width,
            _ => out.push(blank(width)),
        }
    }
    out
}

fn is_operator(sign: &Element) -> bool {
    sign.has("mrel") || sign.has("mbin")
}

/// Operators between their usual spaces are known to the style sheet by KaTeX's name.
const USUAL: [(&str, &[(&str, &str)]); 3] = [
    ("mrel", &[("margin-left", ".2778em"), ("margin-right", ".2778em")]),
    ("mbin", &[("margin-left", ".2222em"), ("margin-right", ".2222em")]),
    ("mpunct", &[("margin-right", ".1667em")]),
];

/// The class that says what the sign's margins say, instead of them.
fn usual(sign: &Element) -> Option<&'static str> {
    let same = |margins: &[(&str, &str)]| {
        margins.len() == sign.style.len() && margins.iter().all(|(name, value)| sign.get(name) == Some(value))
    };
    USUAL.iter().find(|(class, margins)| sign.has(class) && same(margins)).map(|(class, _)| *class)
}

/// The width of an empty box that only keeps a distance.
fn space(node: &Node) -> Option<f64> {
    let Node::Element(element) = node else { return None };
    let [(name, value)] = element.style.as_slice() else { return None };
    let plain = element.classes == ["mspace"] && element.children.is_empty() && element.rest.is_empty();
    if plain && name == "margin-right" { em(value) } else { None }
}

fn blank(width: f64) -> Node {
    let style = vec![("margin-right".into(), length(width))];
    Node::Element(Element { name: "span".into(), classes: vec!["mspace".into()], style, ..Element::default() })
}

/// A sign of the formula's own size, which a margin does not harm.
fn sign(node: &mut Node) -> Option<&mut Element> {
    let Node::Element(element) = node else { return None };
    let plain = |class: &String| INERT[..9].contains(&class.as_str()) || class.starts_with("math");
    let sign = element.name == "span"
        && !element.classes.is_empty()
        && element.classes.iter().all(plain)
        && element.rest.is_empty()
        && element.style.iter().all(|(name, _)| name.starts_with("margin-"))
        && matches!(element.children.as_slice(), [Node::Text(_)]);
    sign.then_some(element)
}

/// A base's strut becomes a box that the style sheet draws before it.
fn strut(base: &mut Element) {
    let Some(Node::Element(first)) = base.children.first() else { return };
    if !base.has("katex-base") || !first.has("katex-strut") {
        return;
    }
    let named =
        first.style.iter().map(|(name, value)| (if name == "height" { "--h" } else { "--d" }.into(), value.clone()));
    base.style = named.collect();
    base.children.remove(0);
}

/// What hangs in a list hangs by margins: a box that is positioned costs the browser at every frame.
fn hang(place: &mut Node) {
    let Node::Element(place) = place else { return };
    for (name, value) in &mut place.style {
        if name == "top" && em(value).is_some_and(|top| top <= 0.0) {
            *name = "--t".into();
        }
    }
}

/// The places of a list that KaTeX lays out as a table: each a strut of a known height with what stands on it.
fn places(table: &Element) -> Option<Vec<(&Element, f64, &Element)>> {
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

/// A letter under its hat: two boxes in one place instead of a table.
fn accent(element: &Element) -> Option<Element> {
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
        // A box in the middle goes half its margin to the side.
        hat.style = vec![("margin-left".into(), length(2.0 * left))];
    }
    let children = vec![Node::Element((*letter).clone()), Node::Element(hat)];
    Some(Element { name: "span".into(), classes: vec!["hat".into()], children, ..Element::default() })
}

/// An exponent or an index alone: one element instead of a table.
fn script(element: &Element) -> Option<Element> {
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

/// Neighbours that look alike become one.
fn join(children: &mut Vec<Node>) {
    let mut out: Vec<Node> = Vec::with_capacity(children.len());
    for child in children.drain(..) {
        match (out.last_mut(), child) {
            (Some(Node::Text(before)), Node::Text(text)) => before.push_str(&text),
            (Some(Node::Element(before)), Node::Element(mut next))
                if before.is_letters() && next.name == "i" && next.only_widens() =>
            {
                before.children.append(&mut next.children);
                before.style = next.style;
                join(&mut before.children);
            }
            (_, child) => out.push(child),
        }
    }
    *children = out;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attributes_are_in_one_order_whatever_the_hash_map_says() {
        let tag = "<g rspace=\"0em\" lspace=\"0em\">+ x &lt; y</g><path style=\"top:-1em;left:0.5em;\" d='M 0 1' class=\"a b\" aria-hidden=\"true\"/>";
        let sorted = "<g lspace=\"0em\" rspace=\"0em\">+ x &lt; y</g><path class=\"a b\" style=\"left:.5em;top:-1em\" aria-hidden=\"true\" d=\"M 0 1\"></path>";
        assert_eq!(slim(tag), sorted);
    }

    #[test]
    fn signs_keep_their_distances_and_lose_their_boxes() {
        let drawn = "<span class=\"katex-html\"><span class=\"katex-base\"><span class=\"katex-strut\" style=\"height:0.5em;vertical-align:-0.1em;\"></span><span class=\"mord mathnormal\">a</span><span class=\"mord mathnormal\" style=\"margin-right:0.05em;\">b</span><span class=\"mspace\" style=\"margin-right:0.2222em;\"></span><span class=\"mbin\">+</span><span class=\"mspace\" style=\"margin-right:0.2222em;\"></span><span class=\"mord\">1</span><span class=\"mclose\">)</span></span></span>";
        assert_eq!(
            slim(drawn),
            "<span class=\"katex-html\"><span class=\"katex-base\" style=\"--h:.5em;--d:-.1em\"><i style=\"margin-right:.05em\">ab</i><span class=\"mbin\">+</span>1)</span></span>"
        );
    }

    #[test]
    fn an_exponent_alone_is_one_element() {
        let drawn = "<span class=\"katex-html\"><span class=\"msupsub\"><span class=\"vlist-t\"><span class=\"vlist-r\"><span class=\"vlist\" style=\"height:0.8141em;\"><span style=\"top:-3.063em;margin-right:0.05em;\"><span class=\"pstrut\" style=\"height:2.7em;\"></span><span class=\"katex-sizing reset-size6 size3 mtight\"><span class=\"mord mtight\">2</span></span></span></span></span></span></span></span>";
        assert_eq!(slim(drawn), "<span class=\"katex-html\"><sup>2</sup></span>");
    }

    #[test]
    fn the_read_half_loses_only_what_a_drawing_needs() {
        let read = "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><semantics><mrow><mi mathvariant=\"bold\">x</mi><mo stretchy=\"false\">(</mo><mtext> </mtext><msup><mrow><mi>a</mi><mi>b</mi></mrow><mrow><mn>2</mn></mrow></msup></mrow><annotation encoding=\"application/x-tex\">x</annotation></semantics></math>";
        assert_eq!(
            slim(read),
            "<math><mi mathvariant=\"bold\">x</mi><mo>(</mo><msup><mrow><mi>a</mi><mi>b</mi></mrow><mn>2</mn></msup></math>"
        );
    }
}
