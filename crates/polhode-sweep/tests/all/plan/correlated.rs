//! Correlated variables.

use super::mistakes::refuses_vary;
use super::vary;

const SPIN: &str = r#"[[sweep.vary]]
key = ["start.spin.body[0]", "body.part[0].mass", "run.duration"]
correlated = { mean = ["20 deg/s", "3.2 kg", "30 s"], sd = ["2 deg/s", "50 g", "1.5 s"], correlation = [[1, 0.6, -0.3], [0.6, 1, 0], [-0.3, 0, 1]] }
"#;

const BODY: &str = r#"[[sweep.vary]]
key = "body"
correlated.covariance = [
    ["0.04 kg^2", "2e-5 kg m", 0, 0, "1.2e-2 kg^2 m^2", "2e-2 kg^2 m^2", "2.6e-2 kg^2 m^2", 0, 0, 0],
    ["2e-5 kg m", "1 mm^2", 0, 0, 0, 0, 0, 0, 0, 0],
    [0, 0, "2 mm^2", "-1 mm^2", 0, 0, 0, 0, 0, 0],
    [0, 0, "-1 mm^2", "3 mm^2", 0, 0, 0, 0, 0, 0],
    ["1.2e-2 kg^2 m^2", 0, 0, 0, "4e-3 kg^2 m^4", "6e-3 kg^2 m^4", "8e-3 kg^2 m^4", 0, 0, 0],
    ["2e-2 kg^2 m^2", 0, 0, 0, "6e-3 kg^2 m^4", "1.2e-2 kg^2 m^4", "1.3e-2 kg^2 m^4", 0, 0, 0],
    ["2.6e-2 kg^2 m^2", 0, 0, 0, "8e-3 kg^2 m^4", "1.3e-2 kg^2 m^4", "1.8e-2 kg^2 m^4", 0, 0, 0],
    [0, 0, 0, 0, 0, 0, 0, "9e-4 kg^2 m^4", "2e-4 kg^2 m^4", 0],
    [0, 0, 0, 0, 0, 0, 0, "2e-4 kg^2 m^4", "4e-4 kg^2 m^4", 0],
    [0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
]
"#;

/// Returns mean and covariance of members' values.
fn moments(values: &[Vec<f64>]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let (n, columns) = (values.len() as f64, values[0].len());
    let mean: Vec<f64> = (0..columns).map(|k| values.iter().map(|v| v[k]).sum::<f64>() / n).collect();
    let of = |i: usize, j: usize| {
        values.iter().map(|v| (v[i] - mean[i]) * (v[j] - mean[j])).sum::<f64>() / (n - 1.0)
    };
    let covariance = (0..columns).map(|i| (0..columns).map(|j| of(i, j)).collect()).collect();
    (mean, covariance)
}

#[test]
fn numbers_of_a_group_have_their_means_deviations_and_correlations() {
    let plan = vary(1_000_000, "monte carlo", 11, SPIN);
    let names: Vec<_> = plan.variables().iter().map(|variable| variable.name.as_str()).collect();
    assert_eq!(names, ["start_spin_body_x_rad_s", "body_part_0_mass_kg", "run_duration_s"]);
    let values: Vec<_> = (0..40_000).map(|member| plan.values(member)).collect();
    let (mean, c) = moments(&values);
    let root = 200.0;
    let sd = [2_f64.to_radians(), 0.05, 1.5];
    let correlation = [[1.0, 0.6, -0.3], [0.6, 1.0, 0.0], [-0.3, 0.0, 1.0]];
    for (i, want) in [20_f64.to_radians(), 3.2, 30.0].into_iter().enumerate() {
        assert!((mean[i] - want).abs() < 4.0 * sd[i] / root, "mean {i}: {}", mean[i]);
        for j in 0..3 {
            let (r, want): (f64, f64) = (c[i][j] / (sd[i] * sd[j]), correlation[i][j]);
            assert!((r - want).abs() < 4.0 * (1.0 + want * want).sqrt() / root, "{i} {j}: {r}");
        }
    }
    let scenario = plan.scenario(&values[17]).unwrap();
    assert_eq!((scenario.start().omega.x, scenario.body().mass()), (values[17][0], values[17][1]));
    assert_eq!(scenario.run().unwrap().times.last(), Some(&values[17][2]));
    // Without a given mean, the nominal value is the mean.
    let written = vary(100, "sobol", 3, &SPIN.replace(r#"mean = ["20 deg/s", "3.2 kg", "30 s"], "#, ""));
    let (mean, _) = moments(&(0..100).map(|member| written.values(member)).collect::<Vec<_>>());
    assert!((mean[0] - 0.3).abs() < 0.01 && (mean[1] - 3.2).abs() < 0.01 && (mean[2] - 20.0).abs() < 0.3);
}

#[test]
fn a_body_is_drawn_by_the_covariance_of_its_ten_numbers() {
    const MEMBERS: usize = 20_000;
    let plan = vary(MEMBERS as u64, "monte carlo", 5, BODY);
    assert!(plan.findings().is_empty());
    let values: Vec<_> = (0..MEMBERS as u64).map(|member| plan.values(member)).collect();
    let (mean, c) = moments(&values);
    let written = plan.nominal().body();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = written.inertia().matrix();
    let [x, y, z] = written.center_of_mass().to_array();
    let mut want = [[0.0; 10]; 10];
    for (i, j, element) in [
        (0, 0, 0.04),
        (0, 1, 2e-5),
        (0, 4, 1.2e-2),
        (0, 5, 2e-2),
        (0, 6, 2.6e-2),
        (1, 1, 1e-6),
        (2, 2, 2e-6),
        (2, 3, -1e-6),
        (3, 3, 3e-6),
        (4, 4, 4e-3),
        (4, 5, 6e-3),
        (4, 6, 8e-3),
        (5, 5, 1.2e-2),
        (5, 6, 1.3e-2),
        (6, 6, 1.8e-2),
        (7, 7, 9e-4),
        (7, 8, 2e-4),
        (8, 8, 4e-4),
    ] {
        (want[i][j], want[j][i]) = (element, element);
    }
    let n = MEMBERS as f64;
    for (i, nominal) in [written.mass(), x, y, z, xx, yy, zz, xy, xz, yz].into_iter().enumerate() {
        assert!((mean[i] - nominal).abs() <= 4.0 * (want[i][i] / n).sqrt() + 1e-13, "mean {i}: {}", mean[i]);
        for j in 0..10 {
            let sd = ((want[i][i] * want[j][j] + want[i][j] * want[i][j]) / n).sqrt();
            assert!((c[i][j] - want[i][j]).abs() <= 4.5 * sd + 1e-24, "{i} {j}: {} {sd}", c[i][j]);
        }
    }
    assert!(values.iter().all(|v| v[9] == yz && plan.scenario(v).is_ok()));
    // A mass with a standard deviation of 70 % is never negative either.
    let wide = vary(2000, "monte carlo", 5, &BODY.replace("0.04 kg^2", "5 kg^2"));
    assert!((0..2000).all(|member| wide.values(member)[0] > 0.0));
}

/// A member is a function of its number, independent of the number of members and of other
/// variables.
#[test]
fn draws_are_those_of_the_members_number() {
    for sampling in ["monte carlo", "latin hypercube"] {
        let (one, two) =
            (vary(500, sampling, 3, BODY), vary(500, sampling, 3, &format!("{}{BODY}", super::DURATION)));
        for member in [0, 499, 17] {
            assert_eq!(one.values(member)[..], two.values(member)[1..]);
        }
    }
    let (few, many) = (vary(10, "monte carlo", 3, SPIN), vary(1_000_000_000, "monte carlo", 3, SPIN));
    assert!((0..10).all(|member| few.values(member) == many.values(member)));
    assert_ne!(few.values(3), few.values(4));
    assert_ne!(few.values(3), vary(10, "monte carlo", 4, SPIN).values(3));
}

/// The default does not move an impossible body to a possible one: the member fails, and is
/// counted.
#[test]
fn what_is_no_body_fails() {
    let tensor = "[[sweep.vary]]\nkey = 'body.inertia'\ncorrelated = { sd = ['0.4 kg m^2', 0, 0, 0, 0, 0], correlation = [[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]] }\n";
    let plan = vary(4000, "monte carlo", 1, tensor);
    let finding = plan.findings().pop().unwrap();
    assert!(finding.message.contains("tested members are invalid"), "{}", finding.message);
    let is_possible = |member: &u64| plan.scenario(&plan.values(*member)).is_ok();
    let failed = (0..4000).filter(|member| !is_possible(member)).count();
    // Ixx is 1.1 ± 0.4, and without products must be above 0.6, which fails in 10.6 %; with
    // products slightly more often.
    assert!((0.09..0.2).contains(&(failed as f64 / 4000.0)), "{failed}");
    // Members that failed become laminas; the others do not change.
    let nearest = vary(4000, "monte carlo", 1, &tensor.replace("{ sd", "{ impossible = 'nearest', sd"));
    assert!(nearest.findings().iter().all(|finding| finding.code != "sweep.members"));
    for member in 0..4000 {
        let (given, moved) = (plan.values(member), nearest.values(member));
        assert_eq!(is_possible(&member), given == moved, "{member}");
        let [i1, i2, i3] = nearest.scenario(&moved).unwrap().body().principal().moments();
        assert!(given == moved || (i1 + i2 - i3).abs() < 1e-12 * i3, "{member}: {i1} {i2} {i3}");
    }
}

#[test]
fn mistakes_are_named_where_they_stand() {
    let two = "key = ['start.spin.body[0]', 'start.spin.body[1]']\n";
    let of = |law: &str| format!("{two}correlated = {law}\n");
    for (law, message, hint) in [
        (
            "{ covariance = [[0.1, 0.2], [«0.2», 0.1]] }",
            "covariance = 0.2 must be positive semidefinite",
            "with these elements, a combination of the numbers up to start.spin.body[1]",
        ),
        (
            "{ covariance = [[0.1, 0.02], [«0.03», 0.1]] }",
            "covariance = 0.03 must be equal to that across the diagonal",
            "both are of start.spin.body[1] and start.spin.body[0]",
        ),
        (
            "{ covariance = [[0.1, 0], [0, 0.1]], impossible = «'nearest'» }",
            "impossible = 'nearest' must be left out for numbers: only mass properties can be impossible",
            "",
        ),
        (
            "{ covariance = [[0.1, 0], [0, «-0.1»]] }",
            "covariance = -0.1 must be zero or positive: it is a variance",
            "it is that of start.spin.body[1]",
        ),
        (
            "{ covariance = [['0.1 deg^2/s^2', 0], [0, «'3 deg/s'»]] }",
            "\"deg/s\" is an angular velocity where a quantity in s^-2 rad^2 belongs",
            "",
        ),
        (
            "{ covariance = [['0.1 deg^2/s^2', 0], [0, «2»]] }",
            "covariance = 2 must be given with its unit, like the other element \"0.1 deg^2/s^2\"",
            "",
        ),
        (
            "{ covariance = «[[1, 0, 0], [0, 1, 0], [0, 0, 1]]» }",
            "covariance = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] must be an array of 2 rows, and it has 3",
            "in this order: start.spin.body[0], start.spin.body[1]",
        ),
        (
            "{ covariance = [[1, 0], «[0]»] }",
            "covariance = [0] must be an array of 2 numbers or strings with units, and it has 1",
            "in this order",
        ),
        ("«{ sd = [1, 2] }»", "the key correlation is missing in correlated", "write correlation"),
        (
            "{ sd = [1, «-2»], correlation = [[1, 0], [0, 1]] }",
            "sd = -2 must be zero or positive",
            "it is a standard deviation",
        ),
        (
            "{ sd = [1, 2], correlation = [[1, 0], [0, «0.9»]] }",
            "correlation = 0.9 must be 1, the correlation of a number with itself",
            "",
        ),
        (
            "{ sd = [1, 2], correlation = [[1, «1.2»], [1.2, 1]] }",
            "correlation = 1.2 must be from -1 to 1",
            "",
        ),
        (
            "{ sd = [1, 2], covariance = «[[1, 0], [0, 1]]» }",
            "sd and covariance are both given: use sd with correlation, or covariance alone",
            "leave one of them out",
        ),
        (
            "«{ sd = [0, 0], correlation = [[1, 0], [0, 1]] }»",
            "correlated = { sd = [0, 0], correlation = [[1, 0], [0, 1]] } must be an array with at least one standard deviation above zero",
            "",
        ),
    ] {
        refuses_vary(&of(law), message, hint);
    }
    refuses_vary(
        "key = «'run.duration'»\ncorrelated = {}\n",
        "key = 'run.duration' must be the body, a part of it, or the inertia of either",
        "write key = \"body\" or \"body.inertia\", or an array of the keys of numbers",
    );
    refuses_vary(
        "key = ['run.duration', «'run.duration'»]\ncorrelated = {}\n",
        "key = 'run.duration' must be different from the numbers before it",
        "leave it out",
    );
    refuses_vary(
        "key = 'body.inertia'\ncorrelated = { mean = «[1, 2, 2, 0, 0, 0]», sd = [0.1, 0, 0, 0, 0, 0] }\n",
        "mean = [1, 2, 2, 0, 0, 0] must be left out for mass properties: their mean is the written value",
        "write the mean into the body itself",
    );
}

#[test]
fn a_number_without_a_dimension_stands_beside_others() {
    let plan = vary(
        10,
        "sobol",
        0,
        "[[sweep.vary]]\nkey = ['start.attitude.axis[0]', 'run.duration']\ncorrelated = { sd = [0.1, '2 s'], correlation = [[1, 0.2], [0.2, 1]] }\n",
    );
    assert_eq!(plan.values(1).len(), 2);
}
