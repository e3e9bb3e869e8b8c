//! What each block directive looks like: notes, figures, algorithms, exercises, listings, tables.

use crate::attributes::Attributes;
use crate::diagnostic::Place;
use crate::html::escape;
use crate::output::Outputs;
use crate::render::Renderer;
use crate::still::WIDGETS;
use crate::tex::Style;

/// Kinds of notes and what each is headed with.
const NOTES: [(&str, &str); 4] = [
    ("correction", "Where the source and the mathematics part"),
    ("honesty", "Said honestly"),
    ("hazard", "Take care"),
    ("aside", ""),
];

/// Kinds of exercises.
const EXERCISES: [&str; 3] = ["foundation", "conceptual", "practical"];

impl Renderer<'_> {
    pub(crate) fn note(&mut self, id: &str, kind: &str, title: &str, place: &Place) -> String {
        let Some((_, word)) = NOTES.iter().find(|(known, _)| *known == kind) else {
            let kinds: Vec<_> = NOTES.iter().map(|(kind, _)| *kind).collect();
            self.diagnostics.report(place, format!("no note is of kind `{kind}`; there are {}", kinds.join(", ")));
            return String::new();
        };
        let word = if word.is_empty() { String::new() } else { format!("<span class=\"note-kind\">{word}</span> ") };
        let title = match title {
            "" => String::new(),
            title => format!("<span class=\"note-title\">{}</span>", self.title(title, place)),
        };
        let head = if word.is_empty() && title.is_empty() {
            String::new()
        } else {
            format!("<p class=\"note-head\">{word}{title}</p>")
        };
        format!("<div class=\"note note-{kind}\" role=\"note\"{id}>{head}\n")
    }

    pub(crate) fn figure(&mut self, id: &str, label: &str, attributes: &Attributes, place: &Place) -> String {
        let widget = attributes.value("widget").unwrap_or_default();
        if !WIDGETS.contains(&widget) {
            self.diagnostics.report(place, format!("no widget is called `{widget}`; there are {}", WIDGETS.join(", ")));
        }
        let title = match attributes.value("title") {
            None => String::new(),
            Some(title) => format!("<p class=\"figure-title\">{}</p>", self.title(title, place)),
        };
        let start = attributes.value("start").map(|start| {
            let read = serde_json::from_str::<serde_json::Map<String, serde_json::Value>>(start);
            self.diagnostics.ok(place, read.map_err(|error| format!("`start` is no JSON object: {error}")));
            format!(" data-start=\"{}\"", escape(start))
        });
        let start = start.unwrap_or_default();
        let figure = attributes.id.as_deref().unwrap_or_default();
        let stills = &self.site.stills;
        let still = stills.get(figure).or_else(|| stills.get(widget)).cloned().unwrap_or_default();
        let figure = escape(figure);
        format!(
            "<figure class=\"figure figure-widget\"{id}>{title}<{widget} class=\"widget\" data-widget=\"{widget}\" data-figure=\"{figure}\"{start}>\
             <div class=\"still\">{}</div><p class=\"still-text visually-hidden\">{}</p></{widget}><figcaption>{label}\n",
            still.svg,
            escape(&still.words)
        )
    }

    pub(crate) fn algorithm(&mut self, id: &str, label: &str, attributes: &Attributes, place: &Place) -> String {
        let name = self.title(attributes.value("name").unwrap_or_default(), place);
        let mut facts = String::new();
        for (key, word) in [("in", "In"), ("out", "Out"), ("cost", "Cost")] {
            if let Some(value) = attributes.value(key) {
                facts += &format!("<div><dt>{word}</dt><dd>{}</dd></div>", self.inline(value, place));
            }
        }
        let facts = if facts.is_empty() { facts } else { format!("<dl class=\"algorithm-io\">{facts}</dl>") };
        format!(
            "<figure class=\"algorithm\"{id}><figcaption class=\"algorithm-head\">{label}<span class=\"algorithm-name\">{name}</span>\
             </figcaption>{facts}<div class=\"algorithm-steps\">\n"
        )
    }

    pub(crate) fn exercise(&mut self, id: &str, label: &str, attributes: &Attributes, place: &Place) -> String {
        let text = |key: &str| attributes.value(key).unwrap_or_default();
        let (kind, difficulty) = (text("kind"), text("difficulty"));
        if !EXERCISES.contains(&kind) {
            self.diagnostics
                .report(place, format!("no exercise is of kind `{kind}`; there are {}", EXERCISES.join(", ")));
        }
        let level = difficulty.parse().ok().filter(|level| (1..=3).contains(level));
        if level.is_none() {
            self.diagnostics.report(place, format!("difficulty is 1, 2 or 3, not `{difficulty}`"));
        }
        let level = level.unwrap_or(1);
        let dots = format!("{}{}", "●".repeat(level), "○".repeat(3 - level));
        let title = self.title(text("title"), place);
        format!(
            "<div class=\"exercise\"{id} data-kind=\"{kind}\" data-difficulty=\"{level}\"><h3 class=\"exercise-head\">{label}\
             <span class=\"title\">{title}</span></h3><p class=\"exercise-facts\"><span class=\"exercise-kind\">{kind}</span> \
             <span class=\"exercise-difficulty\"><span aria-hidden=\"true\">{dots}</span><span class=\"visually-hidden\">difficulty \
             {level} of 3</span></span></p>\n"
        )
    }

    pub(crate) fn listing(&mut self, path: &str, anchor: Option<&str>, place: &Place) -> String {
        let Some(listing) = self.diagnostics.ok(place, self.site.sources.listing(path, anchor)) else {
            return String::new();
        };
        let code = self.site.highlighter.html(&listing.code, "rust");
        format!(
            "<figure class=\"listing\"><figcaption class=\"listing-path\"><a class=\"source-link\" href=\"{}\">{}</a></figcaption>\
             <pre class=\"code scroll-box\"><code class=\"language-rust\">{code}</code></pre></figure>\n",
            self.source_href(path, listing.line),
            escape(path)
        )
    }

    pub(crate) fn output(&mut self, example: &str, place: &Place) -> String {
        let Some(output) = self.diagnostics.ok(place, self.site.outputs.get(example)) else { return String::new() };
        format!(
            "<figure class=\"listing output\"><figcaption class=\"listing-path\"><code>{}</code></figcaption>\
             <pre class=\"code scroll-box\"><samp>{}</samp></pre></figure>\n",
            escape(&Outputs::command(example)),
            escape(output.trim_end())
        )
    }

    /// The two conventions side by side, in fixed letters.
    pub(crate) fn notation(&mut self, id: &str) -> String {
        let mut rows = String::new();
        for row in &self.site.notation {
            let choset = self.formula(&row.choset.markdown, Style::Inline, &row.choset.place);
            let thrun = self.formula(&row.thrun.markdown, Style::Inline, &row.thrun.place);
            let meaning = self.inline(&row.meaning.markdown, &row.meaning.place);
            rows += &format!("<tr><td>{choset}</td><td>{thrun}</td><td>{meaning}</td></tr>\n");
        }
        format!(
            "<div class=\"table-box scroll-box\"{id}><table class=\"notation\"><thead><tr><th scope=\"col\">Choset, this book</th>\
             <th scope=\"col\">Thrun, the sister volume</th><th scope=\"col\">What it is</th></tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n"
        )
    }
}
