//! A page's first figure has its still in the page; the drawings of the others are in files of their own.

mod common;

#[test]
fn the_drawings_of_later_figures_are_in_a_file_that_its_name_tells_apart() {
    let figure =
        |id: &str| format!(":::figure{{#{id} widget=\"observer-bench\" title=\"Turn\"}}\nWatch {id}.\n:::\n\n");
    let (body, complaints) = common::render(&(figure("fig-one") + &figure("fig-two")));
    assert_eq!(complaints, "");
    assert_eq!(body.matches("<svg viewBox=\"0 0 4 3\">").count(), 1, "{body}");
    let (first, second) = body.split_once("id=\"fig-two\"").expect("the second figure is there");
    assert!(first.contains("<svg") && !first.contains("<img"), "{first}");
    let apart = book::Apart::new("observer-bench", String::new(), "<svg></svg>".into());
    assert!(second.contains(&format!("<img src=\"../assets/{}#phase\" alt=\"\">", apart.file)), "{second}");
    assert_eq!(second.matches("A still.").count(), 1, "the words stay in the page");
    let other = book::Apart::new("observer-bench", String::new(), "<svg><g></g></svg>".into());
    assert_ne!(apart.file, other.file);
}
