//! `[[limit]]`: limits on quantities of the whole.

use polhode::math::{Body, Direction, Position};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use crate::limit::DIRECTIONS;
use crate::{About, Basis, Limit, Measure, PrincipalAxis, ProductSign};

/// Dimension of an unbalance, kg·m.
const UNBALANCE: Dimension = Dimension::new(1, 1, 0, 0);

const KEYS: [&str; 13] = [
    "name", "of", "least", "most", "within", "basis", "along", "from", "about", "axes", "products", "number",
    "numbers",
];

/// Name of a measure, its dimension, and its additional keys.
type Kind = (&'static str, Dimension, &'static [&'static str]);

/// Measures that can be limited.
const MEASURES: [Kind; 12] = [
    ("mass", Dimension::MASS, &[]),
    ("center", Dimension::LENGTH, &["along", "from"]),
    ("center distance", Dimension::LENGTH, &["along", "from"]),
    ("static unbalance", UNBALANCE, &["along", "from"]),
    ("couple unbalance", Dimension::INERTIA, &["along", "from"]),
    ("moment", Dimension::INERTIA, &["along", "about"]),
    ("product", Dimension::INERTIA, &["axes", "about", "products"]),
    ("principal moment", Dimension::INERTIA, &["number"]),
    ("principal ratio", Dimension::NONE, &["numbers"]),
    ("tilt", Dimension::ANGLE, &["along", "number"]),
    ("spin ratio", Dimension::NONE, &["along"]),
    ("spin stability", Dimension::NONE, &["along"]),
];

/// Keys that only some measures have.
const DETAILS: [&str; 7] = ["along", "from", "about", "axes", "products", "number", "numbers"];

/// Reads all limits. `products` is the sign convention of limits without their own.
pub(crate) fn limits(value: &Value<'_>, products: Option<ProductSign>) -> Result<Vec<Limit>, FormatError> {
    let mut limits: Vec<Limit> = Vec::new();
    for table in value.tables("limit")? {
        let limit = limit(&table, products)?;
        if limits.iter().any(|other| other.name == limit.name) {
            let place = table.get("name").or(table.get("of"));
            let place = place.ok_or_else(|| table.missing("name", "name = \"tilt\""))?;
            return Err(place
                .invalid("unique among the limits")
                .with_hint("give it another name: write name = \"tilt\""));
        }
        limits.push(limit);
    }
    Ok(limits)
}

fn limit(table: &Table<'_>, products: Option<ProductSign>) -> Result<Limit, FormatError> {
    table.allow(&KEYS)?;
    let kind = table.require("of", "of = \"mass\"")?;
    let (name, dimension, details) = kind.named(&MEASURES.map(|kind| (kind.0, kind)))?;
    for key in DETAILS.into_iter().filter(|key| !details.contains(key)) {
        if let Some(value) = table.get(key) {
            let rule = format!("left out of a limit on \"{name}\"");
            return Err(value.invalid(rule).with_hint(match details {
                [] => "it needs only least or most".to_owned(),
                details => format!("it takes {}", details.join(", ")),
            }));
        }
    }
    let [least, most] = bounds(table, dimension)?;
    let is_even = least.is_some_and(|least| Some(-least) == most);
    Ok(Limit {
        name: match table.get("name") {
            Some(value) => value.string()?.to_owned(),
            None => described(name, table),
        },
        of: measure(name, table, products, is_even)?,
        least,
        most,
        basis: table.get("basis").map_or(Ok(Basis::Predicted), |value| value.named(&Basis::NAMED))?,
    })
}

fn bounds(table: &Table<'_>, dimension: Dimension) -> Result<[Option<f64>; 2], FormatError> {
    let rule = "within sets both";
    table.at_most_one(&["within", "least"], rule)?;
    table.at_most_one(&["within", "most"], rule)?;
    if let Some(value) = table.get("within") {
        let half = value.quantity(dimension)?;
        if !(half >= 0.0) {
            return Err(value.invalid("zero or positive").with_hint("it applies to both sides of zero"));
        }
        return Ok([Some(-half), Some(half)]);
    }
    let bound = |key| table.get(key).map(|value| value.quantity(dimension)).transpose();
    let (least, most) = (bound("least")?, bound("most")?);
    match (least, most) {
        (None, None) => Err(table.missing("most", "most = \"2 mm\", or least, or within")),
        (Some(least), Some(most)) if least > most => {
            let value = table.require("most", "")?;
            Err(value.invalid("at least the value of least"))
        }
        both => Ok([both.0, both.1]),
    }
}

fn measure(
    name: &str,
    table: &Table<'_>,
    products: Option<ProductSign>,
    is_even: bool,
) -> Result<Measure, FormatError> {
    let along = || direction(&table.require("along", "along = \"z\"")?);
    let from = || table.get("from").map_or(Ok(Position::ZERO), |value| point(&value));
    Ok(match name {
        "mass" => Measure::Mass,
        "center" => Measure::Center { along: along()?, from: from()? },
        "center distance" if table.get("along").is_some() => {
            Measure::CenterFromLine { point: from()?, along: along()? }
        }
        "center distance" => Measure::CenterFromPoint(from()?),
        "static unbalance" => Measure::StaticUnbalance { point: from()?, along: along()? },
        "couple unbalance" => Measure::CoupleUnbalance { point: from()?, along: along()? },
        "moment" => Measure::Moment { axis: along()?, about: about(table)? },
        "product" => {
            let value = table.require("axes", "axes = [\"x\", \"y\"]")?;
            let [first, second] = value.fixed::<2>("two directions")?;
            let given = table.get("products").map(|value| value.named(&ProductSign::NAMED)).transpose()?;
            // The sign does not matter for symmetric limits.
            let sign = given.or(products).or(is_even.then_some(ProductSign::NegativeIntegral));
            let sign = sign.ok_or_else(|| table.missing("products", "products = \"positive integrals\""))?;
            let axes = [direction(&first)?, direction(&second)?];
            if axes[0].dot(axes[1]).abs() > 1e-9 * axes[0].norm() * axes[1].norm() {
                return Err(value.invalid("two directions that are perpendicular"));
            }
            Measure::Product { axes, sign, about: about(table)? }
        }
        "principal moment" => Measure::PrincipalMoment(number(&table.require("number", "number = 3")?)?),
        "principal ratio" => {
            let value = table.require("numbers", "numbers = [1, 3]")?;
            let [first, second] = value.fixed::<2>("two numbers of principal moments")?;
            Measure::PrincipalRatio([number(&first)?, number(&second)?])
        }
        "tilt" => {
            let axis = table.get("number").map(|value| number(&value)).transpose()?;
            Measure::Tilt { axis: axis.map_or(PrincipalAxis::Nearest, PrincipalAxis::Number), from: along()? }
        }
        "spin ratio" => Measure::SpinRatio(along()?),
        _ => Measure::SpinStability(along()?),
    })
}

/// Returns a name such as `center along z`.
fn described(name: &str, table: &Table<'_>) -> String {
    let along = table.get("along").and_then(|value| value.string().ok());
    along.map_or_else(|| name.to_owned(), |along| format!("{name} along {along}"))
}

/// Reads the number of a principal axis: 1 for the least moment, 3 for the greatest.
fn number(value: &Value<'_>) -> Result<usize, FormatError> {
    match value.count()? {
        k @ 1..=3 => Ok(k as usize - 1),
        _ => Err(value
            .invalid("1, 2 or 3")
            .with_hint("1 is the axis of the smallest moment, 3 of the largest")),
    }
}

fn about(table: &Table<'_>) -> Result<About, FormatError> {
    let Some(value) = table.get("about") else { return Ok(About::CenterOfMass) };
    if value.is_array() {
        return point(&value).map(About::Point);
    }
    value.named(&[("center", About::CenterOfMass), ("origin", About::Point(Position::ZERO))])
}

pub(crate) fn point(value: &Value<'_>) -> Result<Position<Body>, FormatError> {
    value.quantities(Dimension::LENGTH).map(Position::from_array)
}

/// Reads a direction such as `"z"` or `"-x"`, or three numbers.
pub(crate) fn direction(value: &Value<'_>) -> Result<Direction<Body>, FormatError> {
    if !value.is_array() {
        return value.named(&DIRECTIONS).map(Direction::from_array);
    }
    let direction = Direction::from_array(value.numbers()?);
    match direction.direction() {
        Some(_) => Ok(direction),
        None => Err(value.invalid("a direction that is not zero")),
    }
}
