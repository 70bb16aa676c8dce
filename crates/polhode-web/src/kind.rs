//! Kind of a file, by its name and if necessary by its first bytes.

use std::path::Path;

use polhode_robot::read::format_of;
use polhode_shape::mesh::MeshFormat;

/// Kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Scenario,
    Mesh,
    Molecule,
    Particles,
    Robot,
}

impl Kind {
    /// Returns the kind of a file with these contents; `None` if the page cannot show it.
    pub(crate) fn of(path: &Path, bytes: &[u8]) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        let text = || std::str::from_utf8(bytes).ok();
        match ending.as_str() {
            "toml" => Some(Self::Scenario),
            "xyz" | "mol" | "pdb" | "ent" => Some(Self::Molecule),
            // Two formats have this extension; that of robots is XML.
            "sdf" if !bytes.trim_ascii_start().starts_with(b"<") => Some(Self::Molecule),
            "csv" => Some(Self::Particles),
            "urdf" => Some(Self::Robot),
            "sdf" | "world" | "xml" | "mjcf" | "usda" | "osim" => {
                text().and_then(format_of).map(|_| Self::Robot)
            }
            _ => MeshFormat::of_path(path).map(|_| Self::Mesh),
        }
    }
}
