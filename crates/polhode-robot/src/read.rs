//! Files in, models out.
//!
//! A reader says what stands in the file. It refuses only what is no model at all: text that is no XML, another root element.
//! A number that is none (`"0,5"`), an element that lacks one, a mesh that no root holds: these stay in the model as they are,
//! for the checks. What a reader leaves out is a [`Note`].
//!
//! Defaults are not filled in: in SDF a missing mass is 1 kg, a missing moment 1 kg·m², and a link without `<inertial>` has both; here they
//! are [`Slot::Missing`](crate::model::Slot::Missing), [`Tensor::Missing`](crate::model::Tensor::Missing) and `None`, as in the other
//! languages. What SDF's `<inertial auto="true">` asks for is computed.
//!
//! Not read: xacro (expand it first).

mod checked;
mod files;
mod mjcf;
mod model_file;
mod osim;
mod package;
mod pose;
mod sdf;
mod unread;
mod urdf;
mod uri;
mod usd;
pub(crate) mod xml;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use polhode_source::ContentErrorKind;
use polhode_source::FormatError;
use polhode_source::files::{Disk, Files};

use crate::model::{ModelFormat, Note, RobotModel};
use files::{ModelFiles, Naming};

pub use checked::CheckedFolder;
pub use model_file::is_model;

/// How a model is read.
#[derive(Clone, Debug)]
pub struct ReadOptions<'a> {
    /// Place that the model and all files that it names are taken from.
    pub files: &'a dyn Files,
    /// Folders that hold packages, or are packages: `package://NAME/…` and `model://NAME/…` are ROOT/NAME/…, or ROOT/… if ROOT is
    /// NAME. The model's own folder, and the nearest folder around it that has `package.xml` or `model.config`, are roots without being
    /// named. A package that no root holds is an ancestor folder of that name. No other file outside the roots is opened.
    pub roots: Vec<PathBuf>,
    /// These roots and no others, for a model from elsewhere: neither its own folder, if it is not in them, nor a package around it.
    pub confined: bool,
    /// Folder that is checked as a whole. Files below it may be opened. A package that no root or
    /// ancestor holds is looked up below it: exactly one folder of that name has to hold the file.
    pub checked: Option<Arc<CheckedFolder>>,
}

impl Default for ReadOptions<'_> {
    /// Files of this machine, and no roots but those that need no naming.
    fn default() -> Self {
        Self { files: &Disk, roots: Vec::new(), confined: false, checked: None }
    }
}

/// Reads a URDF, SDF, MJCF, USD (`.usda`) or OpenSim file: its root element or first word says which.
///
/// ```
/// use polhode_robot::read::{ReadOptions, read_text};
/// let text = r#"<robot name="r"><link name="arm"><inertial><mass value="1,5"/></inertial></link></robot>"#;
/// let model = read_text(text, "arm.urdf".as_ref(), &ReadOptions::default())?;
/// let mass = &model.links[0].inertial.as_ref().unwrap().mass;
/// assert_eq!((mass.finite(), &text[mass.span()]), (None, "1,5"));
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
///
/// # Errors
/// [`FormatError`] if the file cannot be read, is not UTF-8, not well-formed or in none of the languages, or has a document type.
pub fn read_model(path: &Path, options: &ReadOptions<'_>) -> Result<RobotModel, FormatError> {
    let text = polhode_source::read_text_file(options.files, path, |text| Ok(text.to_owned()));
    match text {
        Ok(text) => read(text, path, options),
        Err(error) => Err(binary_usd(options.files, path).unwrap_or(error)),
    }
}

/// What to do about a file of USD that is not text.
fn binary_usd(files: &dyn Files, path: &Path) -> Option<FormatError> {
    let ending = path.extension()?.to_str()?.to_ascii_lowercase();
    if !matches!(ending.as_str(), "usd" | "usdc" | "usdz") || !files.is_file(path) {
        return None;
    }
    let error = ContentErrorKind::unsupported("USD that is not text").of_whole();
    let file = path.file_name()?.to_string_lossy().into_owned();
    let error = error.hint(format!("write it as text: usdcat --flatten {file} --out robot.usda"));
    Some(FormatError::of_content(path, b"", error))
}

/// The same for a text; `path` is for messages, and its folder for the files that the model names.
///
/// # Errors
/// As [`read_model`].
pub fn read_text(text: &str, path: &Path, options: &ReadOptions<'_>) -> Result<RobotModel, FormatError> {
    read(text.to_owned(), path, options)
}

/// The language of a text by its root element or its first word, whether or not the rest can be read; `None` if it is none of these.
pub fn format_of(text: &str) -> Option<ModelFormat> {
    if text.trim_start_matches('\u{feff}').trim_start().starts_with("#usda") {
        return Some(ModelFormat::Usd);
    }
    language(root_of(text)?)
}

/// The name of the root element of a text, whether or not the rest can be read; `None` if the text does not come to one.
pub fn root_of(text: &str) -> Option<&str> {
    let mut rest = text.strip_prefix('\u{feff}').unwrap_or(text).trim_start();
    loop {
        let close = if rest.starts_with("<!--") {
            "-->"
        } else if rest.starts_with("<?") {
            "?>"
        } else {
            break;
        };
        rest = rest.split_once(close)?.1.trim_start();
    }
    let name = rest.strip_prefix('<')?;
    name.split(|c: char| c.is_whitespace() || c == '>' || c == '/').next().filter(|name| !name.is_empty())
}

fn language(root: &str) -> Option<ModelFormat> {
    match root {
        "robot" => Some(ModelFormat::Urdf),
        "sdf" | "gazebo" => Some(ModelFormat::Sdf),
        "mujoco" | "mujocoinclude" => Some(ModelFormat::Mjcf),
        "OpenSimDocument" => Some(ModelFormat::Osim),
        _ => None,
    }
}

fn read(text: String, path: &Path, options: &ReadOptions<'_>) -> Result<RobotModel, FormatError> {
    if format_of(&text) == Some(ModelFormat::Usd) {
        let mut model = RobotModel::empty(path, ModelFormat::Usd);
        usd::read(&text, &mut model)
            .map_err(|error| FormatError::of_content(path, text.as_bytes(), error))?;
        keep_finite(&mut model);
        return Ok(RobotModel { text, ..model });
    }
    let roots = uri::Roots::of(path, options);
    let naming = match format_of(&text) {
        Some(ModelFormat::Mjcf) => Naming::Mjcf,
        Some(ModelFormat::Sdf) => Naming::Sdf,
        _ => Naming::Nothing,
    };
    let mut files = ModelFiles::of(text, path, &roots, naming)?;
    let notes = std::mem::take(&mut files.notes);
    let mut model = files.with_root(|root| {
        let Some(format) = language(root.name()) else {
            let what = "<robot> (URDF), <sdf>, <mujoco> or <OpenSimDocument>";
            return Err(ContentErrorKind::expected(what, format!("<{}>", root.name())).at(root.span()));
        };
        let mut model = RobotModel { notes, ..RobotModel::empty(path, format) };
        match format {
            ModelFormat::Urdf => urdf::read(root, &roots, &mut model)?,
            ModelFormat::Sdf => sdf::read(root, &files, &roots, &mut model)?,
            ModelFormat::Mjcf => mjcf::read(root, &files.folders, &roots, &mut model)?,
            ModelFormat::Osim => osim::read(root, &mut model)?,
            ModelFormat::Usd => {}
        }
        Ok(model)
    })?;
    let mut sources = files.sources.into_iter();
    model.text = sources.next().map_or_else(String::new, |main| main.text);
    model.included = sources.collect();
    model.folder.clone_from(roots.folder());
    roots.report(&mut model);
    keep_finite(&mut model);
    Ok(model)
}

/// Takes frames whose place f64 does not hold to the origin, with a note.
fn keep_finite(model: &mut RobotModel) {
    let links = model.links.iter_mut().map(|link| (&link.name, &link.span, &mut link.pose));
    let joints = model.joints.iter_mut().map(|joint| (&joint.name, &joint.span, &mut joint.pose));
    for (name, span, pose) in links.chain(joints) {
        if !pose.position.iter().all(|c| c.is_finite()) {
            pose.position = [0.0; 3];
            let message = "its place is beyond the largest double: it is taken at the origin".to_owned();
            model.notes.push(Note::new("read.pose", &name.text, span.clone(), message));
        }
    }
}
