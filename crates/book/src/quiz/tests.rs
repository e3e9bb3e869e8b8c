use super::*;
use crate::number::Number;

fn read(text: &str) -> (BTreeMap<String, Quiz>, String) {
    let number = |id: &str, value| Number { id: id.into(), value, about: "".into(), source: "".into(), check: None };
    let numbers = [number("a", 1.873), number("b", 3.05), number("c", 1.874)].into_iter().collect();
    let diagnostics = Diagnostics::default();
    let quizzes = quizzes(&[DataFile::from_text("q.toml", text)], &numbers, labs::FIGURES, &diagnostics);
    (quizzes, diagnostics.check().err().map(|error| error.to_string()).unwrap_or_default())
}

const NUMBER: &str = "[[quiz]]\nid = 'n'\nprompt = 'p'\nkind = 'number'\nanswer = 'a'\ntolerance = 0.005\nwhy = 'w'\n";
const CHOICE: &str = "[[quiz]]\nid = 'c'\nprompt = 'p'\nkind = 'choice'\nwhy = 'w'\n\
    [[quiz.choice]]\ntext = 'x'\nright = true\nwhy = 'yes'\n[[quiz.choice]]\ntext = 'y'\nwhy = 'no'\n";

const VECTOR: &str =
    "[[quiz]]\nid = 'v'\nprompt = 'p'\nkind = 'vector'\nanswer = 'a, b'\ntolerance = 0.005\nwhy = 'w'\n";
const STATE: &str = "[[quiz]]\nid = 's'\nprompt = 'p'\nkind = 'state'\nwhy = 'w'\nfigure = 'fig'\n\
    widget = 'observer-bench'\n\
    [[quiz.condition]]\npath = 'params.sensor'\nis = 'position'\ntodo = 't'\n\
    [[quiz.condition]]\npath = 'params.gain'\nleast = 'a'\nmost = 'a'\nwithin = 0.02\ntodo = 't'\n\
    [[quiz.condition]]\npath = 'series.e1.length'\nleast = '2'\ntodo = 't'\n";

#[test]
fn a_key_tells_the_page_what_is_right() {
    let key = |text: &str, id: &str| {
        let digits = read(text).0[id].answer.key().into_bytes();
        let byte = |pair: &[u8]| u8::from_str_radix(std::str::from_utf8(pair).unwrap(), 16).unwrap();
        let json: Vec<u8> = digits.chunks(2).map(byte).collect();
        serde_json::from_slice::<serde_json::Value>(&json).unwrap()
    };
    assert_eq!(key(CHOICE, "c"), json!({ "right": 0 }));
    assert_eq!(
        key(NUMBER, "n"),
        json!({ "values": [1.873], "tolerance": 0.005, "direction": false, "unit": "", "near": [] })
    );
    assert_eq!(key(&NUMBER.replace("'a'", "'a'\nleast = '1.5'\nmost = 'b'"), "n")["bounds"], json!([1.5, 3.05]));
    let near = format!("{VECTOR}direction = true\n[[quiz.near]]\nvalue = '0, b'\nwhy = 'r'\n");
    let expected =
        json!({ "values": [1.873, 3.05], "tolerance": 0.005, "direction": true, "unit": "", "near": [[0.0, 3.05]] });
    assert_eq!(key(&near, "v"), expected);
    let conditions = json!([
        { "path": "params.sensor", "is": "position" },
        { "path": "params.gain", "least": 1.873 - 0.02, "most": 1.873 + 0.02 },
        { "path": "series.e1.length", "least": 2.0, "most": f64::MAX },
    ]);
    assert_eq!(key(STATE, "s"), json!({ "conditions": conditions }));
}

#[test]
fn sound_questions_are_read() {
    let (quizzes, errors) = read(&format!("{NUMBER}[[quiz.near]]\nvalue = 'b'\nwhy = 'r'\n{CHOICE}"));
    assert_eq!(errors, "");
    assert!(matches!(&quizzes["n"].answer, Answer::Values(values) if values.near.len() == 1));
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
        (format!("{CHOICE}[[quiz.near]]\nvalue = 'b'\nwhy = 'r'\n"), "has no `near`"),
        (NUMBER.replace("0.005", "0.005\nformat = '.1f'"), "as it is printed, 1.9, misses"),
        (NUMBER.replace("'a'", "'a, b'"), "2 entries"),
        (NUMBER.replace("'a'", "'a'\nleast = '1.5'"), "go together"),
        (NUMBER.replace("'a'", "'a'\nleast = '1.874'\nmost = 'b'"), "as it is printed, 1.873, misses"),
        (VECTOR.replace("'a, b'", "'a, b'\nleast = '1'"), "has no `least`"),
        (VECTOR.replace("'a, b'", "'a, z'"), "unknown number `z`"),
        (format!("{VECTOR}[[quiz.near]]\nvalue = '1'\nwhy = 'r'\n"), "not as many entries"),
        (format!("{VECTOR}direction = true\n[[quiz.near]]\nvalue = '-3.746, -6.1'\nwhy = 'r'\n"), "a right answer"),
        (STATE.replace("params.sensor", "params.sensors"), "q.toml:9: the figure's frame has no `params.sensors`"),
        (STATE.replace("'position'", "'positions'"), "`params.sensor` is never `positions`"),
        (STATE.replace("series.e1.length", "series.e1"), "wants `is`, or `least`"),
        (STATE.replace("'a'", "'z'"), "unknown number `z`"),
        (STATE.replace("within = 0.02", "within = -1.0"), "no number is within the bounds"),
        (STATE.replace("observer-bench", "bench"), "no widget is called `bench`"),
        (CHOICE.replace("prompt", "promt"), "q.toml:3: unknown field `promt`"),
    ];
    for (text, expected) in cases {
        let (_, errors) = read(&text);
        assert!(errors.contains(expected), "{expected} in {errors}");
    }
}

#[test]
fn the_hash_follows_the_content() {
    let hash = |text: &str| read(text).0["n"].hash.clone();
    assert_eq!(hash(NUMBER), hash(NUMBER));
    assert_ne!(hash(NUMBER), hash(&NUMBER.replace("'p'", "'q'")));
}
