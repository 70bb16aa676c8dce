//! Counterparts of a link as evidence: the other side, or the same part with another number.
//!
//! The names of counterparts differ only in sides and numbers. Their solids are equal, mirrored, or
//! rotated by 180°: with s = ±1 for each axis, c → s c and I_ij → s_i s_j I_ij. A counterpart
//! without findings is evidence: a fix that leads to different numbers is withdrawn.

use std::collections::{HashMap, HashSet};

use super::body::Body;
use super::edit;
use super::explanation::LOOSE;
use super::pair::{EQUAL, MAPS, SIDES, words};
use crate::finding::{Finding, Repair, Severity};
use crate::geometry::Volume;
use crate::model::{Number, RobotModel, Slot};
use crate::moments::{Elements, PLACES, difference, elements, norm, rotated};

/// Maximum number of counterparts for each link. Robots have four to eight legs, and the time stays
/// linear.
const COMPARED: usize = 16;

/// Withdraws fixes that counterparts contradict.
pub(super) fn withdraw(model: &RobotModel, bodies: &[Option<Body>], findings: &mut [Finding]) {
    if findings.iter().all(|finding| finding.repair.is_none()) {
        return;
    }
    let doubted: HashSet<&str> = findings
        .iter()
        .filter(|finding| finding.severity >= Severity::Suspect && is_of_inertia(finding))
        .flat_map(|finding| finding.others.iter().chain([&finding.subject]).map(String::as_str))
        .collect();
    let mut names: HashMap<&str, &Body> = HashMap::new();
    let mut groups: HashMap<String, Vec<&Body>> = HashMap::new();
    for body in bodies.iter().flatten() {
        let name = body.link.name.text.as_str();
        names.insert(name, body);
        if body.mass > 0.0 && !doubted.contains(name) {
            groups.entry(key(name)).or_default().push(body);
        }
    }
    let against: Vec<Option<String>> = findings
        .iter()
        .map(|finding| {
            let repair = finding.repair.as_ref()?;
            let body = names.get(finding.subject.as_str())?;
            let fixed = Numbers::fixed(model, body, repair);
            let twins = groups.get(&key(&finding.subject))?.iter().take(COMPARED);
            let judged: Vec<(&Body, bool)> =
                twins.filter_map(|twin| Some((*twin, fixed.confirmed_by(body, twin)?))).collect();
            let (twin, _) = judged.first().filter(|_| !judged.iter().any(|(_, confirms)| *confirms))?;
            Some(twin.link.name.text.clone())
        })
        .collect();
    for (finding, twin) in findings.iter_mut().zip(against) {
        if let Some(twin) = twin {
            finding.repair = None;
            finding.message = format!(
                "{}; no fix is offered, because its counterpart {twin} has different numbers",
                finding.message
            );
        }
    }
}

fn is_of_inertia(finding: &Finding) -> bool {
    let subject = finding.code.split('.').next().unwrap_or("");
    ["mass", "inertia", "density", "gyration"].contains(&subject)
}

/// Returns the name without sides and numbers. `"FL_calf"` and `"RR_calf"` have the same key, and
/// so have `"finger_1"` and `"finger_2"`.
fn key(name: &str) -> String {
    let mut key = String::new();
    let mut end_before = 0;
    let is_side = |word: &str| SIDES.iter().any(|(left, right)| word == *left || word == *right);
    for (start, end) in words(name) {
        key.push_str(name.get(end_before..start).unwrap_or(""));
        let word = name.get(start..end).unwrap_or("").to_ascii_lowercase();
        key.push_str(if is_side(&word) { "?" } else { &word });
        end_before = end;
    }
    key.push_str(name.get(end_before..).unwrap_or(""));
    let mut plain = String::new();
    for c in key.chars() {
        let is_digit = c.is_ascii_digit();
        if !(is_digit && plain.ends_with('#')) {
            plain.push(if is_digit { '#' } else { c });
        }
    }
    plain
}

/// Numbers that a fix changes, after the fix.
struct Numbers {
    mass: Option<f64>,
    center: Option<[f64; 3]>,
    /// Tensor in link axes, kg·m².
    tensor: Option<Elements>,
}

impl Numbers {
    fn fixed(model: &RobotModel, body: &Body, repair: &Repair) -> Self {
        let edited = |number: &Number| {
            let (_, text) = repair.edits.iter().find(|(span, _)| *span == number.span)?;
            text.trim().parse::<f64>().ok()
        };
        let mass = match &body.inertial.mass {
            Slot::Given(number) => edited(number),
            Slot::Missing { .. } => None,
        };
        let mut written = body.written;
        let mut is_changed = false;
        for (k, number) in body.numbers() {
            if let Some(value) = edited(number) {
                written[k] = value;
                is_changed = true;
            }
        }
        let tensor = is_changed.then(|| rotated(&written, &body.rotation));
        let center = edit::center(model, body.inertial).and_then(|numbers| {
            let edits = numbers.each_ref().map(edited);
            let value = |k: usize| edits[k].unwrap_or(body.centre[k]);
            edits.iter().any(Option::is_some).then(|| [0, 1, 2].map(value))
        });
        Self { mass, center, tensor }
    }

    /// Returns true if the counterpart has these numbers, false if it has others, and `None` if it
    /// cannot decide.
    fn confirmed_by(&self, body: &Body, twin: &Body) -> Option<bool> {
        let is_same_mass = (self.mass.unwrap_or(body.mass) - twin.mass).abs() <= EQUAL * twin.mass;
        let says = self.mass.is_some() || is_same_mass && (self.center.is_some() || self.tensor.is_some());
        let mut maps = std::iter::once([1.0; 3]).chain(MAPS).filter(|s| has_solids(body, twin, s)).peekable();
        if twin.link.name.text == body.link.name.text || !says || maps.peek().is_none() {
            return None;
        }
        let confirms = |s: [f64; 3]| {
            let tensor = self.tensor.is_none_or(|tensor| {
                norm(&difference(&mapped(&tensor, &s), &twin.tensor)) <= LOOSE * norm(&twin.tensor)
            });
            let size = body.solids().map(diagonal).fold(0.0, f64::max);
            let center = self.center.is_none_or(|center| is_near(&center, &twin.centre, &s, size));
            tensor && center
        };
        Some(is_same_mass && maps.any(confirms))
    }
}

/// Returns true if a map takes each solid of one link to that of the other.
fn has_solids(body: &Body, twin: &Body, s: &[f64; 3]) -> bool {
    let is_one = |(a, b): (&Volume, &Volume)| {
        let [own, other] = [a, b].map(|solid| elements(&solid.tensor_per_density));
        (a.volume - b.volume).abs() <= EQUAL * a.volume
            && is_near(&a.centroid, &b.centroid, s, diagonal(a))
            && norm(&difference(&mapped(&own, s), &other)) <= EQUAL * norm(&own)
    };
    let count = body.solids().count();
    count > 0 && count == twin.solids().count() && body.solids().zip(twin.solids()).all(is_one)
}

fn mapped(tensor: &Elements, s: &[f64; 3]) -> Elements {
    std::array::from_fn(|k| {
        let (i, j) = PLACES[k];
        s[i] * s[j] * tensor[k]
    })
}

fn is_near(a: &[f64; 3], b: &[f64; 3], s: &[f64; 3], size: f64) -> bool {
    (0..3).all(|k| (s[k] * a[k] - b[k]).abs() <= EQUAL * size)
}

fn diagonal(solid: &Volume) -> f64 {
    let [low, high] = solid.bounds;
    (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_counterparts_have_one_key() {
        for (a, b) in [
            ("l_hip", "r_hip"),
            ("FL_calf", "RR_calf"),
            ("finger_1_prox", "finger_12_prox"),
            ("LHip2", "RHip3"),
            ("kneeLeft", "kneeRight"),
        ] {
            assert_eq!(key(a), key(b));
        }
        assert_ne!(key("hip"), key("l_hip"));
        assert_ne!(key("thigh_left"), key("calf_left"));
        assert_eq!(key("élan_3"), "élan_#");
    }
}
