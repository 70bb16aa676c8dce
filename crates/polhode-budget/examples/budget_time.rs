//! Time of a budget of 100,000 parts:
//! `cargo run --release -p polhode-budget --example budget_time`.

use std::time::Instant;

use polhode::math::{Position, Rotation};
use polhode_budget::{
    Basis, GivenPart, GivenTensor, Group, Growth, GrowthTable, PartUncertainty, PartsList, Place,
    ProductSign, Quantity, Row, Spread, TensorPoint, Uncertainty,
};

const PARTS: usize = 100_000;
/// Number of parts in a frame.
const IN_FRAME: usize = 50;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut state = 1_u64;
    let mut number = |size: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        size * ((state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    };
    let mut rows = vec![Row::frame("sc")];
    let mut frame = String::new();
    for k in 0..PARTS {
        let mut vector = |size: f64| [number(size), number(size), number(size)];
        let place = Place {
            position: Position::from_array(vector(1.0)),
            rotation: Rotation::exp(vector(1.0).into())?,
        };
        if k % IN_FRAME == 0 {
            frame = format!("sc/{}", k / IN_FRAME);
            rows.push(Row { place, ..Row::frame(frame.clone()) });
        }
        let center_of_mass = Position::from_array(vector(0.1));
        let mass = 0.6 + number(0.5);
        let size = 1e-3 * mass;
        let tensor = GivenTensor {
            moments: [size, 1.2 * size, 1.4 * size],
            products: [0.05 * size, -0.08 * size, 0.03 * size],
            sign: ProductSign::PositiveIntegral,
            about: TensorPoint::CenterOfMass,
        };
        rows.push(Row {
            place,
            quantity: Quantity { count: 1 + (k % 3) as u32, ..Quantity::ONE },
            uncertainty: Uncertainty {
                part: PartUncertainty::Separate {
                    mass: 0.02 * mass,
                    tensor_follows_mass: true,
                    center: Spread::Deviations([1e-3; 3]),
                    tensor: Spread::Deviations([0.02 * size; 6]),
                },
                position: Spread::Deviations([1e-3; 3]),
                rotation: Spread::Deviations([2e-3; 3]),
            },
            group: (k % 4 == 0).then(|| "scale".to_owned()),
            growth: Growth::Code("E".to_owned()),
            ..Row::part(format!("{frame}/{k}"), GivenPart { mass, center_of_mass, tensor })
        });
    }
    let list = PartsList {
        rows,
        groups: vec![Group::of_masses("scale", 0.5)],
        growth: GrowthTable::new([("E".to_owned(), 0.15)])?,
    };
    let seconds = |start: Instant| start.elapsed().as_secs_f64();
    let start = Instant::now();
    let budget = list.budget()?;
    println!("{PARTS} parts checked: {:.3} s", seconds(start));
    let start = Instant::now();
    let body = budget.mass_properties(Basis::Basic)?;
    println!("mass, centre and tensor: {:.3} s", seconds(start));
    let start = Instant::now();
    let estimate = budget.estimate(Basis::Basic)?;
    println!("with the covariance by 16 errors of each part: {:.3} s", seconds(start));
    let start = Instant::now();
    let found = budget.sensitivities(Basis::Basic, &[estimate.principal().moment_gradient(2)], 1000)?;
    println!("sensitivities, {} of them: {:.3} s", found[0].greatest.len() + found[0].others, seconds(start));
    let start = Instant::now();
    let draws = budget.draws(Basis::Basic, 1, 10)?;
    println!("a draw: {:.3} s", seconds(start) / 10.0);
    println!("{:.6} ± {:.6} kg, {:.6} kg in a draw", body.mass(), estimate.sd(0), draws.bodies[0].mass());
    Ok(())
}
