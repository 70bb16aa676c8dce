//! How long a parts list of 100,000 rows takes, from its file to a `Budget`: `cargo bench -p polhode-formats --bench budget`.

#![allow(clippy::print_stdout, reason = "a bench prints")]

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use polhode_formats::budget;

const ROWS: usize = 100_000;

fn main() {
    let csv = list();
    let folder = std::env::temp_dir();
    let path = folder.join(format!("polhode-budget-{}.csv", std::process::id()));
    std::fs::write(&path, &csv).unwrap();
    time("CSV", &path, csv.len());
    std::fs::remove_file(path).unwrap();
}

fn time(what: &str, path: &Path, bytes: usize) {
    let mut best = f64::INFINITY;
    for _ in 0..5 {
        let start = Instant::now();
        let file = budget::read(path).unwrap();
        best = best.min(start.elapsed().as_secs_f64());
        assert_eq!(file.configurations[0].budget.list().rows.len(), ROWS);
    }
    println!("{what}: {ROWS} rows, {:.1} MB in {best:.3} s", bytes as f64 / 1e6);
}

/// Assemblies of a hundred parts, each with a place, a tensor, and errors.
fn list() -> String {
    let mut text = String::from(
        "# products = \"tensor elements\"\n# about = \"center\"\n# growth = { E = 0.25, C = 0.1 }\n\
         name,parent,quantity,mass [g],mass sd [g],x [mm],y [mm],z [mm],x sd [mm],at x [mm],at y [mm],at z [mm],\
         Ixx [g mm^2],Iyy [g mm^2],Izz [g mm^2],Ixy [g mm^2],Ixz [g mm^2],Iyz [g mm^2],maturity\nwhole,,,,,,,,,,,,,,,,,,\n",
    );
    let mut seed = 1_u64;
    let mut next = |least: f64, most: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        least + (most - least) * ((seed >> 11) as f64 / (1_u64 << 53) as f64)
    };
    for k in 1..ROWS {
        let assembly = (k - 1) / 100 * 100 + 1;
        let (name, parent) = match k == assembly {
            true => (format!("assembly {k}"), "whole".to_owned()),
            false => (format!("part {k}"), format!("assembly {assembly}")),
        };
        let (mass, arm) = (next(1.0, 900.0), next(5.0, 40.0));
        let moment = mass * arm * arm;
        let _ = write!(text, "{name},{parent},{},{mass:.2},{:.3},", 1 + k % 3, 0.02 * mass);
        for _ in 0..3 {
            let _ = write!(text, "{:.2},", next(-300.0, 300.0));
        }
        let _ = write!(
            text,
            "0.25,{:.1},{:.1},{:.1},",
            next(-900.0, 900.0),
            next(-900.0, 900.0),
            next(-900.0, 900.0)
        );
        let _ = write!(text, "{:.1},{:.1},{:.1},", 0.9 * moment, moment, 1.1 * moment);
        let _ = writeln!(
            text,
            "{:.2},{:.2},{:.2},{}",
            0.02 * moment,
            -0.03 * moment,
            0.01 * moment,
            ["E", "C"][k % 2]
        );
    }
    text
}
