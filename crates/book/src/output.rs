//! Program output, captured from a real run of an example of `crates/estimate`.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::Command;

/// Runs examples, each at most once a build.
#[derive(Debug)]
pub struct Outputs {
    root: Option<PathBuf>,
    ran: RefCell<BTreeMap<String, Result<String, String>>>,
}

impl Outputs {
    /// Runs examples of the workspace at `root`.
    pub fn of(root: impl Into<PathBuf>) -> Self {
        Self { root: Some(root.into()), ran: RefCell::default() }
    }

    /// Knows the outputs given and runs nothing.
    pub fn fixed<'a>(outputs: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let ran = outputs.into_iter().map(|(example, text)| (example.to_string(), Ok(text.to_string()))).collect();
        Self { root: None, ran: RefCell::new(ran) }
    }

    /// The command a reader types.
    pub fn command(example: &str) -> String {
        format!("cargo run --example {example} -p robot-motion-estimate")
    }

    /// What `example` prints.
    ///
    /// # Errors
    /// A message when it cannot be run, or fails.
    pub fn get(&self, example: &str) -> Result<String, String> {
        if let Some(known) = self.ran.borrow().get(example) {
            return known.clone();
        }
        let output = self.run(example);
        self.ran.borrow_mut().insert(example.to_string(), output.clone());
        output
    }

    fn run(&self, example: &str) -> Result<String, String> {
        let root = self.root.as_ref().ok_or_else(|| format!("no output of `{example}`"))?;
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(cargo);
        // Without optimization: the output is the same, and the tests have built the example already.
        command.current_dir(root).args(["run", "-q", "--example", example, "-p", "robot-motion-estimate"]);
        let output = command.output().map_err(|e| format!("`{}`: {e}", Self::command(example)))?;
        if !output.status.success() {
            let stderr = String::from_utf8_lossy(&output.stderr);
            return Err(format!("`{}` failed: {}", Self::command(example), stderr.trim()));
        }
        String::from_utf8(output.stdout).map_err(|e| format!("`{}`: {e}", Self::command(example)))
    }
}
