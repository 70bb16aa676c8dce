//! Columns of a particle table, from its header.

use std::ops::Range;

use polhode::body::Finding;
use polhode_source::text::{cut, escaped};
use polhode_source::unit;
use polhode_source::unit::{Dimension, Scale};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::fields::text_of;
use super::{ParticleOptions, missing};
use crate::finding::info;

/// Names of the numbers in a line, in the order of all arrays with ten numbers.
pub(crate) const NAMES: [&str; 10] = ["mass", "x", "y", "z", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];
pub(crate) const MASS: usize = 0;
pub(crate) const TENSOR: Range<usize> = 4..10;

/// Example header of each column.
const EXAMPLES: [&str; 10] = [
    "mass_kg",
    "x_m",
    "y_m",
    "z_m",
    "Ixx_kg_m2",
    "Iyy_kg_m2",
    "Izz_kg_m2",
    "Ixy_kg_m2",
    "Ixz_kg_m2",
    "Iyz_kg_m2",
];

/// Role of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Role {
    /// Number with this index in [`NAMES`].
    Number(usize),
    /// Number of pieces of a line.
    Count,
    /// Name of a part.
    Name,
    /// Label, which is not used.
    Label,
}

/// Sign convention of the products of inertia, with the names used in scenarios.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Products {
    /// Products are −∫xy dm.
    Negative,
    /// Products are +∫xy dm.
    Positive,
}

/// Columns of a table.
pub(crate) struct Header {
    pub roles: Vec<Role>,
    pub scales: [Scale; 10],
    pub products: Option<Products>,
    pub findings: Vec<Finding>,
}

impl Header {
    pub(crate) fn has(&self, number: usize) -> bool {
        self.roles.contains(&Role::Number(number))
    }

    /// Returns true if the table has all six tensor elements; otherwise it has none.
    pub(crate) fn has_tensors(&self) -> bool {
        self.has(TENSOR.start)
    }

    /// Parses a header line.
    pub(crate) fn named(
        bytes: &[u8],
        header: &[Range<usize>],
        products: Option<Products>,
        options: &ParticleOptions,
    ) -> Result<Self, ContentError> {
        let mut columns: Vec<Column> = header.iter().map(|field| Column::of(bytes, field)).collect();
        // If a part has several names, the first one identifies it.
        let named = columns.iter().position(|column| column.role == Role::Name);
        for column in columns.iter_mut().skip(named.map_or(0, |k| k + 1)) {
            if column.role == Role::Name {
                column.role = Role::Label;
            }
        }
        let tensors = columns.iter().any(|c| matches!(c.role, Role::Number(k) if TENSOR.contains(&k)));
        let mut scales = [None; 10];
        let mut ignored = Vec::new();
        for (column, field) in columns.iter().zip(header) {
            let place = || ContentPlace::Text(field.clone());
            match column.role {
                Role::Label => {
                    if let Some(hint) = column.physics(tensors) {
                        let rule = format!("one of {}, quantity, name", NAMES.join(", "));
                        let error = super::value("the column", column.name.clone(), rule, place());
                        return Err(error.hint(hint));
                    }
                    ignored.push(cut(&escaped(&column.name)));
                }
                Role::Name | Role::Count => {}
                Role::Number(number) => {
                    let factor = column.factor(number, options, field)?;
                    if scales[number].replace(Scale::from_factor(factor)).is_some() {
                        let rule = "used once".to_owned();
                        return Err(super::value("the column", NAMES[number].to_owned(), rule, place()));
                    }
                }
            }
        }
        let lacking = |numbers: Range<usize>| numbers.into_iter().find(|k| scales[*k].is_none());
        if let Some(number) = lacking(1..4) {
            let hint = "the header must name x, y and z with their units, such as x_m,y_m,z_m";
            return Err(missing(&format!("column {}", NAMES[number]), hint));
        }
        if let Some(number) = lacking(TENSOR).filter(|_| tensors) {
            let hint = "a tensor has six columns, Ixx, Iyy, Izz, Ixy, Ixz and Iyz; products that are zero are written as 0";
            return Err(missing(&format!("column {}", NAMES[number]), hint));
        }
        let roles: Vec<Role> = columns.iter().map(|column| column.role).collect();
        if let Some(second) = (0..roles.len()).filter(|k| roles[*k] == Role::Count).nth(1) {
            let place = ContentPlace::Text(header[second].clone());
            let rule = "the only quantity column".to_owned();
            return Err(super::value("the column", columns[second].name.clone(), rule, place));
        }
        let mut findings = Vec::new();
        if !ignored.is_empty() {
            let message = format!("columns not read: {}", ignored.join(", "));
            findings.push(info("particles.ignored-columns", message));
        }
        let scales = scales.map(|scale| scale.unwrap_or(Scale::Times(1.0)));
        Ok(Self { roles, scales, products, findings })
    }

    /// Returns the header of a file without names: three columns are positions, four are masses and
    /// positions.
    pub(crate) fn nameless(
        line: &Range<usize>,
        columns: usize,
        options: &ParticleOptions,
    ) -> Result<Self, ContentError> {
        let error = |kind: ContentErrorKind| kind.at(line.clone());
        let first = match columns {
            3 => 1,
            4 => MASS,
            _ => {
                let rule = "x, y, z or mass, x, y, z in a file without a header";
                let kind = ContentErrorKind::value("the number of columns", columns.to_string(), rule);
                return Err(error(kind).hint("add a header, such as mass_kg,x_m,y_m,z_m"));
            }
        };
        let unclear = |what: &str, flag: &str| {
            let question = format!("the file has no header: in which unit is the {what}?");
            error(ContentErrorKind::unclear(question, ""))
                .hint(format!("add a header, such as mass_kg,x_m,y_m,z_m, or give the unit by {flag}"))
        };
        let length = Scale::from_factor(options.length_unit.ok_or_else(|| unclear("length", "--unit"))?);
        let mass = match (first, options.mass_unit) {
            (MASS, None) => return Err(unclear("mass", "--mass-unit")),
            (_, unit) => Scale::from_factor(unit.unwrap_or(1.0)),
        };
        let message =
            format!("the file has no header: the columns were read as {}", NAMES[first..4].join(", "));
        let mut scales = [Scale::Times(1.0); 10];
        scales[..4].copy_from_slice(&[mass, length, length, length]);
        Ok(Self {
            roles: (first..4).map(Role::Number).collect(),
            scales,
            products: None,
            findings: vec![info("particles.no-header", message)],
        })
    }
}

impl Products {
    /// Parses a declaration in a comment: `products = negative_integral`. Returns `None` for other
    /// comments.
    pub(crate) fn declared(bytes: &[u8], comment: &Range<usize>) -> Option<Result<Self, ContentError>> {
        let text = text_of(bytes, comment).to_lowercase();
        let rest = text.trim_start_matches(['#', ' ', '\t']).strip_prefix("products")?;
        let value = rest.trim_start().strip_prefix(['=', ':'])?;
        Some(match value.trim().trim_matches(['"', '\'']) {
            "negative_integral" => Ok(Self::Negative),
            "positive_integral" => Ok(Self::Positive),
            other => {
                let rule = "negative_integral (−∫xy dm) or positive_integral (+∫xy dm)".to_owned();
                Err(super::value("products", other.to_owned(), rule, ContentPlace::Text(comment.clone())))
            }
        })
    }
}

/// Column with its name and unit.
pub(crate) struct Column {
    pub role: Role,
    unit: Option<String>,
    name: String,
}

/// Words for the number of pieces; below, words for the name of a part.
const COUNTS: &str = "quantity qty count counts pcs pieces copies instances multiplicity amount times anzahl menge stück \
                      stueck stk quantité quantite nombre cantidad quantità 数量 個数 个数";
const PART_NAMES: &str = "name part component";

/// Words that indicate physical quantities, and the hint for such a column.
const PHYSICS: [(&str, &str); 5] = [
    (
        "mass masse masa massa weight gewicht peso poids density dichte rho volume volumen kg 质量 質量 重量 密度",
        "polhode needs the mass of each line: name its column mass with its unit, such as mass_kg, and delete this column",
    ),
    (
        "inertia moment moments trägheit inertie inercia inerzia tensor gyration i j ixx iyy izz ixy ixz iyz iyx izx izy i1 \
         i2 i3 jxx jyy jzz kxx kyy kzz lxx lyy lzz 惯性 惯量 慣性",
        "a tensor has six columns, Ixx, Iyy, Izz, Ixy, Ixz and Iyz, about the part's own centre of mass",
    ),
    (
        "radius radii diameter com cog cg centroid",
        "a line is a point, or a part with its tensor, at x, y, z: delete this column if this is right",
    ),
    (
        "unit units einheit factor multiplier scale",
        "units belong in the header, such as mass_g,x_mm,y_mm,z_mm: convert the values, and delete this column",
    ),
    (
        "frame time timestep csys",
        "a table is one body, in one frame and at one time: split the table, and delete this column",
    ),
];
/// Words for the attitude of a part, which is relevant for a tensor but not for a point.
const TURNS: &str = "roll pitch yaw rx ry rz qw qx qy qz rotation orientation rpy euler";

impl Column {
    /// Parses `x_mm`, `x [mm]`, `x (mm)` or `x`. Other columns are unused.
    pub(crate) fn of(bytes: &[u8], field: &Range<usize>) -> Self {
        let whole = text_of(bytes, field);
        let name = whole.trim_matches('"').trim();
        // I_xx is a spelling of Ixx.
        let joined = match name.strip_prefix(['I', 'i']).and_then(|rest| rest.strip_prefix('_')) {
            Some(rest) if axes(rest.get(..2).unwrap_or("")) => format!("I{rest}"),
            _ => name.to_owned(),
        };
        let (base, unit) = match joined.split_once(['[', '(']) {
            Some((base, unit)) => (base, Some(unit.trim_end_matches([']', ')']))),
            None => {
                joined.split_once(['_', ' ']).map_or((joined.as_str(), None), |(b, unit)| (b, Some(unit)))
            }
        };
        let base = base.trim().trim_end_matches('_').to_lowercase();
        let role = match base.as_str() {
            "m" => Role::Number(MASS),
            _ => match NAMES.iter().position(|known| known.eq_ignore_ascii_case(&base)) {
                Some(number) => Role::Number(number),
                None if has_word(COUNTS, &base) => Role::Count,
                None if has_word(PART_NAMES, &base) => Role::Name,
                None => Role::Label,
            },
        };
        let unit = unit.map(|unit| unit.trim().to_owned()).filter(|unit| !unit.is_empty());
        let column = Self { role, unit, name: name.to_owned() };
        // A column such as `part_mass_g` is not a name.
        if role == Role::Name && column.physics(false).is_some() {
            return Self { role: Role::Label, ..column };
        }
        column
    }

    /// Returns the value of the column's unit in SI.
    fn factor(
        &self,
        number: usize,
        options: &ParticleOptions,
        field: &Range<usize>,
    ) -> Result<f64, ContentError> {
        let error = |kind: ContentErrorKind| kind.at(field.clone());
        let (dimension, told, flags) = match number {
            MASS => (Dimension::MASS, options.mass_unit, "--mass-unit"),
            1..4 => (Dimension::LENGTH, options.length_unit, "--unit"),
            _ => {
                let told =
                    options.mass_unit.zip(options.length_unit).map(|(mass, length)| mass * length * length);
                (Dimension::INERTIA, told, "--mass-unit and --unit")
            }
        };
        let Some(unit) = &self.unit else {
            return told.ok_or_else(|| {
                let question = format!("in which unit is {}?", NAMES[number]);
                let hint = EXAMPLES[number];
                error(ContentErrorKind::unclear(question, ""))
                    .hint(format!("name the unit in the header, such as {hint}, or give the unit by {flags}"))
            });
        };
        let spelt = if dimension == Dimension::INERTIA { spelt_out(unit) } else { unit.clone() };
        unit::factor(&spelt, dimension).map_err(|wrong| {
            let what = format!("the unit of {}", NAMES[number]);
            let rule = format!("a known unit: {wrong}");
            let hinted = error(ContentErrorKind::value(what, unit.clone(), rule));
            match wrong.hint_for_name() {
                Some(hint) => hinted.hint(hint),
                None => hinted,
            }
        })
    }

    /// Returns the hint for an unused column that would change the body; `None` for a harmless one.
    fn physics(&self, tensors: bool) -> Option<&'static str> {
        let lower = self.name.to_lowercase();
        let words: Vec<&str> =
            lower.split(|c: char| !c.is_alphanumeric()).filter(|w| !w.is_empty()).collect();
        // Spellings such as `I xx` and `I(x,x)`.
        let joined: String = words.concat();
        let says = |list: &str| words.iter().any(|word| has_word(list, word)) || has_word(list, &joined);
        // Spellings such as `massKg` and `MomentOfInertia`.
        let within = |long: &str| lower.contains(long);
        if within("inertia") || within("momentof") {
            return Some(PHYSICS[1].1);
        }
        if within("mass") || within("density") || within("weight") {
            return Some(PHYSICS[0].1);
        }
        let known = PHYSICS.iter().find(|(list, _)| says(list)).map(|(_, hint)| *hint);
        let turned = (tensors && says(TURNS)).then_some(
            "the tensor of each part is along the axes of the table: rotate it accordingly, and delete this column",
        );
        known.or(turned)
    }
}

/// Returns true for two axis letters.
fn axes(text: &str) -> bool {
    text.len() == 2 && text.bytes().all(|b| b"xyzXYZ".contains(&b))
}

fn has_word(list: &str, word: &str) -> bool {
    list.split_whitespace().any(|known| known == word)
}

/// Spells out a unit: `kg_m2` and `kg.mm2` as `kg m^2` and `kg mm^2`.
fn spelt_out(unit: &str) -> String {
    let names = unit.split(['_', '.', ' ', '*']).filter(|name| !name.is_empty());
    let powered = names.map(|name| match name.strip_suffix('2') {
        Some(base) if base.ends_with(char::is_alphabetic) => format!("{base}^2"),
        _ => name.to_owned(),
    });
    powered.collect::<Vec<_>>().join(" ")
}
