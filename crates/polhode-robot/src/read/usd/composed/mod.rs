//! USD with several layers, and binary USD, composed by the crate `openusd`.

mod crate_file;
mod flat;
mod layers;
mod notes;
mod places;
mod value;

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;
use std::thread;

use polhode_source::{ContentError, FormatError};

use super::layer::Layer;
use crate::model::{Note, Source};
use crate::read::ReadOptions;
use crate::read::uri::Roots;
use layers::{LayerFile, Layers};
use places::Places;

/// Stack of the thread that composes, bytes: `openusd` recurses into nested prims.
const STACK: usize = 1 << 27;

/// Stage composed of its layers.
pub(super) struct Composed {
    pub(super) layer: Layer,
    pub(super) notes: Vec<Note>,
    /// Root layer and other layers; the text of a binary layer is empty.
    pub(super) sources: Vec<Source>,
    /// True if the root layer is a text file, and not in a package.
    pub(super) is_text: bool,
}

/// Reads and composes a stage by its root layer or package.
///
/// The work is done in a thread of its own, with a large stack. A panic of `openusd` ends only that
/// thread, and is an error here.
pub(super) fn read(path: &Path, bytes: Vec<u8>, options: &ReadOptions<'_>) -> Result<Composed, FormatError> {
    let work = || {
        let roots = Roots::of(path, options);
        let layers = Arc::new(Layers::of(path, bytes, &roots)?);
        composed(path, &layers)
    };
    let panicked = || {
        failed(
            path,
            ContentError::unsupported(
                "a USD file that ends the crate openusd: it is damaged, or of an unusual version",
            ),
        )
    };
    thread::scope(|scope| {
        let thread = thread::Builder::new().name("usd".to_owned()).stack_size(STACK);
        let Ok(thread) = thread.spawn_scoped(scope, work) else {
            return Err(failed(path, ContentError::unsupported("USD without memory for a thread")));
        };
        thread.join().unwrap_or_else(|_| Err(panicked()))
    })
}

fn failed(path: &Path, error: ContentError) -> FormatError {
    FormatError::of_content(path, &[], error)
}

fn composed(path: &Path, layers: &Arc<Layers>) -> Result<Composed, FormatError> {
    let (mut sources, mut starts, mut next) = (Vec::new(), HashMap::new(), 0);
    for id in &layers.order {
        let Some(file) = layers.files.get(id) else { continue };
        let text = file.text().unwrap_or_default().to_owned();
        starts.insert(id.clone(), next);
        let start = next;
        next += text.len() + 1;
        sources.push(Source { path: file.path.clone(), text, start });
    }
    let places = Places::of(layers, starts)?;
    let (layer, notes) = flat::flattened(layers, &places).map_err(|error| failed(path, error))?;
    let is_text = layers.files.get(&layers.root).is_some_and(LayerFile::is_text_file);
    Ok(Composed { layer, notes, sources, is_text })
}
