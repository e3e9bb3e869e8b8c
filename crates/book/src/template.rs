//! Templates: of pages, which lie in `web/templates/`, and of blocks, which are part of this crate.

use std::path::Path;

use minijinja::value::Serde;
use minijinja::{Environment, UndefinedBehavior, Value};
use serde::Serialize;

use crate::diagnostic::BuildError;
use crate::file;
use crate::html::escape;

/// The templates of pages, and the macros of `templates/blocks.html`, one for each block.
pub struct Templates {
    environment: Environment<'static>,
    /// The paper's colour by day and by night, as the style sheet has it, for the browser's own frame.
    pub paper: Vec<String>,
}

impl Templates {
    /// The macros, and every template of pages under `root`.
    ///
    /// # Errors
    /// [`BuildError`] when one cannot be read or does not parse.
    pub fn load(root: &Path) -> Result<Self, BuildError> {
        let folder = root.join("web/templates");
        let mut texts = vec![(BLOCKS.to_string(), include_str!("../templates/blocks.html").to_string())];
        for name in if folder.is_dir() { file::below(&folder)? } else { Vec::new() } {
            let text = file::read(&folder.join(&name))?;
            texts.push((name, text));
        }
        let mut environment = Environment::new();
        environment.set_undefined_behavior(UndefinedBehavior::SemiStrict);
        // Every value that is not HTML is escaped.
        environment.set_formatter(|out, _, value| {
            let text = value.to_string();
            let text = if value.is_safe() { text } else { escape(&text) };
            out.write_str(&text).map_err(minijinja::Error::from)
        });
        for (name, text) in texts {
            let added = environment.add_template_owned(name, text);
            added.map_err(|e| BuildError::Missing(format!("a template: {e}")))?;
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

    /// The macro `name` of the blocks filled with `values`.
    ///
    /// # Errors
    /// A message when there is no such macro or it asks for a value it is not given.
    pub fn fill(&self, name: &str, values: Value) -> Result<String, String> {
        let macros = self.environment.get_template(BLOCKS).and_then(|it| it.render_captured(()));
        let block = macros.and_then(|mut macros| macros.with_state_mut(|state| state.call_macro(name, &[values])));
        block.map_err(|e| format!("templates/{BLOCKS}: {e:#}"))
    }
}

/// The file of the macros.
const BLOCKS: &str = "blocks.html";

/// A value for a template.
pub fn serde(value: impl Serialize) -> Value {
    Value::from(Serde(value))
}

/// HTML that a template takes as it is.
pub fn safe(html: String) -> Value {
    Value::from_safe_string(html)
}
