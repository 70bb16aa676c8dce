//! Worked solution: from mass to motion in the six steps of the lecture notes.
//!
//! Each step has its own module. `working` holds their common data; they write into a `Document`.

mod answer;
mod attitude;
mod axes;
mod body;
mod contact;
mod driven;
mod elliptic;
mod euler;
mod free;
mod inside;
mod linear;
mod pendulum;
mod rows;
mod shape;
mod shape_formula;
mod spin;
mod symbols;
mod tensor;
mod top;
mod working;

use std::borrow::Cow;

use polhode::motion::{MotionError, Scenario, Trajectory};
use polhode_document::{Document, Section};

use crate::symbolic::Exact;
use inside::Inside;
use working::Working;

/// Returns the worked solution of a scenario, in the order of the lecture notes.
///
/// The steps are: 0 the body; 1 the axes; 2 ω and N; 3 the inertia tensor and its principal axes; 4
/// Euler's equations; 5 their solution; 6 the attitude.
///
/// A body on the ground has the constraint and the forces in step 2, the equations with them in
/// step 4, and what the run shows in step 6.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::Prescribed;
/// use polhode::body::BodyPart;
/// let particles = vec![
///     Particle::new(1.2, Position::new(0.0, 0.0, 0.5))?,
///     Particle::new(0.7, Position::new(0.0, 0.0, -0.5))?,
/// ];
/// let body = mass_properties_of_particles(&particles)?;
/// let part = BodyPart {
///     name: "masses".to_owned(),
///     kind: "particles",
///     properties: body,
///     extent: None,
///     surface_area: None,
///     particles,
///     form: None,
/// };
/// let led = Prescribed::fixed_axis(Attitude::identity(), Direction::new(0.0, 3.0, 4.0), 2.0, 0.0)?;
/// let scenario =
///     Scenario::new(body).titled("A dumbbell").made_of(vec![part]).held_at(Position::ZERO)?.prescribed_as(led)?;
/// let solution = polhode_scenario::report::explain(&scenario)?;
/// // N = −(m1 + m2) b² ω² sin α cos α = −1.9 · 0.25 · 4 · 0.48
/// assert!(solution.to_text(100).contains("N = (-0.912, 0, 0) N·m"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`MotionError`] if the scenario's run cannot be computed, or its pendulum cannot hang.
pub fn explain(scenario: &Scenario) -> Result<Document, MotionError> {
    explain_exactly(scenario, &Exact::None)
}

/// Returns the worked solution of a scenario, with exact formulas before the numbers where the file
/// has them.
///
/// # Errors
/// As [`explain`].
pub fn explain_exactly(scenario: &Scenario, exact: &Exact) -> Result<Document, MotionError> {
    Ok(solved(&Working { exact, ..Working::of(scenario)? }))
}

/// Returns the steps from the masses to the principal moments in exact formulas, without numbers;
/// `None` if there are none.
///
/// # Errors
/// [`MotionError`] if the scenario has no worked solution.
pub fn exact_tensor(scenario: &Scenario, exact: &Exact) -> Result<Option<Document>, MotionError> {
    let w = Working::with(scenario, None)?;
    let mut section = Section::new(0, "Exact formulas");
    let moments = w.rotor.principal().moments();
    match exact {
        Exact::Symbols(symbolic) => {
            symbols::body(symbolic, &mut section);
            symbols::tensor(symbolic, w.point_name(), moments, &mut section);
        }
        Exact::Fractions(symbolic) => symbols::fractions(symbolic, moments, &mut section),
        Exact::Gap(_) | Exact::None => {}
    }
    let document = Document {
        findings: Vec::new(),
        title: w.title(),
        verdict: None,
        answer: Vec::new(),
        sections: vec![section],
    };
    Ok(document.sections.iter().any(|section| !section.blocks.is_empty()).then_some(document))
}

/// Returns the worked solution of a scenario whose motion is known: as [`explain_exactly`], without
/// computing it again.
///
/// # Errors
/// [`MotionError`] if the scenario's pendulum cannot hang.
pub fn explain_motion(
    scenario: &Scenario,
    trajectory: &Trajectory,
    exact: &Exact,
) -> Result<Document, MotionError> {
    Ok(solved(&Working { exact, ..Working::with(scenario, Some(Cow::Borrowed(trajectory)))? }))
}

fn solved(w: &Working<'_>) -> Document {
    if let Some(document) = contact::document(w) {
        return document;
    }
    let inside = Inside::of(w);
    let equations = inside.as_ref().map_or_else(|| euler::section(w), Inside::equations);
    let solution = inside.as_ref().map_or_else(|| solution(w), Inside::solution);
    let mut sections = vec![
        body::section(w),
        axes::section(w),
        spin::section(w),
        tensor::section(w, inside.as_ref()),
        equations,
        solution,
        attitude::section(w, inside.as_ref()),
    ];
    for section in &mut sections {
        let names = derivations(section.number, w);
        if !names.is_empty() {
            section.say(format!("Derivations (polhode explain --derive NAME): {}.", names.join(", ")));
        }
    }
    Document {
        findings: w.findings(),
        title: w.title(),
        verdict: None,
        answer: answer::lines(w, inside.as_ref()),
        sections,
    }
}

/// Returns the names of the derivations that lead to the equations of a step.
fn derivations(step: u8, w: &Working<'_>) -> &'static [&'static str] {
    let is_symmetric = w.at_start.as_ref().is_some_and(|free| free.top.is_some());
    match step {
        2 => &["kinetic-energy"],
        3 => &["inertia-tensor", "parallel-axes", "principal-axes", "angular-momentum"],
        4 if w.needed.is_some() => &["torque", "euler-equations", "dumbbell"],
        4 => &["torque", "euler-equations"],
        5 if w.pendulum.is_some() => &["pendulum-frequency"],
        5 if w.is_free() && is_symmetric => &["symmetric-top", "coplanar", "cones"],
        5 if w.is_free() => &["energy-and-momentum"],
        _ => &[],
    }
}

/// Writes step 5, selected by the kind of motion.
fn solution(w: &Working<'_>) -> Section {
    let mut section = Section::new(5, "Solve for ω(t)");
    if let Some(pendulum) = &w.pendulum {
        if let Some(symbolic) = w.exact.symbols() {
            symbols::pendulum(symbolic, pendulum, &mut section);
        }
        pendulum::solve(w, pendulum, &mut section);
    }
    if let Some(top) = top::of(w) {
        top::solve(w, &top, &mut section);
    }
    if w.needed.is_some() {
        driven::given(w, &mut section);
    } else if w.is_free() {
        free::solve(w, &mut section);
    } else {
        if w.pendulum.is_none() && top::of(w).is_none() {
            linear::solve(w, &mut section);
        }
        driven::integrate(w, &mut section);
    }
    section
}
