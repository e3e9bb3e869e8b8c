//! Attributes in braces: `{#id .class key="value"}`; single quotes hold a value that has double ones.

/// An id, classes and keyed values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Attributes {
    /// `#id`
    pub id: Option<String>,
    /// `.class`, in order
    pub classes: Vec<String>,
    /// `key="value"` or `key=value`, in order
    pub values: Vec<(String, String)>,
}

impl Attributes {
    /// Reads what stands between the braces.
    ///
    /// # Errors
    /// A message when a quote is not closed, a key repeats, or something is neither id, class nor `key=value`.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut attributes = Self::default();
        let mut rest = text.trim();
        while !rest.is_empty() {
            let (key, value, after) = if let Some(tail) = rest.strip_prefix('#') {
                let (id, after) = word(tail);
                ("id", id, after)
            } else if let Some(tail) = rest.strip_prefix('.') {
                let (class, after) = word(tail);
                (".", class, after)
            } else {
                let (key, tail) = rest
                    .split_once('=')
                    .ok_or_else(|| format!("`{rest}` in {{{text}}} is neither #id, .class nor key=\"value\""))?;
                let (value, after) = match tail.chars().next().filter(|c| matches!(c, '"' | '\'')) {
                    Some(quote) => {
                        tail[1..].split_once(quote).ok_or_else(|| format!("a quote is not closed in {{{text}}}"))?
                    }
                    None => word(tail),
                };
                (key.trim(), value, after)
            };
            match key {
                "." => attributes.classes.push(value.to_string()),
                "id" if value.is_empty() || attributes.id.is_some() => {
                    return Err(format!("one id is expected in {{{text}}}"));
                }
                "id" => attributes.id = Some(value.to_string()),
                key if attributes.value(key).is_some() => return Err(format!("`{key}` stands twice in {{{text}}}")),
                key => attributes.values.push((key.to_string(), value.to_string())),
            }
            rest = after.trim_start();
        }
        Ok(attributes)
    }

    /// The value of `key`.
    pub fn value(&self, key: &str) -> Option<&str> {
        self.values.iter().find(|(name, _)| name == key).map(|(_, value)| value.as_str())
    }
}

/// The first word of `text` and what follows it.
fn word(text: &str) -> (&str, &str) {
    text.split_at(text.find(char::is_whitespace).unwrap_or(text.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn id_classes_and_values_are_read() {
        let attributes = Attributes::parse(r#"#fig-bench .wide widget="observer-bench" title="Turn the gain" n=2"#);
        let attributes = attributes.unwrap();
        assert_eq!(attributes.id.as_deref(), Some("fig-bench"));
        assert_eq!(attributes.classes, ["wide"]);
        assert_eq!(attributes.value("title"), Some("Turn the gain"));
        assert_eq!(attributes.value("n"), Some("2"));
        assert_eq!(Attributes::parse(r#"start='{"step": 2}' a=b"#).unwrap().value("start"), Some(r#"{"step": 2}"#));
        assert_eq!(Attributes::parse(r#"id="third-step""#).unwrap().id.as_deref(), Some("third-step"));
    }

    #[test]
    fn what_cannot_be_read_is_refused() {
        for text in ["title=\"open", "loose", "#a #b", "k=1 k=2", "#a id=b"] {
            assert!(Attributes::parse(text).is_err(), "{text}");
        }
    }
}
