//! `content/quizzes.toml`: questions, checked at build.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::json;
use toml::Spanned;

use crate::config::{DataFile, Text};
use crate::diagnostic::Diagnostics;
use crate::hash::fnv1a;
use crate::number::Numbers;
use state::{RawCondition, State};
use values::Values;

pub mod state;
pub mod values;

/// A question to answer before the explanation.
#[derive(Clone, Debug)]
pub struct Quiz {
    /// Name; the element's id is `quiz-<id>`.
    pub id: String,
    /// Title, in Markdown.
    pub title: Option<Text>,
    /// The question, in Markdown.
    pub prompt: Text,
    /// How it is answered.
    pub answer: Answer,
    /// The explanation, in Markdown.
    pub why: Text,
    /// The figure that stays locked until the reader has committed.
    pub unlocks: Option<Text>,
    /// Hash of all that a reader is asked and told.
    pub hash: u64,
}

/// How a quiz is answered.
#[derive(Clone, Debug)]
pub enum Answer {
    /// By choosing.
    Choice(Vec<Choice>),
    /// By a number, or by the entries of a vector.
    Values(Values),
    /// By setting a figure.
    State(State),
}

impl Answer {
    /// What the page compares a reader's answer with, as JSON in hexadecimal digits: nobody reads it in passing.
    pub fn key(&self) -> String {
        let key = match self {
            Self::Choice(choices) => json!({ "right": choices.iter().position(|choice| choice.right) }),
            Self::Values(values) => values.key(),
            Self::State(state) => state.key(),
        };
        key.to_string().bytes().map(|byte| format!("{byte:02x}")).collect()
    }
}

/// One choice.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The choice, in Markdown.
    pub text: Text,
    /// Whether it is the right one.
    pub right: bool,
    /// Why it is right or wrong, in Markdown.
    pub why: Text,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFile {
    #[serde(default)]
    quiz: Vec<RawQuiz>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawQuiz {
    id: Spanned<String>,
    title: Option<Spanned<String>>,
    prompt: Spanned<String>,
    kind: Spanned<Kind>,
    answer: Option<Spanned<String>>,
    tolerance: Option<f64>,
    #[serde(default)]
    direction: bool,
    #[serde(default)]
    unit: String,
    format: Option<String>,
    why: Spanned<String>,
    unlocks: Option<Spanned<String>>,
    #[serde(default)]
    choice: Vec<RawChoice>,
    #[serde(default)]
    near: Vec<RawNear>,
    figure: Option<Spanned<String>>,
    widget: Option<Spanned<String>>,
    #[serde(default)]
    condition: Vec<RawCondition>,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Choice,
    Number,
    Vector,
    State,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawChoice {
    text: Spanned<String>,
    #[serde(default)]
    right: bool,
    why: Option<Spanned<String>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawNear {
    value: Spanned<String>,
    why: Option<Spanned<String>>,
}

/// The questions by id; what is wrong with them goes to `diagnostics`.
pub fn quizzes(file: &DataFile, numbers: &Numbers, diagnostics: &Diagnostics) -> BTreeMap<String, Quiz> {
    let raw: RawFile = file.parse(diagnostics);
    let mut quizzes = BTreeMap::new();
    for raw in &raw.quiz {
        let id = raw.id.get_ref().clone();
        let place = file.place(&raw.id);
        let reader = Reader { file, numbers, diagnostics, raw };
        let answer = match raw.kind.get_ref() {
            Kind::Choice => reader.choice(),
            Kind::Number | Kind::Vector => reader.values(),
            Kind::State => reader.state(),
        };
        let Some(answer) = diagnostics.ok(&place, answer.map_err(|error| format!("quiz `{id}`: {error}"))) else {
            continue;
        };
        let quiz = Quiz {
            hash: hash(raw, &answer),
            title: raw.title.as_ref().map(|title| Text::of(title, file)),
            prompt: Text::of(&raw.prompt, file),
            why: Text::of(&raw.why, file),
            unlocks: raw.unlocks.as_ref().map(|unlocks| Text::of(unlocks, file)),
            id: id.clone(),
            answer,
        };
        if quizzes.insert(id.clone(), quiz).is_some() {
            diagnostics.report(&place, format!("two quizzes are called `{id}`"));
        }
    }
    quizzes
}

struct Reader<'a> {
    file: &'a DataFile,
    numbers: &'a Numbers,
    diagnostics: &'a Diagnostics,
    raw: &'a RawQuiz,
}

impl Reader<'_> {
    fn choice(&self) -> Result<Answer, String> {
        self.only(&["choice"])?;
        let right = self.raw.choice.iter().filter(|choice| choice.right).count();
        if self.raw.choice.len() < 2 || right != 1 {
            let count = self.raw.choice.len();
            return Err(format!(
                "{count} choices, {right} of them right; two or more with exactly one right are wanted"
            ));
        }
        let choice = |raw: &RawChoice| {
            let why = self.reason(&raw.text, raw.why.as_ref())?;
            Some(Choice { text: Text::of(&raw.text, self.file), right: raw.right, why })
        };
        let choices: Vec<_> = self.raw.choice.iter().filter_map(choice).collect();
        for (i, one) in choices.iter().enumerate() {
            if choices[..i].iter().any(|other| other.text.markdown == one.text.markdown) {
                return Err(format!("the choice `{}` stands twice", one.text.markdown));
            }
        }
        Ok(Answer::Choice(choices))
    }

    /// Refuses what belongs to questions of another kind.
    fn only(&self, allowed: &[&str]) -> Result<(), String> {
        let raw = self.raw;
        let given = [
            ("choice", !raw.choice.is_empty()),
            ("answer", raw.answer.is_some()),
            ("tolerance", raw.tolerance.is_some()),
            ("direction", raw.direction),
            ("near", !raw.near.is_empty()),
            ("figure", raw.figure.is_some()),
            ("widget", raw.widget.is_some()),
            ("condition", !raw.condition.is_empty()),
        ];
        let stray = given.iter().find(|(name, given)| *given && !allowed.contains(name));
        stray.map_or(Ok(()), |(name, _)| Err(format!("a question of this kind has no `{name}`")))
    }

    /// The reason of a choice; every one needs its own.
    fn reason(&self, of: &Spanned<String>, why: Option<&Spanned<String>>) -> Option<Text> {
        let why = why.filter(|why| !why.get_ref().trim().is_empty());
        if why.is_none() {
            let message = format!("quiz `{}`: `{}` has no reason (why)", self.raw.id.get_ref(), of.get_ref());
            self.diagnostics.report(&self.file.place(of), message);
        }
        why.map(|why| Text::of(why, self.file))
    }
}

/// FNV-1a over everything a reader is asked and told.
fn hash(raw: &RawQuiz, answer: &Answer) -> u64 {
    let mut parts = vec![raw.id.get_ref().clone(), raw.prompt.get_ref().clone(), raw.why.get_ref().clone()];
    parts.extend(raw.title.as_ref().map(|title| title.get_ref().clone()));
    match answer {
        Answer::Choice(choices) => {
            for choice in choices {
                parts.extend([choice.text.markdown.clone(), choice.right.to_string(), choice.why.markdown.clone()]);
            }
        }
        Answer::Values(values) => parts.extend(values.parts()),
        Answer::State(state) => parts.extend(state.parts()),
    }
    fnv1a(parts.join("\u{0}").as_bytes())
}

#[cfg(test)]
mod tests;
