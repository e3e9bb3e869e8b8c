//! What an earlier run of the same program computed from the same input, in files: the numbers of the ensembles and
//! the coloured sources are most of a build's time, and a change of prose needs neither again.

use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::hash::fnv1a;

/// Values by name, each beside a key of the program and the input it comes from.
#[derive(Debug, Default)]
pub struct Cache {
    folder: Option<PathBuf>,
    program: u64,
}

impl Cache {
    /// Keeps nothing, and computes every value.
    pub fn nothing() -> Self {
        Self::default()
    }

    /// Keeps in `folder` what this program computes: another program, even of the same sources, computes its values
    /// anew. Nothing is kept where the program cannot be read.
    pub fn by_this_program(folder: &Path) -> Self {
        let program = std::env::current_exe().and_then(std::fs::read);
        program.map_or_else(|_| Self::nothing(), |bytes| Self { folder: Some(folder.into()), program: fnv1a(&bytes) })
    }

    /// The value called `name`: as kept where `input` is the same, else as computed. A value that cannot be read or
    /// written (a number that is not finite has no JSON) is computed each time.
    ///
    /// # Errors
    /// What `compute` answers.
    pub fn or<T: Serialize + DeserializeOwned, E>(
        &self,
        name: &str,
        input: &str,
        compute: impl FnOnce() -> Result<T, E>,
    ) -> Result<T, E> {
        let Some(folder) = &self.folder else { return compute() };
        let file = folder.join(format!("{name}.json"));
        let key = format!("{:016x}{:016x}", self.program, fnv1a(input.as_bytes()));
        let kept = std::fs::read(&file).ok().and_then(|json| serde_json::from_slice::<(String, T)>(&json).ok());
        if let Some((of, value)) = kept
            && of == key
        {
            return Ok(value);
        }
        let value = compute()?;
        if let (Some(parent), Ok(json)) = (file.parent(), serde_json::to_vec(&(key, &value))) {
            let _ = std::fs::create_dir_all(parent).and_then(|()| std::fs::write(&file, json));
        }
        Ok(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value kept under `name`, or `fresh`.
    fn value(cache: &Cache, input: &str, fresh: f64) -> f64 {
        cache.or("a/name", input, || Ok::<_, ()>(fresh)).unwrap()
    }

    #[test]
    fn a_value_is_computed_again_when_its_input_or_the_program_is_another() {
        let folder = std::env::temp_dir().join(format!("kept-{}", std::process::id()));
        let cache = Cache::by_this_program(&folder);
        assert_eq!(value(&cache, "input", 0.1), 0.1);
        assert_eq!(value(&cache, "input", 0.2), 0.1);
        assert_eq!(value(&cache, "other", 0.3), 0.3);
        let program = Cache { program: cache.program + 1, ..Cache::by_this_program(&folder) };
        assert_eq!(value(&program, "other", 0.4), 0.4);
        std::fs::write(folder.join("a/name.json"), "half a fi").unwrap();
        assert_eq!(value(&program, "other", 0.5), 0.5);
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_json_cannot_hold_is_computed_each_time_and_an_error_is_not_kept() {
        let folder = std::env::temp_dir().join(format!("kept-not-{}", std::process::id()));
        let cache = Cache::by_this_program(&folder);
        assert_eq!(value(&cache, "", f64::INFINITY), f64::INFINITY);
        assert_eq!(value(&cache, "", 1.0), 1.0);
        assert_eq!(cache.or("failed", "", || Err::<f64, _>("no")), Err("no"));
        assert_eq!(cache.or("failed", "", || Ok::<_, ()>(2.0)), Ok(2.0));
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn nothing_is_kept_where_there_is_no_folder() {
        assert_eq!(value(&Cache::nothing(), "", 1.0), 1.0);
        assert_eq!(value(&Cache::nothing(), "", 2.0), 2.0);
    }
}
