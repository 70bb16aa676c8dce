//! Time of the search for ballast: `cargo run --release -p polhode-budget --example ballast_time`.
//! An argument selects the cases whose names begin with it.

use std::time::Instant;

use polhode::math::{Body, Direction, Position};
use polhode_budget::{
    About, Ballast, BallastAnswer, BallastPlace, Basis, Budget, GivenPart, GivenTensor, Limit, Measure,
    PartsList, ProductSign, Round, Row, Site,
};

const X: Direction<Body> = Direction::new(1.0, 0.0, 0.0);
const Y: Direction<Body> = Direction::new(0.0, 1.0, 0.0);
const Z: Direction<Body> = Direction::new(0.0, 0.0, 1.0);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let only = std::env::args().nth(1).unwrap_or_default();
    for (name, sites, limits) in cases() {
        if only == "list" {
            println!("{name}");
            continue;
        }
        if !name.starts_with(&only) {
            continue;
        }
        let start = Instant::now();
        let answer = body()?.ballast(&Ballast { sites, ..Ballast::default() }, &limits);
        let time = start.elapsed().as_secs_f64();
        let said = match answer {
            Ok(BallastAnswer::Found(found)) => {
                let proved = if found.is_least() { "proved" } else { "not proved" };
                format!("{:.9} kg, gap {:.1e}, {proved}", found.mass, found.gap())
            }
            Ok(BallastAnswer::NotFound(none)) if none.is_proved() => "none: proved".to_owned(),
            Ok(BallastAnswer::NotFound(none)) => format!("none found, bound {:.9} kg", none.bound),
            Err(error) => error.to_string(),
        };
        println!("{name:32} {time:8.2} s  {said}");
    }
    Ok(())
}

fn body() -> Result<Budget, polhode_budget::BudgetError> {
    let tensor = GivenTensor { moments: [3.1, 4.2, 5.3], products: [0.03, 0.02, -0.05], ..GivenTensor::ZERO };
    let part = GivenPart { mass: 6.0, center_of_mass: Position::new(0.021, -0.013, 0.2), tensor };
    PartsList { rows: vec![Row::part("body", part)], ..PartsList::default() }.budget()
}

fn limit(name: &str, of: Measure, most: f64) -> Limit {
    Limit { name: name.to_owned(), of, least: None, most: Some(most), basis: Basis::Basic }
}

fn axis(most: f64) -> Limit {
    limit("axis", Measure::CenterFromLine { point: Position::ZERO, along: Z }, most)
}

fn product(axes: [Direction<Body>; 2], most: f64) -> Limit {
    let about = About::CenterOfMass;
    let of = Measure::Product { axes, sign: ProductSign::PositiveIntegral, about };
    Limit { least: Some(-most), ..limit("product", of, most) }
}

fn of(place: BallastPlace, sizes: &[f64], most: Option<f64>) -> Site {
    Site { most, sizes: sizes.to_vec(), ..Site::new("site", place) }
}

fn cases() -> Vec<(String, Vec<Site>, Vec<Limit>)> {
    let line = BallastPlace::Line([Position::new(-0.7, 0.35, -0.4), Position::new(-0.4, 0.3, 0.6)]);
    let tilted = Direction::new(0.3, -0.2, 1.0);
    let rim =
        BallastPlace::Circle(Round { center: Position::new(0.05, 0.02, 0.5), normal: tilted, radius: 0.6 });
    let disc = BallastPlace::Disc(Round { center: Position::new(-0.1, 0.03, -0.3), normal: Z, radius: 0.5 });
    let products = |most: f64| vec![product([X, Z], most), product([Y, Z], most)];
    let both = |most: f64, product: f64| [vec![axis(most)], products(product)].concat();
    let mut all = Vec::new();
    let mut add =
        |name: &str, sites: Vec<Site>, limits: Vec<Limit>| all.push((name.to_owned(), sites, limits));
    let places = [("line", line.clone()), ("rim", rim.clone()), ("disc", disc.clone())];
    for (name, place) in &places {
        for (size, most) in [(3e-3, Some(0.3)), (2e-5, Some(0.3)), (2e-5, None)] {
            let label = format!("{name} of {size}{}", if most.is_some() { "" } else { " no most" });
            add(&format!("axis {label}"), vec![of(place.clone(), &[size], most)], vec![axis(0.004)]);
            add(&format!("products {label}"), vec![of(place.clone(), &[size], most)], both(0.006, 0.02));
        }
    }
    let ring = Round { center: Position::new(0.0, 0.0, 0.3), normal: Z, radius: 0.7 };
    for (name, place) in [("circle", BallastPlace::Circle(ring)), ("disc", BallastPlace::Disc(ring))] {
        add(&format!("exact {name} of 0.011"), vec![of(place, &[0.011], None)], vec![axis(0.0)]);
    }
    add(
        "two products rim+disc",
        vec![of(rim.clone(), &[], None), of(disc.clone(), &[], None)],
        products(0.01),
    );
    add(
        "two equal products rim+disc",
        vec![of(rim.clone(), &[], None), of(disc.clone(), &[], None)],
        products(0.0),
    );
    for size in [0.02, 3e-3, 2e-5] {
        for most in [None, Some(0.25)] {
            let sized = |place: &BallastPlace| of(place.clone(), &[size], most);
            let label = format!("{size} {most:?}");
            add(&format!("sized products rim+disc {label}"), vec![sized(&rim), sized(&disc)], products(0.01));
            add(&format!("sized both rim+disc {label}"), vec![sized(&rim), sized(&disc)], both(0.006, 0.01));
            add(&format!("sized both line+rim {label}"), vec![sized(&line), sized(&rim)], both(0.006, 0.01));
            add(
                &format!("mixed both line+rim {label}"),
                vec![sized(&line), of(rim.clone(), &[], most)],
                both(0.006, 0.01),
            );
        }
    }
    let several = |place: &BallastPlace| of(place.clone(), &[0.12, 0.2], Some(0.33));
    add(
        "coarse both line+rim",
        vec![several(&line), of(rim.clone(), &[0.15, 0.1], Some(0.2))],
        both(0.008, 0.06),
    );
    add(
        "coarse both line+disc",
        vec![several(&line), of(disc.clone(), &[0.15, 0.1], Some(0.2))],
        both(0.008, 0.06),
    );
    add(
        "coarse both, tight",
        vec![several(&line), of(rim.clone(), &[0.15, 0.1], Some(0.2))],
        both(0.004, 0.03),
    );
    add("coarse both, three", vec![several(&line), several(&rim), several(&disc)], both(0.004, 0.02));
    all
}
