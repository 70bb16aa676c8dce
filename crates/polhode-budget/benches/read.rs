//! Time to read a parts list of 100,000 rows, from its file to a `Budget`:
//! `cargo bench -p polhode-budget --bench read`.
//!
//! Times are processor seconds if the system counts these. Other programs do not lengthen them.

#![allow(clippy::print_stdout, reason = "a bench prints")]

use std::error::Error;
use std::fmt::Write as _;
use std::time::Instant;

use polhode_budget::read as budget;

const ROWS: usize = 100_000;

fn main() -> Result<(), Box<dyn Error>> {
    let csv = list();
    time("csv", csv.as_bytes())?;
    time("xlsx", &workbook(&csv)?)
}

fn time(kind: &str, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    let path = std::env::temp_dir().join(format!("polhode-budget-{}.{kind}", std::process::id()));
    std::fs::write(&path, bytes)?;
    let begin = Instant::now();
    let mut best = f64::INFINITY;
    for _ in 0..5 {
        let start = now(begin);
        let file = budget::read(&path)?;
        best = best.min(now(begin) - start);
        assert_eq!(file.configurations[0].budget.list().rows.len(), ROWS);
    }
    std::fs::remove_file(path)?;
    println!("{kind}: {ROWS} rows, {:.1} MB in {best:.3} s", bytes.len() as f64 / 1e6);
    Ok(())
}

fn now(begin: Instant) -> f64 {
    let nanoseconds = std::fs::read_to_string("/proc/thread-self/schedstat")
        .ok()
        .and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| begin.elapsed().as_secs_f64(), |ns| ns * 1e-9)
}

/// Returns the list as a workbook, in the form that spreadsheet programs write.
fn workbook(csv: &str) -> Result<Vec<u8>, Box<dyn Error>> {
    const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let mut sheet = String::from("<worksheet><sheetData>");
    let mut plan = String::from("<worksheet><sheetData>");
    let cell = |place: &str, text: &str| match text.parse::<f64>() {
        Ok(_) => format!("<c r=\"{place}\"><v>{text}</v></c>"),
        Err(_) => format!("<c r=\"{place}\" t=\"inlineStr\"><is><t>{text}</t></is></c>"),
    };
    let (mut row, mut key) = (0, 0);
    for line in csv.lines() {
        if let Some((name, value)) = line.strip_prefix("# ").and_then(|line| line.split_once(" = ")) {
            key += 1;
            let value = value.trim_matches('"');
            let [a, b] = [cell(&format!("A{key}"), name), cell(&format!("B{key}"), value)];
            let _ = write!(plan, "<row r=\"{key}\">{a}{b}</row>");
            continue;
        }
        row += 1;
        let _ = write!(sheet, "<row r=\"{row}\">");
        for (column, text) in line.split(',').enumerate().filter(|(_, text)| !text.is_empty()) {
            let place = format!("{}{row}", char::from(b'A' + column as u8));
            sheet += &cell(&place, text);
        }
        sheet += "</row>";
    }
    let relations = |list: &[(&str, &str)]| {
        let one = |(kind, target): &(&str, &str)| {
            format!("<Relationship Id=\"{target}\" Type=\"{OFFICE}/{kind}\" Target=\"{target}\"/>")
        };
        format!("<Relationships>{}</Relationships>", list.iter().map(one).collect::<String>())
    };
    let named = |name: &str| format!("<sheet name=\"{name}\" r:id=\"{name}.xml\"/>");
    let list = format!(
        "<workbook xmlns:r=\"{OFFICE}\"><sheets>{}{}</sheets></workbook>",
        named("parts"),
        named("plan")
    );
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, text) in [
        ("_rels/.rels", relations(&[("officeDocument", "workbook.xml")])),
        ("_rels/workbook.xml.rels", relations(&[("worksheet", "parts.xml"), ("worksheet", "plan.xml")])),
        ("workbook.xml", list),
        ("parts.xml", sheet + "</sheetData></worksheet>"),
        ("plan.xml", plan + "</sheetData></worksheet>"),
    ] {
        zip.start_file(name, zip::write::SimpleFileOptions::default())?;
        std::io::Write::write_all(&mut zip, text.as_bytes())?;
    }
    Ok(zip.finish()?.into_inner())
}

/// Returns a list of assemblies with a hundred parts each. Each part has a place, a tensor and
/// errors.
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
