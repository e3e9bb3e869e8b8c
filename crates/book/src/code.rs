//! Code coloured at build time: syntect's scopes reduced to ten classes.

use syntect::parsing::{ParseState, Scope, ScopeStack, SyntaxSet};

use crate::html::escape;

/// Colours code.
pub struct Highlighter {
    syntaxes: SyntaxSet,
    classes: Vec<(Scope, Option<&'static str>)>,
}

/// Each class and the prefixes of the scopes that get it, none for what stays plain. The longest prefix that fits wins,
/// the innermost scope first.
const CLASSES: [(Option<&str>, &str); 10] = [
    (Some("comment"), "comment punctuation.definition.comment"),
    (Some("string"), "string punctuation.definition.string constant.character.escape constant.other.placeholder"),
    (Some("number"), "constant.numeric constant.language storage.type.numeric"),
    (
        Some("keyword"),
        "keyword storage.modifier storage.type storage.type.function storage.type.struct storage.type.enum \
            storage.type.trait storage.type.impl storage.type.type storage.type.module variable.language",
    ),
    (None, "keyword.operator"),
    (Some("lifetime"), "storage.modifier.lifetime entity.name.lifetime"),
    (Some("type"), "storage.type.rust entity.name support.type"),
    (Some("function"), "entity.name.function support.function"),
    (Some("macro"), "support.macro entity.name.macro"),
    (Some("attribute"), "meta.annotation variable.annotation"),
];

impl Default for Highlighter {
    fn default() -> Self {
        let scopes = CLASSES.iter().flat_map(|&(class, scopes)| scopes.split(' ').map(move |scope| (scope, class)));
        let classes = scopes.filter_map(|(scope, class)| Some((Scope::new(scope).ok()?, class))).collect();
        Self { syntaxes: SyntaxSet::load_defaults_newlines(), classes }
    }
}

impl Highlighter {
    /// Each line of `code` as HTML, without its newline. A language syntect does not know is left plain.
    pub fn lines(&self, code: &str, language: &str) -> Vec<String> {
        let syntax = self.syntaxes.find_syntax_by_token(language);
        let syntax = syntax.unwrap_or_else(|| self.syntaxes.find_syntax_plain_text());
        let mut state = ParseState::new(syntax);
        let mut stack = ScopeStack::new();
        // Code in a comment keeps its lines, as the code around it does; the text of a comment goes on in the next
        // line.
        let mut example = false;
        let mut line = |line: &str| {
            let html = self.line(line, &mut state, &mut stack);
            let fence = line.trim_start().starts_with("//") && line.contains("```");
            let inside = example || fence;
            example ^= fence;
            if inside { html.replace("\"c-comment\"", "\"c-comment c-example\"") } else { html }
        };
        code.lines().map(&mut line).collect()
    }

    /// The whole of `code` as HTML.
    pub fn html(&self, code: &str, language: &str) -> String {
        self.lines(code, language).join("\n")
    }

    fn line(&self, line: &str, state: &mut ParseState, stack: &mut ScopeStack) -> String {
        let line = format!("{line}\n");
        let Ok(ops) = state.parse_line(&line, &self.syntaxes) else { return escape(line.trim_end_matches('\n')) };
        let mut runs = Runs::default();
        let mut at = 0;
        for (end, op) in ops {
            runs.push(word(self.class(stack), &line[at..end]), &line[at..end]);
            at = end;
            // A scope the stack cannot apply leaves the colour as it was.
            let _ = stack.apply(&op);
        }
        runs.push(self.class(stack), &line[at..]);
        runs.html()
    }

    fn class(&self, stack: &ScopeStack) -> Option<&'static str> {
        stack.as_slice().iter().rev().find_map(|&scope| {
            let fitting = self.classes.iter().filter(|(prefix, _)| prefix.is_prefix_of(scope));
            fitting.max_by_key(|(prefix, _)| prefix.len()).map(|(_, class)| *class)
        })?
    }
}

/// The Rust syntax gives `let` the scope of a type.
fn word(class: Option<&'static str>, text: &str) -> Option<&'static str> {
    if matches!(text, "let" | "const" | "static") { Some("keyword") } else { class }
}

/// Neighbouring text of one class, kept in one span.
#[derive(Default)]
struct Runs {
    runs: Vec<(Option<&'static str>, String)>,
}

impl Runs {
    fn push(&mut self, class: Option<&'static str>, text: &str) {
        match self.runs.last_mut() {
            Some((last, run)) if *last == class => run.push_str(text),
            _ if text.is_empty() => {}
            _ => self.runs.push((class, text.to_string())),
        }
    }

    fn html(&self) -> String {
        let span = |(class, text): &(Option<&str>, String)| match (class, text.trim_end_matches('\n')) {
            (_, "") => String::new(),
            (Some(class), text) if !text.trim().is_empty() => {
                format!("<span class=\"c-{class}\">{}</span>", marked(text))
            }
            (_, text) => marked(text),
        };
        self.runs.iter().map(span).collect()
    }
}

/// The marks over a letter that the face of code lacks, with the class that draws each.
const MARKS: [(char, &str); 2] = [('\u{302}', "c-hat"), ('\u{304}', "c-bar")];

/// `text` as HTML. A letter under a mark is a box of its own: a mark of another face would stand beside its letter.
pub(crate) fn marked(text: &str) -> String {
    let mut html = String::new();
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        let over = letters.peek().and_then(|next| MARKS.iter().find(|(mark, _)| mark == next));
        match over {
            Some((mark, class)) => {
                letters.next();
                html +=
                    &format!("<span class=\"{class}\">{letter}<span class=\"visually-hidden\">{mark}</span></span>");
            }
            None => html += &escape(letter.encode_utf8(&mut [0; 4])),
        }
    }
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rust_is_coloured_by_role() {
        let html = Highlighter::default().html("// note\npub fn wrap(a: f64) -> f64 { a % 2.0 }", "rust");
        assert!(html.starts_with("<span class=\"c-comment\">// note</span>\n"), "{html}");
        for part in ["c-keyword\">pub", "c-function\">wrap", "c-type\">f64", "c-number\">2.0"] {
            assert!(html.contains(part), "{part} in {html}");
        }
    }

    #[test]
    fn a_letter_under_a_mark_is_one_box() {
        let html = Highlighter::default().html("x\u{302}⁺ < y", "");
        assert_eq!(html, "<span class=\"c-hat\">x<span class=\"visually-hidden\">\u{302}</span></span>⁺ &lt; y");
    }

    #[test]
    fn an_unknown_language_is_escaped_and_left_plain() {
        assert_eq!(Highlighter::default().html("a < b", "nonsense"), "a &lt; b");
    }
}
