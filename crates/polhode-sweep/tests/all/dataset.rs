//! Datasets: identical files for any number of threads and interruptions, and statistics of their
//! contents.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use polhode_source::files::Disk;
use polhode_sweep::{Dataset, Plan, SweepError, SweepSummary, Values, inputs, simulate, trajectories};

/// Temporary folder of a test, removed at the end.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("polhode-dataset-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir(&folder).unwrap();
        Self(folder)
    }

    fn join(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn plan(sampling: &str, members: u64, more: &str) -> Plan {
    let text = format!(
        r#"
title = "a tumbling box"
[[body.part]]
shape = "tensor"
mass = "3.2 kg"
inertia = [[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]]
[start]
spin = {{ body = ["0.3 rad/s", "-1.2 rad/s", "40 deg/s"] }}
[run]
duration = "37 s"
samples = 5
[sweep]
members = {members}
sampling = "{sampling}"
seed = 5
{more}
[[sweep.vary]]
key = "start.spin.body[0]"
normal = {{ mean = 0.3, sd = 0.9 }}
[[sweep.vary]]
key = "start.spin.body[2]"
uniform = {{ from = -2, to = 3 }}
"#
    );
    Plan::parse(&Disk, text, "plan.toml".as_ref()).unwrap_or_else(|error| panic!("{error}"))
}

/// Returns every file of a folder, by its relative path.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else {
            found.insert(name, fs::read(&path).unwrap());
        }
    }
    found
}

fn compute(dataset: &Dataset, plan: &Plan, threads: usize) -> SweepSummary {
    let reached = dataset.compute(plan, threads, &AtomicBool::new(false), &|_| {}).unwrap();
    assert_eq!(reached.done, reached.members);
    dataset.finish(plan, threads).unwrap().summary
}

#[test]
fn files_are_the_same_whoever_makes_them() {
    let scratch = Scratch::new("same");
    let plan = plan("monte carlo", 2_600, "trajectories = true");
    let make = |name: &str, threads: usize| {
        let folder = scratch.join(name);
        compute(&Dataset::create(&folder, &plan).unwrap(), &plan, threads);
        files(&folder)
    };
    let one = make("one", 1);
    assert_eq!(one, make("two", 2));
    assert_eq!(one, make("three", 3));
    let parts = one.keys().filter(|name| name.starts_with("members/")).count();
    assert!(parts > 5 && one.contains_key("trajectories/part-00000.parquet"), "{:?}", one.keys());

    // Written from outside in any order, as on a cluster.
    let folder = scratch.join("cluster");
    let dataset = Dataset::create(&folder, &plan).unwrap();
    let mut missing = dataset.missing().unwrap();
    assert_eq!(missing.len() as u64, dataset.parts());
    missing.reverse();
    for part in missing {
        let rows = inputs(&plan, dataset.rows(part));
        dataset.write_trajectories(part, &trajectories(&plan, &rows).unwrap()).unwrap();
        dataset.write(part, &simulate(&plan, &rows).unwrap()).unwrap();
    }
    dataset.finish(&plan, 1).unwrap();
    assert_eq!(one, files(&folder));

    let other = simulate(&plan, &inputs(&plan, 1..3)).unwrap();
    assert!(matches!(dataset.write(0, &other), Err(SweepError::Rows { part: 0, .. })));
    assert!(matches!(dataset.write(999, &other), Err(SweepError::Rows { part: 999, .. })));
}

#[test]
fn what_is_stopped_goes_on() {
    let scratch = Scratch::new("stop");
    let plan = plan("sobol", 4_096, "");
    let (whole, broken) = (scratch.join("whole"), scratch.join("broken"));
    compute(&Dataset::create(&whole, &plan).unwrap(), &plan, 2);
    let mut runs = 0;
    loop {
        let dataset = Dataset::resume(&broken, &plan).unwrap();
        let stop = AtomicBool::new(false);
        let before = dataset.missing().unwrap().len();
        let reached =
            dataset.compute(&plan, 1, &stop, &|p| stop.store(p.done >= 1024 * (runs + 1), Ordering::Relaxed));
        runs += 1;
        if reached.unwrap().done == 4_096 {
            dataset.finish(&plan, 1).unwrap();
            break;
        }
        assert!(dataset.missing().unwrap().len() < before);
        assert!(matches!(dataset.finish(&plan, 1), Err(SweepError::Incomplete { .. })));
    }
    assert_eq!(runs, 4);
    assert_eq!(files(&whole), files(&broken));
}

#[test]
fn damage_is_found_and_made_good() {
    let scratch = Scratch::new("damage");
    let plan = plan("latin hypercube", 2_048, "");
    let folder = scratch.join("d");
    compute(&Dataset::create(&folder, &plan).unwrap(), &plan, 1);
    let good = files(&folder);
    let part = |k: usize| folder.join(format!("members/part-{k:05}.parquet"));
    let bytes = fs::read(part(1)).unwrap();
    fs::write(part(1), &bytes[..bytes.len() / 2]).unwrap();
    let mut flipped = fs::read(part(2)).unwrap();
    flipped[1000] ^= 1;
    fs::write(part(2), flipped).unwrap();
    // Undamaged, but in the wrong place.
    fs::copy(part(0), part(3)).unwrap();
    fs::write(folder.join("members/part-00000.parquet.partial"), "half").unwrap();
    let dataset = Dataset::resume(&folder, &plan).unwrap();
    assert_eq!(dataset.missing().unwrap(), [1, 2, 3]);
    compute(&dataset, &plan, 2);
    assert_eq!(files(&folder), good);
}

#[test]
fn a_folder_is_one_sweeps_and_one_writers() {
    let scratch = Scratch::new("folder");
    let plan_a = plan("monte carlo", 600, "");
    let plan_b = plan("monte carlo", 601, "");
    let folder = scratch.join("deep/results");
    let dataset = Dataset::create(&folder, &plan_a).unwrap();
    for result in [Dataset::resume(&folder, &plan_a), Dataset::replace(&folder, &plan_a)] {
        let error = result.unwrap_err();
        assert!(matches!(error, SweepError::InUse { .. }), "{error}");
    }
    compute(&dataset, &plan_a, 1);
    drop(dataset);
    let before = files(&folder);
    let error = Dataset::create(&folder, &plan_a).unwrap_err();
    assert!(matches!(error, SweepError::Exists { .. }), "{error}");
    let error = Dataset::resume(&folder, &plan_b).unwrap_err();
    assert!(error.to_string().contains("600 members, but this plan has 601"), "{error}");
    // The same text with other whitespace is another plan, because the copies differ.
    let text = format!("{}\n", plan_a.text());
    let spaced = Plan::parse(&Disk, text, "plan.toml".as_ref()).unwrap();
    let error = Dataset::resume(&folder, &spaced).unwrap_err();
    assert!(matches!(error, SweepError::Changed { .. }), "{error}");
    assert_eq!(files(&folder), before);

    compute(&Dataset::replace(&folder, &plan_b).unwrap(), &plan_b, 1);
    assert_eq!(fs::read_to_string(folder.join("plan.toml")).unwrap(), plan_b.text());

    // Foreign files are never touched.
    fs::write(folder.join("notes.txt"), "mine").unwrap();
    let [resumed, replaced] = [Dataset::resume, Dataset::replace].map(|open| open(&folder, &plan_b));
    // The hint for a new sweep there does not suggest `--resume` or `--force`, which would be
    // refused.
    for result in [resumed, replaced, Dataset::create(&folder, &plan_b)] {
        let error = result.unwrap_err();
        assert!(error.to_string().contains("notes.txt"), "{error}");
        assert!(!error.hint().unwrap().contains("--resume"), "{error}");
    }
    let file = scratch.join("file");
    fs::write(&file, "a file").unwrap();
    assert!(matches!(Dataset::replace(&file, &plan_b), Err(SweepError::NotASweep { .. })));
    assert_eq!(fs::read(&file).unwrap(), b"a file");
}

#[test]
fn a_plan_without_times_is_refused() {
    let scratch = Scratch::new("no-run");
    let text = plan("sobol", 8, "").text().replace("[run]\nduration = \"37 s\"\nsamples = 5\n", "");
    let plan = Plan::parse(&Disk, text, "plan.toml".as_ref()).unwrap();
    let error = Dataset::create(&scratch.join("d"), &plan).unwrap_err();
    assert!(matches!(error, SweepError::NoRun) && error.hint().is_some(), "{error}");
    assert!(!scratch.join("d").exists());
}

/// Statistics of a sweep, compared with sorting and adding the members' values.
#[test]
fn statistics_are_those_of_the_rows() {
    let scratch = Scratch::new("statistics");
    let plan = plan("monte carlo", 3_001, "");
    let summary = compute(&Dataset::create(&scratch.join("d"), &plan).unwrap(), &plan, 2);
    let rows = simulate(&plan, &inputs(&plan, 0..3_001)).unwrap();
    assert_eq!(summary.inputs.len(), 2);
    let mut varied = 0;
    let all = summary.inputs.iter().chain(&summary.outcomes);
    // Rotations from a mean are not columns of a row.
    for statistic in all.filter(|statistic| !statistic.name.contains("_from_mean")) {
        let name = &statistic.name;
        let mut values: Vec<f64> = match &rows.column(name).unwrap().values {
            Values::Numbers(values) => values.clone(),
            Values::Perhaps(values) => values.iter().flatten().copied().collect(),
            _ => panic!("{name}"),
        };
        values.sort_by(f64::total_cmp);
        assert_eq!(statistic.count, values.len() as u64, "{name}");
        let Some((&least, &largest)) = values.first().zip(values.last()) else {
            assert_eq!((statistic.mean, statistic.min, statistic.quantiles.len()), (None, None, 0));
            continue;
        };
        assert_eq!((statistic.min, statistic.max), (Some(least), Some(largest)), "{name}");
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let deviation = (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
        let scale = least.abs().max(largest.abs());
        assert!((statistic.mean.unwrap() - mean).abs() <= 1e-13 * scale, "{name}");
        assert!((statistic.standard_deviation.unwrap() - deviation).abs() <= 1e-12 * scale, "{name}");
        for quantile in &statistic.quantiles {
            let place = (n - 1.0) * quantile.probability;
            let (below, part) = (place.floor() as usize, place.fract());
            let above = values[(below + 1).min(values.len() - 1)];
            let expected = values[below] * (1.0 - part) + above * part;
            assert!((quantile.value - expected).abs() <= 1e-15 * scale, "{name} {}", quantile.probability);
            for end in quantile.interval.into_iter().flatten() {
                assert!(values.binary_search_by(|x| x.total_cmp(&end)).is_ok(), "{name}");
            }
            // About z √(n p q) ranks to either side.
            let p = quantile.probability;
            let reach = 1.96 * (n * p * (1.0 - p)).sqrt();
            let [Some(low), Some(high)] = quantile.interval else {
                assert!(n < 400.0, "{name}");
                continue;
            };
            let rank = |x: f64| values.iter().filter(|y| **y < x).count() as f64;
            if least < largest && values.windows(2).all(|w| w[0] < w[1]) {
                assert!(
                    (rank(low) - (n * p - reach)).abs() < 3.0 && (rank(high) - (n * p + reach)).abs() < 3.0
                );
                varied += 1;
            }
        }
        let histogram = statistic.histogram.as_ref();
        assert_eq!(histogram.is_some(), least < largest, "{name}");
        if let Some(h) = histogram {
            assert_eq!(h.counts.iter().sum::<u64>() + h.below + h.above, statistic.count, "{name}");
            let inside = values.iter().filter(|x| (h.least..=h.greatest).contains(*x)).count();
            assert_eq!(h.counts.iter().sum::<u64>(), inside as u64, "{name}");
        }
        // Student's t is about z (1 + 1.2/n).
        let [low, high] = statistic.mean_interval.unwrap();
        assert!(
            (high - low - 2.0 * 1.959_964 * deviation / n.sqrt()).abs()
                <= 2.0 / n * (high - low) + 1e-14 * scale,
            "{name}"
        );
    }
    assert!(varied > 50, "{varied}");
    assert_eq!(summary.statuses.len(), 1);
    assert_eq!(summary.regimes.iter().map(|share| share.count).sum::<u64>(), 3_001);
    let text = summary.to_text();
    assert!(text.contains("3,001 members, Monte Carlo sampling") && text.contains("period_s"), "{text}");
}

#[test]
fn only_independent_members_have_intervals() {
    let scratch = Scratch::new("intervals");
    for (sampling, why) in [("latin hypercube", "not independent"), ("sobol", "not independent")] {
        let plan = plan(sampling, 256, "");
        let summary = compute(&Dataset::create(&scratch.join(sampling), &plan).unwrap(), &plan, 1);
        for statistic in summary.inputs.iter().chain(&summary.outcomes) {
            assert_eq!(statistic.mean_interval, None);
            assert!(statistic.quantiles.iter().all(|quantile| quantile.interval == [None, None]));
        }
        assert!(summary.statuses.iter().all(|share| share.interval.is_none()));
        assert!(summary.to_text().contains(why) && summary.to_json()["intervals"]["confidence"].is_null());
    }
}
