//! Requests of `check`: files in memory, fixes as data, and the schemas.

use std::path::{Path, PathBuf};

use polhode_document::Report as _;
use polhode_robot::finding::Severity;
use polhode_robot::policy::date::Date;
use polhode_robot::program::Program;
use polhode_robot::{Checked, Fix, Format, Inputs, Progress, REPORT_SCHEMA, REQUEST_SCHEMA, Request, run};
use polhode_source::files::{Disk, Memory};

use crate::common::schema::require_fits;

/// Model with a lost exponent of izz; exactly one number is consistent with the box.
const SLIP: &str = r#"<robot name="r"><link name="box"><inertial><mass value="2"/>
  <inertia ixx="0.0216667" ixy="0" ixz="0" iyy="0.0166667" iyz="0" izz="8.33333"/></inertial>
  <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link></robot>"#;

/// Model with an unphysical tensor: i1 + i2 < i3.
const IMPOSSIBLE: &str = r#"<robot name="r"><link name="arm"><inertial><mass value="1.7"/>
  <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/></inertial></link></robot>"#;

fn request(files: &[&str]) -> Request {
    Request { files: files.iter().map(PathBuf::from).collect(), ..Request::default() }
}

fn require_report(checked: &Checked) {
    require_fits(REPORT_SCHEMA, &checked.to_json());
}

#[test]
fn folders_in_memory_are_searched() {
    let files = Memory::from([
        ("robots/b.urdf", IMPOSSIBLE),
        ("robots/arm/a.urdf", "<robot name='a'><link name='world'/></robot>"),
        ("robots/.hidden/c.urdf", IMPOSSIBLE),
        ("robots/notes.xml", "<notes/>"),
        ("empty/readme.txt", ""),
    ]);
    let request = request(&["robots", "robots/../robots/b.urdf", "empty", "missing.urdf"]);
    let inputs = Inputs::find(&request, &files).unwrap();
    let models: Vec<_> = inputs.models().collect();
    assert_eq!(models, ["robots/b.urdf", "robots/arm/a.urdf", "missing.urdf"].map(Path::new));
    assert_eq!(inputs.repeated(), [["robots/../robots/b.urdf", "robots/b.urdf"].map(PathBuf::from)]);
    let mut passes = Passes::default();
    let checked = inputs.check(&mut passes);
    assert_eq!((passes.counts, passes.done), (vec![4, 0, 4], 8));
    let errors = checked.files.iter().filter_map(|file| Some(file.report.as_ref().err()?.message()));
    assert_eq!(
        errors.collect::<Vec<_>>(),
        ["empty contains no model", "cannot read \"missing.urdf\": the file does not exist"]
    );
    require_report(&checked);
}

/// Counts received from progress reports.
#[derive(Default)]
struct Passes {
    counts: Vec<usize>,
    done: usize,
}

impl Progress for Passes {
    fn begin(&mut self, count: usize) {
        self.counts.push(count);
    }

    fn done(&mut self, _: &Path) {
        self.done += 1;
    }
}

#[test]
fn fixes_are_data() {
    let files = Memory::from([("box.urdf", SLIP)]);
    let request = Request { fix: true, ..request(&["box.urdf"]) };
    let checked = run(&request, &files).unwrap();
    let new = SLIP.replace("8.33333", "0.00833333");
    let [fix] = *checked.fixes().collect::<Vec<_>>() else { panic!("{}", checked.to_diff()) };
    assert_eq!(fix, Fix { path: Path::new("box.urdf"), old: SLIP, new: &new });
    assert!(checked.to_diff().contains("+  <inertia"));
    require_report(&checked);
    assert!(checked.has_failed());
    let checked = checked.with_fix_in(Path::new("fixed.urdf"));
    assert!(!checked.has_failed());
    assert_eq!(checked.to_json()["fix"]["out"], "fixed.urdf");
    require_report(&checked);
}

#[test]
fn what_counts_is_in_the_request() {
    let allowed = "[[check.allow]]\nrule = \"inertia.triangle\"\nfile = \"a.urdf\"\nreason = \"a test\"\nexpires = 2027-01-31\n";
    let mut files = Memory::from([("a.urdf", IMPOSSIBLE), ("polhode.toml", allowed)]);
    let checked = run(&request(&["a.urdf"]), &files).unwrap();
    assert_eq!(checked.to_json()["allowed"][0]["reason"], "a test");
    assert!(!checked.has_failed());
    require_report(&checked);
    let expired = Request { today: Some(Date::new(2027, 2, 1)), ..request(&["a.urdf"]) };
    let checked = run(&expired, &files).unwrap();
    assert!(checked.has_failed() && checked.about_policy().contains("expired on 2027-01-31"));
    let (baseline, count) = checked.to_baseline();
    assert_eq!(count, 1);
    files.insert("known.json", baseline.into_bytes());
    let known = Request { baseline: Some("known.json".into()), ..expired };
    let checked = run(&known, &files).unwrap();
    assert_eq!(checked.to_json()["known"][0]["code"], "inertia.triangle");
    require_report(&checked);
}

#[test]
fn reports_of_all_examples_fit_the_schema() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for folder in ["examples"] {
        for fix in [false, true] {
            let files = vec![root.join(folder)];
            let request = Request { files, fix, programs: Program::ALL.to_vec(), ..Request::default() };
            let checked = run(&request, &Disk).unwrap();
            assert!(checked.files.len() > 2, "{folder}");
            require_report(&checked);
            assert!(checked.to_form(Format::Sarif).contains("partialFingerprints"));
        }
    }
}

#[test]
fn requests_fit_the_schema() {
    let full = Request {
        files: vec!["a.urdf".into()],
        roots: vec!["src".into()],
        programs: vec![Program::Isaac],
        nearest: true,
        fail_on: Some(Severity::Note),
        strict: true,
        config: Some("polhode.toml".into()),
        baseline: Some("known.json".into()),
        fix: true,
        today: Some(Date::new(2027, 1, 31)),
    };
    for request in [Request::default(), full] {
        let value = serde_json::to_value(&request).unwrap();
        require_fits(REQUEST_SCHEMA, &value);
        assert_eq!(serde_json::from_value::<Request>(value).unwrap(), request);
    }
}
