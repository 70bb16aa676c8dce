//! Fixed-step methods.

use polhode::infer::judge::{Cause, Scheme, Turn};

use super::program::*;
use super::scene::*;

/// Returns a log of steps with the right acceleration by the map `step`.
fn mapped(
    right: Equations,
    each: usize,
    h: f64,
    step: impl Fn(&dyn Fn(Q, V) -> V, Q, V) -> (Q, V),
) -> Vec<(f64, Q, V)> {
    run(start(), h, each, 300, |_, q, w| step(&|q, w| right.acceleration(q, w), q, w))
}

pub(super) fn is_scheme(cause: &Cause, wanted: Scheme, h: f64) -> bool {
    matches!(cause, Cause::Method { scheme, step } if *scheme == wanted && (step - h).abs() < 0.02 * h)
}

#[test]
fn methods_of_order_one() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        for (each, h) in [(1, 0.01), (7, 0.01)] {
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
            // L along space axes: ω_s = R I⁻¹ Rᵀ L, with the torque added first
            let log = mapped(right, each, h, |_, q, w| {
                let inertia = right.tensor;
                let l = to_space(q, add(times(&inertia, w), (right.torque)(q), h));
                let rate = to_space(q, times(&inverse(&inertia), to_body(q, l)));
                let q = unit(hamilton(exponential(rate.map(|c| c * h)), q));
                (q, times(&inverse(&inertia), to_body(q, l)))
            });
            // Without a torque, the order of L and attitude has no effect.
            require_named(&scenario, &log, h, |c| is_scheme(c, Scheme::MomentumFirst(Turn::Exponential), h));
            // First-order attitude, correct ω
            let log = mapped(right, each, h, |a, q, w| {
                let (_, after) = rk4(0.0, q, w, h, &|_, q, w| (turning(q, w), a(q, w)));
                (first_order(q, w, h), after)
            });
            require_named(&scenario, &log, h, |c| is_scheme(c, Scheme::HeldAtStart(Turn::FirstOrder), h));
            // One Newton step for the implicit gyroscopic term
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

/// Returns a log of free motion with the gyroscopic term of a physics engine: the new ω as a
/// function of the old one.
fn engine_log(h: f64, each: usize, omega: impl Fn(V) -> V) -> Vec<(f64, Q, V)> {
    run(start(), h, each, 300, |_, q, w| {
        let w = omega(w);
        (hamilton(q, exponential(w.map(|c| c * h))), w)
    })
}

fn newton(w: V, h: f64) -> V {
    let inertia = right().tensor;
    let l = times(&inertia, w);
    let skew = |v: V| [[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]];
    let wi = product(&skew(w), &inertia);
    let j = [0, 1, 2].map(|k| [0, 1, 2].map(|m| inertia[k][m] + h * (wi[k][m] - skew(l)[k][m])));
    add(w, times(&inverse(&j), cross(w, l)), -h)
}

#[test]
fn gyroscopic_terms_of_engines() {
    let inertia = right().tensor;
    for h in [0.01, 1.0 / 60.0] {
        let lagged = engine_log(h, 3, |w| {
            let l = times(&inertia, w);
            let skew = [[0.0, -l[2], l[1]], [l[2], 0.0, -l[0]], [-l[1], l[0], 0.0]];
            let m = [0, 1, 2].map(|k| add(inertia[k], skew[k], -h));
            times(&inverse(&m), l)
        });
        require_named(&free(), &lagged, h, |c| is_scheme(c, Scheme::LaggedMomentum(Turn::Exponential), h));
        let rescaled = engine_log(h, 3, |w| {
            let l = times(&inertia, w);
            let turned = add(l, cross(l, w), h);
            times(&inverse(&inertia), turned.map(|c| c * norm(l) / norm(turned)))
        });
        require_named(&free(), &rescaled, h, |c| {
            is_scheme(c, Scheme::RescaledMomentum(Turn::Exponential), h)
        });
        // With damping as large as the method's error, only both together explain it.
        let damped = engine_log(h, 1, |w| newton(w, h).map(|c| c * (1.0 - 0.04 * h)));
        require_named(&free(), &damped, h, |c| {
            matches!(c, Cause::MethodWithDamping { scheme: Scheme::ImplicitGyroscopic(Turn::Exponential), rate, .. }
                if (rate - 0.04).abs() < 1e-3)
        });
    }
}

#[test]
fn rk4_with_the_attitude_by_the_mean_rate() {
    let h = 0.02;
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let log = mapped(right, 2, h, |a, q, w| {
            let at = |w: V, s: f64| hamilton(q, exponential(w.map(|c| c * s)));
            let a1 = a(q, w);
            let w2 = add(w, a1, 0.5 * h);
            let a2 = a(at(w, 0.5 * h), w2);
            let w3 = add(w, a2, 0.5 * h);
            let a3 = a(at(w2, 0.5 * h), w3);
            let w4 = add(w, a3, h);
            let a4 = a(at(w3, h), w4);
            let mean =
                |a: V, b: V, c: V, d: V| [0, 1, 2].map(|k| (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]) / 6.0);
            (at(mean(w, w2, w3, w4), h), add(w, mean(a1, a2, a3, a4), h))
        });
        require_named(&scenario, &log, h, |c| is_scheme(c, Scheme::RungeKutta4MeanRate, h));
    }
}

#[test]
fn many_steps_for_each_row() {
    let h = 0.001;
    let log = mapped(right(), 50, h, |a, q, w| {
        let w = add(w, a(q, w), h);
        (hamilton(q, exponential(w.map(|c| c * h))), w)
    });
    require_named(&free(), &log, h, |c| is_scheme(c, Scheme::SemiImplicitEuler(Turn::Exponential), h));
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
