//! Assignment of the printed numbers: headings announce the following quantity, and labels name
//! each number.
//!
//! The method does not depend on the program. `Lxx = 1.2`, `Ixx 1.2` below a heading, and `Ixx Ixy
//! Ixz  1.2 0.1 0.3` are all labels that wait for numbers, in order. A heading determines if a
//! tensor is about the centre of mass or the origin.

use std::collections::VecDeque;
use std::ops::Range;

use polhode_source::unit::Dimension;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::{CadProduct, ProductConvention, numbers, units};

/// Position of a number in the report, and its own unit if it has one.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub span: Range<usize>,
    pub unit: Option<String>,
}

/// Numbers under one heading, and the unit in that heading.
#[derive(Clone, Debug)]
pub(crate) struct Group<const N: usize> {
    pub numbers: [Option<Found>; N],
    pub unit: Option<String>,
}

impl<const N: usize> Group<N> {
    const EMPTY: Self = Self { numbers: [const { None }; N], unit: None };

    /// Returns true if there is any number.
    pub(crate) fn is_some(&self) -> bool {
        self.numbers.iter().any(Option::is_some)
    }
}

/// Contents of a report as written.
#[derive(Clone, Debug)]
pub(crate) struct Scan {
    pub product: CadProduct,
    /// Sign convention stated in the report.
    pub stated: Option<ProductConvention>,
    /// Mass, volume, surface area, density.
    pub scalars: [Group<1>; 4],
    pub center: Group<3>,
    /// True if a heading announces the centre of mass, with or without readable numbers.
    pub names_center: bool,
    /// Tensors about the centre of mass and about the origin, row by row.
    pub tensors: [Group<9>; 2],
    pub moments: Group<3>,
    /// Principal axes, one after the other.
    pub axes: Group<9>,
}

/// Scalars in the order of [`Scan::scalars`]: labels, name, dimension.
pub(crate) const SCALARS: [(&[&str], &str, Dimension); 4] = [
    (&["mass"], "the mass", Dimension::MASS),
    (&["volume"], "the volume", Dimension::VOLUME),
    (&["surface area", "area"], "the surface area", Dimension::new(0, 2, 0, 0)),
    (&["density"], "the density", Dimension::DENSITY),
];

pub(crate) const CENTRAL: usize = 0;
pub(crate) const ORIGIN: usize = 1;

/// Section of a report: the meaning of the labels below a heading.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Section {
    /// Unused content: bounding boxes, radii of gyration, rotations.
    Other,
    Center,
    /// Tensor, with its reference point if known.
    Inertia(Option<usize>),
    Principal,
}

/// Target for the next number.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Target {
    Scalar(usize),
    Center(usize),
    Tensor(usize, usize),
    Moment(usize),
    Axis(usize),
}

/// Reads the whole report.
pub(crate) fn scan(text: &str) -> Result<Scan, ContentError> {
    let mut scanner = Scanner {
        text,
        section: Section::Other,
        heading_unit: None,
        waiting: VecDeque::new(),
        scan: Scan {
            product: product(text),
            stated: None,
            scalars: [Group::EMPTY; 4],
            center: Group::EMPTY,
            names_center: false,
            tensors: [Group::EMPTY; 2],
            moments: Group::EMPTY,
            axes: Group::EMPTY,
        },
    };
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        scanner.line(start, line)?;
        start += line.len();
    }
    scanner.nothing_waits(text.len())?;
    Ok(scanner.scan)
}

/// Detects the program by headings that only it has.
fn product(text: &str) -> CadProduct {
    let text = text.to_lowercase();
    let has = |phrase: &str| text.contains(phrase);
    // The first line of Creo may also be "MASS PROPERTIES OF THE PART".
    if has("inertia tensor") && has("coordinate frame") {
        CadProduct::Creo
    } else if has("output coordinate system") || has("mass properties of") {
        CadProduct::SolidWorks
    } else if has("inertia at center of mass") || has("inertia at origin") {
        CadProduct::Fusion
    } else if has("onshape") || (has("lxx") && has("moments of inertia")) {
        CadProduct::Onshape
    } else {
        CadProduct::Unknown
    }
}

struct Scanner<'a> {
    text: &'a str,
    section: Section,
    heading_unit: Option<String>,
    /// Queue of targets, first in, first out.
    waiting: VecDeque<Target>,
    scan: Scan,
}

impl Scanner<'_> {
    fn line(&mut self, start: usize, line: &str) -> Result<(), ContentError> {
        // Reports may also be pasted into comments and tables.
        let content = line.trim_start_matches(|c: char| c.is_whitespace() || "#%/*>;|\u{feff}".contains(c));
        let content = content.strip_prefix("- ").unwrap_or(content);
        let start = start + line.len() - content.len();
        let content = content.trim_end();
        let lower = content.to_ascii_lowercase();
        for (convention, phrase) in
            [(ProductConvention::Positive, "positive"), (ProductConvention::Negative, "negative")]
        {
            if lower.contains(phrase) && lower.contains("tensor notation") {
                self.scan.stated = Some(convention);
            }
        }
        if lower.contains("taken at") && !lower.contains("inertia") {
            if matches!(self.section, Section::Inertia(_)) {
                self.section = Section::Inertia(about(&lower));
            }
            return Ok(());
        }
        if let Some(scalar) = scalar(&lower) {
            self.nothing_waits(start)?;
            (self.section, self.heading_unit) = (Section::Other, bracketed(content, SCALARS[scalar].2));
            self.waiting.push_back(Target::Scalar(scalar));
            return self.numbers(start, content, 0);
        }
        let Some(section) = heading(&lower, self.section) else { return self.numbers(start, content, 0) };
        self.nothing_waits(start)?;
        self.scan.names_center |= section == Section::Center;
        self.section = section;
        let dimension = if section == Section::Center { Dimension::LENGTH } else { Dimension::INERTIA };
        // Creo's lines "INERTIA TENSOR:" are between the heading with the unit and the numbers.
        let unit = bracketed(content, dimension);
        if unit.is_some() || !lower.starts_with("inertia tensor") {
            self.heading_unit = unit;
        }
        // A heading may contain names with digits and letters. Only the heading of a centre of mass
        // has numbers on the same line.
        let beside = section == Section::Center && !lower.contains("with respect to");
        if !beside {
            return Ok(());
        }
        let label = lower.find(" of mass").or(lower.find(" of gravity")).map_or(0, |at| at + " of ".len());
        let from = label + content[label..].find([' ', '\t', ':', '=']).unwrap_or(content.len() - label);
        self.numbers(start, content, from)
    }

    /// Reads the labels and numbers of one line, from byte `from` on.
    fn numbers(&mut self, start: usize, line: &str, from: usize) -> Result<(), ContentError> {
        if self.section == Section::Other && self.waiting.is_empty() {
            return Ok(());
        }
        let mut at = from;
        // The centre of mass "1.2 mm, 3.4 mm, 5.6 mm" needs no labels.
        let mut unlabelled = if self.section == Section::Center && from > 0 { 0..3 } else { 0..0 };
        while let Some(c) = line[at..].chars().next() {
            if let Some(number) = numbers::number_at(line, at) {
                at = number.end;
                let target = self.waiting.pop_front().or_else(|| unlabelled.next().map(Target::Center));
                if let Some(target) = target {
                    let unit = own_unit(&line[at..], dimension(target));
                    self.put(target, start + number.start..start + number.end, unit)?;
                }
            } else if c.is_alphabetic() {
                let word = line[at..].find(|c: char| !c.is_alphanumeric()).unwrap_or(line.len() - at);
                self.label(&line[at..at + word].to_ascii_lowercase(), start + at)?;
                at += word;
            } else {
                at += c.len_utf8();
            }
        }
        Ok(())
    }

    /// Reads a word that may be a label.
    fn label(&mut self, word: &str, at: usize) -> Result<(), ContentError> {
        let axis = |letter: &u8| b"xyz".iter().position(|l| l == letter);
        match (self.section, word.as_bytes()) {
            (Section::Center, [letter]) => self.waiting.extend(axis(letter).map(Target::Center)),
            (Section::Inertia(which), [kind @ (b'i' | b'l'), i, j]) => {
                if let (Some(i), Some(j)) = (axis(i), axis(j)) {
                    // L is always about the centre of mass, and so is Onshape's tensor.
                    let central = *kind == b'l' || self.scan.product == CadProduct::Onshape;
                    let which = which.or(central.then_some(CENTRAL)).ok_or_else(|| nowhere(word, at))?;
                    self.waiting.push_back(Target::Tensor(which, 3 * i + j));
                }
            }
            (Section::Principal, [b'p', k]) => self.waiting.extend(axis(k).map(Target::Moment)),
            (Section::Principal, [b'i', k @ b'1'..=b'3']) => {
                self.waiting.push_back(Target::Moment(usize::from(k - b'1')));
            }
            (Section::Principal, [b'i', k]) => {
                self.waiting.extend(axis(k).into_iter().flat_map(|k| (3 * k..3 * k + 3).map(Target::Axis)));
            }
            _ => {}
        }
        Ok(())
    }

    fn put(&mut self, target: Target, span: Range<usize>, unit: Option<String>) -> Result<(), ContentError> {
        let scan = &mut self.scan;
        let (slot, group_unit) = match target {
            Target::Scalar(k) => (&mut scan.scalars[k].numbers[0], &mut scan.scalars[k].unit),
            Target::Center(k) => (&mut scan.center.numbers[k], &mut scan.center.unit),
            Target::Tensor(which, k) => (&mut scan.tensors[which].numbers[k], &mut scan.tensors[which].unit),
            Target::Moment(k) => (&mut scan.moments.numbers[k], &mut scan.moments.unit),
            Target::Axis(k) => (&mut scan.axes.numbers[k], &mut scan.axes.unit),
        };
        if slot.is_some() {
            let value = self.text[span.clone()].to_owned();
            let rule = "given once: the text contains more than one report, or one report twice";
            let kind = ContentErrorKind::value(name(target), value, rule);
            return Err(kind.at(span).hint("paste one report at a time"));
        }
        // "X Y Z  1 2 3 MM" has one unit for three numbers.
        let shared = self.heading_unit.as_ref().or(unit.as_ref());
        if group_unit.is_none() && dimension(target) != Dimension::NONE {
            *group_unit = shared.cloned();
        }
        *slot = Some(Found { span, unit });
        Ok(())
    }

    /// Returns an error if a label has no number: the report is truncated.
    fn nothing_waits(&mut self, at: usize) -> Result<(), ContentError> {
        let Some(&target) = self.waiting.front() else { return Ok(()) };
        let found = self.text[at..].lines().next().unwrap_or_default().trim().to_owned();
        let kind = ContentErrorKind::expected(format!("a number for {}", name(target)), found);
        let place = ContentPlace::Text(at..at);
        Err(ContentError::new(kind, place).hint("paste the whole report"))
    }
}

/// Returns the scalar whose label starts the line.
fn scalar(lower: &str) -> Option<usize> {
    let starts = |label: &str| {
        lower.strip_prefix(label).is_some_and(|rest| {
            let rest = rest.trim_start();
            rest.is_empty()
                || rest.starts_with([':', '=', '(', '[', '-', '+', '.', ','])
                || rest.starts_with(|c: char| c.is_ascii_digit())
        })
    };
    SCALARS.iter().position(|(labels, ..)| labels.iter().any(|label| starts(label)))
}

/// Returns the section that a line opens, if it is a heading.
fn heading(lower: &str, current: Section) -> Option<Section> {
    let has = |phrases: &[&str]| phrases.iter().any(|phrase| lower.contains(phrase));
    if has(&["rotation ", "radii", "radius", "bounding box", "world "]) || lower.starts_with("mass propert") {
        return Some(Section::Other);
    }
    if has(&["inertia"]) {
        if has(&["principal"]) {
            return Some(Section::Principal);
        }
        return Some(match current {
            Section::Inertia(which) if lower.starts_with("inertia tensor") => {
                Section::Inertia(about(lower).or(which))
            }
            _ => Section::Inertia(about(lower)),
        });
    }
    let center = ["center of mass", "centre of mass", "center of gravity", "centre of gravity", "centroid"];
    center.iter().any(|label| lower.starts_with(label)).then_some(Section::Center)
}

/// Returns the reference point of a tensor, if the line names one.
fn about(lower: &str) -> Option<usize> {
    let has = |phrases: &[&str]| phrases.iter().any(|phrase| lower.contains(phrase));
    if has(&["center of mass", "centre of mass", "center of gravity", "centre of gravity", "centroid"]) {
        Some(CENTRAL)
    } else if has(&["origin", "coordinate system", "coordinate frame"]) {
        Some(ORIGIN)
    } else {
        None
    }
}

/// Returns the unit in brackets in a heading.
fn bracketed(line: &str, dimension: Dimension) -> Option<String> {
    line.split(['(', '[']).skip(1).find_map(|rest| {
        let phrase = rest.split([')', ']']).next()?;
        units::read(phrase, dimension)
    })
}

/// Returns the unit after a number: as many words as form a unit.
fn own_unit(rest: &str, dimension: Dimension) -> Option<String> {
    const WORDS: usize = 6; // "grams per square millimeter" and the like, with signs between them
    let phrase =
        rest.split([',', ';', '|', '(', ')', '[', ']', '\t']).find(|part| !part.trim().is_empty())?;
    let words: Vec<&str> = phrase.split_whitespace().take(WORDS).collect();
    (1..=words.len()).rev().find_map(|n| units::read(&words[..n].join(" "), dimension))
}

fn dimension(target: Target) -> Dimension {
    match target {
        Target::Scalar(k) => SCALARS[k].2,
        Target::Center(_) => Dimension::LENGTH,
        Target::Tensor(..) | Target::Moment(_) => Dimension::INERTIA,
        Target::Axis(_) => Dimension::NONE,
    }
}

fn name(target: Target) -> String {
    match target {
        Target::Scalar(k) => SCALARS[k].1.to_owned(),
        Target::Center(k) => center_name(k).to_owned(),
        Target::Tensor(which, k) => element_name(which, k),
        Target::Moment(k) => format!("principal moment {}", k + 1),
        Target::Axis(k) => format!("principal axis {}", k / 3 + 1),
    }
}

pub(crate) fn center_name(k: usize) -> &'static str {
    ["x of the centre of mass", "y of the centre of mass", "z of the centre of mass"][k]
}

/// Returns the name of an element: `Ixy about the centre of mass`.
pub(crate) fn element_name(which: usize, k: usize) -> String {
    let point = if which == CENTRAL { "the centre of mass" } else { "the origin" };
    let letter = |k: usize| ["x", "y", "z"][k];
    format!("I{}{} about {point}", letter(k / 3), letter(k % 3))
}

fn nowhere(word: &str, at: usize) -> ContentError {
    ContentErrorKind::unclear("is this tensor about the centre of mass or about the origin?", "")
        .at(at..at + word.len())
        .hint("also paste the heading, or write \"Moments of inertia at center of mass\" above the numbers")
}
