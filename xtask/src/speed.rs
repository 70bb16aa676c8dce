//! Pages of measured run times and errors; they require Python and the compared programs.

use std::process::Command;

use crate::process::run;
use crate::{Outcome, root};

/// Script that writes a page of the book with measurements.
struct Script {
    path: &'static str,
    page: &'static str,
    /// Modules that it imports, each with its package name for pip.
    packages: &'static [(&'static str, &'static str)],
}

const SCRIPTS: [Script; 6] = [
    Script {
        path: "crates/polhode/benches/speed.py",
        page: "book/speed.md",
        packages: &[("heyoka", "heyoka"), ("mpmath", "mpmath")],
    },
    Script {
        path: "crates/polhode/benches/work_precision.py",
        page: "book/work-precision.md",
        packages: &[
            ("heyoka", "heyoka"),
            ("scipy", "scipy"),
            ("mujoco", "mujoco"),
            ("mpmath", "mpmath"),
            ("numpy", "numpy"),
        ],
    },
    Script {
        path: "crates/polhode/benches/ensemble.py",
        page: "book/ensembles.md",
        packages: &[("heyoka", "heyoka"), ("numpy", "numpy"), ("scipy", "scipy")],
    },
    Script {
        path: "benches/mass.py",
        page: "book/mass-properties.md",
        packages: &[("numpy", "numpy"), ("trimesh", "trimesh"), ("scipy", "scipy"), ("OCP", "cadquery-ocp")],
    },
    Script {
        path: "benches/python/measure.py",
        page: "book/peers.md",
        packages: &[
            ("heyoka", "heyoka"),
            ("scipy", "scipy"),
            ("mujoco", "mujoco"),
            ("trimesh", "trimesh"),
            ("numpy", "numpy"),
            ("polhode", "./crates/polhode-py"),
        ],
    },
    Script {
        path: "benches/clusters/measure.py",
        page: "book/clusters-dask.md",
        packages: &[
            ("distributed", "distributed"),
            ("ray", "ray"),
            ("pyarrow", "pyarrow"),
            ("polhode", "./crates/polhode-py"),
        ],
    },
];

/// Runs all scripts, if all required modules are installed.
pub(crate) fn measure() -> Outcome {
    let missing: Vec<&str> = SCRIPTS
        .iter()
        .flat_map(|script| script.packages)
        .map(|(module, package)| Ok((imports(module)?, *package)))
        .collect::<Result<Vec<_>, String>>()?
        .into_iter()
        .filter_map(|(there, package)| (!there).then_some(package))
        .collect();
    if !missing.is_empty() {
        let names = missing.join(" ");
        return Err(format!("python3 lacks what polhode is compared with: python3 -m pip install {names}"));
    }
    for Script { path, page, .. } in SCRIPTS {
        println!("   {path} writes {page}; leave the machine alone while it measures");
        run(Command::new("python3").arg(path).current_dir(root()))?;
    }
    Ok(())
}

/// Returns true if Python finds a module, without loading it.
fn imports(module: &str) -> Result<bool, String> {
    const FIND: &str =
        "import importlib.util, sys; sys.exit(0 if importlib.util.find_spec(sys.argv[1]) else 3)";
    let status = Command::new("python3")
        .args(["-c", FIND, module])
        .status()
        .map_err(|error| format!("python3: {error}; it runs the scripts that measure"))?;
    match status.code() {
        Some(0) => Ok(true),
        Some(3) => Ok(false),
        _ => Err(format!("python3 ended with {status} when asked for {module}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_script_is_there_and_needs_what_is_said() {
        for Script { path, page, packages } in SCRIPTS {
            let text = crate::read(&root().join(path)).unwrap_or_default();
            assert!(text.contains(page), "{path} does not name {page}");
            for (module, package) in packages {
                assert!(text.contains(module), "{path} does not need {module}");
                let pip = text.lines().find(|line| line.contains("pip install")).unwrap_or_default();
                assert!(pip.split_whitespace().any(|word| word == *package), "{path}: {pip}");
            }
        }
    }
}
