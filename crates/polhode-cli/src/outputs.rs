//! Checks of the output files before the first is written: each is writable, all differ, and none
//! of them is an input.

use std::fs;
use std::path::{Path, PathBuf};

use polhode_robot::model::{GeometryShape, RobotModel};
use polhode_source::shown;

use crate::failure::Failure;
use crate::partial::parent;
use crate::same_file::is_same;

/// Options with their output files.
pub(crate) struct Outputs<'a> {
    files: Vec<(&'static str, &'a Path)>,
    force: bool,
}

impl<'a> Outputs<'a> {
    pub(crate) fn new<const N: usize>(options: [(&'static str, Option<&'a Path>); N], force: bool) -> Self {
        let files = options.into_iter().filter_map(|(option, file)| Some((option, file?))).collect();
        Self { files, force }
    }

    /// Returns the outputs without that of one option.
    pub(crate) fn without(&self, option: &str) -> Self {
        let files = self.files.iter().copied().filter(|(other, _)| *other != option).collect();
        Self { files, force: self.force }
    }

    /// Refuses two outputs to the same file, and a path where no file can be created or replaced.
    pub(crate) fn require_places(&self) -> Result<(), Failure> {
        for (k, (option, out)) in self.files.iter().enumerate() {
            if let Some((other, _)) = self.files.iter().take(k).find(|(_, other)| is_same(out, other)) {
                return Err(Failure::usage(
                    format!("{other} and {option} would both write {}", shown(out)),
                    "name a different file for each",
                ));
            }
        }
        self.files.iter().try_for_each(|(option, out)| require_place(option, out, self.force))
    }

    /// Refuses to overwrite an input, even with `--force`; `what` describes the input in messages.
    pub(crate) fn require_not_read<'p>(
        &self,
        what: &str,
        mut read: impl Iterator<Item = &'p Path>,
    ) -> Result<(), Failure> {
        if self.files.is_empty() {
            return Ok(());
        }
        let overwritten = read.find_map(|file| self.files.iter().find(|(_, out)| is_same(out, file)));
        match overwritten {
            Some((option, out)) => Err(Failure::usage(
                format!("{option} would overwrite {what}, {}", shown(out)),
                "write to another file, compare, then replace the original",
            )),
            None => Ok(()),
        }
    }

    /// Refuses to overwrite a file that belongs to a model.
    pub(crate) fn require_not_part_of(&self, model: &RobotModel) -> Result<(), Failure> {
        let included = || model.included.iter().map(|source| source.path.as_path());
        self.require_not_read("a file that the model includes", included())?;
        let manifests: Vec<PathBuf> = included().map(|path| path.with_file_name("model.config")).collect();
        self.require_not_read(
            "the model.config of a model that is included",
            manifests.iter().map(PathBuf::as_path),
        )?;
        let meshes =
            model.links.iter().flat_map(|link| &link.geometry).filter_map(|geometry| match &geometry.shape {
                GeometryShape::Mesh { path: Ok(path), .. } => Some(path.as_path()),
                _ => None,
            });
        self.require_not_read("a mesh of the model", meshes)
    }

    /// Refuses to overwrite the file in which the model breaks off, and all files that it names,
    /// because the parts of an unreadable model are unknown.
    pub(crate) fn require_not_named(
        &self,
        model: &Path,
        failure: &polhode_source::Failure,
    ) -> Result<(), Failure> {
        let torn =
            if let polhode_source::Failure::Input(error) = failure { Some(error.path()) } else { None };
        self.require_not_read("a file that the model includes", torn.into_iter())?;
        let there = self.files.iter().filter(|(_, out)| out.is_file());
        let names: Vec<_> = there.filter_map(|(_, out)| Some((*out, out.file_name()?.to_str()?))).collect();
        if names.is_empty() {
            return Ok(());
        }
        let text = fs::read(model).unwrap_or_default();
        let text = String::from_utf8_lossy(&text);
        let named = names.into_iter().find(|(_, name)| text.contains(name)).map(|(out, _)| out);
        self.require_not_read("an unreadable file that the model names", named.into_iter())
    }
}

fn require_place(option: &str, out: &Path, force: bool) -> Result<(), Failure> {
    let shown = shown(out);
    match fs::symlink_metadata(out) {
        Ok(meta) if meta.is_dir() || out.is_dir() => Err(Failure::usage(
            format!("{shown} is a folder, but {option} writes a file"),
            "name a file in it",
        )),
        Ok(_) if !force => Err(Failure::usage(
            format!("{shown} already exists"),
            "choose another file, or overwrite it with --force",
        )),
        _ if !parent(out).is_dir() => {
            Err(Failure::usage(format!("the folder of {shown} does not exist"), "create the folder first"))
        }
        _ => Ok(()),
    }
}
