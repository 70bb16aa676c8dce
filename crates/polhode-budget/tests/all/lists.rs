//! Parts lists of fixtures/budget.toml.

use polhode::math::{Part, Position, Rotation};
use polhode_budget::{
    CopyErrors, GivenPart, GivenTensor, Group, Growth, PartUncertainty, PartsList, Place, ProductSign,
    Quantity, Row, Spread, TensorPoint, Uncertainty,
};

pub(crate) fn cases() -> Vec<toml::Table> {
    let path = format!("{}/../../fixtures/budget.toml", env!("CARGO_MANIFEST_DIR"));
    let table: toml::Table = std::fs::read_to_string(path).unwrap().parse().unwrap();
    table["case"].as_array().unwrap().iter().map(|case| case.as_table().unwrap().clone()).collect()
}

/// Returns the case with this name.
pub(crate) fn case(name: &str) -> toml::Table {
    cases().into_iter().find(|case| case["name"].as_str() == Some(name)).unwrap()
}

pub(crate) fn number(value: &toml::Value) -> f64 {
    match value {
        toml::Value::String(text) => text.parse().unwrap(),
        toml::Value::Integer(n) => *n as f64,
        value => value.as_float().unwrap(),
    }
}

pub(crate) fn numbers<const N: usize>(value: &toml::Value) -> [f64; N] {
    let all: Vec<f64> = value.as_array().unwrap().iter().map(number).collect();
    all.try_into().unwrap()
}

/// Returns N of 16 numbers, such as the six of a tensor.
fn some<const N: usize>(all: &[f64; 16], first: usize) -> [f64; N] {
    core::array::from_fn(|k| all[first + k])
}

fn vector(value: &toml::Value) -> Position<Part> {
    Position::from_array(numbers(value))
}

pub(crate) fn list(case: &toml::Table) -> PartsList {
    let group = |name: &str| {
        let [mass, center, tensor, position, rotation] = numbers(&case[name]);
        Group { name: name.to_owned(), mass, center, tensor, position, rotation, density: 0.0 }
    };
    let rows = case["row"].as_array().unwrap().iter().map(|row| self::row(row.as_table().unwrap()));
    PartsList { rows: rows.collect(), groups: vec![group("g0"), group("g1")], ..PartsList::default() }
}

fn row(row: &toml::Table) -> Row {
    let text = |key: &str| row.get(key).map(|value| value.as_str().unwrap().to_owned());
    let sd = numbers::<16>(&row["sd"]);
    let [xx, yy, zz, xy, xz, yz] = numbers(&row["tensor"]);
    let part = row.get("mass").map(|mass| GivenPart {
        mass: number(mass),
        center_of_mass: vector(&row["center"]),
        tensor: GivenTensor {
            moments: [xx, yy, zz],
            products: [xy, xz, yz],
            sign: match row["sign"].as_str().unwrap() {
                "positive" => ProductSign::PositiveIntegral,
                _ => ProductSign::NegativeIntegral,
            },
            about: row.get("about").map_or(TensorPoint::CenterOfMass, |point| TensorPoint::At(vector(point))),
        },
    });
    Row {
        name: text("name").unwrap(),
        parent: text("parent"),
        quantity: Quantity {
            count: number(&row["count"]) as u32,
            errors: if row["alike"].as_bool().unwrap() { CopyErrors::Alike } else { CopyErrors::Independent },
        },
        place: Place {
            position: vector(&row["position"]),
            rotation: Rotation::from_quaternion(numbers(&row["rotation"])).unwrap(),
        },
        part,
        uncertainty: Uncertainty {
            part: PartUncertainty::Separate {
                mass: sd[0],
                tensor_follows_mass: row["follows"].as_bool().unwrap(),
                center: Spread::Deviations(some(&sd, 1)),
                tensor: Spread::Deviations(some(&sd, 4)),
            },
            position: Spread::Deviations(some(&sd, 10)),
            rotation: Spread::Deviations(some(&sd, 13)),
        },
        group: text("group"),
        growth: Growth::Fraction(number(&row["growth"])),
        subtotal: None,
        allowable: None,
    }
}
