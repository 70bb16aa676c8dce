//! Groups findings: links with the same error, such as the four calves of a quadruped, give one
//! finding.

use std::collections::BTreeMap;

use crate::finding::{Finding, Severity};
use crate::model::RobotModel;

/// Maximum number of links that a message names.
pub(super) const LISTED: usize = 12;

/// Combines findings about masses and tensors that have the same message for several links.
/// Impossible numbers are reported for each link.
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
        // Groups do not extend across files.
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

/// Returns the first finding of a group, with the other links and all repairs added.
fn one(group: Vec<Finding>) -> Option<Finding> {
    let mut group = group.into_iter();
    let mut found = group.next()?;
    for other in group {
        if let (Some(repair), Some(more)) = (&mut found.repair, other.repair) {
            // Copies of a body may share one text; its edit is added once.
            let further = more.edits.into_iter().filter(|edit| !repair.edits.contains(edit));
            let further: Vec<_> = further.collect();
            repair.edits.extend(further);
        }
        found.others.push(other.subject);
    }
    if !found.others.is_empty() {
        let count = found.others.len();
        found.message = format!("{}; same in {}", found.message, named(&found.others));
        if let Some(repair) = &mut found.repair {
            repair.description = format!("{}; same change in {count} more", repair.description);
        }
    }
    Some(found)
}

/// Returns a list of names: `a, b, c`, cut after [`LISTED`] names.
pub(super) fn named<S: AsRef<str>>(names: &[S]) -> String {
    let shown: Vec<&str> = names.iter().take(LISTED).map(AsRef::as_ref).collect();
    let more = match names.len().saturating_sub(LISTED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    shown.join(", ") + &more
}
