//! Assumptions made by the reader.

use polhode_source::text::counted;

use super::ReadParts;
use super::cells::Reader;
use super::heading::Columns;
use super::plan::Plan;
use super::plan::table_file::TableOrigin;
use super::sheet::Sheet;

/// Assumptions made while rows were read.
#[derive(Debug, Default)]
pub(crate) struct Taken {
    /// Parts with mass only, taken as points.
    pub points: usize,
    /// Tensors without columns of products.
    pub without_products: usize,
    /// Tensors without errors of their own, of masses with errors.
    pub following: usize,
    /// Rows of several copies that do not state the correlation of their errors.
    pub alike_copies: usize,
    /// Tensors that make a possible body only if the products are tensor elements.
    pub proved_elements: usize,
    /// Tensors that make a possible body only if the products are positive integrals.
    pub proved_integrals: usize,
    /// Findings in files that were read.
    pub findings: Vec<String>,
}

impl Taken {
    /// Returns the assumptions, one sentence each.
    pub(crate) fn lines(self) -> impl Iterator<Item = String> {
        let line = |count: usize, noun: &str, rest: &str| {
            (count > 0).then(|| format!("{} {rest}", counted(count, noun)))
        };
        [
            line(self.points, "part", "without tensor or shape: all mass at one point"),
            line(self.without_products, "tensor", "without products of inertia: zero"),
            line(
                self.proved_elements,
                "tensor",
                "with products taken as tensor elements, −∫xy dm: the other sign is unphysical",
            ),
            line(
                self.proved_integrals,
                "tensor",
                "with products taken as positive integrals, +∫xy dm: the other sign is unphysical",
            ),
            line(self.following, "tensor", "without a stated error: in proportion to the mass"),
            line(self.alike_copies, "row", "with several copies, which share the same error"),
        ]
        .into_iter()
        .flatten()
        .chain(self.findings)
    }
}

/// Returns the files that were read: the list, and the tables of tanks.
pub(crate) fn files(sheet: &Sheet<'_>, plan: &Plan, mut lines: Vec<String>) -> Vec<ReadParts> {
    let mut files = Vec::new();
    for table in plan.tanks.iter().filter_map(|tank| tank.table.clone()) {
        match table.from {
            TableOrigin::Sheet(_) => lines.extend(table.lines),
            TableOrigin::File(path) => files.push(ReadParts { path, lines: table.lines }),
        }
    }
    files.insert(0, ReadParts { path: sheet.path().to_owned(), lines });
    files
}

/// Returns the assumptions about a table as a whole, one sentence each.
pub(crate) fn of_sheet(
    sheet: &Sheet<'_>,
    columns: &Columns,
    plan: &Plan,
    reader: &Reader<'_, '_>,
) -> Vec<String> {
    let mut lines = Vec::new();
    if let Some(row) = sheet.rows.get(columns.row).filter(|_| columns.row > 0) {
        lines.push(format!("rows above the headings in row {} were ignored", row.number));
    }
    if !columns.ignored.is_empty() {
        let headings: Vec<&str> = columns.ignored.values().map(String::as_str).collect();
        lines.push(format!("ignored columns: {}", headings.join(", ")));
    }
    let hidden: Vec<String> =
        sheet.rows.iter().filter(|row| row.is_hidden).map(|row| row.number.to_string()).collect();
    if !hidden.is_empty() {
        lines.push(format!("hidden rows that were read: {}", hidden.join(", ")));
    }
    if sheet.decimal_comma && plan.decimal_comma.is_none() {
        lines.push("numbers have a decimal comma, inferred from their digits".to_owned());
    }
    let bare = reader.bare();
    if !bare.is_empty() {
        lines.push(format!("no unit given, SI assumed (kg, m, rad): {}", bare.join(", ")));
    }
    if reader.plus_minus || plan.tanks.iter().any(|tank| tank.has_mark) {
        lines.push(match plan.coverage_factor {
            None => "± is one standard deviation: no coverage_factor is given".to_owned(),
            Some(k) => format!("± is {k} standard deviations (coverage_factor)"),
        });
    }
    lines
}
