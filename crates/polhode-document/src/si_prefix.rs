//! SI prefixes, and the prefixes in use with each unit.

/// Prefixes from large to small, with their powers of ten.
const ALL: [(i32, &str); 9] =
    [(9, "G"), (6, "M"), (3, "k"), (0, ""), (-3, "m"), (-6, "µ"), (-9, "n"), (-12, "p"), (-15, "f")];

/// Returns the prefixes in use with a unit, from large to small. Large rates stay in rad/s and long
/// times in s. Other units have none.
pub fn prefixes(unit: &str) -> impl Iterator<Item = (i32, &'static str)> {
    let [least, greatest] = match unit {
        "J" => [-12, 9],
        "N·m" => [-9, 6],
        "rad/s" => [-6, 0],
        "s" => [-15, 0],
        _ => [0, 0],
    };
    ALL.into_iter().filter(move |(power, _)| (least..=greatest).contains(power))
}

/// Returns the prefix for a value of this size, and its factor. Sizes from 0.1 to 10⁴ get no
/// prefix, others the largest prefix that gives at least 0.1. Returns `None` for zero and for sizes
/// outside the range of the prefixes.
pub fn fitting(size: f64, unit: &str) -> Option<(&'static str, f64)> {
    if (0.1..1e4).contains(&size) {
        return Some(("", 1.0));
    }
    let mut sizes = prefixes(unit).map(|(power, prefix)| (prefix, 10_f64.powi(power)));
    sizes.find(|(_, unit)| size >= 0.1 * unit && size < 1e6 * unit)
}
