//! SI prefixes, and those in use with a unit.

/// From large to small, with their powers of ten.
const ALL: [(i32, &str); 9] =
    [(9, "G"), (6, "M"), (3, "k"), (0, ""), (-3, "m"), (-6, "µ"), (-9, "n"), (-12, "p"), (-15, "f")];

/// The prefixes in use with a unit, from large to small: large rates stay in rad/s, and times in s. Other units have none.
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

/// The prefix with which a size is read, and how large it is: none for a size from 0.1 to 10⁴; else the largest in
/// which it is 0.1 at least. `None` if it is none, below all, or far above.
pub fn fitting(size: f64, unit: &str) -> Option<(&'static str, f64)> {
    if (0.1..1e4).contains(&size) {
        return Some(("", 1.0));
    }
    let mut sizes = prefixes(unit).map(|(power, prefix)| (prefix, 10_f64.powi(power)));
    sizes.find(|(_, unit)| size >= 0.1 * unit && size < 1e6 * unit)
}
