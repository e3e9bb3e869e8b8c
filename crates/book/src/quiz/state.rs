//! Answers that are states of a figure: conditions on its frame, which the build holds against the frame's shape.

use labs::{Lab, ObservabilityProbe, ObserverBench, OdometryHook, Picture, Plain, Shape};
use serde::Deserialize;
use serde_json::json;
use toml::Spanned;

use super::{Answer, Reader};
use crate::config::Text;

/// A figure, and what has to hold there.
#[derive(Clone, Debug)]
pub struct State {
    /// The figure's id.
    pub figure: Text,
    /// The conditions; all have to hold.
    pub conditions: Vec<Condition>,
}

/// A condition on one value of a figure's frame.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Where the value stands, as in `params.gain` or `landmarks.length`.
    pub path: String,
    /// What it has to be.
    pub test: Test,
    /// What a reader still has to do, in Markdown.
    pub todo: Text,
}

/// What a value of a frame has to be.
#[derive(Clone, Debug)]
pub enum Test {
    /// This word, or `true` or `false`.
    Is(String),
    /// A number from the first to the second.
    Within(f64, f64),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawCondition {
    path: Spanned<String>,
    is: Option<String>,
    least: Option<String>,
    most: Option<String>,
    #[serde(default)]
    within: f64,
    todo: Spanned<String>,
}

impl State {
    pub(super) fn key(&self) -> serde_json::Value {
        let condition = |condition: &Condition| match &condition.test {
            Test::Is(word) => json!({ "path": condition.path, "is": word }),
            Test::Within(least, most) => json!({ "path": condition.path, "least": least, "most": most }),
        };
        json!({ "conditions": self.conditions.iter().map(condition).collect::<Vec<_>>() })
    }

    /// What a reader is asked and told.
    pub(super) fn parts(&self) -> Vec<String> {
        let todo = self.conditions.iter().map(|condition| condition.todo.markdown.clone());
        [self.figure.markdown.clone(), self.key().to_string()].into_iter().chain(todo).collect()
    }
}

impl Reader<'_> {
    pub(super) fn state(&self) -> Result<Answer, String> {
        self.only(&["figure", "widget", "condition"])?;
        let figure = self.raw.figure.as_ref().ok_or("the figure is missing: its id")?;
        let widget = self.raw.widget.as_ref().ok_or("the figure's widget is missing")?.get_ref();
        let frame = frame(widget).ok_or_else(|| format!("no widget is called `{widget}`"))?;
        if self.raw.condition.is_empty() {
            return Err("a state has one condition or more".into());
        }
        let condition = |raw: &RawCondition| {
            let condition = self.condition(raw, &frame);
            self.diagnostics.ok(&self.file.place(&raw.path), condition)
        };
        let conditions = self.raw.condition.iter().filter_map(condition).collect();
        Ok(Answer::State(State { figure: Text::of(figure, self.file), conditions }))
    }

    fn condition(&self, raw: &RawCondition, frame: &Shape) -> Result<Condition, String> {
        let path = raw.path.get_ref();
        let shape = at(frame, path).ok_or_else(|| format!("the figure's frame has no `{path}`"))?;
        let bound = |bound: &Option<String>, otherwise: f64| match bound {
            Some(id) => id.parse().or_else(|_| self.numbers.get(id).map(|number| number.value)),
            None => Ok(otherwise),
        };
        let test = match (&raw.is, shape) {
            (Some(word), Shape::Word(words)) if words.contains(&word.as_str()) => Test::Is(word.clone()),
            (Some(word), Shape::Flag) if ["true", "false"].contains(&word.as_str()) => Test::Is(word.clone()),
            (Some(word), _) => return Err(format!("`{path}` is never `{word}`")),
            (None, Shape::Number | Shape::Whole) if raw.least.is_some() || raw.most.is_some() => {
                let least = bound(&raw.least, f64::MIN)? - raw.within;
                Test::Within(least, bound(&raw.most, f64::MAX)? + raw.within)
            }
            (None, _) => return Err(format!("`{path}` wants `is`, or `least` or `most` where it is a number")),
        };
        if matches!(test, Test::Within(least, most) if least > most) {
            return Err(format!("no number is within the bounds of `{path}`"));
        }
        Ok(Condition { path: path.clone(), test, todo: Text::of(&raw.todo, self.file) })
    }
}

/// What a frame of the widget holds.
fn frame(widget: &str) -> Option<Shape> {
    fn of<L: Lab>() -> Shape {
        L::Frame::SHAPE
    }
    Some(match widget {
        "observer-bench" => of::<ObserverBench>(),
        "odometry-hook" => of::<OdometryHook>(),
        "observability-probe" => of::<ObservabilityProbe>(),
        "kalman-picture" => of::<Picture>(),
        _ => return None,
    })
}

/// The shape at a path of names and indices; `length` is that of a list.
fn at<'a>(shape: &'a Shape, path: &str) -> Option<&'a Shape> {
    let (name, rest) = path.split_once('.').map_or((path, None), |(name, rest)| (name, Some(rest)));
    let inner = match shape {
        Shape::Maybe(inner) => return at(inner, path),
        Shape::Record(_, fields) => &fields.iter().find(|field| field.name == name)?.shape,
        Shape::List(_) | Shape::Exactly(..) if name == "length" => &Shape::Whole,
        Shape::Exactly(n, inner) if name.parse::<usize>().ok()? < *n => *inner,
        Shape::List(inner) if name.parse::<usize>().is_ok() => *inner,
        _ => return None,
    };
    let inner = if let Shape::Maybe(inner) = inner { inner } else { inner };
    rest.map_or(Some(inner), |rest| at(inner, rest))
}
