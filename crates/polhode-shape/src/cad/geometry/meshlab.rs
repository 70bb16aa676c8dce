//! Reader for the log of MeshLab's filter "Compute Geometric Measures".

use std::ops::Range;

use polhode_source::ContentError;

use super::{Measures, Number, Once, bad, exactly};

const HINT: &str = "paste MeshLab's log from \"Mesh Volume is\" to the last row of \"Inertia Tensor is\": Filters, Quality Measure and \
                    Computations, Compute Geometric Measures";

/// Returns true if a text is such a log.
pub(crate) fn is_of(text: &str) -> bool {
    text.lines().any(|line| {
        let line = words(line);
        line.starts_with("mesh volume is") || line.starts_with("inertia tensor is")
    }) || text.contains("Mesh is not 'watertight'")
}

/// Returns a line in lower case with single spaces, without the prefix of a log.
fn words(line: &str) -> String {
    let line = content(line);
    line.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase()
}

/// Returns a line without the prefix `LOG: 2` of the command and without comment marks.
fn content(line: &str) -> &str {
    let line = line.trim_start_matches(|c: char| c.is_whitespace() || "#%/*>;\u{feff}".contains(c));
    let Some(logged) = line.strip_prefix("LOG:") else { return line };
    logged.trim_start().trim_start_matches(|c: char| c.is_ascii_digit()).trim_start()
}

/// Meaning of the rows after a heading.
enum Rows {
    None,
    Tensor(Vec<[Number; 3]>),
    /// Principal axes; redundant, since the tensor is known.
    Axes,
    Moments,
}

pub(crate) fn read(text: &str) -> Result<Measures, ContentError> {
    let (mut volume, mut area, mut center) = (Once::default(), Once::default(), Once::default());
    let (mut tensor, mut moments) = (Once::default(), Once::default());
    let (mut rows, mut start) = (Rows::None, 0);
    for line in text.split_inclusive('\n') {
        let inner = content(line);
        let place = start + (line.len() - inner.len())..start + line.len();
        start += line.len();
        let lower = words(line);
        if lower.starts_with("mesh is not 'watertight'") {
            let rule = "closed: MeshLab computes no volume and no tensor of an open mesh".to_owned();
            let error = bad("the mesh", "not 'watertight'".to_owned(), rule, place);
            return Err(error.hint(
                "polhode inertia MESH lists its open edges; --fill closes holes, --hull uses the convex hull",
            ));
        }
        if inner.starts_with('|') {
            rows = row(text, place, rows, &mut tensor, &mut moments)?;
            continue;
        }
        rows = Rows::None;
        let after = |label: &str| behind(text, &place, label);
        if lower.starts_with("mesh volume is") {
            let [number] = exactly("the volume", text, after("is"), &[])?;
            volume.put("the volume", number, place)?;
        } else if lower.starts_with("mesh surface area is") || lower.starts_with("mesh surface is") {
            let [number] = exactly("the surface area", text, after("is"), &[])?;
            area.put("the surface area", number, place)?;
        } else if lower.starts_with("center of mass is") {
            center.put(
                "the centre of mass",
                exactly("the centre of mass", text, after("is"), &[])?,
                place,
            )?;
        } else if lower.starts_with("inertia tensor is") {
            rows = Rows::Tensor(Vec::new());
        } else if lower.starts_with("principal axes are") {
            rows = Rows::Axes;
        } else if lower.starts_with("axis momenta are") {
            rows = Rows::Moments;
        }
    }
    Ok(Measures {
        volume: volume.require("volume", HINT)?,
        surface_area: area.0,
        center: center.require("centre of mass", HINT)?,
        tensor: tensor.require("inertia tensor", HINT)?,
        moments: moments.0,
        unit: None,
    })
}

/// Reads one row `| a b c |`; returns the meaning of the next row.
fn row(
    text: &str,
    place: Range<usize>,
    rows: Rows,
    tensor: &mut Once<[Number; 9]>,
    moments: &mut Once<[Number; 3]>,
) -> Result<Rows, ContentError> {
    let numbers = |what: &str| exactly::<3>(what, text, place.clone(), &['|']);
    Ok(match rows {
        Rows::Tensor(mut found) => {
            found.push(numbers("a row of the inertia tensor")?);
            match <[[Number; 3]; 3]>::try_from(found) {
                Ok([[a, b, c], [d, e, f], [g, h, i]]) => {
                    tensor.put("the inertia tensor", [a, b, c, d, e, f, g, h, i], place)?;
                    Rows::None
                }
                Err(fewer) => Rows::Tensor(fewer),
            }
        }
        Rows::Moments => {
            moments.put("the principal moments", numbers("the principal moments")?, place)?;
            Rows::None
        }
        other => other,
    })
}

/// Returns the part of a line after a label.
fn behind(text: &str, place: &Range<usize>, word: &str) -> Range<usize> {
    let spaced = format!(" {word} ");
    let at = text[place.clone()].find(&spaced).map_or(0, |at| at + spaced.len());
    place.start + at..place.end
}
