//! Statistics of the results for a repository.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use hmac_sha256::Hash as Sha256;
use serde_json::Value;

/// Hashes of all models counted so far, to skip copies.
pub(super) type Seen = BTreeSet<[u8; 32]>;

/// Severities of findings, from the worst.
pub(super) const SEVERITIES: [&str; 3] = ["impossible", "suspect", "note"];

/// Rules broken by values that no physical body has.
///
/// Rules about missing or invalid numbers are not included.
pub(super) const NO_BODY: [&str; 4] =
    ["inertia.triangle", "inertia.negative", "inertia.zero", "mass.not_positive"];

/// Statistics of one or several repositories.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    /// Number of models read, by language.
    pub(super) read: BTreeMap<String, usize>,
    /// Number of refused files, by reason.
    pub(super) refused: BTreeMap<String, usize>,
    /// Number of files with the same bytes as an earlier one.
    pub(super) copies: usize,
    /// Number of files in test folders.
    pub(super) tests: usize,
    pub(super) links: usize,
    /// Number of files that are included by others, and are not models by themselves.
    pub(super) parts: usize,
    /// Number of inertial elements.
    pub(super) inertials: usize,
    /// Number of files with inertial elements.
    pub(super) weighed: usize,
    /// Number of files with a finding of each severity.
    pub(super) files: [usize; 3],
    /// Number of files with inertials in which a rule of [`NO_BODY`] is broken.
    pub(super) impossible_bodies: usize,
    pub(super) rules: BTreeMap<String, RuleCounts>,
}

/// Statistics of one rule.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct RuleCounts {
    /// Number of findings, by severity.
    pub(super) findings: [usize; 3],
    pub(super) files: usize,
    pub(super) repositories: usize,
}

/// Results for a file, from itself and from models that include it.
#[derive(Debug, Default)]
struct Holder {
    /// Language of the file, if it is a model by itself.
    format: Option<String>,
    /// Reason of the refusal, if it was refused.
    refused: Option<String>,
    links: usize,
    inertials: usize,
    /// Rank of each finding's severity; the worst of all models.
    findings: BTreeMap<Key, usize>,
}

/// Finding of a file: its rule, line, column and message.
type Key = (String, u64, u64, String);

impl Holder {
    fn add(&mut self, links: usize, inertials: usize) {
        self.links = self.links.max(links);
        self.inertials = self.inertials.max(inertials);
    }
}

impl Counts {
    /// Computes the statistics of a work tree from the results.
    pub(super) fn of(tree: &Path, results: &[Value], seen: &mut Seen) -> Result<Self, String> {
        let mut counts = Self::default();
        let mut holders: BTreeMap<PathBuf, Holder> = BTreeMap::new();
        for result in results {
            counts.hold(tree, result, &mut holders)?;
        }
        for (file, holder) in &holders {
            counts.add(tree, file, holder, seen);
        }
        Ok(counts)
    }

    /// Assigns the results of one model to the files that contain the elements.
    fn hold(
        &mut self,
        tree: &Path,
        result: &Value,
        holders: &mut BTreeMap<PathBuf, Holder>,
    ) -> Result<(), String> {
        let file = result["file"].as_str().ok_or("a result without its file")?;
        if tree.join(file).is_dir() {
            return Ok(()); // The folder has no models.
        }
        if is_test(file) {
            self.tests += 1;
            return Ok(());
        }
        let real = |file: &str| std::fs::canonicalize(tree.join(file));
        let Ok(own) = real(file) else {
            *self.refused.entry("files that cannot be opened".to_owned()).or_default() += 1;
            return Ok(());
        };
        if let Some(message) = result["error"]["message"].as_str() {
            holders.entry(own).or_default().refused = Some(reason(message).to_owned());
            return Ok(());
        }
        let number = |value: &Value, key: &str| {
            let number = value[key].as_u64().and_then(|number| usize::try_from(number).ok());
            number.ok_or_else(|| format!("{file}: no {key}"))
        };
        let (mut links, mut inertials) = (number(result, "links")?, number(result, "inertials")?);
        for part in result["includes"].as_array().ok_or_else(|| format!("{file}: no includes"))? {
            let (within, of_links, of_inertials) = (
                part["file"].as_str().unwrap_or_default(),
                number(part, "links")?,
                number(part, "inertials")?,
            );
            let within = real(within).map_err(|error| format!("{within}: {error}"))?;
            holders.entry(within).or_default().add(of_links, of_inertials);
            links = links.saturating_sub(of_links);
            inertials = inertials.saturating_sub(of_inertials);
        }
        let holder = holders.entry(own.clone()).or_default();
        holder.add(links, inertials);
        holder.format =
            Some(result["format"].as_str().ok_or_else(|| format!("{file}: no format"))?.to_owned());
        for finding in result["findings"].as_array().into_iter().flatten() {
            let text =
                |key: &str| finding[key].as_str().ok_or_else(|| format!("{file}: a finding without {key}"));
            let at =
                |key: &str| finding[key].as_u64().ok_or_else(|| format!("{file}: a finding without {key}"));
            let severity = text("severity")?;
            let rank = SEVERITIES.iter().position(|known| *known == severity);
            let rank = rank.ok_or_else(|| format!("{file}: a finding is {severity}"))?;
            let within = match finding["file"].as_str() {
                Some(within) => real(within).map_err(|error| format!("{within}: {error}"))?,
                None => own.clone(),
            };
            let key = (text("code")?.to_owned(), at("line")?, at("column")?, text("message")?.to_owned());
            let worst = holders.entry(within).or_default().findings.entry(key).or_insert(rank);
            *worst = rank.min(*worst);
        }
        Ok(())
    }

    /// Adds the results of a file.
    fn add(&mut self, tree: &Path, file: &Path, holder: &Holder, seen: &mut Seen) {
        if file.strip_prefix(tree).is_ok_and(|within| is_test(&within.to_string_lossy())) {
            return; // Models that are none include the file.
        }
        let Ok(bytes) = std::fs::read(file) else {
            *self.refused.entry("files that cannot be opened".to_owned()).or_default() += 1;
            return;
        };
        if !seen.insert(Sha256::hash(&bytes)) {
            self.copies += 1;
            return;
        }
        match (&holder.format, &holder.refused) {
            (Some(format), _) => *self.read.entry(format.clone()).or_default() += 1,
            (None, Some(reason)) => *self.refused.entry(reason.clone()).or_default() += 1,
            (None, None) => self.parts += 1,
        }
        self.links += holder.links;
        self.inertials += holder.inertials;
        let says_mass = holder.inertials > 0;
        self.weighed += usize::from(says_mass);
        let mut by_rule: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
        for ((code, ..), rank) in &holder.findings {
            by_rule.entry(code).or_default()[*rank] += 1;
        }
        for rank in 0..SEVERITIES.len() {
            self.files[rank] += usize::from(by_rule.values().any(|counts| counts[rank] > 0));
        }
        let is_body = |code: &str| NO_BODY.contains(&code);
        let is_impossible = by_rule.iter().any(|(code, counts)| is_body(code) && counts[0] > 0);
        self.impossible_bodies += usize::from(says_mass && is_impossible);
        for (code, counts) in by_rule {
            let rule = self.rules.entry(code.to_owned()).or_default();
            rule.add(&RuleCounts { findings: counts, files: 1, repositories: 0 });
            rule.repositories = 1;
        }
    }

    /// Adds the statistics of another repository.
    pub(super) fn join(&mut self, other: &Self) {
        for (own, others) in [(&mut self.read, &other.read), (&mut self.refused, &other.refused)] {
            others.iter().for_each(|(key, count)| *own.entry(key.clone()).or_default() += count);
        }
        for (own, count) in [
            (&mut self.copies, other.copies),
            (&mut self.tests, other.tests),
            (&mut self.parts, other.parts),
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

    /// Returns the number of models read.
    pub(super) fn files_read(&self) -> usize {
        self.read.values().sum()
    }

    /// Returns the number of findings of a severity, given by its rank.
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

/// Returns true if a file is in a test folder, where models are wrong on purpose.
fn is_test(file: &str) -> bool {
    let folders = file.rsplit_once('/').map_or("", |(folders, _)| folders);
    folders.split('/').any(|folder| {
        let folder = folder.to_ascii_lowercase();
        folder
            .split(['_', '-'])
            .any(|word| matches!(word, "test" | "tests" | "testing" | "testdata" | "unittest"))
    })
}

/// Returns the category of a refusal message.
fn reason(message: &str) -> &str {
    for (part, class) in [
        ("xacro", "unexpanded xacro"),
        ("well-formed XML", "XML that is not well-formed"),
        ("expected </", "XML that is not well-formed"),
        ("the end of the root element", "XML that is not well-formed"),
        ("OpenSim files before", "OpenSim before version 2.3.2"),
        ("UTF-8", "text that is not UTF-8"),
        ("included a second time", "MJCF that includes a file twice, which MuJoCo refuses"),
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

    fn finding(code: &str, severity: &str, line: usize) -> Value {
        json!({ "code": code, "severity": severity, "line": line, "column": 1, "message": "it is" })
    }

    /// Creates a work tree with these files.
    fn tree(name: &str, files: &[(&str, &str)]) -> PathBuf {
        let tree = std::env::temp_dir().join(format!("polhode-corpus-{name}-{}", std::process::id()));
        std::fs::create_dir_all(tree.join("test")).unwrap();
        files.iter().for_each(|(file, text)| std::fs::write(tree.join(file), text).unwrap());
        std::fs::canonicalize(tree).unwrap()
    }

    #[test]
    fn each_file_counts_once_for_what_is_found_in_it() {
        let tree = tree(
            "files",
            &[("a.urdf", "a"), ("b.sdf", "b"), ("c.urdf", "a"), ("test/d.urdf", "d"), ("e.urdf", "e")],
        );
        let read = |file: &str, format: &str, findings: Value| json!({ "file": file, "format": format, "links": 5, "inertials": 3, "includes": [], "findings": findings });
        let results = [
            read(
                "a.urdf",
                "urdf",
                json!([
                    finding("inertia.triangle", "impossible", 3),
                    finding("inertia.triangle", "impossible", 5),
                    finding("inertia.triangle", "suspect", 7),
                    finding("geometry.unreadable", "note", 8)
                ]),
            ),
            read("b.sdf", "sdf", json!([finding("tree.empty", "impossible", 1)])),
            read("c.urdf", "urdf", json!([finding("inertia.zero", "impossible", 1)])),
            read("test/d.urdf", "urdf", json!([finding("inertia.zero", "impossible", 1)])),
            json!({ "file": "e.urdf", "error": { "message": "polhode does not read xacro: …" } }),
            json!({ "file": "gone.urdf", "error": { "message": "the file does not exist" } }),
            json!({ "file": ".", "error": { "message": ". contains no model" } }),
        ];
        let counts = Counts::of(&tree, &results, &mut Seen::default()).unwrap();
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
    fn what_stands_in_an_included_file_counts_once_and_for_that_file() {
        // Two models include the same arm, which is a model itself, and a hand, which is not; a
        // test includes another.
        let tree = tree(
            "includes",
            &[
                ("one.xml", "1"),
                ("two.xml", "2"),
                ("arm.xml", "arm"),
                ("hand.inc", "hand"),
                ("test/t.xml", "t"),
                ("own.inc", "own"),
            ],
        );
        let within = |file: &str, mut finding: Value| {
            finding["file"] = file.into();
            finding
        };
        let arm = finding("inertia.triangle", "impossible", 4);
        let hand = finding("mass.not_positive", "suspect", 2);
        let of = |file: &str, links: usize, hand: Value| {
            json!({ "file": file, "format": "mjcf", "links": links, "inertials": 5, "findings": [within("arm.xml", arm.clone()), within("hand.inc", hand)],
                "includes": [{ "file": "arm.xml", "links": 3, "inertials": 3 }, { "file": "hand.inc", "links": 2, "inertials": 2 }] })
        };
        let worse = finding("mass.not_positive", "impossible", 2);
        let results = [
            of("one.xml", 6, hand),
            of("two.xml", 5, worse),
            json!({ "file": "arm.xml", "format": "mjcf", "links": 3, "inertials": 3, "includes": [], "findings": [arm] }),
            json!({ "file": "test/t.xml", "format": "mjcf", "links": 9, "inertials": 9, "findings": [],
                "includes": [{ "file": "own.inc", "links": 9, "inertials": 9 }] }),
        ];
        let counts = Counts::of(&tree, &results, &mut Seen::default()).unwrap();
        std::fs::remove_dir_all(&tree).unwrap();
        assert_eq!((counts.files_read(), counts.parts, counts.tests), (3, 1, 1));
        assert_eq!((counts.links, counts.inertials, counts.weighed), (6, 5, 2));
        assert_eq!(
            (counts.findings(0), counts.findings(1), counts.files, counts.impossible_bodies),
            (2, 0, [2, 0, 0], 2)
        );
    }

    #[test]
    fn only_a_mass_or_a_tensor_that_no_body_has_counts_as_one() {
        let counted = |code: &str, severity: &str, inertials: usize| {
            let tree = tree(code, &[("a.urdf", "a")]);
            let result = json!({ "file": "a.urdf", "format": "urdf", "links": 2, "inertials": inertials, "includes": [],
                "findings": [finding(code, severity, 1)] });
            let counts = Counts::of(&tree, &[result], &mut Seen::default()).unwrap();
            std::fs::remove_dir_all(&tree).unwrap();
            assert!(counts.impossible_bodies <= counts.weighed);
            counts.impossible_bodies
        };
        for code in NO_BODY {
            assert_eq!(
                (counted(code, "impossible", 1), counted(code, "suspect", 1), counted(code, "impossible", 0)),
                (1, 0, 0),
                "{code}"
            );
        }
        for code in ["mass.missing", "inertia.missing", "number.missing", "number.malformed", "tree.empty"] {
            assert_eq!(counted(code, "impossible", 1), 0, "{code}");
        }
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
