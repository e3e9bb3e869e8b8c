//! Small pieces of HTML.

/// `text` with the five characters that mean something to HTML escaped.
pub fn escape(text: &str) -> String {
    escape_text(text).replace('"', "&quot;").replace('\'', "&#39;")
}

/// `text` as it may stand between tags.
pub fn escape_text(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Stands before and after code among the words: a search weighs a name in code less than a word of the text.
pub(crate) const CODE: char = '\u{1e}';
