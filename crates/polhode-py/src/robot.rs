//! Bodies in models of robots: a link, or all of them as one.

use std::path::{Path, PathBuf};

use polhode::math::{Body, Rotation};
use polhode_formats::read_file;
use polhode_report::plain::number;
use polhode_report::{InertiaReport, SourceInfo};
use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::lump::{Lump, Lumping, lump};
use polhode_robot::model::{JointKind, ModelFormat, RobotModel};
use polhode_robot::read::{ReadOptions, format_of, read_model};
use polhode_robot::remarks::remarks;
use pyo3::prelude::*;

use crate::error::{Raise, refused};
use crate::files::of_file;
use crate::mass_properties::PyMassProperties;

/// A link of a robot, or all its links at some values of its joints.
#[pyfunction]
pub(crate) fn robot_file(
    path: PathBuf,
    link: Option<&str>,
    joints: Vec<(String, f64)>,
) -> PyResult<PyMassProperties> {
    let model = read_model(&path, &ReadOptions::default()).map_err(Raise::raise)?;
    let findings = remarks(&model, link).map_err(|twice| refused(&twice, Some(twice.hint())))?;
    let report = match link {
        Some(name) => of_link(&path, &model, name)?,
        None => of_all(&path, &model, &joints)?,
    };
    Ok(PyMassProperties::of(InertiaReport { findings, ..report }))
}

fn of_link(path: &Path, model: &RobotModel, name: &str) -> PyResult<InertiaReport> {
    let Some(link) = model.links.iter().find(|link| link.name.text == name) else {
        let names: Vec<_> = model.links.iter().map(|link| link.name.text.as_str()).collect();
        let hint = format!("its links are {}", names.join(", "));
        return Err(refused(format!("{} has no link {name:?}", path.display()), Some(&hint)));
    };
    let body = match link_mass(model.format, link) {
        Ok(LinkMass::Body(body)) => body,
        Ok(LinkMass::None) => {
            let hint = "name another, or leave link out: then all links are one body";
            return Err(refused(format!("the link {name:?} has no mass"), Some(hint)));
        }
        Err(error) => {
            return Err(refused(format!("the link {name:?} is no body: {error}"), Some(error.hint())));
        }
    };
    // The link's axes are the body's.
    let properties = body.properties.in_frame::<Body>(Rotation::identity());
    let source = of_file(path, format_name(model))
        .described(format!("link {name} {}, in the link's frame", of_model(model)))
        .with("link", name)
        .with("frame", "link");
    Ok(InertiaReport::new(rounded(source, body.rounding), properties))
}

fn of_all(path: &Path, model: &RobotModel, joints: &[(String, f64)]) -> PyResult<InertiaReport> {
    let lumps = lump(model, Lumping::All, joints).map_err(|error| refused(&error, Some(&error.hint())))?;
    let Some(Lump { frame, links, massless, rounding, properties }) = lumps.into_iter().next() else {
        return Err(refused(format!("no link of {} has a mass", path.display()), None));
    };
    let links_words = if links.len() == 1 { "1 link".to_owned() } else { format!("{} links", links.len()) };
    let words = format!(
        "all {links_words} {}, {}, {}",
        of_model(model),
        joints_words(model, joints),
        frame
            .as_ref()
            .map_or_else(|| "in the model's frame".to_owned(), |link| format!("in the frame of {link}")),
    );
    let values: serde_json::Map<String, serde_json::Value> =
        joints.iter().map(|(name, value)| (name.clone(), (*value).into())).collect();
    let source = of_file(path, format_name(model))
        .described(words)
        .with("link", frame.clone())
        .with("frame", if frame.is_some() { "link" } else { "model" })
        .with("links", links)
        .with("massless", massless)
        .with("joints", values);
    Ok(InertiaReport::new(rounded(source, rounding), properties))
}

fn of_model(model: &RobotModel) -> String {
    model.name.as_ref().map_or_else(|| "of the model".to_owned(), |name| format!("of {name}"))
}

/// `elbow = 0.523599 rad and other joints at zero`
fn joints_words(model: &RobotModel, joints: &[(String, f64)]) -> String {
    let slides = |name: &str| {
        model.joints.iter().any(|joint| joint.name.text == name && joint.kind == JointKind::Prismatic)
    };
    let at = |(name, q): &(String, f64)| {
        format!("{name} = {} {}", number(*q, 6), if slides(name) { "m" } else { "rad" })
    };
    match joints {
        [] => "joints at zero".to_owned(),
        _ => format!("{} and other joints at zero", joints.iter().map(at).collect::<Vec<_>>().join(", ")),
    }
}

/// The source, and that digits were too few for a possible tensor.
fn rounded(source: SourceInfo, rounding: f64) -> SourceInfo {
    if rounding == 0.0 {
        return source;
    }
    let words = format!(
        "{}; tensor brought to the edge of the possible, {rounding:.1e} kg·m² away by its digits",
        source.description
    );
    source.described(words).with("rounding", rounding)
}

const fn format_name(model: &RobotModel) -> &'static str {
    match model.format {
        ModelFormat::Urdf => "urdf",
        ModelFormat::Sdf => "sdf",
        ModelFormat::Mjcf => "mjcf",
        ModelFormat::Usd => "usd",
        ModelFormat::Osim => "osim",
    }
}

/// The links of a robot, in the file's order.
#[pyfunction]
pub(crate) fn robot_links(path: PathBuf) -> PyResult<Vec<String>> {
    let model = read_model(&path, &ReadOptions::default()).map_err(Raise::raise)?;
    Ok(model.links.iter().map(|link| link.name.text.clone()).collect())
}

/// True if the file's root element or first word is that of a robot model.
#[pyfunction]
pub(crate) fn is_robot(path: PathBuf) -> PyResult<bool> {
    let is_robot = |bytes: &[u8]| {
        let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
        let is_text = start.first() == Some(&b'<') || start.starts_with(b"#usda");
        Ok(is_text && format_of(&String::from_utf8_lossy(bytes)).is_some())
    };
    read_file(&path, is_robot).map_err(Raise::raise)
}
