//! Where a formula may go on in a next line: never between round brackets; in a display ahead of a relation or an
//! operator, and an `aligned` display is a list of lines, which a page sets in columns or, where it is narrow, one
//! below the other.

use std::mem::take;

use super::script::places;
use crate::markup::{Element, Node, em, length};

/// Joins the bases that a line must not part.
pub fn bases(html: &mut Element, display: bool) {
    if let Some((pairs, lines)) = aligned(html).filter(|_| display) {
        html.children = lines;
        html.classes.push(if pairs == 1 { "lines" } else { "lines pairs" }.into());
        return;
    }
    let bases = take(&mut html.children);
    html.children = joined(bases, display);
}

/// The lines of a formula that is nothing but an `aligned` environment, and how many stand side by side: one for each
/// pair of columns, at most two.
fn aligned(html: &Element) -> Option<(usize, Vec<Node>)> {
    let [Node::Element(base)] = html.children.as_slice() else { return None };
    let [_, Node::Element(content)] = base.children.as_slice() else { return None };
    let table = match content.children.as_slice() {
        [Node::Element(inner)] if !content.has("mtable") => inner,
        _ => content,
    };
    let columns = table.children.iter().filter_map(Node::element).filter(|it| !it.has("arraycolsep"));
    let columns: Vec<Vec<_>> = columns
        .map(|column| match column.children.as_slice() {
            [Node::Element(rows)] if column.has("col-align-r") || column.has("col-align-l") => places(rows),
            _ => None,
        })
        .collect::<Option<_>>()?;
    let rows = columns.first().filter(|_| table.has("mtable"))?.len();
    if !matches!(columns.len(), 2 | 4) || columns.iter().any(|column| column.len() != rows) {
        return None;
    }
    let cell = |(_, _, content): &(_, _, &Element)| span("cell", joined(split(content.children.clone()), true));
    let line = |row: usize, pair: &[Vec<_>]| span("line", pair.iter().map(|column| cell(&column[row])).collect());
    let lines = (0..rows).flat_map(|row| columns.chunks(2).map(move |pair| line(row, pair)));
    Some((columns.len() / 2, lines.collect()))
}

fn span(class: &str, children: Vec<Node>) -> Node {
    Node::Element(Element { name: "span".into(), classes: vec![class.into()], children, ..Element::default() })
}

/// The bases of a list of signs, as KaTeX parts a formula that is no list: behind each relation and each operator.
fn split(signs: Vec<Node>) -> Vec<Node> {
    let mut bases = Vec::new();
    let mut base = Vec::new();
    let mut signs = signs.into_iter().peekable();
    while let Some(sign) = signs.next() {
        let ends = breaks(&sign);
        base.push(sign);
        if ends {
            base.extend(std::iter::from_fn(|| signs.next_if(is_space)));
            bases.push(span("katex-base", take(&mut base)));
        }
    }
    if !base.is_empty() {
        bases.push(span("katex-base", base));
    }
    bases
}

fn joined(bases: Vec<Node>, display: bool) -> Vec<Node> {
    let mut out: Vec<Element> = Vec::new();
    let mut depth = 0;
    for node in bases {
        let Node::Element(mut base) = node else { continue };
        let opened = base.children.iter().map(open).sum::<i32>();
        match out.last_mut() {
            Some(before) if depth > 0 => {
                let strut = strut(&mut base);
                before.children.append(&mut base.children);
                reach(before, strut);
            }
            Some(before) if display => {
                carry(before, &mut base);
                out.push(base);
            }
            _ => out.push(base),
        }
        depth += opened;
    }
    out.retain(|base| base.children.iter().any(shows));
    out.into_iter().map(Node::Element).collect()
}

/// Takes the relation or the operator that ends `before` to the start of `base`.
fn carry(before: &mut Element, base: &mut Element) {
    let Some(mut at) = before.children.iter().rposition(|it| !is_space(it)) else { return };
    if !before.children[at].element().is_some_and(|it| it.has("mrel") || it.has("mbin")) {
        return;
    }
    while at > 0 && is_space(&before.children[at - 1]) {
        at -= 1;
    }
    let first = usize::from(base.children.first().is_some_and(is_strut));
    let signs: Vec<Node> = before.children.drain(at..).collect();
    base.children.splice(first..first, signs);
}

/// How many round or square brackets a sign leaves open. A bracket that the author made large may hold a long formula.
fn open(sign: &Node) -> i32 {
    let Node::Element(sign) = sign else { return 0 };
    let large = sign.children.iter().any(|it| it.element().is_some_and(|it| it.has("delimsizing")));
    let own = i32::from(sign.has("mopen")) - i32::from(sign.has("mclose"));
    match own {
        _ if large => 0,
        0 => sign.children.iter().map(open).sum(),
        // A bracket with an exponent holds the bracket alone.
        own => own,
    }
}

fn breaks(sign: &Node) -> bool {
    sign.element().is_some_and(|it| it.has("mrel") || it.has("mbin") || it.has("allowbreak"))
}

fn is_space(sign: &Node) -> bool {
    sign.element().is_some_and(|it| it.has("mspace") && !it.has("allowbreak"))
}

/// Whether anything of it is drawn.
fn shows(sign: &Node) -> bool {
    match sign {
        Node::Text(_) => true,
        Node::Element(sign) => sign.name == "svg" || sign.children.iter().any(shows),
    }
}

fn is_strut(sign: &Node) -> bool {
    sign.element().is_some_and(|it| it.has("katex-strut"))
}

/// How far a base reaches above and below its foot, taken out of it.
fn strut(base: &mut Element) -> Option<[f64; 2]> {
    let strut = base.children.first().filter(|it| is_strut(it))?.element()?;
    let size = |name| strut.get(name).and_then(em).unwrap_or_default();
    let reach = [size("height") + size("vertical-align"), -size("vertical-align")];
    base.children.remove(0);
    Some(reach)
}

/// Lets a base reach as far as `other` does.
fn reach(base: &mut Element, other: Option<[f64; 2]>) {
    let (Some(own), Some(other)) = (strut(base), other) else { return };
    let [above, below] = [own[0].max(other[0]), own[1].max(other[1])];
    let style = vec![("height".into(), length(above + below)), ("vertical-align".into(), length(-below))];
    let strut = Element { name: "span".into(), classes: vec!["katex-strut".into()], style, ..Element::default() };
    base.children.insert(0, Node::Element(strut));
}

#[cfg(test)]
mod tests {
    use katex::{KatexContext, Settings, render_to_string};

    use super::super::slim;
    use crate::markup::{Node, parse};

    /// What is drawn of each line, with a stroke ahead of each base.
    fn lines(tex: &str, display: bool) -> Vec<String> {
        let settings = Settings::builder().display_mode(display).build();
        let html = slim(&render_to_string(&KatexContext::default(), tex, &settings).unwrap()).unwrap().html;
        parse(&html).unwrap().iter().map(drawn).collect::<String>().lines().map(String::from).collect()
    }

    fn drawn(node: &Node) -> String {
        let element = match node {
            Node::Text(text) => return text.clone(),
            Node::Element(element) => element,
        };
        let inside: String = element.children.iter().map(drawn).collect();
        match element.classes.first().map(String::as_str) {
            _ if element.name == "math" => String::new(),
            Some("base") => format!("|{inside}"),
            Some("line") => format!("{inside}\n"),
            _ => inside,
        }
    }

    #[test]
    fn a_line_of_text_goes_on_behind_an_operator_and_never_between_brackets() {
        assert_eq!(lines("a = b (c + d) + e", false), ["|a=|b(c+d)+|e"]);
    }

    #[test]
    fn a_bracket_with_an_exponent_closes_one_bracket() {
        assert_eq!(lines("(a - b)^2 + (c - d)", false), ["|(a−b)2+|(c−d)"]);
    }

    #[test]
    fn a_display_goes_on_ahead_of_an_operator() {
        assert_eq!(lines("a = b (c + d) + e", true), ["|a|=b(c+d)|+e"]);
    }

    #[test]
    fn a_large_bracket_may_hold_several_lines() {
        assert_eq!(lines(r"a \bigl[ b - c \bigr] = d", true), ["|a[b|−c]|=d"]);
    }

    #[test]
    fn an_aligned_display_is_a_list_of_lines() {
        assert_eq!(lines(r"\begin{aligned} a &= b + c,\\ d &= e \end{aligned}", true), ["|a|=b|+c,", "|d|=e"]);
        assert_eq!(lines(r"\begin{aligned} a &= b & c &= d \end{aligned}", true), ["|a|=b", "|c|=d"]);
    }
}
