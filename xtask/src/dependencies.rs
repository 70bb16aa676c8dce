//! Limits on the number of linked crates, and on their licences.

use std::collections::{BTreeMap, BTreeSet};

use crate::Outcome;
use crate::licence::is_satisfied;
use crate::process::{cargo, output};

/// Largest number of external crates of each package on this platform, with these features.
const MOST: [(&str, &[&str], usize); 3] = [
    ("polhode", &[], 10),
    ("polhode-cli", &["--no-default-features"], 82), // shapes and scenarios
    ("polhode-cli", &[], 123), // with nalgebra for `polhode identify`, and openusd with 22 for USD
];

/// Checks the number of crates, and their licences on every platform, including tests and build
/// scripts.
pub(crate) fn check() -> Outcome {
    let ours: BTreeSet<String> = tree(&["--workspace", "--depth", "0"])?.into_keys().collect();
    for (package, features, most) in MOST {
        let mut linked = tree(&[&["--package", package, "--edges", "normal,build"], features].concat())?;
        linked.retain(|name, _| !ours.contains(name));
        println!("   {package}: {} external crates (at most {most})", linked.len());
        if linked.len() > most {
            return Err(format!("{package} brings {} external crates, more than {most}", linked.len()));
        }
    }
    let all = tree(&["--workspace", "--target", "all"])?;
    let refused: Vec<_> = all.iter().filter(|(_, licence)| !is_satisfied(licence)).collect();
    println!("   licences of {} crates on all platforms", all.len());
    if refused.is_empty() {
        return Ok(());
    }
    let lines = refused.iter().map(|(name, licence)| format!("\n  {name}: `{licence}`"));
    Err(format!("{} crates with a licence that is not accepted:{}", refused.len(), lines.collect::<String>()))
}

/// Returns the packages that `cargo tree` lists, each with its licence expression.
pub(crate) fn tree(arguments: &[&str]) -> Result<BTreeMap<String, String>, String> {
    let mut command = cargo(&["tree", "--quiet", "--locked", "--prefix", "none", "--format", "{p}|{l}"]);
    let listed = output(command.args(arguments))?;
    let packages =
        listed.lines().map(|line| line.trim_end_matches(" (*)")).filter_map(|line| line.rsplit_once('|'));
    Ok(packages.map(|(name, licence)| (name.to_owned(), licence.to_owned())).collect())
}
