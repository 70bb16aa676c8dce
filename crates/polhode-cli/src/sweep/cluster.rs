//! Sweeps on a cluster, run by the Python package.

use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

use super::Sweep;
use crate::failure::Failure;

/// Parses `ray://HOST:PORT`, `dask://HOST:PORT`, or `local` for a cluster started on this machine.
pub(super) fn url(text: &str) -> Result<String, String> {
    let place = text.strip_prefix("ray://").or_else(|| text.strip_prefix("dask://"));
    let is_place = |place: &str| {
        let (host, port) = place.rsplit_once(':').unwrap_or((place, ""));
        place == "local" || !host.is_empty() && port.parse::<u16>().is_ok()
    };
    match place {
        Some(place) if is_place(place) => Ok(text.to_owned()),
        _ => Err("expected ray://HOST:PORT or dask://HOST:PORT, or local instead of HOST:PORT".to_owned()),
    }
}

/// Returns the Python modules that an engine requires, and the packages that install them.
fn needed(engine: &str) -> [(&'static str, &'static str); 3] {
    // The package is installed from a checkout of polhode.
    let polhode = ("polhode", "./crates/polhode-py");
    let cluster =
        if engine == "ray" { ("ray", "'ray[data,client]'") } else { ("distributed", "distributed") };
    [("pyarrow", "pyarrow"), cluster, polhode]
}

/// Runs `python3 -m polhode.sweep` with the same arguments, and returns its exit status.
pub(super) fn hand_over(sweep: &Sweep, url: &str, target: &Path) -> Result<(), Failure> {
    let engine = if url.starts_with("ray") { "ray" } else { "dask" };
    let needed = needed(engine);
    let install = |packages: &[&str]| {
        format!("in a checkout of polhode: python3 -m pip install {}", packages.join(" "))
    };
    let cannot = |error: &io::Error| {
        let hint = "polhode sweep --on runs `python3 -m polhode.sweep`: check which python3 is in the PATH";
        Failure::usage(format!("python3 cannot be run: {error}"), hint)
    };
    // Modules are searched, not imported: a module that fails to import reports the reason itself.
    let names = needed.map(|(module, _)| format!("'{module}'")).join(", ");
    let look = format!(
        "from importlib.util import find_spec\nprint(*(m for m in ({names}) if find_spec(m) is None))"
    );
    let found = Command::new("python3").args(["-c", &look]).stdin(Stdio::null()).output();
    let found = match found {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            return Err(Failure::usage(
                "a sweep on a cluster needs Python, but python3 is not in the PATH",
                format!(
                    "install Python 3.10 or later; then, {}",
                    install(&needed.map(|(_, package)| package))
                ),
            ));
        }
        Err(error) => return Err(cannot(&error)),
        Ok(found) => String::from_utf8_lossy(&found.stdout).into_owned(),
    };
    let is_missing = |module: &str| found.split_whitespace().any(|name| name == module);
    let missing: Vec<_> = needed.into_iter().filter(|(module, _)| is_missing(module)).collect();
    if !missing.is_empty() {
        let modules: Vec<_> = missing.iter().map(|(module, _)| *module).collect();
        let packages: Vec<_> = missing.iter().map(|(_, package)| *package).collect();
        let message = format!(
            "a sweep on {engine} needs Python packages that are not installed for this python3: {}",
            modules.join(", ")
        );
        return Err(Failure::usage(message, install(&packages)));
    }
    let mut command = Command::new("python3");
    command.args(["-m", "polhode.sweep"]).arg(&sweep.request.plan).arg("-o").arg(target).args(["--on", url]);
    for (wanted, flag) in [(sweep.resume, "--resume"), (sweep.force, "--force"), (sweep.json, "--json")] {
        if wanted {
            command.arg(flag);
        }
    }
    if let Some(threads) = sweep.request.threads {
        command.arg("--threads").arg(threads.to_string());
    }
    let status = command.status().map_err(|error| cannot(&error))?;
    match status.code() {
        Some(0) => Ok(()),
        code => Err(Failure::Status(code.and_then(|code| u8::try_from(code).ok()).unwrap_or(2))),
    }
}

#[cfg(test)]
mod tests {
    use super::url;

    #[test]
    fn a_cluster_is_an_engine_a_host_and_a_port() {
        assert_eq!(url("ray://127.0.0.1:10001").as_deref(), Ok("ray://127.0.0.1:10001"));
        assert_eq!(url("dask://node-1.example:8786").as_deref(), Ok("dask://node-1.example:8786"));
        assert_eq!(url("dask://local").as_deref(), Ok("dask://local"));
        for wrong in
            ["ray://", "ray://host", "ray://host:port", "http://host:80", "dask://:1", "dask://h:99999"]
        {
            assert!(url(wrong).is_err(), "{wrong}");
        }
    }
}
