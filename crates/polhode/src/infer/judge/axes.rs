//! Axes of a log, as signed axes of the scenario.

use core::fmt;

/// Axes x, y, z of a log, each an axis of the scenario or its opposite, for body and space alike.
///
/// Programs have y or z upward, and some have left-handed axes. If all axes are reversed, rotations
/// keep their components; every left-handed choice is therefore equivalent to one of the 24
/// right-handed ones: (x, z, y) to (−x, −z, −y).
///
/// ```
/// use polhode::infer::judge::SignedAxes;
/// // The log's y is the scenario's z, and its z the scenario's −y: y upwards.
/// let upwards = SignedAxes::parse("x,z,-y").ok_or("it is one of them")?;
/// assert_eq!(upwards.to_string(), "(x, z, −y)");
/// assert_eq!(upwards.to_scenario([1.0, 2.0, 3.0]), [1.0, -3.0, 2.0]);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SignedAxes([(u8, bool); 3]);

impl SignedAxes {
    /// Axes equal to those of the scenario.
    pub const SAME: Self = Self([(0, false), (1, false), (2, false)]);

    /// All 24 right-handed choices, [`SignedAxes::SAME`] first.
    pub const ALL: [Self; 24] = all();

    /// Parses axes from a text such as `x,z,-y`, or the displayed form. `None` if it does not name
    /// three right-handed axes.
    pub fn parse(text: &str) -> Option<Self> {
        let plain = |text: &str| text.replace([' ', '(', ')'], "").replace('−', "-").to_lowercase();
        let wanted = plain(text);
        Self::ALL.into_iter().find(|axes| plain(&axes.to_string()) == wanted)
    }

    /// Returns true if x × y = z.
    pub(super) fn is_right_handed(self) -> bool {
        Self::ALL.contains(&self)
    }

    /// Returns the opposite axes, which are left-handed if these are right-handed.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self(self.0.map(|(axis, negative)| (axis, !negative)))
    }

    /// Converts components along these axes to those along the scenario's axes; also for axial
    /// vectors and the vector part of a quaternion.
    pub fn to_scenario(self, components: [f64; 3]) -> [f64; 3] {
        let mut along = [0.0; 3];
        for ((axis, negative), c) in self.0.into_iter().zip(components) {
            along[usize::from(axis)] = if negative { -c } else { c };
        }
        along
    }
}

const fn all() -> [SignedAxes; 24] {
    // Even permutations first, then odd ones. A right-handed choice has an even or an odd number of
    // reversed axes, respectively.
    let permutations = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let mut axes = [SignedAxes::SAME; 24];
    let mut count = 0;
    let mut p = 0;
    while p < 6 {
        let mut signs: u8 = 0;
        while signs < 8 {
            if signs.count_ones() % 2 == (p / 3) as u32 {
                let [a, b, c] = permutations[p];
                axes[count] = SignedAxes([(a, signs & 4 != 0), (b, signs & 2 != 0), (c, signs & 1 != 0)]);
                count += 1;
            }
            signs += 1;
        }
        p += 1;
    }
    axes
}

impl fmt::Display for SignedAxes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("(")?;
        for (k, (axis, negative)) in self.0.into_iter().enumerate() {
            let (comma, sign) = (if k == 0 { "" } else { ", " }, if negative { "−" } else { "" });
            let name = ["x", "y", "z"][usize::from(axis) % 3];
            write!(f, "{comma}{sign}{name}")?;
        }
        f.write_str(")")
    }
}
