//! Changes of all rows.

use std::collections::{HashMap, HashSet};

use polhode::body::MassProperties;
use polhode::math::Part;
use polhode_document::layout::printable;
use polhode_document::number::number;
use serde_json::{Value, json};

use super::change::{Change, Changes, from_to};
use super::errors::{self, Deviation};
use crate::report::case::Case;
use crate::{CopyErrors, GivenTensor, Growth, Row, Subtotal};

/// Relative rounding error of a change of units.
const ROUNDING: f64 = 1e-12;

/// Returns the changes in the order of the rows of the second list, followed by the removed rows.
pub(crate) fn changes(cases: [&Case; 2]) -> Vec<Change> {
    let [old, new] = cases.map(|case| case.budget.rows());
    let old_names: HashMap<&str, usize> = (0..old.len()).map(|k| (old.name(k), k)).collect();
    let new_names: HashSet<&str> = (0..new.len()).map(|k| new.name(k)).collect();
    let mut all = Vec::new();
    for k in 0..new.len() {
        let mut changes = Changes { row: new.name(k), all: &mut all };
        match old_names.get(new.name(k)) {
            None => appeared(&mut changes, "added", cases[1], k),
            Some(&other) => differences(&mut changes, cases, [other, k]),
        }
    }
    for k in (0..old.len()).filter(|k| !new_names.contains(old.name(*k))) {
        appeared(&mut Changes { row: old.name(k), all: &mut all }, "removed", cases[0], k);
    }
    all
}

/// Adds a row that only one list has, with the mass of all copies of its own part.
fn appeared(changes: &mut Changes<'_>, what: &'static str, case: &Case, row: usize) {
    let copies = f64::from(case.budget.rows().quantity(row).count);
    let mass = case.budget.given(row).map_or(0.0, |part| copies * part.mass());
    let words = match mass {
        0.0 => format!("{what}, a frame"),
        mass => format!("{what}, with {} kg", number(mass, 6)),
    };
    let both = if what == "added" { [None, Some(mass)] } else { [Some(mass), None] };
    changes.pair(what, both, words);
}

fn differences(changes: &mut Changes<'_>, cases: [&Case; 2], rows: [usize; 2]) {
    let [before, after] = [0, 1].map(|side| cases[side].budget.rows().get(rows[side]));
    let [before, after] = [&before, &after];
    let parents = [0, 1].map(|side| {
        let budget = &cases[side].budget;
        budget.parent(rows[side]).map(|parent| budget.rows().name(parent).to_owned())
    });
    if parents[0] != parents[1] {
        let [was, is] =
            parents.each_ref().map(|name| name.as_deref().map_or_else(|| "nothing".to_owned(), printable));
        changes.pair("parent", parents, format!("parent {was} to {is}"));
    }
    let [was, is] = [before, after].map(|row| row.quantity);
    if was.count != is.count {
        changes.pair("quantity", [was.count, is.count], format!("quantity {} to {}", was.count, is.count));
    }
    let copies = |errors: &CopyErrors| errors.name().to_owned();
    let in_json = |errors: &CopyErrors| errors.name().into();
    changes.unequal(["copies"; 2], [Some(was.errors), Some(is.errors)], copies, in_json);
    part(changes, cases, rows, [before, after]);
    let growths = [0, 1].map(|side| cases[side].budget.growth(rows[side]));
    if !near(growths[0], growths[1]) {
        let [was, is] = growths.map(|growth| number(100.0 * growth, 4));
        changes.pair("growth", growths, format!("growth allowance {was} % to {is} %"));
    }
    let allowable = [before.allowable, after.allowable];
    changes.unequal(
        ["allowable", "allowable mass"],
        allowable,
        |x| format!("{} kg", number(*x, 6)),
        |x| (*x).into(),
    );
    let codes = [before, after].map(|row| match &row.growth {
        Growth::Code(code) => Some(code),
        Growth::None | Growth::Fraction(_) => None,
    });
    changes.unequal(["maturity"; 2], codes, |code| printable(code), |code| code.as_str().into());
    let subtotals = [0, 1].map(|side| cases[side].subtotal(rows[side]));
    let stated = |one: &Subtotal| format!("{} ± {} kg", number(one.mass, 9), number(one.tolerance, 3));
    let in_json = |one: &Subtotal| json!({ "mass": one.mass, "tolerance": one.tolerance });
    changes.unequal(["subtotal"; 2], subtotals, stated, in_json);
    let groups = [&before.group, &after.group].map(Option::as_ref);
    changes.unequal(["group"; 2], groups, |group| printable(group), |group| group.as_str().into());
    if let Some(all) = errors::changed([before, after]) {
        let of = |one: &Deviation, side: usize| (one.name.to_owned(), Value::from(one.sd[side]));
        let both = [0, 1].map(|side| Value::Object(all.iter().map(|one| of(one, side)).collect()));
        let words: Vec<String> = all.iter().map(Deviation::words).collect();
        let words = if words.is_empty() {
            "its error correlations changed".to_owned()
        } else {
            format!("sd of {}", words.join(", of "))
        };
        changes.pair("uncertainty", both, words);
    }
}

/// Compares the mass of one copy of a row's own part, its place and its tensor.
fn part(changes: &mut Changes<'_>, cases: [&Case; 2], rows: [usize; 2], [before, after]: [&Row; 2]) {
    let parts = [0, 1].map(|side| cases[side].budget.given(rows[side]));
    let masses = parts.map(|part| part.map_or(0.0, |part| part.mass()));
    if !near(masses[0], masses[1]) {
        let word = if masses[1] > masses[0] { "heavier" } else { "lighter" };
        changes.pair("mass", masses, format!("{word}: {}", from_to(masses[0], masses[1], "kg")));
    }
    let mut distance = (after.place.position - before.place.position).norm();
    let size = after.place.position.max_abs().max(before.place.position.max_abs());
    let mut is_moved = distance > ROUNDING * size;
    if let [Some(was), Some(is)] = parts {
        let by = (is.center_of_mass() - was.center_of_mass()).norm();
        let size = is.center_of_mass().max_abs().max(was.center_of_mass().max_abs());
        if by > ROUNDING * size {
            // Displacement by both changes together, along the axes of the parent's frame.
            let [was, is] = [(before, was), (after, is)]
                .map(|(row, part)| row.place.position + row.place.rotation * part.center_of_mass());
            (is_moved, distance) = (true, (is - was).norm());
        }
        // The tensor of a part that is only heavier changes in proportion to the mass.
        if let Some(by) = tensor_change([before, after], [&was, &is]) {
            let percent = number(100.0 * by, 3);
            changes.by("tensor", by, format!("its inertia tensor changed by up to {percent} %"));
        }
    }
    if is_moved {
        changes.by("moved", distance, format!("moved by {} mm", number(1e3 * distance, 4)));
    }
    let angle = (after.place.rotation * before.place.rotation.inverse()).angle();
    if angle > ROUNDING {
        changes.by("turned", angle, format!("turned by {} deg", number(angle.to_degrees(), 4)));
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUNDING * a.abs().max(b.abs())
}

/// Returns the change of the tensor per kilogram, relative to its greatest element. The tensor is
/// about the centre of mass, or as given. Returns `None` if the change is within rounding.
fn tensor_change(rows: [&Row; 2], parts: [&MassProperties<Part>; 2]) -> Option<f64> {
    /// Rounding threshold about the centre of mass. The conversion from another point loses digits.
    const OF_CENTER: f64 = 1e-9;
    let own = parts.map(|part| {
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = part.inertia().matrix();
        [xx, yy, zz, xy, xz, yz].map(|x| x / part.mass())
    });
    let of_center = change(own, OF_CENTER);
    let [Some(was), Some(is)] = rows.map(|row| row.part.as_ref().map(|part| &part.tensor)) else {
        return of_center;
    };
    if was.about != is.about || was.sign != is.sign {
        return of_center;
    }
    let of = |tensor: &GivenTensor, mass: f64| {
        let ([xx, yy, zz], [xy, xz, yz]) = (tensor.moments, tensor.products);
        [xx, yy, zz, xy, xz, yz].map(|x| x / mass)
    };
    of_center.or(change([of(was, parts[0].mass()), of(is, parts[1].mass())], ROUNDING))
}

/// Returns the greatest difference relative to the greatest number, if it exceeds the rounding
/// error.
fn change([was, is]: [[f64; 6]; 2], rounding: f64) -> Option<f64> {
    let greatest = was.iter().chain(&is).fold(0.0_f64, |most, x| most.max(x.abs()));
    let by = was.iter().zip(&is).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    (by > rounding * greatest).then(|| by / greatest)
}
