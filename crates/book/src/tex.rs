//! Formulas: TeX to HTML with MathML, once in Choset's letters and once in Thrun's.

use std::collections::BTreeMap;

use katex::macros::MacroDefinition;
use katex::{KatexContext, Settings, TrustSetting};
use serde::Deserialize;

use crate::slim::{Reading, slim};

/// `content/macros.toml`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Macros {
    /// Read the same in either notation.
    #[serde(default)]
    both: BTreeMap<String, String>,
    /// Read twice.
    #[serde(default)]
    switch: BTreeMap<String, Letters>,
}

/// One symbol in the two notations.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Letters {
    choset: String,
    thrun: String,
}

/// Where a formula stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// In a line of text.
    Inline,
    /// On a line of its own.
    Display,
}

/// Renders formulas with the macros of both notations.
pub struct Typesetter {
    context: KatexContext,
    /// Settings for Choset and Thrun, each inline and display.
    settings: [[Settings; 2]; 2],
}

impl Typesetter {
    /// A typesetter that knows `macros`.
    pub fn new(macros: &Macros) -> Self {
        let settings = |pick: fn(&Letters) -> &String, display: bool| {
            let both = macros.both.iter();
            let all = both.chain(macros.switch.iter().map(|(name, letters)| (name, pick(letters))));
            let definitions =
                all.map(|(name, tex)| (format!("\\{name}"), MacroDefinition::String(tex.clone()))).collect();
            // Trust admits \htmlClass and \htmlData; the formulas are the book's own.
            Settings::builder().display_mode(display).macros(definitions).trust(TrustSetting::Bool(true)).build()
        };
        let pair = |pick| [settings(pick, false), settings(pick, true)];
        Self { context: KatexContext::default(), settings: [pair(|l| &l.choset), pair(|l| &l.thrun)] }
    }

    /// The formula in Choset's and in Thrun's letters; one answer when the two read the same.
    ///
    /// # Errors
    /// KaTeX's message.
    pub fn render(&self, tex: &str, style: Style) -> Result<Formula, String> {
        let display = usize::from(style == Style::Display);
        let [choset, thrun] = &self.settings;
        let choset = self.one(tex, &choset[display])?;
        let thrun = self.one(tex, &thrun[display])?;
        let thrun = if thrun == choset { None } else { Some(thrun) };
        Ok(Formula { choset, thrun })
    }

    fn one(&self, tex: &str, settings: &Settings) -> Result<Reading, String> {
        let html = katex::render_to_string(&self.context, tex, settings)
            .map_err(|error| format!("TeX: {error} in ${tex}$"))?;
        slim(&html)
    }
}

/// A rendered formula.
#[derive(Debug)]
pub struct Formula {
    /// In Choset's letters.
    pub choset: Reading,
    /// In Thrun's letters, where they differ.
    pub thrun: Option<Reading>,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typesetter() -> Typesetter {
        let macros = r"
            [both]
            pred = '\htmlClass{term-prediction}{#1}'
            [switch]
            F = { choset = 'F', thrun = 'A' }
        ";
        Typesetter::new(&toml::from_str(macros).unwrap())
    }

    /// The one reading of a formula that both notations share.
    fn same(typesetter: &Typesetter, tex: &str, style: Style) -> String {
        let formula = typesetter.render(tex, style).unwrap();
        assert!(formula.thrun.is_none(), "{formula:?}");
        formula.choset.html
    }

    #[test]
    fn a_formula_without_switched_letters_is_rendered_once() {
        let html = same(&typesetter(), "x^2", Style::Inline);
        assert!(
            html.contains("<math>") && html.contains("aria-hidden=\"true\"") && !html.contains("annotation"),
            "{html}"
        );
    }

    #[test]
    fn switched_letters_are_rendered_in_both_notations_and_keep_their_colour() {
        let formula = typesetter().render(r"\pred{\F} = 1", Style::Inline).unwrap();
        let (choset, thrun) = (formula.choset.html, formula.thrun.expect("two readings").html);
        assert!(choset.contains("<mi>F</mi>") && thrun.contains("<mi>A</mi>"));
        assert!(choset.contains("term-prediction"));
    }

    #[test]
    fn attributes_are_in_one_order_whatever_the_hash_map_says() {
        for _ in 0..20 {
            let formula =
                typesetter().render(r"x_{k+1|k+1} = \begin{aligned} a &= b \end{aligned}", Style::Display).unwrap();
            assert!(formula.thrun.is_none(), "{formula:?}");
        }
    }

    #[test]
    fn generated_digits_carry_their_number() {
        let html = same(&typesetter(), r"\htmlData{number=step1.S}{2.6}", Style::Display);
        assert!(html.contains("data-number=\"step1.S\""), "{html}");
    }

    #[test]
    fn an_unknown_command_is_an_error() {
        assert!(typesetter().render(r"\nonsense", Style::Inline).unwrap_err().contains("nonsense"));
    }
}
