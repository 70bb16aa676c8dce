//! Checks of robot models.

use std::sync::atomic::AtomicBool;
use std::time::{SystemTime, UNIX_EPOCH};

use polhode_document::Report as _;
use polhode_robot::policy::date::Date;
use polhode_robot::{Inputs, REPORT_SCHEMA, REQUEST_SCHEMA, Request};
use polhode_source::files::Files;
use polhode_source::{Failure, shown};

use crate::arguments::Arguments;
use crate::definition::Definition;
use crate::outcome::Outcome;

pub(super) const DEFINITION: Definition = Definition {
    name: "check",
    title: "Check of robot models",
    description: "\
Are the masses and inertias of this robot or simulation model possible and plausible? \
For URDF, SDF, MJCF, USD and OpenSim files, and folders of them. Each finding states its place, the rule, the values (kg, m, kg m²) \
and the fix, if exactly one fix is consistent with the link's own geometry. exit_status 1 means at least one finding. \
With fix, the text begins with the diff of the fixes; no file is changed. \
Example: {\"files\": [\"robot.urdf\"], \"fix\": true}",
    request: REQUEST_SCHEMA,
    report: || REPORT_SCHEMA,
    more: "",
    without: &["today"],
    required: &["files"],
};

pub(super) fn run(arguments: Arguments, files: &dyn Files, _: &AtomicBool) -> Result<Outcome, Failure> {
    let mut request: Request = arguments.read()?;
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    request.today = Some(Date::of_days(seconds / 86_400));
    let inputs = Inputs::find(&request, files)?;
    let repeated = inputs.repeated().iter().map(|[again, first]| {
        format!("{} is the same file as {}; it is checked once\n", shown(again), shown(first))
    });
    let mut text: String = repeated.collect();
    let checked = inputs.check(&mut ());
    let diff = checked.to_diff();
    if !diff.is_empty() {
        text = format!("{text}{diff}\n");
    }
    text += &checked.to_text(None);
    let failures: Vec<Failure> =
        checked.files.iter().filter_map(|file| file.report.as_ref().err().cloned()).collect();
    Ok(Outcome::of(&checked, text, &failures))
}
