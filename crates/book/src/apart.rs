//! A part of a chapter with a page of its own, as the chapter's other pages know it: the chapter lists its exercises or
//! its sections, and it shows the figures of the chapter that its questions ask for.

use minijinja::{Value, context};
use pulldown_cmark::{HeadingLevel, Tag};

use crate::block::dots;
use crate::diagnostic::Place;
use crate::piece::Piece;
use crate::quiz::Answer;
use crate::site::Site;
use crate::template::safe;
use crate::tree::{self, Kind, Node};
use crate::writer::Writer;

/// The directives called `name` in `texts`, in order.
pub fn all<'a>(texts: &'a [Vec<Node>], name: &str) -> Vec<&'a Node> {
    let mut found = Vec::new();
    texts.iter().for_each(|text| {
        tree::walk(text, &mut |node| {
            if node.is_directive(name) {
                found.push(node);
            }
        });
    });
    found
}

/// The id of a directive.
pub fn id(node: &Node) -> &str {
    match &node.kind {
        Kind::Piece(Piece::Directive { attributes, .. }) => attributes.id.as_deref().unwrap_or_default(),
        _ => "",
    }
}

/// The ids of the figures that the questions of `texts` ask for, each once.
pub fn asked(site: &Site, texts: &[Vec<Node>]) -> Vec<String> {
    let mut asked = Vec::new();
    for quiz in all(texts, "quiz") {
        if let Some(Answer::State(state)) = site.quizzes.get(id(quiz)).map(|quiz| &quiz.answer)
            && !asked.contains(&state.figure.markdown)
        {
            asked.push(state.figure.markdown.clone());
        }
    }
    asked
}

impl<'a> Writer<'a> {
    /// The exercises of the part called `page` for a list: each with its questions, whose answers the browser keeps
    /// under the same names on every page, and with every id that an address may name; with `beside` those that say
    /// they stand beside it. Without `beside` the first exercise below a heading has the heading's id too, the last one
    /// that of a heading without any: an address of before names it.
    pub(crate) fn exercises(&mut self, page: &str, beside: &str, place: &Place) -> Value {
        let Some(texts) = self.texts_of(page, place) else { return Value::UNDEFINED };
        let mut nodes: Vec<(&Node, Vec<String>)> = Vec::new();
        let mut above = Vec::new();
        texts.iter().for_each(|text| {
            tree::walk(text, &mut |node| match &node.kind {
                Kind::Element(Tag::Heading { id: Some(id), .. }) if beside.is_empty() => above.push(id.to_string()),
                Kind::Piece(Piece::Directive { name, attributes })
                    if name == "exercise" && (beside.is_empty() || attributes.value("beside") == Some(beside)) =>
                {
                    nodes.push((node, std::mem::take(&mut above)));
                }
                _ => {}
            });
        });
        if let Some((_, ids)) = nodes.last_mut() {
            ids.append(&mut above);
        }
        if nodes.is_empty() {
            self.diagnostics.report(place, format!("no exercise of `{page}` stands beside `{beside}`"));
        }
        let listed = nodes.into_iter().map(|(node, mut ids)| {
            let Kind::Piece(Piece::Directive { attributes, .. }) = &node.kind else { return Value::UNDEFINED };
            let value = |key: &str| attributes.value(key).unwrap_or_default();
            let mut quizzes = Vec::new();
            tree::walk(&node.children, &mut |inner| {
                let Kind::Piece(Piece::Directive { name, attributes }) = &inner.kind else { return };
                let Some(id) = &attributes.id else { return };
                match (name.as_str(), self.site.quizzes.get(id)) {
                    ("quiz", Some(quiz)) => quizzes.push(context! { id, hash => &quiz.hash }),
                    ("quiz", None) => {}
                    _ => ids.push(id.clone()),
                }
            });
            let label = self.diagnostics.ok(&node.place, self.labels.get(id(node), self.root));
            context! {
                id => id(node),
                label => label.as_ref().map(|label| label.text.clone()),
                href => label.map(|label| label.href),
                title => safe(self.title(value("title"), &node.place)),
                difficulty => value("difficulty"),
                dots => dots(value("difficulty").parse().unwrap_or_default()),
                ids,
                quizzes,
            }
        });
        listed.collect()
    }

    /// The texts of the part called `page`.
    fn texts_of(&self, page: &str, place: &Place) -> Option<&'a [Vec<Node>]> {
        let end = format!("/{page}/");
        let found = self.apart.texts.iter().find(|(at, _)| at.ends_with(&end)).map(|(_, texts)| *texts);
        if found.is_none() {
            self.diagnostics.report(place, format!("no part of this chapter is called `{page}`"));
        }
        found
    }

    /// The sections of the part called `page` for a list: each with its title, and with the ids of the headings within
    /// it, which an address may name.
    pub(crate) fn contents(&mut self, page: &str, place: &Place) -> Value {
        let Some(texts) = self.texts_of(page, place) else { return Value::UNDEFINED };
        let mut sections: Vec<(&Node, &str, Vec<String>)> = Vec::new();
        texts.iter().for_each(|text| {
            tree::walk(text, &mut |node| {
                let Kind::Element(Tag::Heading { level, id: Some(id), .. }) = &node.kind else { return };
                match sections.last_mut() {
                    Some((_, _, within)) if *level > HeadingLevel::H2 => within.push(id.to_string()),
                    _ => sections.push((node, id.as_ref(), Vec::new())),
                }
            });
        });
        let plain = std::mem::replace(&mut self.plain, true);
        let listed = sections.into_iter().map(|(node, id, within)| {
            let href = self.diagnostics.ok(&node.place, self.labels.get(id, self.root)).map(|label| label.href);
            let title = self.write(&node.children);
            self.words.push(' ');
            context! { id, href, title => safe(title), within }
        });
        let listed = listed.collect();
        self.plain = plain;
        listed
    }
}
