//! How long a text takes: to read, and to work its exercises.
//!
//! Adults read non-fiction at 238 words a minute in the mean of 190 studies (M. Brysbaert, "How many words do we read
//! per minute?", Journal of Memory and Language 109, 2019). For what is not words no such mean is known. Those rates
//! are ours, and round.

use serde::Serialize;

use crate::piece::Piece;
use crate::tree::{Kind, Node};

/// Words a minute. A formula, a number or a reference within a line is read as a word.
const WORDS: f64 = 238.0;
/// Minutes for a formula on lines of its own, a listing, a question, and a figure to work with.
const DISPLAY: f64 = 0.25;
const LISTING: f64 = 1.0;
const QUESTION: f64 = 0.5;
const FIGURE: f64 = 3.0;
/// Minutes for an exercise with its answer, by difficulty.
const EXERCISES: [f64; 4] = [5.0, 10.0, 20.0, 60.0];

/// Times in minutes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ReadingTime {
    /// For the text with its derivations, figures and questions.
    pub text: f64,
    /// For the exercises.
    pub exercises: f64,
}

impl ReadingTime {
    /// The times of `nodes`.
    pub fn of(nodes: &[Node]) -> Self {
        let mut reading = Self::default();
        nodes.iter().for_each(|node| reading.add(node));
        reading
    }

    fn add(&mut self, node: &Node) {
        self.text += match &node.kind {
            Kind::Text(text) | Kind::Code(text) => text.split_whitespace().count() as f64 / WORDS,
            Kind::Piece(Piece::Math(_) | Piece::Number(_) | Piece::Ref(_)) => 1.0 / WORDS,
            Kind::Piece(Piece::DisplayMath(_)) => DISPLAY,
            Kind::Piece(Piece::Listing { .. } | Piece::Output(_)) => LISTING,
            Kind::Piece(Piece::Directive { name, attributes }) => match name.as_str() {
                "exercise" => {
                    let level = attributes.value("difficulty").and_then(|level| level.parse::<usize>().ok());
                    self.exercises += level.and_then(|level| EXERCISES.get(level.checked_sub(1)?)).unwrap_or(&0.0);
                    return;
                }
                "quiz" => QUESTION,
                "figure" => FIGURE,
                _ => 0.0,
            },
            _ => 0.0,
        };
        node.children.iter().for_each(|child| self.add(child));
    }

    /// Both in words, to five minutes, as in "1 h 35 min"; nothing for exercises where there are none.
    pub fn words(&self) -> [String; 2] {
        [self.text, self.exercises].map(|minutes| {
            let minutes = (minutes / 5.0).round() as u32 * 5;
            let part = |n: u32, unit: &str| if n == 0 { String::new() } else { format!("{n}\u{a0}{unit}") };
            format!("{} {}", part(minutes / 60, "h"), part(minutes % 60, "min")).trim().to_string()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::{Diagnostics, Place};
    use crate::parse::parse;

    fn reading(text: &str) -> ReadingTime {
        ReadingTime::of(&parse(text, &Place::new("a.md", 1), &Diagnostics::default()))
    }

    #[test]
    fn words_formulas_figures_and_questions_take_their_time() {
        assert!((reading(&"word ".repeat(236)).text - 236.0 / WORDS).abs() < 1e-12);
        assert!((reading("The *value* $x$.\n").text - 4.0 / WORDS).abs() < 1e-12);
        let own = "$$\nx\n$$\n\n:::figure{#f widget=\"a\"}\n:::\n\n:::figure{#g widget=\"a\"}\n:::\n\n\
            :::quiz{id=\"q\"}\n:::\n";
        assert!((reading(own).text - (DISPLAY + 2.0 * FIGURE + QUESTION)).abs() < 1e-12);
    }

    #[test]
    fn an_exercise_counts_by_its_difficulty_and_not_by_its_words() {
        let text = |level: &str| {
            format!(":::exercise{{#e title=\"t\" kind=\"practical\" difficulty=\"{level}\"}}\nMany words.\n:::\n")
        };
        assert_eq!(reading(&text("4")), ReadingTime { text: 0.0, exercises: 60.0 });
        assert_eq!(reading(&(text("1") + &text("2"))).exercises, 15.0);
        assert_eq!(reading(&text("0")).exercises, 0.0);
    }

    #[test]
    fn times_are_told_to_five_minutes() {
        let words = ReadingTime { text: 96.0, exercises: 0.0 }.words();
        assert_eq!(words, ["1\u{a0}h 35\u{a0}min", ""]);
        assert_eq!(ReadingTime { text: 42.0, exercises: 181.0 }.words(), ["40\u{a0}min", "3\u{a0}h"]);
    }
}
