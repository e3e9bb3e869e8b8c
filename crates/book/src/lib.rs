//! Builds the site from content/, the labs and the compiled sources.
//!
//! A page goes through four hands: `scan` takes out of its Markdown what CommonMark does not know, `label` numbers its
//! elements, `render` (with `piece`, `directive` and `question`) writes its HTML, `page` puts that into the template.
//! What is wrong with the content is collected in [`Diagnostics`] and reported at once, each complaint with its file and
//! line.

mod asset;
mod attributes;
mod check;
mod code;
mod config;
mod diagnostic;
mod directive;
mod dist;
mod document;
mod environment;
mod figure;
mod glossary;
mod html;
mod label;
mod link;
mod markup;
mod matter;
mod number;
mod output;
mod page;
mod piece;
mod question;
mod quiz;
mod reference;
mod render;
mod scan;
mod site;
mod slim;
mod source;
mod still;
mod syntax;
mod template;
mod tex;

pub use asset::Assets;
pub use check::Check;
pub use config::{Chapter, Config, Page};
pub use diagnostic::{BuildError, Diagnostic, Diagnostics, Place};
pub use dist::{Build, Dist};
pub use figure::Figure;
pub use label::{Label, Labels};
pub use number::{Format, Number, Numbers};
pub use output::Outputs;
pub use page::{Found, Section, Text, files, text};
pub use render::{Heading, Used};
pub use site::Site;
pub use source::{Listing, Sources};
pub use still::{Still, Stills, WIDGETS, load as load_stills};
