//! Elliptic integrals and Jacobi elliptic functions, compared with tables of 40 digits, and
//! identities between them.
#![allow(clippy::excessive_precision, clippy::approx_constant, reason = "the tables' digits, as they are")]

use crate::common::{cases, number, table};
use polhode::math::elliptic::{EllipticError, EllipticParameter, JacobiFunctions};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::f64::consts::{FRAC_PI_2, PI};

/// Comparison with correctly rounded values, in ulp.
#[derive(Default)]
struct Comparison {
    seen: usize,
    worst: f64,
    failures: Vec<String>,
}

impl Comparison {
    fn compare(&mut self, what: &str, got: f64, want: f64, tolerance: f64) {
        let ulp = want.abs().next_up() - want.abs();
        let error = if got == want { 0.0 } else { (got - want) / ulp };
        self.seen += 1;
        self.worst = self.worst.max(error.abs());
        // Negated so that NaN fails.
        if !(error.abs() <= tolerance) {
            self.failures.push(format!("{what}: {got:e} for {want:e}, {error} ulp"));
        }
    }

    fn jacobi(&mut self, what: &str, got: JacobiFunctions, want: [f64; 4], tolerance: f64) {
        let functions = [("sn", got.sn), ("cn", got.cn), ("dn", got.dn), ("am", got.am)];
        for ((name, got), want) in functions.into_iter().zip(want) {
            self.compare(&format!("{name}({what})"), got, want, tolerance);
        }
    }

    fn conclude(self, least: usize) {
        assert!(self.seen >= least, "only {} values", self.seen);
        assert!(self.failures.is_empty(), "{}\nworst: {} ulp", self.failures.join("\n"), self.worst);
    }
}

/// Tolerance in ulp: the nearest double may be missed if the exact value is close to the midpoint
/// of two doubles.
const ROUNDED: f64 = 1.0;
/// Tolerance at m = 1, where the functions are those of libm.
const HYPERBOLIC: f64 = 3.0;

fn given(by: &str, value: f64) -> EllipticParameter {
    match by {
        "m" => EllipticParameter::new(value).unwrap(),
        "m1" => EllipticParameter::from_complement(value).unwrap(),
        other => panic!("given by {other}?"),
    }
}

#[test]
fn every_value_of_the_table_is_met_to_the_last_place() {
    let table = table("elliptic");
    let list = |value: &toml::Value| -> Vec<f64> { value.as_array().unwrap().iter().map(number).collect() };
    let characteristics = list(&table["characteristics"]);
    let mut comparison = Comparison::default();
    for case in cases(&table, "parameter") {
        let by = case["given"].as_str().unwrap();
        let p = given(by, number(&case[by]));
        let name = format!("{by} = {:e}", number(&case[by]));
        let mut compare =
            |what: String, got, want| comparison.compare(&format!("{what}, {name}"), got, want, ROUNDED);
        compare("m".into(), p.m(), number(&case["m"]));
        compare("m1".into(), p.complement(), number(&case["m1"]));
        compare("E".into(), p.e(), number(&case["e"]));
        match case.get("k") {
            Some(k) => compare("K".into(), p.k(), number(k)),
            None => assert!(p.k() == f64::INFINITY && p.pi(0.3) == Ok(f64::INFINITY)),
        }
        if let Some(pi) = case.get("pi") {
            for (&n, want) in characteristics.iter().zip(list(pi)) {
                compare(format!("Pi, n = {n:e}"), p.pi(n).unwrap(), want);
            }
        }
        for row in cases(case, "incomplete") {
            let phi = number(&row["phi"]);
            compare(format!("E({phi:e})"), p.incomplete_e(phi), number(&row["e"]));
            match row.get("f") {
                Some(f) => compare(format!("F({phi:e})"), p.incomplete_f(phi), number(f)),
                None => assert_eq!(p.incomplete_f(phi), f64::INFINITY.copysign(phi)),
            }
            if let Some(pi) = row.get("pi") {
                for (&n, want) in characteristics.iter().zip(list(pi)) {
                    compare(format!("Pi({phi:e}), n = {n:e}"), p.incomplete_pi(n, phi).unwrap(), want);
                }
            }
        }
        let tolerance = if p.complement() == 0.0 { HYPERBOLIC } else { ROUNDED };
        for row in cases(case, "jacobi") {
            let u = number(&row["u"]);
            let want = ["sn", "cn", "dn", "am"].map(|key| number(&row[key]));
            comparison.jacobi(&format!("{u:e}, {name}"), p.jacobi(u), want, tolerance);
        }
    }
    comparison.conclude(3200);
}

/// References by fixtures/elliptic.py: the doubles nearest to a zero of sn or cn, after up to 10⁵
/// periods.
#[test]
fn the_nearest_double_to_a_distant_zero_keeps_its_digits() {
    let mut comparison = Comparison::default();
    for (by, value, u, want) in [
        ("m", 0.3, 3.427778896357582, [1.8299096433907169058e-16, -1.0, 1.0, 3.1415926535897930555]),
        (
            "m",
            0.3,
            11.997226137251538,
            [-1.0, 2.0724909241531679139e-16, 0.83666002653407555461, 10.995574287564276542],
        ),
        ("m", 0.3, 685555.7792715164, [-5.5356521091880983024e-11, 1.0, 1.0, 628318.53071795859234]),
        (
            "m",
            0.3,
            685557.4931609646,
            [1.0, 2.4378996276253771259e-11, 0.83666002653407555461, 628320.10151428541821],
        ),
        ("m1", 1e-9, 23.495854564560155, [1.3317721827456094491e-15, -1.0, 1.0, 3.1415926535897919067]),
        (
            "m1",
            1e-9,
            82.23549097596054,
            [-1.0, -3.5053498773099808376e-20, 3.1622776601683794305e-5, 10.995574287564276335],
        ),
        ("m1", 1e-9, 4699170.912912032, [4.4077769407932981514e-10, 1.0, 1.0, 628318.53071795908847]),
        (
            "m1",
            1e-9,
            4699182.660839314,
            [1.0, -5.2572291859543811166e-15, 3.1622776601683794305e-5, 628320.10151428544259],
        ),
        ("m", -4.0, 2.018905819978423, [1.0490076227816454349e-16, -1.0, 1.0, 3.1415926535897931336]),
        (
            "m",
            -4.0,
            7.066170369924481,
            [-1.0, -8.2097832370932567761e-16, 2.2360679774997896964, 10.995574287564275514],
        ),
        ("m", -4.0, 403781.16399568465, [5.281507058060394171e-12, 1.0, 1.0, 628318.53071795865297]),
        (
            "m",
            -4.0,
            403782.17344859464,
            [1.0, -8.8445527302117543185e-12, 2.2360679774997896964, 628320.10151428545143],
        ),
    ] {
        comparison.jacobi(&format!("{u}, {by} = {value}"), given(by, value).jacobi(u), want, ROUNDED);
    }
    comparison.conclude(48);
}

/// References by fixtures/elliptic.py: characteristics and parameters that are not in its table.
#[test]
fn the_third_kind_is_right_at_the_ends_of_the_range() {
    let mut comparison = Comparison::default();
    let quarter = f64::NAN;
    for (by, value, n, phi, want) in [
        ("m", -10.0, -0.5, quarter, 0.68381492647577473789),
        ("m", -10.0, -300.0, 2.5, 0.083987600619829799335),
        ("m", -1e6, 0.9, -4.0, -0.032044275044885125117),
        ("m", 0.7, -1e30, 1.2, 1.5707963267948967612e-15),
        ("m1", 1e-300, -1e100, quarter, 1.5707963267948966067e-50),
        ("m", 0.5, 0.9999999999999999, quarter, 2.1082871328594347314e8),
        ("m", -1e245, -1e70, quarter, 6.3931559636282597924e-121),
        ("m1", 1e300, -3.0, 1e-150, 8.8137358701954302511e-151),
        ("m1", 1e-40, 0.9999999999999999, FRAC_PI_2, 1.7080762586567010617e17),
        ("m", 0.99, -2.0, 12345.678, 13199.497199058498244),
    ] {
        let p = given(by, value);
        let got = if phi.is_nan() { p.pi(n) } else { p.incomplete_pi(n, phi) };
        comparison.compare(&format!("Pi({phi:e}), n = {n:e}, {by} = {value:e}"), got.unwrap(), want, ROUNDED);
    }
    comparison.conclude(10);
}

#[test]
fn at_zero_they_are_circular_however_far() {
    let (mut comparison, p) = (Comparison::default(), given("m", 0.0));
    for u in [0.7, 1e5, 1e10, 1e15, 1e22, -3e22] {
        comparison.jacobi(&format!("{u:e}, m = 0"), p.jacobi(u), [u.sin(), u.cos(), 1.0, u], ROUNDED);
        comparison.compare(&format!("F({u:e}), m = 0"), p.incomplete_f(u), u, ROUNDED);
    }
    comparison.conclude(30);
}

#[test]
fn what_has_no_integral_is_refused() {
    let infinite = f64::INFINITY;
    for m in [1.0 + f64::EPSILON, 2.0, infinite, -infinite] {
        assert_eq!(EllipticParameter::new(m), Err(EllipticError::Parameter { m }));
    }
    for m1 in [-5e-324, -1.0, infinite, -infinite] {
        assert_eq!(EllipticParameter::from_complement(m1), Err(EllipticError::Complement { m1 }));
    }
    assert!(
        EllipticParameter::new(f64::NAN).is_err() && EllipticParameter::from_complement(f64::NAN).is_err()
    );
    let p = EllipticParameter::new(0.5).unwrap();
    for n in [1.0, 1.5, infinite, -infinite] {
        assert_eq!(p.pi(n), Err(EllipticError::Characteristic { n }));
        assert_eq!(p.incomplete_pi(n, 0.1), Err(EllipticError::Characteristic { n }));
    }
    assert!(p.pi(f64::NAN).is_err());
    assert_eq!(
        EllipticParameter::new(1.5).unwrap_err().to_string(),
        "the elliptic parameter m = 1.5 must be finite and at most 1"
    );
    // Infinite amplitudes and arguments give values, not errors.
    assert_eq!((p.incomplete_f(infinite), p.incomplete_e(-infinite)), (infinite, -infinite));
    assert!(p.incomplete_f(f64::NAN).is_nan() && p.incomplete_pi(0.1, f64::NAN).unwrap().is_nan());
    assert!(p.jacobi(infinite).sn.is_nan() && p.jacobi(f64::NAN).am.is_nan());
}

#[test]
fn finite_arguments_never_give_nan() {
    let max = f64::MAX;
    let parameters = [-max, -1e300, -1e-310, 0.0, 5e-324, 0.5, 1.0 - 1e-16, 1.0].map(|m| given("m", m));
    let complements = [0.0, 5e-324, 1e-320, 1e-300, 1e-16, 1.0, 1e308, max].map(|m1| given("m1", m1));
    let arguments =
        [0.0, 5e-324, 1e-200, 1e-9, 1.0, FRAC_PI_2, FRAC_PI_2.next_up(), 800.0, 1e22, 1e50, 1e300, max];
    for p in parameters.into_iter().chain(complements) {
        assert!(p.k() > 0.0 && p.e() > 0.0, "{p:?}");
        for x in arguments.into_iter().flat_map(|x| [x, -x]) {
            let at = p.jacobi(x);
            assert!(
                at.sn.abs() <= 1.0 && at.cn.abs() <= 1.0 && at.dn >= 0.0 && !at.am.is_nan(),
                "{p:?} {x} {at:?}"
            );
            // Odd functions with the sign of φ
            let (f, e) = (p.incomplete_f(x), p.incomplete_e(x));
            assert!(f * x.signum() >= 0.0 && f == -p.incomplete_f(-x), "{p:?} {x} {f}");
            assert!(e * x.signum() >= 0.0 && e == -p.incomplete_e(-x), "{p:?} {x} {e}");
            for n in [-max, -1e300, -1e20, -1.0, -5e-324, 0.0, 0.3, 1.0 - 1e-16] {
                assert!(p.pi(n).unwrap() > 0.0, "{p:?} {n}");
                assert!(p.incomplete_pi(n, x).unwrap() * x.signum() >= 0.0, "{p:?} {n} {x}");
            }
        }
    }
}

/// m of every kind, given by m or by its complement.
fn parameter() -> impl Strategy<Value = EllipticParameter> {
    prop_oneof![
        (0.0..1.0).prop_map(|m| given("m", m)),
        (-50.0..0.0).prop_map(|m| given("m", m)),
        (-300.0..0.0).prop_map(|x| given("m1", 10f64.powf(x))),
        (-300.0..0.0).prop_map(|x| given("m", 10f64.powf(x))),
    ]
}

fn characteristic() -> impl Strategy<Value = f64> {
    prop_oneof![-1.0..1.0, -100.0..-1.0, (-15.0..0.0).prop_map(|x| 1.0 - 10f64.powf(x))]
}

/// Checks |a − b| in ε times the size of the terms.
fn close(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= 4.0 * f64::EPSILON * size
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, rng_seed: RngSeed::Fixed(11), ..ProptestConfig::default() })]

    #[test]
    fn squares_add_up_to_one(p in parameter(), w in -30.0..30.0) {
        let JacobiFunctions { sn, cn, dn, am } = p.jacobi(w * p.k());
        prop_assert!(close(sn * sn + cn * cn, 1.0, 1.0));
        prop_assert!(close(dn * dn + p.m() * sn * sn, 1.0, dn * dn + p.m().abs() + 1.0));
        // without cancellation
        prop_assert!(close(dn * dn, cn * cn + p.complement() * sn * sn, dn * dn));
        prop_assert!(close(am.sin(), sn, 1.0 + am.abs()) && close(am.cos(), cn, 1.0 + am.abs()));
    }

    #[test]
    fn the_amplitude_is_the_inverse_of_the_first_kind(p in parameter(), phi in -20.0..20.0) {
        let u = p.incomplete_f(phi);
        // u is rounded, and the amplitude changes at the rate dn
        let at = p.jacobi(u);
        prop_assert!(close(at.am, phi, phi.abs() + at.dn * u.abs()), "{u} {}", at.am);
    }

    #[test]
    fn quarters_are_where_they_should_be(p in parameter(), phi in -20.0..20.0, n in characteristic()) {
        // F(π/2) = K except for the distance of the double from π/2, and whole half turns add 2K
        prop_assume!(p.complement() > 1e-12 && n < 0.999);
        let (up, down) = (phi + PI, phi);
        let size = |x: f64| 40.0 * x / (1.0 - n).min(1.0) / p.complement().min(1.0).sqrt();
        prop_assert!(close(p.incomplete_f(up) - p.incomplete_f(down), 2.0 * p.k(), size(p.k())));
        prop_assert!(close(p.incomplete_e(up) - p.incomplete_e(down), 2.0 * p.e(), size(p.e())));
        let [up, down] = [up, down].map(|phi| p.incomplete_pi(n, phi).unwrap());
        let pi = p.pi(n).unwrap();
        prop_assert!(close(up - down, 2.0 * pi, size(pi)), "{up} {down} {pi}");
    }

    #[test]
    fn legendres_relation_holds(m in 1e-9..1.0) {
        // E K′ + E′ K − K K′ = π/2, with both parameters exact
        let (p, q) = (given("m", m), given("m1", m));
        let [a, b, c] = [p.e() * q.k(), q.e() * p.k(), p.k() * q.k()];
        prop_assert!(close(a + b - c, FRAC_PI_2, a + b + c));
    }

    #[test]
    fn integrals_grow_at_the_rate_of_their_integrands(m in -3.0..0.95, n in -3.0..0.9, phi in -5.0..5.0_f64) {
        let p = given("m", m);
        let h = 1e-4;
        let rate = |f: &dyn Fn(f64) -> f64| (f(phi + h) - f(phi - h)) / (2.0 * h);
        let s2 = phi.sin() * phi.sin();
        let delta = (1.0 - m * s2).sqrt();
        let is = |rate: f64, integrand: f64| (rate / integrand - 1.0).abs() < 1e-5;
        prop_assert!(is(rate(&|x| p.incomplete_f(x)), 1.0 / delta));
        prop_assert!(is(rate(&|x| p.incomplete_e(x)), delta));
        prop_assert!(is(rate(&|x| p.incomplete_pi(n, x).unwrap()), 1.0 / ((1.0 - n * s2) * delta)));
        prop_assert!(is(rate(&|u| p.jacobi(u).am), p.jacobi(phi).dn));
    }

    #[test]
    fn the_third_kind_has_the_others_in_it(p in parameter(), phi in -20.0..20.0_f64, n in -50.0..0.9_f64) {
        prop_assert_eq!(p.incomplete_pi(0.0, phi).unwrap(), p.incomplete_f(phi));
        prop_assert!(close(p.pi(0.0).unwrap(), p.k(), p.k()));
        // m = 0:  Π(n) = arctan(√(1 − n) tan φ)/√(1 − n)
        let circular = given("m", 0.0);
        let (phi, root) = (phi / 13.0, (1.0 - n).sqrt());
        let value = (root * phi.tan()).atan() / root;
        prop_assert!(close(circular.incomplete_pi(n, phi).unwrap(), value, 2.0 * value.abs()));
        prop_assert!(close(circular.pi(n).unwrap(), FRAC_PI_2 / root, FRAC_PI_2 / root));
    }
}
