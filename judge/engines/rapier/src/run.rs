//! Command line: `DIR --setting NAME [--out OUT] [--step S]… [--case NAME]…`.

use crate::case::{Case, Row, write};
use std::{error::Error, fs, path::PathBuf, time::Instant};

/// Name of a setting, text of the engine, and its own step, s.
pub type Setting = (&'static str, &'static str, f64);

/// Runs the cases. `run` returns rows, or the reason why the engine cannot compute a case.
pub fn run(
    settings: &[Setting],
    run: impl Fn(&Case, &str, f64) -> Result<Vec<Row>, String>,
) -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let suite = PathBuf::from(args.next().ok_or("a folder with suite.json is missing")?);
    let (mut out, mut setting, mut steps, mut only) =
        (suite.clone(), "default".to_owned(), Vec::new(), Vec::new());
    while let Some(flag) = args.next() {
        let value = args.next().ok_or(format!("{flag} needs a value"))?;
        match flag.as_str() {
            "--out" => out = value.into(),
            "--setting" => setting = value,
            "--step" => steps.push(value.parse()?),
            "--case" => only.push(value),
            _ => return Err(format!("{flag} is unknown").into()),
        }
    }
    let &(_, engine, own) = settings.iter().find(|s| s.0 == setting).ok_or("no such setting")?;
    fs::create_dir_all(&out)?;
    let many = !steps.is_empty();
    if !many {
        steps.push(own);
    }
    let json: serde_json::Value = serde_json::from_str(&fs::read_to_string(suite.join("suite.json"))?)?;
    let mut not_run = String::new();
    for value in json["cases"].as_array().ok_or("there are no cases")? {
        let case = Case::read(value).ok_or(format!("{} is not understood", value["name"]))?;
        if !only.is_empty() && !only.contains(&case.name) {
            continue;
        }
        for &step in &steps {
            let name = if many { format!("{}@{step}", case.name) } else { case.name.clone() };
            let start = Instant::now();
            let mut rows = match run(&case, &setting, step) {
                Ok(rows) => rows,
                Err(why) => {
                    not_run += &format!("{name}: not run: {why}\n");
                    continue;
                }
            };
            let finite = |r: &Row| r.attitude.iter().chain(&r.omega_body).all(|v| v.is_finite());
            if let Some(end) = rows.iter().position(|r| !finite(r)) {
                rows.truncate(end);
                not_run += &format!(
                    "{name}: ends after {:?} s: the engine's state is not finite\n",
                    rows[end.max(1) - 1].time
                );
            }
            if rows.len() < 2 {
                continue;
            }
            write(&out.join(format!("{name}.csv")), engine, step, &rows)?;
            println!("{name}: {} rows, {:.2} s", rows.len(), start.elapsed().as_secs_f64());
        }
    }
    print!("{not_run}");
    fs::write(out.join("not-run.txt"), not_run)?;
    Ok(())
}
