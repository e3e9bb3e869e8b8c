//! Answers that are states of a figure: conditions on its frame, which the build holds against the frame's shape.

use lab::{Figure, Shape};
use serde::Deserialize;
use serde_json::{Value, json};

use super::{Answer, Reader};
use crate::config::Text;

/// A figure, and what has to hold there.
#[derive(Clone, Debug)]
pub struct State {
    /// The figure's id.
    pub figure: Text,
    /// What a reader still has to do where a condition does not hold, in Markdown.
    pub todo: Vec<Text>,
    /// The conditions, each with the path of a value in the frame and the word or the bounds that it has to meet.
    pub(super) key: Value,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawCondition {
    path: Text,
    is: Option<String>,
    least: Option<String>,
    most: Option<String>,
    #[serde(default)]
    within: f64,
    todo: Text,
}

impl State {
    /// What a reader is asked and told.
    pub(super) fn parts(&self) -> Vec<String> {
        let todo = self.todo.iter().map(|todo| todo.markdown.clone());
        [self.figure.markdown.clone(), self.key.to_string()].into_iter().chain(todo).collect()
    }
}

impl Reader<'_> {
    pub(super) fn state(&self) -> Result<Answer, String> {
        self.only(&["figure", "widget", "condition"])?;
        let figure = self.asked.figure.clone().ok_or("the figure is missing: its id")?;
        let widget = self.asked.widget.as_ref().ok_or("the figure's widget is missing")?;
        let named = |figure: &&Figure| figure.name() == widget.as_str();
        let figure_frame = self.figures.iter().find(named).map(|figure| &figure.kind.frame);
        let frame = figure_frame.ok_or_else(|| format!("no widget is called `{widget}`"))?;
        let conditions = &self.asked.condition;
        if conditions.is_empty() {
            return Err("a state has one condition or more".into());
        }
        let key = |raw: &RawCondition| self.diagnostics.ok(&raw.path.place, self.condition(raw, frame));
        let key = json!({ "conditions": conditions.iter().filter_map(key).collect::<Vec<_>>() });
        let todo = conditions.iter().map(|condition| condition.todo.clone()).collect();
        Ok(Answer::State(State { figure, todo, key }))
    }

    fn condition(&self, raw: &RawCondition, frame: &Shape) -> Result<Value, String> {
        let path = &raw.path.markdown;
        let shape = at(frame, path).ok_or_else(|| format!("the figure's frame has no `{path}`"))?;
        let bound = |bound: &Option<String>, otherwise| bound.as_ref().map_or(Ok(otherwise), |id| self.value(id));
        match (&raw.is, shape) {
            (Some(word), Shape::Word(words)) if words.contains(&word.as_str()) => {}
            (Some(word), Shape::Flag) if ["true", "false"].contains(&word.as_str()) => {}
            (Some(word), _) => return Err(format!("`{path}` is never `{word}`")),
            (None, Shape::Number | Shape::Whole) if raw.least.is_some() || raw.most.is_some() => {
                let (least, most) =
                    (bound(&raw.least, f64::MIN)? - raw.within, bound(&raw.most, f64::MAX)? + raw.within);
                if least > most {
                    return Err(format!("no number is within the bounds of `{path}`"));
                }
                return Ok(json!({ "path": path, "least": least, "most": most }));
            }
            (None, _) => return Err(format!("`{path}` wants `is`, or `least` or `most` where it is a number")),
        }
        Ok(json!({ "path": path, "is": raw.is }))
    }
}

/// The shape at a path of names and indices; `length` is that of a list.
fn at<'a>(shape: &'a Shape, path: &str) -> Option<&'a Shape> {
    let (name, rest) = path.split_once('.').map_or((path, None), |(name, rest)| (name, Some(rest)));
    let inner = match shape {
        Shape::Maybe(inner) => return at(inner, path),
        Shape::Record(_, fields) | Shape::Sparse(_, fields) => &fields.iter().find(|field| field.name == name)?.shape,
        Shape::List(_) | Shape::Exactly(..) if name == "length" => &Shape::Whole,
        Shape::Exactly(n, inner) if name.parse::<usize>().ok()? < *n => *inner,
        Shape::List(inner) if name.parse::<usize>().is_ok() => *inner,
        _ => return None,
    };
    let inner = if let Shape::Each(_, inner) = inner { inner } else { inner };
    let inner = if let Shape::Maybe(inner) = inner { inner } else { inner };
    rest.map_or(Some(inner), |rest| at(inner, rest))
}
