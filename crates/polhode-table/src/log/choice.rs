//! Choice of the columns that are read, and their meaning.

use std::collections::BTreeMap;
use std::ops::Range;

use polhode::infer::judge::{AttitudeSense, DeclaredReading, OmegaAxes, QuaternionOrder};
use polhode_source::nearest;
use polhode_source::text::{cut, escaped};
use polhode_source::unit;
use polhode_source::unit::Scale;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::ReadColumns;
use super::candidate::{Candidate, Numbers, attitudes, incomplete, omegas};
use super::columns::{Columns, Key, Said};
use super::euler::Sequence;
use super::head::Units;
use super::name::{Kind, Name};

/// Columns of a file.
#[derive(Debug, Default)]
pub(crate) struct Header {
    pub names: Vec<String>,
    /// Position of each name, in a text.
    pub spans: Vec<Range<usize>>,
    /// True if the columns have an order. Members of a JSON object have none.
    pub is_in_order: bool,
    /// Units of columns that have one in their type.
    pub units: BTreeMap<usize, &'static str>,
}

/// Columns that are read from a row, and their meaning.
#[derive(Debug)]
pub(crate) struct Plan {
    /// Columns of the time, the attitude and the angular velocity.
    pub slots: Vec<Slot>,
    pub time: Scale,
    pub form: Form,
    pub omega: Option<Scale>,
    pub says: DeclaredReading,
    pub read: Vec<ReadColumns>,
    pub ignored: Vec<String>,
    /// True if commas separate the fields.
    pub has_commas: bool,
}

/// Column that is read.
#[derive(Clone, Debug)]
pub(crate) struct Slot {
    pub column: usize,
    pub name: String,
}

/// Form of the numbers of an attitude.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Form {
    /// No attitude is read.
    None,
    Quaternion,
    Matrix,
    Euler {
        sequence: Sequence,
        unit: Scale,
    },
}

impl Form {
    pub(crate) const fn count(self) -> usize {
        match self {
            Self::None => 0,
            Self::Quaternion => 4,
            Self::Matrix => 9,
            Self::Euler { .. } => 3,
        }
    }
}

impl Header {
    fn place(&self, column: usize) -> ContentPlace {
        self.spans.get(column).map_or(ContentPlace::Whole, |span| ContentPlace::Text(span.clone()))
    }

    fn whole(&self) -> ContentPlace {
        match (self.spans.first(), self.spans.last()) {
            (Some(first), Some(last)) => ContentPlace::Text(first.start..last.end),
            _ => ContentPlace::Whole,
        }
    }

    fn named(&self, columns: &[usize]) -> Vec<String> {
        columns.iter().map(|column| self.names[*column].clone()).collect()
    }

    /// Lists the names of columns for messages: `a, b, c`.
    fn listed(&self, columns: &[usize]) -> String {
        self.named(columns).iter().map(|name| cut(&escaped(name))).collect::<Vec<_>>().join(", ")
    }

    /// Lists the names of columns as a user writes them: `a 'b c' d`.
    fn quoted(&self, columns: &[usize]) -> String {
        let quoted = |name: &String| match name.contains([' ', ',', ';', '=', '\t']) {
            true => format!("'{name}'"),
            false => name.clone(),
        };
        self.named(columns).iter().map(quoted).collect::<Vec<_>>().join(" ")
    }

    /// Lists all columns for a message, up to 24.
    fn all(&self) -> String {
        const MOST: usize = 24;
        let shown: Vec<usize> = (0..self.names.len().min(MOST)).collect();
        let more = if self.names.len() > MOST {
            format!(" … ({} in all)", self.names.len())
        } else {
            String::new()
        };
        format!("{}{more}", self.listed(&shown))
    }

    fn missing(&self, what: &str, hint: &str) -> ContentError {
        let kind = ContentErrorKind::Missing { what: what.to_owned() };
        ContentError::new(kind, self.whole()).hint(format!("{hint}; the columns are {}", self.all()))
    }

    /// Returns the columns that a user names, and checks their number.
    fn find(&self, said: &Said) -> Result<Vec<usize>, ContentError> {
        let mut found = Vec::new();
        for name in &said.columns {
            let exact = |name: &str| self.names.iter().position(|own| own == name);
            if self.names.iter().filter(|own| *own == name).count() > 1 {
                return Err(value("the column", name.clone(), "named once".to_owned(), self.whole()));
            }
            let elements = || {
                let is_element =
                    |own: &String| own.strip_prefix(name).is_some_and(|rest| rest.starts_with('['));
                let elements: Vec<usize> =
                    (0..self.names.len()).filter(|k| is_element(&self.names[*k])).collect();
                Some(elements).filter(|elements| !elements.is_empty())
            };
            let neighbours = || {
                let (first, last) = name.split_once("..")?;
                Some((exact(first)?..=exact(last)?).collect::<Vec<_>>()).filter(|all| !all.is_empty())
            };
            let columns = exact(name).map(|column| vec![column]).or_else(elements).or_else(neighbours);
            found.extend(columns.ok_or_else(|| self.no_column(name))?);
        }
        if found.len() != said.key.count() {
            let rule = format!("{} columns; here are {}", said.key.count(), found.len());
            return Err(value("the columns", said.columns.join(" "), rule, self.whole()));
        }
        Ok(found)
    }

    fn no_column(&self, name: &str) -> ContentError {
        let rule = format!("one of the columns of the log: {}", self.all());
        let error = value("the column", name.to_owned(), rule, self.whole());
        match nearest(name, self.names.iter().map(String::as_str)) {
            Some(near) => error.hint(format!("did you mean {near}?")),
            None => error.hint("write the names as in the file; a name with spaces in quotes"),
        }
    }

    /// Returns the candidate with the lowest rank, unless another has the same rank.
    fn best(
        &self,
        what: &str,
        key: &str,
        mut candidates: Vec<Candidate>,
    ) -> Result<Option<Candidate>, ContentError> {
        candidates.sort_by_key(|candidate| candidate.rank);
        if let [first, second, ..] = candidates.as_slice()
            && first.rank == second.rank
        {
            let found = format!("{}; {}", self.listed(&first.columns), self.listed(&second.columns));
            let example = self.quoted(&first.columns);
            return Err(value(what, found, "one thing: these are as likely".to_owned(), self.whole())
                .hint(format!("say which: --columns \"{key} = {example}\"")));
        }
        let Some(best) = candidates.into_iter().next() else { return Ok(None) };
        if let Some(column) = best.twice {
            let name = self.names[column].clone();
            return Err(value("the column", name, "named once".to_owned(), self.place(column)));
        }
        Ok(Some(best))
    }
}

fn value(what: &str, value: String, rule: String, place: ContentPlace) -> ContentError {
    ContentError::new(ContentErrorKind::Value { what: what.to_owned(), value, rule }, place)
}

/// Required contents of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// Attitudes, and optionally angular velocities.
    Attitude,
    /// Angular velocities, attitudes, or both.
    Either,
}

/// Chooses the columns to read: those that the user names, then those with known names.
pub(crate) fn choose(
    header: &Header,
    columns: &Columns,
    units: &Units,
    wanted: Wanted,
) -> Result<Plan, ContentError> {
    let names: Vec<Option<Name>> = header.names.iter().map(|name| Name::of(name)).collect();
    let known = Known { header, names: &names, units };
    let mut says = DeclaredReading::default();
    let (time, time_unit, time_read) = known.time(columns.time.as_ref())?;
    let omega = known.omega(columns.omega.as_ref())?;
    let may_lack = wanted == Wanted::Either && omega.is_some() && columns.attitude.is_none();
    let attitude = match known.attitude(columns.attitude.as_ref()) {
        Err(_) if may_lack && incomplete(&names).is_none() && attitudes(&names).is_empty() => None,
        attitude if header.is_in_order => Some(attitude?.in_file_order()),
        attitude => Some(attitude?),
    };
    let (form, attitude_read) = match &attitude {
        Some(attitude) => known.form(attitude).map(|(form, read)| (form, Some(read)))?,
        None => (Form::None, None),
    };
    if let Some(attitude) = &attitude {
        (says.order, says.sense) = (attitude.order(), attitude.sense);
        let said = columns.attitude.as_ref();
        // Quaternions are computed here from matrices and angles, so their order is certain.
        let is_quaternion = matches!(form, Form::Quaternion);
        says.by_name.order = is_quaternion && said.is_none_or(|said| said.order.is_none());
        says.by_name.sense = said.is_none_or(|said| said.sense.is_none());
    }
    let own = ["time_s", "attitude_w", "attitude_x", "attitude_y", "attitude_z"];
    let read_first = [vec![time], attitude.map_or_else(Vec::new, |attitude| attitude.columns)].concat();
    if header.named(&read_first) == own && columns.attitude.is_none() {
        says.sense = Some(AttitudeSense::BodyToSpace);
    }
    let is_certain =
        |said: &Option<Said>| said.as_ref().is_some_and(|said| said.unit.is_some()).then_some(1.0);
    (says.time_factor, says.omega_factor) = (is_certain(&columns.time), is_certain(&columns.omega));
    says.by_name.time_unit = time_unit.is_stated;
    let mut read = vec![time_read];
    read.extend(attitude_read);
    let mut all = read_first;
    let omega = omega.map(|(candidate, unit, said)| {
        says.omega_axes = candidate.axes;
        says.by_name.omega_axes = columns.omega.as_ref().is_none_or(|said| said.axes.is_none());
        says.by_name.omega_unit = unit.is_stated;
        all.extend(candidate.columns);
        read.push(said);
        unit.scale
    });
    if let Some(column) = (1..all.len()).map(|k| (all[k], &all[..k])).find(|(c, before)| before.contains(c)) {
        let name = header.names[column.0].clone();
        return Err(value("the column", name, "read as one thing".to_owned(), header.place(column.0)));
    }
    let is_ignored = |k: &usize| !all.contains(k) && !header.names[*k].is_empty();
    let ignored = (0..header.names.len()).filter(is_ignored).map(|k| header.names[k].clone()).collect();
    let slots = all.iter().map(|&column| Slot { column, name: header.names[column].clone() }).collect();
    Ok(Plan { slots, time: time_unit.scale, form, omega, says, read, ignored, has_commas: false })
}

/// Unit of columns.
struct Unit {
    scale: Scale,
    /// Unit as shown in messages.
    shown: String,
    /// False for the default unit of SI, if no unit is stated.
    is_stated: bool,
}

/// Known facts about the columns, before the choice.
struct Known<'a> {
    header: &'a Header,
    names: &'a [Option<Name>],
    units: &'a Units,
}

impl Known<'_> {
    /// Returns the column of the time, and its unit.
    fn time(&self, said: Option<&Said>) -> Result<(usize, Unit, ReadColumns), ContentError> {
        let header = self.header;
        let column = match said {
            Some(said) => header.find(said)?[0],
            None => {
                let is_time = |k: &usize| self.names[*k].as_ref().is_some_and(|name| name.kind == Kind::Time);
                let times = (0..self.names.len()).filter(is_time).map(|k| Candidate::time(k, self.names));
                let best = header.best("the time", "time", times.collect())?;
                let best = best.ok_or_else(|| {
                    let hint = "name it time_s, or state its column: --columns \"time = NAME\"";
                    header.missing("column of the time", hint)
                })?;
                best.columns[0]
            }
        };
        let is_stamp = self.names[column].as_ref().is_some_and(Name::is_stamp);
        let unit = self.unit(Key::Time, said, &[column], !is_stamp)?;
        let what = format!("time, {}", unit.shown);
        Ok((column, unit, ReadColumns { what, columns: header.named(&[column]) }))
    }

    fn attitude(&self, said: Option<&Said>) -> Result<Candidate, ContentError> {
        let header = self.header;
        if let Some(said) = said {
            return Candidate::said(said, header.find(said)?, self.names)
                .map_err(|(found, rule)| value("the Euler angles", found, rule, header.whole()));
        }
        let best = header.best("the attitude", "quaternion", attitudes(self.names))?;
        best.ok_or_else(|| {
            let hint = "name a quaternion qw, qx, qy, qz, a matrix r11 … r33 or the angles roll, pitch, yaw, or state the \
                        columns: --columns \"quaternion wxyz = A B C D\"";
            match incomplete(self.names) {
                Some((label, columns)) => {
                    header.missing(&format!("column of {label} beside {}", header.listed(&columns)), hint)
                }
                None => header.missing("columns of an attitude", hint),
            }
        })
    }

    /// Returns the form of the numbers of an attitude, with the unit of angles.
    fn form(&self, attitude: &Candidate) -> Result<(Form, ReadColumns), ContentError> {
        let columns = self.header.named(&attitude.columns);
        let read = |what: String| ReadColumns { what, columns: columns.clone() };
        match attitude.numbers {
            Numbers::Quaternion(order) => {
                let order = match order {
                    Some(QuaternionOrder::ScalarFirst) => " (w, x, y, z)",
                    Some(QuaternionOrder::ScalarLast) => " (x, y, z, w)",
                    None => "",
                };
                Ok((Form::Quaternion, read(format!("quaternion{order}"))))
            }
            Numbers::Vector | Numbers::Matrix => Ok((Form::Matrix, read("matrix, row by row".to_owned()))),
            Numbers::Euler(sequence) => {
                let sequence = sequence.ok_or_else(|| self.no_sequence(&attitude.columns))?;
                let unit = self.unit(Key::Euler, attitude.said.as_ref(), &attitude.columns, false)?;
                let what = format!("{} Euler angles, {}", sequence.shown(), unit.shown);
                Ok((Form::Euler { sequence, unit: unit.scale }, read(what)))
            }
        }
    }

    fn no_sequence(&self, columns: &[usize]) -> ContentError {
        let listed = self.header.listed(columns);
        let question = format!("in which sequence are the Euler angles {listed}?");
        let kind = ContentErrorKind::Unclear { question, found: String::new() };
        let names = self.header.quoted(columns);
        ContentError::new(kind, self.header.whole()).hint(format!(
            "say it, with the angles in the order of the turns: --columns \"euler 3-1-3 rad = {names}\""
        ))
    }

    /// Returns the angular velocity and its unit, if it exists and is to be read.
    fn omega(&self, said: Option<&Said>) -> Result<Option<(Candidate, Unit, ReadColumns)>, ContentError> {
        let header = self.header;
        let candidate = match said {
            Some(said) if said.columns.is_empty() => None,
            Some(said) => Candidate::said(said, header.find(said)?, self.names).ok(),
            None => header.best("the angular velocity", "omega", omegas(self.names))?,
        };
        let Some(candidate) = candidate else { return Ok(None) };
        let unit = self.unit(Key::Omega, said, &candidate.columns, true)?;
        let axes = match candidate.axes {
            Some(OmegaAxes::Body) => " along body axes",
            Some(OmegaAxes::Space) => " along space axes",
            None => "",
        };
        let what = format!("angular velocity{axes}, {}", unit.shown);
        let columns = header.named(&candidate.columns);
        Ok(Some((candidate, unit, ReadColumns { what, columns })))
    }

    /// Returns the unit of columns: as the user, the names of the columns, or the head states it.
    /// If `si` is true, the SI unit is the default.
    fn unit(&self, key: Key, said: Option<&Said>, columns: &[usize], si: bool) -> Result<Unit, ContentError> {
        let header = self.header;
        let own = |column: &usize| {
            let by_type = header.units.get(column).map(|unit| (*unit).to_owned());
            by_type.or_else(|| self.names[*column].as_ref().and_then(|name| name.unit.clone()))
        };
        let named: Vec<Option<String>> = columns.iter().map(own).collect();
        let first = named.first().cloned().flatten();
        let by_user = said.and_then(|said| said.unit.clone());
        if by_user.is_none() && named.iter().any(|unit| *unit != first) {
            let rule = "all in one unit".to_owned();
            return Err(value("the columns", header.listed(columns), rule, header.whole()));
        }
        let unit = by_user.or(first).or_else(|| self.units.of(key));
        let Some(unit) = unit else {
            let (assumed, other) = match key {
                Key::Time => ("s", "ms"),
                Key::Omega => ("rad/s", "deg/s"),
                _ => ("rad", "deg"),
            };
            if si {
                let shown = format!("{assumed} (no unit is named)");
                return Ok(Unit { scale: Scale::from_factor(1.0), shown, is_stated: false });
            }
            let question = format!("in which unit is {}?", header.listed(columns));
            let kind = ContentErrorKind::Unclear { question, found: String::new() };
            let hint = format!(
                "name the unit in the header, such as {} [{other}], or write # units = {assumed} above it",
                header.names[columns[0]]
            );
            return Err(ContentError::new(kind, header.place(columns[0])).hint(hint));
        };
        let factor = unit::factor(&unit, key.dimension()).map_err(|wrong| {
            let what = format!("the unit of {}", header.listed(columns));
            let rule = format!("a unit that polhode knows: {wrong}");
            value(&what, unit.clone(), rule, header.place(columns[0]))
        })?;
        Ok(Unit { scale: Scale::from_factor(factor), shown: unit, is_stated: true })
    }
}
