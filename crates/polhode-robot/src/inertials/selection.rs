//! Links that a request chooses.

use polhode_source::{Failure, nearest};

use super::request::{InertialsRequest, Only};
use crate::finding::{Finding, Severity};
use crate::link_error::suggested;
use crate::model::{Link, RobotModel, Slot, Tensor};
use crate::policy::glob::name_matches;

/// Returns the indices of the chosen links. `findings` are those of the model.
pub(super) fn chosen(
    model: &RobotModel,
    request: &InertialsRequest,
    findings: &[Finding],
) -> Result<Vec<usize>, Failure> {
    let named = |link: &Link| request.link.as_ref().is_none_or(|name| matches(name, &link.name.text));
    if let Some(name) = &request.link
        && !model.links.iter().any(named)
    {
        let names: Vec<&str> = model.links.iter().map(|link| link.name.text.as_str()).collect();
        let hint = suggested(nearest(name, names.iter().copied()), "the links are", &names);
        return Err(Failure::usage(format!("no link is named {name:?}"), hint).in_file(&model.path));
    }
    let worst = |link: &Link| {
        let name = &link.name.text;
        let own = findings.iter().filter(|finding| finding.subject == *name || finding.others.contains(name));
        own.map(|finding| finding.severity).max()
    };
    let is_wanted = |link: &Link| match request.options.only {
        None => true,
        Some(Only::Missing) => !has_inertial(link),
        Some(Only::Suspect) => worst(link) >= Some(Severity::Suspect),
        Some(Only::Impossible) => worst(link) >= Some(Severity::Impossible),
    };
    let links = model.links.iter().enumerate();
    Ok(links.filter(|(_, link)| named(link) && is_wanted(link)).map(|(k, _)| k).collect())
}

/// Returns true if a name is a pattern's, or the pattern itself.
pub(super) fn matches(pattern: &str, name: &str) -> bool {
    pattern == name || name_matches(pattern, name)
}

/// Returns true if a link states a mass and all elements of a tensor.
pub(super) fn has_inertial(link: &Link) -> bool {
    link.inertial.as_ref().is_some_and(|inertial| {
        let given = |slot: &Slot| matches!(slot, Slot::Given(_));
        let has_tensor = match &inertial.tensor {
            Tensor::Missing(_) => false,
            Tensor::Six(slots) => slots.iter().take(3).all(given),
            Tensor::Diagonal(slots) => slots.iter().all(given),
        };
        given(&inertial.mass) && has_tensor
    })
}
