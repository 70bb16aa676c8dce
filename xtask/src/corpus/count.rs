//! What is counted of the results of a repository's models.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde_json::Value;
use sha2::{Digest as _, Sha256};

/// The contents of all models so far: a copy does not count.
pub(super) type Seen = BTreeSet<[u8; 32]>;

/// How bad a finding is, the worst first.
pub(super) const SEVERITIES: [&str; 3] = ["impossible", "suspect", "note"];

/// The counts of a repository, or of several.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    /// Files of each language that were read.
    pub(super) read: BTreeMap<String, usize>,
    /// Files that were refused, by the reason.
    pub(super) refused: BTreeMap<String, usize>,
    /// Files that are not counted: the same bytes as one before, or in a folder of tests.
    pub(super) copies: usize,
    pub(super) tests: usize,
    pub(super) links: usize,
    /// Links that say something of their mass, and files with such.
    pub(super) inertials: usize,
    pub(super) weighed: usize,
    /// Files with a finding of each severity; and with an impossible mass or tensor.
    pub(super) files: [usize; 3],
    pub(super) impossible_bodies: usize,
    pub(super) rules: BTreeMap<String, RuleCounts>,
}

/// How often a rule is broken.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct RuleCounts {
    /// Findings of each severity.
    pub(super) findings: [usize; 3],
    pub(super) files: usize,
    pub(super) repositories: usize,
}

impl Counts {
    /// Adds what was said of one file.
    pub(super) fn add(&mut self, tree: &Path, result: &Value, seen: &mut Seen) -> Result<(), String> {
        let file = result["file"].as_str().ok_or("a result without its file")?;
        if tree.join(file).is_dir() {
            return Ok(()); // a folder without models
        }
        if is_test(file) {
            self.tests += 1;
            return Ok(());
        }
        let Ok(bytes) = std::fs::read(tree.join(file)) else {
            *self.refused.entry("files that cannot be opened".to_owned()).or_default() += 1;
            return Ok(());
        };
        if !seen.insert(Sha256::digest(&bytes).into()) {
            self.copies += 1;
            return Ok(());
        }
        if let Some(message) = result["error"]["message"].as_str() {
            *self.refused.entry(reason(message).to_owned()).or_default() += 1;
            return Ok(());
        }
        let number = |key: &str| {
            let number = result[key].as_u64().and_then(|number| usize::try_from(number).ok());
            number.ok_or_else(|| format!("{file}: no {key}"))
        };
        let format = result["format"].as_str().ok_or_else(|| format!("{file}: no format"))?;
        *self.read.entry(format.to_owned()).or_default() += 1;
        self.links += number("links")?;
        self.inertials += number("inertials")?;
        self.weighed += usize::from(number("inertials")? > 0);
        let mut of_file: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
        for finding in result["findings"].as_array().into_iter().flatten() {
            let (Some(code), Some(severity)) = (finding["code"].as_str(), finding["severity"].as_str())
            else {
                return Err(format!("{file}: a finding without code or severity"));
            };
            let rank = SEVERITIES.iter().position(|known| *known == severity);
            let rank = rank.ok_or_else(|| format!("{file}: a finding is {severity}"))?;
            of_file.entry(code).or_default()[rank] += 1;
        }
        for rank in 0..SEVERITIES.len() {
            self.files[rank] += usize::from(of_file.values().any(|counts| counts[rank] > 0));
        }
        let of_bodies = |code: &str| code.starts_with("inertia.") || code.starts_with("mass.");
        self.impossible_bodies +=
            usize::from(of_file.iter().any(|(code, counts)| of_bodies(code) && counts[0] > 0));
        for (code, counts) in of_file {
            let rule = self.rules.entry(code.to_owned()).or_default();
            rule.add(&RuleCounts { findings: counts, files: 1, repositories: 0 });
            rule.repositories = 1;
        }
        Ok(())
    }

    /// Adds those of another repository.
    pub(super) fn join(&mut self, other: &Self) {
        for (own, others) in [(&mut self.read, &other.read), (&mut self.refused, &other.refused)] {
            others.iter().for_each(|(key, count)| *own.entry(key.clone()).or_default() += count);
        }
        for (own, count) in [
            (&mut self.copies, other.copies),
            (&mut self.tests, other.tests),
            (&mut self.links, other.links),
            (&mut self.inertials, other.inertials),
            (&mut self.weighed, other.weighed),
            (&mut self.impossible_bodies, other.impossible_bodies),
        ] {
            *own += count;
        }
        (0..SEVERITIES.len()).for_each(|rank| self.files[rank] += other.files[rank]);
        for (code, counts) in &other.rules {
            self.rules.entry(code.clone()).or_default().add(counts);
        }
    }

    /// Files that were read.
    pub(super) fn files_read(&self) -> usize {
        self.read.values().sum()
    }

    /// Findings of a severity.
    pub(super) fn findings(&self, rank: usize) -> usize {
        self.rules.values().map(|rule| rule.findings[rank]).sum()
    }
}

impl RuleCounts {
    fn add(&mut self, other: &Self) {
        (0..SEVERITIES.len()).for_each(|rank| self.findings[rank] += other.findings[rank]);
        self.files += other.files;
        self.repositories += other.repositories;
    }
}

/// Whether a file is in a folder of tests, where models are wrong on purpose.
fn is_test(file: &str) -> bool {
    let folders = file.rsplit_once('/').map_or("", |(folders, _)| folders);
    folders.split('/').any(|folder| {
        let folder = folder.to_ascii_lowercase();
        folder
            .split(['_', '-'])
            .any(|word| matches!(word, "test" | "tests" | "testing" | "testdata" | "unittest"))
    })
}

/// The class of a reason why a file was refused.
fn reason(message: &str) -> &str {
    for (part, class) in [
        ("xacro", "xacro, which makes a model and is none"),
        ("well-formed XML", "XML that is not well-formed"),
        ("expected </", "XML that is not well-formed"),
        ("the end of the root element", "XML that is not well-formed"),
        ("OpenSim files before", "OpenSim before version 2.3.2"),
        ("UTF-8", "text that is not UTF-8"),
        ("for the second time", "MJCF that includes a file twice, which MuJoCo refuses"),
    ] {
        if message.contains(part) {
            return class;
        }
    }
    message
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn finding(code: &str, severity: &str) -> Value {
        json!({ "code": code, "severity": severity })
    }

    #[test]
    fn each_file_counts_once_for_what_is_found_in_it() {
        let tree = std::env::temp_dir().join(format!("polhode-corpus-{}", std::process::id()));
        std::fs::create_dir_all(tree.join("test")).unwrap();
        for (file, text) in
            [("a.urdf", "a"), ("b.sdf", "b"), ("c.urdf", "a"), ("test/d.urdf", "d"), ("e.urdf", "e")]
        {
            std::fs::write(tree.join(file), text).unwrap();
        }
        let read = |file: &str, format: &str, findings: Value| json!({ "file": file, "format": format, "links": 5, "inertials": 3, "findings": findings });
        let results = [
            read(
                "a.urdf",
                "urdf",
                json!([
                    finding("inertia.triangle", "impossible"),
                    finding("inertia.triangle", "impossible"),
                    finding("inertia.triangle", "suspect"),
                    finding("geometry.unreadable", "note")
                ]),
            ),
            read("b.sdf", "sdf", json!([finding("tree.empty", "impossible")])),
            read("c.urdf", "urdf", json!([finding("inertia.zero", "impossible")])),
            read("test/d.urdf", "urdf", json!([finding("inertia.zero", "impossible")])),
            json!({ "file": "e.urdf", "error": { "message": "polhode does not read xacro: …" } }),
            json!({ "file": "gone.urdf", "error": { "message": "there is no such file" } }),
            json!({ "file": ".", "error": { "message": ". holds no model" } }),
        ];
        let (mut counts, mut seen) = (Counts::default(), Seen::default());
        for result in &results {
            counts.add(&tree, result, &mut seen).unwrap();
        }
        std::fs::remove_dir_all(&tree).unwrap();
        assert_eq!((counts.files_read(), counts.copies, counts.tests), (2, 1, 1));
        assert_eq!(counts.refused.values().copied().collect::<Vec<_>>(), [1, 1]);
        assert_eq!((counts.links, counts.inertials, counts.weighed), (10, 6, 2));
        assert_eq!((counts.files, counts.impossible_bodies), ([2, 1, 1], 1));
        let triangle = RuleCounts { findings: [2, 1, 0], files: 1, repositories: 1 };
        assert_eq!(counts.rules["inertia.triangle"], triangle);
        assert!(!counts.rules.contains_key("inertia.zero"));
        let mut both = counts.clone();
        both.join(&counts);
        assert_eq!((both.files_read(), both.findings(0)), (4, 6));
        assert_eq!(
            both.rules["inertia.triangle"],
            RuleCounts { findings: [4, 2, 0], files: 2, repositories: 2 }
        );
    }

    #[test]
    fn folders_of_tests_are_known_by_words() {
        assert!(is_test("./multibody/parsing/test/bad.urdf") && is_test("unittest/models/a.urdf"));
        assert!(is_test("dm_control/mjcf/test_assets/model.xml"));
        assert!(
            !is_test("robots/testbench/a.urdf") && !is_test("test.urdf") && !is_test("models/contest/a.sdf")
        );
    }
}
