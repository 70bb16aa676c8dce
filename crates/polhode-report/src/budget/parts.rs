//! Where the parts are: a picture.

use polhode::body::MassProperties;
use polhode::math::Body;
use polhode_budget::Basis;

use super::case::Case;
use crate::explain::document::Section;
use crate::explain::drawing::{Drawing, Solid, Solids};
use crate::layout::printable;
use crate::number::{count, number, tidy};

/// Parts that are drawn: more would hide each other.
const MOST: usize = 150;
/// Parts that are listed.
const ROWS: usize = 20;
/// Where lengths are read in mm, m.
const SHORT: f64 = 10.0;
/// Groups that have a colour.
const GROUPS: usize = 7;

/// `None` of a list whose parts are no numbers.
pub(super) fn section(case: &Case, basis: Basis) -> Option<Section> {
    let mut section = Section::new(6, "Where the parts are");
    let drawn = solids(case, basis)?;
    let extent =
        drawn.solids.iter().flat_map(|solid| solid.center).fold(0.0_f64, |most, x| most.max(x.abs()));
    let (unit, scale) = if extent < SHORT { ("mm", 1e3) } else { ("m", 1.0) };
    section.say(format!("The heaviest parts, with their centres of mass and the boxes that have their inertia tensors, along the box's own axes, in {unit}."));
    let row = |solid: &Solid| {
        let [x, y, z] = tidy(solid.center).map(|x| number(scale * x, 4));
        let sides = solid.halves.map(|half| half.iter().map(|x| x * x).sum::<f64>().sqrt());
        let is_point = sides.iter().all(|half| *half == 0.0);
        let sides = sides.map(|half| number(2.0 * scale * half, 3)).join(" × ");
        let sides = if is_point { "a point".to_owned() } else { sides };
        vec![printable(&solid.name), x, y, z, sides]
    };
    section.table(&["part", "x", "y", "z", "box"], drawn.solids.iter().take(ROWS).map(row).collect());
    // All the mass in the origin has no extent that could be drawn.
    let is_somewhere = |solid: &Solid| solid.halves.iter().flatten().chain(&solid.center).any(|x| *x != 0.0);
    if drawn.solids.iter().any(is_somewhere) {
        section.draw(Drawing::Solids(drawn));
    }
    Some(section)
}

pub(super) fn solids(case: &Case, basis: Basis) -> Option<Solids> {
    let parts = case.budget.parts(basis).ok()?;
    let mut all: Vec<(usize, MassProperties<Body>)> =
        parts.into_iter().enumerate().filter_map(|(k, part)| Some((k, part?))).collect();
    let left_out = all.len().saturating_sub(MOST);
    all.sort_by(|(_, a), (_, b)| b.mass().total_cmp(&a.mass()));
    all.truncate(MOST);
    let heads = heads(case);
    let mut groups: Vec<usize> = Vec::new();
    for (k, _) in &all {
        if !groups.contains(&heads[*k]) && groups.len() < GROUPS {
            groups.push(heads[*k]);
        }
    }
    let solid = |(k, part): &(usize, MassProperties<Body>)| Solid {
        name: case.short(*k).to_owned(),
        center: part.center_of_mass().to_array(),
        halves: halves(part),
        group: groups.iter().position(|head| *head == heads[*k]).unwrap_or(GROUPS),
    };
    let whole = case.estimate(basis).properties;
    let frame = whole.principal();
    let of_many = match left_out {
        0 => String::new(),
        n => format!(" Of all parts the {MOST} heaviest are drawn, and {} are not.", count(n as u64)),
    };
    Some(Solids {
        title: "Parts, centre of mass and principal axes".to_owned(),
        caption: format!(
            "Each part is drawn as the box that has its mass, centre of mass and inertia tensor; a point is a small cube. All views but the last have one scale.{of_many}"
        ),
        solids: all.iter().map(solid).collect(),
        groups: groups.iter().map(|&k| case.short(k).to_owned()).collect(),
        center: whole.center_of_mass().to_array(),
        axes: [0, 1, 2].map(|k| frame.axis(k).to_array()),
    })
}

/// Of each row the one below the root that it is in; the root of itself.
fn heads(case: &Case) -> Vec<usize> {
    let parents = case.budget.parents();
    let root = case.budget.root();
    (0..parents.len())
        .map(|row| {
            let mut head = row;
            while let Some(parent) = parents[head].filter(|parent| *parent != root) {
                head = parent;
            }
            head
        })
        .collect()
}

/// Of the box with these mass properties: ∫x² dm = m h²/3 along each axis.
fn halves(part: &MassProperties<Body>) -> [[f64; 3]; 3] {
    let frame = part.principal();
    let moments = frame.moments();
    let sum: f64 = moments.iter().sum();
    [0, 1, 2].map(|k| {
        let second = (0.5 * sum - moments[k]).max(0.0);
        let half = (3.0 * second / part.mass()).sqrt();
        frame.axis(k).to_array().map(|x| half * x)
    })
}
