//! The site, written: pages, sources, search, assets, and the list the service worker caches.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use minijinja::value::Serde;
use minijinja::{Value, context};
use serde::Serialize;

use crate::asset::Assets;
use crate::check::{self, Check};
use crate::config::Chapter;
use crate::diagnostic::{BuildError, Diagnostics};
use crate::figure::Figure;
use crate::html;
use crate::page::{self, Found, Text};
use crate::quiz::fnv1a;
use crate::site::Site;
use crate::template::Templates;

/// Everything a build needs.
pub struct Build<'a> {
    /// The repository.
    pub root: &'a Path,
    /// Content and data.
    pub site: &'a Site,
    /// Scripts, styles, fonts.
    pub assets: &'a Assets,
    /// The checks as computed natively.
    pub checks: &'a [Check],
    /// Where complaints go.
    pub diagnostics: &'a Diagnostics,
    /// Whether to go on in spite of complaints, printing them.
    pub draft: bool,
}

/// The built site, in memory: path to bytes.
#[derive(Debug, Default)]
pub struct Dist {
    /// Every file by its path.
    pub files: BTreeMap<String, Vec<u8>>,
    search: Vec<Found>,
}

/// An entry of the list the service worker caches.
#[derive(Debug, Serialize)]
struct Cached {
    url: String,
    hash: String,
    bytes: usize,
    group: &'static str,
}

/// A page's formulas in Thrun's letters. The page names the version it was built with: it picks its readings by number,
/// and a tab left open over a deploy would pick them from another page's.
#[derive(Debug, Serialize)]
struct Readings {
    version: String,
    readings: Vec<String>,
}

impl Readings {
    fn new(readings: Vec<String>) -> Self {
        Self { version: format!("{:016x}", fnv1a(readings.join("\0").as_bytes())), readings }
    }
}

impl Build<'_> {
    /// Builds the site.
    ///
    /// # Errors
    /// [`BuildError`]: the complaints about the content, or the first file or template that fails.
    pub fn run(&self) -> Result<Dist, BuildError> {
        let templates = Templates::load(self.root)?;
        let mut dist = Dist::default();
        self.chapters(&templates, &mut dist)?;
        self.pages(&templates, &mut dist)?;
        match self.diagnostics.check() {
            Err(error) if self.draft => eprintln!("{error}"),
            result => result?,
        }
        let config = &self.site.config;
        self.page(&templates, &mut dist, "cover", "index.html", &config.title, &config.description, context! {})?;
        let rows = check::rows(self.checks, &self.site.sources);
        let about = "The checks that pin every number of the chapter, run again in your own browser.";
        self.page(
            &templates,
            &mut dist,
            "check",
            "check/",
            "Check this book",
            about,
            context! { checks => serde(&rows) },
        )?;
        self.page(
            &templates,
            &mut dist,
            "404",
            "404.html",
            "Not found",
            "There is no such page in this book.",
            context! {},
        )?;
        self.sources(&templates, &mut dist)?;
        dist.put("search.json", serde_json::to_vec(&dist.search).map_err(|e| BuildError::Missing(e.to_string()))?);
        for (path, bytes) in self.assets.files()? {
            dist.put(&format!("assets/{path}"), bytes);
        }
        dist.service_worker(self.assets)?;
        Ok(dist)
    }

    fn chapters(&self, templates: &Templates, dist: &mut Dist) -> Result<(), BuildError> {
        for chapter in &self.site.config.chapters {
            let address = format!("{}/", chapter.slug);
            let files = page::files(self.root, &format!("content/{}", chapter.slug))?;
            let text = page::text(self.site, &files, Some(chapter.number), &address, self.diagnostics);
            let readings = Readings::new(text.thrun);
            let extra = context! { chapter => serde(chapter), body => text.body, contents => serde(&text.contents), readings => &readings.version };
            self.page(templates, dist, "chapter", &address, &chapter.title, &chapter.description, extra)?;
            dist.text(&address, text.search, &readings)?;
            self.figures(templates, dist, chapter, &text.figures)?;
        }
        Ok(())
    }

    /// A page for each widget of a chapter: its first figure in its usual state, or else its first figure.
    fn figures(
        &self,
        templates: &Templates,
        dist: &mut Dist,
        chapter: &Chapter,
        figures: &[Figure],
    ) -> Result<(), BuildError> {
        let usual = figures.iter().filter(|figure| figure.start.is_none());
        for figure in usual.chain(figures) {
            let address = format!("figure/{}/", figure.widget);
            if dist.files.contains_key(&format!("{address}index.html")) {
                continue;
            }
            let title = html::words(&figure.title);
            let about = format!("{title}: a figure of the chapter {}, alive.", chapter.title);
            let extra = context! { figure => serde(figure), chapter => serde(chapter), formulas => figure.caption.contains("class=\"katex") };
            self.page(templates, dist, "figure", &address, &title, &about, extra)?;
        }
        Ok(())
    }

    fn pages(&self, templates: &Templates, dist: &mut Dist) -> Result<(), BuildError> {
        for page in &self.site.config.pages {
            let (address, path) = (format!("{}/", page.slug), format!("content/pages/{}.md", page.slug));
            let file = std::fs::read_to_string(self.root.join(&path)).map_err(|e| BuildError::File(path.clone(), e))?;
            let text: Text = page::text(self.site, &[(path, file)], None, &address, self.diagnostics);
            let readings = Readings::new(text.thrun);
            let extra =
                context! { body => text.body, contents => serde(&text.contents), readings => &readings.version };
            self.page(templates, dist, "page", &address, &page.title, &page.description, extra)?;
            dist.text(&address, text.search, &readings)?;
        }
        Ok(())
    }

    fn sources(&self, templates: &Templates, dist: &mut Dist) -> Result<(), BuildError> {
        for (path, text) in self.site.sources.iter() {
            let lines = self.site.highlighter.lines(text, "rust");
            let line = |(i, line): (usize, &String)| {
                let n = i + 1;
                format!("<a class=\"line-number\" id=\"L{n}\" href=\"#L{n}\">{n}</a>{line}\n")
            };
            let code: String = lines.iter().enumerate().map(line).collect();
            let address = format!("source/{path}.html");
            let about = format!("The source {path}, as compiled into this page.");
            self.page(templates, dist, "source", &address, path, &about, context! { code => code, path => path })?;
        }
        Ok(())
    }

    /// One page through its template.
    #[allow(clippy::too_many_arguments)]
    fn page(
        &self,
        templates: &Templates,
        dist: &mut Dist,
        kind: &str,
        address: &str,
        title: &str,
        description: &str,
        extra: Value,
    ) -> Result<(), BuildError> {
        let root = page::root_of(address);
        let common = context! {
            kind => kind,
            assets => serde(self.assets.hrefs(&root)),
            inline => serde(&self.assets.inline),
            root => root,
            paper => serde(&templates.paper),
            book => serde(&self.site.config),
            title => title,
            description => description,
        };
        let html = templates.render(&format!("{kind}.html"), context! { ..extra, ..common })?;
        let path = if address.ends_with('/') { format!("{address}index.html") } else { address.to_string() };
        dist.put(&path, html.into_bytes());
        Ok(())
    }
}

impl Dist {
    fn put(&mut self, path: &str, bytes: Vec<u8>) {
        self.files.insert(path.to_string(), bytes);
    }

    /// What a text brings beside its page: its part of the search, and its formulas in Thrun's letters.
    fn text(&mut self, address: &str, search: Vec<Found>, readings: &Readings) -> Result<(), BuildError> {
        self.search.extend(search);
        let json = serde_json::to_vec(readings).map_err(|e| BuildError::Missing(e.to_string()))?;
        self.put(&format!("{address}thrun.json"), json);
        Ok(())
    }

    /// The service worker and the list it caches.
    fn service_worker(&mut self, assets: &Assets) -> Result<(), BuildError> {
        let list: Vec<Cached> = self
            .files
            .iter()
            .map(|(path, bytes)| Cached {
                url: path
                    .strip_suffix("index.html")
                    .map_or(path.clone(), |folder| if folder.is_empty() { "./".into() } else { folder.into() }),
                hash: format!("{:016x}", fnv1a(bytes)),
                bytes: bytes.len(),
                group: match path {
                    path if path.starts_with("source/") => "source",
                    path if path.starts_with("assets/") => "asset",
                    path if path.ends_with(".html") => "page",
                    _ => "data",
                },
            })
            .collect();
        let json = serde_json::to_string(&list).map_err(|e| BuildError::Missing(e.to_string()))?;
        if let Some(template) = assets.service_worker() {
            let version = format!("{:016x}", fnv1a(json.as_bytes()));
            let worker = template
                .replace("\"__PRECACHE__\"", &json)
                .replace("__PRECACHE__", &json)
                .replace("__VERSION__", &version);
            self.put("sw.js", worker.into_bytes());
        }
        self.put("precache.json", json.into_bytes());
        Ok(())
    }

    /// The pages as text.
    pub fn pages(&self) -> BTreeMap<String, String> {
        let pages = self.files.iter().filter(|(path, _)| path.ends_with(".html"));
        pages.map(|(path, bytes)| (path.clone(), String::from_utf8_lossy(bytes).into_owned())).collect()
    }

    /// What is wrong with links, ids and tags.
    pub fn faults(&self) -> Vec<String> {
        let files: BTreeSet<String> = self.files.keys().cloned().collect();
        crate::link::faults(&self.pages(), &files)
    }

    /// Writes everything into `folder`, whose former content goes; a folder that holds something else is left alone.
    ///
    /// # Errors
    /// [`BuildError`] when the folder is not ours, or a file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(), BuildError> {
        let fail = |path: &Path, e| BuildError::File(path.display().to_string(), e);
        let used = std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some());
        if used && !folder.join("precache.json").exists() {
            return Err(BuildError::Missing(format!("{} holds something else than a built site", folder.display())));
        }
        if used {
            std::fs::remove_dir_all(folder).map_err(|e| fail(folder, e))?;
        }
        for (path, bytes) in &self.files {
            let path: PathBuf = folder.join(path);
            if let Some(parent) = path.parent() {
                std::fs::create_dir_all(parent).map_err(|e| fail(parent, e))?;
            }
            std::fs::write(&path, bytes).map_err(|e| fail(&path, e))?;
        }
        Ok(())
    }
}

/// A value for a template.
fn serde(value: impl Serialize) -> Value {
    Value::from(Serde(value))
}
