//! Scripts and styles reach the site under their hashed names, and the service worker knows every file.

mod common;

use std::path::PathBuf;

use book::{Assets, Build, Diagnostics};

/// A folder of its own for each test.
fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    for (name, text) in files {
        std::fs::write(folder.join(name), text).expect("a file");
    }
    folder
}

const MANIFEST: &str =
    r#"{ "site.css": "site-AAAAAAAA.css", "katex.css": "katex-AAAAAAAA.css", "page.js": "page-AAAAAAAA.js" }"#;

const INLINE: &str = r#"{ "not-found.js": { "text": "go(1 < 2)", "sha256": "a+/b=" },
    "not-found.css": { "text": "a > b {}", "sha256": "c+/d=" } }"#;

#[test]
fn the_worker_lists_every_file_and_its_version_follows_them() {
    let build = |script: &str| {
        let files = [
            ("manifest.json", MANIFEST),
            ("site-AAAAAAAA.css", "p {}"),
            ("katex-AAAAAAAA.css", "b {}"),
            ("page-AAAAAAAA.js", script),
            ("inline.json", INLINE),
            ("sw.js", "const VERSION = '__VERSION__'\nconst FILES = __PRECACHE__\n"),
        ];
        let assets = Assets::load(&folder("assets", &files), true).expect("assets");
        let diagnostics = Diagnostics::default();
        let mut site = common::site(&diagnostics);
        site.config.chapters.clear();
        site.checks.clear();
        let root = common::fixtures().join("../../../..");
        let build =
            Build { root: &root, site: &site, assets: &assets, diagnostics: &diagnostics, pdf: false, draft: false };
        build.run().unwrap_or_else(|error| panic!("{error}"))
    };
    let dist = build("1");
    let text = |path: &str| String::from_utf8(dist.files[path].clone()).expect("text");
    assert!(text("index.html").contains("src=\"assets/page-AAAAAAAA.js\""));
    assert!(text("check/index.html").contains("href=\"../assets/site-AAAAAAAA.css\""));
    assert!(
        ["manifest.json", "inline.json", "sw.js"]
            .iter()
            .all(|file| !dist.files.contains_key(&format!("assets/{file}")))
    );
    let lost = text("404.html");
    assert!(lost.contains("<script type=\"module\">go(1 < 2)</script>") && lost.contains("<style>a > b {}</style>"));
    assert!(lost.contains("script-src 'sha256-a+/b='; style-src 'sha256-c+/d=';"), "{lost}");
    let worker = text("sw.js");
    assert!(!worker.contains("__"), "{worker}");
    for path in dist.files.keys().filter(|path| !["sw.js", "precache.json"].contains(&path.as_str())) {
        let url = path.strip_suffix("index.html").unwrap_or(path);
        let url = if url.is_empty() { "./" } else { url };
        assert!(worker.contains(&format!("\"url\":\"{url}\"")), "{path}");
    }
    assert_eq!(dist.faults(), Vec::<String>::new());
    assert_ne!(worker, String::from_utf8(build("2").files["sw.js"].clone()).expect("text"));
}

#[test]
fn a_strict_build_refuses_missing_assets_and_stills() {
    let empty = folder("empty", &[]);
    assert!(Assets::load(&empty, false).is_ok());
    assert!(Assets::load(&empty, true).is_err());
    assert!(book::load_stills(&empty, labs::FIGURES, true).is_err_and(|error| error.to_string().contains("stills")));
    let poor = folder("poor", &[("manifest.json", r#"{ "page.js": "p.js" }"#), ("inline.json", "{}")]);
    assert!(Assets::load(&poor, true).is_err_and(|error| error.to_string().contains("site.css")));
}

#[test]
fn a_folder_that_holds_something_else_is_left_alone() {
    let other = folder("other", &[("diary.txt", "dear diary")]);
    assert!(book::Dist::default().write(&other).is_err());
    assert!(other.join("diary.txt").exists());
}
