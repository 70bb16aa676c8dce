//! Facts next to the picture: about the motion, the body, and the page itself.

use polhode::motion::Scenario;
use polhode_document::fact::{Fact, Facts, Quantity};
use polhode_document::number::{count, tidy, tidy_matrix, vector};
use polhode_document::unit;
use polhode_shape::report::block::Geometry;
use serde_json::Value;

use super::motion::Shown;
use super::turning::Turning;
use crate::report::facts::{self, Known};
use crate::report::sampling::largest_turn;

/// Largest rotation between samples that a picture can show correctly, rad.
const LARGEST_TURN: f64 = 1.0;

pub(crate) fn json(known: &Known<'_>, turning: &Turning<'_>, shown: &Shown<'_>, notes: &[String]) -> Value {
    let body = known.scenario.map_or_else(Vec::new, |scenario| body(scenario, turning));
    let mut sections = vec![Facts::new("Body", body), Facts::new("Inertia", inertia(turning))];
    sections.extend(facts::of(known));
    sections.push(Facts::new("This page", this_page(shown, notes)));
    sections.iter().filter_map(Facts::to_rows).collect()
}

fn body(scenario: &Scenario, turning: &Turning<'_>) -> Vec<Fact> {
    let body = scenario.body();
    let geometry = Geometry::of_parts(scenario.parts(), body.mass());
    let place = |v: [f64; 3]| Quantity::Text(unit::place_in(unit::size(body), tidy(v)));
    let lever = Quantity::Number(turning.lever.norm(), "m");
    vec![
        Fact::shown("mass", Quantity::Number(body.mass(), "kg")).note(at_start(turning)),
        Fact::shown("volume", geometry.volume.map(|volume| Quantity::Number(volume, "m³"))),
        Fact::shown("density", geometry.density.map(|density| Quantity::Number(density, "kg/m³")))
            .note("mean"),
        Fact::shown("centre of mass", place(body.center_of_mass().to_array())).note("body axes"),
        Fact::shown("pivot", place(turning.point.to_array())).note("body axes").shown_if(turning.is_pivoted),
        Fact::shown("lever", lever).note("from the pivot to the centre of mass").shown_if(turning.is_pivoted),
    ]
}

/// Returns the remark for values of a body that changes with time.
const fn at_start(turning: &Turning<'_>) -> &'static str {
    if turning.is_changing { "at the start" } else { "" }
}

fn inertia(turning: &Turning<'_>) -> Vec<Fact> {
    let principal = &turning.principal;
    let [i1, i2, i3] = principal.moments().map(|i| Quantity::Number(i, "kg·m²"));
    let [e1, e2, e3] = principal.axes().map(|axis| vector(tidy(axis.to_array()), 5));
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = tidy_matrix(turning.tensor);
    let about = Quantity::Text(format!("the {}", turning.about()));
    let symmetry = Quantity::Text(principal.symmetry().name().to_owned());
    vec![
        Fact::shown("i1, least", i1).note(format!("axis 1 = {e1} in the body")),
        Fact::shown("i2", i2).note(format!("axis 2 = {e2}")),
        Fact::shown("i3, greatest", i3).note(format!("axis 3 = {e3}")),
        Fact::shown("about", about).note(at_start(turning)),
        Fact::shown("symmetry", symmetry).note(principal.symmetry().freedom()),
        Fact::shown("Ixx, Iyy, Izz", Quantity::Vector([xx, yy, zz], "kg·m²")).note("body axes"),
        Fact::shown("Ixy, Ixz, Iyz", Quantity::Vector([xy, xz, yz], "kg·m²")).note("−∫xy dm, …"),
    ]
}

/// Returns facts about the page: number of samples, omitted details.
fn this_page(shown: &Shown<'_>, notes: &[String]) -> Vec<Fact> {
    let [here, all] = [shown.samples.len(), shown.of].map(|n| n as u64);
    let note = if here == all { String::new() } else { format!("of {}, evenly chosen", count(all)) };
    let turn = largest_turn(shown.samples.iter().copied());
    let far = Fact::shown("turn between samples", Quantity::Angle(turn))
        .note("at most: too large to resolve; use a shorter sample interval")
        .shown_if(turn > LARGEST_TURN);
    let samples = Fact::shown("samples", Quantity::Count(here)).note(note);
    let notes = notes.iter().map(|note| Fact::shown("body", note.clone()));
    [samples, far].into_iter().chain(notes).collect()
}
