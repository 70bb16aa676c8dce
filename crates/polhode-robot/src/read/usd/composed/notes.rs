//! Content of a stage that is not read, and statements that USD ignores.

use openusd::pcp::Error;
use openusd::sdf::{Path as SpecPath, Value as Field};
use openusd::tf::Token;
use openusd::usd::{Prim, Stage};
use polhode_source::{ContentError, ContentErrorKind};

use super::layers::{Layers, failed, key};
use super::places::Places;
use super::value::of_value;
use crate::finding::Severity;
use crate::model::{Note, Span};

/// Reports the errors of composition.
///
/// # Errors
/// [`ContentError`] for a circle of references or layers.
pub(super) fn of_errors(stage: &Stage, layers: &Layers, places: &Places) -> Result<Vec<Note>, ContentError> {
    let mut notes: Vec<Note> = Vec::new();
    for error in stage.composition_errors() {
        let note = match &error {
            Error::ArcCycle(_) | Error::SublayerCycle { .. } => {
                let message = plain(layers, &error.to_string());
                let error = ContentErrorKind::unsupported(format!("a circle of layers or prims: {message}"));
                return Err(error.of_whole().hint("remove one of the arcs of the circle"));
            }
            Error::UnresolvedLayer { asset_path, introduced_by, site_path, .. } => {
                let site = site_path.as_str();
                let keys = ["references", "payload"];
                let spans = keys.map(|key| places.metadata(introduced_by, site, key));
                let prim = places.of_prim(introduced_by, site)[0].clone();
                let span = spans.into_iter().find(|span| *span != prim).unwrap_or(prim);
                missing(layers, introduced_by, asset_path, site, span)
            }
            Error::UnresolvedSublayer { asset_path, introduced_by } => {
                let own = places.layer_metadata(introduced_by, "subLayers").map(|value| value.span);
                let start = places.start(introduced_by);
                missing(layers, introduced_by, asset_path, "", own.unwrap_or(start..start))
            }
            other => {
                let message = format!("USD ignores it: {}", plain(layers, &other.to_string()));
                let note = Note::new("read.include", "", 0..0, message);
                Note { severity: Severity::Suspect, ..note }
            }
        };
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    Ok(notes)
}

/// Returns a message with the paths of layers in place of their identifiers.
fn plain(layers: &Layers, message: &str) -> String {
    let mut message = message.replace('\0', "");
    for (id, file) in &layers.files {
        message = message.replace(id, &file.path.to_string_lossy());
    }
    message
}

fn missing(layers: &Layers, layer: &str, name: &str, prim: &str, span: Span) -> Note {
    let name = name.trim_end_matches('\0');
    let why = match layers.names.get(&key(layer, name)) {
        Some(Err(why)) => format!(": {why}"),
        _ => String::new(),
    };
    Note::new("read.include", prim, span, format!("@{name}@ is not read, so its content is unknown{why}"))
}

/// Reports variant sets of a prim without a selection, and selections of variants that do not exist.
pub(super) fn of_variants(stage: &Stage, prim: &Prim, places: &Places) -> Result<Vec<Note>, ContentError> {
    let mut notes = Vec::new();
    let sites = prim.prim_stack().map_err(failed)?;
    let is_read = |set: &str| sites.iter().any(|(_, site)| site.as_str().contains(&format!("{{{set}=")));
    for (id, site) in sites.iter().filter(|(_, site)| !site.as_str().ends_with('}')) {
        let Some(layer) = stage.layer(id) else { continue };
        let Some(sets) = layer.data().try_field(site, "variantSetChildren").map_err(failed)? else {
            continue;
        };
        let Field::TokenVec(sets) = &*sets else { continue };
        for set in sets.iter().map(Token::as_str).filter(|set| !is_read(set)) {
            let selected = sites.iter().find_map(|(id, site)| {
                let layer = stage.layer(id)?;
                match &*layer.data().try_field(site, "variantSelection").ok()?? {
                    Field::VariantSelectionMap(map) => map.get(set).cloned(),
                    _ => None,
                }
            });
            let span = places.of_prim(id, site.as_str())[0].clone();
            let path = prim.path().as_str();
            notes.push(match selected.filter(|selected| !selected.is_empty()) {
                Some(selected) => {
                    let message = format!(
                        "the variant set {set:?} has no variant {selected:?}: USD reads none of its variants"
                    );
                    Note { severity: Severity::Suspect, ..Note::new("read.left_out", path, span, message) }
                }
                None => {
                    let message = format!("no variant of {set:?} is selected, so none is read");
                    Note::new("read.left_out", path, span, message)
                }
            });
        }
    }
    Ok(notes)
}

/// Reports value clips, which give attributes other values over time.
pub(super) fn of_clips(prim: &Prim, places: &Places) -> Result<Option<Note>, ContentError> {
    if !prim.has_clips().map_err(failed)? {
        return Ok(None);
    }
    let sites = prim.prim_stack().map_err(failed)?;
    let span = sites.first().map_or(0..0, |(id, site)| places.metadata(id, site.as_str(), "clips"));
    let message = "value clips are not read; values are those without them".to_owned();
    Ok(Some(Note::new("read.animated", prim.path().as_str(), span, message)))
}

/// Reports references and payloads of prims that their layer does not have. `openusd` ignores most of
/// them without an error.
pub(super) fn of_targets(
    stage: &Stage,
    prim: &Prim,
    layers: &Layers,
    places: &Places,
) -> Result<Vec<Note>, ContentError> {
    let mut notes = Vec::new();
    for (id, site) in prim.prim_stack().map_err(failed)? {
        let mut arcs = Vec::new();
        let Some(layer) = stage.layer(&id) else { continue };
        for key in ["references", "payload"] {
            match layer.data().try_field(&site, key).map_err(failed)?.as_deref() {
                Some(Field::ReferenceListOp(list)) => {
                    arcs.extend(list.iter().map(|arc| (key, arc.asset_path.clone(), arc.prim_path.clone())));
                }
                Some(Field::PayloadListOp(list)) => {
                    arcs.extend(list.iter().map(|arc| (key, arc.asset_path.clone(), arc.prim_path.clone())));
                }
                Some(Field::Payload(arc)) => arcs.push((key, arc.asset_path.clone(), arc.prim_path.clone())),
                _ => {}
            }
        }
        for (arc, asset, target) in arcs.into_iter().filter(|(_, _, target)| target.is_root_prim()) {
            let of = match asset.as_str() {
                "" => layers.order.clone(),
                _ => match layers.names.get(&key(&id, &asset)) {
                    Some(Ok(target)) => layers.with_sublayers(target),
                    _ => continue, // reported as missing
                },
            };
            let has = |of: &String| stage.layer(of).is_some_and(|layer| layer.data().has_spec(&target));
            if !of.iter().any(has) {
                let message =
                    format!("{arc} = @{asset}@<{target}>: its layer has no such prim, so USD ignores it");
                let span = places.metadata(&id, site.as_str(), arc);
                let note = Note::new("read.include", prim.path().as_str(), span, message);
                notes.push(Note { severity: Severity::Suspect, ..note });
            }
        }
    }
    Ok(notes)
}

/// Reports layers whose units differ from those of the root layer. USD does not convert them; a scale
/// `unitsResolve` converts lengths.
pub(super) fn of_units(stage: &Stage, layers: &Layers, places: &Places, is_resolved: bool) -> Vec<Note> {
    let stated = |id: &str, key: &str| {
        let layer = stage.layer(id)?;
        let value = layer.data().try_field(&SpecPath::abs_root(), key).ok()??;
        of_value(&value, 0..0).numbers.first()?.value
    };
    let mut notes = Vec::new();
    for id in layers.order.iter().filter(|id| **id != layers.root) {
        for (key, default) in [("metersPerUnit", 0.01), ("kilogramsPerUnit", 1.0)] {
            let root = stated(&layers.root, key).unwrap_or(default);
            let Some(own) = stated(id, key) else { continue };
            if (own / root - 1.0).abs() > 1e-9 {
                let start = places.start(id);
                let span = places.layer_metadata(id, key).map_or(start..start, |value| value.span);
                let message = format!(
                    "{key} is {own} here and {root} in the root layer, whose unit counts: USD does not convert numbers"
                );
                let note = Note::new("read.unit", "", span, message);
                let is_scaled = is_resolved && key == "metersPerUnit";
                notes.push(if is_scaled { note } else { Note { severity: Severity::Suspect, ..note } });
            }
        }
    }
    notes
}
