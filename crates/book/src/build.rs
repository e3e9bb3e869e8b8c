//! The build of the site: each page through its template, and what lies beside the pages.

use std::path::Path;

use minijinja::{Value, context};
use serde::Serialize;

use crate::asset::Assets;
use crate::check;
use crate::config::{Chapter, Page};
use crate::diagnostic::{BuildError, Diagnostics};
use crate::dist::Dist;
use crate::figure::{self, Figure};
use crate::file;
use crate::hash::fnv1a;
use crate::notation::NOTATIONS;
use crate::page;
use crate::search::SearchEntry;
use crate::site::Site;
use crate::template::{Templates, safe, serde};

/// Everything a build needs.
pub struct Build<'a> {
    /// The repository.
    pub root: &'a Path,
    /// Content and data.
    pub site: &'a Site,
    /// Scripts, styles, fonts.
    pub assets: &'a Assets,
    /// Where complaints go.
    pub diagnostics: &'a Diagnostics,
    /// Whether a PDF of each chapter will be beside it.
    pub pdf: bool,
    /// Whether to go on in spite of complaints, printing them.
    pub draft: bool,
}

/// A page's formulas in the letters of another notation. The page names the version it was built with: it picks its
/// readings by number, and a tab left open over a deploy would pick them from another page's.
#[derive(Debug, Serialize)]
struct Readings<'a> {
    version: &'a str,
    readings: Vec<&'a str>,
}

impl Build<'_> {
    /// Builds the site.
    ///
    /// # Errors
    /// [`BuildError`]: the complaints about the content, or the first file or template that fails.
    pub fn run(&self) -> Result<Dist, BuildError> {
        let mut pages = Pages { build: self, templates: Templates::load(self.root)?, dist: Dist::default() };
        let config = &self.site.config;
        for chapter in &config.chapters {
            let figures = pages.chapter(chapter)?;
            pages.figures(&format!("chapter {}: {}", chapter.number, chapter.title), &figures)?;
            if self.pdf {
                pages.dist.elsewhere.insert(format!("{0}/{0}.pdf", chapter.slug));
                let parts = chapter.apart.iter().map(|part| format!("{}/{1}/{1}.pdf", chapter.slug, part.slug));
                pages.dist.elsewhere.extend(parts);
            }
        }
        for page in &config.pages {
            let path = format!("content/pages/{}.md", page.slug);
            let file = file::read(&self.root.join(&path))?;
            let address = format!("{}/", page.slug);
            let text = page::text(self.site, &[(path, file)], None, &address, self.diagnostics);
            let figures = pages.text("page", None, &address, page, text)?;
            pages.figures(&page.title, &figures)?;
        }
        match self.diagnostics.check() {
            Err(error) if self.draft => eprintln!("{error}"),
            result => result?,
        }
        pages.page("cover", "index.html", &config.title, &config.description, context! {})?;
        let checks = check::rows(&self.site.checks, &self.site.sources);
        let about = "The checks that pin every number of the chapter, run again in your own browser.";
        pages.page("check", "check/", "Check this book", about, context! { checks })?;
        pages.page("404", "404.html", "Not found", "There is no such page in this book.", context! {})?;
        for (path, text) in self.site.sources.pages(self.site.answers) {
            pages.source(path, &text)?;
        }
        let mut dist = pages.dist;
        dist.put("search.json", serde_json::to_vec(&dist.search)?);
        for (path, bytes) in self.assets.files()? {
            dist.put(&format!("assets/{path}"), bytes);
        }
        dist.service_worker(self.assets)?;
        Ok(dist)
    }
}

/// The pages in the making.
struct Pages<'a> {
    build: &'a Build<'a>,
    templates: Templates,
    dist: Dist,
}

impl Pages<'_> {
    /// A chapter with its parts on pages of their own; answers its figures.
    fn chapter(&mut self, chapter: &Chapter) -> Result<Vec<Figure>, BuildError> {
        let slug = &chapter.slug;
        let whole = Page { slug: slug.clone(), title: chapter.title.clone(), description: chapter.description.clone() };
        let sources = page::pages(self.build.root, chapter)?;
        let mut texts = page::texts(self.build.site, &sources, Some(chapter.number), self.build.diagnostics);
        // The time for the exercises is told at the chapter's head, wherever they stand.
        let exercises = texts.iter().map(|text| text.reading[1].clone()).find(|time| !time.is_empty());
        texts[0].reading[1] = exercises.unwrap_or_default();
        let pages = [("chapter", &whole)].into_iter().chain(chapter.apart.iter().map(|part| ("part", part)));
        let mut figures = Vec::new();
        for (((kind, page), (address, _)), text) in pages.zip(&sources).zip(texts) {
            figures.extend(self.text(kind, Some(chapter), address, page, text)?);
        }
        Ok(figures)
    }

    /// A page of text; answers its figures.
    fn text(
        &mut self,
        kind: &str,
        chapter: Option<&Chapter>,
        address: &str,
        page: &Page,
        text: page::Text,
    ) -> Result<Vec<Figure>, BuildError> {
        let Page { title, description, .. } = page;
        let version = format!("{:016x}", fnv1a(text.readings.concat().join("\0").as_bytes()));
        let extra = context! {
            letters => !text.readings.is_empty(),
            chapter => serde(chapter),
            body => safe(text.body),
            contents => serde(text.contents),
            readings => &version,
            reading => text.reading,
            slug => &page.slug,
            asks => !text.used.quizzes.is_empty(),
        };
        self.page(kind, address, title, description, extra)?;
        // A place of another page than a chapter is told with the page's title.
        let of = if kind == "chapter" { "" } else { title };
        self.dist.search.extend(text.search.into_iter().map(|found| SearchEntry { of: of.into(), ..found }));
        for (file, picture) in text.used.pictures {
            self.dist.put(&format!("assets/{file}"), picture.into_bytes());
        }
        if !text.numbers.is_empty() {
            let about = format!("What computes each number that {title} prints, and which check pins it.");
            let extra = context! { body => safe(text.numbers), of => title };
            self.page("numbers", &format!("{address}numbers/"), "Where the numbers come from", &about, extra)?;
        }
        for (n, (notation, _)) in NOTATIONS[1..].iter().enumerate() {
            let readings = text.readings.iter().map(|others| others[n].as_str()).collect();
            let readings = Readings { version: &version, readings };
            self.dist.put(&format!("{address}{notation}.json"), serde_json::to_vec(&readings)?);
        }
        Ok(text.figures)
    }

    /// A page for each widget of the text whose name is `from`: its first figure in its usual state, or else
    /// its first figure.
    fn figures(&mut self, from: &str, figures: &[Figure]) -> Result<(), BuildError> {
        let usual = figures.iter().filter(|figure| figure.start.is_none());
        for figure in usual.chain(figures) {
            let address = figure::address(&figure.widget);
            if self.dist.files.contains_key(&format!("{address}index.html")) {
                continue;
            }
            let about = format!("{}: a figure of {from}, alive.", figure.name);
            let formulas = figure.caption.contains("class=\"katex");
            let extra = context! { figure => serde(figure), from, formulas };
            self.page("figure", &address, &figure.name, &about, extra.clone())?;
            // An address of before opens the same page, which says where it is now.
            let was = self.build.site.figure(&figure.widget).and_then(|known| known.was);
            if let Some(was) = was {
                let extra = context! { canonical => format!("../{}/", figure.widget), ..extra };
                self.page("figure", &figure::address(was), &figure.name, &about, extra)?;
            }
        }
        Ok(())
    }

    /// A source with its lines numbered.
    fn source(&mut self, path: &str, text: &str) -> Result<(), BuildError> {
        let site = self.build.site;
        let lines = || Ok(site.highlighter.lines(text, "rust"));
        let code = site.cache.or::<_, BuildError>(path, text, lines)?.into_iter().enumerate().map(|(i, line)| {
            let n = i + 1;
            format!("<a class=\"line-number\" id=\"L{n}\" href=\"#L{n}\">{n}</a>{line}\n")
        });
        let extra = context! { code => safe(code.collect()), path };
        let about = format!("The source {path}, as compiled into this page.");
        self.page("source", &format!("source/{path}.html"), path, &about, extra)
    }

    /// One page through the template of its kind.
    fn page(
        &mut self,
        kind: &str,
        address: &str,
        title: &str,
        description: &str,
        extra: Value,
    ) -> Result<(), BuildError> {
        let root = page::root_of(address);
        let common = context! {
            kind,
            assets => serde(self.build.assets.hrefs(&root)),
            inline => serde(&self.build.assets.inline),
            root,
            notations => serde(NOTATIONS),
            answers => self.build.site.answers,
            pdf => self.build.pdf,
            paper => serde(&self.templates.paper),
            book => serde(&self.build.site.config),
            title,
            description,
        };
        let html = self.templates.render(&format!("{kind}.html"), context! { ..extra, ..common })?;
        let path = if address.ends_with('/') { format!("{address}index.html") } else { address.to_string() };
        self.dist.put(&path, html.into_bytes());
        Ok(())
    }
}
