//! Small pieces of HTML.

/// `text` with the five characters that mean something to HTML escaped.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            _ => out.push(c),
        }
    }
    out
}

/// ` id="…"` or nothing.
pub fn id_attribute(id: Option<&str>) -> String {
    id.map(|id| format!(" id=\"{}\"", escape(id))).unwrap_or_default()
}

/// The words of a piece of HTML: tags and everything aria-hidden or MathML dropped, entities resolved, spaces folded.
pub fn words(html: &str) -> String {
    let mut text = String::with_capacity(html.len() / 2);
    let mut rest = html;
    while let Some(start) = rest.find('<') {
        text.push_str(&rest[..start]);
        let Some(end) = rest[start..].find('>') else { break };
        let tag = &rest[start..start + end + 1];
        rest = &rest[start + end + 1..];
        if tag.starts_with("<span class=\"formula") {
            rest = skip_element(rest, "span");
        } else if tag.starts_with("<svg") {
            rest = skip_element(rest, "svg");
        } else if tag.starts_with("<a class=\"heading-link") {
            rest = skip_element(rest, "a");
        } else if !INLINE
            .iter()
            .any(|name| tag[1..].trim_start_matches('/').trim_end_matches('>').split(' ').next() == Some(name))
        {
            text.push(' ');
        }
    }
    text.push_str(rest);
    let text = text
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&#39;", "'")
        .replace("&amp;", "&");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

const INLINE: [&str; 9] = ["a", "em", "strong", "span", "code", "sub", "sup", "dfn", "b"];

/// What follows the end of the element `name` that has just been opened.
fn skip_element<'a>(html: &'a str, name: &str) -> &'a str {
    let (open, close) = (format!("<{name}"), format!("</{name}>"));
    let (mut depth, mut at) = (1, 0);
    while depth > 0 {
        let Some(end) = html[at..].find(&close) else { return "" };
        depth += html[at..at + end].matches(&open).count();
        depth -= 1;
        at += end + close.len();
    }
    &html[at..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_leave_formulas_and_tags_out() {
        let html = r#"<p>Let <span class="formula"><span>x</span> y</span> be <em>one</em>&#39;s.</p><p>Next</p>"#;
        assert_eq!(words(html), "Let be one's. Next");
    }
}
