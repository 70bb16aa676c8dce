//! Polhode, momentum trace, herpolhode and cones: points on their quadrics, in their plane, and
//! close to their chords.

use polhode::motion::Regime;
use polhode::observe::{Curve, CurveError, Herpolhode, MomentumTrace, Polhode, RollingCones};
use polhode::prelude::*;

/// A free motion, and its tensor in units that keep squares within f64.
struct Case {
    name: &'static str,
    motion: FreeMotion,
    inertia: [[f64; 3]; 3],
    units: [f64; 2],
}

impl Case {
    /// Creates a case from moments along axes given by Euler angles in the body.
    fn turned(name: &'static str, moments: [f64; 3], angles: [f64; 3], omega: [f64; 3]) -> Self {
        let r = Rotation::<Body, Principal>::from_euler313(angles).unwrap();
        let m = r.matrix();
        let element = |i: usize, j: usize| (0..3).map(|k| m[i][k] * moments[k] * m[j][k]).sum::<f64>();
        let inertia = [0, 1, 2].map(|i| [0, 1, 2].map(|j| element(i.min(j), i.max(j))));
        let products = [inertia[0][1], inertia[0][2], inertia[1][2]];
        let tensor =
            InertiaTensor::<Body>::with_negative_products([0, 1, 2].map(|k| inertia[k][k]), products)
                .unwrap();
        assert_eq!(tensor.matrix(), inertia);
        let rotor = Rotor::free(&MassProperties::new(1.0, Position::ZERO, tensor).unwrap());
        let motion = FreeMotion::of(&rotor, start(r * AngularVelocity::from_array(omega))).unwrap();
        Self { name, motion, inertia, units: [1.0; 2] }
    }

    /// Creates a case from moments along the body axes, in units of kg·m² and of rad/s.
    fn scaled(name: &'static str, moments: [f64; 3], omega: [f64; 3], units: [f64; 2]) -> Self {
        let [unit_i, unit_w] = units;
        let omega = AngularVelocity::from_array(omega.map(|w| w * unit_w));
        let start = State { time: 0.3 / unit_w, ..start(omega) };
        let motion = FreeMotion::of_moments(moments.map(|i| i * unit_i), start).unwrap();
        let [a, b, c] = moments;
        Self { name, motion, inertia: [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]], units }
    }

    /// Returns L in kg·m²/s divided by the units, from ω in rad/s.
    fn momentum(&self, omega: AngularVelocity<Body>) -> [f64; 3] {
        let w = (omega / self.units[1]).to_array();
        self.inertia.map(|row| row[0] * w[0] + row[1] * w[1] + row[2] * w[2])
    }

    /// Returns 2T and |L|² divided by the units.
    fn quadrics(&self, omega: AngularVelocity<Body>) -> [f64; 2] {
        let l = self.momentum(omega);
        let w = (omega / self.units[1]).to_array();
        [l[0] * w[0] + l[1] * w[1] + l[2] * w[2], l[0] * l[0] + l[1] * l[1] + l[2] * l[2]]
    }

    fn fastest(&self) -> f64 {
        let [a1, _, a3] = self.motion.amplitudes();
        a1.hypot(a3)
    }
}

fn start(omega: AngularVelocity<Body>) -> State {
    State { time: 0.3, attitude: Attitude::from_euler313([0.4, 1.1, -2.0]).unwrap(), omega }
}

/// Returns ω3 for which L² − 2T i2 is `excess` times its first term.
fn near_separatrix([i1, i2, i3]: [f64; 3], w1: f64, excess: f64) -> f64 {
    (i1 * (i2 - i1) * w1 * w1 * (1.0 + excess) / (i3 * (i3 - i2))).sqrt()
}

const ANGLES: [f64; 3] = [0.7, 1.9, -2.6];

fn moving() -> Vec<Case> {
    let generic = [2.0, 3.1, 4.3];
    let w3 = |excess| near_separatrix(generic, -0.8, excess);
    vec![
        Case::turned("short axis", [3.1, 4.3, 2.0], ANGLES, [0.4, -1.2, 0.3]),
        Case::turned("long axis", [4.3, 2.0, 3.1], ANGLES, [-0.2, 1.3, 0.5]),
        Case::turned("small wobble", generic, ANGLES, [1e-3, -2e-3, -1.5]),
        Case::turned("short axis, near separatrix", generic, ANGLES, [-0.8, 0.3, w3(1e-9)]),
        Case::turned("long axis, near separatrix", generic, ANGLES, [-0.8, 0.3, -w3(-1e-9)]),
        Case::turned("resting near axis 2", generic, ANGLES, [-1e-5, 1.0, 1e-5]),
        Case::turned("oblate", [1.0, 1.0, 1.7], ANGLES, [0.5, -0.4, 0.9]),
        Case::turned("prolate", [2.0, 2.0, 0.3], ANGLES, [0.5, -0.4, 0.9]),
        Case::scaled("rod", [2.0, 0.0, 2.0], [0.3, -0.8, 0.5], [1.0; 2]),
        Case::scaled("separatrix", [6.0, 3.0, 4.0], [-0.5, 1.0, 0.2], [1.0; 2]),
        Case::scaled("at the end of the separatrix", [6.0, 3.0, 4.0], [0.5e-7, 1e-7, -1.2], [1.0; 2]),
        Case::scaled("separatrix of a giant", [6.0, 3.0, 4.0], [0.5, 1.0, 0.2], [2.0_f64.powi(498); 2]),
        Case::scaled("separatrix of a dwarf", [6.0, 3.0, 4.0], [0.5, 1.0, -0.2], [2.0_f64.powi(-498); 2]),
        Case::scaled("huge", [3.1, 4.3, 2.0], [0.4, -1.2, 0.3], [1e150, 1e150]),
        Case::scaled("tiny", [3.1, 4.3, 2.0], [0.4, -1.2, 0.3], [1e-150, 1e-150]),
        Case::scaled("heavy and slow", [4.3, 2.0, 3.1], [-0.2, 1.3, 0.5], [1e150, 1e-150]),
    ]
}

/// Returns the largest distance of the path, at 50 times in every chord, from the chord; relative
/// to `largest`.
fn dense_error(times: &[f64], points: &[[f64; 3]], path: impl Fn(f64) -> [f64; 3]) -> f64 {
    let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let mut worst: f64 = 0.0;
    for (t, p) in times.windows(2).zip(points.windows(2)) {
        let chord = minus(p[1], p[0]);
        for k in 1..50 {
            let reach = minus(path(t[0] + (t[1] - t[0]) * (f64::from(k) / 50.0)), p[0]);
            let part = (dot(reach, chord) / dot(chord, chord).max(1e-300)).clamp(0.0, 1.0);
            let away = minus(reach, chord.map(|c| c * part));
            worst = worst.max(dot(away, away).sqrt());
        }
    }
    worst
}

/// Checks the error that a curve states by recomputing it.
fn check_chords<Q, F>(name: &str, curve: &Curve<Q, F>, path: impl Fn(f64) -> Vector<Q, F>) {
    let unit = |v: Vector<Q, F>| (v / curve.largest()).to_array();
    let points: Vec<_> = curve.points().iter().map(|p| unit(*p)).collect::<Vec<_>>();
    let found = dense_error(curve.times(), &points, |t| unit(path(t)));
    println!("{name:45} {:6} points, error {found:.3e} (claimed {:.3e})", points.len(), curve.error());
    assert!(found <= curve.tolerance(), "{name}: {found:e}");
    assert!(found <= 1.02 * curve.error() && curve.error() <= curve.tolerance(), "{name}: {found:e}");
    assert!(curve.times().is_sorted_by(|a, b| a < b), "{name}: times do not ascend");
    assert!(points.iter().all(|p| p.iter().map(|x| x * x).sum::<f64>() <= 1.0 + 1e-14), "{name}: largest");
}

#[test]
fn polhodes_lie_on_both_quadrics_and_near_their_chords() {
    for case in moving() {
        for tolerance in [1e-2, 1e-4] {
            let curve = Polhode::of(&case.motion, tolerance).unwrap().curve;
            check_chords(case.name, &curve, |t| case.motion.at(t).omega);
            let [energy, momentum] = case.quadrics(case.motion.start().omega);
            for point in curve.points() {
                let [e, m] = case.quadrics(*point);
                assert!((e / energy - 1.0).abs() < 1e-14, "{}: energy {e} of {energy}", case.name);
                assert!((m / momentum - 1.0).abs() < 1e-14, "{}: momentum {m} of {momentum}", case.name);
            }
            assert!(curve.points().len() < 1500, "{}", case.name);
            assert_eq!(curve.is_closed(), !case.name.contains("separatrix") || case.name.contains("near"));
            assert_eq!(curve.is_closed(), curve.points().first() == curve.points().last());
        }
    }
}

#[test]
fn momentum_traces_lie_on_their_sphere() {
    for case in moving() {
        let curve = MomentumTrace::of(&case.motion, 1e-4).unwrap().curve;
        check_chords(case.name, &curve, |t| case.motion.angular_momentum(&case.motion.at(t)));
        let unit = case.units[0] * case.units[1];
        let size = case.motion.momentum().norm();
        for (l, &time) in curve.points().iter().zip(curve.times()) {
            assert!((l.norm() / size - 1.0).abs() < 1e-14, "{}", case.name);
            // L = Iω with the tensor itself
            let truth = Vector::from_array(case.momentum(case.motion.at(time).omega));
            assert!((*l / unit - truth).norm() < 1e-14 * size / unit, "{}", case.name);
        }
        assert_eq!(curve.is_closed(), case.motion.period().is_some());
    }
}

#[test]
fn herpolhodes_lie_in_their_plane_between_and_on_both_circles() {
    for case in moving() {
        let Case { name, motion, .. } = &case;
        let herpolhode = Herpolhode::of(motion, 1.3, 1e-4).unwrap();
        let (normal, fastest) = (herpolhode.normal, case.fastest());
        let rounding = 1e-14 * fastest;
        let across = |t: f64| {
            let omega = motion.at(t).omega_space();
            let along: AngularVelocity<Space> = omega - herpolhode_foot(&herpolhode);
            along
        };
        let curve = &herpolhode.curve;
        check_chords(name, curve, across);
        let [least, greatest] = herpolhode.annulus;
        for (point, &time) in curve.points().iter().zip(curve.times()) {
            let omega = motion.at(time).omega_space();
            assert!((omega.dot(normal) - herpolhode.height).abs() < rounding, "{name}: height");
            assert!(point.dot(normal).abs() < rounding, "{name}: plane");
            assert!(point.norm() > least - rounding && point.norm() < greatest + rounding, "{name}: annulus");
        }
        for [x, y] in herpolhode.in_plane() {
            assert!(x.hypot(y) > least - rounding && x.hypot(y) < greatest + rounding, "{name}: in plane");
        }
        if motion.period().is_some() {
            let [smallest, largest] = [-1.0, 1.0].map(|sign| extreme(curve, sign, across));
            assert!((smallest - least).abs() < rounding, "{name}: {smallest} is not {least}");
            assert!((largest - greatest).abs() < rounding, "{name}: {largest} is not {greatest}");
        }
    }
}

fn herpolhode_foot(herpolhode: &Herpolhode) -> AngularVelocity<Space> {
    AngularVelocity::from_array((herpolhode.normal * herpolhode.height).to_array())
}

/// Returns the largest magnitude on a path, or the smallest for sign −1: refines the best sample by
/// trisection.
fn extreme<Q, F>(curve: &Curve<Q, F>, sign: f64, path: impl Fn(f64) -> Vector<Q, F>) -> f64 {
    let size = |t: f64| sign * path(t).norm();
    let times = curve.times();
    let best = (0..times.len()).max_by(|&a, &b| size(times[a]).total_cmp(&size(times[b]))).unwrap();
    let (mut a, mut b) = (times[best.saturating_sub(1)], times[(best + 1).min(times.len() - 1)]);
    for _ in 0..100 {
        let (left, right) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
        if size(left) < size(right) {
            a = left;
        } else {
            b = right;
        }
    }
    sign * size(0.5 * (a + b)).max(size(times[best]))
}

#[test]
fn the_smallest_radius_has_its_digits_near_the_separatrix_and_near_the_axes() {
    // exact numbers: i = (3, 4, 6), ω = (2, 0, 1 + d): L² − 2T i2 = 12 ((1 + d)² − 1),
    // ω × L = (0, 3 ω1 ω3, 0) · (−1)
    for d in [2.0_f64.powi(-40), 0.25] {
        let motion =
            FreeMotion::of_moments([3.0, 4.0, 6.0], start(AngularVelocity::new(2.0, 0.0, 1.0 + d))).unwrap();
        let w3 = 1.0 + d;
        let l = (36.0 + 36.0 * w3 * w3).sqrt();
        let excess = 12.0 * d * (2.0 + d);
        // where ω1 = 0: i2 ω2² + i3 ω3² = 2T, i2² ω2² + i3² ω3² = L², so
        // i3 (i3 − i2) ω3² = L² − 2T i2 and i2 (i3 − i2) ω2² = 2T i3 − L² = i1 (i3 − i1) ω1²
        let (z, y) = ((excess / 12.0).sqrt(), (3.0 * 3.0 * 4.0 / (4.0 * 2.0_f64)).sqrt());
        let [least, greatest] = Herpolhode::of(&motion, 1.0, 1e-3).unwrap().annulus;
        assert!((least / (2.0 * y * z / l) - 1.0).abs() < 1e-14, "{d}: {least}");
        assert!((greatest / (3.0 * 2.0 * w3 / l) - 1.0).abs() < 1e-14, "{d}: {greatest}");
    }
    // a wobble far below the rounding of ω has correct radii, and a curve that ends
    let motion =
        FreeMotion::of_moments([3.0, 4.0, 6.0], start(AngularVelocity::new(1e-14, 0.0, 1.0))).unwrap();
    let herpolhode = Herpolhode::of(&motion, 1.0, 1e-6).unwrap();
    assert!((herpolhode.annulus[1] / (3e-14 / 6.0) - 1.0).abs() < 1e-14);
    assert!(herpolhode.curve.points().len() < 1000);
}

#[test]
fn cones_touch_along_common_rulings_and_do_not_slip() {
    for case in moving() {
        let Case { name, motion, .. } = &case;
        let cones = RollingCones::of(motion, 2.0, 1e-3).unwrap();
        check_chords(name, &cones.body, |t| motion.at(t).omega);
        check_chords(name, &cones.space, |t| motion.at(t).omega_space());
        assert_eq!(cones.body.times(), cones.space.times());
        let fastest = case.fastest();
        let span = motion.period().unwrap_or(cones.body.times().last().unwrap() - cones.body.times()[0]);
        let h = 2e-3 / (motion.precession_rate().abs() + 30.0 / span);
        for (k, &time) in cones.body.times().iter().enumerate() {
            let state = motion.at(time);
            let gap = state.attitude * cones.body.points()[k] - cones.space.points()[k];
            assert!(gap.norm() < 1e-14 * fastest, "{name}: ruling {k}");
            if case.units != [1.0; 2] {
                continue; // i ω² is out of range
            }
            // dω/dt in space by differences is that in the body
            let omega = |steps: f64| motion.at(time + steps * h).omega_space();
            let rate = (8.0 * (omega(1.0) - omega(-1.0)) - (omega(2.0) - omega(-2.0))) / 12.0;
            let in_body = motion.angular_acceleration(&state) * h;
            let turned = state.attitude * in_body;
            let slip = Direction::<Space>::from_array((rate / fastest).to_array())
                - Direction::from_array((turned / fastest).to_array());
            assert!(
                slip.norm() < 1e-9 * h * 30.0 / span + 1e-13,
                "{name}: {:e} slips {:e}",
                time,
                slip.norm()
            );
            let lengths = [rate.norm(), in_body.norm()];
            assert!((lengths[0] - lengths[1]).abs() < 1e-9 * fastest * h * 30.0 / span + 1e-13 * fastest);
        }
    }
}

#[test]
fn counts_grow_as_the_root_of_the_tolerance() {
    for case in moving() {
        let count = |tolerance| Polhode::of(&case.motion, tolerance).unwrap().curve.points().len();
        let counts = [1e-3, 1e-4, 1e-5, 1e-6, 1e-8].map(count);
        let space = [1e-3, 1e-4, 1e-6]
            .map(|tolerance| Herpolhode::of(&case.motion, 1.0, tolerance).unwrap().curve.points().len());
        println!("{:35} polhode {counts:?}  herpolhode {space:?}", case.name);
        if case.name != "small wobble" {
            let ratio = counts[4] as f64 / counts[3] as f64;
            assert!(ratio > 5.0 && ratio < 15.0, "{}: {ratio}", case.name);
        }
    }
}

#[test]
fn the_check_of_chords_can_fail() {
    for case in moving().iter().filter(|case| case.name != "small wobble") {
        let curve = Polhode::of(&case.motion, 1e-5).unwrap().curve;
        let unit = |omega: AngularVelocity<Body>| (omega / curve.largest()).to_array();
        let thin: Vec<_> = curve.times().iter().copied().step_by(2).collect();
        let points: Vec<_> = curve.points().iter().step_by(2).map(|p| unit(*p)).collect();
        let found = dense_error(&thin, &points, |t| unit(case.motion.at(t).omega));
        assert!(found > 1e-5, "{}: {found:e}", case.name);
    }
}

#[test]
fn a_resting_motion_spends_its_points_where_it_moves() {
    let case = &moving()[5];
    let curve = Polhode::of(&case.motion, 1e-6).unwrap().curve;
    let steps = curve.times().windows(2).map(|t| t[1] - t[0]);
    let (short, long) = steps.fold((f64::MAX, 0.0), |(a, b): (f64, f64), h| (a.min(h), b.max(h)));
    assert!(long > 30.0 * short, "{short} {long}");
}

#[test]
fn what_does_not_move_is_a_point() {
    let still = [
        Case::turned("greatest", [2.0, 3.1, 4.3], ANGLES, [0.0, 0.0, -1.4]),
        Case::scaled("intermediate", [2.0, 3.1, 4.3], [0.0, 1.3, 0.0], [1.0; 2]),
        Case::turned("sphere", [2.0, 2.0, 2.0], ANGLES, [0.3, -0.7, 0.2]),
        Case::scaled("rod across itself", [2.0, 0.0, 2.0], [0.3, 0.0, -0.4], [1.0; 2]),
        Case::scaled("at rest", [2.0, 3.1, 4.3], [0.0; 3], [1.0; 2]),
    ];
    for Case { name, motion, .. } in &still {
        let polhode = Polhode::of(motion, 1e-4).unwrap();
        assert_eq!(polhode.curve.points(), [motion.start().omega], "{name}");
        assert_eq!(polhode.regime, motion.regime());
        assert!(polhode.curve.is_closed() && polhode.curve.fan().is_empty());
        assert_eq!(MomentumTrace::of(motion, 1e-4).unwrap().curve.points().len(), 1);
        let herpolhode = Herpolhode::of(motion, 5.0, 1e-4).unwrap();
        assert_eq!((herpolhode.curve.points(), herpolhode.annulus), (&[Vector::ZERO][..], [0.0; 2]));
        assert!((herpolhode.height - motion.start().omega.norm()).abs() < 1e-15, "{name}");
        let cones = RollingCones::of(motion, 1.0, 1e-4).unwrap();
        assert_eq!(cones.space.points(), [motion.start().omega_space()]);
    }
}

#[test]
fn a_family_covers_its_ellipsoid() {
    for (case, curves) in [
        (&moving()[0], 4 * 4 + 4),
        (&moving()[3], 20),
        (&moving()[6], 8),
        (&moving()[7], 8),
        (&moving()[8], 0),
        (&moving()[13], 20),
        (&moving()[14], 20),
    ] {
        let family = Polhode::family(&case.motion, 4, 1e-4).unwrap();
        assert_eq!(family.len(), curves, "{}", case.name);
        let [energy, _] = case.quadrics(case.motion.start().omega);
        for sister in &family {
            let [_, momentum] = case.quadrics(sister.curve.points()[0]);
            for point in sister.curve.points() {
                let [e, m] = case.quadrics(*point);
                assert!((e / energy - 1.0).abs() < 1e-14, "{}: {e} {energy}", case.name);
                assert!((m / momentum - 1.0).abs() < 1e-14, "{}: {m} {momentum}", case.name);
            }
            assert!(sister.curve.error() <= 1e-4 && sister.curve.points().len() < 1000);
        }
        let open = family.iter().filter(|p| !p.curve.is_closed());
        assert!(open.clone().all(|p| p.regime == Regime::Separatrix));
        assert_eq!(open.count(), if curves == 20 { 4 } else { 0 });
    }
}

#[test]
fn a_separatrix_of_the_family_is_the_motion() {
    let case = &moving()[9];
    let polhode = Polhode::of(&case.motion, 1e-4).unwrap();
    let family = Polhode::family(&case.motion, 1, 1e-4).unwrap();
    let near = |sister: &Polhode| {
        let pairs = sister.curve.points().iter().zip(polhode.curve.points());
        sister.curve.points().len() == polhode.curve.points().len()
            && pairs.clone().all(|(a, b)| (*a - *b).norm() < 1e-13)
    };
    assert_eq!(family.iter().filter(|sister| near(sister)).count(), 1);
}

#[test]
fn what_cannot_be_drawn_says_so() {
    let motion = moving().remove(0).motion;
    for tolerance in [0.0, 1e-11, 0.2, f64::NAN, -1e-3, f64::INFINITY] {
        let error = Polhode::of(&motion, tolerance).unwrap_err();
        assert!(
            matches!(error, CurveError::Parameter { value, .. } if value.to_bits() == tolerance.to_bits())
        );
    }
    for periods in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(Herpolhode::of(&motion, periods, 1e-3), Err(CurveError::Parameter { .. })));
    }
    // too many turns: fails immediately
    assert!(matches!(RollingCones::of(&motion, 1e12, 1e-3), Err(CurveError::TooManyPoints { .. })));
    let nearly_round = FreeMotion::of_moments([2.0, 2.0 + 1e-9, 2.0 + 2e-9], motion.start()).unwrap();
    assert!(matches!(Herpolhode::of(&nearly_round, 1.0, 1e-3), Err(CurveError::TooManyPoints { .. })));
    assert!(Polhode::of(&nearly_round, 1e-3).is_ok());
    // too many points: fails in reasonable time
    assert!(matches!(Herpolhode::of(&motion, 100.0, 1e-10), Err(CurveError::TooManyPoints { .. })));
    // a late start, whose times are too coarse
    let late = State { time: 1e15, ..motion.start() };
    let late = FreeMotion::of_moments([2.0, 3.1, 4.3], late).unwrap();
    // 1/8 s: too coarse for the tolerance, but not for the division into parts
    let error = Polhode::of(&late, 1e-6).unwrap_err();
    assert!(matches!(error, CurveError::StepTooSmall { step, .. } if step >= 0.0), "{error}");
}
