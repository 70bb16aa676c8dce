//! `correlated`: several numbers, or mass properties, drawn from a joint distribution.

use polhode::infer::correlated::Correlated;
use polhode::infer::covariance::NotCovariance;
use polhode_source::FormatError;
use polhode_source::text::cut;
use polhode_source::toml::reader::Value;
use polhode_source::unit::{Dimension, unit_of};

use crate::read::target::Target;

/// Largest number of columns drawn together.
const MOST: usize = 16;

/// The ten numbers of a body in their order; a tensor has the last six.
const NUMBERS: [(&str, Dimension); 10] = [
    ("mass", Dimension::MASS),
    ("center_of_mass x", Dimension::LENGTH),
    ("center_of_mass y", Dimension::LENGTH),
    ("center_of_mass z", Dimension::LENGTH),
    ("inertia xx", Dimension::INERTIA),
    ("inertia yy", Dimension::INERTIA),
    ("inertia zz", Dimension::INERTIA),
    ("inertia xy", Dimension::INERTIA),
    ("inertia xz", Dimension::INERTIA),
    ("inertia yz", Dimension::INERTIA),
];

/// Numbers drawn together: names, dimensions, and values as written.
pub(crate) struct Numbers {
    names: Vec<(String, Dimension)>,
    nominal: Vec<f64>,
    is_body: bool,
}

impl Numbers {
    /// Creates the numbers of mass properties.
    pub(crate) fn of_body(target: &Target) -> Self {
        let nominal = target.nominal().to_vec();
        let names = NUMBERS.iter().skip(NUMBERS.len() - nominal.len());
        Self { names: names.map(|(name, of)| ((*name).to_owned(), *of)).collect(), nominal, is_body: true }
    }

    /// Combines numbers of the scenario, each a target of its own, into one target.
    pub(crate) fn of_keys(
        key: &Value<'_>,
        targets: Vec<(Target, Value<'_>)>,
    ) -> Result<(Target, Self), FormatError> {
        if targets.len() > MOST {
            return Err(key.invalid(format!("at most {MOST} keys that are drawn together")));
        }
        let names = targets.iter().map(|(target, _)| (target.key().to_owned(), target.dimension())).collect();
        let nominal = targets.iter().flat_map(|(target, _)| target.nominal().iter().copied()).collect();
        let mut targets = targets.into_iter();
        let Some((mut all, _)) = targets.next() else { return Err(key.invalid("keys of numbers")) };
        for (target, key) in targets {
            all = all.joined_with(target, &key)?;
        }
        Ok((all, Self { names, nominal, is_body: false }))
    }

    /// Reads `correlated = { covariance = [[…], …] }`, or `{ sd = […], correlation = [[…], …] }`.
    /// Numbers may have a `mean`; mass properties have a rule for `impossible` draws.
    pub(crate) fn law(&self, form: &Value<'_>) -> Result<Correlated, FormatError> {
        let table = form.table()?;
        table.allow(&["mean", "covariance", "sd", "correlation", "impossible"])?;
        let rule = "use sd with correlation, or covariance alone";
        table.at_most_one(&["covariance", "sd"], rule)?;
        table.at_most_one(&["covariance", "correlation"], rule)?;
        let mean = match table.get("mean") {
            Some(value) if self.is_body => {
                let error = value.invalid("left out for mass properties: their mean is the written value");
                return Err(error.with_hint("write the mean into the body itself"));
            }
            Some(value) => self.list(&value)?.into_iter().map(|(_, x)| x).collect(),
            None => self.nominal.clone(),
        };
        let is_moved = match table.get("impossible") {
            Some(value) if !self.is_body => {
                return Err(value.invalid("left out for numbers: only mass properties can be impossible"));
            }
            Some(value) => value.choice(&["failed", "nearest"])? == "nearest",
            None => false,
        };
        let elements = match table.get("covariance") {
            Some(value) => self.covariance(&value)?,
            None => {
                let sd = self.deviations(&table.require("sd", "sd = [0.1, 0.2], and correlation")?)?;
                self.correlation(&table.require("correlation", "correlation = [[1, 0.5], [0.5, 1]]")?, &sd)?
            }
        };
        let matrix: Vec<Vec<f64>> =
            elements.iter().map(|row| row.iter().map(|(_, x)| *x).collect()).collect();
        let is_mass_first = self.is_body && self.names.len() == NUMBERS.len();
        let made = if is_mass_first {
            Correlated::mass_first(mean, &matrix)
        } else {
            Correlated::normal(mean, &matrix)
        };
        let law = made.map_err(|error| self.refused(form, error, &elements))?;
        if law.variables() == 0 {
            return Err(form.invalid("an array with at least one standard deviation above zero"));
        }
        Ok(if is_moved { law.possible() } else { law })
    }

    /// Reads one quantity for each number, in its own dimension.
    fn list<'a>(&self, value: &Value<'a>) -> Result<Vec<(Value<'a>, f64)>, FormatError> {
        let all = self.each(value, "numbers or strings with units")?;
        quantities(all.into_iter().zip(self.dimensions()).collect())
    }

    fn covariance<'a>(&self, value: &Value<'a>) -> Result<Vec<Vec<(Value<'a>, f64)>>, FormatError> {
        let mut all = Vec::new();
        for (row, of) in self.each(value, "rows")?.iter().zip(self.dimensions()) {
            let elements = self.each(row, "numbers or strings with units")?;
            all.extend(elements.into_iter().zip(self.dimensions().map(|other| of.times(other, 1))));
        }
        Ok(quantities(all)?.chunks(self.names.len().max(1)).map(<[_]>::to_vec).collect())
    }

    fn dimensions(&self) -> impl Iterator<Item = Dimension> {
        self.names.iter().map(|(_, of)| *of)
    }

    fn deviations(&self, value: &Value<'_>) -> Result<Vec<f64>, FormatError> {
        let all = self.list(value)?;
        match all.iter().find(|(_, sd)| !(*sd >= 0.0)) {
            Some((value, _)) => {
                Err(value.invalid("zero or positive").with_hint("it is a standard deviation"))
            }
            None => Ok(all.into_iter().map(|(_, sd)| sd).collect()),
        }
    }

    /// Returns the covariance computed from correlations, each element with the place of its
    /// correlation.
    fn correlation<'a>(
        &self,
        value: &Value<'a>,
        sd: &[f64],
    ) -> Result<Vec<Vec<(Value<'a>, f64)>>, FormatError> {
        let mut rows = Vec::new();
        for (i, row) in self.each(value, "rows")?.iter().enumerate() {
            let mut elements = Vec::new();
            for (j, element) in self.each(row, "numbers")?.into_iter().enumerate() {
                let r = element.number()?;
                if i == j && r != 1.0 {
                    return Err(element.invalid("1, the correlation of a number with itself"));
                }
                if !(-1.0..=1.0).contains(&r) {
                    return Err(element.invalid("from -1 to 1"));
                }
                let of = |k: usize| sd.get(k).copied().unwrap_or_default();
                elements.push((element, r * of(i) * of(j)));
            }
            rows.push(elements);
        }
        Ok(rows)
    }

    /// Returns the elements of an array with one element for each number.
    fn each<'a>(&self, value: &Value<'a>, of: &str) -> Result<Vec<Value<'a>>, FormatError> {
        let n = self.names.len();
        let expected = format!("an array of {n} {of}");
        let elements = value.elements(&expected)?;
        if elements.len() == n {
            return Ok(elements);
        }
        let names: Vec<&str> = self.names.iter().map(|(name, _)| name.as_str()).collect();
        let error = value.invalid(format!("{expected}, and it has {}", elements.len()));
        Err(error.with_hint(format!("in this order: {}", names.join(", "))))
    }

    /// Returns the error for a matrix that is not a covariance matrix, at the responsible element.
    fn refused(
        &self,
        form: &Value<'_>,
        NotCovariance { element: [i, j] }: NotCovariance,
        elements: &[Vec<(Value<'_>, f64)>],
    ) -> FormatError {
        let at = |i: usize, j: usize| elements.get(i - 1).and_then(|row| row.get(j - 1));
        let value = at(i, j).map_or(form, |(value, _)| value);
        let name = |k: usize| self.names.get(k - 1).map_or("", |(name, _)| name.as_str());
        let (rule, hint) = match (at(i, j), at(j, i)) {
            (Some((_, x)), _) if i == j && !(*x >= 0.0) => {
                ("zero or positive: it is a variance", format!("it is that of {}", name(i)))
            }
            (Some((_, a)), Some((_, b))) if i != j && (a - b).abs() > 1e-6 * a.abs().max(b.abs()) => {
                ("equal to that across the diagonal", format!("both are of {} and {}", name(i), name(j)))
            }
            _ => (
                "positive semidefinite",
                format!(
                    "with these elements, a combination of the numbers up to {} would have a negative variance",
                    name(i.max(j))
                ),
            ),
        };
        value.invalid(rule).with_hint(hint)
    }
}

/// Reads quantities of given dimensions; refuses the first number without a unit if others have
/// one.
fn quantities<'a>(all: Vec<(Value<'a>, Dimension)>) -> Result<Vec<(Value<'a>, f64)>, FormatError> {
    let unit = |value: &Value<'a>| value.string().ok().filter(|text| !unit_of(text).is_empty());
    let (mut numbers, mut with, mut bare) = (Vec::with_capacity(all.len()), None, None);
    for (value, of) in all {
        let number = value.quantity(of)?;
        if of != Dimension::NONE && number != 0.0 {
            match unit(&value) {
                None => bare = bare.or(Some(value)),
                Some(text) => with = with.or(Some(text)),
            }
        }
        numbers.push((value, number));
    }
    match (with, bare) {
        (Some(with), Some(bare)) => {
            Err(bare.invalid(format!("given with its unit, like the other element \"{}\"", cut(with))))
        }
        _ => Ok(numbers),
    }
}
