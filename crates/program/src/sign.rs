//! What a single sign is: a blank, a letter, a mark of a name.

/// Blanks, those of other alphabets' typography among them.
pub(crate) fn is_blank(c: char) -> bool {
    matches!(
        c,
        ' ' | '\t' | '\r' | '\u{a0}' | '\u{2000}'..='\u{200b}' | '\u{202f}' | '\u{205f}' | '\u{3000}' | '\u{feff}'
    )
}

/// Letters, Greek and others among them.
pub(crate) fn begins_name(c: char) -> bool {
    c.is_ascii_alphabetic()
        || c == '_'
        || matches!(c, '\u{aa}' | '\u{b5}' | '\u{c0}'..='\u{d6}' | '\u{d8}'..='\u{f6}' | '\u{f8}'..='\u{1d2b}')
        || matches!(c, '\u{1e00}'..='\u{1ffe}' | '₀'..='ₜ' | '\u{2c60}'..='\u{2c7f}')
}

/// What marks a name as predicted or updated.
pub(crate) fn is_mark(c: char) -> bool {
    matches!(c, '⁻' | '⁺')
}

/// The sign of `^-` or `^+` behind a name, which is a mark where no power follows it.
pub(crate) fn raised_mark(rest: &str) -> Option<char> {
    let mut signs = rest.strip_prefix('^')?.chars();
    let mark = signs.next().filter(|c| matches!(c, '-' | '−' | '–' | '+'))?;
    signs.next().is_none_or(|c| !c.is_ascii_digit()).then_some(mark)
}
