//! Formulas: TeX to HTML with MathML, once in the letters of each notation.

use std::collections::BTreeMap;

use katex::macros::MacroDefinition;
use katex::{KatexContext, Settings, TrustSetting};
use serde::Deserialize;

use crate::notation::{COUNT, Letters};
use crate::slim::{Typeset, slim};

/// `content/macros.toml`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Macros {
    /// Read the same in every notation.
    #[serde(default)]
    all: BTreeMap<String, String>,
    /// Read once in each notation.
    #[serde(default)]
    switch: BTreeMap<String, Letters>,
}

/// Where a formula stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// In a line of text.
    Inline,
    /// On a line of its own.
    Display,
}

/// Renders formulas with the macros of each notation.
pub struct Typesetter {
    context: KatexContext,
    /// Settings of each notation, inline and display.
    settings: [[Settings; 2]; COUNT],
}

impl Typesetter {
    /// A typesetter that knows `macros`.
    pub fn new(macros: &Macros) -> Self {
        let settings = |notation: usize, display: bool| {
            let switch = macros.switch.iter().map(|(name, letters)| (name, letters.of(notation)));
            let all = macros.all.iter().map(|(name, tex)| (name, tex.as_str())).chain(switch);
            let definitions =
                all.map(|(name, tex)| (format!("\\{name}"), MacroDefinition::String(tex.to_string()))).collect();
            // Trust admits \htmlClass and \htmlData; the formulas are the book's own.
            Settings::builder().display_mode(display).macros(definitions).trust(TrustSetting::Bool(true)).build()
        };
        let pair = |notation| [settings(notation, false), settings(notation, true)];
        Self { context: KatexContext::default(), settings: std::array::from_fn(pair) }
    }

    /// The formula in the letters of each notation.
    ///
    /// # Errors
    /// KaTeX's message.
    pub fn render(&self, tex: &str, style: Style) -> Result<Formula, String> {
        let display = usize::from(style == Style::Display);
        let readings = self.settings.iter().map(|settings| self.one(tex, &settings[display]));
        Ok(Formula { readings: readings.collect::<Result<_, _>>()? })
    }

    fn one(&self, tex: &str, settings: &Settings) -> Result<Typeset, String> {
        let html = katex::render_to_string(&self.context, tex, settings)
            .map_err(|error| format!("TeX: {error} in ${tex}$"))?;
        slim(&html)
    }
}

/// A rendered formula.
#[derive(Debug)]
pub struct Formula {
    /// Its readings, in the order of [`crate::notation::NOTATIONS`].
    readings: Vec<Typeset>,
}

impl Formula {
    /// In the page's own letters.
    pub fn own(&self) -> &Typeset {
        &self.readings[0]
    }

    /// In the letters of the other notations, if any of these reads differently: empty where one reads as the page's
    /// own.
    pub fn others(&self) -> Option<Vec<String>> {
        let (own, others) = self.readings.split_first()?;
        let html = |reading: &Typeset| if reading == own { String::new() } else { reading.html.clone() };
        others.iter().any(|reading| reading != own).then(|| others.iter().map(html).collect())
    }

    /// Whether it is plain text, without boxes, in every notation.
    pub fn plain(&self) -> bool {
        self.readings.iter().all(|reading| reading.plain)
    }

    /// Its readings as HTML, in the order of [`crate::notation::NOTATIONS`].
    pub fn html(self) -> impl Iterator<Item = String> {
        self.readings.into_iter().map(|reading| reading.html)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typesetter() -> Typesetter {
        let macros = r"
            [all]
            pred = '\htmlClass{term-prediction}{#1}'
            [switch]
            F = { choset = 'F', thrun = 'A' }
        ";
        Typesetter::new(&toml::from_str(macros).unwrap())
    }

    /// The one reading of a formula that all notations share.
    fn same(typesetter: &Typesetter, tex: &str, style: Style) -> String {
        let formula = typesetter.render(tex, style).unwrap();
        assert!(formula.others().is_none(), "{formula:?}");
        formula.own().html.clone()
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
    fn switched_letters_are_rendered_in_every_notation_and_keep_their_colour() {
        let formula = typesetter().render(r"\pred{\F} = 1", Style::Inline).unwrap();
        let [thrun, common] = formula.others().expect("other readings").try_into().unwrap();
        let own = &formula.own().html;
        assert!(own.contains("<mi>F</mi>") && thrun.contains("<mi>A</mi>"));
        assert_eq!(common, "", "a notation that is not given has the page's own letters");
        assert!(own.contains("term-prediction"));
    }

    #[test]
    fn attributes_are_in_one_order_whatever_the_hash_map_says() {
        for _ in 0..20 {
            let formula =
                typesetter().render(r"x_{k+1|k+1} = \begin{aligned} a &= b \end{aligned}", Style::Display).unwrap();
            assert!(formula.others().is_none(), "{formula:?}");
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
