//! Files of exact shapes, STEP and IGES, which are not read: what they are, and what makes a mesh of them.

use std::fs::{self, File};
use std::io::{self, Read as _};
use std::path::Path;

/// A format of exact shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BrepFormat {
    /// STEP, ISO 10303-21.
    Step,
    /// IGES.
    Iges,
}

/// The bytes that tell.
const HEAD: u64 = 96;

impl BrepFormat {
    /// What a file is, by its first bytes, or by its name if it cannot be read or says nothing.
    pub fn of(path: &Path) -> Option<Self> {
        // What is taken from a pipe is gone.
        let head = || -> io::Result<Vec<u8>> {
            let mut head = Vec::new();
            if fs::metadata(path)?.is_file() {
                File::open(path)?.take(HEAD).read_to_end(&mut head)?;
            }
            Ok(head)
        };
        head().ok().and_then(|head| Self::of_bytes(&head)).or_else(|| Self::of_path(path))
    }

    /// The format of files with this extension, in any case.
    pub fn of_path(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "step" | "stp" | "p21" => Some(Self::Step),
            "iges" | "igs" => Some(Self::Iges),
            _ => None,
        }
    }

    /// The format of a file that begins so.
    ///
    /// ```
    /// use polhode_formats::brep::BrepFormat;
    /// assert_eq!(BrepFormat::of_bytes(b"ISO-10303-21;\nHEADER;"), Some(BrepFormat::Step));
    /// assert_eq!(BrepFormat::of_bytes(b"solid ISO-10303-21"), None);
    /// ```
    pub fn of_bytes(bytes: &[u8]) -> Option<Self> {
        // A line of IGES ends in its section and its number there: S      1.
        let is_iges = |line: &[u8]| {
            let (number, section) = (line.get(73..80)?, line.get(72)?);
            Some(*section == b'S' && matches!(number.trim_ascii(), b"1" | b"0000001"))
        };
        if bytes.trim_ascii_start().starts_with(b"ISO-10303-21") {
            return Some(Self::Step);
        }
        is_iges(bytes).unwrap_or(false).then_some(Self::Iges)
    }

    /// Its name as its makers write it.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Step => "STEP",
            Self::Iges => "IGES",
        }
    }

    const fn ending(self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::Iges => "igs",
        }
    }

    /// Why a file of this format is not read.
    pub fn refusal(self) -> String {
        format!("polhode reads meshes, and a {} file has exact shapes", self.title())
    }

    /// The commands that make a mesh of it, which is in millimetres whatever the file's unit is; and how it is measured as it is.
    pub fn hint(self, path: &Path) -> String {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let (own, ending) = (path.file_name().unwrap_or_default().to_string_lossy(), self.ending());
        // The programs go by the name.
        let (renamed, file) = match Self::of_path(path) {
            Some(_) => (String::new(), own.into_owned()),
            None => (format!("call it {stem}.{ending}, and "), format!("{stem}.{ending}")),
        };
        let mesh = format!("{renamed}make a mesh of it, in mm: gmsh {file} -2 -o {stem}.stl");
        match self {
            Self::Step => format!(
                "{mesh}, or python -c \"import cadquery as cq; cq.exporters.export(cq.importers.importStep('{file}'), '{stem}.stl')\"; \
                 or have it measured exactly, by polhode.inertia in Python, after pip install cadquery-ocp"
            ),
            Self::Iges => format!("{mesh}, and read that with --unit mm"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_exact_shapes_are_known_by_name_and_by_their_first_bytes() {
        for (name, format) in [
            ("a.step", Some(BrepFormat::Step)),
            ("a.STP", Some(BrepFormat::Step)),
            ("a.igs", Some(BrepFormat::Iges)),
            ("a.stl", None),
            ("step", None),
        ] {
            assert_eq!(BrepFormat::of_path(Path::new(name)), format, "{name}");
        }
        let line = |text: &str, section: &str| format!("{text:<72}{section}{:>7}\n", 1);
        assert_eq!(BrepFormat::of_bytes(line("a part", "S").as_bytes()), Some(BrepFormat::Iges));
        assert_eq!(BrepFormat::of_bytes(line("a part", "G").as_bytes()), None);
        assert_eq!(BrepFormat::of_bytes(b"\n ISO-10303-21;"), Some(BrepFormat::Step));
        assert_eq!(BrepFormat::of_bytes(b"solid"), None);
    }
}
