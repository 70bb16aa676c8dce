//! Derivatives of free motion compared with differences in high precision, their own differential
//! equations, and the laws of motion.

use crate::common::{cases, matrix, number, numbers, table};
use polhode::motion::{FreeMotionDerivatives, StateDerivatives};
use polhode::prelude::*;

/// Rows and columns of a derivative, with a name.
type Block<'a> = (&'a str, core::ops::Range<usize>, core::ops::Range<usize>);

/// Returns a body with the elements xx, yy, zz, xy, xz, yz.
fn body([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Rotor {
    let inertia = InertiaTensor::with_negative_products([xx, yy, zz], [xy, xz, yz]).unwrap();
    Rotor::free(&MassProperties::new(1.3, Position::new(0.2, -0.1, 0.4), inertia).unwrap())
}

fn start(omega: [f64; 3]) -> State {
    let attitude = Attitude::from_quaternion([0.6, -0.3, 0.5, 0.55]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) }
}

fn motion(tensor: [f64; 6], omega: [f64; 3]) -> FreeMotionDerivatives {
    FreeMotionDerivatives::of(&body(tensor), start(omega)).unwrap()
}

/// Returns bodies of every kind with a start, and a characteristic time.
fn motions() -> Vec<(&'static str, [f64; 6], [f64; 3], f64)> {
    let diagonal = |a: f64, b: f64, c: f64| [a, b, c, 0.0, 0.0, 0.0];
    let products = [1.5, 2.25, 2.5, 0.125, -0.25, 0.375];
    vec![
        ("short", diagonal(1.3, 2.1, 2.9), [0.35, -0.2, 0.8], 7.0),
        ("long", diagonal(2.1, 2.9, 1.3), [0.4, -0.25, 0.7], -9.0),
        ("products", products, [0.1, 0.9, 0.2], 31.0),
        ("products, briefly", products, [0.3, -0.2, 0.8], 0.05),
        ("near the separatrix", diagonal(1.3, 2.1, 2.9), [1e-3, 1.0, -1e-3], 40.0),
        ("separatrix", diagonal(3.0, 4.0, 6.0), [1.0, 0.3, 0.5], 3.0),
        ("permanent, middle", diagonal(1.3, 2.1, 2.9), [0.0, -0.7, 0.0], 5.0),
        ("permanent, greatest", diagonal(1.3, 2.1, 2.9), [0.0, 0.0, 1.1], 5.0),
        ("oblate", diagonal(2.0, 2.0, 3.5), [0.4, -0.7, 1.1], 12.0),
        ("oblate, across", diagonal(1.5, 1.5, 1.7), [0.7, -0.3, 0.0], 12.0),
        ("prolate", diagonal(0.7, 2.4, 2.4), [1.3, 0.5, -0.35], -4.0),
        ("spherical", diagonal(1.3, 1.3, 1.3), [0.4, -0.7, 1.1], 6.0),
    ]
}

fn norm<'a>(elements: impl IntoIterator<Item = &'a f64>) -> f64 {
    elements.into_iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Returns |a − b|/|b| of a block of six rows; |a − b| where b is zero.
fn error<const N: usize>(a: &[[f64; N]; 6], b: &[[f64; N]; 6], (_, rows, columns): &Block<'_>) -> f64 {
    let (mut difference, mut size) = (0.0, 0.0);
    for row in rows.clone() {
        for column in columns.clone() {
            let (a, b) = (a[row][column], b[row][column]);
            difference += (a - b) * (a - b);
            size += b * b;
        }
    }
    if size == 0.0 { f64::sqrt(difference) } else { f64::sqrt(difference / size) }
}

fn six_rows<const N: usize>(value: &toml::Value) -> [[f64; N]; 6] {
    let rows: Vec<_> = value.as_array().unwrap().iter().map(numbers).collect();
    rows.try_into().unwrap()
}

#[test]
fn differences_in_high_precision_are_these_derivatives() {
    let mut failures = Vec::new();
    let mut worst: f64 = 0.0;
    for case in cases(&table("free_derivatives"), "case") {
        let name = case["name"].as_str().unwrap();
        let motion = motion(numbers(&case["inertia"]), numbers(&case["omega"]));
        for row in cases(case, "at") {
            let t = number(&row["t"]);
            let StateDerivatives { by_start, by_inertia, .. } = motion.at(t);
            let turn = matrix(&row["turn"]);
            for (i, of_start) in by_start.iter().enumerate() {
                for k in 0..3 {
                    // ∂θ/∂θ(0) is attitude(t)ᵀ attitude(0), and ω does not depend on the attitude
                    let exact = if i < 3 { turn[k][i] } else { 0.0 };
                    assert!((of_start[k] - exact).abs() < 1e-14, "{name} at {t}: {:e}", of_start[k] - exact);
                }
            }
            let by_omega: [[f64; 3]; 6] = six_rows(&row["by_omega"]);
            let found = by_start.map(|row| [row[3], row[4], row[5]]);
            let tensor: [[f64; 6]; 6] = six_rows(&row["by_inertia"]);
            for (what, error) in [
                ("θ by ω", error(&found, &by_omega, &("", 0..3, 0..3))),
                ("ω by ω", error(&found, &by_omega, &("", 3..6, 0..3))),
                ("θ by I", error(&by_inertia, &tensor, &("", 0..3, 0..6))),
                ("ω by I", error(&by_inertia, &tensor, &("", 3..6, 0..6))),
            ] {
                worst = worst.max(error);
                if !(error <= 2e-13) {
                    failures.push(format!("{name} at {t:e}, {what}: {error:.1e}"));
                }
            }
        }
    }
    println!("worst {worst:.1e}");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Variations of θ̇ = θ × ω + δω and (I ω)˙ = I ω × ω; the left sides by differences in time.
#[test]
fn the_derivatives_satisfy_the_variational_equations() {
    for (name, tensor, omega, t) in motions() {
        let motion = motion(tensor, omega);
        let h = 2f64.powi(-7) / norm(&omega);
        let states = [-4, -3, -2, -1, 1, 2, 3, 4].map(|k| motion.at(t + f64::from(k) * h));
        let weights = [3.0, -32.0, 168.0, -672.0, 672.0, -168.0, 32.0, -3.0];
        let now = motion.at(t);
        let w = now.state.omega;
        for part in [0, 1] {
            let of = |s: &StateDerivatives| if part == 0 { s.by_start } else { s.by_inertia };
            let here = of(&now);
            let size = norm(here.iter().flatten());
            let columns = [0, 1, 2, 3, 4, 5].map(|column| here.map(|row| row[column]));
            for (column, [t1, t2, t3, w1, w2, w3]) in columns.into_iter().enumerate() {
                let (turn, change) = ([t1, t2, t3], [w1, w2, w3]);
                let rate = |row: usize| {
                    let sum: f64 = states.iter().zip(weights).map(|(s, x)| x * of(s)[row][column]).sum();
                    sum / (840.0 * h)
                };
                let w = w.to_array();
                let inertia = |v: [f64; 3]| apply(tensor, v);
                // δI ω and δI ω̇ of this column
                let unit = |v: [f64; 3]| if part == 0 { [0.0; 3] } else { apply(unit_of(column), v) };
                let acceleration = motion.motion().angular_acceleration(&now.state).to_array();
                let expected_turn = cross(turn, w);
                // variation of (I ω)̇ = I ω × ω
                let mut momentum_rate = cross(inertia(change), w);
                for term in [cross(unit(w), w), cross(inertia(w), change)] {
                    for (sum, x) in momentum_rate.iter_mut().zip(term) {
                        *sum += x;
                    }
                }
                let found = inertia([rate(3), rate(4), rate(5)]);
                let of_acceleration = unit(acceleration);
                for k in 0..3 {
                    let turn_error = (rate(k) - expected_turn[k] - change[k]).abs();
                    assert!(
                        turn_error < 1e-11 * size,
                        "{name}, θ{k} column {column}: {turn_error:e} of {size:e}"
                    );
                    let error = (found[k] + of_acceleration[k] - momentum_rate[k]).abs();
                    assert!(error < 1e-10 * size, "{name}, ω{k} column {column}: {error:e} of {size:e}");
                }
            }
        }
    }
}

fn apply([xx, yy, zz, xy, xz, yz]: [f64; 6], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z]
}

fn unit_of(element: usize) -> [f64; 6] {
    let mut unit = [0.0; 6];
    unit[element] = 1.0;
    unit
}

#[test]
fn scaling_the_tensor_changes_nothing_and_energy_and_momentum_are_conserved() {
    for (name, tensor, omega, t) in motions() {
        let motion = motion(tensor, omega);
        let now = motion.at(t);
        let size = norm(now.by_inertia.iter().flatten()) * norm(&tensor);
        for row in now.by_inertia {
            let null: f64 = row.iter().zip(&tensor).map(|(x, y)| x * y).sum();
            assert!(null.abs() < 1e-13 * size, "{name}: {null:e} of {size:e}");
        }
        // ω(t; κω0) = κ ω(κt; ω0), so (∂ω/∂ω0) ω0 = ω + t ω̇. The attitude is that at κt, so
        // (∂θ/∂ω0) ω0 = t ω
        let state = now.state;
        let (w, a) = (state.omega.to_array(), motion.motion().angular_acceleration(&state).to_array());
        for k in 0..3 {
            let along = |row: [f64; 6]| row[3] * omega[0] + row[4] * omega[1] + row[5] * omega[2];
            let (turn, rate) =
                (along(now.by_start[k]) - t * w[k], along(now.by_start[3 + k]) - w[k] - t * a[k]);
            let size = norm(now.by_start.iter().flatten()) * norm(&omega);
            assert!(
                turn.abs() < 2e-14 * size && rate.abs() < 2e-14 * size,
                "{name}: {turn:e}, {rate:e} of {size:e}"
            );
        }
        // δ(2T)/2 = L·δω + ½ ω·δI ω is conserved
        for column in 0..9 {
            let inertia = column >= 3;
            let (unit, from, before) = if inertia {
                (unit_of(column - 3), column - 3, [0.0; 3])
            } else {
                let mut before = [0.0; 3];
                before[column] = 1.0;
                ([0.0; 6], 3 + column, before)
            };
            let table = if inertia { &now.by_inertia } else { &now.by_start };
            let after = [3, 4, 5].map(|row| table[row][from]);
            let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let energy =
                |w: [f64; 3], change: [f64; 3]| dot(apply(tensor, w), change) + 0.5 * dot(w, apply(unit, w));
            let error = energy(w, after) - energy(omega, before);
            let size = norm(table.iter().flatten()) * norm(&tensor) * norm(&omega) + 1.0;
            assert!(error.abs() < 1e-13 * size, "{name}, column {column}: {error:e} of {size:e}");
        }
    }
}

/// The flow in θ and L is Hamiltonian: with ω = I⁻¹ L, Φᵀ J(t) Φ = J(0), J = [[−L×, 1], [−1, 0]].
#[test]
fn the_transition_matrix_is_symplectic() {
    for (name, tensor, omega, t) in motions() {
        let motion = motion(tensor, omega);
        let now = motion.at(t);
        let form = |l: [f64; 3], a: [f64; 6], b: [f64; 6]| {
            // δθ₁·δL₂ − δθ₂·δL₁ + L·(δθ₁ × δθ₂)
            let (p, q) = ([a[0], a[1], a[2]], [b[0], b[1], b[2]]);
            let (dl, dm) = (apply(tensor, [a[3], a[4], a[5]]), apply(tensor, [b[3], b[4], b[5]]));
            let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            dot(p, dm) - dot(q, dl) + dot(l, cross(p, q))
        };
        let column = |k: usize| now.by_start.map(|row| row[k]);
        let unit = |k: usize| {
            let mut unit = [0.0; 6];
            unit[k] = 1.0;
            unit
        };
        let (before, after) = (apply(tensor, omega), apply(tensor, now.state.omega.to_array()));
        let size = norm(now.by_start.iter().flatten()).powi(2) * norm(&tensor);
        for j in 0..6 {
            for k in 0..6 {
                let error = form(after, column(j), column(k)) - form(before, unit(j), unit(k));
                assert!(error.abs() < 1e-14 * size, "{name}, {j} {k}: {error:e} of {size:e}");
            }
        }
    }
}

#[test]
fn transitions_follow_one_another() {
    for (name, tensor, omega, t) in motions() {
        let motion = motion(tensor, omega);
        let (half, whole) = (motion.at(0.4 * t), motion.at(t));
        let second = FreeMotionDerivatives::of(&body(tensor), half.state).unwrap().at(t);
        for row in 0..6 {
            for k in 0..6 {
                let product: f64 = (0..6).map(|j| second.by_start[row][j] * half.by_start[j][k]).sum();
                let of_tensor: f64 =
                    (0..6).map(|j| second.by_start[row][j] * half.by_inertia[j][k]).sum::<f64>()
                        + second.by_inertia[row][k];
                let size = norm(second.by_start.iter().flatten());
                let (error, scale) =
                    (product - whole.by_start[row][k], size * norm(half.by_start.iter().flatten()));
                assert!(error.abs() < 2e-14 * scale, "{name} {row} {k}: {error:e} of {scale:e}");
                let (error, scale) = (
                    of_tensor - whole.by_inertia[row][k],
                    size * norm(half.by_inertia.iter().flatten()) + norm(whole.by_inertia.iter().flatten()),
                );
                assert!(error.abs() < 2e-13 * scale, "{name} {row} {k}: {error:e} of {scale:e}");
            }
        }
    }
}

#[test]
fn at_the_start_nothing_has_changed_and_beyond_reach_nothing_is_known() {
    for (name, tensor, omega, t) in motions() {
        let motion = motion(tensor, omega);
        let first = motion.at(0.0);
        assert_eq!(first.state, motion.motion().start(), "{name}");
        for row in 0..6 {
            for k in 0..6 {
                let unit = if row == k { 1.0 } else { 0.0 };
                assert!((first.by_start[row][k] - unit).abs() < 1e-15, "{name}: {:?}", first.by_start);
                assert_eq!(first.by_inertia[row][k], 0.0, "{name}");
            }
        }
        for far in [f64::NAN, f64::INFINITY] {
            let none = motion.at(far);
            assert!(none.by_start.iter().chain(&none.by_inertia).flatten().all(|x| x.is_nan()), "{name}");
        }
        // The state is that of the motion, bit for bit.
        assert_eq!(motion.at(t).state, motion.motion().at(t), "{name}");
        assert_eq!(motion.at_times(&[t, 0.0]), [motion.at(t), first], "{name}");
    }
    let resting = motion([1.3, 2.1, 2.9, 0.1, 0.0, 0.0], [0.0; 3]).at(3.0);
    assert!(
        (resting.by_start[1][4] - 3.0).abs() < 1e-15
            && resting.by_inertia.iter().flatten().all(|x| *x == 0.0)
    );
    let rod = FreeMotionDerivatives::of(&body([0.0, 1.0, 1.0, 0.0, 0.0, 0.0]), start([0.3, 0.5, 0.9]));
    assert!(rod.is_err_and(|error| error.is_parameter()));
}

/// Near the intermediate axis, derivatives grow like e^|λ|t and leave the range of f64: then they
/// are NaN.
#[test]
fn what_leaves_the_range_of_numbers_is_not_a_number() {
    let motion = motion([3.0, 4.0, 6.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let rate = (1.0_f64 * 2.0 / (3.0 * 6.0)).sqrt();
    for exponent in [10.0, 100.0, 300.0] {
        let grown = norm(motion.at(exponent / rate).by_start.iter().flatten());
        assert!((grown.ln() / exponent - 1.0).abs() < 0.2, "{exponent}: {grown:e}");
    }
    for exponent in [360.0, 800.0, 1e4] {
        let none = motion.at(exponent / rate);
        assert!(
            none.by_start.iter().chain(&none.by_inertia).flatten().all(|x| x.is_nan()),
            "{exponent}: {none:?}"
        );
        assert_eq!(none.state, motion.motion().at(exponent / rate));
    }
}

#[test]
fn a_covariance_is_carried_to_first_order() {
    let motion = motion([1.5, 2.25, 2.5, 0.125, -0.25, 0.375], [0.1, 0.9, 0.2]);
    let now = motion.at(3.0);
    // With one direction each, the covariance is that of a vector.
    let (a, b) = ([0.1, -0.2, 0.3, 0.4, 0.5, -0.6], [0.7, 0.2, -0.1, 0.3, -0.4, 0.5]);
    let outer = |v: [f64; 6]| v.map(|x| v.map(|y| x * y));
    let image =
        |m: &[[f64; 6]; 6], v: [f64; 6]| m.map(|row| row.iter().zip(v).map(|(x, y)| x * y).sum::<f64>());
    let (p, q) = (image(&now.by_start, a), image(&now.by_inertia, b));
    let covariance = now.covariance(&outer(a), &outer(b));
    for i in 0..6 {
        for k in 0..6 {
            let exact = p[i] * p[k] + q[i] * q[k];
            assert!((covariance[i][k] - exact).abs() < 1e-13, "{i} {k}: {}", covariance[i][k]);
        }
    }
}

/// Columns: ω(0), and the six elements of the tensor.
type Vectors = [[f64; 3]; 9];

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn plus(a: [f64; 3], x: f64, b: [f64; 3]) -> [f64; 3] {
    [a[0] + x * b[0], a[1] + x * b[1], a[2] + x * b[2]]
}

/// Computes θ and ω of every column after a time, by Taylor's method: L̇ = L × ω,
/// δL̇ = δL × ω + L × δω, θ̇ = θ × ω + δω.
fn by_taylor(tensor: [f64; 6], omega: [f64; 3], time: f64) -> [Vectors; 2] {
    const ORDER: usize = 20;
    let [xx, yy, zz, xy, xz, yz] = tensor;
    let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let adjoint = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])];
    let determinant: f64 = (0..3).map(|k| rows[0][k] * adjoint[0][k]).sum();
    let solved =
        |l: [f64; 3]| [0, 1, 2].map(|i| (0..3).map(|j| adjoint[i][j] * l[j]).sum::<f64>() / determinant);
    let of_element = |column: usize, v: [f64; 3]| {
        if column < 3 { [0.0; 3] } else { apply(unit_of(column - 3), v) }
    };
    let steps = 1 + (2.0 * time.abs() * norm(&omega)) as usize;
    let h = time / steps as f64;
    let mut l = apply(tensor, omega);
    let mut delta: Vectors = core::array::from_fn(|column| match column {
        0..3 => rows[column],
        _ => of_element(column, omega),
    });
    let mut theta: Vectors = [[0.0; 3]; 9];
    for _ in 0..steps {
        let (mut ls, mut deltas, mut thetas) = (vec![l], vec![delta], vec![theta]);
        let (mut ws, mut changes) = (Vec::new(), Vec::<Vectors>::new());
        for n in 0..ORDER {
            let w = solved(ls[n]);
            ws.push(w);
            changes.push(core::array::from_fn(|c| solved(plus(deltas[n][c], -1.0, of_element(c, w)))));
            let over = 1.0 / (n + 1) as f64;
            let sum = |term: &dyn Fn(usize, usize) -> [f64; 3]| {
                (0..=n).fold([0.0; 3], |sum, j| plus(sum, over, term(j, n - j)))
            };
            ls.push(sum(&|j, k| cross(ls[j], ws[k])));
            deltas.push(core::array::from_fn(|c| {
                sum(&|j, k| plus(cross(deltas[j][c], ws[k]), 1.0, cross(ls[j], changes[k][c])))
            }));
            thetas.push(core::array::from_fn(|c| {
                plus(sum(&|j, k| cross(thetas[j][c], ws[k])), over, changes[n][c])
            }));
        }
        let summed = |series: &dyn Fn(usize) -> [f64; 3]| {
            (0..=ORDER).rev().fold([0.0; 3], |sum, n| plus(series(n), h, sum))
        };
        l = summed(&|n| ls[n]);
        delta = core::array::from_fn(|c| summed(&|n| deltas[n][c]));
        theta = core::array::from_fn(|c| summed(&|n| thetas[n][c]));
    }
    let w = solved(l);
    [theta, core::array::from_fn(|c| solved(plus(delta[c], -1.0, of_element(c, w))))]
}

/// Pseudorandom numbers between 0 and 1, the same in every run.
struct Draw(u64);

impl Draw {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Returns 1, or with equal probability a number down to `least`, log-uniform.
    fn small(&mut self, least: f64) -> f64 {
        let chosen = self.unit() < 0.5;
        if chosen { least.powf(self.unit()) } else { 1.0 }
    }
}

#[test]
fn random_bodies_turn_as_taylors_method_says() {
    let mut draw = Draw(7);
    let mut worst: f64 = 0.0;
    for _ in 0..1000 {
        // Second moments, nearly equal for some; arbitrary axes and ω, with ω near an axis for
        // some.
        let b = 1.0 - 0.9 * draw.unit() * draw.small(1e-12);
        let c = b * (1.0 - 0.9 * draw.unit() * draw.small(1e-12));
        let moments = [b + c, 1.0 + c, 1.0 + b];
        let along = [0, 1, 2].map(|_| draw.signed() * draw.small(1e-10));
        let axes =
            Rotation::<Body, Body>::from_quaternion([0, 1, 2, 3].map(|_| draw.signed())).unwrap().matrix();
        let element = |i: usize, j: usize| (0..3).map(|k| axes[i][k] * moments[k] * axes[j][k]).sum::<f64>();
        let tensor =
            [element(0, 0), element(1, 1), element(2, 2), element(0, 1), element(0, 2), element(1, 2)];
        let omega = axes.map(|row| (0..3).map(|k| row[k] * along[k]).sum::<f64>());
        // At shorter times doubles are not accurate enough: ∂θ/∂I begins with t².
        let time = 6.0 * (0.1 + draw.unit()) * draw.signed().signum() * draw.small(0.1) / norm(&omega);
        let [theta, change] = by_taylor(tensor, omega, time);
        let expected = core::array::from_fn::<[f64; 9], 6, _>(|row| {
            core::array::from_fn(|c| if row < 3 { theta[c][row] } else { change[c][row - 3] })
        });
        let now = motion(tensor, omega).at(time);
        let found = core::array::from_fn::<[f64; 9], 6, _>(|row| {
            core::array::from_fn(
                |c| if c < 3 { now.by_start[row][3 + c] } else { now.by_inertia[row][c - 3] },
            )
        });
        for block in
            [("θ by ω", 0..3, 0..3), ("ω by ω", 3..6, 0..3), ("θ by I", 0..3, 3..9), ("ω by I", 3..6, 3..9)]
        {
            let error = error(&found, &expected, &block);
            assert!(error < 1e-12, "{}: {error:e}, tensor {tensor:?}, ω {omega:?}, t {time}", block.0);
            worst = worst.max(error);
        }
    }
    println!("worst {worst:.1e}");
}
