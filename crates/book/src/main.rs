//! Builds the site: `book [--out dist] [--assets target/assets] [--stills target/stills] [--root .] [--strict]
//! [--draft]`.
//!
//! `--strict` refuses a site whose scripts, styles or stills have not been built; `--draft` writes the pages in spite of
//! what is wrong with the content, and says what is.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use book::{Assets, Build, BuildError, Check, Diagnostics, Number, Outputs, Site};
use labs::givens::Givens;

const USAGE: &str =
    "usage: book [--out dist] [--assets target/assets] [--stills target/stills] [--root .] [--strict] [--draft]";

/// What the command line asks for.
struct Options {
    out: PathBuf,
    assets: PathBuf,
    stills: PathBuf,
    root: PathBuf,
    strict: bool,
    draft: bool,
}

impl Options {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self {
            out: "dist".into(),
            assets: "target/assets".into(),
            stills: "target/stills".into(),
            root: ".".into(),
            strict: false,
            draft: false,
        };
        while let Some(argument) = arguments.next() {
            let mut path = || {
                let path = arguments.next().ok_or_else(|| format!("{argument} needs a path\n{USAGE}"));
                path.map(PathBuf::from)
            };
            match argument.as_str() {
                "--out" => options.out = path()?,
                "--assets" => options.assets = path()?,
                "--stills" => options.stills = path()?,
                "--root" => options.root = path()?,
                "--draft" => options.draft = true,
                "--strict" => options.strict = true,
                other => return Err(format!("unknown argument `{other}`\n{USAGE}")),
            }
        }
        Ok(options)
    }
}

fn build(options: &Options) -> Result<String, BuildError> {
    let start = Instant::now();
    let diagnostics = Diagnostics::default();
    let failed = |e| BuildError::Missing(format!("the labs: {e}"));
    let numbers =
        labs::numbers::with_ensembles(&Givens::default()).map_err(failed)?.into_iter().map(Number::from).collect();
    let checks: Vec<Check> = labs::checks::chapter_checks().map_err(failed)?.into_iter().map(Check::from).collect();
    let stills = book::load_stills(&options.stills, options.strict)?;
    let site = Site::load(&options.root, numbers, Outputs::of(&options.root), stills, &diagnostics)?;
    let assets = Assets::load(&options.assets, options.strict)?;
    let build = Build {
        root: &options.root,
        site: &site,
        assets: &assets,
        checks: &checks,
        diagnostics: &diagnostics,
        draft: options.draft,
    };
    let dist = build.run()?;
    let faults = dist.faults();
    if !faults.is_empty() {
        let list = format!("{}\n{} faults in the built pages", faults.join("\n"), faults.len());
        if !options.draft {
            return Err(BuildError::Missing(list));
        }
        eprintln!("{list}");
    }
    dist.write(&options.out)?;
    let bytes: usize = dist.files.values().map(Vec::len).sum();
    let (files, seconds) = (dist.files.len(), start.elapsed().as_secs_f64());
    let chapters = site.config.chapters.iter().map(|chapter| {
        let elements = dist.elements(&format!("{}/index.html", chapter.slug));
        format!("; {}: {elements} elements", chapter.slug)
    });
    let chapters: String = chapters.collect();
    Ok(format!("{}: {files} files, {} kB, in {seconds:.1} s{chapters}", options.out.display(), bytes / 1000))
}

fn main() -> ExitCode {
    let result =
        Options::parse(std::env::args().skip(1)).and_then(|options| build(&options).map_err(|e| e.to_string()));
    match result {
        Ok(done) => {
            println!("{done}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
