//! Tanks in the words of the file.

use polhode::body::MassProperties;
use polhode::math::Part;
use polhode_document::number::{number, vector};

use super::item::Item;
use super::words::{names, point};
use crate::read::{FilledTank, Prescribed};
use crate::{Liquid, LiquidTable, Measured, TankShape, Vessel};

/// Returns the statements about the tanks of all configurations.
pub(crate) fn items(prescribed: &Prescribed, digits: usize) -> Vec<Item> {
    let mut all: Vec<(&FilledTank, Vec<String>)> = Vec::new();
    for (name, _, tanks) in prescribed.dry() {
        for tank in tanks {
            let known = all.iter().position(|(other, _)| other.tank.name == tank.tank.name);
            let k = known.unwrap_or(all.len());
            if known.is_none() {
                all.push((tank, Vec::new()));
            }
            all[k].1.extend(name.map(str::to_owned));
        }
    }
    all.iter().flat_map(|(tank, configurations)| of_tank(tank, configurations, digits)).collect()
}

/// Returns the statements about a tank: its description, and each row of its table. The amount in
/// it and its error are in the tank's row of the list.
fn of_tank(tank: &FilledTank, configurations: &[String], digits: usize) -> Vec<Item> {
    let name = &tank.tank.name;
    let mut words = vec![format!("frame {}", tank.tank.frame)];
    if !configurations.is_empty() {
        words.push(format!("configuration {}", names(configurations)));
    }
    let mut rows = Vec::new();
    match &tank.tank.liquid {
        Liquid::Vessel(vessel) => words.extend(of_vessel(vessel, digits)),
        Liquid::Table(table) => {
            words.push("by a table".to_owned());
            rows = of_table(table, digits);
        }
    }
    // The effect of a density error depends on this. The standard deviations do not show it if that
    // of the amount is 0.
    if tank.errors.density > 0.0 {
        words.push(match tank.errors.measured {
            Measured::Mass => "measured by mass".to_owned(),
            Measured::Fill => "measured by fill".to_owned(),
        });
    }
    // An empty tank has no row.
    if tank.mass == 0.0 && tank.errors.density > 0.0 {
        words.push(format!("density_sd {} %", number(100.0 * tank.errors.density, digits)));
        words.extend(tank.group.iter().map(|group| format!("group {group}")));
    }
    let of = format!(" of the table of the tank {name}");
    let rows = rows.into_iter().map(|row| Item::of_several("row", of.clone(), row));
    [Item::new(format!("tank {name}"), words.join("; "))].into_iter().chain(rows).collect()
}

fn of_vessel(vessel: &Vessel, digits: usize) -> [String; 3] {
    let mm = |x: f64| number(1e3 * x, digits);
    let shape = match *vessel.shape() {
        TankShape::Box(size) => format!("box, size {} mm", size.map(mm).join(" × ")),
        TankShape::Ellipsoid(axes) if axes == [axes[0]; 3] => format!("sphere, radius {} mm", mm(axes[0])),
        TankShape::Ellipsoid(axes) => format!("ellipsoid, semi_axes {} mm", axes.map(mm).join(" × ")),
        TankShape::Cylinder { radius, length, ends: [low, high] } => format!(
            "cylinder, radius {} mm, length {} mm, ends {} and {} mm",
            mm(radius),
            mm(length),
            mm(low),
            mm(high)
        ),
    };
    let density = format!("density {} kg/m³", number(vessel.density(), digits));
    [shape, density, format!("settles {}", vessel.down().name())]
}

fn of_table(table: &LiquidTable, digits: usize) -> Vec<String> {
    let row = |(k, body): (usize, &MassProperties<Part>)| {
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = body.inertia().matrix();
        let level = table.levels().and_then(|levels| levels.get(k));
        let level =
            level.map_or_else(String::new, |level| format!(", level {} mm", number(1e3 * level, digits)));
        format!(
            "mass {} kg{level}, center {}, moments {} kg·m², products {} kg·m²",
            number(body.mass(), digits),
            point(body.center_of_mass().to_array(), digits),
            vector([xx, yy, zz], digits),
            vector([xy, xz, yz], digits)
        )
    };
    table.rows().iter().enumerate().map(row).collect()
}
