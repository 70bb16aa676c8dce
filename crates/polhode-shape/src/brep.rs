//! STEP and IGES files, which contain exact geometry. They are recognized and refused, with the
//! commands that convert them to a mesh.

use std::io::Read as _;
use std::path::Path;

use polhode_source::files::Files;

/// Format of exact geometry (boundary representation).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BrepFormat {
    /// STEP (ISO 10303-21).
    Step,
    /// IGES (Initial Graphics Exchange Specification).
    Iges,
}

/// Number of bytes needed for recognition.
const HEAD: u64 = 96;

impl BrepFormat {
    /// Returns the format of a file by its first bytes. If these are unreadable or inconclusive,
    /// the extension decides.
    pub fn of(files: &dyn Files, path: &Path) -> Option<Self> {
        Self::of_content(files, path).or_else(|| Self::of_path(path))
    }

    /// Returns the format of a file by its first bytes only.
    pub fn of_content(files: &dyn Files, path: &Path) -> Option<Self> {
        let mut head = Vec::new();
        // Bytes read from a pipe would be lost.
        if files.is_file(path) {
            files.open(path).ok()?.take(HEAD).read_to_end(&mut head).ok()?;
        }
        Self::of_bytes(&head)
    }

    /// Returns the format of files with this extension, in any case.
    pub fn of_path(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "step" | "stp" | "p21" => Some(Self::Step),
            "iges" | "igs" => Some(Self::Iges),
            _ => None,
        }
    }

    /// Returns the format of a file that begins with these bytes.
    ///
    /// ```
    /// use polhode_shape::brep::BrepFormat;
    /// assert_eq!(BrepFormat::of_bytes(b"ISO-10303-21;\nHEADER;"), Some(BrepFormat::Step));
    /// assert_eq!(BrepFormat::of_bytes(b"solid ISO-10303-21"), None);
    /// ```
    pub fn of_bytes(bytes: &[u8]) -> Option<Self> {
        // A line of IGES ends with its section and its number in that section: S      1.
        let is_iges = |line: &[u8]| {
            let (number, section) = (line.get(73..80)?, line.get(72)?);
            Some(*section == b'S' && matches!(number.trim_ascii(), b"1" | b"0000001"))
        };
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        if bytes.trim_ascii_start().starts_with(b"ISO-10303-21") {
            return Some(Self::Step);
        }
        is_iges(bytes).unwrap_or(false).then_some(Self::Iges)
    }

    /// Returns the official name of the format.
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

    /// Returns the reason why a file of this format is not read.
    pub fn refusal(self) -> String {
        let article = if matches!(self, Self::Iges) { "an" } else { "a" };
        format!("polhode reads meshes, but {article} {} file contains exact shapes", self.title())
    }

    /// Returns a hint: the commands that convert the file to a mesh, which is in millimetres
    /// whatever the file's unit, and the command that measures it.
    pub fn hint(self, path: &Path) -> String {
        let mesh = shell_word(&path.with_extension("stl"));
        // The programs recognize files by their extension.
        let (renamed, file) = match Self::of_path(path) {
            Some(_) => (String::new(), shell_word(path)),
            None => {
                let file = shell_word(&path.with_extension(self.ending()));
                (format!("rename it to {file}, "), file)
            }
        };
        let made = format!("{renamed}convert it to a mesh in mm: gmsh {file} -2 -o {mesh}");
        match self {
            Self::Step => {
                let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
                let kind = if ending == "step" || ending == "stp" { "" } else { " with kind=\"step\"" };
                format!(
                    "{made}, or python -c \"import sys, cadquery as cq; cq.exporters.export(cq.importers.importStep(sys.argv[1]), sys.argv[2])\" \
                     {file} {mesh}; or measure it exactly with polhode.inertia in Python{kind}, after pip install cadquery-ocp"
                )
            }
            Self::Iges => format!("{made}, and read the result with --unit mm"),
        }
    }
}

/// Quotes a path as a word of a shell command.
fn shell_word(path: &Path) -> String {
    let name = path.to_string_lossy();
    let is_plain = |c: char| c.is_alphanumeric() || "/._-+,:@%".contains(c);
    // A leading dash would be read as an option.
    let name = if name.starts_with('-') { format!("./{name}").into() } else { name };
    if name.chars().all(is_plain) { name.into_owned() } else { format!("'{}'", name.replace('\'', r"'\''")) }
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
        assert_eq!(BrepFormat::of_bytes("\u{feff}ISO-10303-21;".as_bytes()), Some(BrepFormat::Step));
        assert_eq!(BrepFormat::of_bytes(b"solid"), None);
    }

    #[test]
    fn commands_are_for_a_shell_and_this_file() {
        let hint = |format: BrepFormat, path: &str| format.hint(Path::new(path));
        let says = hint(BrepFormat::Step, "arms/it's left.step");
        assert!(says.contains(r"gmsh 'arms/it'\''s left.step' -2 -o 'arms/it'\''s left.stl', or"), "{says}");
        assert!(
            says.contains(r#"sys.argv[2])" 'arms/it'\''s left.step' 'arms/it'\''s left.stl'; or"#),
            "{says}"
        );
        assert!(!says.contains("kind="), "{says}");
        let says = hint(BrepFormat::Step, "-a.dat");
        assert!(says.contains("rename it to ./-a.step, convert") && says.contains("kind=\"step\""), "{says}");
        assert!(hint(BrepFormat::Step, "a.P21").contains("gmsh a.P21 -2 -o a.stl"));
        assert!(hint(BrepFormat::Step, "a.P21").contains("kind=\"step\""));
        assert!(hint(BrepFormat::Iges, "ä/b.igs").contains("gmsh ä/b.igs -2 -o ä/b.stl"));
        assert_eq!(
            BrepFormat::Iges.refusal(),
            "polhode reads meshes, but an IGES file contains exact shapes"
        );
    }
}
