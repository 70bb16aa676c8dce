//! Plates and rods: the boundary of physical consistency.

use nalgebra::{DMatrix, DVector};
use polhode::math::symmetric_eigen;
use polhode_identify::payload::{EdgeKind, PayloadFinding};

use super::statistics::{Statistics, covariance_bound};
use super::wrist::{Carried, Course, noisy, rows};
use super::{FORCE, SENSE, TORQUE, close, found, log};
use crate::draws::{draws, is_about_one, tolerance};

#[test]
fn without_noise_a_plate_is_a_plate() {
    for carried in [Carried::plate(), Carried::rod()] {
        let exact = rows(&carried, Course::Generic(1.0), 60, SENSE);
        let found = found(&log(exact));
        // The solution lies on the boundary, and the estimate inside by a millionth of a standard
        // deviation.
        close(&found, &carried.about_center(), 1e-6);
        assert!(found.body.is_some());
    }
}

/// Estimated second moments are always at the boundary or inside. Plain least squares mostly is
/// not.
#[test]
fn every_answer_is_possible() {
    for (carried, course, force, least) in [
        (Carried::plate(), Course::Generic(1.0), FORCE, 0.4),
        (Carried::rod(), Course::Generic(1.0), FORCE, 0.9),
        (Carried::generic(), Course::Generic(0.1), 30.0 * FORCE, 0.9),
    ] {
        let exact = rows(&carried, course, 150, SENSE);
        let mut impossible = 0;
        for seed in 0..200 {
            let measured = noisy(&exact, force, force * TORQUE / FORCE, seed);
            let found = found(&log(measured));
            let g: [f64; 10] = std::array::from_fn(|k| found.about_center.numbers[k].value);
            let (moments, _) = symmetric_eigen([g[4], g[5], g[6], g[7], g[8], g[9]]);
            assert!(g[0] > 0.0 && moments[0] + moments[1] >= moments[2] * (1.0 - 1e-9), "{moments:?}");
            assert!(found.body.is_some());
            impossible += i32::from(!found.unconstrained.is_possible);
            if !found.unconstrained.is_possible {
                assert!(found.unconstrained.chi_square_rise > 0.0);
                assert!(found.unconstrained.least_second_moment.is_none_or(|least| least < 0.0));
            }
        }
        println!("impossible: {impossible} of 200");
        assert!(f64::from(impossible) > least * 200.0, "{impossible}");
    }
}

/// Returns the normals of a body's plane or line: directions without extent.
fn normals(carried: &Carried, count: usize) -> Vec<[f64; 3]> {
    let n = carried.about_center();
    let half = 0.5 * (n[4] + n[5] + n[6]);
    let (values, vectors) = symmetric_eigen([half - n[4], half - n[5], half - n[6], -n[7], -n[8], -n[9]]);
    assert!(values[..count].iter().all(|v| v.abs() < 1e-12 * half));
    vectors[..count].to_vec()
}

/// Returns the projection on directions along the boundary: 1 − C Kᵀ (K C Kᵀ)⁻¹ K, with K the
/// derivative of nᵀ G n'.
fn along(covariance: &DMatrix<f64>, normals: &[[f64; 3]]) -> DMatrix<f64> {
    let mut rows = Vec::new();
    for i in 0..normals.len() {
        for j in 0..=i {
            let (a, b) = (normals[i], normals[j]);
            let mut row = vec![0.0; covariance.nrows()];
            let dot: f64 = (0..3).map(|k| a[k] * b[k]).sum();
            (0..3).for_each(|k| row[4 + k] = 0.5 * dot - a[k] * b[k]);
            for (k, (p, q)) in [(0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
                row[7 + k] = -(a[p] * b[q] + a[q] * b[p]);
            }
            rows.extend(row);
        }
    }
    let n = covariance.nrows();
    let k = DMatrix::from_row_slice(rows.len() / n, n, &rows);
    let inner = (&k * covariance * k.transpose()).try_inverse().unwrap();
    DMatrix::identity(n, n) - covariance * k.transpose() * inner * &k
}

/// Along the boundary, estimates have no bias, the deviation of the bound, and the stated errors.
/// Across it they are bounded from one side.
#[test]
fn errors_along_the_edge_are_honest() {
    for (carried, thin, kind) in [(Carried::plate(), 1, EdgeKind::Lamina), (Carried::rod(), 2, EdgeKind::Rod)]
    {
        let exact = rows(&carried, Course::Generic(1.0), 150, SENSE);
        let truth = carried.about_center();
        let covariance = covariance_bound(&exact, FORCE, TORQUE, false, &truth);
        let projector = along(&covariance, &normals(&carried, thin));
        let edge = &projector * &covariance * projector.transpose();
        let limit: Vec<f64> = (0..10).map(|k| edge[(k, k)].sqrt()).collect();
        let (mut whole, mut moving, mut said) =
            (Statistics::new(10), Statistics::new(10), Statistics::new(10));
        let (mut at_edge, mut held) = (0, 0);
        for seed in 0..draws(600) {
            let found = found(&log(noisy(&exact, FORCE, TORQUE, seed)));
            whole.add(&found.about_center, &truth);
            let error = DVector::from_fn(10, |k, _| found.about_center.numbers[k].value - truth[k]);
            moving.add_error(&(&projector * error), &limit, &edge);
            let Some(at) = found.edge.filter(|at| at.kind == kind) else { continue };
            at_edge += 1;
            held += i32::from(at.thin.iter().all(|thin| thin.at_most > 0.0 && thin.sd > 0.0));
            said.add(at.along.as_ref().unwrap(), &truth);
        }
        println!(
            "{kind}: whole {whole}\n along {moving} {:?}\n said {said} {:?} of {at_edge}",
            moving.of_draws(&limit),
            said.of_said(&limit)
        );
        moving.hold(&limit);
        assert_eq!(held, at_edge);
        let [least, most] = said.of_said(&limit);
        assert!(0.9 < least && most < 1.1 && is_about_one(said.normalised(), 0.1));
        // The constraint moves the estimate closer to the truth, so errors are never larger than
        // stated.
        let whole = whole.normalised();
        assert!(0.8 < whole && whole < 1.0 + tolerance(0.05), "{whole}");
    }
}

/// A plate of some thickness: the upper bound holds in at least 95 % of the draws that are
/// estimated as a lamina. With a second moment of 1.4 standard deviations, a bound at the 84 %
/// quantile would never hold.
#[test]
fn the_bound_of_thickness_holds() {
    let total = Carried::plate().about_origin()[0];
    let (edges, held, sd) = laminae(0.004);
    println!("thickness: {held} of {edges}");
    assert!(edges > draws(400) / 8 && held as f64 >= 0.95 * edges as f64, "{held} of {edges}");
    let (edges, held, _) = laminae((1.4 * sd / total).sqrt());
    println!("greater thickness: {held} of {edges}");
    assert!(edges > draws(400) / 50 && held as f64 >= 0.9 * edges as f64, "{held} of {edges}");
}

/// Returns the number of draws estimated as laminae, the number of those whose bound is above the
/// second moment of a plate of this half thickness (m), and the largest standard deviation.
fn laminae(half: f64) -> (u64, u64, f64) {
    let mut carried = Carried::plate();
    let normal = normals(&carried, 1)[0];
    // Half of each particle on each side.
    carried.0 = carried
        .0
        .iter()
        .flat_map(|(m, r)| [half, -half].map(|by| (0.5 * m, std::array::from_fn(|k| r[k] + by * normal[k]))))
        .collect();
    let exact = rows(&carried, Course::Generic(1.0), 150, SENSE);
    let truth = carried.about_origin()[0] * half * half;
    let (mut edges, mut held, mut sd) = (0, 0, 0.0_f64);
    for seed in 0..draws(400) {
        let found = found(&log(noisy(&exact, FORCE, TORQUE, seed)));
        let Some(edge) = found.edge else { continue };
        edges += 1;
        held += u64::from(edge.thin[0].at_most >= truth);
        sd = sd.max(edge.thin[0].sd);
        assert!(edge.thin[0].thickness_at_most(found.about_center.numbers[0].value) > 0.0);
    }
    (edges, held, sd)
}

/// A payload declared as a plate or a rod is estimated as one, without bias.
#[test]
fn a_kind_that_is_known_leaves_no_bias() {
    for (carried, thin, kind) in [(Carried::plate(), 1, EdgeKind::Lamina), (Carried::rod(), 2, EdgeKind::Rod)]
    {
        let exact = rows(&carried, Course::Generic(1.0), 150, SENSE);
        let truth = carried.about_center();
        close(&found(&log(exact.clone()).with_kind(kind)), &truth, 1e-8);
        let covariance = covariance_bound(&exact, FORCE, TORQUE, false, &truth);
        let projector = along(&covariance, &normals(&carried, thin));
        let edge = &projector * &covariance * projector.transpose();
        let limit: Vec<f64> = (0..10).map(|k| edge[(k, k)].sqrt()).collect();
        let mut statistics = Statistics::new(10);
        for seed in 0..draws(600) {
            let found = found(&log(noisy(&exact, FORCE, TORQUE, seed)).with_kind(kind));
            assert!(found.body.is_some() && found.edge.is_none() && found.findings.is_empty());
            statistics.add(&found.about_center, &truth);
        }
        println!(
            "known {kind}: {statistics} {:?} {:?}",
            statistics.of_draws(&limit),
            statistics.of_said(&limit)
        );
        statistics.hold(&limit);
    }
}

#[test]
fn what_is_not_of_a_kind_is_said() {
    let measured = noisy(&rows(&Carried::generic(), Course::Generic(1.0), 150, SENSE), FORCE, TORQUE, 3);
    let found = found(&log(measured).with_kind(EdgeKind::Rod));
    assert!(
        found.findings.iter().any(|f| matches!(f, PayloadFinding::NotOfKind { kind: EdgeKind::Rod, .. })),
        "{:?}",
        found.findings
    );
}
