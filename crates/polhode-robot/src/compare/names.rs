//! Names of links and joints in the first model and in the second.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;
use std::path::Path;

use polhode_source::{ContentError, ContentErrorKind, FormatError, nearest};
use toml::de::{DeTable, DeValue};

use crate::model::RobotModel;

/// Names in the second model by names in the first. Other names are equal in both.
#[derive(Debug, Default)]
pub(super) struct Names {
    pub(super) links: Renamed,
    pub(super) joints: Renamed,
}

/// Names that differ.
#[derive(Debug, Default)]
pub(super) struct Renamed {
    to: BTreeMap<String, String>,
    taken: BTreeSet<String>,
}

impl Renamed {
    /// Returns for each name of the first model the index of its partner in the second.
    ///
    /// Partners have the names of the map, otherwise the same name, otherwise the same last part of
    /// a path, if it is the only one: `/robot/arm` of USD and `model::arm` of SDF are `arm`.
    pub(super) fn partners(&self, a: &[&str], b: &[&str]) -> Vec<Option<usize>> {
        let places: HashMap<&str, usize> = b.iter().enumerate().map(|(k, name)| (*name, k)).collect();
        let mut partners: Vec<Option<usize>> =
            a.iter().map(|name| self.of(name).and_then(|name| places.get(name)).copied()).collect();
        let mut is_taken = vec![false; b.len()];
        for k in partners.iter().flatten() {
            is_taken.get_mut(*k).into_iter().for_each(|taken| *taken = true);
        }
        // For each last part: its first name, and the number of open names, in each model.
        let mut parts: HashMap<&str, [(usize, usize); 2]> = HashMap::new();
        let open_a = a
            .iter()
            .enumerate()
            .filter(|(k, name)| partners.get(*k) == Some(&None) && !self.to.contains_key(**name));
        let open_b = b.iter().enumerate().filter(|(k, _)| is_taken.get(*k) == Some(&false));
        for (side, k, name) in open_a.map(|(k, n)| (0, k, n)).chain(open_b.map(|(k, n)| (1, k, n))) {
            if let Some(entry) = parts.entry(last_part(name)).or_default().get_mut(side) {
                *entry = (k, entry.1 + 1);
            }
        }
        for [(of_a, in_a), (of_b, in_b)] in parts.into_values() {
            if let Some(slot) = partners.get_mut(of_a).filter(|_| (in_a, in_b) == (1, 1)) {
                *slot = Some(of_b);
            }
        }
        partners
    }

    /// Returns the name in the second model. A name that another one is mapped to is not equal to
    /// itself.
    fn of<'n>(&'n self, name: &'n str) -> Option<&'n str> {
        match self.to.get(name) {
            Some(other) => Some(other),
            None => Some(name).filter(|name| !self.taken.contains(*name)),
        }
    }
}

/// Returns the last part of a path of USD or SDF.
pub(super) fn last_part(name: &str) -> &str {
    let name = name.rsplit_once("::").map_or(name, |(_, last)| last);
    name.rsplit_once('/').map_or(name, |(_, last)| last)
}

impl Names {
    /// Parses a map file; `path` is for messages.
    ///
    /// # Errors
    /// [`FormatError`] with its place, for invalid TOML, other tables, unknown names, and names
    /// that occur twice.
    pub(super) fn read(path: &Path, text: &str, a: &RobotModel, b: &RobotModel) -> Result<Self, FormatError> {
        read(text, a, b).map_err(|error| FormatError::of_content(path, text.as_bytes(), error))
    }
}

fn read(text: &str, a: &RobotModel, b: &RobotModel) -> Result<Names, ContentError> {
    let document = DeTable::parse(text).map_err(|error| {
        let span = error.span().unwrap_or(0..0);
        let what = format!("TOML ({})", error.message().replace('\n', " "));
        expected(&what, text.get(span.clone()).unwrap_or(""), span)
            .hint("write [links] or [joints], then \"name in A\" = \"name in B\"")
    })?;
    let mut names = Names::default();
    for (key, value) in document.get_ref() {
        let (renamed, kind) = match key.get_ref().as_ref() {
            "links" => (&mut names.links, Kind { noun: "link", list: links }),
            "joints" => (&mut names.joints, Kind { noun: "joint", list: joints }),
            other => {
                let meant = nearest(other, ["links", "joints"]);
                let meant = meant.map_or(String::new(), |meant| format!("did you mean [{meant}]? "));
                let error = expected("[links] or [joints]", other, key.span());
                return Err(error.hint(format!("{meant}a map has the tables [links] and [joints]")));
            }
        };
        let DeValue::Table(entries) = value.get_ref() else {
            let hint = format!("write [{}], then \"name in A\" = \"name in B\"", key.get_ref());
            return Err(expected("a table of names", "another value", value.span()).hint(hint));
        };
        let mut entries: Vec<_> = entries.iter().collect();
        entries.sort_by_key(|(from, _)| from.span().start);
        for (from, to) in entries {
            kind.require(from.get_ref(), from.span(), a)?;
            let DeValue::String(other) = to.get_ref() else {
                let hint = "write the name in quotes: \"name in A\" = \"name in B\"";
                return Err(expected("a name", "another value", to.span()).hint(hint));
            };
            kind.require(other, to.span(), b)?;
            if !renamed.taken.insert(other.to_string()) {
                let what = format!("each {} once", kind.noun);
                let error = expected(&what, &format!("{other} twice"), to.span());
                return Err(error.hint("delete one of the two lines"));
            }
            renamed.to.insert(from.get_ref().to_string(), other.to_string());
        }
    }
    Ok(names)
}

/// Links or joints.
struct Kind {
    noun: &'static str,
    list: fn(&RobotModel) -> Vec<&str>,
}

impl Kind {
    /// Refuses a name that a model does not have.
    fn require(&self, name: &str, span: Range<usize>, model: &RobotModel) -> Result<(), ContentError> {
        let known = (self.list)(model);
        if known.contains(&name) {
            return Ok(());
        }
        let file = model.path.display();
        let error = expected(&format!("a {} of {file}", self.noun), name, span);
        Err(match nearest(name, known) {
            Some(meant) => error.hint(format!("did you mean {meant:?}?")),
            None => error.hint(format!("write a name that {file} has")),
        })
    }
}

pub(super) fn links(model: &RobotModel) -> Vec<&str> {
    model.links.iter().map(|link| link.name.text.as_str()).collect()
}

pub(super) fn joints(model: &RobotModel) -> Vec<&str> {
    model.joints.iter().map(|joint| joint.name.text.as_str()).collect()
}

fn expected(what: &str, found: &str, span: Range<usize>) -> ContentError {
    ContentErrorKind::expected(what, found).at(span)
}
