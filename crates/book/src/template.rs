//! Templates: of pages, which lie in `web/templates/`, and of blocks, which are part of this crate.

use std::path::Path;

use minijinja::value::Serde;
use minijinja::{Environment, UndefinedBehavior, Value};
use serde::Serialize;

use crate::diagnostic::BuildError;
use crate::file;
use crate::html::escape;

/// The templates of pages.
pub struct Templates {
    environment: Environment<'static>,
    /// The paper's colour by day and by night, as the style sheet has it, for the browser's own frame.
    pub paper: Vec<String>,
}

impl Templates {
    /// Reads every template under `root`.
    ///
    /// # Errors
    /// [`BuildError`] when one cannot be read or does not parse.
    pub fn load(root: &Path) -> Result<Self, BuildError> {
        let folder = root.join("web/templates");
        let mut environment = environment();
        for name in file::below(&folder)? {
            let text = file::read(&folder.join(&name))?;
            environment
                .add_template_owned(name, text)
                .map_err(|e| BuildError::Missing(format!("web/templates: {e}")))?;
        }
        let tokens = std::fs::read_to_string(root.join("web/style/tokens.css")).unwrap_or_default();
        let values = tokens.split("--paper:").skip(1).take(2).filter_map(|rest| rest.split_once(';'));
        let paper = values.map(|(value, _)| value.trim().to_string()).collect();
        Ok(Self { environment, paper })
    }

    /// The template `name` filled with `values`.
    ///
    /// # Errors
    /// [`BuildError::Missing`] when there is no such template or it asks for a value it is not given.
    pub fn render(&self, name: &str, values: Value) -> Result<String, BuildError> {
        let template = self.environment.get_template(name);
        let page = template.and_then(|template| template.render(values));
        page.map_err(|e| BuildError::Missing(format!("web/templates/{name}: {e:#}")))
    }
}

/// What the blocks of a page look like: the macros of `templates/blocks.html`.
pub struct Blocks {
    environment: Environment<'static>,
}

impl Default for Blocks {
    fn default() -> Self {
        let mut environment = environment();
        // Macros that do not parse are missed, with the reason, when the first block is filled.
        let _ = environment.add_template("blocks.html", include_str!("../templates/blocks.html"));
        Self { environment }
    }
}

impl Blocks {
    /// The macro `name` filled with `values`.
    ///
    /// # Errors
    /// A message when there is no such macro or it asks for a value it is not given.
    pub fn fill(&self, name: &str, values: Value) -> Result<String, String> {
        let macros = self.environment.get_template("blocks.html").and_then(|it| it.render_captured(()));
        let block = macros.and_then(|mut macros| macros.with_state_mut(|state| state.call_macro(name, &[values])));
        block.map_err(|e| format!("templates/blocks.html: {e:#}"))
    }
}

/// A value for a template.
pub fn serde(value: impl Serialize) -> Value {
    Value::from(Serde(value))
}

/// HTML that a template takes as it is.
pub fn safe(html: String) -> Value {
    Value::from_safe_string(html)
}

/// Every value that is not HTML is escaped, and one that is not given is an error.
fn environment() -> Environment<'static> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::SemiStrict);
    environment.set_formatter(|out, _, value| {
        let text = value.to_string();
        let text = if value.is_safe() { text } else { escape(&text) };
        out.write_str(&text).map_err(minijinja::Error::from)
    });
    environment
}
