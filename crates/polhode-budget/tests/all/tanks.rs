//! Liquids in tanks compared with closed forms, sums of tetrahedra and each other.

use polhode::body::shape::{Shape, Sphere, Substance};
use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Part, Position};
use polhode_budget::{Down, Fill, Liquid, LiquidTable, SequenceError, TankShape, Vessel};
use std::f64::consts::PI;

const ALL: [Down; 6] = [Down::MinusX, Down::MinusY, Down::MinusZ, Down::PlusX, Down::PlusY, Down::PlusZ];

fn shapes() -> Vec<TankShape> {
    vec![
        TankShape::Box([0.7, 1.1, 0.4]),
        TankShape::Ellipsoid([0.3, 0.5, 0.7]),
        TankShape::Cylinder { radius: 0.4, length: 0.9, ends: [0.0, 0.0] },
        TankShape::Cylinder { radius: 0.4, length: 0.9, ends: [0.4, 0.25] },
        TankShape::Cylinder { radius: 0.4, length: 0.0, ends: [0.1, 0.3] },
    ]
}

fn vessel(shape: TankShape, down: Down) -> Vessel {
    Vessel::new(shape, 1234.5, down).unwrap()
}

fn at(shape: TankShape, down: Down, fraction: f64) -> Fill {
    let vessel = vessel(shape, down);
    Liquid::Vessel(Box::new(vessel.clone())).at(fraction * vessel.capacity()).unwrap()
}

/// Returns the mass, the first moments and the tensor about the origin.
fn moments(body: &MassProperties<Part>) -> [f64; 10] {
    let (m, c) = (body.mass(), body.center_of_mass().to_array());
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia_about(Position::ZERO).matrix();
    [m, m * c[0], m * c[1], m * c[2], xx, yy, zz, xy, xz, yz]
}

/// Returns the tank's axis in which the liquid settles, and the sign of the upward direction.
fn upwards(down: Down) -> (usize, f64) {
    match down {
        Down::MinusX => (0, 1.0),
        Down::MinusY => (1, 1.0),
        Down::MinusZ => (2, 1.0),
        Down::PlusX => (0, -1.0),
        Down::PlusY => (1, -1.0),
        Down::PlusZ => (2, -1.0),
    }
}

fn is_inside(shape: &TankShape, [x, y, z]: [f64; 3]) -> bool {
    match *shape {
        TankShape::Box([a, b, c]) => x.abs() < 0.5 * a && y.abs() < 0.5 * b && z.abs() < 0.5 * c,
        TankShape::Ellipsoid([a, b, c]) => (x / a).powi(2) + (y / b).powi(2) + (z / c).powi(2) < 1.0,
        TankShape::Cylinder { radius, length, ends } => {
            let r2 = (x * x + y * y) / (radius * radius);
            let beyond = z.abs() - 0.5 * length;
            let end = if z < 0.0 { ends[0] } else { ends[1] };
            if beyond <= 0.0 { r2 < 1.0 } else { end > 0.0 && r2 + (beyond / end).powi(2) < 1.0 }
        }
    }
}

/// Compares every shape, direction and level with a grid of points. Both have no formula in common.
#[test]
fn liquids_are_what_is_inside_below_the_level() {
    let n = 150;
    for shape in shapes() {
        for down in ALL {
            let (axis, up) = upwards(down);
            let fill = at(shape, down, 0.37);
            let level = fill.level.unwrap();
            // A grid over a box that contains every shape. The level is measured from the lowest
            // point.
            let half = 1.0;
            let h = 2.0 * half / f64::from(n);
            let places: Vec<[f64; 3]> = (0..n * n * n)
                .map(|k| [k / (n * n), k / n % n, k % n].map(|j| (f64::from(j) + 0.5) * h - half))
                .filter(|p| is_inside(&shape, *p))
                .collect();
            let lowest = match shape {
                TankShape::Box(size) => -0.5 * size[axis],
                TankShape::Ellipsoid(axes) => -axes[axis],
                TankShape::Cylinder { radius, .. } if axis != 2 => -radius,
                TankShape::Cylinder { length, ends, .. } => {
                    -(0.5 * length + if up > 0.0 { ends[0] } else { ends[1] })
                }
            };
            let mut sum = [0.0; 10];
            for [x, y, z] in places {
                // A cell at the surface counts with its part below the surface.
                let depth = level - (up * [x, y, z][axis] - lowest);
                let part = (depth / h + 0.5).clamp(0.0, 1.0);
                if part > 0.0 {
                    let terms =
                        [1.0, x, y, z, y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
                    sum.iter_mut()
                        .zip(terms)
                        .for_each(|(sum, term)| *sum += part * 1234.5 * h * h * h * term);
                }
            }
            let found = moments(&fill.properties.unwrap());
            let scale = found[0];
            for (k, (a, b)) in found.iter().zip(sum).enumerate() {
                assert!((a - b).abs() < 0.03 * scale, "{shape:?} {down:?} {k}: {a} {b}");
            }
        }
    }
}

#[test]
fn a_full_tank_is_the_shape() {
    let full = at(TankShape::Ellipsoid([0.6; 3]), Down::PlusY, 1.0).properties.unwrap();
    let sphere = Sphere::new(0.6).unwrap().mass_properties(Substance::Density(1234.5)).unwrap();
    assert!((full.mass() / sphere.mass() - 1.0).abs() < 3e-15);
    let (a, b) = (moments(&full), moments(&sphere));
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14 * full.mass()), "{a:?} {b:?}");
    // A full tank does not depend on the direction. Two parts that settle in opposite directions
    // add up to it.
    for shape in shapes() {
        let reference = moments(&at(shape, Down::MinusZ, 1.0).properties.unwrap());
        for (down, opposite) in ALL.into_iter().zip(ALL.into_iter().cycle().skip(3)) {
            let one = moments(&at(shape, down, 1.0).properties.unwrap());
            let (a, b) = (at(shape, down, 0.3), at(shape, opposite, 0.7));
            let (a, b) = (moments(&a.properties.unwrap()), moments(&b.properties.unwrap()));
            for k in 0..10 {
                assert!((one[k] - reference[k]).abs() < 2e-15 * reference[0], "{shape:?} {down:?}");
                assert!((a[k] + b[k] - reference[k]).abs() < 2e-14 * reference[0], "{shape:?} {down:?} {k}");
            }
        }
    }
}

/// Cap of a sphere: V = π h² (3 r − h)/3, its centre 3 (2 r − h)²/(4 (3 r − h)) from the middle.
/// Also tested for a very small amount.
#[test]
fn a_cap_of_a_sphere_has_a_closed_form() {
    let r = 0.6;
    for h in [1e-9, 1e-4, 0.1, 0.6, 0.9, 1.1999] {
        let volume = PI * h * h * (3.0 * r - h) / 3.0;
        let vessel = vessel(TankShape::Ellipsoid([r; 3]), Down::MinusX);
        let fill = Liquid::Vessel(Box::new(vessel)).at(1234.5 * volume);
        if h < 1e-6 {
            // An amount below the rounding error of a full tank is an empty tank.
            assert!(fill.unwrap().properties.is_none());
            continue;
        }
        let fill = fill.unwrap();
        // Near the top, little volume is above a level.
        let digits = if h > 1.0 { 1e-11 } else { 1e-14 };
        assert!((fill.level.unwrap() / h - 1.0).abs() < digits, "{h}: {:e}", fill.level.unwrap() / h - 1.0);
        let center = fill.properties.unwrap().center_of_mass();
        let want = -3.0 * (2.0 * r - h) * (2.0 * r - h) / (4.0 * (3.0 * r - h));
        // measured from the bottom, where all digits are accurate
        let up = |x: f64| x + r;
        assert!((up(center.x) - up(want)).abs() < 1e-15 && center.y == 0.0 && center.z == 0.0);
        assert!((fill.next.center[0] - (h - r)).abs() < digits);
        let a2 = h * (2.0 * r - h);
        assert!((fill.next.tensor[0] / (0.5 * a2) - 1.0).abs() < digits / a2);
    }
}

/// Horizontal cylinder: A = r² acos((r − h)/r) − (r − h) √(2 r h − h²). Its centre is
/// ⅔ (2 r h − h²)^1.5 / A below the middle.
#[test]
fn a_segment_of_a_lying_cylinder_has_a_closed_form() {
    let (r, l) = (0.4_f64, 0.9);
    for h in [1e-3, 0.13, 0.4, 0.7_f64] {
        let s = 2.0 * r * h - h * h;
        let area = r * r * ((r - h) / r).acos() - (r - h) * s.sqrt();
        let vessel = vessel(TankShape::Cylinder { radius: r, length: l, ends: [0.0; 2] }, Down::PlusY);
        let fill = Liquid::Vessel(Box::new(vessel)).at(1234.5 * area * l).unwrap();
        let liquid = fill.properties.unwrap();
        let digits = if h < 0.01 { 1e-9 } else { 1e-13 };
        assert!((fill.level.unwrap() / h - 1.0).abs() < digits);
        assert!((liquid.center_of_mass().y - 2.0 / 3.0 * s.powf(1.5) / area).abs() < digits);
        // The liquid is a rod along the axis.
        let [[xx, ..], [_, yy, _], [.., zz]] = liquid.inertia().matrix();
        let along = 0.5 * (xx + yy - zz);
        assert!((along / (liquid.mass() * l * l / 12.0) - 1.0).abs() < 1e-13);
    }
}

/// Levels measured from the bottom and from the top of a tank add up to its height.
#[test]
fn levels_are_exact_at_both_ends_and_of_full_digits_between() {
    for shape in shapes() {
        for down in ALL {
            let opposite = ALL[(ALL.iter().position(|other| *other == down).unwrap() + 3) % 6];
            let [here, turned] = [down, opposite].map(|down| vessel(shape, down));
            let level = |vessel: &Vessel, mass: f64| {
                Liquid::Vessel(Box::new(vessel.clone())).at(mass).unwrap().level.unwrap()
            };
            let (axis, _) = upwards(down);
            let whole = match shape {
                TankShape::Box(size) => size[axis],
                TankShape::Ellipsoid(axes) => 2.0 * axes[axis],
                TankShape::Cylinder { radius, .. } if axis != 2 => 2.0 * radius,
                TankShape::Cylinder { length, ends: [a, b], .. } if down == Down::MinusZ => a + length + b,
                TankShape::Cylinder { length, ends: [a, b], .. } => b + length + a,
            };
            assert_eq!(
                [level(&here, 0.0), level(&here, here.capacity())],
                [0.0, whole],
                "{shape:?} {down:?}"
            );
            for part in [1e-9, 1e-4, 0.013, 0.31, 0.5, 0.77, 0.9999] {
                // Rounded so that the empty volume is exact.
                let mass = here.capacity() - (here.capacity() - part * here.capacity());
                let sum = level(&here, mass) + level(&turned, turned.capacity() - mass);
                assert!((sum - whole).abs() < 5e-15 * whole, "{shape:?} {down:?} {part}: {sum} {whole}");
            }
        }
    }
    // Nearly full, with an empty cap of π h² (r − h/3).
    let sphere = vessel(TankShape::Ellipsoid([0.2; 3]), Down::PlusX);
    for h in [1e-7, 1e-5, 1e-3, 0.05] {
        let mass = sphere.capacity() - 1234.5 * PI * h * h * (0.2 - h / 3.0);
        let volume = (sphere.capacity() - mass) / 1234.5;
        let level = Liquid::Vessel(Box::new(sphere.clone())).at(mass).unwrap().level.unwrap();
        let depth = 0.4 - level;
        let found = PI * depth * depth * (0.2 - depth / 3.0);
        // The level of 0.4 m has a rounding error of 1e-16.
        let rounding = 1e-12 * volume + 2.0 * PI * h * 0.2 * 1e-16;
        assert!((found - volume).abs() < rounding, "{h}: {found} {volume}");
    }
}

#[test]
fn slices_are_derivatives() {
    let of_slice = |fill: &Fill| {
        let ([x, y, z], t) = (fill.next.center, fill.next.tensor);
        let moved = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
        let tensor: [f64; 6] = core::array::from_fn(|k| t[k] + moved[k]);
        [1.0, x, y, z, tensor[0], tensor[1], tensor[2], tensor[3], tensor[4], tensor[5]]
    };
    for shape in shapes() {
        for down in ALL {
            let liquid = Liquid::Vessel(Box::new(vessel(shape, down)));
            for fraction in [0.08, 0.5, 0.93] {
                let (m, h) = (fraction * liquid.capacity(), 1e-5 * liquid.capacity());
                let [before, after] =
                    [m - h, m + h].map(|m| moments(&liquid.at(m).unwrap().properties.unwrap()));
                for (k, slope) in of_slice(&liquid.at(m).unwrap()).into_iter().enumerate() {
                    let difference = (after[k] - before[k]) / (2.0 * h);
                    assert!(
                        (slope - difference).abs() < 2e-8,
                        "{shape:?} {down:?} {fraction} {k}: {slope} {difference}"
                    );
                }
            }
        }
    }
    let table = Liquid::Table(table());
    for m in [0.5, 2.0, 4.4] {
        let [before, after] =
            [m - 1e-4, m + 1e-4].map(|m| moments(&table.at(m).unwrap().properties.unwrap()));
        for (k, slope) in of_slice(&table.at(m).unwrap()).into_iter().enumerate() {
            assert!((slope - (after[k] - before[k]) / 2e-4).abs() < 1e-10, "{m} {k}");
        }
    }
}

fn table() -> LiquidTable {
    let body = |m: f64, c: [f64; 3], moments: [f64; 3], products: [f64; 3]| {
        let inertia = InertiaTensor::with_negative_products(moments, products).unwrap();
        MassProperties::new(m, Position::from_array(c), inertia).unwrap()
    };
    let rows = vec![
        body(1.0, [0.1, 0.2, -0.3], [0.02, 0.03, 0.04], [0.001, -0.002, 0.003]),
        body(3.0, [0.12, 0.15, -0.1], [0.09, 0.08, 0.07], [0.004, 0.002, -0.001]),
        body(5.0, [0.1, 0.1, 0.05], [0.2, 0.22, 0.1], [0.01, 0.004, 0.02]),
    ];
    LiquidTable::new(rows, Some(vec![0.1, 0.25, 0.4])).unwrap()
}

#[test]
fn tables_mix_their_rows() {
    let table = Liquid::Table(table());
    let at = |m: f64| table.at(m).unwrap();
    assert_eq!(table.capacity(), 5.0);
    // a mixture of ¼ of the second row and ¾ of the first
    let (a, b, mixed) =
        (moments(&at(1.0).properties.unwrap()), moments(&at(3.0).properties.unwrap()), at(1.5));
    let found = moments(&mixed.properties.unwrap());
    assert!((0..10).all(|k| (found[k] - 0.75 * a[k] - 0.25 * b[k]).abs() < 1e-15));
    assert!((mixed.level.unwrap() - 0.1375).abs() < 1e-15);
    // Below the first row, the density is lower and the level is not known.
    let thin = at(0.5);
    assert!((0..10).all(|k| (moments(&thin.properties.unwrap())[k] - 0.5 * a[k]).abs() < 1e-16));
    assert!(thin.level.is_none() && at(0.0).properties.is_none());
    assert!(table.at(5.1).is_none() && table.at(-0.1).is_none());
}

#[test]
fn what_is_no_tank_is_refused() {
    let refused = |shape, density| {
        assert!(matches!(Vessel::new(shape, density, Down::MinusZ), Err(SequenceError::Value { .. })));
    };
    refused(TankShape::Box([1.0, 0.0, 1.0]), 1000.0);
    refused(TankShape::Ellipsoid([1.0, f64::NAN, 1.0]), 1000.0);
    refused(TankShape::Cylinder { radius: 1.0, length: 0.0, ends: [0.0; 2] }, 1000.0);
    refused(TankShape::Cylinder { radius: 1.0, length: 1.0, ends: [0.1, -0.1] }, 1000.0);
    refused(TankShape::Box([1.0; 3]), -1.0);
    let row = |m| MassProperties::new(m, Position::ZERO, InertiaTensor::diagonal([1.0; 3]).unwrap()).unwrap();
    assert!(LiquidTable::new(vec![row(2.0), row(1.0)], None).is_err());
    assert!(LiquidTable::new(vec![row(1.0), row(2.0)], Some(vec![0.1, 0.1])).is_err());
    assert!(
        LiquidTable::new(vec![row(1.0)], Some(vec![])).is_err() && LiquidTable::new(vec![], None).is_err()
    );
}
