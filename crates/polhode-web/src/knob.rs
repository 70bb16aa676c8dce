//! Numbers of a scenario that can be changed on the page, and their ranges.

use polhode::motion::Scenario;
use polhode_scenario::read::WrittenNumber;
use polhode_source::unit::Dimension;

use crate::protocol::{Knob, Switch};

/// Groups of knobs, by the first table of a key. Among knobs of equal interest, they are in this
/// order.
const GROUPS: [&str; 5] = ["start", "body", "torque", "wheel", "run"];

/// Returns a knob for each number of a scenario, the most informative first.
pub fn knobs(numbers: &[WrittenNumber]) -> Vec<Knob> {
    let mut order: Vec<(u32, &WrittenNumber)> =
        numbers.iter().map(|number| (interest(number), number)).collect();
    // Equally informative numbers stay in the order of the text.
    order.sort_by_key(|(interest, _)| *interest);
    order.iter().enumerate().map(|(rank, (_, number))| knob(number, numbers, rank)).collect()
}

fn knob(number: &WrittenNumber, all: &[WrittenNumber], rank: usize) -> Knob {
    let (head, _) = split(&number.key);
    let group = GROUPS.iter().find(|group| **group == head).copied().unwrap_or("other");
    let value = written(number);
    let is_size = is_positive(number) && value > 0.0;
    let [low, high] = if is_size { [value / 5.0, value * 5.0] } else { span(number, all, value) };
    let si = if number.unit.is_empty() { number.si() } else { String::new() };
    Knob {
        key: number.key.clone(),
        label: label(number),
        group,
        value,
        unit: number.unit.clone(),
        si,
        what: number.dimension.to_string(),
        low,
        high,
        scale: if is_size { "log" } else { "linear" },
        rank,
    }
}

/// Returns the number in the unit in which it is written.
fn written(number: &WrittenNumber) -> f64 {
    let factor = polhode_source::unit::factor(&number.unit, number.dimension).unwrap_or(1.0);
    let value = if number.unit.is_empty() { number.value } else { number.value / factor };
    // The conversion is not exact, but the number in the text has few digits.
    format!("{value:.14e}").parse().unwrap_or(value)
}

/// Returns true for a quantity that is always positive.
fn is_positive(number: &WrittenNumber) -> bool {
    let key = number.key.rsplit('.').next().unwrap_or_default();
    let key = key.split('[').next().unwrap_or_default();
    let is_size = [
        "size",
        "radius",
        "length",
        "height",
        "semi_axes",
        "tube",
        "damping",
        "spring",
        "friction",
        "static_friction",
        "viscous",
        "rolling_friction",
        "pivoting_friction",
        "thickness",
        "moments",
        "samples",
        "duration",
        "every",
    ];
    is_size.contains(&key)
        || key.ends_with("_radius")
        || [Dimension::MASS, Dimension::DENSITY].contains(&number.dimension)
}

/// Returns the range of a number that may have either sign. Angles have a full turn. Components of
/// a vector reach 1.5 times the largest component, and other numbers three times their value or a
/// usual value.
fn span(number: &WrittenNumber, all: &[WrittenNumber], value: f64) -> [f64; 2] {
    let factor = polhode_source::unit::factor(&number.unit, number.dimension).unwrap_or(1.0);
    if number.dimension == Dimension::ANGLE {
        let half = (std::f64::consts::PI / factor).round();
        return [-half, half]
            .map(|end| if value.abs() > half { end * (value.abs() / half).ceil() } else { end });
    }
    let usual = match number.dimension {
        Dimension::ANGULAR_VELOCITY => 10.0 / factor,
        Dimension::LENGTH => 0.1 / factor,
        Dimension::ACCELERATION => 20.0 / factor,
        _ => 1.0,
    };
    let vector = number.key.rsplit_once('[').map(|(vector, _)| vector);
    let beside = all.iter().filter(|other| other.key.rsplit_once('[').map(|(vector, _)| vector) == vector);
    let largest = beside
        .map(|other| other.value.abs() / if number.unit.is_empty() { 1.0 } else { factor })
        .fold(0.0, f64::max);
    let most = match (vector, value == 0.0) {
        (Some(_), _) if largest > 0.0 => 1.5 * largest,
        (_, true) => usual,
        (_, false) => 3.0 * value.abs(),
    };
    [-most, most]
}

/// Returns the rank of interest of a number; a smaller value means more interest.
fn interest(number: &WrittenNumber) -> u32 {
    let (head, rest) = split(&number.key);
    let is_zero = u32::from(number.value == 0.0);
    match head {
        "start" if rest.starts_with("spin") => 10,
        "start" if rest.starts_with("attitude") => 12,
        "body" if is_positive(number) && number.dimension == Dimension::LENGTH => 20,
        "body" if is_positive(number) => 22,
        "torque" => 14 + is_zero * 20,
        "wheel" => 16 + is_zero * 20,
        "body" if rest.contains("rotate.axis") => 38,
        "body" => 26 + is_zero * 10,
        "run" if rest == "duration" => 30,
        "contact" | "gimbals" => 16 + is_zero * 20,
        "pendulum" | "shaft" | "prescribed" => 18,
        _ => 40,
    }
}

/// Splits a key after its first word.
fn split(key: &str) -> (&str, &str) {
    let head = key.split(['.', '[']).next().unwrap_or_default();
    (head, key[head.len()..].trim_start_matches('.'))
}

/// Returns the label of a number, such as `crossbar: radius`; components of the spin are labelled
/// by their symbols.
fn label(number: &WrittenNumber) -> String {
    for (vector, symbols) in [
        ("start.spin.body", ["ωx", "ωy", "ωz"]),
        ("start.spin.space", ["ωX", "ωY", "ωZ"]),
        ("start.spin.momentum", ["LX", "LY", "LZ"]),
    ] {
        let component =
            number.key.strip_prefix(vector).map(|index| index.trim_matches(['[', ']']).parse::<usize>());
        if let Some(symbol) = component.and_then(Result::ok).and_then(|k| symbols.get(k)) {
            return (*symbol).to_owned();
        }
    }
    let (head, rest) = split(&number.key);
    let rest = if rest.is_empty() { head } else { rest };
    let rest = rest
        .strip_prefix("part")
        .unwrap_or(rest)
        .trim_start_matches(|c: char| c == '[' || c == ']' || c == '.' || c.is_ascii_digit());
    let mut words: Vec<String> = Vec::new();
    for word in rest.split('.') {
        let (name, index) = word.split_at(word.find('[').unwrap_or(word.len()));
        words.push(name.replace('_', " "));
        let axis = index.split(['[', ']']).filter(|k| !k.is_empty()).filter_map(|k| k.parse().ok());
        let letters: String = axis.filter_map(|k: usize| ["x", "y", "z"].get(k).copied()).collect();
        // Euler angles and elements of a quaternion are not components of a vector.
        let is_vector = !name.starts_with("euler")
            && name != "quaternion"
            && name != "roll_pitch_yaw"
            && name != "moments";
        match (is_vector, index) {
            (_, "") => {}
            (true, _) if !letters.is_empty() => words.push(letters),
            _ => words.push(
                index
                    .trim_matches(['[', ']'])
                    .parse::<usize>()
                    .map_or_else(|_| index.to_owned(), |k| (k + 1).to_string()),
            ),
        }
    }
    let rest = words
        .join(" ")
        .replace("roll pitch yaw 1", "roll")
        .replace("roll pitch yaw 2", "pitch")
        .replace("roll pitch yaw 3", "yaw");
    match &number.owner {
        Some(owner) => format!("{owner}: {rest}"),
        None => rest,
    }
}

/// Returns a switch for each torque of a text, labelled by its name or its model.
pub(crate) fn switches(scenario: &Scenario, text: &str) -> Vec<Switch> {
    let document = text.parse::<toml_edit::DocumentMut>().unwrap_or_default();
    let models: Vec<_> =
        document.get("torque").and_then(|list| list.as_array_of_tables()).into_iter().flatten().collect();
    let off = scenario.switched_off();
    let one = |k: usize| {
        let name = scenario.torque_names().get(k).cloned().flatten();
        let model = || Some(models.get(k)?.get("model")?.as_str()?.replace('_', " "));
        Switch {
            key: format!("torque[{k}].on"),
            label: name.or_else(model).unwrap_or_else(|| format!("torque {}", k + 1)),
            on: !off.contains(&k),
        }
    };
    (0..scenario.torques().len()).map(one).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use polhode_scenario::read::Draft;
    use polhode_source::files::Disk;

    use super::*;

    #[test]
    fn the_spin_comes_first_and_sizes_are_in_their_units() {
        let text = "[[body.part]]\nname = \"bar\"\nshape = \"cylinder\"\nradius = \"6 mm\"\nlength = \"120 mm\"\ndensity = 7800\nposition = [\"1 mm\", 0, \"-2 mm\"]\n[start]\nspin = { body = [\"0.01 rad/s\", \"30 deg/s\", \"6 rad/s\"] }\n[run]\nduration = \"20 s\"\nsamples = 11\n";
        let mut draft = Draft::new("a.toml".as_ref(), []);
        draft.read(&Disk, text.to_owned()).unwrap();
        let knobs = knobs(&draft.numbers());
        let named: Vec<_> =
            knobs.iter().map(|knob| (knob.label.as_str(), knob.value, knob.unit.as_str())).collect();
        assert_eq!(named[..3], [("ωx", 0.01, "rad/s"), ("ωy", 30.0, "deg/s"), ("ωz", 6.0, "rad/s")]);
        let find = |label: &str| knobs.iter().find(|knob| knob.label == label).unwrap();
        let radius = find("bar: radius");
        assert_eq!((radius.value, radius.low, radius.high, radius.scale), (6.0, 1.2, 30.0, "log"));
        assert_eq!(find("bar: density").si, "kg/m³");
        let spin = find("ωy");
        assert!((spin.high - 1.5 * 6_f64.to_degrees()).abs() < 1e-9 && spin.low == -spin.high);
        let place = find("bar: position z");
        assert_eq!((place.value, place.low, place.high, place.scale), (-2.0, -3.0, 3.0, "linear"));
        assert!(knobs.iter().enumerate().all(|(k, knob)| knob.rank == k));
    }
}
