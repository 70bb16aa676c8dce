//! Plans in `examples/sweeps`: every plan is readable, its members are bodies, and one of them
//! moves.

use std::fs;
use std::path::{Path, PathBuf};

use polhode_source::files::Disk;
use polhode_sweep::Plan;

fn plans() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/sweeps");
    let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let plans: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    assert!(plans.len() >= 4, "{plans:?}");
    plans
}

#[test]
fn every_plan_is_read_and_its_members_move() {
    for path in plans() {
        let plan = Plan::read(&Disk, &path).unwrap_or_else(|error| panic!("{error}"));
        assert!(plan.findings().is_empty(), "{}: {:?}", path.display(), plan.findings());
        for member in (0..plan.members()).step_by((plan.members() / 80).max(1) as usize) {
            let scenario = plan.scenario(&plan.values(member)).unwrap_or_else(|error| panic!("{error}"));
            if member == 0 {
                scenario.simulate().unwrap().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            }
        }
    }
}

/// A file cut at any character is read, or refused with a valid place.
#[test]
fn a_plan_cut_anywhere_is_answered() {
    for path in plans() {
        let text = fs::read_to_string(&path).unwrap();
        for end in (0..text.len()).filter(|&end| text.is_char_boundary(end)) {
            if let Err(error) = Plan::parse(&Disk, text[..end].to_owned(), &path) {
                let place = error.place().unwrap();
                assert!(place.span.end <= end && place.line <= text[..end].matches('\n').count() + 1);
            }
        }
    }
}
