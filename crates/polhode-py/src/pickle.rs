//! Serialization of mass properties for copies and other processes. Numbers keep all bits, and all
//! information on the body is kept.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use polhode::body::{Finding, InertiaTensor, MassProperties, Severity};
use polhode::math::Position;
use polhode_document::Extra;
use polhode_document::SourceInfo;
use polhode_shape::report::InertiaReport;
use pyo3::prelude::*;
use serde_json::Value;

use crate::error::{Raise, refused};
use crate::finding::{Remark, remarks};

/// Mass, centre of mass, and the elements of the tensor: diagonal, then xy, xz, yz.
type Numbers = (f64, [f64; 3], [[f64; 3]; 2]);

/// Source: path, format, description, and further fields as JSON.
type Source = (String, String, String, String);

/// Volume, surface area and density, and the other reference point of the tensor.
type Geometry = (Option<f64>, Option<f64>, Option<f64>, Option<[f64; 3]>);

/// Block of a report: key, JSON, text.
type Block = (String, String, String);

/// Report as values that Python can pickle.
pub(crate) type Values = (Numbers, Source, Geometry, Vec<Block>, Vec<Remark>);

/// Returns the values of a report.
pub(crate) fn values(report: &InertiaReport) -> Values {
    // All fields are listed, so that a new field causes a compiler error; `axes` is for the
    // command only.
    let InertiaReport { source, properties, volume, surface_area, density, about, extras, findings, axes: _ } =
        report;
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = properties.inertia().matrix();
    let SourceInfo { path, format, description, fields } = source.clone();
    let block = |Extra { key, json, text }: &Extra| ((*key).to_owned(), json.to_string(), text.clone());
    (
        (properties.mass(), properties.center_of_mass().to_array(), [[xx, yy, zz], [xy, xz, yz]]),
        (path, format, description, Value::Object(fields).to_string()),
        (*volume, *surface_area, *density, about.map(polhode::math::Vector::to_array)),
        extras.iter().map(block).collect(),
        remarks(findings),
    )
}

/// Restores a report from [`values`].
///
/// # Errors
/// `PolhodeError` for values that are not from a report.
pub(crate) fn report((numbers, source, geometry, extras, findings): Values) -> PyResult<InertiaReport> {
    let (mass, center, [moments, products]) = numbers;
    let inertia = InertiaTensor::with_negative_products(moments, products);
    let properties = inertia.and_then(|it| MassProperties::new(mass, Position::from_array(center), it));
    let (path, format, description, fields) = source;
    let (volume, surface_area, density, about) = geometry;
    let block = |(key, json, text): Block| Ok(Extra { key: name(key), json: read(&json)?, text });
    let remark = |(code, severity, message, place): Remark| {
        let all = [Severity::Error, Severity::Warning, Severity::Info];
        let severity = all.into_iter().find(|known| known.name() == severity);
        let severity = severity.ok_or_else(|| refused("a finding has an unknown severity", None))?;
        Ok(Finding { code: name(code), severity, message, place })
    };
    let fields = read(&fields)?.as_object().cloned().unwrap_or_default();
    let source = SourceInfo { path, format, description, fields };
    Ok(InertiaReport {
        volume,
        surface_area,
        density,
        about: about.map(Position::from_array),
        extras: extras.into_iter().map(block).collect::<PyResult<_>>()?,
        findings: findings.into_iter().map(remark).collect::<PyResult<_>>()?,
        ..InertiaReport::new(source, properties.map_err(Raise::raise)?)
    })
}

fn read(json: &str) -> PyResult<Value> {
    serde_json::from_str(json).map_err(|error| refused(error, None))
}

/// Returns a static copy of a finding code or block key. There are few of them; each is leaked
/// once.
fn name(text: String) -> &'static str {
    static NAMES: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    let mut names = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
    match names.get(text.as_str()) {
        Some(known) => known,
        None => {
            let kept: &'static str = text.leak();
            names.insert(kept);
            kept
        }
    }
}
