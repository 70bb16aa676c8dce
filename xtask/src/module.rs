//! WebAssembly modules: builds of `polhode-wasm`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process::{cargo, output, run};
use crate::{Outcome, root};

const TARGET: &str = "wasm32-unknown-unknown";

/// Largest memory of a module, bytes.
const MEMORY: u32 = 1 << 30;

/// Profile in which only the size counts.
pub(crate) const SMALL: &str = "npm";

/// Profiles of cargo: those of a release, and a quick one for tests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Build {
    Release,
    Quick,
}

/// Returns the folder of all modules and their builds.
pub(crate) fn folder() -> PathBuf {
    root().join("target/page")
}

/// Builds the module with these features to `target/page/NAME.wasm`, and returns its path. `profile`
/// is that of a release.
pub(crate) fn build(build: Build, features: &str, profile: &str, name: &str) -> Result<PathBuf, String> {
    let profile = match build {
        Build::Release => profile,
        Build::Quick => "page-quick",
    };
    let package = ["build", "--locked", "--package", "polhode-wasm", "--features", features];
    let mut command = cargo(&[&package[..], &["--target", TARGET, "--profile", profile]].concat());
    let mut flags = format!("-Clink-arg=--max-memory={MEMORY}");
    if build == Build::Release {
        // Without messages of defects, which make the module larger.
        flags += " -Zunstable-options -Cpanic=immediate-abort";
    }
    // Vectors of two numbers make the module 4 % smaller, and the rattleback 2.4 times as fast.
    flags += " -Ctarget-feature=+simd128";
    command.env("CARGO_TARGET_DIR", folder()).env("RUSTFLAGS", flags);
    Toolchain::find(build)?.apply(&mut command)?;
    if build == Build::Release {
        // Shorter sorts of the standard library: 7 % of the small module.
        command.arg("-Zbuild-std-features=optimize_for_size");
    }
    run(&mut command)?;
    let module = folder().join(name).with_extension("wasm");
    let built = folder().join(TARGET).join(profile).join("polhode_wasm.wasm");
    std::fs::copy(&built, &module).map_err(|error| format!("{}: {error}", built.display()))?;
    Ok(module)
}

/// A compiler with the standard library for WebAssembly, or with its sources.
///
/// Cargo compiles the sources too, which is not stable yet: a release needs it for a standard
/// library without messages.
enum Toolchain {
    /// The compiler of cargo, with the target installed: `rustup target add wasm32-unknown-unknown`.
    Own,
    /// The compiler of cargo, with the sources installed: `rustup component add rust-src`.
    OwnSources,
    /// The compiler of Debian's `rustc-web`, with the sources `rust-web-src`.
    Debian,
}

/// Compiler and sources of Debian's packages.
const DEBIAN: [&str; 2] = ["/usr/bin/rustc", "/usr/lib/rustlib/src/rust/library/std/src/lib.rs"];

impl Toolchain {
    /// Finds a compiler; installs Debian's if there is none and the system permits that.
    fn find(build: Build) -> Result<Self, String> {
        let libraries = output(Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]))?;
        if build == Build::Quick && Path::new(libraries.trim()).is_dir() {
            return Ok(Self::Own);
        }
        if Path::new(&sysroot()?).join("lib/rustlib/src/rust/library/std/src/lib.rs").is_file() {
            return Ok(Self::OwnSources);
        }
        let is_there = || DEBIAN.iter().all(|path| Path::new(path).is_file());
        if !is_there() {
            println!("   no standard library for {TARGET}: installing Debian's");
            let apt = |arguments: &[&str]| {
                run(Command::new("apt-get").args(arguments).env("DEBIAN_FRONTEND", "noninteractive"))
            };
            let install =
                ["install", "-qq", "-y", "--no-install-recommends", "rustc-web", "rust-web-src", "lld"];
            apt(&["update", "-qq"]).and_then(|()| apt(&install)).map_err(|why| {
                format!("the module needs `rustup component add rust-src`, or Debian's rustc-web and rust-web-src ({why})")
            })?;
        }
        if is_there() { Ok(Self::Debian) } else { Err(format!("{} is not there", DEBIAN[1])) }
    }

    fn apply(&self, command: &mut Command) -> Outcome {
        match self {
            Self::Own => return Ok(()),
            Self::OwnSources => {}
            Self::Debian => {
                command.env("RUSTC", DEBIAN[0]);
            }
        }
        command.env("RUSTC_BOOTSTRAP", "1").arg("-Zbuild-std=std,panic_abort");
        // rustup's toolchain has the linker that Debian's uses, outside the path.
        let host = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
        let linkers = Path::new(&sysroot()?).join("lib/rustlib").join(host).join("bin");
        let path = std::env::var_os("PATH").unwrap_or_default();
        let folders = std::env::split_paths(&path).chain([linkers]);
        command.env("PATH", std::env::join_paths(folders).map_err(|error| error.to_string())?);
        Ok(())
    }
}

/// Returns the folder of the compiler.
fn sysroot() -> Result<String, String> {
    output(Command::new("rustc").args(["--print", "sysroot"])).map(|path| path.trim().to_owned())
}
