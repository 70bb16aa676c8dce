//! Layers of a stage: the files that are named by references, payloads and sublayers.
//!
//! All layers that may be needed are read before the stage is composed, so that each file is opened
//! through [`Roots`], and an error has its place in its file. Names that no file answers are an
//! error only where composition needs them.

use std::collections::HashMap;
use std::fmt::Display;
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use openusd::ar::{Asset, ResolvedPath, Resolver};
use openusd::sdf::{AbstractData, Path as SpecPath, Value};
use openusd::{usda, usdc};
use polhode_source::package::archive::Archive;
use polhode_source::{ContentError, ContentErrorKind, FormatError, FormatErrorKind, read_file};

use super::crate_file::{is_crate, require_sound};
use crate::read::uri::Roots;
use crate::read::usd::layer::Layer;

/// Maximum number of layers of a stage.
const MOST_LAYERS: usize = 1000;

/// Layer with its bytes.
#[derive(Debug)]
pub(super) struct LayerFile {
    /// Path for messages: `robot.usdz[robot.usdc]` in a package.
    pub(super) path: PathBuf,
    /// File on the file system.
    file: PathBuf,
    /// Name in the package.
    entry: Option<String>,
    pub(super) bytes: Arc<[u8]>,
}

/// Layers by identifier, with the targets of the names in them.
#[derive(Debug, Default)]
pub(super) struct Layers {
    /// Identifier of the root layer.
    pub(super) root: String,
    pub(super) files: HashMap<String, LayerFile>,
    /// Identifiers in the order in which they were named.
    pub(super) order: Vec<String>,
    /// Identifier of the layer that a name in a layer means, or the reason why there is none.
    pub(super) names: HashMap<(String, String), Result<String, String>>,
    /// Names of the sublayers of each layer.
    sublayers: HashMap<String, Vec<String>>,
    /// Packages by file.
    packages: HashMap<PathBuf, Arc<[u8]>>,
}

impl LayerFile {
    /// Returns true for a text layer that is not in a package.
    pub(super) fn is_text_file(&self) -> bool {
        self.entry.is_none() && self.text().is_some()
    }

    /// Returns the text; `None` for a binary layer.
    pub(super) fn text(&self) -> Option<&str> {
        if is_crate(&self.bytes) { None } else { std::str::from_utf8(&self.bytes).ok() }
    }

    pub(super) fn failed(&self, error: ContentError) -> FormatError {
        FormatError::of_content(&self.path, &self.bytes, error)
    }
}

impl Layers {
    /// Reads the root layer and all layers that it may need.
    pub(super) fn of(path: &Path, bytes: Vec<u8>, roots: &Roots<'_>) -> Result<Self, FormatError> {
        let mut layers = Self::default();
        let failed = |error| FormatError::of_content(path, &[], error);
        let file = roots.files.canonical(path).unwrap_or_else(|_| path.to_owned());
        let bytes: Arc<[u8]> = bytes.into();
        layers.root = match bytes.starts_with(b"PK") {
            true => {
                let first = first_layer(&bytes).map_err(failed)?;
                layers.packages.insert(file.clone(), bytes);
                layers.insert_entry(&file, path, &first).map_err(failed)?
            }
            false => layers.insert(LayerFile { path: path.to_owned(), file, entry: None, bytes }),
        };
        let mut next = 0;
        while let Some(id) = layers.order.get(next).cloned() {
            next += 1;
            let Some(layer) = layers.files.get(&id) else { continue };
            let (sublayers, named) = match layer.text() {
                Some(text) => names_in(&parsed(layer, text)?),
                None => binary(layer),
            }
            .map_err(|error| layer.failed(error))?;
            layers.sublayers.insert(id.clone(), sublayers);
            for name in named {
                let target = layers.target(&id, &name, roots)?;
                layers.names.insert(key(&id, &name), target);
            }
        }
        Ok(layers)
    }

    /// Returns a layer and its sublayers, those of sublayers included.
    pub(super) fn with_sublayers(&self, id: &str) -> Vec<String> {
        let mut all = vec![id.to_owned()];
        let mut next = 0;
        while let Some(of) = all.get(next).cloned() {
            next += 1;
            for name in self.sublayers.get(&of).into_iter().flatten() {
                if let Some(Ok(under)) = self.names.get(&key(&of, name))
                    && !all.contains(under)
                {
                    all.push(under.clone());
                }
            }
        }
        all
    }

    /// Adds a layer, and returns its identifier.
    fn insert(&mut self, layer: LayerFile) -> String {
        // `openusd` finds the format of this extension in the content.
        let id = match &layer.entry {
            Some(entry) => format!("{}/{entry}.usd", layer.file.display()),
            None => format!("{}.usd", layer.file.display()),
        };
        if !self.files.contains_key(&id) {
            self.order.push(id.clone());
            self.files.insert(id.clone(), layer);
        }
        id
    }

    /// Adds a layer of a package, and returns its identifier.
    fn insert_entry(&mut self, file: &Path, shown: &Path, entry: &str) -> Result<String, ContentError> {
        let Some(package) = self.packages.get(file) else { return Err(ContentError::missing("the package")) };
        let mut bytes = Vec::new();
        let mut archive = Archive::open(package)?;
        io::Read::read_to_end(&mut archive.stream(entry)?, &mut bytes)
            .map_err(|error| ContentError::unsupported(format!("the entry {entry:?}: {error}")))?;
        let path = PathBuf::from(format!("{}[{entry}]", shown.display()));
        let layer =
            LayerFile { path, file: file.to_owned(), entry: Some(entry.to_owned()), bytes: bytes.into() };
        Ok(self.insert(layer))
    }

    /// Returns the identifier of the layer that a name in another layer means, or the reason why
    /// there is none.
    fn target(
        &mut self,
        of: &str,
        name: &str,
        roots: &Roots<'_>,
    ) -> Result<Result<String, String>, FormatError> {
        let Some(layer) = self.files.get(of) else { return Ok(Err("its layer is not read".to_owned())) };
        if self.files.len() >= MOST_LAYERS {
            let error = ContentErrorKind::unsupported(format!("a stage with more than {MOST_LAYERS} layers"));
            return Err(layer.failed(error.of_whole()));
        }
        let (file, shown) = (layer.file.clone(), layer.path.clone());
        if let Some(entry) = &layer.entry {
            // Names in a package mean its own entries.
            let folder = entry.rsplit_once('/').map_or("", |(folder, _)| folder);
            let joined = crate::read::usd::path::absolute(name, &format!("/{folder}"));
            let inner = joined.trim_start_matches('/');
            let has = self
                .packages
                .get(&file)
                .is_some_and(|package| Archive::open(package).is_ok_and(|archive| archive.has(inner)));
            if !has {
                return Ok(Err(format!("the package has no {inner:?}")));
            }
            let failed = |error| FormatError::of_content(&shown, &[], error);
            let shown = PathBuf::from(shown.to_string_lossy().split('[').next().unwrap_or_default());
            return match is_layer(inner) {
                true => self.insert_entry(&file, &shown, inner).map(Ok).map_err(failed),
                false => Ok(Err("it is not a USD layer".to_owned())),
            };
        }
        let (outer, inner) = match name.split_once('[') {
            Some((outer, inner)) => (outer, Some(inner.trim_end_matches(']'))),
            None => (name, None),
        };
        let folder = file.parent().unwrap_or(Path::new(""));
        let found = match roots.resolve(outer, folder) {
            Ok(found) => found,
            Err(why) => return Ok(Err(why)),
        };
        if !is_layer(&found.to_string_lossy()) && found.extension().is_none_or(|ending| ending != "usdz") {
            return Ok(Err("it is not a USD layer".to_owned()));
        }
        let bytes = match self.packages.get(&found) {
            Some(bytes) => Arc::clone(bytes),
            None => match read_file(roots.files, &found, |bytes| Ok(Arc::from(bytes))) {
                Ok(bytes) => bytes,
                Err(error) => match error.kind() {
                    FormatErrorKind::Io { why, .. } => return Ok(Err(why.clone())),
                    _ => return Err(error),
                },
            },
        };
        if !bytes.starts_with(b"PK") {
            return Ok(Ok(self.insert(LayerFile { path: found.clone(), file: found, entry: None, bytes })));
        }
        let failed = |error| FormatError::of_content(&found, &[], error);
        let entry = match inner {
            Some(inner) => inner.to_owned(),
            None => first_layer(&bytes).map_err(failed)?,
        };
        self.packages.insert(found.clone(), bytes);
        self.insert_entry(&found, &found, &entry).map(Ok).map_err(failed)
    }
}

/// Returns the key of a name in a layer; `openusd` drops `.` from paths.
pub(super) fn key(layer: &str, name: &str) -> (String, String) {
    (layer.to_owned(), name.split('/').filter(|part| *part != ".").collect::<Vec<_>>().join("/"))
}

/// Returns the error for a stage that `openusd` refuses.
pub(super) fn failed(error: impl Display) -> ContentError {
    ContentError::unsupported(format!("a stage that the crate openusd does not compose: {error:#}"))
}

fn is_layer(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    [".usd", ".usda", ".usdc"].iter().any(|ending| name.ends_with(ending))
}

/// Returns the name of the first file of a package, which is its root layer.
fn first_layer(package: &[u8]) -> Result<String, ContentError> {
    let first = Archive::open(package)?.names().into_iter().next().unwrap_or_default();
    if is_layer(&first) {
        return Ok(first);
    }
    let rule = "a USD layer: .usd, .usda or .usdc";
    Err(ContentErrorKind::value("the first file of the package", first, rule).of_whole())
}

/// Parses a text layer.
fn parsed(layer: &LayerFile, text: &str) -> Result<openusd::sdf::Data, FormatError> {
    // This reader names the place of most errors, and limits the nesting.
    Layer::of(text).map_err(|error| layer.failed(error))?;
    let mut parser = usda::parser::Parser::new(text);
    match parser.parse() {
        Ok(specs) => Ok(openusd::sdf::Data::from_specs(specs)),
        Err(error) => {
            let what = format!("USD text that the crate openusd does not read: {error:#}");
            let place = parser.last_error_highlight().map(|place| {
                let lines = text.split_inclusive('\n').take(place.line.saturating_sub(1));
                lines.map(str::len).sum::<usize>() + place.column.saturating_sub(1)
            });
            let start = place.unwrap_or(0).min(text.len());
            Err(layer.failed(ContentErrorKind::unsupported(what).at(start..start)))
        }
    }
}

/// Checks a binary layer, and returns the names of other layers in it.
fn binary(layer: &LayerFile) -> Result<(Vec<String>, Vec<String>), ContentError> {
    if !is_crate(&layer.bytes) {
        let hint = "USD layers begin with #usda or PXR-USDC";
        return Err(ContentErrorKind::unsupported("a layer that is not UTF-8").of_whole().hint(hint));
    }
    require_sound(&layer.bytes)?;
    let data = usdc::CrateData::open(Cursor::new(Arc::clone(&layer.bytes)), true)
        .map_err(|error| ContentError::unsupported(format!("a binary USD layer: {error:#}")))?;
    names_in(&data)
}

/// Returns the asset paths of sublayers in a layer, and those of all arcs.
fn names_in(data: &dyn AbstractData) -> Result<(Vec<String>, Vec<String>), ContentError> {
    let (mut sublayers, mut names) = (Vec::new(), Vec::new());
    let field = |path: &SpecPath, name: &str| data.try_field(path, name).map_err(failed);
    if let Some(Value::StringVec(layers)) = field(&SpecPath::abs_root(), "subLayers")?.as_deref() {
        sublayers.clone_from(layers);
        names.clone_from(layers);
    }
    for path in data.spec_paths().iter().filter(|path| !path.is_property_path()) {
        if let Some(Value::ReferenceListOp(list)) = field(path, "references")?.as_deref() {
            names.extend(list.iter().map(|reference| reference.asset_path.clone()));
        }
        match field(path, "payload")?.as_deref() {
            Some(Value::PayloadListOp(list)) => {
                names.extend(list.iter().map(|payload| payload.asset_path.clone()));
            }
            Some(Value::Payload(payload)) => names.push(payload.asset_path.clone()),
            _ => {}
        }
    }
    require_single_inheritance(data)?;
    names.retain(|name| !name.is_empty());
    names.sort();
    names.dedup();
    Ok((sublayers, names))
}

/// Refuses a prim that inherits what it inherits already, because a prim around it inherits a prim
/// around that one. `openusd` 0.6 then recurses without end, and no stack is enough.
fn require_single_inheritance(data: &dyn AbstractData) -> Result<(), ContentError> {
    let mut arcs: HashMap<String, Vec<String>> = HashMap::new();
    for path in data.spec_paths().iter().filter(|path| !path.is_property_path()) {
        for key in ["inheritPaths", "specializes"] {
            if let Some(Value::PathListOp(list)) = data.try_field(path, key).map_err(failed)?.as_deref() {
                let targets = list.iter().map(|target| target.as_str().to_owned());
                arcs.entry(path.as_str().to_owned()).or_default().extend(targets);
            }
        }
    }
    for (path, targets) in &arcs {
        for (at, _) in path.match_indices('/') {
            let (around, rest) = path.split_at(at);
            for of in arcs.get(around).into_iter().flatten() {
                if targets.iter().any(|target| target.strip_prefix(of.as_str()) == Some(rest)) {
                    let what = format!("<{path}>, which inherits <{of}{rest}> itself and by <{around}>,");
                    let hint = format!("remove its own arc: <{around}> brings the same content");
                    return Err(ContentErrorKind::unsupported(what).of_whole().hint(hint));
                }
            }
        }
    }
    Ok(())
}

/// Resolver of `openusd` for these layers. It opens no file.
#[derive(Debug)]
pub(super) struct OwnLayers(pub(super) Arc<Layers>);

impl Resolver for OwnLayers {
    fn create_identifier(&self, asset_path: &str, anchor: Option<&ResolvedPath>) -> String {
        let Some(anchor) = anchor else { return asset_path.to_owned() };
        match self.0.names.get(&key(&anchor.to_string_lossy(), asset_path)) {
            Some(Ok(id)) => id.clone(),
            // No identifier ends like this, so it is not found.
            _ => format!("{asset_path}\u{0}"),
        }
    }

    fn resolve(&self, asset_path: &str) -> Option<ResolvedPath> {
        self.0.files.contains_key(asset_path).then(|| ResolvedPath::new(asset_path))
    }

    fn resolve_for_new_asset(&self, _asset_path: &str) -> Option<ResolvedPath> {
        None
    }

    fn open_asset(&self, resolved_path: &ResolvedPath) -> io::Result<Box<dyn Asset>> {
        let layer = self.0.files.get(&*resolved_path.to_string_lossy());
        let layer = layer.ok_or(io::ErrorKind::NotFound)?;
        Ok(Box::new(Cursor::new(layer.bytes.to_vec())))
    }

    fn get_modification_timestamp(
        &self,
        _asset_path: &str,
        _resolved_path: &ResolvedPath,
    ) -> Option<std::time::SystemTime> {
        None
    }
}
