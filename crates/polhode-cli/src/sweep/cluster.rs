//! Sweeps on a cluster: the Python package does it.

use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

use super::Sweep;
use crate::failure::Failure;

/// `ray://HOST:PORT` or `dask://HOST:PORT`, or `local` for a cluster that is started here.
pub(super) fn url(text: &str) -> Result<String, String> {
    let place = text.strip_prefix("ray://").or_else(|| text.strip_prefix("dask://"));
    let is_place = |place: &str| {
        let (host, port) = place.rsplit_once(':').unwrap_or((place, ""));
        place == "local" || !host.is_empty() && port.parse::<u16>().is_ok()
    };
    match place {
        Some(place) if is_place(place) => Ok(text.to_owned()),
        _ => {
            Err("a cluster is ray://HOST:PORT or dask://HOST:PORT, or local instead of HOST:PORT".to_owned())
        }
    }
}

/// Runs `python3 -m polhode.sweep` with the same arguments, and ends as it does.
pub(super) fn hand_over(sweep: &Sweep, url: &str, target: &Path) -> Result<(), Failure> {
    let engine = if url.starts_with("ray") { "ray" } else { "dask" };
    let install = format!("install it with: python3 -m pip install 'polhode[{engine}]'");
    // With what it says thrown away: a missing package is told in our words.
    let found = Command::new("python3")
        .args(["-c", "import polhode.sweep"])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    match found {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            return Err(Failure::usage(
                "a sweep on a cluster needs Python, and there is no python3 in the PATH",
                format!("install Python 3.10 or later, and then polhode: {install}"),
            ));
        }
        Err(error) => return Err(Failure::usage(format!("python3 cannot be run: {error}"), install)),
        Ok(status) if !status.success() => {
            let message =
                "a sweep on a cluster needs the Python package polhode, which this python3 does not have";
            return Err(Failure::usage(message, install));
        }
        Ok(_) => {}
    }
    let mut command = Command::new("python3");
    command.args(["-m", "polhode.sweep"]).arg(&sweep.plan).arg("-o").arg(target).args(["--on", url]);
    for (wanted, flag) in [(sweep.resume, "--resume"), (sweep.force, "--force"), (sweep.json, "--json")] {
        if wanted {
            command.arg(flag);
        }
    }
    if let Some(threads) = sweep.threads {
        command.arg("--threads").arg(threads.to_string());
    }
    let status = command
        .status()
        .map_err(|error| Failure::usage(format!("python3 cannot be run: {error}"), install))?;
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
