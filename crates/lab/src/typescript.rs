//! TypeScript written from declarations while the crate is compiled: no second copy is kept anywhere.

use crate::interface::About;
use crate::lab::Lab;
use crate::shape::{Plain, Shape};
use crate::text::Text;

/// How many bytes the interfaces may have; a compilation with more ends.
pub const LONGEST: usize = 130_000;

/// These interfaces. The names `Vector` and `Matrix` are left to whoever includes this.
pub const fn written(mut groups: &[&[&[About]]]) -> Text<LONGEST> {
    let mut text = Text::new();
    while let [group, rest @ ..] = groups {
        let mut records = *group;
        while let [some, others @ ..] = records {
            let mut i = 0;
            while i < some.len() {
                put_interface(&mut text, &some[i]);
                i += 1;
            }
            records = others;
        }
        groups = rest;
    }
    text
}

/// The class of the lab `L`, which JavaScript calls `class`; `world` is the type of what it stands on, empty where that
/// is nothing. What all labs do is in the interface `Lab`, which is left to whoever includes this.
pub const fn class<L: Lab>(class: &str, world: &str) -> Text<1_000> {
    let (Shape::Record(params, _), Shape::Record(frame, _)) = (L::Params::SHAPE, L::Frame::SHAPE) else {
        panic!("parameters and frame are records")
    };
    let (first, more) = if world.is_empty() { ("", "") } else { ("log: ", ", ") };
    let mut text = Text::new();
    text.put_all(&["/** ", L::ABOUT, " */\nexport class ", class, " {\n"]);
    text.put("    /** The lab at step 0; what `params` leaves out takes its default. */\n");
    text.put_all(&["    constructor(", first, world, more, "params?: Partial<", params, ">);\n"]);
    text.put("    /** The lab in a state that `state()` answered. */\n");
    text.put_all(&["    static from(", first, world, more, "state: LabState<", params, ">): ", class, ";\n"]);
    text.put("    /** The parameters: how far each goes, in which steps, and its default. */\n");
    text.put("    static parameters(): Parameter[];\n");
    text.put("    /** The last step a run can reach. */\n    static lastStep(): number;\n}\n");
    text.put_all(&["export interface ", class, " extends Lab<", params, ", ", frame, "> {}\n"]);
    text
}

const fn put_interface<const N: usize>(text: &mut Text<N>, about: &About) {
    let (name, fields, sparse) = match about.shape {
        Shape::Record(name, fields) => (name, fields, false),
        Shape::Sparse(name, fields) => (name, fields, true),
        _ => panic!("an interface is of a record"),
    };
    text.put_all(&["/**", about.record, " */\nexport interface ", name, " {\n"]);
    let mut i = 0;
    while i < fields.len() {
        text.put_all(&["    /**", about.fields[i]]);
        if i < about.parameters.len() {
            put_limits(text, about.parameters[i].bounds, about.defaults[i]);
        }
        text.put_all(&[" */\n    ", fields[i].name, if sparse { "?: " } else { ": " }]);
        match &fields[i].shape {
            Shape::Maybe(value) if sparse => put_type(text, value),
            shape => put_type(text, shape),
        }
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
        Shape::Record(name, _) | Shape::Sparse(name, _) => text.put(name),
        Shape::Exactly(_, entry) | Shape::List(entry) | Shape::Between(_, _, entry) => match entry {
            Shape::Number | Shape::Whole => text.put("Vector"),
            Shape::Exactly(_, Shape::Number) | Shape::List(Shape::Number) | Shape::Between(_, _, Shape::Number) => {
                text.put("Matrix");
            }
            Shape::Maybe(_) | Shape::Each(..) | Shape::Word(_) => {
                text.put("(");
                put_type(text, entry);
                text.put(")[]");
            }
            _ => {
                put_type(text, entry);
                text.put("[]");
            }
        },
        Shape::Maybe(value) => {
            put_type(text, value);
            text.put(" | null");
        }
        Shape::Each(names, value) => {
            put_type(text, value);
            text.put(" | { ");
            let mut i = 0;
            while i < names.len() {
                text.put_all(&[if i == 0 { "" } else { "; " }, names[i], "?: "]);
                put_type(text, value);
                i += 1;
            }
            text.put(" }");
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
