//! KaTeX's answer made slim: the same picture from a third of the elements.
//!
//! In the half that is drawn, elements go that no style rule mentions, spaces become margins of the sign beside them,
//! and an exponent or index that stands alone becomes one `sup` or `sub` where KaTeX lays out a table of seven boxes.
//! The half that is read is `mathml`'s. What is one symbol is text (`symbol`). `formulas.css` knows the elements this
//! makes.

mod known;
mod letters;
mod lines;
mod mathml;
mod script;
mod symbol;

use crate::markup::{Element, Node, em, length, parse, write};
use known::known;
use mathml::read;
use script::{accent, script};

/// Classes that no style rule mentions.
const INERT: [&str; 10] = ["mord", "mopen", "mclose", "mbin", "mrel", "mpunct", "minner", "mop", "mtight", "enclosing"];

/// Classes whose style rules name their children, so that these must stay elements.
const STRICT: [&str; 8] = ["hat", "delim-size1", "delim-size4", "katex-inner", "clap", "llap", "rlap", "mfrac"];

/// A formula in one notation.
#[derive(Clone, Debug, PartialEq)]
pub struct Typeset {
    /// MathML to read and spans to look at, or plain text where that says it all.
    pub html: String,
    /// Its letters, for the search.
    pub letters: String,
    /// Whether it is plain text, without boxes.
    pub plain: bool,
}

/// A formula as KaTeX wrote it, slim.
///
/// # Errors
/// A message when `html` is not well formed.
pub fn slim(html: &str) -> Result<Typeset, String> {
    let mut nodes = parse(html)?;
    nodes.iter().try_for_each(known)?;
    nodes.iter_mut().for_each(|node| visit(node, false));
    let letters = letters::letters(&nodes);
    let symbol = symbol::symbol(&nodes);
    let plain = symbol.is_some();
    if let Some(symbol) = symbol {
        nodes = vec![symbol];
    }
    let mut out = String::with_capacity(html.len() / 2);
    nodes.iter().for_each(|node| write(node, &mut out));
    Ok(Typeset { html: out, letters, plain })
}

fn visit(node: &mut Node, display: bool) {
    let Node::Element(element) = node else { return };
    if element.name == "math" {
        read(element);
    } else if element.has("katex-html") {
        lines::bases(element, display);
        draw(element, false);
    } else if element.has("katex-mathml")
        && let [Node::Element(math)] = element.children.as_mut_slice()
    {
        // The style sheet hides the MathML from the eye without a class.
        *element = std::mem::take(math);
        read(element);
    } else {
        let display = display || element.has("katex-display");
        element.children.iter_mut().for_each(|child| visit(child, display));
    }
}

/// Makes the drawn half slim. With `strict`, style rules name the children of `element`, so that these stay elements.
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

/// Turns each empty box that keeps a distance into a margin of a sign beside it: of an operator if there is one, else
/// of the sign before.
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

/// The margins that KaTeX usually gives to an operator, and the class to which the style sheet gives the same margins.
const USUAL: [(&str, &[(&str, &str)]); 3] = [
    ("mrel", &[("margin-left", "0.2778em"), ("margin-right", "0.2778em")]),
    ("mbin", &[("margin-left", "0.2222em"), ("margin-right", "0.2222em")]),
    ("mpunct", &[("margin-right", "0.1667em")]),
];

/// The class to use instead of the sign's margins, if these are the usual ones.
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

/// The element, if it is a sign of the formula's own size: there a margin in ems has the length that KaTeX means.
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

/// How far a line of KaTeX's letters reaches above and below its foot, in ems: ascent 0.903 and descent 0.272 of the
/// face, with the rest of the line height of 1.2 on both sides alike.
const LINE: (f64, f64) = (0.915, 0.284);

/// Replaces a base's strut by its height and depth as properties: the style sheet draws such a box before the base. A
/// strut that reaches no farther than the line does goes.
fn strut(base: &mut Element) {
    if !base.has("katex-base") {
        return;
    }
    base.classes = vec!["base".into()];
    let Some(first) = base.children.first().and_then(Node::element).filter(|it| it.has("katex-strut")) else { return };
    let size = |name| first.get(name).and_then(em).unwrap_or_default();
    let (height, depth) = (size("height"), -size("vertical-align"));
    let needed = height - depth > LINE.0 || depth > LINE.1;
    let named = [("--h", height), ("--d", -depth)].map(|(name, value)| (name.into(), length(value)));
    base.style = if needed { named.into() } else { Vec::new() };
    base.children.remove(0);
}

/// Marks the rows of a list to be placed by margins: a positioned box costs the browser time in every frame.
fn hang(place: &mut Node) {
    let Node::Element(place) = place else { return };
    for (name, value) in &mut place.style {
        if name == "top" && em(value).is_some_and(|top| top <= 0.0) {
            *name = "--t".into();
        }
    }
}

/// Joins neighbours that look alike.
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
    fn a_change_of_size_that_the_style_sheet_does_not_have_is_an_error() {
        let sized = |size: &str| slim(&format!("<span class=\"katex-sizing reset-size6 {size}\">x</span>"));
        assert!(sized("size3").is_ok());
        assert!(sized("size7").unwrap_err().contains("size7"));
    }

    #[test]
    fn attributes_are_in_one_order_whatever_the_hash_map_says() {
        let tag = "<g rspace=\"0em\" lspace=\"0em\">+ x &lt; y</g><path style=\"top:-1em;left:0.5em;\" d='M 0 1' \
            class=\"a b\" aria-hidden=\"true\"/>";
        let sorted = "<g lspace=\"0em\" rspace=\"0em\">+ x &lt; y</g><path class=\"a b\" style=\"left:.5em;top:-1em\" \
            aria-hidden=\"true\" d=\"M 0 1\"></path>";
        assert_eq!(slim(tag).unwrap().html, sorted);
    }

    #[test]
    fn signs_keep_their_distances_and_lose_their_boxes() {
        let drawn = "<span class=\"katex-html\"><span class=\"katex-base\"><span class=\"katex-strut\" \
            style=\"height:0.5em;vertical-align:-0.1em;\"></span><span class=\"mord mathnormal\">a</span><span \
            class=\"mord mathnormal\" style=\"margin-right:0.1389em;\">b</span><span class=\"mspace\" \
            style=\"margin-right:0.2222em;\"></span><span class=\"mbin\">+</span><span class=\"mspace\" \
            style=\"margin-right:0.2222em;\"></span><span class=\"mord\">1</span><span \
            class=\"mclose\">)</span></span></span>";
        assert_eq!(
            slim(drawn).unwrap().html,
            "<span class=\"katex-html\"><span class=\"base\"><i class=\"r14\">ab</i><span \
                class=\"mbin\">+</span>1)</span></span>"
        );
    }

    #[test]
    fn an_exponent_alone_is_one_element() {
        let drawn = "<span class=\"katex-html\"><span class=\"msupsub\"><span class=\"vlist-t\"><span \
            class=\"vlist-r\"><span class=\"vlist\" style=\"height:0.8141em;\"><span \
            style=\"top:-3.063em;margin-right:0.05em;\"><span class=\"pstrut\" style=\"height:2.7em;\"></span><span \
            class=\"katex-sizing reset-size6 size3 mtight\"><span class=\"mord \
            mtight\">2</span></span></span></span></span></span></span></span>";
        assert_eq!(slim(drawn).unwrap().html, "<span class=\"katex-html\"><sup>2</sup></span>");
    }

    #[test]
    fn the_read_half_loses_only_what_a_drawing_needs() {
        let read = "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><semantics><mrow><mi \
            mathvariant=\"bold\">x</mi><mo stretchy=\"false\">(</mo><mtext> \
            </mtext><msup><mrow><mi>a</mi><mi>b</mi></mrow><mrow><mn>2</mn></mrow></msup></mrow><annotation \
            encoding=\"application/x-tex\">x</annotation></semantics></math>";
        assert_eq!(
            slim(read).unwrap().html,
            "<math><mi mathvariant=\"bold\">x</mi><mo>(</mo>\
             <msup><mrow><mi>a</mi><mi>b</mi></mrow><mn>2</mn></msup></math>"
        );
    }
}
