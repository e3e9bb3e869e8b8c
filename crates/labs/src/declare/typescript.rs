//! TypeScript written from declarations while the crate is compiled: no second copy is kept anywhere.

use super::parameter::Parameter;
use super::text::{Text, same};

/// A type as TypeScript knows it.
#[derive(Clone, Copy, Debug)]
pub enum Type {
    /// `number`.
    Number,
    /// `boolean`.
    Boolean,
    /// `string`.
    Text,
    /// `"a" | "b"`.
    Words(&'static [&'static str]),
    /// `… | null`.
    Maybe(&'static Type),
    /// `…[]`; `Vector` and `Matrix` for numbers.
    Array(&'static Type),
    /// An interface.
    Record(&'static Declaration),
}

/// An interface.
#[derive(Debug)]
pub struct Declaration {
    /// Its name.
    pub name: &'static str,
    /// The lines of its doc comment.
    pub about: &'static [&'static str],
    /// Its members.
    pub members: &'static [Member],
    /// The limits of each, where they are parameters.
    pub parameters: &'static [Parameter],
}

/// A member of an interface.
#[derive(Debug)]
pub struct Member {
    /// Its name.
    pub name: &'static str,
    /// The lines of its doc comment.
    pub about: &'static [&'static str],
    /// Its default; empty where there is none to show.
    pub default: &'static str,
    /// Its type.
    pub of: Type,
}

type Found = [Option<&'static Declaration>; 64];

/// The interfaces that these types are made of, each once. The names `Vector` and `Matrix` are left to whoever includes this.
pub const fn written(roots: &[Type]) -> Text<20_000> {
    let (mut found, mut i): (Found, usize) = ([None; 64], 0);
    while i < roots.len() {
        collect(&roots[i], &mut found);
        i += 1;
    }
    let mut text = Text::new();
    i = 0;
    while let Some(declaration) = found[i] {
        put_declaration(&mut text, declaration);
        i += 1;
    }
    text
}

/// Adds the interfaces that `of` speaks of, each once.
const fn collect(of: &Type, found: &mut Found) {
    match of {
        Type::Maybe(inner) | Type::Array(inner) => collect(inner, found),
        Type::Record(declaration) => {
            let mut i = 0;
            while let Some(known) = found[i] {
                if same(known.name, declaration.name) {
                    return;
                }
                i += 1;
            }
            found[i] = Some(declaration);
            i = 0;
            while i < declaration.members.len() {
                collect(&declaration.members[i].of, found);
                i += 1;
            }
        }
        Type::Number | Type::Boolean | Type::Text | Type::Words(_) => {}
    }
}

const fn put_declaration<const N: usize>(text: &mut Text<N>, declaration: &Declaration) {
    text.put("/**");
    put_lines(text, declaration.about);
    text.put(" */\nexport interface ");
    text.put(declaration.name);
    text.put(" {\n");
    let mut i = 0;
    while i < declaration.members.len() {
        let member = &declaration.members[i];
        text.put("    /**");
        put_lines(text, member.about);
        if i < declaration.parameters.len() && !declaration.parameters[i].bounds.is_empty() {
            text.put(" Goes ");
            text.put(declaration.parameters[i].bounds);
            text.put(".");
        }
        if !member.default.is_empty() {
            text.put(" Default ");
            text.put(member.default);
            text.put(".");
        }
        text.put(" */\n    ");
        text.put(member.name);
        text.put(": ");
        put_type(text, &member.of);
        text.put(";\n");
        i += 1;
    }
    text.put("}\n");
}

const fn put_lines<const N: usize>(text: &mut Text<N>, lines: &[&str]) {
    let mut i = 0;
    while i < lines.len() {
        text.put(lines[i]);
        i += 1;
    }
}

const fn put_type<const N: usize>(text: &mut Text<N>, of: &Type) {
    match of {
        Type::Number => text.put("number"),
        Type::Boolean => text.put("boolean"),
        Type::Text => text.put("string"),
        Type::Record(declaration) => text.put(declaration.name),
        Type::Array(Type::Number) => text.put("Vector"),
        Type::Array(Type::Array(Type::Number)) => text.put("Matrix"),
        Type::Array(entry) => {
            put_type(text, entry);
            text.put("[]");
        }
        Type::Maybe(value) => {
            put_type(text, value);
            text.put(" | null");
        }
        Type::Words(words) => {
            let mut i = 0;
            while i < words.len() {
                text.put(if i == 0 { "\"" } else { " | \"" });
                text.put(words[i]);
                text.put("\"");
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
    fn what_is_written_for_rust_s_own_documentation_does_not_slip_in() {
        assert!(!TYPESCRIPT.contains("[`"), "a link of rustdoc is none in TypeScript");
    }
}
