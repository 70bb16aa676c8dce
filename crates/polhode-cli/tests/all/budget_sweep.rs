//! `polhode budget --sweep`: a parts list as a sweep plan.

use polhode_source::files::Disk;
use polhode_sweep::Plan;

use crate::common::{Scratch, json, numbers, refused, stdout};

/// Members have the mean and covariance of the list.
#[test]
fn members_have_the_covariance_of_the_list() {
    const MEMBERS: usize = 20_000;
    let scratch = Scratch::new("budget-sweep");
    scratch.write("cubesat.csv", crate::budget::CUBESAT);
    let asked = ["budget", "cubesat.csv", "--configuration", "deployed"];
    let report = json(&scratch.run(&[&asked[..], &["--json", "--draws", "20"]].concat()));
    let estimate = &report["configurations"][0]["estimate"];
    let covariance: Vec<Vec<f64>> = estimate["covariance"].as_array().unwrap().iter().map(numbers).collect();
    stdout(
        &scratch.run(&[&asked[..], &["--sweep", "plan.toml", "--draws", "20000", "--seed", "3"]].concat()),
    );
    let plan = Plan::read(&Disk, &scratch.0.join("plan.toml")).unwrap();
    assert_eq!((plan.members(), plan.seed()), (MEMBERS as u64, Some(3)));
    assert!(plan.findings().iter().all(|finding| finding.code != "sweep.members"));
    let values: Vec<Vec<f64>> = (0..plan.members()).map(|member| plan.values(member)).collect();
    assert!(values.iter().all(|member| plan.scenario(member).is_ok()));
    let body = plan.nominal().body();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
    let [x, y, z] = body.center_of_mass().to_array();
    let n = MEMBERS as f64;
    let mean: Vec<f64> = (0..10).map(|k| values.iter().map(|v| v[k]).sum::<f64>() / n).collect();
    for (i, nominal) in [body.mass(), x, y, z, xx, yy, zz, xy, xz, yz].into_iter().enumerate() {
        let sd = (covariance[i][i] / n).sqrt();
        assert!((mean[i] - nominal).abs() < 4.0 * sd + 1e-15, "mean {i}: {} is not {nominal}", mean[i]);
        for j in 0..=i {
            let sum: f64 = values.iter().map(|v| (v[i] - mean[i]) * (v[j] - mean[j])).sum();
            let want = covariance[i][j];
            // Standard deviation of a sample covariance, for normal variables.
            let sd = ((covariance[i][i] * covariance[j][j] + want * want) / n).sqrt();
            assert!((sum / (n - 1.0) - want).abs() < 4.5 * sd, "{i} {j}: {} is not {want}", sum / n);
        }
    }
    // The variables are correlated: mass and Ixx.
    assert!(covariance[4][0] > 0.3 * (covariance[4][4] * covariance[0][0]).sqrt());
}

#[test]
fn the_plan_is_run() {
    let scratch = Scratch::new("budget-sweep-run");
    let list = "# [[tank]]\n# name = \"fuel\"\n# shape = \"sphere\"\n# radius = \"10 cm\"\n# density = 900\n# settles = \"-z\"\n# mass = \"1 kg\"\n\
                # [sequence]\n# until = \"10 s\"\n# spin = [\"0.1 rad/s\", 0, \"30 rpm\"]\n# [result]\n# draws = 60\n# seed = 4\n\
                name,mass [kg],x [mm],y [mm],z [mm]\na,2 ± 0.1,100,0,5\nb,1 ± 0.1,-50 ± 2,20,300\n";
    scratch.write("list.csv", list);
    let written = ["budget", "list.csv", "--sweep", "plan.toml"];
    assert_eq!(stdout(&scratch.run(&written)), "");
    assert!(refused(&scratch.run(&written), 2).contains("plan.toml"));
    stdout(&scratch.run(&[&written[..], &["--force", "--draws", "60"]].concat()));
    let error = refused(&scratch.run(&["budget", "list.csv", "--sweep", "list.csv", "--force"]), 2);
    assert!(error.contains("is an input file and would be overwritten"), "{error}");
    let summary = json(&scratch.run(&["sweep", "plan.toml", "-o", "out", "--json"]));
    assert_eq!(summary["status"]["complete"]["count"], 60);
    let plan = Plan::read(&Disk, &scratch.0.join("plan.toml")).unwrap();
    assert_eq!((plan.members(), plan.seed()), (60, Some(4)));
    assert_eq!(plan.nominal().start().omega.x, 0.1);
    assert_eq!(plan.nominal().run().unwrap().times.last(), Some(&10.0));
    scratch.write("exact.csv", "name,mass [kg],x [mm]\na,2,100\n");
    let error = refused(&scratch.run(&["budget", "exact.csv", "--sweep", "out.toml"]), 2);
    assert!(
        error.contains("no part has an uncertainty") && error.contains("add errors to the list"),
        "{error}"
    );
    scratch.write("point.csv", "name,mass [kg],x [mm]\na,2 ± 0.1,100 ± 1\n");
    let error = refused(&scratch.run(&["budget", "point.csv", "--sweep", "out.toml"]), 2);
    assert!(error.contains("all mass is at one point"), "{error}");
    let error = refused(&scratch.run(&["budget", "list.csv", "--sweep", "out.toml", "--draws", "0"]), 2);
    assert!(error.contains("--draws is 0"), "{error}");
    let error = refused(&scratch.run(&["budget", "list.csv", "--sweep", "out.toml", "--about", "0,0,1"]), 2);
    assert!(error.contains("--about"), "{error}");
    let error = refused(&scratch.run(&["budget", "list.csv", "--force", "--draws", "20"]), 2);
    assert!(error.contains("--force") || error.contains("--xlsx"), "{error}");
}

/// Three points form a plane, and six have a volume. Errors across the plane are of second order in
/// its thickness, so most draws from the covariance are unphysical.
#[test]
fn members_of_a_flat_body_are_possible() {
    const MEMBERS: u64 = 500;
    let scratch = Scratch::new("budget-sweep-flat");
    let head = "name,mass [kg],x [mm],y [mm],z [mm]\n";
    let flat = "a,2 ± 0.1,100,0,5 ± 1\nb,1 ± 0.1,-50 ± 2,20,30\nc,1 ± 0.1,-50 ± 2,120,31 ± 1\n";
    let thick = "d,1,10,30,160\ne,1,20,30,-160\nf,1,0,190,40\n";
    for (name, rows, is_flat) in [("flat", flat.to_owned(), true), ("thick", format!("{flat}{thick}"), false)]
    {
        scratch.write("list.csv", &format!("{head}{rows}"));
        let report = json(&scratch.run(&["budget", "list.csv", "--json", "--draws", "20000"]));
        let drawn = &report["configurations"][0]["estimate"];
        let covariance: Vec<Vec<f64>> = drawn["covariance"].as_array().unwrap().iter().map(numbers).collect();
        stdout(&scratch.run(&["budget", "list.csv", "--sweep", "plan.toml", "--draws", "500", "--force"]));
        let plan = Plan::read(&Disk, &scratch.0.join("plan.toml")).unwrap();
        let said =
            plan.text().lines().any(|line| line.starts_with("# ") && line.contains(" of 1000 test draws"));
        assert_eq!(said, is_flat, "{name}: {}", plan.text());
        let bodies = (0..MEMBERS).map(|member| *plan.scenario(&plan.values(member)).unwrap().body());
        let bodies: Vec<_> = bodies.collect();
        let mut square = [0.0; 3];
        for body in &bodies {
            let [i1, i2, i3] = body.principal().moments();
            assert_eq!((i1 + i2 - i3).abs() < 1e-9 * i3, is_flat, "{name}: {i1} {i2} {i3}");
            let nominal = plan.nominal().body();
            let [[xx, ..], [_, yy, _], [.., zz]] = nominal.inertia().matrix();
            let [[a, ..], [_, b, _], [.., c]] = body.inertia().matrix();
            [a - xx, b - yy, c - zz].iter().zip(&mut square).for_each(|(d, sum)| *sum += d * d);
        }
        for (k, sum) in square.into_iter().enumerate() {
            let ratio = (sum / MEMBERS as f64 / covariance[4 + k][4 + k]).sqrt();
            // Five standard deviations for this number of draws.
            assert!((ratio - 1.0).abs() < 5.0 / (2.0 * MEMBERS as f64).sqrt(), "{name} {k}: {ratio}");
        }
        let without = plan.text().replace("correlated.impossible = \"nearest\"\n", "");
        scratch.write("without.toml", &without);
        let summary = json(&scratch.run(&["sweep", "plan.toml", "-o", name, "--json"]));
        assert_eq!(summary["status"]["complete"]["count"], MEMBERS, "{name}");
        let without = Plan::read(&Disk, &scratch.0.join("without.toml")).unwrap();
        let failed =
            (0..MEMBERS).filter(|member| without.scenario(&without.values(*member)).is_err()).count();
        assert_eq!(failed > 0, is_flat, "{name}: {failed}");
    }
}

/// The bodies of members do not change with time.
#[test]
fn a_list_whose_body_changes_is_no_plan() {
    let scratch = Scratch::new("budget-sweep-changes");
    let tank = "# [[tank]]\n# name = \"fuel\"\n# shape = \"sphere\"\n# radius = \"10 cm\"\n# density = 900\n# settles = \"-z\"\n# mass = \"1 kg\"\n";
    let begin = "# configurations = [\"a\", \"b\"]\n# [sequence]\n# configuration = \"a\"\n# until = \"10 s\"\n# spin = [0, 0, 3]\n";
    let rows = "name,configuration,mass [kg],x [mm],y [mm],z [mm]\nbus,,2 ± 0.1,100,0,5\nend,,1 ± 0.1,-50 ± 2,20,300\nlid,,0.3,3,-80,11\n\
                arm,a,0.5,0,100,7\narm,b,0.5,0,200,7\n";
    let written = ["budget", "list.csv", "--sweep", "plan.toml", "--force", "--configuration"];
    for what in [
        "# [[burn]]\n# tank = \"fuel\"\n# until = \"4 s\"\n# flow = 0.1\n",
        "# [[drop]]\n# time = 5\n# rows = [\"lid\"]\n",
        "# [[deploy]]\n# time = 5\n# configuration = \"b\"\n",
    ] {
        scratch.write("list.csv", &format!("{begin}{tank}{what}{rows}"));
        let error = refused(&scratch.run(&[&written[..], &["a"]].concat()), 2);
        assert!(error.contains("bodies of a plan do not change") && error.contains("--scenario"), "{error}");
        assert!(!scratch.0.join("plan.toml").exists());
        let body = stdout(&scratch.run(&["budget", "list.csv", "--body", "--configuration", "a"]));
        assert!(body.starts_with("# Initial body"), "{body}");
        // A configuration that is not the initial one stays constant.
        let body = stdout(&scratch.run(&["budget", "list.csv", "--body", "--configuration", "b"]));
        assert!(!body.contains("Initial body"), "{body}");
        stdout(&scratch.run(&[&written[..], &["b"]].concat()));
        std::fs::remove_file(scratch.0.join("plan.toml")).unwrap();
    }
    scratch.write("list.csv", &format!("{begin}{tank}{rows}"));
    stdout(&scratch.run(&[&written[..], &["a"]].concat()));
    let plan = Plan::read(&Disk, &scratch.0.join("plan.toml")).unwrap();
    assert_eq!(plan.nominal().start().omega.z, 3.0);
}
