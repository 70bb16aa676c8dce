//! Kind of a file, by its name and if necessary by its contents.

use std::path::Path;

use polhode_robot::read::format_of;
use polhode_shape::mesh::MeshFormat;

use crate::table::TableKind;

/// Kind of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Scenario,
    Mesh,
    Molecule,
    Particles,
    Robot,
    /// Table or plan of one of these kinds; if there are several, the reader chooses.
    Table(Vec<TableKind>),
}

impl Kind {
    /// Returns the kind of a file with these contents; `None` if the page cannot show it.
    pub(crate) fn of(path: &Path, bytes: &[u8]) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        let text = || std::str::from_utf8(bytes).ok();
        match ending.as_str() {
            "toml" => {
                Some(TableKind::of_plan(&String::from_utf8_lossy(bytes)).map_or(Self::Scenario, Self::only))
            }
            "xyz" | "mol" | "pdb" | "ent" => Some(Self::Molecule),
            // Two formats have this extension; that of robots is XML.
            "sdf" if !bytes.trim_ascii_start().starts_with(b"<") => Some(Self::Molecule),
            "csv" | "tsv" | "txt" | "dat" | "json" | "jsonl" | "ndjson" => Self::of_table(&ending, bytes),
            "xlsx" | "xls" => Some(Self::only(TableKind::Budget)),
            // The reader says why it does not read USD.
            "urdf" | "usd" | "usda" | "usdc" | "usdz" => Some(Self::Robot),
            "sdf" | "world" | "xml" | "mjcf" | "osim" => text().and_then(format_of).map(|_| Self::Robot),
            _ => MeshFormat::of_path(path).map(|_| Self::Mesh),
        }
    }

    fn only(kind: TableKind) -> Self {
        Self::Table(vec![kind])
    }

    /// Returns the kinds that the headings of a table allow. A CSV that has none of them may be any
    /// damaged table.
    fn of_table(ending: &str, bytes: &[u8]) -> Option<Self> {
        let may_be = |kind: &TableKind| *kind != TableKind::Particles || ending == "csv";
        let kinds: Vec<_> = TableKind::of_headings(bytes).into_iter().filter(may_be).collect();
        match &kinds[..] {
            [TableKind::Particles] => Some(Self::Particles),
            [] if ending == "csv" => Some(Self::Table(TableKind::ALL.to_vec())),
            [] => None,
            _ => Some(Self::Table(kinds)),
        }
    }
}
