//! A quiz as a form: without scripts the answer opens on demand, with them it waits for the reader's own. The page's
//! script makes the controls when the question comes near the screen: a browser lays out every part of the page that holds
//! a form control as soon as the page is read, however far below the screen it is.

use minijinja::{Value, context};

use crate::config::Text;
use crate::diagnostic::Place;
use crate::quiz::{Answer, Choice, Quiz};
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
        let unlocks = quiz.unlocks.as_ref().map(|figure| {
            self.diagnostics.ok(&figure.place, self.labels.get(&figure.markdown, self.root));
            &figure.markdown
        });
        let title = quiz.title.as_ref().map(|title| safe(self.title(&title.markdown, &title.place)));
        let prompt = self.part(&quiz.prompt);
        let answer = match &quiz.answer {
            Answer::Choice(choices) => self.choices(choices),
            Answer::Number { .. } => self.value(quiz),
        };
        let why = self.part(&quiz.why);
        let hash = format!("{:016x}", quiz.hash);
        self.fill("quiz", context! { id, hash, unlocks, title, prompt, why, ..answer }, place)
    }

    /// A part of the quiz, in paragraphs.
    fn part(&mut self, text: &Text) -> Value {
        safe(self.blocks(&text.markdown, &text.place))
    }

    fn choices(&mut self, choices: &[Choice]) -> Value {
        let choice = |choice: &Choice| {
            let text = safe(self.title(&choice.text.markdown, &choice.text.place));
            context! { text, right => choice.right, why => self.part(&choice.why) }
        };
        context! { kind => "choice", choices => choices.iter().map(choice).collect::<Vec<_>>() }
    }

    fn value(&mut self, quiz: &Quiz) -> Value {
        let Answer::Number { id, value, tolerance, format, unit, near } = &quiz.answer else { return context! {} };
        self.used.numbers.insert(id.clone());
        let print = |value: f64| safe(format.html(value).unwrap_or_default());
        let near = near.iter().map(|near| {
            let (value, printed) = (near.value.to_string(), print(near.value));
            context! { value, printed, why => self.part(&near.why) }
        });
        let near: Vec<_> = near.collect();
        context! {
            kind => "number",
            number => id,
            value => value.to_string(),
            printed => print(*value),
            tolerance => tolerance.to_string(),
            unit,
            near,
        }
    }
}
