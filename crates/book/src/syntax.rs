//! The wording of each piece: what stands between colons, braces, brackets and dollars.

use crate::attributes::Attributes;
use crate::piece::{NumberRef, Piece, Tex};

/// The bracket that closes the one `text` starts with, in the same paragraph.
pub fn closing_bracket(text: &str) -> Option<usize> {
    let mut depth = 0;
    let mut escaped = false;
    for (at, c) in text.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '[' => depth += 1,
            ']' => {
                depth -= 1;
                if depth == 0 {
                    return Some(at);
                }
            }
            _ => {}
        }
    }
    None
}

/// `name{…}` after three colons.
pub fn directive(rest: &str) -> Result<Piece, String> {
    let (name, braces) = rest.split_at(rest.find('{').unwrap_or(rest.len()));
    let attributes = match braces.strip_prefix('{') {
        Some(inside) => {
            let inside = inside.strip_suffix('}').ok_or_else(|| format!("`{{` is not closed in `:::{rest}`"))?;
            Attributes::parse(inside)?
        }
        None => Attributes::default(),
    };
    Ok(Piece::Directive { name: name.trim().to_string(), attributes })
}

/// `name[title]{#id}` after two colons.
pub fn part(rest: &str) -> Result<Piece, String> {
    let (name, tail) = rest.split_at(rest.find(['[', '{']).unwrap_or(rest.len()));
    let (title, tail) = match tail.starts_with('[') {
        true => {
            let close = closing_bracket(tail).ok_or_else(|| format!("`[` is not closed in `::{rest}`"))?;
            (&tail[1..close], &tail[close + 1..])
        }
        false => ("", tail),
    };
    let inside = tail.trim().strip_prefix('{').and_then(|tail| tail.strip_suffix('}')).unwrap_or("");
    let id = Attributes::parse(inside)?.id;
    match name.trim() {
        "step" => Ok(Piece::Step { title: title.to_string(), id, number: 0 }),
        "after" => Ok(Piece::After(title.to_string())),
        other => Err(format!("unknown directive `::{other}`; there are ::step and ::after")),
    }
}

/// `listing path#anchor` or `output example`, the whole of a line between double braces.
pub fn listing(text: &str) -> Option<Piece> {
    let (name, argument) = text.trim().split_once(' ')?;
    let argument = argument.trim();
    match name {
        "listing" => {
            let (path, anchor) = argument.split_once('#').map_or((argument, None), |(path, it)| (path, Some(it)));
            Some(Piece::Listing { path: path.to_string(), anchor: anchor.map(String::from) })
        }
        "output" => Some(Piece::Output(argument.to_string())),
        _ => None,
    }
}

/// `name arguments` between double braces within a line.
pub fn inline(text: &str) -> Result<Piece, String> {
    let (name, argument) = text.trim().split_once(char::is_whitespace).unwrap_or((text.trim(), ""));
    let argument = argument.trim();
    match name {
        "number" => number(argument).map(Piece::Number),
        "ref" => Ok(Piece::Ref(argument.to_string())),
        "listing" | "output" => Err(format!("`{{{{{name}}}}}` stands on a line of its own")),
        other => Err(format!("unknown directive `{{{{{other}}}}}`; there are number, ref, listing and output")),
    }
}

/// `id format`
fn number(argument: &str) -> Result<NumberRef, String> {
    let (id, format) = argument
        .split_once(char::is_whitespace)
        .ok_or_else(|| format!("`{{{{number {argument}}}}}` needs an id and a format"))?;
    Ok(NumberRef { id: id.to_string(), format: format.trim().to_string() })
}

/// A formula, its numbers apart.
pub fn formula(tex: &str) -> Result<Vec<Tex>, String> {
    let mut parts = Vec::new();
    let mut rest = tex;
    while let Some((before, after)) = rest.split_once("{{number ") {
        let (argument, after) =
            after.split_once("}}").ok_or_else(|| format!("`{{{{number` is not closed in ${tex}$"))?;
        parts.extend([Tex::Source(before.to_string()), Tex::Number(number(argument.trim())?)]);
        rest = after;
    }
    parts.push(Tex::Source(rest.to_string()));
    Ok(parts)
}

/// The statements of a displayed formula: what `\qquad` parts outside of all braces and environments. Where a line has
/// no room for all of them, a page puts them below one another.
pub fn statements(tex: &[Tex]) -> Vec<Vec<Tex>> {
    let (mut statements, mut statement, mut depth) = (Vec::new(), Vec::new(), 0);
    for part in tex {
        let Tex::Source(source) = part else {
            statement.push(part.clone());
            continue;
        };
        let mut from = 0;
        for (i, _) in source.match_indices(['{', '}', '\\']) {
            let rest = &source[i..];
            depth += i32::from(rest.starts_with('{') || rest.starts_with("\\begin"));
            depth -= i32::from(rest.starts_with('}') || rest.starts_with("\\end"));
            if depth == 0 && rest.starts_with(SPACE) {
                statement.push(Tex::Source(source[from..i].into()));
                statements.push(std::mem::take(&mut statement));
                from = i + SPACE.len();
            }
        }
        statement.push(Tex::Source(source[from..].into()));
    }
    statements.push(statement);
    statements
}

/// What stands between two statements of a display.
const SPACE: &str = "\\qquad";

/// `@key, locator; @key` between brackets.
pub fn citation(inside: &str) -> Result<Piece, String> {
    let keys = inside.split(';').map(|one| {
        let one = one.trim().strip_prefix('@').ok_or_else(|| format!("`[{inside}]` is not a citation"))?;
        Ok(match one.split_once(',') {
            Some((key, locator)) => (key.trim().to_string(), Some(locator.trim().to_string())),
            None => (one.trim().to_string(), None),
        })
    });
    Ok(Piece::Cite(keys.collect::<Result<_, String>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_display_is_parted_between_its_statements_and_nowhere_else() {
        let parts = |tex: &str| {
            let tex = formula(tex).unwrap();
            let all = statements(&tex);
            all.iter()
                .map(|statement| statement.iter().map(|part| format!("{part:?}")).collect::<String>())
                .collect::<Vec<_>>()
        };
        let one = |tex: &str| format!("{:?}", Tex::Source(tex.into()));
        assert_eq!(parts("a"), [one("a")]);
        assert_eq!(parts("a,\\qquad\\frac{b}{c}\\qquad d"), [one("a,"), one("\\frac{b}{c}"), one(" d")]);
        assert_eq!(parts("\\text{a\\qquad b}").len(), 1);
        assert_eq!(parts("\\begin{aligned} a \\qquad b \\end{aligned}").len(), 1);
        assert_eq!(parts("a = {{number x.y .2f}},\\qquad b").len(), 2);
    }
}
