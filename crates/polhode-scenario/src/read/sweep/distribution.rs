//! Probability distributions of a number.

use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit;
use polhode_source::unit::Dimension;

/// Probability distribution of a number, SI units.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Distribution {
    /// Normal distribution with `sd` > 0, truncated to `from` … `to`.
    Normal {
        /// Mean of the distribution before truncation.
        mean: f64,
        /// Standard deviation before truncation.
        sd: f64,
        /// Lower bound; −∞ if there is none.
        from: f64,
        /// Upper bound; ∞ if there is none.
        to: f64,
    },
    /// Uniform distribution between two numbers.
    Uniform {
        /// Lower bound.
        from: f64,
        /// Upper bound.
        to: f64,
    },
    /// Log-normal distribution: the logarithm is normal.
    LogNormal {
        /// Median; positive.
        median: f64,
        /// Standard deviation of the natural logarithm; positive.
        sigma: f64,
    },
    /// Log-uniform distribution: the logarithm is uniform. Both bounds are positive.
    LogUniform {
        /// Lower bound; positive.
        from: f64,
        /// Upper bound; positive.
        to: f64,
    },
    /// Triangular distribution: the density rises linearly from the lower bound to the mode, and
    /// falls to the upper bound.
    Triangular {
        /// Lower bound.
        from: f64,
        /// Mode, which may be at either bound.
        mode: f64,
        /// Upper bound.
        to: f64,
    },
    /// List of equally probable values; in a grid, all of them. At least one.
    List(Vec<f64>),
}

impl Distribution {
    /// Returns the least possible number; −∞ if there is none.
    pub fn least(&self) -> f64 {
        match self {
            Self::Normal { from, .. }
            | Self::Uniform { from, .. }
            | Self::LogUniform { from, .. }
            | Self::Triangular { from, .. } => *from,
            Self::LogNormal { .. } => 0.0,
            Self::List(values) => values.iter().copied().fold(f64::INFINITY, f64::min),
        }
    }
}

/// Keys of the distributions.
pub(crate) const FORMS: [&str; 8] =
    ["normal", "uniform", "log_normal", "log_uniform", "triangular", "relative", "list", "grid"];

/// Largest number of values of one number; more are probably a mistake.
const MOST_VALUES: u64 = 1_000_000;

/// Reads the distribution of a number of this dimension; `nominal` is its value as written.
pub(crate) fn distribution(
    form: &Value<'_>,
    dimension: Dimension,
    nominal: f64,
) -> Result<Distribution, FormatError> {
    match form.key() {
        "relative" => return relative(form, nominal),
        "list" => return list(form, dimension),
        _ => {}
    }
    let table = form.table()?;
    match form.key() {
        "normal" => normal(&table, dimension),
        "log_normal" => log_normal(&table, dimension),
        "grid" => grid(&table, dimension),
        "triangular" => {
            table.allow(&["from", "mode", "to"])?;
            let [from, to] = bounds(&table, dimension)?;
            let value = table.require("mode", "mode = 0.5")?;
            let mode = value.quantity(dimension)?;
            if !(from..=to).contains(&mode) {
                return Err(value.invalid("between from and to").with_hint("it is the likeliest value"));
            }
            Ok(Distribution::Triangular { from, mode, to })
        }
        "log_uniform" => {
            table.allow(&["from", "to"])?;
            let [from, to] = bounds(&table, dimension)?;
            above_zero(&table, "from", from)?;
            Ok(Distribution::LogUniform { from, to })
        }
        _ => {
            table.allow(&["from", "to"])?;
            let [from, to] = bounds(&table, dimension)?;
            Ok(Distribution::Uniform { from, to })
        }
    }
}

/// Reads `normal = { mean, sd }`, optionally with `from` and `to`.
fn normal(table: &Table<'_>, dimension: Dimension) -> Result<Distribution, FormatError> {
    table.allow(&["mean", "sd", "from", "to"])?;
    let mean = table.require("mean", "mean = 0.3")?.quantity(dimension)?;
    let sd = deviation(&table.require("sd", "sd = 0.05")?, dimension)?;
    let bound = |key, or| table.get(key).map_or(Ok(or), |value| value.quantity(dimension));
    let (from, to) = (bound("from", f64::NEG_INFINITY)?, bound("to", f64::INFINITY)?);
    if let Some(value) = table.get("to").filter(|_| !(from < to)) {
        return Err(value.invalid("greater than from").with_hint("the numbers are between them"));
    }
    // Bounds beyond this many standard deviations from the mean leave almost no probability.
    const FARTHEST: f64 = 30.0;
    for (key, outside) in [("from", (from - mean) / sd > FARTHEST), ("to", (mean - to) / sd > FARTHEST)] {
        if let Some(value) = table.get(key).filter(|_| outside) {
            let error = value.invalid("within 30 sd of the mean");
            return Err(error.with_hint("the probability beyond it is negligible"));
        }
    }
    Ok(Distribution::Normal { mean, sd, from, to })
}

/// Reads `log_normal = { median, sigma }`, or `{ mean, sd }` of the number itself.
fn log_normal(table: &Table<'_>, dimension: Dimension) -> Result<Distribution, FormatError> {
    table.allow(&["median", "sigma", "mean", "sd"])?;
    let rule = "use median with sigma, or mean with sd";
    for (one, other) in [("median", "mean"), ("median", "sd"), ("sigma", "mean"), ("sigma", "sd")] {
        table.at_most_one(&[one, other], rule)?;
    }
    let positive = |key, example| {
        let value = table.require(key, example)?;
        let number = value.quantity(dimension)?;
        above_zero(table, key, number).map(|()| number)
    };
    if table.get("mean").is_some() || table.get("sd").is_some() {
        let mean = positive("mean", "mean = 0.3")?;
        let sd = deviation(&table.require("sd", "sd = 0.05")?, dimension)?;
        // σ² = ln(1 + (sd/mean)²),  median = mean / √(1 + (sd/mean)²).
        let square = (sd / mean) * (sd / mean);
        return Ok(Distribution::LogNormal {
            median: mean / (1.0 + square).sqrt(),
            sigma: libm::log1p(square).sqrt(),
        });
    }
    let median = positive("median", "median = 0.3, and sigma = 0.5")?;
    let sigma = deviation(&table.require("sigma", "sigma = 0.5")?, Dimension::NONE)?;
    Ok(Distribution::LogNormal { median, sigma })
}

/// Reads `grid = { from, to, count }`, optionally with `spacing = "log"`.
fn grid(table: &Table<'_>, dimension: Dimension) -> Result<Distribution, FormatError> {
    table.allow(&["from", "to", "count", "spacing"])?;
    let [from, to] = bounds(table, dimension)?;
    let value = table.require("count", "count = 11")?;
    let count = value.count()?;
    if !(2..=MOST_VALUES).contains(&count) {
        return Err(value.invalid("from 2 to 1000000").with_hint("both ends are among the values"));
    }
    let spacing = table.get("spacing").map_or(Ok("linear"), |value| value.choice(&["linear", "log"]))?;
    let last = (count - 1) as f64;
    let at = |k: u64| match k {
        0 => from,
        k if k == count - 1 => to,
        k if spacing == "log" => from * libm::pow(to / from, k as f64 / last),
        k => from + (to - from) * (k as f64 / last),
    };
    if spacing == "log" {
        above_zero(table, "from", from)?;
    }
    Ok(Distribution::List((0..count).map(at).collect()))
}

/// Reads `list = [ … ]`.
fn list(form: &Value<'_>, dimension: Dimension) -> Result<Distribution, FormatError> {
    let elements = form.elements("an array of numbers or strings with units")?;
    if elements.is_empty() {
        return Err(form.invalid("at least one number").with_hint("write list = [0.1, 0.2, 0.5]"));
    }
    elements
        .iter()
        .map(|element| element.quantity(dimension))
        .collect::<Result<_, _>>()
        .map(Distribution::List)
}

/// Reads `relative = "5 %"`: a normal distribution around the number as written.
fn relative(form: &Value<'_>, nominal: f64) -> Result<Distribution, FormatError> {
    let share = percentage(form)?;
    if !(share > 0.0) {
        return Err(form.invalid("above 0").with_hint("it is a standard deviation: \"5 %\""));
    }
    if nominal == 0.0 {
        let error = form.invalid("left out, since the number is written as zero");
        return Err(error.with_hint("write normal = { mean = 0, sd = 0.1 } in place of relative"));
    }
    let (from, to) = (f64::NEG_INFINITY, f64::INFINITY);
    Ok(Distribution::Normal { mean: nominal, sd: share * nominal.abs(), from, to })
}

/// Reads a percentage, `"5 %"` or 0.05, as a fraction.
pub(crate) fn percentage(value: &Value<'_>) -> Result<f64, FormatError> {
    let Ok(text) = value.string() else { return value.number() };
    let wrong = || value.invalid("a percentage").with_hint("write \"5 %\", or 0.05");
    let number = text.trim_end().strip_suffix('%').ok_or_else(wrong)?;
    unit::parse(number, Dimension::NONE).map(|number| number / 100.0).map_err(|_| wrong())
}

/// Reads `from` and `to`; `from` must be less than `to`.
fn bounds(table: &Table<'_>, dimension: Dimension) -> Result<[f64; 2], FormatError> {
    let from = table.require("from", "from = 0.1")?.quantity(dimension)?;
    let value = table.require("to", "to = 0.5")?;
    let to = value.quantity(dimension)?;
    if !(from < to) {
        return Err(value.invalid("greater than from").with_hint("the numbers are between them"));
    }
    if !(to - from).is_finite() {
        return Err(value
            .invalid("nearer to from")
            .with_hint("their difference is larger than the largest double"));
    }
    Ok([from, to])
}

fn deviation(value: &Value<'_>, dimension: Dimension) -> Result<f64, FormatError> {
    let sd = value.quantity(dimension)?;
    if sd > 0.0 {
        return Ok(sd);
    }
    Err(value
        .invalid("positive")
        .with_hint("it is a standard deviation; a number with zero standard deviation does not vary"))
}

fn above_zero(table: &Table<'_>, key: &'static str, number: f64) -> Result<(), FormatError> {
    if number > 0.0 {
        return Ok(());
    }
    let value = table.require(key, "")?;
    Err(value.invalid("positive").with_hint("only positive numbers have a logarithm"))
}
