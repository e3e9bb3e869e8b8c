//! Builds the site from content/, the labs and the compiled sources.
//!
//! A page is made in five steps. `scan` takes out of its Markdown what CommonMark does not know and leaves marks;
//! `parse` builds a tree of CommonMark's elements and these pieces; `label` numbers what the tree holds; `writer` (with
//! `inline`, `block` and `question`) writes the tree as HTML, and the words for the search beside it; `page` puts both
//! together. What is wrong with the content is collected in [`Diagnostics`] and reported at once, each complaint with
//! its file and line.

mod apart;
mod asset;
mod attributes;
mod block;
mod build;
mod cache;
mod check;
mod code;
mod config;
mod diagnostic;
mod directive;
mod dist;
mod figure;
mod file;
mod glossary;
mod hash;
mod html;
mod inline;
mod label;
mod link;
mod listed;
mod markup;
mod matter;
mod notation;
mod number;
mod output;
mod page;
mod parse;
mod piece;
mod question;
mod quiz;
mod reading;
mod reference;
mod scan;
mod search;
mod site;
mod slim;
mod source;
mod still;
mod syntax;
mod template;
mod tex;
mod tree;
mod writer;

pub use asset::Assets;
pub use build::Build;
pub use cache::Cache;
pub use config::{Chapter, Config, Page};
pub use diagnostic::{BuildError, Diagnostic, Diagnostics, Place};
pub use dist::Dist;
pub use figure::Figure;
pub use label::{Label, Labels};
pub use listed::{builds, write as write_list};
pub use number::{Format, Number, Numbers};
pub use output::Outputs;
pub use page::{Section, Text, files, pages, text, texts};
pub use search::SearchEntry;
pub use site::Site;
pub use source::{Listing, Sources};
pub use still::{Apart, Still, Stills, load as load_stills};
pub use writer::{Heading, Used};
