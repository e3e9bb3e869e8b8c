use super::*;
use crate::number::Number;

fn read(text: &str) -> (BTreeMap<String, Quiz>, String) {
    let number = |id: &str, value| Number { id: id.into(), value, about: "", source: "", check: None };
    let numbers = [number("a", 1.873), number("b", 3.05), number("c", 1.874)].into_iter().collect();
    let diagnostics = Diagnostics::default();
    let quizzes = quizzes(&DataFile::from_text("q.toml", text), &numbers, &diagnostics);
    (quizzes, diagnostics.check().err().map(|error| error.to_string()).unwrap_or_default())
}

const NUMBER: &str = "[[quiz]]\nid = 'n'\nprompt = 'p'\nkind = 'number'\nanswer = 'a'\ntolerance = 0.005\nwhy = 'w'\n";
const CHOICE: &str = "[[quiz]]\nid = 'c'\nprompt = 'p'\nkind = 'choice'\nwhy = 'w'\n\
    [[quiz.choice]]\ntext = 'x'\nright = true\nwhy = 'yes'\n[[quiz.choice]]\ntext = 'y'\nwhy = 'no'\n";

#[test]
fn sound_questions_are_read() {
    let (quizzes, errors) = read(&format!("{NUMBER}[[quiz.near]]\nvalue = 'b'\nwhy = 'r'\n{CHOICE}"));
    assert_eq!(errors, "");
    assert!(matches!(&quizzes["n"].answer, Answer::Number { near, .. } if near.len() == 1));
    assert!(matches!(&quizzes["c"].answer, Answer::Choice(choices) if choices.len() == 2));
}

#[test]
fn broken_questions_are_named_with_their_line() {
    let cases = [
        (format!("{NUMBER}{NUMBER}"), "q.toml:9: two quizzes are called `n`"),
        (NUMBER.replace("'a'", "'z'"), "unknown number `z`"),
        (NUMBER.replace("tolerance = 0.005\n", ""), "tolerance is missing"),
        (format!("{NUMBER}[[quiz.near]]\nvalue = 'b'\n"), "q.toml:9: quiz `n`: `b` has no reason"),
        (format!("{NUMBER}[[quiz.near]]\nvalue = 'c'\nwhy = 'r'\n"), "a right answer"),
        (CHOICE.replace("right = true\n", ""), "0 of them right"),
        (CHOICE.replace("text = 'y'\n", "text = 'y'\nright = true\n"), "2 of them right"),
        (CHOICE.replace("why = 'no'\n", ""), "`y` has no reason"),
        (CHOICE.replace("'y'", "'x'"), "stands twice"),
        (CHOICE.replace("prompt", "promt"), "q.toml:3: unknown field `promt`"),
    ];
    for (text, expected) in cases {
        let (_, errors) = read(&text);
        assert!(errors.contains(expected), "{expected} in {errors}");
    }
}

#[test]
fn the_hash_follows_the_content() {
    let hash = |text: &str| read(text).0["n"].hash;
    assert_eq!(hash(NUMBER), hash(NUMBER));
    assert_ne!(hash(NUMBER), hash(&NUMBER.replace("'p'", "'q'")));
}
