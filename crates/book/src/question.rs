//! A question: without scripts the answer opens on demand, with them it waits for the reader's own. A book built
//! without answers asks, and neither checks nor tells. The page's script makes the controls when the question comes
//! near the screen: a browser lays out every part of the page that holds a form control as soon as the page is read,
//! however far below the screen it is.

use minijinja::{Value, context};

use crate::config::Text;
use crate::diagnostic::Place;
use crate::quiz::state::State;
use crate::quiz::values::Values;
use crate::quiz::{Answer, Choice};
use crate::template::safe;
use crate::writer::Writer;

impl Writer<'_> {
    /// The quiz called `id`, asked at `place`.
    pub(crate) fn quiz(&mut self, id: &str, place: &Place) -> String {
        let quiz = self.site.quizzes.get(id).ok_or_else(|| format!("unknown quiz `{id}`"));
        let Some(quiz) = self.diagnostics.ok(place, quiz) else { return String::new() };
        if !self.used.quizzes.insert(id.to_string()) {
            self.diagnostics.report(place, format!("the quiz `{id}` is asked twice"));
        }
        let answers = self.site.answers;
        // Nothing is locked behind a question that the page does not check.
        let unlocks = quiz.asked.unlocks.as_ref().filter(|_| answers);
        let unlocks = unlocks.and_then(|figure| self.figure_link(figure));
        let checks = self.inside.last().is_some_and(|parent| parent == "exercise");
        let title = quiz.asked.title.as_ref().map(|title| safe(self.title(&title.markdown, &title.place)));
        let prompt = self.part(&quiz.asked.prompt);
        let answer = match &quiz.answer {
            Answer::Choice(choices) => self.choices(choices),
            Answer::Values(values) => self.values(values),
            Answer::State(state) => self.state(state),
        };
        if !answers {
            return self.fill("question", context! { id, checks, title, prompt, ..answer }, place);
        }
        let why = self.part(&quiz.asked.why);
        let (hash, key) = (&quiz.hash, quiz.answer.key());
        self.fill("quiz", context! { id, hash, key, unlocks, checks, title, prompt, why, ..answer }, place)
    }

    /// A figure's id, and what a cross-reference calls it.
    fn figure_link(&mut self, figure: &Text) -> Option<Value> {
        let label = self.diagnostics.ok(&figure.place, self.labels.get(&figure.markdown, self.root))?;
        Some(context! { id => figure.markdown.clone(), label => label.text })
    }

    /// A part of the quiz, in paragraphs.
    fn part(&mut self, text: &Text) -> Value {
        safe(self.blocks(&text.markdown, &text.place))
    }

    fn choices(&mut self, choices: &[Choice]) -> Value {
        let choice = |choice: &Choice| {
            let text = self.title(&choice.text.markdown, &choice.text.place);
            let asked = safe(unmarked(&text));
            if !self.site.answers {
                return context! { asked };
            }
            context! { asked, text => safe(text), right => choice.right, why => self.part(&choice.why) }
        };
        context! { kind => "choice", choices => choices.iter().map(choice).collect::<Vec<_>>() }
    }

    fn values(&mut self, values: &Values) -> Value {
        let (entries, direction, unit) = (values.ids.len(), values.direction, &values.unit);
        if !self.site.answers {
            return context! { kind => "values", entries, direction, unit };
        }
        self.used.numbers.extend(values.ids.iter().cloned());
        let near = values.near.iter().map(|near| {
            let printed = safe(values.print(&near.value));
            context! { printed, why => self.part(&near.why) }
        });
        let near: Vec<_> = near.collect();
        let printed = safe(values.print(&values.right));
        context! { kind => "values", number => values.ids[0].clone(), printed, entries, direction, unit, near }
    }

    fn state(&mut self, state: &State) -> Value {
        let told = if self.site.answers { state.todo.as_slice() } else { &[] };
        let todo: Vec<_> = told.iter().map(|todo| self.part(todo)).collect();
        context! { kind => "state", figure => self.figure_link(&state.figure), todo }
    }
}

/// Choices look alike: a computed number among them is not marked as one.
fn unmarked(html: &str) -> String {
    let html = html.replace(" class=\"number\"", "");
    let mut parts = html.split(" data-number=\"");
    let first = parts.next().unwrap_or_default().to_string();
    parts.fold(first, |html, part| html + part.split_once('"').map_or(part, |(_, rest)| rest))
}
