//! The wording of the directives: what stands between colons, braces and brackets.

use crate::attributes::Attributes;
use crate::scan::Piece;

/// The bracket that closes the one `text` starts with, in the same paragraph.
pub(crate) fn closing_bracket(text: &str) -> Option<usize> {
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
pub(crate) fn directive(rest: &str) -> Result<Piece, String> {
    let rest = rest.trim();
    if rest.is_empty() {
        return Ok(Piece::End);
    }
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
pub(crate) fn inner_directive(rest: &str) -> Result<Piece, String> {
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
        "step" => Ok(Piece::Step { title: title.to_string(), id }),
        "after" => Ok(Piece::After(title.to_string())),
        other => Err(format!("unknown directive `::{other}`; there are ::step and ::after")),
    }
}

/// `name arguments` between double braces.
pub(crate) fn inline_directive(text: &str) -> Result<Piece, String> {
    let (name, argument) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let argument = argument.trim();
    match name {
        "number" => {
            let (id, format) = argument
                .split_once(char::is_whitespace)
                .ok_or_else(|| format!("`{{{{{text}}}}}` needs an id and a format"))?;
            Ok(Piece::Number { id: id.to_string(), format: format.trim().to_string() })
        }
        "ref" => Ok(Piece::Ref(argument.to_string())),
        "notation" => {
            let (choset, thrun) =
                argument.split_once('|').ok_or_else(|| format!("`{{{{{text}}}}}` needs `choset|thrun`"))?;
            Ok(Piece::Notation { choset: choset.trim().to_string(), thrun: thrun.trim().to_string() })
        }
        "listing" | "output" => Err(format!("`{{{{{name}}}}}` stands on a line of its own")),
        other => {
            Err(format!("unknown directive `{{{{{other}}}}}`; there are number, ref, notation, listing and output"))
        }
    }
}

/// `@key, locator; @key` between brackets.
pub(crate) fn citation(inside: &str) -> Result<Piece, String> {
    let keys = inside.split(';').map(|one| {
        let one = one.trim().strip_prefix('@').ok_or_else(|| format!("`[{inside}]` is not a citation"))?;
        Ok(match one.split_once(',') {
            Some((key, locator)) => (key.trim().to_string(), Some(locator.trim().to_string())),
            None => (one.trim().to_string(), None),
        })
    });
    Ok(Piece::Cite(keys.collect::<Result<_, String>>()?))
}
