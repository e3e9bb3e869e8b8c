//! A quiz as a form: without scripts the answer opens on demand, with them it waits for the reader's own. The page's
//! script makes the controls when the question comes near the screen: a browser lays out every part of the page that holds
//! a form control as soon as the page is read, however far below the screen it is.

use crate::diagnostic::Place;
use crate::html::escape;
use crate::quiz::{Answer, Choice, Quiz};
use crate::render::Renderer;

impl Renderer<'_> {
    /// The quiz called `id`, asked at `place`.
    pub(crate) fn quiz(&mut self, id: &str, place: &Place) -> String {
        let quiz = self.site.quizzes.get(id).ok_or_else(|| format!("unknown quiz `{id}`"));
        let Some(quiz) = self.diagnostics.ok(place, quiz) else { return String::new() };
        if !self.used.quizzes.insert(id.to_string()) {
            self.diagnostics.report(place, format!("the quiz `{id}` is asked twice"));
        }
        let unlocks = quiz.unlocks.as_ref().map(|figure| {
            self.diagnostics.ok(&figure.place, self.labels.get(&figure.markdown, self.root));
            format!(" data-unlocks=\"{}\"", escape(&figure.markdown))
        });
        let title = quiz
            .title
            .as_ref()
            .map(|title| format!(" <span class=\"title\">{}</span>", self.title(&title.markdown, &title.place)));
        let prompt = self.blocks(&quiz.prompt.markdown, &quiz.prompt.place);
        let (kind, entry, reasons) = match &quiz.answer {
            Answer::Choice(choices) => self.choices(choices),
            Answer::Number { .. } => self.value(quiz),
        };
        let why = self.blocks(&quiz.why.markdown, &quiz.why.place);
        format!(
            "<form class=\"quiz\" id=\"quiz-{0}\" data-quiz=\"{0}\" data-kind=\"{kind}\" data-hash=\"{1:016x}\"{2}>\
             <fieldset><legend><span class=\"label\">Predict first</span>{3}</legend><div class=\"quiz-prompt\">{prompt}</div>{entry}</fieldset>\
             <p class=\"quiz-actions\" data-needs-js hidden></p><div class=\"quiz-verdict\" role=\"status\"></div>\
             <details class=\"quiz-answer\"><summary>Answer</summary><div class=\"details-body\">{reasons}\
             <div class=\"quiz-why\">{why}</div></div></details></form>\n",
            escape(id),
            quiz.hash,
            unlocks.unwrap_or_default(),
            title.unwrap_or_default(),
        )
    }

    fn choices(&mut self, choices: &[Choice]) -> (&'static str, String, String) {
        let (mut entry, mut reasons) = (String::new(), String::new());
        for (i, choice) in choices.iter().enumerate() {
            let text = self.title(&choice.text.markdown, &choice.text.place);
            let why = self.blocks(&choice.why.markdown, &choice.why.place);
            entry += &format!("<label class=\"quiz-choice\"><span>{text}</span></label>");
            let right = if choice.right { " data-right" } else { "" };
            reasons += &format!(
                "<li data-choice=\"{i}\"{right}><span class=\"quiz-reason-choice\">{text}</span> <div class=\"quiz-reason\">{why}</div></li>"
            );
        }
        (
            "choice",
            format!("<div class=\"quiz-choices\">{entry}</div>"),
            format!("<ul class=\"quiz-reasons\">{reasons}</ul>"),
        )
    }

    fn value(&mut self, quiz: &Quiz) -> (&'static str, String, String) {
        let Answer::Number { id, value, tolerance, format, unit, near } = &quiz.answer else {
            return ("number", String::new(), String::new());
        };
        let unit =
            if unit.is_empty() { String::new() } else { format!(" <span class=\"quiz-unit\">{}</span>", escape(unit)) };
        let entry = format!("<p class=\"quiz-number\"><label>Your answer </label>{unit}</p>");
        self.used.numbers.insert(id.clone());
        let print = |value: f64| format.html(value).unwrap_or_default();
        let link =
            format!("<a class=\"number\" href=\"#number-{0}\" data-number=\"{0}\">{1}</a>", escape(id), print(*value));
        let mut reasons = String::new();
        for near in near {
            let why = self.blocks(&near.why.markdown, &near.why.place);
            reasons += &format!(
                "<li data-value=\"{}\" data-tolerance=\"{tolerance}\"><span class=\"quiz-reason-choice\">{}</span> <div class=\"quiz-reason\">{why}</div></li>",
                near.value,
                print(near.value)
            );
        }
        let reasons = if reasons.is_empty() { reasons } else { format!("<ul class=\"quiz-reasons\">{reasons}</ul>") };
        let answer = format!(
            "<p class=\"quiz-value\" data-value=\"{value}\" data-tolerance=\"{tolerance}\">{link}{unit}</p>{reasons}"
        );
        ("number", entry, answer)
    }
}
