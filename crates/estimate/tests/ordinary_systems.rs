//! A hundredth of `cargo run --release -p robot-motion-estimate --example grid`.

mod grid;

#[test]
fn ordinary_systems_have_answers_that_satisfy_their_equations() {
    let count = grid::examine(1_000_000, 101);
    assert_eq!(count.wrong, 0, "{count:#?}");
    assert!(count.systems > 9_000 && count.placed > 3_000 && count.converged > 1_000, "{count:#?}");
}
