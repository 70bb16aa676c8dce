//! Distribution of draws. Seeds are fixed; each threshold is one that a right generator passes for
//! 999 of 1000 seeds.

use std::f64::consts::PI;

use super::{plan, vary};

const DRAWS: u64 = 20_000;

/// Returns the Kolmogorov–Smirnov statistic: largest difference between the share of values below x
/// and F(x), times √n. It is below 1.95 in 99.9 % of samples.
fn kolmogorov(mut values: Vec<f64>, f: impl Fn(f64) -> f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let n = values.len() as f64;
    let apart = |(k, x): (usize, &f64)| {
        let p = f(*x);
        (p - k as f64 / n).abs().max(((k + 1) as f64 / n - p).abs())
    };
    values.iter().enumerate().map(apart).fold(0.0, f64::max) * n.sqrt()
}

/// Returns Φ(z).
fn normal(z: f64) -> f64 {
    0.5 * libm::erfc(-z / 2.0_f64.sqrt())
}

/// Returns the columns of values of one variable.
fn columns(key: &str, law: &str, seed: u64) -> Vec<Vec<f64>> {
    let plan = vary(DRAWS, "monte carlo", seed, &format!("[[sweep.vary]]\nkey = \"{key}\"\n{law}\n"));
    let rows: Vec<Vec<f64>> = (0..DRAWS).map(|member| plan.values(member)).collect();
    (0..plan.variables().len()).map(|k| rows.iter().map(|row| row[k]).collect()).collect()
}

#[test]
fn numbers_follow_their_distributions() {
    let spin = |law: &str| columns("start.spin.body[0]", law, 11).remove(0);
    let greatest = 1.95;
    let uniform = spin("uniform = { from = -2, to = 3 }");
    assert!(kolmogorov(uniform, |x| (x + 2.0) / 5.0) < greatest);
    let gauss = spin("normal = { mean = 0.3, sd = 0.05 }");
    assert!(kolmogorov(gauss, |x| normal((x - 0.3) / 0.05)) < greatest);
    let relative = spin("relative = \"5 %\"");
    assert!(kolmogorov(relative, |x| normal((x - 0.3) / 0.015)) < greatest);
    let cut = spin("normal = { mean = 0.3, sd = 0.05, from = 0.25, to = 0.4 }");
    let (a, b) = (normal(-1.0), normal(2.0));
    assert!(kolmogorov(cut, |x| (normal((x - 0.3) / 0.05) - a) / (b - a)) < greatest);
    let log = spin("log_normal = { median = 0.3, sigma = 0.7 }");
    assert!(kolmogorov(log, |x| normal((x / 0.3).ln() / 0.7)) < greatest);
    // Mean 0.3 and standard deviation 0.1 of the number itself.
    let log = spin("log_normal = { mean = 0.3, sd = 0.1 }");
    let n = log.len() as f64;
    let mean = log.iter().sum::<f64>() / n;
    let sd = (log.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt();
    assert!((mean - 0.3).abs() < 3.3 * 0.1 / n.sqrt() && (sd - 0.1).abs() < 0.003, "{mean}, {sd}");
    let even = spin("log_uniform = { from = 0.1, to = 10 }");
    assert!(kolmogorov(even, |x| (x / 0.1).ln() / 100.0_f64.ln()) < greatest);
    let triangle = spin("triangular = { from = -1, mode = 0, to = 3 }");
    let f = |x: f64| if x < 0.0 { (x + 1.0).powi(2) / 4.0 } else { 1.0 - (3.0 - x).powi(2) / 12.0 };
    assert!(kolmogorov(triangle, f) < greatest);
    let list = spin("list = [3, -1, 4]");
    for value in [3.0, -1.0, 4.0] {
        let share = list.iter().filter(|x| **x == value).count() as f64 / n;
        assert!((share - 1.0 / 3.0).abs() < 3.3 * (2.0 / 9.0 / n).sqrt(), "{value}: {share}");
    }
}

#[test]
fn neighbours_and_variables_are_not_correlated() {
    let names = ["start.spin.body[0]", "start.spin.body[1]", "run.duration", "body.part[0].mass"];
    let text: String = names
        .iter()
        .map(|key| format!("[[sweep.vary]]\nkey = \"{key}\"\nuniform = {{ from = 1, to = 2 }}\n"))
        .collect();
    for sampling in ["monte carlo", "latin hypercube", "sobol"] {
        let plan = vary(DRAWS, sampling, 5, &text);
        let rows: Vec<Vec<f64>> = (0..DRAWS).map(|member| plan.values(member)).collect();
        // Correlation of uniform numbers; for independent ones it is normal with standard deviation
        // 1/√n.
        let correlation = |pairs: &dyn Fn(usize) -> (f64, f64), n: usize| {
            (0..n).map(pairs).map(|(a, b)| 12.0 * (a - 1.5) * (b - 1.5)).sum::<f64>() / n as f64
        };
        let bound = 3.9 / (DRAWS as f64).sqrt();
        for i in 0..names.len() {
            for j in 0..i {
                let r = correlation(&|k| (rows[k][i], rows[k][j]), rows.len());
                assert!(r.abs() < bound, "{sampling}: {r} between {i} and {j}");
            }
            if sampling != "sobol" {
                let r = correlation(&|k| (rows[k][i], rows[k + 1][i]), rows.len() - 1);
                assert!(r.abs() < bound, "{sampling}: {r} between neighbours of {i}");
            }
        }
    }
}

#[test]
fn attitudes_are_uniform() {
    let [w, x, y, z] = &columns("start.attitude", "random = \"uniform\"", 3)[..] else { panic!("four") };
    assert!(w.iter().all(|w| *w >= 0.0));
    let angles = w.iter().map(|w| 2.0 * w.acos()).collect();
    // Distribution of the angle of a uniform rotation: (θ − sin θ)/π.
    assert!(kolmogorov(angles, |t| (t - t.sin()) / PI) < 1.95);
    // Every element of the matrix is uniform from −1 to 1, like the coordinate of a point on a
    // sphere.
    let element = |f: &dyn Fn(usize) -> f64| kolmogorov((0..w.len()).map(f).collect(), |c| 0.5 * (c + 1.0));
    assert!(element(&|k| 1.0 - 2.0 * (y[k] * y[k] + z[k] * z[k])) < 1.95);
    assert!(element(&|k| 1.0 - 2.0 * (x[k] * x[k] + y[k] * y[k])) < 1.95);
    assert!(element(&|k| 2.0 * (x[k] * y[k] - w[k] * z[k])) < 1.95);
    assert!(element(&|k| 2.0 * (x[k] * z[k] + w[k] * y[k])) < 1.95);
    assert!(element(&|k| 2.0 * (y[k] * z[k] + w[k] * x[k])) < 1.95);
}

#[test]
fn an_attitude_about_the_written_one_turns_about_all_axes_alike() {
    use polhode::math::Attitude;
    let columns = columns("start.attitude", "random = { sd = \"2 deg\" }", 4);
    let nominal = plan(&format!("[sweep]\nmembers = 1\nsampling = 'sobol'\n{}", super::SPIN))
        .nominal()
        .start()
        .attitude;
    let sd = 2.0_f64.to_radians();
    let turns: Vec<[f64; 3]> = (0..DRAWS as usize)
        .map(|k| {
            let attitude =
                Attitude::from_quaternion([columns[0][k], columns[1][k], columns[2][k], columns[3][k]]);
            let turn = nominal.inverse() * attitude.unwrap();
            let [w, x, y, z] = turn.canonical_quaternion();
            let sine = x.hypot(y).hypot(z);
            let factor = 2.0 * sine.atan2(w) / sine;
            [factor * x, factor * y, factor * z]
        })
        .collect();
    for k in 0..3 {
        assert!(kolmogorov(turns.iter().map(|turn| turn[k]).collect(), |a| normal(a / sd)) < 1.95);
    }
}

#[test]
fn directions_are_uniform_and_keep_their_magnitude() {
    let law = "direction = \"uniform\"\nmagnitude = { uniform = { from = 1, to = 3 } }";
    let [x, y, z] = &columns("start.spin.body", law, 8)[..] else { panic!("three") };
    let norm = |k: usize| x[k].hypot(y[k]).hypot(z[k]);
    let all = 0..x.len();
    assert!(kolmogorov(all.clone().map(norm).collect(), |r| 0.5 * (r - 1.0)) < 1.95);
    for c in [x, y, z] {
        assert!(kolmogorov(all.clone().map(|k| c[k] / norm(k)).collect(), |c| 0.5 * (c + 1.0)) < 1.95);
    }
    let around = all.map(|k| y[k].atan2(x[k])).collect();
    assert!(kolmogorov(around, |angle| 0.5 * (angle / PI + 1.0)) < 1.95);
}

#[test]
fn directions_within_an_angle_fill_the_cap() {
    let [x, y, z] = &columns("start.spin.body", "direction = { within = \"35 deg\" }", 9)[..] else {
        panic!("three")
    };
    let nominal = [0.3, -1.2, 40.0_f64.to_radians()];
    let size = nominal.iter().map(|c| c * c).sum::<f64>().sqrt();
    let n = nominal.map(|c| c / size);
    let cosines: Vec<f64> = (0..x.len()).map(|k| (n[0] * x[k] + n[1] * y[k] + n[2] * z[k]) / size).collect();
    assert!((0..x.len()).all(|k| (x[k].hypot(y[k]).hypot(z[k]) / size - 1.0).abs() < 1e-15));
    let least = 35.0_f64.to_radians().cos();
    assert!(kolmogorov(cosines, |c| (c - least) / (1.0 - least)) < 1.95);
    // Transverse components cancel: their mean is zero within 4 standard deviations.
    let across = |v: &[f64], k: usize| v[k] / size;
    for (axis, v) in [x, y, z].into_iter().enumerate() {
        let mean = (0..v.len()).map(|k| across(v, k)).sum::<f64>() / v.len() as f64;
        let expected = n[axis] * 0.5 * (1.0 + least);
        assert!((mean - expected).abs() < 4.0 * 0.45 / (v.len() as f64).sqrt(), "{mean} is not {expected}");
    }
}

/// Returns the squared L2 star discrepancy (Warnock, 1972): the deviation of the share of points in
/// boxes at the origin from their volume.
fn discrepancy(points: &[Vec<f64>]) -> f64 {
    let (n, d) = (points.len() as f64, points[0].len() as i32);
    let once: f64 = points.iter().map(|p| p.iter().map(|x| 1.0 - x * x).product::<f64>()).sum();
    let twice: f64 = points
        .iter()
        .flat_map(|p| {
            points.iter().map(move |q| p.iter().zip(q).map(|(x, y)| 1.0 - x.max(*y)).product::<f64>())
        })
        .sum();
    3.0_f64.powi(-d) - 2.0_f64.powi(1 - d) / n * once + twice / (n * n)
}

/// Returns points of the four-dimensional unit cube.
fn points(sampling: &str, seed: u64, members: u64) -> Vec<Vec<f64>> {
    let keys =
        ["start.spin.body[0]", "start.spin.body[1]", "start.spin.body[2]", "body.part[0].center_of_mass[0]"];
    let text: String = keys
        .iter()
        .map(|key| format!("[[sweep.vary]]\nkey = \"{key}\"\nuniform = {{ from = 0, to = 1 }}\n"))
        .collect();
    let plan = vary(members, sampling, seed, &text);
    (0..members).map(|member| plan.values(member)).collect()
}

#[test]
fn sobol_points_are_spread_more_evenly_than_random_ones() {
    // For independent points the mean is (2⁻ᵈ − 3⁻ᵈ)/n.
    let expected = (1.0 / 16.0 - 1.0 / 81.0) / 512.0;
    let mean =
        |sampling: &str| (0..8).map(|seed| discrepancy(&points(sampling, seed, 512))).sum::<f64>() / 8.0;
    let (random, sobol) = (mean("monte carlo"), mean("sobol"));
    assert!((random / expected - 1.0).abs() < 0.7, "{random} for {expected}");
    assert!(sobol < 0.1 * random, "{sobol}, {random}");
    // The mean over 40 seeds of scipy.stats.qmc.Sobol(4, scramble=True) is 6.38e-6, each within
    // 0.16e-6.
    assert!((sobol - 6.38e-6).abs() < 4.0 * 0.16e-6 / 8.0_f64.sqrt(), "{sobol}");
}

/// Returns the variance of an estimated mean over seeds.
fn variance(sampling: &str, f: impl Fn(&[f64]) -> f64) -> f64 {
    const SEEDS: u64 = 100;
    let mean = |seed| points(sampling, seed, 64).iter().map(|p| f(p)).sum::<f64>() / 64.0;
    let means: Vec<f64> = (0..SEEDS).map(mean).collect();
    let whole = means.iter().sum::<f64>() / SEEDS as f64;
    means.iter().map(|m| (m - whole).powi(2)).sum::<f64>() / (SEEDS - 1) as f64
}

#[test]
fn layers_take_the_variance_out_of_what_is_additive() {
    let additive = |p: &[f64]| p[0] * p[0] + (3.0 * p[1]).sin() + p[2].exp() - p[3];
    let (random, layers) = (variance("monte carlo", additive), variance("latin hypercube", additive));
    // With layers it decreases by about n²: 64² = 4096.
    assert!(layers < random / 1000.0, "{layers}, {random}");
    // The product of centred numbers has no additive part, so layers do not reduce its variance
    // (Stein's theorem).
    let product = |p: &[f64]| p.iter().map(|x| 2.0 * x - 1.0).product::<f64>();
    let (random, layers) = (variance("monte carlo", product), variance("latin hypercube", product));
    assert!(layers > 0.4 * random && layers < 2.5 * random, "{layers}, {random}");
}
