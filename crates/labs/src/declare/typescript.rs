//! TypeScript written from declarations while the crate is compiled: no second copy is kept anywhere.

use super::parameter::Parameter;
use super::shape::{Plain, Shape};
use super::text::Text;

/// What an interface of TypeScript says beside its shape. It is kept apart from the shape, so that no program carries these
/// words.
pub(crate) struct About {
    /// A record.
    pub shape: Shape,
    /// The record's doc comment.
    pub record: &'static str,
    /// The doc comment of each field.
    pub fields: &'static [&'static str],
    /// The limits of each field, where the fields are parameters.
    pub parameters: &'static [Parameter],
    /// The default of each, as it is written in the declaration.
    pub defaults: &'static [&'static str],
}

/// A record that TypeScript knows as an interface.
pub(crate) trait Interface: Plain {
    /// Shape and doc comments.
    const ABOUT: About;
}

/// These interfaces. The names `Vector` and `Matrix` are left to whoever includes this.
pub(crate) const fn written(mut groups: &[&[About]]) -> Text<60_000> {
    let mut text = Text::new();
    while let [group, rest @ ..] = groups {
        let mut i = 0;
        while i < group.len() {
            put_interface(&mut text, &group[i]);
            i += 1;
        }
        groups = rest;
    }
    text
}

const fn put_interface<const N: usize>(text: &mut Text<N>, about: &About) {
    let Shape::Record(name, fields) = about.shape else { panic!("an interface is of a record") };
    text.put_all(&["/**", about.record, " */\nexport interface ", name, " {\n"]);
    let mut i = 0;
    while i < fields.len() {
        text.put_all(&["    /**", about.fields[i]]);
        if i < about.parameters.len() {
            put_limits(text, about.parameters[i].bounds, about.defaults[i]);
        }
        text.put_all(&[" */\n    ", fields[i].name, ": "]);
        put_type(text, &fields[i].shape);
        text.put(";\n");
        i += 1;
    }
    text.put("}\n");
}

/// The limits of a parameter, and its default if it is a literal.
const fn put_limits<const N: usize>(text: &mut Text<N>, bounds: &str, default: &str) {
    if !bounds.is_empty() {
        text.put_all(&[" Goes ", bounds, "."]);
    }
    match default.as_bytes() {
        [b'(', ..] => {}
        b"None" => text.put(" Default null."),
        _ => text.put_all(&[" Default ", default, "."]),
    }
}

const fn put_type<const N: usize>(text: &mut Text<N>, shape: &Shape) {
    match shape {
        Shape::Number | Shape::Whole => text.put("number"),
        Shape::Flag => text.put("boolean"),
        Shape::Text => text.put("string"),
        Shape::Record(name, _) => text.put(name),
        Shape::Exactly(_, entry) | Shape::List(entry) => match entry {
            Shape::Number | Shape::Whole => text.put("Vector"),
            Shape::Exactly(_, Shape::Number) | Shape::List(Shape::Number) => text.put("Matrix"),
            _ => {
                put_type(text, entry);
                text.put("[]");
            }
        },
        Shape::Maybe(value) => {
            put_type(text, value);
            text.put(" | null");
        }
        Shape::Word(words) => {
            let mut i = 0;
            while i < words.len() {
                text.put_all(&[if i == 0 { "\"" } else { " | \"" }, words[i], "\""]);
                i += 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::TYPESCRIPT;

    #[test]
    fn doc_comments_limits_and_defaults_are_kept() {
        for line in [
            "    /** Who chooses the gain. */\n    mode: \"fixed\" | \"filter\";\n",
            "    /** Whether sightings of the corners correct the estimate. Default false. */\n    fixes: boolean;\n",
            "    /** How many of them are seen. Goes from 1 to 3. Default 1. */\n    count: number;\n",
            "    stop: number | null;\n",
            "    feet: Feet | null;\n",
            "    P: Matrix;\n",
        ] {
            assert!(TYPESCRIPT.contains(line), "{line}");
        }
    }

    #[test]
    fn each_interface_is_declared_once_and_none_is_missing() {
        let names: Vec<&str> =
            TYPESCRIPT.lines().filter_map(|line| line.strip_prefix("export interface ")?.strip_suffix(" {")).collect();
        let mut once = names.clone();
        once.sort_unstable();
        once.dedup();
        assert_eq!(once.len(), names.len(), "{names:?}");
        assert!(names.contains(&"Ellipse") && names.contains(&"ProbeRanks"), "{names:?}");
    }

    #[test]
    fn no_link_of_rustdoc_is_in_typescript() {
        assert!(!TYPESCRIPT.contains("[`"), "a link of rustdoc is none in TypeScript");
    }
}
