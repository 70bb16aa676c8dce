//! Interface of `robot.rs` in a build without robot models: no flags, and an error for a model.

use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_shape::Request;
use polhode_shape::report::InertiaReport;

use polhode_source::Failure;
use polhode_source::files::{Disk, Overlay};

use super::output::OutputFlags;
use crate::failure::Failure as CommandFailure;

/// Lines for the examples in the help; none in this build.
pub(super) const EXAMPLES: &str = "";

/// Options that write files.
pub(super) const OUTPUTS: [&str; 1] = ["write_mesh"];

/// Flags for robot models: none.
#[derive(Debug, Args)]
pub(super) struct RobotFlags {}

impl RobotFlags {
    /// Returns the first flag that is given; none in this build.
    pub(super) const fn given(&self) -> Option<&'static str> {
        None
    }
}

/// Returns the files of this machine.
#[expect(clippy::unnecessary_wraps, reason = "the expansion of xacro files may fail")]
pub(super) fn expanded(_: &[PathBuf], _: &RobotFlags) -> Result<Overlay<'static>, CommandFailure> {
    Ok(Overlay::new(&Disk))
}

/// Returns true for the file extensions of robot models. Files `.sdf` and `.xml` must also begin
/// with `<`, because SDF is also a format of molecules.
pub(super) fn is_model(path: &Path, _: &Overlay<'_>) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    match extension.as_deref() {
        Some("urdf" | "usd" | "usda" | "usdc" | "usdz" | "osim" | "world" | "mjcf") => true,
        Some("sdf" | "xml") => path.is_file() && first_character(path) == Some(b'<'),
        _ => false,
    }
}

/// Returns the first byte that is neither white space nor part of a byte-order mark.
fn first_character(path: &Path) -> Option<u8> {
    const LONGEST: u64 = 4096;
    let mut start = Vec::new();
    File::open(path).ok()?.take(LONGEST).read_to_end(&mut start).ok()?;
    start.into_iter().find(|byte| byte.is_ascii() && *byte != 0 && !byte.is_ascii_whitespace())
}

/// Returns an error for a robot model.
pub(super) fn reports(_: &Path, _: &RobotFlags, _: &Overlay<'_>) -> Result<Vec<InertiaReport>, Failure> {
    let hint = "install polhode with its default features, or build it with --features robot";
    Err(Failure::usage("this program was built without robot models", hint))
}

/// Writes no inertials, because `--write-inertials` is a flag of robot models.
pub(super) const fn write_inertials(
    _: &Request,
    _: &RobotFlags,
    _: &OutputFlags,
    _: bool,
    _: &Overlay<'_>,
) -> Option<Result<(), CommandFailure>> {
    None
}

/// Prints no table of links, because `--table` is a flag of robot models.
pub(super) fn tables(
    _: &[PathBuf],
    _: &RobotFlags,
    _: &OutputFlags,
    _: &Overlay<'_>,
    _: impl Fn(&Path) -> Result<(), Failure>,
) -> Option<Result<(), CommandFailure>> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_robot_model_is_refused_with_the_feature_that_is_missing() {
        let files = Overlay::new(&Disk);
        assert!(is_model(Path::new("arm.URDF"), &files));
        assert!(!is_model(Path::new("water.sdf"), &files));
        let Err(refusal) = reports(Path::new("arm.urdf"), &RobotFlags {}, &files) else { unreachable!() };
        assert_eq!(refusal.message(), "this program was built without robot models");
    }
}
