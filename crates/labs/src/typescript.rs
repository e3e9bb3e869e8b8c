//! The labs' TypeScript: every type that a lab takes or hands out.

use crate::*;
use lab::{About, Interface, Lab, Text, written};

macro_rules! described {
    ($($module:ident::$lab:ident $(of $world:ident)? in $build:literal $(, was $was:literal)?;)*) => {
        /// What the labs take and hand out, and what that is made of.
        const ALL: &[&[&[About]]] = &[
            &[lab::OF_THE_CORE, lab::INTERFACES, lab::LOG_INTERFACES, lab::series::INTERFACES],
            &[shapes::INTERFACES, mapping::INTERFACES],
            $(&[&[<$lab as Lab>::Params::ABOUT]], <$lab as Lab>::INTERFACES,)*
        ];
    };
}

figures!(described);

/// The interfaces of all labs, with their doc comments, limits and defaults. `Vector` and `Matrix` are not among them.
pub const TYPESCRIPT: &str = WRITTEN.as_str();

const WRITTEN: &Text<80_000> = &written(ALL);

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
