//! Positions of prims, properties and metadata in the text layers of a stage.

use std::collections::HashMap;

use polhode_source::FormatError;

use super::layers::Layers;
use crate::model::{Number, Span};
use crate::read::usd::layer::{Layer, Prim};
use crate::read::usd::value::Value;

/// Text layers with their positions.
pub(super) struct Places {
    layers: HashMap<String, Layer>,
    /// Start of each layer in the model's count of bytes.
    starts: HashMap<String, usize>,
    /// Index of each prim in its layer, by the layer's identifier and the prim's path.
    prims: HashMap<(String, String), usize>,
}

impl Places {
    /// Scans all text layers. `starts` has the position of each layer.
    pub(super) fn of(layers: &Layers, starts: HashMap<String, usize>) -> Result<Self, FormatError> {
        let mut places = Self { layers: HashMap::new(), starts, prims: HashMap::new() };
        for (id, file) in &layers.files {
            let Some(text) = file.text() else { continue };
            let layer = Layer::of(text).map_err(|error| file.failed(error))?;
            let prims = layer.prims.iter().enumerate();
            places.prims.extend(prims.map(|(k, prim)| ((id.clone(), prim.path.clone()), k)));
            places.layers.insert(id.clone(), layer);
        }
        Ok(places)
    }

    /// Returns the start of a layer.
    pub(super) fn start(&self, layer: &str) -> usize {
        self.starts.get(layer).copied().unwrap_or(0)
    }

    fn prim(&self, layer: &str, path: &str) -> Option<&Prim> {
        let &k = self.prims.get(&(layer.to_owned(), path.to_owned()))?;
        self.layers.get(layer)?.prims.get(k)
    }

    /// Returns the positions of a prim and of its name; the start of a binary layer.
    pub(super) fn of_prim(&self, layer: &str, path: &str) -> [Span; 2] {
        let start = self.start(layer);
        match self.prim(layer, path) {
            Some(prim) => [moved(&prim.span, start), moved(&prim.name.span, start)],
            None => [start..start, start..start],
        }
    }

    /// Returns a property as a text layer states it.
    pub(super) fn property(&self, layer: &str, path: &str, name: &str) -> Option<Value> {
        let value = self.prim(layer, path)?.properties.get(name)?;
        Some(moved_value(value, self.start(layer)))
    }

    /// Returns a metadata key of a layer as its text states it.
    pub(super) fn layer_metadata(&self, layer: &str, key: &str) -> Option<Value> {
        let value = self.layers.get(layer)?.metadata.get(key)?;
        Some(moved_value(value, self.start(layer)))
    }

    /// Returns the position of a metadata key of a prim, or of the prim.
    pub(super) fn metadata(&self, layer: &str, path: &str, key: &str) -> Span {
        let own = self.prim(layer, path).and_then(|prim| prim.metadata.get(key));
        own.map_or_else(|| self.of_prim(layer, path)[0].clone(), |own| moved(&own.span, self.start(layer)))
    }

    /// Returns the repeated statements of all text layers.
    pub(super) fn twice(&self) -> Vec<(String, String, Span)> {
        let of = |(id, layer): (&String, &Layer)| {
            let start = self.start(id);
            let moved = move |(prim, name, span): &(String, String, Span)| {
                (prim.clone(), name.clone(), moved(span, start))
            };
            layer.twice.iter().map(moved).collect::<Vec<_>>()
        };
        let mut twice: Vec<_> = self.layers.iter().flat_map(of).collect();
        twice.sort_by_key(|(_, _, span)| span.start);
        twice
    }
}

fn moved(span: &Span, start: usize) -> Span {
    span.start + start..span.end + start
}

fn moved_value(value: &Value, start: usize) -> Value {
    let number = |number: &Number| Number { span: moved(&number.span, start), ..number.clone() };
    Value {
        span: moved(&value.span, start),
        numbers: value.numbers.iter().map(number).collect(),
        words: value.words.clone(),
        array: value.array.clone(),
    }
}
