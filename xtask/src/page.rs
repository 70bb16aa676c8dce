//! The interactive page, `polhode.html`: the engine as a WebAssembly module, and the viewer around it.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use lzma_rust2::{XzOptions, XzWriter};

use crate::process::{cargo, output, run};
use crate::viewer;
use crate::{Outcome, root};

const TARGET: &str = "wasm32-unknown-unknown";

/// Largest memory of the module, bytes.
const MEMORY: u32 = 1 << 30;

/// Largest size of the page, bytes.
const MOST: u64 = 3_000_000;

/// Profiles of cargo: that of a release, and a quick one for tests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Build {
    Release,
    Quick,
}

/// Builds the module and the page into `target/page/`.
pub(crate) fn build(build: Build) -> Outcome {
    let profile = match build {
        Build::Release => "page",
        Build::Quick => "page-quick",
    };
    let folder = folder();
    let arguments =
        ["build", "--locked", "--package", "polhode-wasm", "--target", TARGET, "--profile", profile];
    let mut command = cargo(&arguments);
    let mut flags = format!("-Clink-arg=--max-memory={MEMORY}");
    if build == Build::Release {
        // Without messages of defects, which make the module larger.
        flags += " -Zunstable-options -Cpanic=immediate-abort";
    }
    // Vectors of two numbers make the module 4 % smaller, and the rattleback 2.4 times as fast.
    flags += " -Ctarget-feature=+simd128";
    command.env("CARGO_TARGET_DIR", &folder).env("RUSTFLAGS", flags);
    Toolchain::find(build)?.apply(&mut command)?;
    run(&mut command)?;
    let module = folder.join("polhode.wasm");
    let built = folder.join(TARGET).join(profile).join("polhode_wasm.wasm");
    std::fs::copy(&built, &module).map_err(|error| format!("{}: {error}", built.display()))?;
    let module = packed(&module, build)?;
    let page = folder.join("polhode.html");
    let mut viewer = Command::new("node");
    viewer.args(["build.mjs", "--module"]).arg(&module).arg("--page").arg(&page);
    if build == Build::Release {
        let commit = output(Command::new("git").args(["rev-parse", "HEAD"]).current_dir(root()))?;
        viewer.args(["--commit", commit.trim()]);
    }
    run(viewer.current_dir(root().join("viewer")))?;
    if build == Build::Release { size() } else { Ok(()) }
}

/// Builds the page quickly, and runs its tests in a browser.
pub(crate) fn check() -> Outcome {
    build(Build::Quick)?;
    viewer::check_page()
}

/// Puts the page of a release where the command includes it.
pub(crate) fn release() -> Outcome {
    build(Build::Release)?;
    viewer::check_page()?;
    viewer::check_bits()?;
    let committed = root().join("crates/polhode-live/assets/polhode.html");
    std::fs::copy(folder().join("polhode.html"), &committed)
        .map(|_| ())
        .map_err(|error| format!("{}: {error}", committed.display()))
}

/// Returns the folder of the module and the page.
pub(crate) fn folder() -> PathBuf {
    root().join("target/page")
}

/// Compresses the module as XZ, and returns its new path.
///
/// XZ makes the module of a release 23 % smaller than gzip does.
fn packed(module: &Path, build: Build) -> Result<PathBuf, String> {
    let failed = |error| format!("{}: {error}", module.display());
    let bytes = std::fs::read(module).map_err(failed)?;
    let mut options = XzOptions::with_preset(if build == Build::Release { 9 } else { 0 });
    // Code has no alignment, and its literals follow from the byte before.
    (options.lzma_options.lc, options.lzma_options.pb) = (4, 0);
    let mut writer = XzWriter::new(Vec::new(), options).map_err(failed)?;
    writer.write_all(&bytes).map_err(failed)?;
    let out = writer.finish().map_err(failed)?;
    println!("   module: {} kB, {} kB compressed", bytes.len() / 1000, out.len() / 1000);
    let packed = module.with_extension("wasm.xz");
    std::fs::write(&packed, out).map_err(failed)?;
    Ok(packed)
}

/// Checks the size of a release.
fn size() -> Outcome {
    let page = folder().join("polhode.html");
    let length = std::fs::metadata(&page).map_err(|error| format!("{}: {error}", page.display()))?.len();
    if length <= MOST { Ok(()) } else { Err(format!("the page has {length} bytes, more than {MOST}")) }
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
