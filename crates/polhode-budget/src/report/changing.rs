//! Body with draining tanks and other changes: its numbers by fill and over time.

use polhode_document::Section;
use polhode_document::graph::Graph;
use polhode_document::json::matrix;
use polhode_document::layout::printable;
use polhode_document::number::{number, tidy};
use serde_json::{Value, json};

use super::numbers::{rates, ten};
use crate::tensor::rows;
use crate::{Burn, Change, Sequence, SequenceError, SequenceRow, Tank};

/// Number of steps in the fill of a tank: in tables; in JSON and pictures.
const SHOWN_FILLS: usize = 4;
const FILLS: usize = 20;
/// Number of steps in each time interval without events: in tables; in JSON and pictures.
const SHOWN_PIECES: usize = 2;
const PIECES: usize = 16;
const DIGITS: usize = 5;

/// Body as a function of the fill of its tanks, and of time.
#[derive(Clone, Debug)]
pub(crate) struct Changing {
    tanks: Vec<FilledTank>,
    over_time: Option<OverTime>,
}

/// Whole body as a function of the liquid in one tank.
#[derive(Clone, Debug)]
struct FilledTank {
    name: String,
    capacity: f64,
    at_first: f64,
    /// Fill fraction, ascending, level if known, and body. Rates are derivatives per kilogram of
    /// liquid.
    rows: Vec<(f64, Option<f64>, SequenceRow)>,
}

/// Body over time, from t = 0 on.
#[derive(Clone, Debug)]
pub(crate) struct OverTime {
    until: f64,
    pub tanks: Vec<String>,
    /// Name of the configuration, by the number of changes that have happened.
    configurations: Vec<Option<String>>,
    /// Time, s, and description of each event.
    happenings: Vec<(f64, String)>,
    /// Rows of all intervals without events, each divided into [`PIECES`].
    pub all: Vec<SequenceRow>,
}

impl Changing {
    /// Computes the numbers of the configuration in which the sequence begins.
    pub(crate) fn new(
        configuration: Option<&str>,
        sequence: &Sequence<'_>,
        until: Option<f64>,
    ) -> Result<Self, SequenceError> {
        let tanks =
            (0..).zip(&sequence.tanks).map(|(k, (tank, mass))| FilledTank::new(sequence, k, tank, *mass));
        let tanks = tanks.collect::<Result<_, _>>()?;
        let over_time = until.map(|until| OverTime::new(configuration, sequence, until)).transpose()?;
        Ok(Self { tanks, over_time })
    }

    pub(crate) fn sections(&self) -> Vec<Section> {
        let mut sections = Vec::new();
        if let Some(over_time) = &self.over_time {
            sections.push(over_time.section());
        }
        if !self.tanks.is_empty() {
            let mut section = Section::new(0, "Mass properties by fill level");
            section.say(
                "Initial mass properties, with the contents of one tank varied. Liquids are at rest in the tanks, with a plane surface, and rotate with the body.",
            );
            self.tanks.iter().for_each(|tank| tank.add_to(&mut section));
            sections.push(section);
        }
        sections
    }

    pub(crate) const fn over_time(&self) -> Option<&OverTime> {
        self.over_time.as_ref()
    }

    /// Iterates over tanks and fills: name, fill fraction, mass in kg, level in m, and body. Rates
    /// are derivatives per kilogram of liquid.
    pub(crate) fn by_fill(&self) -> impl Iterator<Item = (&str, f64, f64, Option<f64>, &SequenceRow)> {
        self.tanks.iter().flat_map(|tank| {
            let rows = tank.rows.iter();
            rows.map(|(fill, level, row)| (&*tank.name, *fill, fill * tank.capacity, *level, row))
        })
    }

    /// Returns words such as `In 60 s 73.24 kg become 35.1 kg`.
    pub(crate) fn in_words(&self) -> Option<String> {
        let over_time = self.over_time.as_ref()?;
        let [first, last] = [over_time.all.first()?, over_time.all.last()?].map(|row| row.properties.mass());
        let [first, last] = [first, last].map(|mass| number(mass, DIGITS));
        Some(format!("Mass over {} s: {first} kg to {last} kg", number(over_time.until, DIGITS)))
    }

    pub(crate) fn to_json(&self) -> Value {
        let tank = |tank: &FilledTank| {
            let row = |(fill, level, row): &(f64, Option<f64>, SequenceRow)| {
                let mut data = row_to_json(row);
                data["fill"] = json!(fill);
                data["liquid"] = json!(fill * tank.capacity);
                data["level"] = json!(level);
                data
            };
            json!({
                "name": tank.name,
                "capacity": tank.capacity,
                "mass": tank.at_first,
                "rows": tank.rows.iter().map(row).collect::<Value>(),
            })
        };
        let over_time = self.over_time.as_ref().map(|over_time| {
            let row = |row: &SequenceRow| {
                let mut data = row_to_json(row);
                data["configuration"] = json!(over_time.configuration(row));
                data["time"] = json!(row.time);
                data["liquid"] = json!(row.liquid);
                data["rates"] = json!({
                    "mass": row.rates.mass,
                    "center_of_mass": row.rates.center_of_mass.to_array(),
                    "inertia": matrix(rows(row.rates.inertia)),
                });
                data
            };
            let what = |(time, what): &(f64, String)| json!({ "time": time, "what": what });
            json!({
                "until": over_time.until,
                "tanks": over_time.tanks,
                "events": over_time.happenings.iter().map(what).collect::<Value>(),
                "rows": over_time.all.iter().map(row).collect::<Value>(),
            })
        });
        json!({ "by_fill": self.tanks.iter().map(tank).collect::<Value>(), "over_time": over_time })
    }
}

fn row_to_json(row: &SequenceRow) -> Value {
    json!({
        "mass": row.properties.mass(),
        "center_of_mass": row.properties.center_of_mass().to_array(),
        "inertia": matrix(row.properties.inertia().matrix()),
    })
}

/// Headings of mass and centre of mass, and of the tensor about it; and of their rates.
const PLACE: [&str; 4] = ["M (kg)", "x (mm)", "y (mm)", "z (mm)"];
const PLACE_RATES: [&str; 4] = ["dM/dt (kg/s)", "dx/dt (mm/s)", "dy/dt (mm/s)", "dz/dt (mm/s)"];
const TENSOR: [&str; 6] = ["Ixx (kg·m²)", "Iyy (kg·m²)", "Izz (kg·m²)", "Ixy", "Ixz", "Iyz"];
const TENSOR_RATES: [&str; 6] = ["dIxx/dt (kg·m²/s)", "dIyy/dt", "dIzz/dt", "dIxy/dt", "dIxz/dt", "dIyz/dt"];

/// Formats the ten numbers. Values that are only rounding error of larger ones become 0.
fn cells(values: [f64; 10]) -> [Vec<String>; 2] {
    let [mass, x, y, z, xx, yy, zz, xy, xz, yz] = values;
    let [x, y, z] = tidy([x, y, z]).map(|x| 1e3 * x);
    let least = 1e-12 * xx.abs().max(yy.abs()).max(zz.abs());
    let [xy, xz, yz] = [xy, xz, yz].map(|x| if x.abs() < least { 0.0 } else { x });
    let shown = |numbers: &[f64]| numbers.iter().map(|x| number(*x, DIGITS)).collect();
    [shown(&[mass, x, y, z]), shown(&[xx, yy, zz, xy, xz, yz])]
}

impl FilledTank {
    fn new(sequence: &Sequence<'_>, k: usize, tank: &Tank, at_first: f64) -> Result<Self, SequenceError> {
        let mut base = Sequence::of(sequence.budget, sequence.basis, sequence.tanks.iter().cloned());
        let capacity = tank.liquid.capacity();
        base.burns = vec![Burn { tank: tank.name.clone(), from: 0.0, until: 1.0, flow: 1.0 }];
        let row = |j: usize| {
            let fill = j as f64 / FILLS as f64;
            let mass = fill * capacity;
            if let Some(load) = base.tanks.get_mut(k) {
                load.1 = mass;
            }
            let level = tank.liquid.at(mass).and_then(|fill| fill.level);
            Ok((fill, level, more(base.at(0.0)?)))
        };
        let rows = (0..=FILLS).map(row).collect::<Result<_, SequenceError>>()?;
        Ok(Self { name: tank.name.clone(), capacity, at_first, rows })
    }

    fn add_to(&self, section: &mut Section) {
        let shown = || self.rows.iter().step_by(FILLS / SHOWN_FILLS);
        section.line(format!(
            "{}: {} kg of {} kg",
            printable(&self.name),
            number(self.at_first, DIGITS),
            number(self.capacity, DIGITS)
        ));
        let mut headers = vec!["fill (%)", "mass (kg)"];
        let has_level = shown().all(|(_, level, _)| level.is_some());
        headers.extend(has_level.then_some("level (mm)"));
        headers.extend(PLACE);
        let row = |(fill, level, row): &(f64, Option<f64>, SequenceRow)| {
            let mut line = vec![number(100.0 * fill, 3), number(fill * self.capacity, DIGITS)];
            line.extend(level.filter(|_| has_level).map(|level| number(1e3 * level, DIGITS)));
            let [place, _] = cells(ten(&row.properties));
            line.extend(place);
            line
        };
        section.table(&headers, shown().map(row).collect());
        let headers: Vec<&str> = ["fill (%)"].into_iter().chain(TENSOR).collect();
        let row = |(fill, _, row): &(f64, Option<f64>, SequenceRow)| {
            let [_, tensor] = cells(ten(&row.properties));
            [number(100.0 * fill, 3)].into_iter().chain(tensor).collect()
        };
        section.table(&headers, shown().map(row).collect());
        let across = |(fill, _, row): &(f64, Option<f64>, SequenceRow)| (100.0 * fill, ten(&row.properties));
        let points: Vec<(f64, [f64; 10])> = self.rows.iter().map(across).collect();
        let k = greatest(&points, 1..4, |_| 1.0);
        let title = format!("Centre of mass by contents of {}", printable(&self.name));
        section.graph(curve(title, ["fill", "%"], ["x", "y", "z"][k - 1], "mm", &points, k, 1e3));
    }
}

/// Turns the rates of an outflow of 1 kg/s into derivatives per added kilogram.
fn more(mut row: SequenceRow) -> SequenceRow {
    let rates = &mut row.rates;
    rates.mass = -rates.mass;
    rates.center_of_mass = -rates.center_of_mass;
    rates.inertia = rates.inertia.map(|x| 0.0 - x);
    row
}

/// Returns the index of the number that changes most, relative to a size.
fn greatest(
    points: &[(f64, [f64; 10])],
    among: core::ops::Range<usize>,
    size: impl Fn(usize) -> f64,
) -> usize {
    let range = |k: usize| {
        let values = || points.iter().map(|(_, all)| all[k]);
        (values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)) / size(k)
    };
    let first = among.start;
    among.fold(first, |best, k| if range(k) > range(best) { k } else { best })
}

fn curve(
    title: String,
    across: [&'static str; 2],
    name: &'static str,
    unit: &'static str,
    points: &[(f64, [f64; 10])],
    k: usize,
    scale: f64,
) -> Graph {
    let points: Vec<[f64; 2]> = points.iter().map(|(x, all)| [*x, scale * all[k]]).collect();
    let [first, last] = [points.first(), points.last()].map(|point| point.copied().unwrap_or_default());
    let level = ([first[0], last[0], last[1]], "final value");
    Graph { title, across, up: [name, unit], points, level }
}

impl OverTime {
    fn new(configuration: Option<&str>, sequence: &Sequence<'_>, until: f64) -> Result<Self, SequenceError> {
        let all = sequence.rows([0.0, until], PIECES)?;
        let mut happenings: Vec<(f64, String)> = Vec::new();
        for burn in &sequence.burns {
            let flow = number(burn.flow, DIGITS);
            happenings
                .push((burn.from, format!("outflow of {flow} kg/s from {} begins", printable(&burn.tank))));
            happenings
                .push((burn.until, format!("outflow of {flow} kg/s from {} ends", printable(&burn.tank))));
        }
        for change in &sequence.changes {
            let what = match change {
                Change::Drop { rows, .. } => {
                    format!(
                        "{} dropped",
                        rows.iter().map(|row| printable(row)).collect::<Vec<_>>().join(", ")
                    )
                }
                Change::Become { name, .. } => format!("becomes {}", printable(name)),
            };
            happenings.push((change.time(), what));
        }
        happenings.retain(|(time, _)| *time <= until);
        happenings.sort_by(|a, b| a.0.total_cmp(&b.0));
        let tanks = sequence.tanks.iter().map(|(tank, _)| tank.name.clone()).collect();
        let mut changes: Vec<&Change<'_>> = sequence.changes.iter().collect();
        changes.sort_by(|a, b| a.time().total_cmp(&b.time()));
        let mut configurations = vec![configuration.map(str::to_owned)];
        for change in changes {
            configurations.push(match change {
                Change::Drop { .. } => configurations.last().cloned().flatten(),
                Change::Become { name, .. } => Some(name.clone()),
            });
        }
        Ok(Self { until, tanks, configurations, happenings, all })
    }

    /// Returns the name of the configuration in a row.
    pub(crate) fn configuration(&self, row: &SequenceRow) -> Option<&str> {
        self.configurations.get(row.changes).and_then(Option::as_deref)
    }

    fn section(&self) -> Section {
        let mut section = Section::new(0, "Over time");
        let seconds = |time: f64| number(time, DIGITS);
        section.table(
            &["t (s)", "event"],
            self.happenings.iter().map(|(time, what)| vec![seconds(*time), what.clone()]).collect(),
        );
        let mut shown: Vec<&SequenceRow> = Vec::new();
        let stretches = self.all.chunks(PIECES + 1);
        for row in stretches.flat_map(|stretch| stretch.iter().step_by(PIECES / SHOWN_PIECES)) {
            // If the next interval begins as the last one ended, only one row is shown.
            let again = shown.last().is_some_and(|last| {
                last.time == row.time && last.properties == row.properties && last.rates == row.rates
            });
            if !again {
                shown.push(row);
            }
        }
        let mut table =
            |headers: &[&'static str], of: &dyn Fn([Vec<String>; 2], [Vec<String>; 2]) -> Vec<String>| {
                let headers: Vec<&str> = ["t (s)"].iter().chain(headers).copied().collect();
                let line = |row: &&SequenceRow| {
                    let numbers = of(cells(ten(&row.properties)), cells(rates(row)));
                    [seconds(row.time)].into_iter().chain(numbers).collect()
                };
                section.table(&headers, shown.iter().map(line).collect());
            };
        table(&[PLACE, PLACE_RATES].concat(), &|[place, _], [rates, _]| [place, rates].concat());
        table(&TENSOR, &|[_, tensor], _| tensor);
        table(&TENSOR_RATES, &|_, [_, rates]| rates);
        section.say(
            "Two rows with the same time are just before and just after an event. The tensor is about the centre of mass, in body axes. Rates are exact at each time: the surface layer of a liquid leaves its tank first.",
        );
        let points: Vec<(f64, [f64; 10])> =
            self.all.iter().map(|row| (row.time, ten(&row.properties))).collect();
        let across = ["time", "s"];
        section.graph(curve("Mass over time".to_owned(), across, "M", "kg", &points, 0, 1.0));
        let k = greatest(&points, 1..4, |_| 1.0);
        section.graph(curve(
            "Centre of mass over time".to_owned(),
            across,
            ["x", "y", "z"][k - 1],
            "mm",
            &points,
            k,
            1e3,
        ));
        for k in 4..7 {
            let name = ["Ixx", "Iyy", "Izz"][k - 4];
            section.graph(curve(format!("{name} over time"), across, name, "kg·m²", &points, k, 1.0));
        }
        section
    }
}
