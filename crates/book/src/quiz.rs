//! `content/quizzes/`: questions, checked at build.

use std::collections::BTreeMap;

use lab::Figure;
use serde::Deserialize;
use serde_json::json;

use crate::config::{DataFile, Text};
use crate::diagnostic::Diagnostics;
use crate::hash::fnv1a;
use crate::number::Numbers;
use state::{RawCondition, State};
use values::Values;

pub mod state;
pub mod values;

/// A question.
#[derive(Clone, Debug)]
pub struct Quiz {
    /// What it asks and explains.
    pub asked: Asked,
    /// How it is answered.
    pub answer: Answer,
    /// What changes with all that a reader is asked and told: eight digits.
    pub hash: String,
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
            Self::State(state) => state.key.clone(),
        };
        key.to_string().bytes().map(|byte| format!("{byte:02x}")).collect()
    }
}

/// One choice.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Choice {
    /// The choice, in Markdown.
    pub text: Text,
    /// Whether it is the right one.
    #[serde(default)]
    pub right: bool,
    /// Why it is right or wrong, in Markdown.
    #[serde(default)]
    pub why: Text,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    quiz: Vec<Asked>,
}

/// A question as the file has it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Asked {
    /// Name; the element's id is `quiz-<id>`.
    id: Text,
    /// Title, in Markdown.
    pub title: Option<Text>,
    /// The question, in Markdown.
    pub prompt: Text,
    kind: Kind,
    /// The explanation, in Markdown.
    pub why: Text,
    /// The figure that stays locked until the reader has committed.
    pub unlocks: Option<Text>,
    answer: Option<String>,
    tolerance: Option<f64>,
    least: Option<String>,
    most: Option<String>,
    #[serde(default)]
    direction: bool,
    #[serde(default)]
    unit: String,
    format: Option<String>,
    #[serde(default)]
    choice: Vec<Choice>,
    #[serde(default)]
    near: Vec<RawNear>,
    figure: Option<Text>,
    widget: Option<String>,
    #[serde(default)]
    condition: Vec<RawCondition>,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Choice,
    Number,
    Vector,
    State,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawNear {
    value: Text,
    #[serde(default)]
    why: Text,
}

/// The questions of all `files` by id; what is wrong with them goes to `diagnostics`.
pub fn quizzes(
    files: &[DataFile],
    numbers: &Numbers,
    figures: &[Figure],
    diagnostics: &Diagnostics,
) -> BTreeMap<String, Quiz> {
    let mut quizzes = BTreeMap::new();
    for asked in files.iter().flat_map(|file| file.parse::<File>(diagnostics).quiz) {
        let Text { markdown: id, place } = asked.id.clone();
        let reader = Reader { numbers, figures, diagnostics, asked: &asked };
        let answer = match asked.kind {
            Kind::Choice => reader.choice(),
            Kind::Number | Kind::Vector => reader.values(),
            Kind::State => reader.state(),
        };
        let Some(answer) = diagnostics.ok(&place, answer.map_err(|error| format!("quiz `{id}`: {error}"))) else {
            continue;
        };
        let hash = hash(&asked, &answer);
        if quizzes.insert(id.clone(), Quiz { asked, answer, hash }).is_some() {
            diagnostics.report(&place, format!("two quizzes are called `{id}`"));
        }
    }
    quizzes
}

struct Reader<'a> {
    numbers: &'a Numbers,
    figures: &'a [Figure],
    diagnostics: &'a Diagnostics,
    asked: &'a Asked,
}

impl Reader<'_> {
    fn choice(&self) -> Result<Answer, String> {
        self.only(&["choice"])?;
        let choices = &self.asked.choice;
        let (count, right) = (choices.len(), choices.iter().filter(|choice| choice.right).count());
        if count < 2 || right != 1 {
            return Err(format!(
                "{count} choices, {right} of them right; two or more with exactly one right are wanted"
            ));
        }
        for (i, one) in choices.iter().enumerate() {
            self.needs_reason(&one.text, &one.why);
            if choices[..i].iter().any(|other| other.text.markdown == one.text.markdown) {
                return Err(format!("the choice `{}` stands twice", one.text.markdown));
            }
        }
        Ok(Answer::Choice(choices.clone()))
    }

    /// Refuses what belongs to questions of another kind.
    fn only(&self, allowed: &[&str]) -> Result<(), String> {
        let asked = self.asked;
        let given = [
            ("choice", !asked.choice.is_empty()),
            ("answer", asked.answer.is_some()),
            ("tolerance", asked.tolerance.is_some()),
            ("least", asked.least.is_some()),
            ("most", asked.most.is_some()),
            ("direction", asked.direction),
            ("near", !asked.near.is_empty()),
            ("figure", asked.figure.is_some()),
            ("widget", asked.widget.is_some()),
            ("condition", !asked.condition.is_empty()),
        ];
        let stray = given.iter().find(|(name, given)| *given && !allowed.contains(name));
        stray.map_or(Ok(()), |(name, _)| Err(format!("a question of this kind has no `{name}`")))
    }

    /// Every choice and every well-known wrong answer needs a reason of its own.
    fn needs_reason(&self, of: &Text, why: &Text) {
        if why.markdown.trim().is_empty() {
            let message = format!("quiz `{}`: `{}` has no reason (why)", self.asked.id.markdown, of.markdown);
            self.diagnostics.report(&of.place, message);
        }
    }
}

/// The upper half of FNV-1a over everything a reader is asked and told. It tells one wording of a question from
/// another, and stands in the page once for each question: more digits would only weigh.
fn hash(asked: &Asked, answer: &Answer) -> String {
    let texts = [Some(&asked.id), Some(&asked.prompt), Some(&asked.why), asked.title.as_ref()];
    let mut parts: Vec<String> = texts.into_iter().flatten().map(|text| text.markdown.clone()).collect();
    match answer {
        Answer::Choice(choices) => {
            for choice in choices {
                parts.extend([choice.text.markdown.clone(), choice.right.to_string(), choice.why.markdown.clone()]);
            }
        }
        Answer::Values(values) => parts.extend(values.parts()),
        Answer::State(state) => parts.extend(state.parts()),
    }
    format!("{:08x}", fnv1a(parts.join("\u{0}").as_bytes()) >> 32)
}

#[cfg(test)]
mod tests;
