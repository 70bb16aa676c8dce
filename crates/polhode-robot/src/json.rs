//! JSON of a checked model. Keys are stable, numbers are in SI units, and values that are not
//! finite are `null`.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Map, Value, json};

use crate::finding::{Finding, NearestTensor, Proposal, Repair};
use crate::line_index::{FilePlace, Places};
use crate::model::RobotModel;
use crate::policy::{Reason, Settled};
use crate::repair::Left;
use crate::report::{CheckReport, Counts, Fixed, format_name};

impl CheckReport {
    /// Returns one object. Keys: `file`, `format`, `links`, `inertials`, `includes` (counts for
    /// each included file), `counts` (of findings), `verdicts` (of links), `findings`. Findings
    /// that do not count are in `allowed`, `known` and `off`. `fix` is present if repairs were
    /// requested.
    ///
    /// Lines and columns count from 1, columns in characters. A finding has the key `file` if it is
    /// in an included file.
    pub fn to_json(&self) -> Value {
        let Counts { impossible, suspect, note } = self.counts();
        let by_link = self.link_counts();
        let ok = self.model.links.len().saturating_sub(by_link.sum());
        let places = Places::of(&self.model);
        let finding = |f: &Finding, id: &str| finding(&places, &self.model, f, id);
        let mut object = Map::new();
        let mut insert = |key: &str, value: Value| object.insert(key.to_owned(), value);
        insert("polhode", polhode_document::VERSION.into());
        insert("file", self.model.path.to_string_lossy().into());
        insert("format", format_name(self.model.format).to_ascii_lowercase().into());
        insert("name", self.model.name.clone().into());
        insert("links", self.model.links.len().into());
        insert("inertials", self.inertials().into());
        insert("includes", self.includes(&places));
        insert("inertia_about", "center_of_mass".into());
        insert("products", "negative_integral".into());
        insert("counts", json!({ "impossible": impossible, "suspect": suspect, "note": note }));
        let Counts { impossible, suspect, note } = by_link;
        insert("verdicts", json!({ "impossible": impossible, "suspect": suspect, "note": note, "ok": ok }));
        let open = self.findings().iter().zip(&self.judged.ids);
        insert("findings", open.map(|(f, id)| finding(f, id)).collect());
        let (mut allowed, mut known) = (Vec::new(), Vec::new());
        for Settled { finding: settled, id, why } in &self.judged.settled {
            let mut value = finding(settled, id);
            match why {
                Reason::Known => known.push(value),
                Reason::Allowed(reason) => {
                    value["reason"] = reason.as_str().into();
                    allowed.push(value);
                }
            }
        }
        insert("allowed", allowed.into());
        insert("known", known.into());
        insert("off", self.judged.off.into());
        if let Some(fixed) = &self.fixed {
            insert("fix", fix(self.findings(), fixed));
        }
        Value::Object(object)
    }

    /// Returns the numbers of links and inertials in each included file.
    fn includes(&self, places: &Places<'_>) -> Value {
        let mut counts: BTreeMap<&Path, [usize; 2]> =
            self.model.included.iter().map(|source| (source.path.as_path(), [0; 2])).collect();
        let inertials = self.model.links.iter().filter_map(|link| link.inertial.as_ref());
        let links = self.model.links.iter().map(|link| (&link.span, 0));
        for (span, of) in links.chain(inertials.map(|inertial| (&inertial.span, 1))) {
            let FilePlace { file, is_included, .. } = places.place(span);
            if let Some(count) = counts.get_mut(file).filter(|_| is_included).and_then(|c| c.get_mut(of)) {
                *count += 1;
            }
        }
        let one = |(file, [links, inertials]): (&Path, [usize; 2])| json!({ "file": file.to_string_lossy(), "links": links, "inertials": inertials });
        counts.into_iter().map(one).collect()
    }
}

fn finding(places: &Places<'_>, model: &RobotModel, finding: &Finding, id: &str) -> Value {
    let is_expanded = model.expansion.is_some();
    let FilePlace { file, is_included, line, column } = places.place(&finding.span);
    let numbers: Map<String, Value> =
        finding.numbers.iter().map(|&(name, value)| (name.to_owned(), Value::from(value))).collect();
    let mut object = json!({
        "id": id,
        "code": finding.code,
        "severity": finding.severity.name(),
        "link": finding.subject,
        "others": finding.others,
        "line": line,
        "column": column,
        "message": finding.message,
        "rule": finding.rule,
        "numbers": numbers,
        "repair": finding.repair.as_ref().map(|repair| self::repair(places, model, repair)),
    });
    if let Some(proposal) = &finding.nearest {
        object["nearest"] = nearest(proposal);
    }
    if let Some(object) = object.as_object_mut().filter(|_| is_included || is_expanded) {
        object.insert("file".to_owned(), file.to_string_lossy().into());
    }
    object
}

/// Returns the nearest possible tensors, or the reasons why there is none.
fn nearest(Proposal { frobenius, affine_invariant }: &Proposal) -> Value {
    let one = |nearest: &Result<NearestTensor, String>| match nearest {
        Ok(NearestTensor { tensor: [ixx, iyy, izz, ixy, ixz, iyz], distance, .. }) => json!({
            "ixx": ixx, "iyy": iyy, "izz": izz, "ixy": ixy, "ixz": ixz, "iyz": iyz, "distance": distance,
        }),
        Err(why) => json!({ "none": why.trim_start_matches("none: ") }),
    };
    json!({ "frobenius": one(frobenius), "affine_invariant": one(affine_invariant) })
}

fn repair(places: &Places<'_>, model: &RobotModel, repair: &Repair) -> Value {
    let edit = |(span, new): &(std::ops::Range<usize>, String)| {
        let FilePlace { file, line, column, .. } = places.place(span);
        let old = model.text.get(span.clone());
        let mut edit = json!({ "line": line, "column": column, "old": old, "new": new });
        if model.expansion.is_some() {
            edit["file"] = file.to_string_lossy().into();
        }
        edit
    };
    json!({ "description": repair.description, "edits": repair.edits.iter().map(edit).collect::<Vec<_>>() })
}

/// Returns the output path, the diff, the applied repairs (by index in `findings`), and the repairs
/// that were not applied.
fn fix(findings: &[Finding], fixed: &Fixed) -> Value {
    let left = |Left { finding, why }: &Left| {
        let of = findings.get(*finding);
        json!({
            "finding": finding,
            "code": of.map(|f| f.code),
            "link": of.map(|f| f.subject.as_str()),
            "why": why.in_words(),
        })
    };
    json!({
        "out": fixed.out,
        "diff": fixed.diff,
        "changes": fixed.repaired.changes,
        "repaired": fixed.repaired.applied,
        "left": fixed.repaired.left.iter().map(left).collect::<Vec<_>>(),
        "remaining": fixed.remaining.len(),
    })
}
