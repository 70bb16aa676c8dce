//! Causes of wrong motions, planted by a program of the test's own and named.

use polhode::infer::judge::ReadMotion;
use polhode::infer::judge::{Cause, Causes, Scheme, TriedStart, Turn, Untried, causes};
use polhode::prelude::*;

mod program;
use program::*;

const MASS: f64 = 2.3;
const CENTER: V = [0.31, -0.17, 0.23];
const MOMENTS: V = [1.3, 2.1, 2.9];
const PRODUCTS: V = [0.25, -0.35, 0.15];

fn tensor(moments: V, products: V) -> M {
    let ([a, b, c], [d, e, f]) = (moments, products);
    [[a, d, e], [d, b, f], [e, f, c]]
}

fn body() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products(MOMENTS, PRODUCTS).unwrap();
    MassProperties::new(MASS, Position::from_array(CENTER), inertia).unwrap()
}

fn start() -> (Q, V) {
    (unit([0.4, -0.7, 1.1, 0.3]), [0.7, -1.1, 1.6])
}

fn free() -> Scenario {
    let (q, w) = start();
    let attitude = Attitude::from_quaternion(q).unwrap();
    Scenario::new(body())
        .starting(State { time: 0.0, attitude, omega: AngularVelocity::from_array(w) })
        .unwrap()
}

const BODY_TORQUE: V = [0.6, -0.45, 0.35];
const SPACE_TORQUE: V = [-0.5, 0.4, 0.7];

/// Under a torque along body axes and one along space axes.
fn driven() -> Scenario {
    let body = TorqueModel::Constant(ConstantTorque::Body(Torque::from_array(BODY_TORQUE)));
    let space = TorqueModel::Constant(ConstantTorque::Space(Torque::from_array(SPACE_TORQUE)));
    free().under([body, space]).unwrap()
}

/// What it logs: with ω, or without.
fn found(scenario: &Scenario, log: &[(f64, Q, V)], with_omega: bool, step: Option<f64>) -> Causes {
    let times: Vec<f64> = log.iter().map(|row| row.0).collect();
    let exact =
        Simulation::new(scenario.rotor(), scenario.torques(), scenario.start(), &times).states().unwrap();
    let omega = log.iter().map(|row| AngularVelocity::from_array(row.2)).collect();
    let motion = ReadMotion {
        times,
        attitude: log.iter().map(|row| row.1).collect(),
        omega: with_omega.then_some(omega),
    };
    causes(scenario, &motion, &exact, step)
}

/// The first named, of runs with and without ω and with and without the step.
fn require_named(scenario: &Scenario, log: &[(f64, Q, V)], step: f64, is_it: impl Fn(&Cause) -> bool) {
    for (with_omega, step) in [(true, Some(step)), (true, None), (false, Some(step)), (false, None)] {
        let found = found(scenario, log, with_omega, step);
        let first = found.likeliest().map(|tried| tried.cause.clone());
        let all: String = found
            .tried
            .iter()
            .take(6)
            .map(|t| format!("\n {:.2e} {:.2e} {}", t.residual, t.error, t.cause))
            .collect();
        assert!(first.as_ref().is_some_and(&is_it), "ω {with_omega}, step {step:?}: {first:?}{all}");
    }
}

fn require_not_accused(scenario: &Scenario, log: &[(f64, Q, V)], step: f64) {
    for (with_omega, step) in [(true, Some(step)), (true, None), (false, Some(step)), (false, None)] {
        let found = found(scenario, log, with_omega, step);
        let accused: Vec<String> = found
            .named()
            .filter(|tried| tried.cause.is_mistake())
            .map(|t| format!("{} {:.2e} of {:.2e}", t.cause, t.residual, t.error))
            .collect();
        assert!(accused.is_empty(), "ω {with_omega}, step {step:?}: {accused:?}");
    }
}

/// The program's equations: tensor, torque in body axes, and what differs.
#[derive(Clone, Copy)]
struct Equations {
    tensor: M,
    gyroscopic: f64,
    torque: fn(Q) -> V,
    damping: f64,
}

fn no_torque(_: Q) -> V {
    [0.0; 3]
}

fn right_torque(q: Q) -> V {
    add(BODY_TORQUE, to_body(q, SPACE_TORQUE), 1.0)
}

const RIGHT: Equations =
    Equations { tensor: [[0.0; 3]; 3], gyroscopic: 1.0, torque: no_torque, damping: 0.0 };

impl Equations {
    fn acceleration(&self, q: Q, w: V) -> V {
        let gyroscopic = cross(times(&self.tensor, w), w).map(|c| c * self.gyroscopic);
        let force = add(gyroscopic, (self.torque)(unit(q)), 1.0);
        add(times(&inverse(&self.tensor), force), w, -self.damping)
    }

    /// 400 rows of 0.05 s, of steps that leave no error.
    fn log(&self) -> Vec<(f64, Q, V)> {
        let h = 0.005;
        run(start(), h, 10, 400, |t, q, w| {
            rk4(t, q, w, h, &|_, q, w| (turning(q, w), self.acceleration(q, w)))
        })
    }
}

fn right() -> Equations {
    Equations { tensor: tensor(MOMENTS, PRODUCTS), ..RIGHT }
}

fn right_driven() -> Equations {
    Equations { torque: right_torque, ..right() }
}

#[test]
fn no_gyroscopic_term() {
    let is_it = |cause: &Cause| *cause == Cause::NoGyroscopicTerm;
    require_named(&free(), &Equations { gyroscopic: 0.0, ..right() }.log(), 0.005, is_it);
    require_named(&driven(), &Equations { gyroscopic: 0.0, ..right_driven() }.log(), 0.005, is_it);
}

#[test]
fn omega_in_the_wrong_frame() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let h = 0.005;
        let log = |turned: fn(Q, V) -> V| {
            run(start(), h, 10, 400, |t, q, w| {
                rk4(t, q, w, h, &|_, q, w| (turning(q, turned(q, w)), right.acceleration(q, w)))
            })
        };
        require_named(&scenario, &log(|q, w| to_body(unit(q), w)), h, |c| *c == Cause::OmegaBodyAsSpace);
        require_named(&scenario, &log(|q, w| to_space(unit(q), w)), h, |c| *c == Cause::OmegaSpaceAsBody);
    }
}

#[test]
fn quaternions_of_another_meaning() {
    let log = right().log();
    let with =
        |change: fn(Q) -> Q| -> Vec<(f64, Q, V)> { log.iter().map(|&(t, q, w)| (t, change(q), w)).collect() };
    require_named(&free(), &with(|[w, x, y, z]| [w, -x, -y, -z]), 0.005, |c| *c == Cause::ConjugateAttitude);
    require_named(&free(), &with(|[w, x, y, z]| [x, y, z, w]), 0.005, |c| *c == Cause::ScalarLast);
}

#[test]
fn wrong_tensors() {
    let principal = body().principal();
    let axes: M = principal.axes().map(|axis| axis.to_array());
    let [a, b, c] = principal.moments();
    let diagonal = [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]];
    // The right one is axesᵀ D axes: the rows of `axes` are the principal axes.
    let transposed_one = product(&axes, &product(&diagonal, &transposed(&axes)));
    let reversed = [axes[2], axes[0].map(|c| -c), axes[1]];
    let reversed =
        product(&reversed, &product(&[[c, 0.0, 0.0], [0.0, a, 0.0], [0.0, 0.0, b]], &transposed(&reversed)));
    let [x, y, z] = CENTER;
    let r2 = x * x + y * y + z * z;
    let moved = |k: usize, l: usize| MASS * (if k == l { r2 } else { 0.0 } - CENTER[k] * CENTER[l]);
    let about_origin = [0, 1, 2].map(|k| [0, 1, 2].map(|l| tensor(MOMENTS, PRODUCTS)[k][l] + moved(k, l)));
    let [p, q, r] = PRODUCTS;
    let cases: [(M, fn(&Cause) -> bool); 7] = [
        (transposed_one, |c| *c == Cause::TensorTransposed),
        (reversed, |c| *c == Cause::TensorTransposed),
        (diagonal, |c| *c == Cause::PrincipalMomentsAlongBodyAxes([0, 1, 2])),
        (tensor(MOMENTS, [-p, -q, -r]), |c| *c == Cause::ProductsReversed),
        (tensor(MOMENTS, [0.0; 3]), |c| *c == Cause::ProductsLeftOut),
        (tensor(MOMENTS, [r, q, p]), |c| *c == Cause::ProductsReordered([2, 1, 0])),
        (about_origin, |c| *c == Cause::TensorAboutOrigin),
    ];
    for (tensor, is_it) in cases {
        require_named(&free(), &Equations { tensor, ..right() }.log(), 0.005, is_it);
        require_named(&driven(), &Equations { tensor, ..right_driven() }.log(), 0.005, is_it);
    }
}

#[test]
fn the_tensor_of_another_body() {
    let tensor = tensor([1.6, 1.9, 2.6], [-0.1, -0.2, 0.3]);
    for (scenario, right, scale) in [(free(), right(), false), (driven(), right_driven(), true)] {
        let log = Equations { tensor, ..right }.log();
        require_named(&scenario, &log, 0.005, |cause| {
            let Cause::OtherTensor { tensor: found, has_scale } = cause else { return false };
            let times = if scale { 1.0 } else { 6.3 / 6.1 };
            let error = (0..3)
                .flat_map(|k| (0..3).map(move |l| (k, l)))
                .map(|(k, l)| (found[k][l] / times - tensor[k][l]).abs());
            // With ω from differences of the attitudes it is good to the square of the spacing.
            *has_scale == scale && error.fold(0.0, f64::max) < 0.03
        });
    }
}

fn pivoted_torque(q: Q) -> V {
    let weight = to_body(q, [0.0, 0.0, -9.80665 * MASS]);
    cross(CENTER, weight)
}

#[test]
fn the_tensor_about_the_wrong_point_of_a_top() {
    let top = free().held_at(Position::ZERO).unwrap();
    let top = top.under([TorqueModel::Gravity(UniformGravity::STANDARD)]).unwrap();
    let log = Equations { torque: pivoted_torque, ..right() }.log();
    require_named(&top, &log, 0.005, |c| *c == Cause::TensorAboutCenterOfMass);
}

#[test]
fn wrong_torques() {
    fn reversed(q: Q) -> V {
        right_torque(q).map(|c| -c)
    }
    fn body_only(_: Q) -> V {
        BODY_TORQUE
    }
    fn body_as_space(q: Q) -> V {
        add(to_body(q, BODY_TORQUE), to_body(q, SPACE_TORQUE), 1.0)
    }
    fn larger(q: Q) -> V {
        right_torque(q).map(|c| 1.02 * c)
    }
    fn space_as_body(_: Q) -> V {
        SPACE_TORQUE
    }
    let log = |torque: fn(Q) -> V| Equations { torque, ..right() }.log();
    require_named(&driven(), &log(reversed), 0.005, |c| *c == Cause::TorqueReversed { torque: None });
    require_named(&driven(), &log(no_torque), 0.005, |c| *c == Cause::TorqueLeftOut { torque: None });
    require_named(&driven(), &log(body_only), 0.005, |c| {
        matches!(c, Cause::TorqueLeftOut { torque: Some(_) })
    });
    require_named(&driven(), &log(body_as_space), 0.005, |c| {
        matches!(c, Cause::TorqueBodyAsSpace { torque: Some(_) })
    });
    require_named(
        &driven(),
        &log(larger),
        0.005,
        |c| matches!(c, Cause::TorqueScaled { factor } if (factor - 1.02).abs() < 1e-6),
    );
    let space = TorqueModel::Constant(ConstantTorque::Space(Torque::from_array(SPACE_TORQUE)));
    let scenario = free().under([space]).unwrap();
    require_named(&scenario, &log(space_as_body), 0.005, |c| *c == Cause::TorqueSpaceAsBody { torque: None });
}

#[test]
fn damping_and_limits() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let log = Equations { damping: 0.05, ..right }.log();
        require_named(
            &scenario,
            &log,
            0.005,
            |c| matches!(c, Cause::Damping { rate } if (rate - 0.05).abs() < 1e-6),
        );
        let log = Equations { damping: 0.05, gyroscopic: 0.0, ..right }.log();
        require_named(
            &scenario,
            &log,
            0.005,
            |c| matches!(c, Cause::DampingWithoutGyroscopicTerm { rate } if (rate - 0.05).abs() < 1e-6),
        );
    }
    // As the engine of a game: 7 rad/s at most, from a body at 9.
    let (q, w) = start();
    let w = w.map(|c| 4.5 * c);
    let scenario = free();
    let fast = State { omega: AngularVelocity::from_array(w), ..scenario.start() };
    let scenario = scenario.starting(fast).unwrap();
    let h = 0.001;
    let log = run((q, w), h, 20, 400, |t, q, w| {
        let cut = |w: V| if norm(w) > 7.0 { w.map(|c| c * 7.0 / norm(w)) } else { w };
        let (q, w) = rk4(t, q, cut(w), h, &|_, q, w| (turning(q, w), right().acceleration(q, w)));
        (q, cut(w))
    });
    require_named(
        &scenario,
        &log,
        h,
        |c| matches!(c, Cause::SpeedLimit { limit, gyroscopic: true } if (limit - 7.0).abs() < 1e-6),
    );
}

/// One step with the right acceleration by a map of the test.
fn mapped(
    right: Equations,
    each: usize,
    h: f64,
    step: impl Fn(&dyn Fn(Q, V) -> V, Q, V) -> (Q, V),
) -> Vec<(f64, Q, V)> {
    run(start(), h, each, 300, |_, q, w| step(&|q, w| right.acceleration(q, w), q, w))
}

fn is_scheme(cause: &Cause, wanted: Scheme, h: f64) -> bool {
    matches!(cause, Cause::Method { scheme, step } if *scheme == wanted && (step - h).abs() < 0.02 * h)
}

#[test]
fn methods_of_order_one() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        for (each, h) in [(1, 0.01), (7, 0.01), (50, 0.001)] {
            let log = mapped(right, each, h, |a, q, w| (unit(first_order(q, w, h)), add(w, a(q, w), h)));
            require_named(&scenario, &log, h, |c| is_scheme(c, Scheme::ExplicitEuler(Turn::FirstOrder), h));
            let log = mapped(right, each, h, |a, q, w| {
                let w = add(w, a(q, w), h);
                (hamilton(q, exponential(w.map(|c| c * h))), w)
            });
            require_named(&scenario, &log, h, |c| {
                is_scheme(c, Scheme::SemiImplicitEuler(Turn::Exponential), h)
            });
            let log = mapped(right, each, h, |a, q, w| {
                let w = add(w, a(q, w), h);
                (first_order(q, w, h), w)
            });
            require_named(&scenario, &log, h, |c| {
                is_scheme(c, Scheme::SemiImplicitEuler(Turn::FirstOrder), h)
            });
            // L along space axes: ω_s = R I⁻¹ Rᵀ L, the torque added first
            let log = mapped(right, each, h, |_, q, w| {
                let inertia = right.tensor;
                let l = to_space(q, add(times(&inertia, w), (right.torque)(q), h));
                let rate = to_space(q, times(&inverse(&inertia), to_body(q, l)));
                let q = unit(hamilton(exponential(rate.map(|c| c * h)), q));
                (q, times(&inverse(&inertia), to_body(q, l)))
            });
            // Without a torque it is the same whether L or the attitude comes first.
            require_named(&scenario, &log, h, |c| is_scheme(c, Scheme::MomentumFirst(Turn::Exponential), h));
            // The attitude to first order, ω right
            let log = mapped(right, each, h, |a, q, w| {
                let (_, after) = rk4(0.0, q, w, h, &|_, q, w| (turning(q, w), a(q, w)));
                (first_order(q, w, h), after)
            });
            require_named(&scenario, &log, h, |c| is_scheme(c, Scheme::HeldAtStart(Turn::FirstOrder), h));
            // One step of Newton's for the implicit gyroscopic term
            let log = mapped(right, each, h, |_, q, w| {
                let inertia = right.tensor;
                let l = times(&inertia, w);
                let skew = |v: V| [[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]];
                let wi = product(&skew(w), &inertia);
                let j = [0, 1, 2].map(|k| [0, 1, 2].map(|m| inertia[k][m] + h * (wi[k][m] - skew(l)[k][m])));
                let f = add(cross(w, l), (right.torque)(q), -1.0);
                let w = add(w, times(&inverse(&j), f), -h);
                (hamilton(q, exponential(w.map(|c| c * h))), w)
            });
            require_named(&scenario, &log, h, |c| {
                is_scheme(c, Scheme::ImplicitGyroscopic(Turn::Exponential), h)
            });
        }
    }
}

fn midpoint_log(right: Equations, each: usize, h: f64) -> Vec<(f64, Q, V)> {
    mapped(right, each, h, |a, q, w| {
        let (dq, dw) = (turning(q, w), a(q, w));
        let (p, v) = ([0, 1, 2, 3].map(|k| q[k] + 0.5 * h * dq[k]), add(w, dw, 0.5 * h));
        let (dq, dw) = (turning(p, v), a(p, v));
        (unit([0, 1, 2, 3].map(|k| q[k] + h * dq[k])), add(w, dw, h))
    })
}

fn rk4_log(right: Equations, each: usize, h: f64) -> Vec<(f64, Q, V)> {
    mapped(right, each, h, |a, q, w| rk4(0.0, q, w, h, &|_, q, w| (turning(q, w), a(q, w))))
}

#[test]
fn the_error_of_right_methods_is_no_mistake() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        for (each, h) in [(1, 0.05), (3, 0.05)] {
            require_named(&scenario, &midpoint_log(right, each, h), h, |c| is_scheme(c, Scheme::Midpoint, h));
            require_named(&scenario, &rk4_log(right, each, h), h, |c| is_scheme(c, Scheme::RungeKutta4, h));
        }
        for (each, h) in [(1, 0.2), (2, 0.01), (5, 0.002), (1, 0.1), (20, 0.05)] {
            require_not_accused(&scenario, &midpoint_log(right, each, h), h);
            require_not_accused(&scenario, &rk4_log(right, each, h), h);
        }
    }
}

/// Numbers between −1 and 1 that repeat.
fn noise(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

fn changed(log: &[(f64, Q, V)], mut q: impl FnMut(f64) -> f64) -> Vec<(f64, Q, V)> {
    log.iter().map(|&(t, p, w)| (t, p.map(&mut q), w.map(&mut q))).collect()
}

#[test]
fn rows_of_few_digits() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let log = right.log();
        let single = changed(&log, |x| f64::from(x as f32));
        require_named(&scenario, &single, 0.005, |c| *c == Cause::RoundedRows(None));
        let written = changed(&log, |x| format!("{}", x as f32).parse().unwrap());
        require_named(&scenario, &written, 0.005, |c| *c == Cause::RoundedRows(None));
        let short = changed(&log, |x| (x * 1e5).round() / 1e5);
        require_named(&scenario, &short, 0.005, |c| *c == Cause::RoundedRows(Some(5)));
    }
}

#[test]
fn steps_in_single_precision() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let h = 0.005;
        let single = |x: f64| f64::from(x as f32);
        let log = run(start(), h, 10, 400, |t, q, w| {
            let (q, w) = rk4(t, q, w, h, &|_, q, w| (turning(q, w), right.acceleration(q, w)));
            (q.map(single), w.map(single))
        });
        require_named(&scenario, &log, h, |c| *c == Cause::SinglePrecisionArithmetic);
    }
}

#[test]
fn noise_is_no_mistake() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        for size in [1e-6, 1e-3, 0.1] {
            let mut seed = 12_345;
            let noisy = changed(&right.log(), |x| x + size * noise(&mut seed));
            require_not_accused(&scenario, &noisy, 0.005);
        }
    }
}

#[test]
fn another_start() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let (q, w) = start();
        let h = 0.005;
        let from = |start: (Q, V), right: Equations| {
            run(start, h, 10, 400, |t, q, w| {
                rk4(t, q, w, h, &|_, q, w| (turning(q, w), right.acceleration(q, w)))
            })
        };
        let turned = (hamilton(q, exponential([0.02, -0.03, 0.01])), w);
        require_named(&scenario, &from(turned, right), h, |c| matches!(c, Cause::OtherStart { .. }));
        require_named(&scenario, &from((q, to_body(q, w)), right), h, |c| *c == Cause::StartOmegaAlongSpace);
        // Another ω: from the log it is known, else nothing is said.
        let faster = from((q, [0.71, -1.08, 1.57]), right);
        let said = found(&scenario, &faster, true, None);
        assert!(
            matches!(said.likeliest().unwrap().cause, Cause::OtherStart { .. }),
            "{:?}",
            said.likeliest()
        );
        let said = found(&scenario, &faster, false, None);
        assert!(said.mistake().is_none(), "{:?}", said.likeliest());
        // Another start, and a mistake besides.
        let turned = hamilton(q, exponential([0.2, -0.3, 0.1]));
        let both = from((turned, [0.71, -1.08, 1.57]), Equations { gyroscopic: 0.0, ..right });
        let said = found(&scenario, &both, true, None);
        assert_eq!(said.likeliest().unwrap().cause, Cause::NoGyroscopicTerm);
        assert_eq!(said.start, TriedStart::FirstRow);
    }
}

/// Fehlberg's pair with steps that keep to a tolerance, as loose as some programs have it.
fn adaptive_log(right: Equations, tolerance: f64) -> Vec<(f64, Q, V)> {
    let slope = |_: f64, q: Q, w: V| (turning(q, w), right.acceleration(q, w));
    let (mut q, mut w) = start();
    let mut log = vec![(0.0, q, w)];
    for k in 0..400 {
        let (row, mut t, mut h) = (0.05 * f64::from(k + 1), 0.05 * f64::from(k), 0.05_f64);
        while row - t > 1e-12 {
            h = h.min(row - t);
            let one = rk4(t, q, w, h, &slope);
            let half = rk4(t, q, w, 0.5 * h, &slope);
            let two = rk4(t + 0.5 * h, half.0, half.1, 0.5 * h, &slope);
            let error = norm(add(one.1, two.1, -1.0));
            if error < tolerance {
                (q, w) = two;
                t += h;
            }
            h *= if error < 0.1 * tolerance { 1.5 } else { 0.7 };
        }
        log.push((row, q, w));
    }
    log
}

/// Half a kick of L, turns about the principal axes there and back, half a kick: written along the body's axes.
fn split_log(right: Equations, each: usize, h: f64, order: [usize; 5]) -> Vec<(f64, Q, V)> {
    let (moments, axes) =
        (body().principal().moments(), body().principal().axes().map(|axis| axis.to_array()));
    let inertia = right.tensor;
    run(start(), h, each, 300, |_, q, w| {
        let mut l = add(times(&inertia, w), (right.torque)(q), 0.5 * h);
        let mut q = q;
        for (place, axis) in order.into_iter().enumerate() {
            let along = times(&[axes[axis], axes[axis], axes[axis]], l)[0];
            let angle = along / moments[axis] * if place == 2 { h } else { 0.5 * h };
            let turn = exponential(axes[axis].map(|c| c * angle));
            q = hamilton(q, turn);
            l = to_body(turn, l);
        }
        let l = add(l, (right.torque)(q), 0.5 * h);
        (unit(q), times(&inverse(&inertia), l))
    })
}

#[test]
fn right_motions_are_not_accused() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        for tolerance in [1e-3, 1e-5, 1e-7, 1e-9] {
            require_not_accused(&scenario, &adaptive_log(right, tolerance), 0.05);
        }
        for h in [0.05, 0.01, 0.002] {
            require_not_accused(&scenario, &split_log(right, 5, h, [1, 2, 0, 2, 1]), h);
            require_named(&scenario, &split_log(right, 5, h, [0, 1, 2, 1, 0]), h, |c| {
                is_scheme(c, Scheme::Splitting, h)
            });
        }
        // polhode's own
        let times: Vec<f64> = (0..400).map(|k| 0.05 * f64::from(k)).collect();
        let run = Trajectory::compute(
            scenario.rotor(),
            scenario.torques(),
            scenario.start(),
            &times,
            Method::Taylor,
            1e-13,
        )
        .unwrap();
        let log: Vec<_> = run
            .samples()
            .iter()
            .map(|sample| {
                let State { time, attitude, omega } = sample.state;
                (time, attitude.quaternion(), omega.to_array())
            })
            .collect();
        let said = found(&scenario, &log, true, None);
        assert_eq!((said.untried, said.tried.len()), (Some(Untried::Exact), 0));
    }
}
