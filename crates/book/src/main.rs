//! Builds the site; `book --help` lists the options.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use book::{Assets, Build, BuildError, Cache, Diagnostics, Outputs, Site};
use chapter_kalman::{checks::chapter_checks, givens::Givens, numbers::with_ensembles};
use clap::Parser;
use labs::FIGURES;

/// Builds the site.
#[derive(Parser)]
struct Options {
    /// The folder to write; what was in it goes.
    #[arg(long, default_value = "dist")]
    out: PathBuf,
    /// The folder of the scripts, styles and fonts.
    #[arg(long, default_value = "target/assets")]
    assets: PathBuf,
    /// The folder of the figures' still pictures.
    #[arg(long, default_value = "target/stills")]
    stills: PathBuf,
    /// The folder for what the next build need not compute again.
    #[arg(long, default_value = "target/cache")]
    cache: PathBuf,
    /// The repository.
    #[arg(long, default_value = ".")]
    root: PathBuf,
    /// Refuses a site whose scripts, styles or stills have not been built.
    #[arg(long)]
    strict: bool,
    /// Writes the list of figures for scripts (`figures.js`, `opened.json`) into this folder, prints the builds of the
    /// module that they ask for, and builds nothing.
    #[arg(long, value_name = "FOLDER")]
    list: Option<PathBuf>,
    /// Leaves the answers to questions and exercises out; the pages then check nothing.
    #[arg(long)]
    no_answers: bool,
    /// Links to a PDF of each chapter, which somebody puts beside it: `kalman/kalman.pdf`.
    #[arg(long)]
    pdf: bool,
    /// Writes the pages in spite of what is wrong with the content, and says what is.
    #[arg(long)]
    draft: bool,
}

fn build(options: &Options) -> Result<String, BuildError> {
    let start = Instant::now();
    if let Some(folder) = &options.list {
        book::write_list(&options.root, FIGURES, folder)?;
        return Ok(book::builds(FIGURES).join("\n"));
    }
    let diagnostics = Diagnostics::default();
    let failed = |e| BuildError::Missing(format!("the labs: {e}"));
    let cache = Cache::by_this_program(&options.cache);
    let numbers = cache.or("numbers", "", || with_ensembles(&Givens::default())).map_err(failed)?;
    let stills = book::load_stills(&options.stills, FIGURES, options.strict)?;
    let mut site = Site::load(
        &options.root,
        numbers.into_iter().collect(),
        FIGURES,
        Outputs::of(&options.root),
        stills,
        &diagnostics,
    )?;
    site.answers = !options.no_answers;
    site.cache = cache;
    site.checks = chapter_checks().map_err(failed)?;
    let assets = Assets::load(&options.assets, options.strict)?;
    let build = Build {
        root: &options.root,
        site: &site,
        assets: &assets,
        diagnostics: &diagnostics,
        pdf: options.pdf,
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
    match build(&Options::parse()) {
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
