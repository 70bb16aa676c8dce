//! Fuzz targets for robot models.
//!
//! Every place is inside the text, a repaired model can be read, repairs end, and links are
//! physical bodies.

use std::path::Path;

use polhode_robot::finding::Finding;
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::{Inspection, inspect};
use polhode_robot::lump::{Lumping, lump};
use polhode_robot::model::{ModelFormat, RobotModel};
use polhode_robot::policy::Policy;
use polhode_robot::policy::baseline::Baseline;
use polhode_robot::policy::config::Config;
use polhode_robot::read::{ReadOptions, read_text};
use polhode_robot::repair::proved;
use polhode_robot::report::CheckReport;

use super::physical::{assert_physical, assert_written_is_read};

/// Largest number of successive repairs.
const MOST_REPAIRS: usize = 10;

pub fn urdf(data: &[u8]) {
    model(data, ModelFormat::Urdf);
}

pub fn sdf(data: &[u8]) {
    model(data, ModelFormat::Sdf);
}

pub fn mjcf(data: &[u8]) {
    model(data, ModelFormat::Mjcf);
}

pub fn usd(data: &[u8]) {
    model(data, ModelFormat::Usd);
}

pub fn osim(data: &[u8]) {
    model(data, ModelFormat::Osim);
}

/// Checks `polhode.toml`: reading is deterministic, and errors have a message.
pub fn config(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    let read = || Config::read(Path::new("polhode.toml"), text);
    match read() {
        Ok(config) => assert_eq!(format!("{config:?}"), format!("{:?}", read().unwrap())),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Checks baselines: reading is deterministic, and every finding has an id.
pub fn baseline(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    let read = || Baseline::read(Path::new("baseline.json"), text);
    match read() {
        Ok(baseline) => assert_eq!(baseline.findings, read().unwrap().findings),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

fn read(text: &str) -> Option<RobotModel> {
    read_text(text, Path::new("/nowhere/model.xml"), &ReadOptions::default()).ok()
}

/// Returns the content of a model as text, so that NaN equals NaN.
fn contents(model: &RobotModel) -> String {
    format!("{:?}", (&model.links, &model.joints, &model.notes))
}

fn model(data: &[u8], format: ModelFormat) {
    let Some(model) = str::from_utf8(data).ok().and_then(read) else { return };
    if model.format != format {
        return;
    }
    assert_eq!(Some(contents(&model)), read(&model.text).as_ref().map(contents), "read twice");
    let Inspection { geometry, findings } = inspect(&model, &Shapes::default());
    for finding in &findings {
        assert!(model.text.get(finding.span.clone()).is_some(), "{finding:?}");
    }
    let first = model.links.first().map_or("", |link| &link.name.text);
    for lumping in [Lumping::Fixed, Lumping::All, Lumping::Subtree(first)] {
        for lump in lump(&model, lumping, &[]).unwrap_or_default() {
            assert_physical(&lump.properties);
            assert_written_is_read(&lump.properties);
        }
    }
    repairs_end(&model);
    // The model may contain comments that allow some findings.
    let judged = Policy::default().judge(|path| path.to_string_lossy().into_owned(), &model, findings);
    let report = CheckReport::new(model, geometry, judged);
    assert!(!report.to_text().contains('\u{1b}') && !report.to_table().contains('\u{1b}'));
    assert!(report.to_json().is_object());
}

/// Checks that a repaired model can be read, and that successive repairs end.
///
/// A repair may make a number readable, and thus reveal another finding.
fn repairs_end(model: &RobotModel) {
    let found = |model: &RobotModel| inspect(model, &Shapes::default()).findings;
    let check = |text: &str| -> Result<Vec<Finding>, ()> { Ok(found(&read(text).ok_or(())?)) };
    let mut model = model.clone();
    for _ in 0..MOST_REPAIRS {
        let (repaired, _) = proved(&model, &found(&model), check).unwrap();
        if repaired.applied.is_empty() {
            return;
        }
        model = read(&repaired.text).unwrap();
    }
    panic!("still repaired after {MOST_REPAIRS} times:\n{}", model.text);
}
