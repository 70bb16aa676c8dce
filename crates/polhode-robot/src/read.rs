//! Readers of model files.
//!
//! A reader returns the contents of a file without judging them. It refuses only text that is not a
//! model: XML that is not well-formed, or another root element. Unreadable numbers (`"0,5"`),
//! missing numbers and missing mesh files stay in the model for the checks. Skipped content is
//! reported as a [`Note`].
//!
//! Defaults are not filled in. In SDF a missing mass means 1 kg, a missing moment 1 kg·m², and a
//! link without `<inertial>` has both. Here, as in the other languages, they are
//! [`Slot::Missing`](crate::model::Slot::Missing),
//! [`Tensor::Missing`](crate::model::Tensor::Missing) and `None`. SDF's `<inertial auto="true">` is
//! computed.
//!
//! xacro is not read: `xacro.rs` only finds the files of a model that was expanded from it, so that
//! findings can be traced to macros.

mod checked;
mod computed;
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
#[cfg(feature = "usd")]
pub(crate) mod usd;
mod xacro;
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

/// Options for reading a model.
#[derive(Clone, Debug)]
pub struct ReadOptions<'a> {
    /// File system for the model and for all files that it names.
    pub files: &'a dyn Files,
    /// Folders that are packages or contain packages. `package://NAME/…` and `model://NAME/…` mean
    /// ROOT/NAME/…, or ROOT/… if ROOT is named NAME.
    ///
    /// The model's own folder is always a root. So is the nearest enclosing folder with a
    /// `package.xml` or `model.config`. A package that no root holds may be an ancestor folder of
    /// that name. No other file outside the roots is opened.
    pub roots: Vec<PathBuf>,
    /// True to use only the given roots, for untrusted models: not the model's own folder, and not
    /// a package around it.
    pub confined: bool,
    /// Folder that is checked as a whole. Files below it may be opened. A package that no root or
    /// ancestor holds is searched below it: exactly one folder of that name must hold the file.
    pub checked: Option<Arc<CheckedFolder>>,
}

impl Default for ReadOptions<'_> {
    /// Returns options that read from disk, without additional roots.
    fn default() -> Self {
        Self { files: &Disk, roots: Vec::new(), confined: false, checked: None }
    }
}

/// Reads a URDF, SDF, MJCF, USD or OpenSim file. The root element or first word determines the
/// format.
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
/// [`FormatError`] if the file cannot be read, is not UTF-8, is not well-formed, has an unknown
/// format, or has a document type.
pub fn read_model(path: &Path, options: &ReadOptions<'_>) -> Result<RobotModel, FormatError> {
    let bytes = polhode_source::read_file(options.files, path, |bytes| Ok(bytes.to_vec()))?;
    if is_binary_usd(&bytes) {
        return read_usd(bytes, path, options);
    }
    match String::from_utf8(bytes) {
        Ok(text) => read(text, path, options),
        Err(error) => {
            let valid = error.utf8_error().valid_up_to();
            Err(FormatError::not_utf8(path, error.as_bytes(), valid))
        }
    }
}

/// Returns true for the bytes of a binary USD layer or of a package.
fn is_binary_usd(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PXR-USDC") || bytes.starts_with(b"PK")
}

#[cfg(feature = "usd")]
fn read_usd(bytes: Vec<u8>, path: &Path, options: &ReadOptions<'_>) -> Result<RobotModel, FormatError> {
    let mut model = usd::read(bytes, path, options)?;
    keep_finite(&mut model);
    Ok(model)
}

#[cfg(not(feature = "usd"))]
fn read_usd(bytes: Vec<u8>, path: &Path, _options: &ReadOptions<'_>) -> Result<RobotModel, FormatError> {
    let error = ContentErrorKind::unsupported("USD in this build").of_whole();
    let error = error.hint("check it with the command: polhode check FILE");
    Err(FormatError::of_content(path, &bytes, error))
}

/// Reads a model from a text. `path` is for messages; its folder resolves the files that the model
/// names.
///
/// # Errors
/// [`FormatError`], as for [`read_model`].
pub fn read_text(text: &str, path: &Path, options: &ReadOptions<'_>) -> Result<RobotModel, FormatError> {
    read(text.to_owned(), path, options)
}

/// Returns the format of a text by its root element or first word, even if the rest cannot be read.
/// Returns `None` for other texts.
pub fn format_of(text: &str) -> Option<ModelFormat> {
    if text.trim_start_matches('\u{feff}').trim_start().starts_with("#usda") {
        return Some(ModelFormat::Usd);
    }
    language(root_of(text)?)
}

/// Returns the name of the root element of a text, even if the rest cannot be read. Returns `None`
/// if there is none.
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
    if cfg!(feature = "languages") && format_of(&text) == Some(ModelFormat::Usd) {
        return read_usd(text.into_bytes(), path, options);
    }
    let beneath = options.files.beneath(path).filter(|_| cfg!(feature = "languages"));
    let Some(files) = beneath else { return read_as(text, path, options) };
    let expanded = xacro::expanded(path);
    let mut model = read_as(text, &expanded, options)?;
    path.clone_into(&mut model.path);
    xacro::add_sources(&mut model, files, &uri::Roots::of(path, options), expanded);
    Ok(model)
}

/// Reads a model from a text. `path` is for messages, and its folder for files that the model names.
fn read_as(text: String, path: &Path, options: &ReadOptions<'_>) -> Result<RobotModel, FormatError> {
    if format_of(&text).is_some_and(is_left_out) {
        let error = ContentErrorKind::unsupported("in this build, which reads URDF only").of_whole();
        return Err(FormatError::of_content(path, text.as_bytes(), error));
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
            _ if is_left_out(format) => {}
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

/// Returns true for a language that this build does not read.
fn is_left_out(format: ModelFormat) -> bool {
    !cfg!(feature = "languages") && format != ModelFormat::Urdf
}

/// Moves frames whose position is not finite to the origin, with a note.
fn keep_finite(model: &mut RobotModel) {
    let links = model.links.iter_mut().map(|link| (&link.name, &link.span, &mut link.pose));
    let joints = model.joints.iter_mut().map(|joint| (&joint.name, &joint.span, &mut joint.pose));
    for (name, span, pose) in links.chain(joints) {
        if !pose.position.iter().all(|c| c.is_finite()) {
            pose.position = [0.0; 3];
            let message = "its position is too large for a double; it is taken as the origin".to_owned();
            model.notes.push(Note::new("read.pose", &name.text, span.clone(), message));
        }
    }
}
