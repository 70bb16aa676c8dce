//! Error that explains the evidence of a link: its six tensor elements, mass, geometry and implied
//! density.
//!
//! The geometry implies the tensor of a uniform body with the link's mass. If the written tensor
//! differs, each known error is undone in turn ([`super::explanation`]). If the density is
//! implausible, so is the geometry or the mass. Then each unit of length and each error of the mass
//! is assumed in turn. An assumption is an explanation only if it makes both density and tensor
//! agree.
//!
//! Explanations with fewer errors are preferred. A fix follows if exactly one outcome remains. If
//! two explanations fit equally well and imply different numbers, neither is applied. An
//! explanation is not applied either if it changes an element that another solid of the link
//! confirms.

use super::body::Body;
use super::edit::{multiplied, resized};
use super::explanation::{
    BETTER, Candidates, Fit, LOOSE, SAME, Supposition, TIGHT, compared, describe, percent,
};
use super::material::{is_plausible, is_solid};
use super::placeholder::is_round;
use super::written::short;
use super::{conjugate, factor, finding, formula, order, origin, sign, unit};
use crate::finding::{Finding, Repair, Severity};
use crate::geometry::Volume;
use crate::model::{RobotModel, Slot};
use crate::moments::{difference, norm};

/// Typical errors of a mass: the correction factor and the description.
const MASSES: [(f64, &str); 8] = [
    (0.001, "the mass is in grams"),
    (1000.0, "the mass is in tonnes"),
    (0.453_592_37, "the mass is in pounds"),
    (1.0 / 0.453_592_37, "the mass was divided by 2.2046 twice"),
    (0.1, "the mass is 10 times too large"),
    (10.0, "the mass is 10 times too small"),
    (0.01, "the mass is 100 times too large"),
    (100.0, "the mass is 100 times too small"),
];

/// Maximum number of alternative explanations in a message.
const RIVALS: usize = 3;

/// Explanation of a link's numbers.
#[derive(Debug, Default)]
pub(super) struct Cause {
    /// Error of the tensor.
    pub(super) tensor: Option<Finding>,
    /// Error of the mass, if the density is plausible.
    pub(super) mass: Option<Finding>,
    /// Change that makes an implausible density plausible: a text to follow the density, and the
    /// fix.
    pub(super) density: Option<(String, Option<Repair>)>,
}

/// Returns the explanation of a body's numbers, if there is one.
pub(super) fn cause(model: &RobotModel, body: &Body) -> Cause {
    let is_plausible = body.has_plausible_density();
    let mut fits = with_one_slip(body, is_plausible);
    if fits.is_empty() && !is_plausible {
        fits = with_two_slips(body);
    }
    let Some(choice) = Choice::of(&fits) else {
        return Cause { density: (!is_plausible).then(|| (hint(body), None)), ..Cause::default() };
    };
    choice.cause(model, body, is_plausible)
}

/// Returns explanations with one error: of the geometry's scale, of the mass, or of the tensor.
fn with_one_slip(body: &Body, is_plausible: bool) -> Vec<Fit> {
    let mut fits = Vec::new();
    if is_plausible {
        // Numbers that agree as written need no explanation.
        let solids: Vec<&Volume> = plausible(body).collect();
        if solids.iter().any(|solid| is_of(body, solid, SAME)) {
            return fits;
        }
        for solid in solids {
            fits.append(&mut slips(body, solid, Supposition::NONE));
        }
    }
    for rescaled in &body.geometry.rescaled {
        as_written(body, Supposition { scale: rescaled.factor, mass: 1.0 }, &mut fits);
    }
    for (mass, _) in MASSES {
        as_written(body, Supposition { scale: 1.0, mass }, &mut fits);
    }
    fits
}

/// Returns true if the written tensor agrees with a solid of the written mass.
fn is_of(body: &Body, solid: &Volume, tolerance: f64) -> bool {
    Candidates::of(body, solid, Supposition::NONE).all_agree(tolerance)
}

/// Returns explanations of an implausible density with two errors.
fn with_two_slips(body: &Body) -> Vec<Fit> {
    let mut fits = Vec::new();
    for rescaled in &body.geometry.rescaled {
        let scale = rescaled.factor;
        let supposition = Supposition { scale, mass: 1.0 };
        for solid in supposed(body, supposition) {
            fits.append(&mut slips(body, solid, supposition));
        }
        for (mass, _) in MASSES {
            as_written(body, Supposition { scale, mass }, &mut fits);
        }
    }
    for (mass, _) in MASSES {
        let supposition = Supposition { scale: 1.0, mass };
        // A tensor that follows from the written mass has no error of its own.
        for solid in supposed(body, supposition).into_iter().filter(|solid| !is_of(body, solid, LOOSE)) {
            fits.append(&mut slips(body, solid, supposition));
        }
    }
    fits
}

/// Adds explanations that keep the written tensor, with a different scale or mass.
fn as_written(body: &Body, supposition: Supposition, fits: &mut Vec<Fit>) {
    if is_round(body) {
        return; // a placeholder confirms nothing
    }
    let is_decimal = supposition.mass == 1.0 || supposition.mass.log10().fract().abs() < 1e-9;
    for solid in supposed(body, supposition) {
        let mut candidates = Candidates::of(body, solid, supposition);
        candidates.offer_as_written(if is_decimal { candidates.loose() } else { TIGHT });
        fits.append(&mut candidates.fits);
    }
}

/// Returns the solids whose density is plausible as written.
fn plausible<'m>(body: &Body<'m>) -> impl Iterator<Item = &'m Volume> {
    let mass = body.mass;
    body.solids().filter(move |solid| is_plausible(solid.kind, mass / solid.volume))
}

/// Returns the solids whose density is that of a material under a supposition.
fn supposed<'m>(body: &Body<'m>, supposition: Supposition) -> Vec<&'m Volume> {
    let Supposition { scale, mass } = supposition;
    let has_density = |solid: &&Volume| is_solid(mass * body.mass / solid.volume);
    if scale == 1.0 {
        body.solids().filter(has_density).collect()
    } else {
        body.rescaled(scale).filter(has_density).collect()
    }
}

/// Returns the errors of the tensor that explain it by one solid.
fn slips(body: &Body, solid: &Volume, supposition: Supposition) -> Vec<Fit> {
    let mut candidates = Candidates::of(body, solid, supposition);
    unit::explain(&mut candidates);
    // If programs disagree on the axes, axes are not evidence of an error.
    if !body.geometry.is_turned_by_some {
        order::explain(&mut candidates);
        sign::explain(&mut candidates);
        origin::explain(&mut candidates);
        conjugate::explain(&mut candidates);
        factor::explain(&mut candidates);
        formula::explain(&mut candidates);
    }
    candidates.fits
}

/// Best explanation, and the rivals that fit equally well but imply different numbers.
struct Choice<'f> {
    best: &'f Fit,
    rivals: Vec<&'f Fit>,
}

impl<'f> Choice<'f> {
    fn of(fits: &'f [Fit]) -> Option<Self> {
        let least = fits.iter().map(|fit| fit.misfit).min_by(f64::total_cmp)?;
        // Among equals, the first: simpler errors come first.
        let best = fits.iter().find(|fit| fit.misfit <= 1.1 * least + SAME * LOOSE)?;
        let means_another = |fit: &&Fit| {
            fit.supposition != best.supposition
                || norm(&difference(&fit.tensor, &best.tensor)) > SAME * norm(&best.tensor)
        };
        let bound = BETTER * least.max(SAME);
        let rivals = fits.iter().filter(|fit| fit.misfit <= bound).filter(means_another).collect();
        Some(Self { best, rivals })
    }

    fn cause(&self, model: &RobotModel, body: &Body, is_plausible: bool) -> Cause {
        let Self { best, rivals } = self;
        let may_write = rivals.is_empty() && !body.geometry.is_turned_by_some && !self.is_contradicted(body);
        let mut cause = Cause::default();
        let mut others: Vec<String> = rivals.iter().map(|fit| words(fit)).collect();
        others.dedup();
        let mut or = others.iter().take(RIVALS).map(|other| format!("; or {other}")).collect::<String>();
        if others.len() > RIVALS {
            or.push_str(&format!("; or {} more", others.len() - RIVALS));
        }
        if let Some(slip) = &best.slip {
            let message = format!(
                "{}: as written {}; corrected {} off{or}",
                words(best),
                compared(best.as_written, best.ratio),
                percent(best.misfit),
            );
            let mut found =
                finding(slip.code, Severity::Suspect, body.link, slip.span.clone(), message, slip.rule);
            found.numbers = vec![("misfit", best.as_written), ("misfit_repaired", best.misfit)];
            if may_write && !best.edits.is_empty() {
                let description = describe(body, &best.edits);
                found.repair = Some(Repair { description, edits: best.edits.clone() });
            }
            cause.tensor = Some(found);
        }
        let repair = may_write.then(|| supposed_repair(model, body, best)).flatten();
        if !is_plausible {
            let why = format!("; {}: then {}{or}", words_of(&best.supposition), evidence(body, best));
            cause.density = Some((why, repair));
        } else if best.supposition.mass != 1.0 {
            let why = format!(
                "{}: as written {}; corrected {} off{or}",
                words_of(&best.supposition),
                compared(best.as_written_mass(body), best.supposition.mass),
                percent(best.misfit),
            );
            let span = body.inertial.mass.span();
            let mut found =
                finding("inertia.geometry", Severity::Suspect, body.link, span, why, factor::RULE);
            found.numbers = vec![("misfit_repaired", best.misfit)];
            found.repair = repair;
            cause.mass = Some(found);
        }
        cause
    }

    /// Returns true if another solid with a plausible density confirms an element that the
    /// explanation changes.
    fn is_contradicted(&self, body: &Body) -> bool {
        let Fit { supposition, tensor, .. } = self.best;
        if *supposition != Supposition::NONE {
            return false;
        }
        let size = norm(tensor);
        let changed: Vec<usize> =
            (0..6).filter(|k| (tensor[*k] - body.written[*k]).abs() > SAME * size).collect();
        plausible(body).any(|solid| {
            let candidates = Candidates::of(body, solid, Supposition::NONE);
            let is_nearer = |k: &usize| {
                let [written, right] =
                    [body.written[*k], tensor[*k]].map(|x| (x - candidates.target[*k]).abs());
                candidates.agrees(*k, LOOSE) && written < right
            };
            changed.iter().any(is_nearer)
        })
    }
}

impl Fit {
    /// Returns the misfit of the tensor with the mass as written, if the mass is the error.
    fn as_written_mass(&self, body: &Body) -> f64 {
        // The target is proportional to the mass.
        let target = self.tensor.map(|x| x / self.supposition.mass);
        norm(&difference(&body.written, &target)) / norm(&target)
    }
}

/// Returns the fix of the geometry's scale, or of the mass.
fn supposed_repair(model: &RobotModel, body: &Body, fit: &Fit) -> Option<Repair> {
    let Supposition { scale, mass } = fit.supposition;
    let mut edits = Vec::new();
    let mut changes = Vec::new();
    if scale != 1.0 {
        // The scale applies to all shapes, so all of them must need it.
        let needs_it = |solid: &Volume| is_plausible(solid.kind, mass * body.mass / solid.volume);
        if body.geometry.is_incomplete || !body.rescaled(scale).all(needs_it) {
            return None;
        }
        edits.extend(resized(model, &body.link.geometry, scale)?);
        changes.push(format!("sizes of the geometry × {}", short(scale, 6)));
    }
    if mass != 1.0 {
        let Slot::Given(number) = &body.inertial.mass else { return None };
        let text = multiplied(number, mass)?;
        changes.push(format!("mass {} → {text}", number.text));
        edits.push((number.span.clone(), text));
    }
    let description = format!("{}: {}", changes.join(", "), evidence(body, fit));
    (!edits.is_empty()).then_some(Repair { description, edits })
}

/// Returns the evidence in words: `"2000 kg/m³, and the tensor is 0.1 % off the geometry's tensor"`
fn evidence(body: &Body, fit: &Fit) -> String {
    let solid = supposed(body, fit.supposition).into_iter().next();
    let density = solid.map_or(f64::NAN, |s| fit.supposition.mass * body.mass / s.volume);
    let slip = if fit.slip.is_some() { " (with its own error corrected)" } else { "" };
    format!(
        "{} kg/m³, and the tensor{slip} is {} off the geometry's tensor",
        short(density, 3),
        percent(fit.misfit)
    )
}

fn words(fit: &Fit) -> String {
    match (&fit.slip, fit.supposition.count()) {
        (Some(slip), 0) => slip.mistake.clone(),
        (Some(slip), _) => format!("{} and {}", words_of(&fit.supposition), slip.mistake),
        (None, _) => words_of(&fit.supposition),
    }
}

/// Returns a supposition in words: `"its sizes are in mm"`
fn words_of(supposition: &Supposition) -> String {
    let Supposition { scale, mass } = *supposition;
    let unit = match scale {
        1.0 => None,
        0.001 => Some("its sizes are in mm".to_owned()),
        0.01 => Some("its sizes are in cm".to_owned()),
        0.0254 => Some("its sizes are in inches".to_owned()),
        factor => Some(format!("its sizes are {} times too small", short(factor, 4))),
    };
    let of_mass = MASSES.iter().find(|(factor, _)| *factor == mass).map(|(_, why)| (*why).to_owned());
    unit.into_iter().chain(of_mass).collect::<Vec<_>>().join(", and ")
}

/// Suggests a unit that would make the density plausible, if no change also makes the tensor agree.
fn hint(body: &Body) -> String {
    if let Some(solid) = body.solids().find(|solid| is_of(body, solid, LOOSE)) {
        let in_grams = is_solid(1000.0 * body.mass / solid.volume);
        let density = if in_grams { "density in g/cm³" } else { "wrong density" };
        return format!(
            "; the tensor agrees with this mass, so both may have been computed with a {density}"
        );
    }
    for rescaled in body.geometry.rescaled.iter().filter(|rescaled| rescaled.factor < 1.0) {
        let supposition = Supposition { scale: rescaled.factor, mass: 1.0 };
        if let Some(solid) = supposed(body, supposition).into_iter().next() {
            let density = short(body.mass / solid.volume, 3);
            let what = words_of(&supposition);
            return format!(
                "; if {what}, the density is {density} kg/m³, but the tensor does not confirm it"
            );
        }
    }
    String::new()
}
