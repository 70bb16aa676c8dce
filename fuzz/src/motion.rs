//! Scenarios with their tables, sweep plans, and logs of motions.
//!
//! An accepted scenario is simulated for a few steps, and all numbers of its table must be finite.

use std::fs;
use std::path::{Path, PathBuf};

use polhode::infer::judge::{AttitudeSense, DeclaredReading, OmegaAxes, SignedAxes};
use polhode::motion::{ErrorEffort, Scenario, Trajectory};
use polhode_judge::suite::CASES;
use polhode_judge::{JudgeReport, JudgedRun};
use polhode_scenario::read as scenario;
use polhode_source::files::Disk;
use polhode_sweep::Plan;
use polhode_table::log as run_log;
use polhode_table::output::Table;

use super::physical::assert_physical;

/// Largest number of samples; more would take too long.
const MOST_SAMPLES: usize = 5;
/// Largest number of integration steps.
const MOST_STEPS: usize = 300;

pub fn scenario(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    let path = Path::new("/nowhere/scenario.toml");
    match scenario::parse(text, path) {
        Ok(read) => {
            assert_eq!(
                format!("{:?}", Ok::<_, ()>(&read)),
                format!("{:?}", scenario::parse(text, path).map_err(|_| ()))
            );
            accepted(read);
        }
        Err(error) => assert!(!error.to_string().is_empty() && error.hint() != Some(String::new())),
    }
}

pub fn motion_table(data: &[u8]) {
    named_table(data, |table| {
        format!(
            "[[body.part]]\nshape = \"box\"\nsize = [1.1, 2, 3]\nmass = 1.7\n[prescribed]\ntable = '{}'\n\
             [run]\nduration = 0.5\nsamples = 3\n",
            table.display()
        )
    });
}

/// Checks a table named by a scenario.
fn named_table(data: &[u8], text: impl Fn(&Path) -> String) {
    let table = table_file();
    let read =
        fs::write(&table, data).map(|()| scenario::parse(&text(&table), &table.with_extension("toml")));
    let _ = fs::remove_file(&table);
    match read {
        Ok(Ok(scenario)) => accepted(scenario),
        Ok(Err(error)) => assert!(!error.to_string().is_empty()),
        Err(_) => {}
    }
}

pub fn torque_table(data: &[u8]) {
    named_table(data, |table| {
        format!(
            "[[body.part]]\nshape = \"box\"\nsize = [1.1, 2, 3]\nmass = 1.7\n[start]\nspin = {{ body = [0.3, 0.5, 0.9] }}\n\
             [[torque]]\nmodel = \"table\"\ntable = '{}'\naxes = \"body\"\ninterpolation = \"spline\"\n\
             [run]\nduration = 0.5\nsamples = 3\n",
            table.display()
        )
    });
}

pub fn mass_table(data: &[u8]) {
    named_table(data, |table| {
        format!(
            "[[body.part]]\nshape = \"box\"\nsize = [1.1, 2, 3]\nmass = 1.7\n[start]\nspin = {{ body = [0.3, 0.5, 0.9] }}\n\
             [mass_history]\ntable = '{}'\n[run]\nduration = 0.5\nsamples = 3\n",
            table.display()
        )
    });
}

/// Checks a log of a motion in Parquet.
///
/// The library catches panics of the parquet crate on broken pages, but libFuzzer would report
/// them.
pub fn parquet(data: &[u8]) {
    let read = || run_log::from_bytes(data, None);
    if !data.starts_with(b"PAR1") {
        return;
    }
    match read() {
        Ok(log) => {
            assert_eq!(Ok(&log), read().as_ref());
            assert!(log.log.times().is_sorted_by(|a, b| a < b));
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Largest number of judged rows; more would take too long.
const MOST_ROWS: usize = 200;
/// Largest duration of a judged run, s.
const LONGEST: f64 = 1e3;

/// Checks a run of a suite case, as graded by the suite and as read by `polhode judge`: errors are
/// finite.
pub fn judge(data: &[u8]) {
    if data.starts_with(b"PAR1") {
        return;
    }
    let Ok(read) = run_log::from_bytes(data, None) else { return };
    let times = read.log.times();
    if times.len() > MOST_ROWS || times[times.len() - 1] - times[0] > LONGEST {
        return;
    }
    let strict = DeclaredReading {
        sense: Some(AttitudeSense::BodyToSpace),
        omega_axes: Some(OmegaAxes::Body),
        axes: Some(SignedAxes::SAME),
        time_origin: Some(times[0]),
        time_factor: Some(1.0),
        ..read.says
    };
    let case = CASES.iter().find(|case| case.name == "free-flips").unwrap().scenario().unwrap();
    for declared in [strict, read.says] {
        match JudgedRun::of(None, &case.scenario, &read.log, &declared, read.step) {
            Ok(run) => {
                assert!(run.worst().is_finite());
                assert!(run.judgement.errors.angles().iter().all(|angle| (0.0..=3.15).contains(angle)));
                let report = JudgeReport::new(&case.scenario, vec![run]);
                assert!(!report.to_document().to_text(100).contains("NaN"));
            }
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
}

pub fn run_log(data: &[u8]) {
    // The library catches panics of the parquet crate on broken pages, but libFuzzer would report
    // them.
    if data.starts_with(b"PAR1") {
        return;
    }
    let read = || run_log::from_bytes(data, None);
    let log = match read() {
        Ok(log) => log,
        Err(error) => return assert!(!error.to_string().is_empty() && error.hint != Some(String::new())),
    };
    assert_eq!(Ok(&log), read().as_ref());
    assert!(log.log.times().is_sorted_by(|a, b| a < b));
    let names = if log.log.omega().is_some() { "t,q0,q1,q2,q3,wx,wy,wz" } else { "t,q0,q1,q2,q3" };
    let mut text = format!("{names}\n");
    for (k, time) in log.log.times().iter().enumerate() {
        let omega = log.log.omega().map_or(&[][..], |omega| &omega[k]);
        let numbers = [&[*time], &log.log.attitude()[k][..], omega].concat();
        text += &(numbers.iter().map(|n| format!("{n:?}")).collect::<Vec<_>>().join(",") + "\n");
    }
    assert_eq!(run_log::from_bytes(text.as_bytes(), None).unwrap().log, log.log);
}

pub fn plan(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    let Ok(plan) = Plan::parse(&Disk, text.to_owned(), Path::new("/nowhere/plan.toml")) else { return };
    for member in [0, 1, plan.members() / 2, plan.members().saturating_sub(1)] {
        let values = plan.values(member);
        assert_eq!(values.len(), plan.variables().len());
        assert!(values.iter().all(|value| value.is_finite()), "{values:?}");
        assert_eq!(values, plan.values(member));
        if let Ok(scenario) = plan.scenario(&values) {
            assert_physical(scenario.body());
        }
    }
}

/// Checks the body of a scenario, and the start of its motion.
fn accepted(scenario: Scenario) {
    assert_physical(scenario.body());
    let Some(mut run) = scenario.run().cloned() else { return };
    assert!(run.times.iter().all(|time| time.is_finite()));
    run.times.truncate(MOST_SAMPLES);
    let scenario = scenario.sampled(run);
    // A scenario that needs too many steps is not checked further.
    let mut steps = 0;
    let mut few = |_| {
        steps += 1;
        steps <= MOST_STEPS
    };
    if let Some(Ok(motion)) = scenario.simulate_with_error(ErrorEffort::Cheap, &mut few) {
        finite(&motion, &scenario);
    }
}

/// Checks that all numbers of the table are finite.
fn finite(motion: &Trajectory, scenario: &Scenario) {
    let mut csv = Vec::new();
    Table::of(motion, &scenario.into()).write_csv(&mut csv).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    for cell in csv.lines().skip(1).flat_map(|line| line.split(',')) {
        assert!(cell.parse::<f64>().is_ok_and(f64::is_finite), "{cell} in\n{csv}");
    }
}

/// Returns the path of a file for this thread, in memory if possible.
fn table_file() -> PathBuf {
    let memory = Path::new("/dev/shm");
    let parent = if memory.is_dir() { memory.to_owned() } else { std::env::temp_dir() };
    parent.join(format!("polhode-fuzz-{}-{:?}.csv", std::process::id(), std::thread::current().id()))
}
