//! Test suite of motions for other programs, and the grading of their runs.

use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use polhode_document::json::pretty;
use polhode_judge::suite;
use polhode_judge::suite::CASES;
use polhode_source::shown;
use polhode_table::output::{Surroundings, Table};

use crate::failure::Failure;
use crate::partial::{Partial, output};
use crate::stdout::print;

/// Folder of the exact motions, inside that of the suite.
const EXACT: &str = "exact";
/// Writes the suite into a new folder, completely or not at all.
pub(super) fn write(target: &Path) -> Result<(), Failure> {
    if fs::symlink_metadata(target).is_ok() {
        let message = format!("{} already exists", shown(target));
        return Err(Failure::usage(message, "choose a new folder"));
    }
    let folder = Partial::folder(target, |path| fs::remove_dir_all(path))?;
    let put = |name: PathBuf, write: &dyn Fn(&mut Vec<u8>) -> io::Result<()>| {
        let mut bytes = Vec::new();
        write(&mut bytes)
            .and_then(|()| fs::write(folder.path().join(&name), &bytes))
            .map_err(|error| output(&target.join(&name), error))
    };
    fs::create_dir(folder.path().join(EXACT)).map_err(|error| output(target, error))?;
    let json = pretty(&suite::to_json()?) + "\n";
    put("suite.json".into(), &|out| out.write_all(json.as_bytes()))?;
    for case in CASES {
        put(format!("{}.toml", case.name).into(), &|out| out.write_all(case.text.as_bytes()))?;
        let file = case.scenario()?;
        let failed = |error| Failure::motion(case.name.to_owned(), error);
        if let Some(motion) = file.scenario.simulate() {
            let motion = motion.map_err(failed)?;
            let surroundings = Surroundings::from(&file.scenario);
            put(Path::new(EXACT).join(format!("{}.csv", case.name)), &|out| {
                Table::of(&motion, &surroundings).write_csv(out)
            })?;
        }
    }
    folder.publish(|partial| fs::rename(partial.path(), target)).map_err(|error| output(target, error))?;
    print(&format!(
        "wrote {}: {} cases; run them, write NAME.csv for each next to suite.json, then: polhode judge --suite {}\n",
        shown(target),
        CASES.len(),
        shown(target)
    ))
}
