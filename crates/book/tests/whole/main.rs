//! The book itself, built whole. The tests share its numbers, whose ensembles take some seconds, and one build with
//! them.

mod answers;
mod site;

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use book::{Assets, Build, Diagnostics, Dist, Number, Outputs, Site, Stills};
use chapter_kalman::{checks::chapter_checks, givens::Givens, numbers::with_ensembles};

/// Every number that the book prints.
static NUMBERS: LazyLock<Vec<Number>> = LazyLock::new(|| with_ensembles(&Givens::default()).expect("computed"));

/// The site.
static DIST: LazyLock<Dist> = LazyLock::new(|| {
    let diagnostics = Diagnostics::default();
    build(&load(NUMBERS.clone(), &diagnostics), &diagnostics)
});

/// The repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The book's data with `numbers`.
fn load(numbers: Vec<Number>, diagnostics: &Diagnostics) -> Site {
    let numbers = numbers.into_iter().collect();
    let mut site = Site::load(&root(), numbers, labs::FIGURES, Outputs::of(root()), Stills::new(), diagnostics)
        .expect("the content is there");
    site.checks = chapter_checks().expect("computed");
    site
}

/// Its pages.
fn build(site: &Site, diagnostics: &Diagnostics) -> Dist {
    let (root, assets) = (root(), Assets::default());
    let build = Build { root: &root, site, assets: &assets, diagnostics, pdf: false, draft: false };
    build.run().unwrap_or_else(|error| panic!("{error}"))
}
