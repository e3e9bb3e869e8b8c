//! A second chapter stands beside the first: a page with one number and one figure that no crate of ours knows.

use std::path::{Path, PathBuf};

use book::{Assets, Build, BuildError, Diagnostics, Dist, Number, Outputs, Site, Stills};
use estimate::Error;
use lab::{Check, Digest, Figure, Kind, Lab, Listing, Params, kept, named, params, record};

params! {
    /// What a reader of the second chapter can change.
    pub struct SpringParams {
        /// How stiff the spring is.
        pub stiffness: f64 = 2.0, from 0.0 to 10.0 by 0.5 in "N/m";
    }
}

record! {
    /// A spring, pulled further at each step.
    #[derive(Copy)]
    pub struct SpringFrame {
        /// Newtons.
        pub force: f64,
    }
}

#[derive(Clone)]
struct Spring {
    params: SpringParams,
    step: u32,
    digest: Digest,
}

impl Lab for Spring {
    named! { "spring", SpringParams, SpringFrame, &[INTERFACES], "A spring, pulled further at each step." }
    kept! {}

    fn start((): (), params: SpringParams) -> Result<Self, Error> {
        params.check()?;
        Ok(Self { params, step: 0, digest: Digest::default() })
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        self.digest.take(&[self.frame().force]);
        Ok(())
    }

    fn frame(&self) -> SpringFrame {
        SpringFrame { force: self.params.stiffness * f64::from(self.step) }
    }
}

/// The list of figures of a book with both chapters.
static FIGURES: [Figure; 2] = [
    Figure {
        class: "Spring",
        build: "springs",
        world: false,
        was: Some("coil"),
        kind: const { &Kind::of::<Spring>() },
    },
    Figure {
        class: "ObserverBench",
        build: "linear",
        world: false,
        was: None,
        kind: const { &Kind::of::<labs::ObserverBench>() },
    },
];

/// What the second chapter prints, and checks.
fn numbers() -> Result<Vec<Number>, Error> {
    let mut spring = Spring::new(SpringParams::default())?;
    spring.run(3)?;
    let mut listing = Listing::new();
    listing.by("second::force", Some(1)).add("spring.force", spring.frame().force, "the force of the third step");
    Ok(listing.numbers)
}

/// Builds a book of two chapters in a folder of its own, `words` among those of the second.
fn build(folder: &str, words: &str) -> (PathBuf, Result<Dist, BuildError>) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target").join(folder);
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let write = |name: &str, text: &str| {
        let path = root.join(name);
        std::fs::create_dir_all(path.parent().expect("below the root")).expect("a folder");
        std::fs::write(path, text).expect("a file");
    };
    let chapter = |slug: &str, number| {
        format!("[[chapter]]\nslug = \"{slug}\"\nnumber = {number}\ntitle = \"{slug}\"\ndescription = \"A chapter.\"\n")
    };
    write(
        "content/book.toml",
        &format!(
            "title = \"Two\"\nsubtitle = \"s\"\nlanguage = \"en\"\ndescription = \"d\"\nmacros = \"macros.toml\"\n{}{}",
            chapter("one", 1),
            chapter("two", 2)
        ),
    );
    write("content/quizzes/none.toml", "");
    write("content/macros.toml", "");
    write("content/one/01-a.md", "## One {#one}\n\nThe first.\n");
    let text = format!(
        "## Two {{#two}}\n\nIt pulls with {{{{number spring.force .1f}}}}. {words}\n\n\
         :::figure{{#fig-spring start='{{\"step\": 2}}' widget=\"spring\" title=\"Pull\"}}\nPull it.\n:::\n"
    );
    write("content/two/01-a.md", &text);
    for file in book_templates(&repository) {
        let text = std::fs::read_to_string(repository.join(&file)).expect("a template");
        write(&file, &text);
    }

    let diagnostics = Diagnostics::default();
    let numbers = numbers().expect("computed").into_iter().collect();
    let mut site =
        Site::load(&root, numbers, &FIGURES, Outputs::of(&root), Stills::new(), &diagnostics).expect("its data");
    site.sources.insert("crates/second/src/lib.rs", "/// A force.\npub fn force() {}\n");
    site.checks = vec![Check::new(1, "The force of the third step", vec![6.0], vec![6.0], 0.0)];
    let assets = Assets::default();
    let build =
        Build { root: &root, site: &site, assets: &assets, diagnostics: &diagnostics, pdf: false, draft: false };
    let dist = build.run();
    (root, dist)
}

#[test]
fn a_second_chapter_has_a_number_and_a_figure_of_its_own() {
    let (root, dist) = build("second-chapter", "{{ref check-1}} holds it.");
    let dist = dist.unwrap_or_else(|error| panic!("{error}"));
    let page = |path: &str| String::from_utf8(dist.files[path].clone()).expect("text");
    let two = page("two/index.html");
    assert!(two.contains("6.0") && two.contains("<lab-spring class=\"widget\" data-widget=\"spring\""), "{two}");
    assert!(two.contains("href=\"../check/#check-1\""), "{two}");
    assert!(!page("one/index.html").contains("spring"));
    let figure = page("figure/spring/index.html");
    assert!(figure.contains("<lab-spring ") && !figure.contains("canonical"));
    assert!(page("figure/coil/index.html").contains("rel=\"canonical\" href=\"../spring/\""));

    // What scripts are told of it, whatever the order of its attributes.
    let folder = root.join("list");
    book::write_list(&root, &FIGURES, &folder).expect("written");
    let told = |name: &str| std::fs::read_to_string(folder.join(name)).expect("written");
    assert!(told("figures.js").contains("\"tag\": \"lab-spring\""));
    let opened: serde_json::Value = serde_json::from_str(&told("opened.json")).expect("JSON");
    assert_eq!(opened, serde_json::json!([{ "id": "fig-spring", "name": "spring", "start": { "step": 2 } }]));
    assert_eq!(book::builds(&FIGURES), ["springs", "linear"]);
}

#[test]
fn a_chapter_of_one_check_has_no_second() {
    let (_, dist) = build("second-chapter-without", "{{ref check-2}} holds it.");
    let error = dist.expect_err("a link to nothing").to_string();
    assert!(error.contains("check-2"), "{error}");
}

/// The templates of pages, which a second chapter shares with the first.
fn book_templates(repository: &Path) -> Vec<String> {
    let folder = std::fs::read_dir(repository.join("web/templates")).expect("the templates");
    folder.flatten().filter_map(|file| Some(format!("web/templates/{}", file.file_name().to_str()?))).collect()
}
