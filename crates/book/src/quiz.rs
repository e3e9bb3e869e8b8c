//! `content/quizzes.toml`: questions, checked at build.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

use crate::config::{DataFile, Text};
use crate::diagnostic::Diagnostics;
use crate::hash::fnv1a;
use crate::number::{Format, Numbers};

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
    /// By a number.
    Number {
        /// Id of the right number.
        id: String,
        /// Its value.
        value: f64,
        /// How far off is still right.
        tolerance: f64,
        /// How it is printed.
        format: Format,
        /// Its unit.
        unit: String,
        /// Wrong answers worth recognising, tried in order.
        near: Vec<Near>,
    },
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

/// A wrong number with its reason.
#[derive(Clone, Debug)]
pub struct Near {
    /// The wrong value.
    pub value: f64,
    /// Why it is wrong, in Markdown.
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
    unit: String,
    format: Option<String>,
    why: Spanned<String>,
    unlocks: Option<Spanned<String>>,
    #[serde(default)]
    choice: Vec<RawChoice>,
    #[serde(default)]
    near: Vec<RawNear>,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Choice,
    Number,
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
            Kind::Number => reader.number(),
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
        if self.raw.answer.is_some() || !self.raw.near.is_empty() || self.raw.tolerance.is_some() {
            return Err("a question with choices has no answer, near or tolerance".into());
        }
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

    fn number(&self) -> Result<Answer, String> {
        if !self.raw.choice.is_empty() {
            return Err("a question for a number has no choices".into());
        }
        let id = self.raw.answer.as_ref().ok_or("the answer is missing: the id of a number")?.get_ref();
        let value = self.numbers.get(id)?.value;
        let tolerance =
            self.raw.tolerance.filter(|&tolerance| tolerance > 0.0).ok_or("a positive tolerance is missing")?;
        let format = Format::parse(self.raw.format.as_deref().unwrap_or(".3f"))?;
        format.html(value)?;
        let near = |raw: &RawNear| {
            let why = self.reason(&raw.value, raw.why.as_ref())?;
            let place = self.file.place(&raw.value);
            // A value as it stands, or the id of a computed one.
            let id = raw.value.get_ref();
            let near = id.parse().or_else(|_| self.numbers.get(id).map(|number| number.value));
            let near: f64 = self.diagnostics.ok(&place, near)?;
            if (near - value).abs() <= tolerance {
                self.diagnostics
                    .report(&place, format!("`{id}` is wrong by no more than the tolerance: a right answer"));
            }
            Some(Near { value: near, why })
        };
        let near = self.raw.near.iter().filter_map(near).collect();
        Ok(Answer::Number { id: id.clone(), value, tolerance, format, unit: self.raw.unit.clone(), near })
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
        Answer::Number { value, tolerance, format, unit, near, .. } => {
            parts.extend([format.html(*value).unwrap_or_default(), tolerance.to_string(), unit.clone()]);
            for near in near {
                parts.extend([format.html(near.value).unwrap_or_default(), near.why.markdown.clone()]);
            }
        }
    }
    fnv1a(parts.join("\u{0}").as_bytes())
}

#[cfg(test)]
mod tests;
