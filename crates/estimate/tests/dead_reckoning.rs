//! What `cargo run --example dead_reckoning -p robot-motion-estimate` prints: the five lines that the chapter prints,
//! to the letter. The program itself is run and not a copy of what it does, since the chapter shows its source as it
//! stands.

use std::process::Command;

const LINES: &str = "\
step 1: ν = -1.300  S = 2.6000  R = [0.4038, 0.8077]
        x̂⁺ = [3.475, 2.950]   P⁺ = [[1.2760, 0.2019], [0.2019, 0.4038]]
step 2: ν = -0.950  S = 1.0038  R = [0.4521, 0.5019]
        x̂⁺ = [4.520, 2.473]   P⁺ = [[1.5737, 0.2261], [0.2261, 0.2510]]
rank Q = 1 (velocity sensor), 2 (position sensor)
";

#[test]
fn the_example_prints_the_five_lines_of_the_chapter() {
    // cargo puts examples beside the folder of the tests and builds both, unless told to build this test alone.
    let here = std::env::current_exe().expect("a test has a path");
    let folder = here.ancestors().nth(2).expect("in a folder of the target's").join("examples");
    let program = folder.join(format!("dead_reckoning{}", std::env::consts::EXE_SUFFIX));
    let run = Command::new(&program).output();
    let run =
        run.unwrap_or_else(|e| panic!("{}: {e}; `cargo test -p robot-motion-estimate` builds it", program.display()));
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    assert_eq!(String::from_utf8(run.stdout).expect("text"), LINES);
}
