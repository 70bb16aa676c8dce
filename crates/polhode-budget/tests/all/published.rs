//! Composite bodies of NASA JEOD (fixtures/composite_bodies.toml). Their tensors are given about
//! different points and with both signs.

use polhode::math::{Body, Part, Position};
use polhode_budget::{Basis, GivenPart, GivenTensor, PartsList, Place, ProductSign, Row, TensorPoint};

use crate::lists::{number, numbers};

fn matrix(value: &toml::Value) -> [[f64; 3]; 3] {
    let rows: Vec<_> = value.as_array().unwrap().iter().map(numbers::<3>).collect();
    rows.try_into().unwrap()
}

/// Returns the moments of a part about its centre, along the axes of the body.
fn moments(part: &toml::Table) -> [f64; 3] {
    if let Some(inertia) = part.get("inertia") {
        let m = matrix(inertia);
        return [m[0][0], m[1][1], m[2][2]];
    }
    let [a, b, c] = numbers::<3>(&part["size"]).map(|edge| edge * edge);
    [b + c, a + c, a + b].map(|sum| number(&part["mass"]) * sum / 12.0)
}

/// Returns the moments and products of a part about the origin of the body. Its centre is at p.
fn about_origin(part: &toml::Table, p: Position<Part>) -> ([f64; 3], [f64; 3]) {
    let (m, [x, y, z], i) = (number(&part["mass"]), p.to_array(), moments(part));
    let moments = [i[0] + m * (y * y + z * z), i[1] + m * (x * x + z * z), i[2] + m * (x * x + y * y)];
    (moments, [m * x * y, m * x * z, m * y * z])
}

#[test]
fn jeod_composite_bodies() {
    let path = format!("{}/../../fixtures/composite_bodies.toml", env!("CARGO_MANIFEST_DIR"));
    let table: toml::Table = std::fs::read_to_string(path).unwrap().parse().unwrap();
    for case in table["case"].as_array().unwrap() {
        let mut list = PartsList { rows: vec![Row::frame("body")], ..PartsList::default() };
        for (k, part) in case["part"].as_array().unwrap().iter().enumerate() {
            let part = part.as_table().unwrap();
            let p = Position::from_array(numbers(&part["position"]));
            let mass = number(&part["mass"]);
            let (moments_there, products) = about_origin(part, p);
            let there = GivenTensor {
                moments: moments_there,
                products,
                sign: ProductSign::PositiveIntegral,
                about: TensorPoint::OriginOf("body".to_owned()),
            };
            let here = GivenTensor { moments: moments(part), ..GivenTensor::ZERO };
            let (place, center, tensor) = match k % 3 {
                // in a separate frame about its centre; about the body's origin; and in the body's
                // axes
                0 => (p, Position::ZERO, here),
                1 => (p, Position::ZERO, there),
                _ => (Position::ZERO, p, GivenTensor { about: TensorPoint::At(Position::ZERO), ..there }),
            };
            list.rows.push(Row {
                place: Place { position: place, ..Place::default() },
                ..Row::part(format!("body/{k}"), GivenPart { mass, center_of_mass: center, tensor })
            });
        }
        let body = list.budget().unwrap().mass_properties(Basis::Basic).unwrap();
        let id = case["id"].as_str().unwrap();
        assert!((body.mass() / number(&case["mass"]) - 1.0).abs() < 1e-12, "{id}");
        let center = Position::<Body>::from_array(numbers(&case["center_of_mass"]));
        assert!((body.center_of_mass() - center).norm() < 1e-12, "{id}: {:?}", body.center_of_mass());
        let tensor = match case.get("about") {
            Some(point) => body.inertia_about(Position::from_array(numbers(point))).matrix(),
            None => body.inertia().matrix(),
        };
        let expected = matrix(&case["inertia"]);
        let largest = expected.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        for (got, want) in tensor.iter().flatten().zip(expected.iter().flatten()) {
            assert!((got - want).abs() < 1e-12 * largest, "{id}: {tensor:?}");
        }
    }
}
