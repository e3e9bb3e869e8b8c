//! The book itself, for tests that build it whole.

use std::path::{Path, PathBuf};

use book::{Assets, Build, Diagnostics, Dist, Outputs, Site, Stills};

/// The repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The book's data with `numbers`.
pub fn load(numbers: Vec<labs::numbers::Number>, diagnostics: &Diagnostics) -> Site {
    Site::load(&root(), numbers.into_iter().collect(), Outputs::of(root()), Stills::new(), diagnostics)
        .expect("the content is there")
}

/// Its pages.
pub fn build(site: &Site, diagnostics: &Diagnostics) -> Dist {
    let (root, assets, checks) = (root(), Assets::default(), labs::checks::chapter_checks().expect("computed"));
    let build = Build { root: &root, site, assets: &assets, checks: &checks, diagnostics, pdf: false, draft: false };
    build.run().unwrap_or_else(|error| panic!("{error}"))
}
