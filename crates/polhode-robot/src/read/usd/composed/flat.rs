//! Composed stage as one layer: the strongest opinion of each prim and property, with its position.
//!
//! Composition is that of the crate `openusd`: sublayers, inherits, variants, references, payloads
//! and specializes in this order of strength, and instances. Values keep the digits of a text layer;
//! those of a binary layer are the shortest that identify them.
//!
//! Source: openusd.org, "Glossary": LIVERPS strength ordering, payload, instanceable.

use std::collections::HashMap;
use std::sync::Arc;

use openusd::sdf::{self, Path as SpecPath, SpecType};
use openusd::usd::{Prim as StagePrim, PrimStatus, Stage};
use polhode_source::ContentError;

use super::layers::{Layers, OwnLayers, failed};
use super::notes;
use super::places::Places;
use super::value::{array_of, of_value};
use crate::model::{Name, Note};
use crate::read::usd::array::ARRAYS;
use crate::read::usd::layer::{Layer, Prim};
use crate::read::usd::value::Value;

/// Maximum number of prims of a stage.
const MOST_PRIMS: usize = 200_000;

/// Maximum nesting depth of prims of a stage.
const MOST_DEPTH: usize = 500;

/// Start of the names of properties that matter; others may be large.
const PREFIXES: [&str; 6] = ["physics:", "physx", "newton:", "mjc:", "xformOp", "material:binding"];
const NAMES: [&str; 7] = ["size", "radius", "height", "axis", "orientation", "subdivisionScheme", "purpose"];

/// Arrays of the stage by layer and path of the attribute; instances share them.
type Arrays = HashMap<(String, String), Arc<[f64]>>;

/// Metadata keys of the root layer that matter.
const METADATA: [&str; 3] = ["metersPerUnit", "kilogramsPerUnit", "defaultPrim"];

/// Composes the stage, and returns it as one layer with notes about content that is not read.
pub(super) fn flattened(layers: &Arc<Layers>, places: &Places) -> Result<(Layer, Vec<Note>), ContentError> {
    let resolver = OwnLayers(Arc::clone(layers));
    let stage = Stage::builder().resolver(resolver).open(&layers.root).map_err(failed)?;
    let mut layer = Layer::default();
    layer.twice = places.twice();
    for key in METADATA {
        let value = match places.layer_metadata(&layers.root, key) {
            Some(value) => Some(value),
            None => stage.stage_metadata(key).map_err(failed)?.map(|value| of_value(&value, 0..0)),
        };
        layer.metadata.extend(value.map(|value| (key.to_owned(), value)));
    }
    let mut notes = Vec::new();
    let mut undefined = Vec::new();
    let mut arrays = Arrays::new();
    let mut waiting = vec![(SpecPath::abs_root(), None, 0)];
    while let Some((path, mut parent, depth)) = waiting.pop() {
        if depth > 0 {
            let status = stage.prim_status(&path).map_err(failed)?;
            if !status.contains(PrimStatus::ACTIVE) || status.contains(PrimStatus::ABSTRACT) {
                continue;
            }
            if layer.prims.len() >= MOST_PRIMS || depth > MOST_DEPTH {
                let what =
                    format!("a stage with more than {MOST_PRIMS} prims, or nested deeper than {MOST_DEPTH}");
                return Err(ContentError::unsupported(what));
            }
            let own = layer.prims.len();
            if !status.contains(PrimStatus::DEFINED) {
                undefined.push(own);
            }
            let prim = stage.prim(&path);
            notes.extend(notes::of_variants(&stage, &prim, places)?);
            notes.extend(notes::of_clips(&prim, places)?);
            notes.extend(notes::of_targets(&stage, &prim, layers, places)?);
            layer.prims.push(of_prim(&stage, &prim, parent, places, &mut arrays)?);
            parent = Some(own);
        }
        let children = stage.prim(&path).child_names().map_err(failed)?;
        for name in children.iter().rev() {
            waiting.push((path.append_path(name.as_str()).map_err(failed)?, parent, depth + 1));
        }
    }
    let errors = notes::of_errors(&stage, layers, places)?;
    // An `over` alone defines no prim. A layer that is not read may define it.
    let may_be_defined = errors.iter().any(|note| note.code == "read.include");
    for k in undefined {
        if let Some(prim) = layer.prims.get_mut(k) {
            (prim.is_over, prim.is_abstract) = (may_be_defined, !may_be_defined);
        }
    }
    notes.extend(errors);
    let is_resolved =
        layer.prims.iter().any(|prim| prim.properties.contains_key("xformOp:scale:unitsResolve"));
    notes.extend(notes::of_units(&stage, layers, places, is_resolved));
    Ok((layer, notes))
}

fn of_prim(
    stage: &Stage,
    prim: &StagePrim,
    parent: Option<usize>,
    places: &Places,
    arrays: &mut Arrays,
) -> Result<Prim, ContentError> {
    let path = prim.path();
    let sites = prim.prim_stack().map_err(failed)?;
    let (layer, site) = sites.first().map_or(("", path.as_str()), |(layer, site)| (layer, site.as_str()));
    let [span, name] = places.of_prim(layer, site);
    let name = Name { text: path.name().unwrap_or_default().to_owned(), span: name };
    let words = api_schemas(stage, prim)?;
    let schemas = Value { span: places.metadata(layer, site, "apiSchemas"), words, ..Value::default() };
    let mut properties = HashMap::new();
    for own in prim.property_names().map_err(failed)? {
        let own = own.as_str();
        if NAMES.contains(&own)
            || ARRAYS.contains(&own)
            || PREFIXES.iter().any(|prefix| own.starts_with(prefix))
        {
            properties.extend(property(stage, prim, own, places, arrays)?);
        }
    }
    Ok(Prim {
        kind: prim.type_name().map_err(failed)?.map_or_else(String::new, |kind| kind.as_str().to_owned()),
        name,
        parent,
        path: path.as_str().to_owned(),
        span,
        openings: (None, 0),
        metadata: HashMap::from([("apiSchemas".to_owned(), schemas)]),
        properties,
        is_abstract: false,
        is_over: false,
    })
}

/// Returns the schemas that are applied to a prim.
///
/// The lists of its layers are combined from the weakest to the strongest. In each, `delete` comes
/// first, as in OpenUSD; `openusd` 0.6 deletes last.
fn api_schemas(stage: &Stage, prim: &StagePrim) -> Result<Vec<String>, ContentError> {
    let mut schemas: Vec<String> = Vec::new();
    for (id, site) in prim.prim_stack().map_err(failed)?.iter().rev() {
        let Some(layer) = stage.layer(id) else { continue };
        let Some(value) = layer.data().try_field(site, "apiSchemas").map_err(failed)? else { continue };
        let sdf::Value::TokenListOp(list) = &*value else { continue };
        if list.explicit {
            schemas.clear();
        }
        schemas.retain(|schema| !list.deleted_items.iter().any(|item| item.as_str() == schema));
        let added = [&list.explicit_items, &list.prepended_items, &list.appended_items, &list.added_items];
        for item in added.into_iter().flatten() {
            if !schemas.iter().any(|schema| schema == item.as_str()) {
                schemas.push(item.as_str().to_owned());
            }
        }
    }
    Ok(schemas)
}

/// Returns the value of a property, and marks for time samples, splines and connections, by name.
///
/// The strongest layer with a value counts. In it, time samples are stronger than the default.
fn property(
    stage: &Stage,
    prim: &StagePrim,
    name: &str,
    places: &Places,
    arrays: &mut Arrays,
) -> Result<Vec<(String, Value)>, ContentError> {
    let attribute = prim.attribute(name.to_owned());
    let mut found = Vec::new();
    for (id, site) in attribute.property_stack().map_err(failed)? {
        let Some(layer) = stage.layer(&id) else { continue };
        let data = layer.data();
        let owner = site.as_str().strip_suffix(name).and_then(|owner| owner.strip_suffix('.'));
        let owner = owner.unwrap_or_default();
        let written = places.property(&id, owner, name);
        let place =
            written.as_ref().map_or_else(|| places.of_prim(&id, owner)[0].clone(), |w| w.span.clone());
        if data.spec_type(&site) == Some(SpecType::Relationship) {
            let words: Vec<_> = prim.relationship(name.to_owned()).targets().map_err(failed)?;
            let words = words.iter().map(|target| target.as_str().to_owned()).collect();
            return Ok(vec![(name.to_owned(), Value { span: place, words, ..Value::default() })]);
        }
        for (field, suffix) in
            [("timeSamples", "timeSamples"), ("spline", "spline"), ("connectionPaths", "connect")]
        {
            if data.has_field(&site, field) {
                let key = format!("{name}.{suffix}");
                let value = places.property(&id, owner, &key);
                let value = value.unwrap_or(Value { span: place.clone(), ..Value::default() });
                found.push((key, value));
            }
        }
        let key = (id.clone(), site.as_str().to_owned());
        if let Some(array) = arrays.get(&key).cloned() {
            found.push((name.to_owned(), Value { span: place, array: Some(array), ..Value::default() }));
        } else if let Some(value) = data.try_field(&site, "default").map_err(failed)? {
            let value = match (&*value, written) {
                (sdf::Value::ValueBlock, _) => None,
                (_, Some(written)) => Some(written),
                (value, None) if ARRAYS.contains(&name) => {
                    let array = arrays.entry(key).or_insert_with(|| array_of(value)).clone();
                    Some(Value { span: place, array: Some(array), ..Value::default() })
                }
                (value, None) => Some(of_value(value, place)),
            };
            found.extend(value.map(|value| (name.to_owned(), value)));
        }
        if data.has_field(&site, "default")
            || data.has_field(&site, "timeSamples")
            || data.has_field(&site, "spline")
        {
            break;
        }
    }
    Ok(found)
}
