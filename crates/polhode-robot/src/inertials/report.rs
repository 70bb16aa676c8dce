//! Report of new inertials as text, diff and JSON.

use std::fmt::Write as _;

use polhode_document::layout::{plain_spaces, printable};
use polhode_document::number::number;
use polhode_document::{Document, Report};
use polhode_source::text::counted;
use serde_json::{Map, Value, json};

use super::choice::name;
use super::outcome::{Inertials, LinkOutcome, Outcome, Written};

impl Inertials {
    /// Returns the diff from the model to the new text, for `patch -p1` and `git apply`. `file` is
    /// the name of the model in it.
    pub fn to_diff(&self, file: &str) -> String {
        self.edited.diff(&self.model, &[], file)
    }

    /// Returns one line for the model and one for each link.
    pub fn lines(&self) -> Vec<String> {
        let ([new, unchanged], all) = (self.counts(), self.links.len());
        let path = printable(&self.model.path.to_string_lossy());
        let to = match &self.out {
            Some(out) => format!(", in {}", printable(&out.to_string_lossy())),
            None => String::new(),
        };
        let right = if unchanged > 0 { format!("; {unchanged} unchanged") } else { String::new() };
        let first =
            format!("{path}: {} for {}{right}{to}", counted(new, "new inertial"), counted(all, "link"));
        let links = self.links.iter().map(|link| format!("{path}:{}: {}", link.line, link.in_words()));
        [first].into_iter().chain(links).map(|line| plain_spaces(&line)).collect()
    }
}

impl LinkOutcome {
    fn in_words(&self) -> String {
        let link = printable(&self.link);
        match &self.outcome {
            Outcome::Written(written) => {
                let Written { properties, volume, role, reason, mass_by, error, is_unchanged } = &**written;
                let mut text = format!(
                    "{link}: {}{} kg ({mass_by}), {} m³ of {}: {reason}",
                    if *is_unchanged { "unchanged: " } else { "" },
                    number(properties.mass(), 6),
                    number(*volume, 6),
                    name(*role),
                );
                if *error > 1e-12 {
                    let _ = write!(text, "; error {} of the tensor", number(*error, 2));
                }
                text
            }
            Outcome::NoGeometry { .. } => format!("{link}: not written: no geometry"),
            Outcome::NotWritten { why, had_inertial } => {
                let kept = if *had_inertial { "; its inertial stays as it was" } else { "" };
                format!("{link}: not written: {}{kept}", printable(why))
            }
        }
    }

    fn to_json(&self) -> Value {
        let mut object = Map::new();
        object.insert("link".to_owned(), self.link.as_str().into());
        object.insert("line".to_owned(), self.line.into());
        let (is_written, why) = match &self.outcome {
            Outcome::Written(_) => (true, None),
            Outcome::NoGeometry { .. } => (false, Some("no geometry")),
            Outcome::NotWritten { why, .. } => (false, Some(why.as_str())),
        };
        object.insert("written".to_owned(), is_written.into());
        object.insert("why_not".to_owned(), why.into());
        if let Outcome::Written(written) = &self.outcome {
            let Written { properties, volume, role, reason, mass_by, error, is_unchanged } = &**written;
            let Value::Object(own) = json!({
                "mass_kg": properties.mass(),
                "center_of_mass_m": properties.center_of_mass().to_array(),
                "tensor_kg_m2": properties.inertia().matrix(),
                "volume_m3": volume,
                "geometry": name(*role),
                "reason": reason,
                "mass_by": mass_by,
                "relative_error": error,
                "unchanged": is_unchanged,
            }) else {
                return Value::Object(object);
            };
            object.extend(own);
        }
        Value::Object(object)
    }
}

impl Report for Inertials {
    /// Returns an object with the links, the diff and the output file.
    fn to_json(&self) -> Value {
        let path = self.model.path.to_string_lossy();
        json!({
            "polhode": polhode_document::VERSION,
            "file": path,
            "out": self.out.as_ref().map(|out| out.to_string_lossy()),
            "links": self.links.iter().map(LinkOutcome::to_json).collect::<Vec<_>>(),
            "diff": self.to_diff(&path),
        })
    }

    fn to_document(&self) -> Document {
        Document::of_text("Inertials from geometry", &self.to_text(None))
    }

    fn to_text(&self, _columns: Option<usize>) -> String {
        self.lines().into_iter().map(|line| line + "\n").collect()
    }

    fn has_failed(&self) -> bool {
        self.is_incomplete()
    }
}
