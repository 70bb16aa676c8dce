//! Long parts lists: a given number of draws is kept, and memory is a few hundred bytes per row.
#![cfg(target_os = "linux")]

use std::fmt::Write as _;
use std::fs::{self, File};
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

use polhode_budget::report::workbook::{self, Cell, Sheet};

use crate::common::{Scratch, json, refused};

/// List with errors: assemblies of 50 parts, each with a mass, its standard deviation and a centre;
/// every tenth has a tensor.
struct Parts {
    rows: usize,
}

impl Parts {
    const HEAD: [&str; 10] = [
        "name",
        "parent",
        "mass [g]",
        "mass sd [g]",
        "x [mm]",
        "y [mm]",
        "z [mm]",
        "Ixx [g mm^2]",
        "Iyy [g mm^2]",
        "Izz [g mm^2]",
    ];

    fn cells(&self) -> impl Iterator<Item = Vec<Cell>> {
        let text = |text: String| Cell::Text(text);
        let mut state = 1_u64;
        let mut number = move |size: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (size * ((state >> 11) as f64 / (1_u64 << 53) as f64) * 1e4).round() / 1e4
        };
        let root = vec![text("sc".to_owned())];
        [root].into_iter().chain((0..self.rows).map(move |k| {
            if k % 51 == 0 {
                return vec![text(format!("unit {}", k / 51)), text("sc".to_owned())];
            }
            let mass = 1.0 + number(900.0);
            let mut row = vec![text(format!("part {k}")), text(format!("unit {}", k / 51))];
            row.extend(
                [mass, 0.01 + number(5.0), number(800.0), number(700.0), number(900.0)].map(Cell::Number),
            );
            if k % 10 == 0 {
                row.extend([100.0, 110.0, 120.0].map(|i| Cell::Number(i * mass)));
            }
            row
        }))
    }

    fn csv(&self) -> String {
        let mut all = "# about = \"center\"\n".to_owned() + &Self::HEAD.join(",") + "\n";
        for row in self.cells() {
            for (k, cell) in row.iter().enumerate() {
                let comma = if k > 0 { "," } else { "" };
                let _ = match cell {
                    Cell::Empty => write!(all, "{comma}"),
                    Cell::Text(text) => write!(all, "{comma}{text}"),
                    Cell::Number(number) => write!(all, "{comma}{number}"),
                };
            }
            all.push('\n');
        }
        all
    }

    fn write_workbook(&self, file: File) {
        let head = Self::HEAD.map(|name| Cell::Text(name.to_owned())).to_vec();
        let parts = Sheet { name: "parts", rows: [head].into_iter().chain(self.cells()).collect() };
        let plan = vec![Cell::Text("about".to_owned()), Cell::Text("center".to_owned())];
        workbook::write(&[parts, Sheet { name: "plan", rows: vec![plan] }], file).unwrap();
    }
}

/// Returns the peak memory of a run, bytes, its duration, s, and its output length.
fn peak(scratch: &Scratch, arguments: &[&str]) -> (f64, f64, usize) {
    let begun = Instant::now();
    let (out, errors) =
        (File::create(scratch.0.join("out")).unwrap(), File::create(scratch.0.join("err")).unwrap());
    let mut child =
        scratch.command(arguments).stdout(Stdio::from(out)).stderr(Stdio::from(errors)).spawn().unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut most = 0.0_f64;
    let ended = loop {
        let text = fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kib = line.and_then(|line| line.trim().strip_suffix(" kB")?.parse::<f64>().ok());
        most = most.max(1024.0 * kib.unwrap_or(0.0));
        if let Some(ended) = child.try_wait().unwrap() {
            break ended;
        }
        sleep(Duration::from_millis(1));
    };
    assert!(ended.success(), "{arguments:?}: {}", fs::read_to_string(scratch.0.join("err")).unwrap());
    (most, begun.elapsed().as_secs_f64(), fs::read_to_string(scratch.0.join("out")).unwrap().lines().count())
}

/// Returns the memory per row without the file itself, bytes: from the difference between a long
/// list and one of a sixth of its rows, because the peak of a very short run is not measured.
fn bytes_a_row(rows: usize, forms: &[&[&str]]) {
    let scratch = Scratch::new(&format!("long-{rows}"));
    for (name, rows) in [("short", rows / 6), ("long", rows)] {
        scratch.write(&format!("{name}.csv"), &Parts { rows }.csv());
        let workbook = File::create(scratch.0.join(format!("{name}.xlsx"))).unwrap();
        Parts { rows }.write_workbook(workbook);
    }
    for file in ["long.csv", "long.xlsx"] {
        for options in forms {
            let name = options.join(" ");
            let run = |file: &str| {
                let length = fs::metadata(scratch.0.join(file)).unwrap().len() as f64;
                let (most, seconds, lines) = peak(&scratch, &[&["budget", file], *options].concat());
                (most - length, seconds, lines)
            };
            let ((few, ..), (many, seconds, lines)) = (run(&file.replace("long", "short")), run(file));
            let each = (many - few) / (rows - rows / 6) as f64;
            eprintln!("{rows} rows, {file}, {name}: {each:.0} bytes a row beyond the file, {seconds:.1} s");
            assert!(each < 400.0, "{file} {name}: {each} bytes a row");
            assert!(options.len() > 2 || options[0] == "--csv" || lines < 300, "{lines} lines");
        }
    }
}

#[test]
fn memory_is_a_few_hundred_bytes_a_row() {
    bytes_a_row(12_000, &[&["--draws", "10"]]);
}

/// `POLHODE_BUDGET_ROWS=1000000 cargo test --release -p polhode-cli --test all budget_long --
/// --ignored --nocapture` runs it with a million rows.
#[test]
#[ignore = "measures 10⁵ to 10⁶ rows for minutes; the gate measures 12,000"]
fn memory_of_very_long_lists_is_a_few_hundred_bytes_a_row() {
    let rows = std::env::var("POLHODE_BUDGET_ROWS").map_or(100_000, |rows| rows.parse().unwrap());
    bytes_a_row(rows, &[&["--draws", "10"], &["--json", "--draws", "10"], &["--csv"]]);
}

#[test]
fn draws_are_as_many_as_are_asked_for() {
    let scratch = Scratch::new("asked-draws");
    let list = "name,mass [g],x [mm]\na,100 ± 3,20\nb,50,-10\n";
    scratch.write("asks.csv", &format!("# [result]\n# draws = 10_050\n{list}"));
    scratch.write("plain.csv", list);
    let count = |arguments: &[&str]| {
        let output = scratch.run(&[&["budget", "--json"], arguments].concat());
        json(&output)["configurations"][0]["draws"]["count"].as_u64().unwrap()
    };
    assert_eq!(count(&["asks.csv"]), 10_050);
    assert_eq!(count(&["asks.csv", "--draws", "12"]), 12);
    assert_eq!(count(&["plain.csv"]), 10_000);
    assert_eq!(count(&["plain.csv", "--draws", "10050"]), 10_050);
    for most in ["10000001", "9"] {
        let error = refused(&scratch.run(&["budget", "plain.csv", "--draws", most]), 2);
        assert!(error.contains("it must be 0, or from 10 to 10000000"), "{error}");
    }
    // 2000 uncertain rows in 40 assemblies, and the root.
    scratch.write("long.csv", &Parts { rows: 2000 }.csv());
    let error = refused(&scratch.run(&["budget", "long.csv", "--draws", "10000000"]), 2);
    assert!(error.contains("10000000 draws of 2001 uncertain rows are too many: at most 4997501"), "{error}");
    scratch.write("few.csv", &format!("# [result]\n# draws = 9\n{list}"));
    let error = refused(&scratch.run(&["budget", "few.csv"]), 2);
    assert!(
        error.contains("draws = 9 must be from 10 to 10000000") && error.contains("few.csv:2:11"),
        "{error}"
    );
}

#[test]
fn json_that_is_written_row_by_row_is_that_of_the_whole() {
    let scratch = Scratch::new("streamed");
    scratch.write(
        "list.csv",
        "# title = \"\\\"rows\\\": null\"\nname,parent,mass [g],configuration\nsc,,,\nä \"quoted\",sc,1 ± 0.1,\n\"b,c\",sc,2,stowed\nd,sc,3,open\n",
    );
    let found = json(&scratch.run(&["budget", "list.csv", "--json", "--draws", "10"]));
    let names = |k: usize| -> Vec<String> {
        let rows = found["configurations"][k]["rows"].as_array().unwrap();
        rows.iter().map(|row| row["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(found["title"], "\"rows\": null");
    assert_eq!(names(0), ["sc", "ä \"quoted\"", "b,c"]);
    assert_eq!(names(1), ["sc", "ä \"quoted\"", "d"]);
    assert_eq!(found["configurations"][1]["rows"][0]["basic"], 0.004);
}
