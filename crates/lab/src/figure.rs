//! A figure, as a list of figures has it.

use crate::experiment::Kind;
use std::borrow::Cow;

/// A figure, and the lab behind it.
#[derive(Debug)]
pub struct Figure {
    /// The class of its lab in the module.
    pub class: &'static str,
    /// The build of the module that has the class.
    pub build: &'static str,
    /// Whether the lab stands on something from outside.
    pub world: bool,
    /// What the figure was called before.
    pub was: Option<&'static str>,
    /// What is known of the lab, its name among it.
    pub kind: &'static Kind,
}

impl Figure {
    /// The name of the figure: its lab's in links, its folder's in `web/widgets`, its page's in `figure/`.
    pub fn name(&self) -> &'static str {
        self.kind.name
    }

    /// The custom element that shows it. Its name must have a hyphen: a name without one gets `lab-` before it.
    pub fn tag(&self) -> Cow<'static, str> {
        let name = self.name();
        if name.contains('-') { name.into() } else { format!("lab-{name}").into() }
    }
}
