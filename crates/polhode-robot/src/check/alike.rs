//! One finding for all links of which the same is said: the four calves of a dog are one part, and one mistake.

use std::collections::BTreeMap;

use crate::finding::{Finding, Severity};
use crate::model::RobotModel;

/// Links that a message names.
pub(super) const LISTED: usize = 12;

/// What is said of masses and tensors by their geometry, in the same words of several links, is said once. What is impossible is said of
/// each.
pub(super) fn grouped(model: &RobotModel, findings: Vec<Finding>) -> Vec<Finding> {
    type Key = (&'static str, Severity, String, String, bool, usize);
    let mut first: BTreeMap<Key, usize> = BTreeMap::new();
    let mut groups: Vec<Vec<Finding>> = Vec::new();
    for finding in findings {
        let subject = finding.code.split('.').next().unwrap_or("");
        let alone = !["mass", "inertia", "density", "gyration"].contains(&subject)
            || finding.severity == Severity::Impossible
            || !finding.others.is_empty();
        if alone {
            groups.push(vec![finding]);
            continue;
        }
        let Finding { code, severity, message, rule, repair, .. } = &finding;
        // Of each file by itself.
        let file = model.included.partition_point(|source| source.start <= finding.span.start);
        let key = (*code, *severity, message.clone(), rule.clone(), repair.is_some(), file);
        match first.get(&key).and_then(|group| groups.get_mut(*group)) {
            Some(group) => group.push(finding),
            None => {
                first.insert(key, groups.len());
                groups.push(vec![finding]);
            }
        }
    }
    groups.into_iter().filter_map(one).collect()
}

/// The first of a group, with the others named, and all their repairs.
fn one(group: Vec<Finding>) -> Option<Finding> {
    let mut group = group.into_iter();
    let mut found = group.next()?;
    for other in group {
        if let (Some(repair), Some(more)) = (&mut found.repair, other.repair) {
            // Copies of a body are of one text.
            let further = more.edits.into_iter().filter(|edit| !repair.edits.contains(edit));
            let further: Vec<_> = further.collect();
            repair.edits.extend(further);
        }
        found.others.push(other.subject);
    }
    if !found.others.is_empty() {
        let count = found.others.len();
        found.message = format!("{}; so {}", found.message, named(&found.others));
        if let Some(repair) = &mut found.repair {
            repair.description = format!("{}; so in {count} more", repair.description);
        }
    }
    Some(found)
}

/// `a, b, c`, of many the first.
pub(super) fn named<S: AsRef<str>>(names: &[S]) -> String {
    let shown: Vec<&str> = names.iter().take(LISTED).map(AsRef::as_ref).collect();
    let more = match names.len().saturating_sub(LISTED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    shown.join(", ") + &more
}
