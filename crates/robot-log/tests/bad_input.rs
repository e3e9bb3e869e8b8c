//! Every way in which a log can be broken is refused, with the line and column of the fault and a word on what was
//! expected.

use robot_log::{Error, parse};

/// The refusal of `text`.
fn refused(text: &str) -> Error {
    parse(text).expect_err(text)
}

/// Asserts that `text` is refused at `[line, column]` with `words` in the message.
fn assert_refused(text: &str, at: [u32; 2], words: &str) {
    let error = refused(text);
    assert_eq!([error.line, error.column], at, "{text:?}: {error}");
    assert!(error.message.contains(words), "{text:?}: {error}");
}

const SOUND: &str = "L,7,3.0,4.0\nO,0.5,0.1,0.02\nR,0.5,7,4.9\n";

#[test]
fn a_row_letter_that_is_not_known_is_refused() {
    assert_refused("X,1,2,3\n", [1, 1], "'X' is no row's letter");
    assert_refused("L,7,3,4\n  o,0.5,0.1,0.02\n", [2, 3], "'o' is no row's letter");
    assert_refused(",1,2,3\n", [1, 1], "empty field");
}

#[test]
fn too_few_and_too_many_fields_are_refused() {
    assert_refused("O,0.5,0.1\n", [1, 10], "has 3 fields; 4 were expected: O,t,distance,turn");
    assert_refused("L,7,3.0,4.0, 5.0\n", [1, 14], "has 5 fields; 4 were expected: L,id,x,y");
    assert_refused("O", [1, 2], "has 1 fields");
    assert_refused("O,1,2,3,4,5,6,7,8,9\n", [1, 17], "more than 8 fields");
}

#[test]
fn a_field_that_is_no_finite_number_is_refused() {
    for (field, words) in [
        ("x", "distance is 'x'"),
        ("nan", "distance is 'nan'"),
        ("inf", "distance is 'inf'"),
        ("1e999", "distance is '1e999'"),
        ("", "distance is missing"),
        ("1_000", "finite number"),
        ("0x10", "finite number"),
        ("1.2.3", "finite number"),
        ("１", "finite number"),
        ("a very long field that is no number", "'a very long field th…'"),
    ] {
        assert_refused(&format!("{SOUND}O,0.7,{field},0.02\n"), [4, 7], words);
    }
}

#[test]
fn an_id_that_is_no_whole_number_is_refused() {
    for id in ["7.0", "-7", "+7", "4294967296", "seven", ""] {
        assert_refused(&format!("{SOUND}R,0.7,{id},4.9\n"), [4, 7], "whole number");
        assert_refused(&format!("L,{id},0,0\n"), [1, 3], "whole number");
    }
}

#[test]
fn a_landmark_named_twice_is_refused() {
    assert_refused(&format!("{SOUND}L, 7,1,1\n"), [4, 4], "landmark 7 stands here for the second time");
}

#[test]
fn a_sighting_of_a_landmark_that_is_not_there_is_refused() {
    assert_refused(&format!("{SOUND}R,0.7,8,4.9\n"), [4, 7], "there is no landmark 8");
    assert_refused("O,1,0,0\nB,0.7,8,4.9,0.1\nL,9,0,0\n", [2, 7], "there is no landmark 8");
}

#[test]
fn a_negative_range_is_refused() {
    assert_refused(&format!("{SOUND}R,0.7,7,-4.9\n"), [4, 9], "range is '-4.9'");
    assert_refused(&format!("{SOUND}B,0.7,7,-1e-9,0\n"), [4, 9], "at least 0");
}

#[test]
fn odometry_and_velocities_in_one_log_are_refused() {
    assert_refused("O,0.5,0.1,0.02\nV,0.6,1,0\n", [2, 1], "O rows and V rows");
    assert_refused("V,0.5,0.1,0.02\nO,0.6,1,0\n", [2, 1], "O rows and V rows");
    assert_refused("D,0.5,0.1,0.02\nO,0.6,1,0\n", [2, 1], "O rows and D rows");
    assert_refused("D,0.5,0.1,0.02\nV,0.6,1,0\n", [2, 1], "D rows and V rows");
}

#[test]
fn odometry_and_speeds_or_turn_rates_in_one_log_are_refused() {
    assert_refused("O,0.5,0.1,0.02\nS,0.6,1\n", [2, 1], "O rows and S rows");
    assert_refused("T,0.5,0.1\nS,0.5,1\nO,0.6,1,0\n", [3, 1], "O rows and T rows");
    assert!(parse("V,0.5,0.1,0.02\nS,0.6,1\nT,0.6,1\n").is_ok(), "a velocity is a speed and a turn rate");
}

#[test]
fn rows_of_the_pose_and_of_held_motion_have_their_fields() {
    for (row, at, words) in [
        ("S,1", [2, 4], "2 fields; 3 were expected: S,t,v"),
        ("S,1,2,3", [2, 7], "4 fields; 3 were expected: S,t,v"),
        ("S,1,fast", [2, 5], "v is 'fast'"),
        ("T,1,inf", [2, 5], "omega is 'inf'"),
        ("T,1e12,0", [2, 3], "times within"),
        ("P,1,2", [2, 6], "3 fields; 4 or 5 were expected: P,t,x,y[,sigma]"),
        ("P,1,2,3,4,5", [2, 11], "6 fields; 4 or 5 were expected"),
        ("P,1,2,y", [2, 7], "y is 'y'"),
        ("P,1,2,3,", [2, 9], "sigma is missing"),
        ("P,1,2,3,0", [2, 9], "sigma is '0'; a standard deviation above 0"),
        ("P,1,2,3,-1", [2, 9], "above 0"),
        ("P,1,2,3,nan", [2, 9], "finite number"),
        ("H,1", [2, 4], "2 fields; 3 or 4 were expected: H,t,theta[,sigma]"),
        ("H,1,0,0.1,7", [2, 11], "5 fields; 3 or 4"),
        ("H,1,north", [2, 5], "theta is 'north'"),
        ("H,1,0,-0", [2, 7], "above 0"),
    ] {
        assert_refused(&format!("O,0,1,0\n{row}\n"), at, words);
    }
}

#[test]
fn fixes_and_headings_alone_are_no_motion() {
    assert_refused("P,0,1,2\nH,1,0\n", [2, 1], "no motion");
}

#[test]
fn a_log_without_motion_is_refused_at_its_last_row() {
    assert_refused("L,7,3.0,4.0\nR,0.5,7,4.9\n# the end\n", [2, 1], "no motion");
    assert_refused("", [1, 1], "no motion");
    assert_refused("# nothing\n\n", [1, 1], "no motion");
}

#[test]
fn what_is_no_text_is_refused() {
    assert_refused("O\0,\x000\0.\x005\0", [1, 1], "control character");
    assert_refused("\u{fffd}PNG\r\n\u{1a}\n", [1, 1], "control character");
    // A file of an old Macintosh, whose lines end in CR.
    assert_refused("L,7,3,4\rO,1,0,0\r", [1, 7], "control character");
}

#[test]
fn quotes_and_other_separators_are_refused_with_a_word_on_them() {
    assert_refused("\"L\",7,3,4\n", [1, 1], "quoted");
    assert_refused("L,\"7\",3,4\n", [1, 3], "quoted");
    assert_refused("L,7,\"3\",4\n", [1, 5], "quoted");
    for (text, words) in [
        ("L;7;3;4\n", "';' was found"),
        ("L 7 3 4\n", "blanks were found"),
        ("L\t7\t3\t4\n", "tabs were found"),
        ("L|7|3|4\n", "'|' was found"),
        (&"R\t1.014892e+00\t5.543292e-01".repeat(4), "tabs were found"),
    ] {
        assert_refused(text, [1, 1], words);
    }
}

#[test]
fn times_and_sizes_are_bounded() {
    assert_refused("O,1.1e11,0,0\n", [1, 3], "times within");
    assert!(parse("O,-1e11,0,0\nO,1e11,0,0\n").is_ok());
    assert_refused(&format!("O,0,{}1,0\n", " ".repeat(70)), [1, 5], "longer than 64 bytes");
    let landmarks: String = (0..501).map(|id| format!("L,{id},0,0\n")).collect();
    assert_refused(&landmarks, [501, 1], "more than 500 landmarks");
    let rows = "O,0,0,0\n".repeat(robot_log::MAX_ROWS);
    assert_eq!(parse(&rows).expect("just as many").count, robot_log::MAX_ROWS);
    assert_refused(&format!("{rows}O,0,0,0\n"), [2_000_001, 1], "more than 2000000 rows");
    assert_refused(&"#".repeat(robot_log::MAX_BYTES + 1), [1, 1], "64000001 bytes");
}
