//! Section of the report on the places of the parts, with a picture.

use polhode::body::MassProperties;
use polhode::math::Body;
use polhode_document::Section;
use polhode_document::drawing::{Drawing, Solid, Solids};
use polhode_document::layout::printable;
use polhode_document::number::{count, number, tidy};

use super::case::Case;
use crate::Basis;

/// Largest number of parts in the picture. More would hide each other.
const MOST: usize = 150;
/// Number of parts in the table.
const ROWS: usize = 20;
/// Extent below which lengths are shown in mm, m.
const SHORT: f64 = 10.0;
/// Number of groups that have a colour.
const GROUPS: usize = 7;

pub(crate) fn section(case: &Case, basis: Basis) -> Section {
    let mut section = Section::new(6, "Part positions");
    let drawn = solids(case, basis);
    let extent =
        drawn.solids.iter().flat_map(|solid| solid.center).fold(0.0_f64, |most, x| most.max(x.abs()));
    let (unit, scale) = if extent < SHORT { ("mm", 1e3) } else { ("m", 1.0) };
    section.say(format!("Heaviest parts: centre of mass, and sides of the box with the same inertia tensor (along its own axes), in {unit}."));
    let row = |solid: &Solid| {
        let [x, y, z] = tidy(solid.center).map(|x| number(scale * x, 4));
        let sides = solid.halves.map(|half| half.iter().map(|x| x * x).sum::<f64>().sqrt());
        let is_point = sides.iter().all(|half| *half == 0.0);
        let sides = sides.map(|half| number(2.0 * scale * half, 3)).join(" × ");
        let sides = if is_point { "a point".to_owned() } else { sides };
        vec![printable(&solid.name), x, y, z, sides]
    };
    section.table(&["part", "x", "y", "z", "box"], drawn.solids.iter().take(ROWS).map(row).collect());
    // If all mass is at the origin, there is nothing to draw.
    let is_somewhere = |solid: &Solid| solid.halves.iter().flatten().chain(&solid.center).any(|x| *x != 0.0);
    if drawn.solids.iter().any(is_somewhere) {
        section.draw(Drawing::Solids(drawn));
    }
    section
}

pub(crate) fn solids(case: &Case, basis: Basis) -> Solids {
    let (left_out, all) = heaviest(case, basis);
    let head = |(k, _): &(usize, MassProperties<Body>)| head(case, *k);
    let heads: Vec<usize> = all.iter().map(head).collect();
    let mut groups: Vec<usize> = Vec::new();
    for head in &heads {
        if !groups.contains(head) && groups.len() < GROUPS {
            groups.push(*head);
        }
    }
    let solid = |((k, part), own): (&(usize, MassProperties<Body>), &usize)| Solid {
        name: case.short(*k).to_owned(),
        center: part.center_of_mass().to_array(),
        halves: halves(part),
        group: groups.iter().position(|head| head == own).unwrap_or(GROUPS),
    };
    let whole = case.estimate(basis).properties;
    let frame = whole.principal();
    let of_many = match left_out {
        0 => String::new(),
        n => format!(" Only the {MOST} heaviest parts are drawn; {} are not.", count(n as u64)),
    };
    Solids {
        title: "Parts, centre of mass and principal axes".to_owned(),
        caption: format!(
            "Each part is drawn as the box with the same mass, centre of mass and inertia tensor; a point mass is a small cube. All views except the last have the same scale.{of_many}"
        ),
        solids: all.iter().zip(&heads).map(solid).collect(),
        groups: groups.iter().map(|&k| case.short(k).to_owned()).collect(),
        center: whole.center_of_mass().to_array(),
        axes: [0, 1, 2].map(|k| frame.axis(k).to_array()),
    }
}

/// Row index and mass properties of a part.
type Part = (usize, MassProperties<Body>);

/// Returns the number of parts that are left out, and the heaviest parts in descending order.
fn heaviest(case: &Case, basis: Basis) -> (usize, Vec<Part>) {
    // A report has no parts that overflow.
    let own = |k: usize| case.budget.own(k, basis).ok().flatten();
    let (mut masses, mut count) = (Vec::new(), 0);
    for k in 0..case.budget.rows().len() {
        let Some(part) = own(k) else { continue };
        count += 1;
        masses.push((k, part.mass()));
        if masses.len() > 2 * MOST {
            shorten(&mut masses);
        }
    }
    shorten(&mut masses);
    let parts = masses.into_iter().filter_map(|(k, _)| Some((k, own(k)?)));
    (count - count.min(MOST), parts.collect())
}

fn shorten(masses: &mut Vec<(usize, f64)>) {
    masses.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    masses.truncate(MOST);
}

/// Returns the child of the root that contains a row. For the root, returns the root itself.
fn head(case: &Case, row: usize) -> usize {
    let root = case.budget.root();
    let mut head = row;
    while let Some(parent) = case.budget.parent(head).filter(|parent| *parent != root) {
        head = parent;
    }
    head
}

/// Returns the half axes of the box with these mass properties: ∫x² dm = m h²/3 along each axis.
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
