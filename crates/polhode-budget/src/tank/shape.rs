//! Shapes of tanks.

use super::section::Section;

/// Inner shape of a tank in its own axes, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TankShape {
    /// Box centred at the origin: its sides along x, y and z.
    Box([f64; 3]),
    /// Ellipsoid or sphere centred at the origin: its semi-axes.
    Ellipsoid([f64; 3]),
    /// Cylinder along z with half ellipsoids at its ends. The origin is at the middle of the
    /// cylindrical part.
    Cylinder {
        /// Radius of the cylindrical part.
        radius: f64,
        /// Length of the cylindrical part.
        length: f64,
        /// Heights of the ends at −z and at +z: 0 if flat, the radius for a half sphere.
        ends: [f64; 2],
    },
}

/// Direction in which the liquid settles, along an axis of the tank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "they say what they are")]
pub enum Down {
    MinusX,
    MinusY,
    MinusZ,
    PlusX,
    PlusY,
    PlusZ,
}

impl Down {
    /// All directions in their order, with their names.
    pub(crate) const NAMED: [(&str, Self); 6] = [
        ("-x", Self::MinusX),
        ("-y", Self::MinusY),
        ("-z", Self::MinusZ),
        ("x", Self::PlusX),
        ("y", Self::PlusY),
        ("z", Self::PlusZ),
    ];

    pub(crate) const fn name(self) -> &'static str {
        Self::NAMED[self as usize].0
    }

    /// Returns the opposite direction.
    pub(super) const fn opposite(self) -> Self {
        Self::NAMED[(self as usize + 3) % 6].1
    }

    /// Returns the index of the axis, and the sign of the upward direction.
    pub(super) const fn axis(self) -> (usize, f64) {
        let place = self as usize;
        (place % 3, if place < 3 { 1.0 } else { -1.0 })
    }
}

impl TankShape {
    /// Returns the name and the value of the first invalid number.
    pub(super) fn wrong(&self) -> Option<(&'static str, f64)> {
        let positive = |what, value: f64| (!(value > 0.0 && value.is_finite())).then_some((what, value));
        let not_negative = |what, value: f64| (!(value >= 0.0 && value.is_finite())).then_some((what, value));
        match *self {
            Self::Box(size) => size.into_iter().find_map(|x| positive("a side of the tank", x)),
            Self::Ellipsoid(axes) => axes.into_iter().find_map(|x| positive("a semi-axis of the tank", x)),
            Self::Cylinder { radius, length, ends } => positive("the radius of the tank", radius)
                .or_else(|| not_negative("the length of the tank", length))
                .or_else(|| {
                    ends.into_iter().find_map(|x| not_negative("the height of an end of the tank", x))
                })
                .or_else(|| positive("the whole length of the tank", length + ends[0] + ends[1])),
        }
    }

    /// Returns the intervals of height above the bottom, m, in each of which all sections are of
    /// one kind.
    pub(super) fn bands(&self, down: Down) -> Vec<[f64; 2]> {
        let (axis, up) = down.axis();
        match *self {
            Self::Box(size) => vec![[0.0, size[axis]]],
            Self::Ellipsoid(axes) => vec![[0.0, 2.0 * axes[axis]]],
            Self::Cylinder { radius, .. } if axis != 2 => vec![[0.0, 2.0 * radius]],
            Self::Cylinder { length, ends: [a, b], .. } => {
                let [low, high] = if up > 0.0 { [a, b] } else { [b, a] };
                let bands = [[0.0, low], [low, low + length], [low + length, low + length + high]];
                bands.into_iter().filter(|[from, to]| to > from).collect()
            }
        }
    }

    /// Returns the coordinate of the bottom along the axis in which the liquid settles, m.
    pub(super) fn bottom(&self, down: Down) -> f64 {
        let (axis, up) = down.axis();
        match *self {
            Self::Box(size) => -0.5 * up * size[axis],
            Self::Ellipsoid(axes) => -up * axes[axis],
            Self::Cylinder { radius, .. } if axis != 2 => -up * radius,
            Self::Cylinder { length, ends: [a, b], .. } => {
                -up * (0.5 * length + if up > 0.0 { a } else { b })
            }
        }
    }

    /// Returns the section at a height above the bottom, m.
    pub(super) fn section(&self, down: Down, height: f64) -> Section {
        let (axis, up) = down.axis();
        let (p, q) = ((axis + 1) % 3, (axis + 2) % 3);
        // 1 − (1 − u)²: the squared relative width of an ellipse whose lowest point is at u = 0
        let round = |u: f64| (u * (2.0 - u)).max(0.0);
        match *self {
            Self::Box(size) => Section::rectangle([size[p], size[q]]),
            Self::Ellipsoid(axes) => {
                let w = round(height / axes[axis]).sqrt();
                Section::ellipse([axes[p] * w, axes[q] * w])
            }
            Self::Cylinder { radius, length, ends } if axis != 2 => {
                let w = round(height / radius).sqrt();
                let section = Section::stadium(radius * w, length, ends.map(|end| end * w));
                // Order of the axes: x, then y and z; y, then z and x.
                if axis == 0 { section } else { section.swapped() }
            }
            Self::Cylinder { radius, length, ends: [a, b] } => {
                let [low, high] = if up > 0.0 { [a, b] } else { [b, a] };
                let w = if height < low {
                    round(height / low).sqrt()
                } else if height > low + length {
                    round((low + length + high - height) / high).sqrt()
                } else {
                    1.0
                };
                Section::ellipse([radius * w; 2])
            }
        }
    }
}
