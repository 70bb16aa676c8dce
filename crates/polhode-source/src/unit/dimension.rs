//! Physical dimension of a unit.

use std::fmt;

/// Exponents of mass, length, time, angle and electric current in a quantity.
///
/// The angle is counted, although the radian is 1 in SI, so that `"30 deg"` is not accepted as a
/// plain number. Energy and torque have the same dimension, as in SI.
///
/// ```
/// use polhode_source::unit::Dimension;
/// assert_eq!(Dimension::INERTIA.to_string(), "a moment of inertia");
/// assert_eq!(Dimension::new(1, 0, -1, 0).to_string(), "a quantity in kg s^-1");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Dimension {
    mass: i8,
    length: i8,
    time: i8,
    angle: i8,
    current: i8,
}

#[allow(missing_docs, reason = "the names are the documentation")]
impl Dimension {
    pub const NONE: Self = Self::new(0, 0, 0, 0);
    pub const MASS: Self = Self::new(1, 0, 0, 0);
    pub const LENGTH: Self = Self::new(0, 1, 0, 0);
    pub const VOLUME: Self = Self::new(0, 3, 0, 0);
    pub const TIME: Self = Self::new(0, 0, 1, 0);
    pub const ANGLE: Self = Self::new(0, 0, 0, 1);
    pub const VELOCITY: Self = Self::new(0, 1, -1, 0);
    pub const ACCELERATION: Self = Self::new(0, 1, -2, 0);
    pub const ANGULAR_VELOCITY: Self = Self::new(0, 0, -1, 1);
    pub const ANGULAR_ACCELERATION: Self = Self::new(0, 0, -2, 1);
    pub const DENSITY: Self = Self::new(1, -3, 0, 0);
    pub const AREA_DENSITY: Self = Self::new(1, -2, 0, 0);
    pub const LINE_DENSITY: Self = Self::new(1, -1, 0, 0);
    pub const INERTIA: Self = Self::new(1, 2, 0, 0);
    pub const ANGULAR_MOMENTUM: Self = Self::new(1, 2, -1, 0);
    pub const TORQUE: Self = Self::new(1, 2, -2, 0);
    pub const FORCE: Self = Self::new(1, 1, -2, 0);
    pub const GRAVITATIONAL_PARAMETER: Self = Self::new(0, 3, -2, 0);
    pub const CURRENT: Self = Self::new(0, 0, 0, 0).with_current(1);
    pub const MAGNETIC_FIELD: Self = Self::new(1, 0, -2, 0).with_current(-1);
    pub const MAGNETIC_MOMENT: Self = Self::new(0, 2, 0, 0).with_current(1);
    pub const STIFFNESS: Self = Self::new(1, 2, -2, -1);
    pub const DRAG: Self = Self::new(1, 2, -1, -1);
    pub const QUADRATIC_DRAG: Self = Self::new(1, 2, 0, -2);
    pub const VISCOUS_FRICTION: Self = Self::new(1, 0, -1, 0);
}

impl Dimension {
    /// Creates the dimension kg^mass m^length s^time rad^angle.
    pub const fn new(mass: i8, length: i8, time: i8, angle: i8) -> Self {
        Self { mass, length, time, angle, current: 0 }
    }

    /// Returns the dimension with the exponent of the ampere set to `current`.
    pub const fn with_current(self, current: i8) -> Self {
        Self { current, ..self }
    }

    /// Returns `self` × `other`^power.
    pub fn times(self, other: Self, power: i8) -> Self {
        let sum = |a: i8, b: i8| a.saturating_add(b.saturating_mul(power));
        Self {
            mass: sum(self.mass, other.mass),
            length: sum(self.length, other.length),
            time: sum(self.time, other.time),
            angle: sum(self.angle, other.angle),
            current: sum(self.current, other.current),
        }
    }

    /// Returns the dimension without the angle, as used in formulas.
    pub const fn without_angle(self) -> Self {
        Self { angle: 0, ..self }
    }

    /// Returns the dimension of a formula's value with the angle restored in rates: `1/s` is an
    /// angular velocity.
    pub const fn with_angle(self) -> Self {
        match self {
            Self { mass: 0, length: 0, time: -2 | -1, current: 0, .. } => Self { angle: 1, ..self },
            _ => self.without_angle(),
        }
    }

    /// Returns `self` raised to a power; `None` if an exponent is not an integer.
    pub fn raised(self, power: f64) -> Option<Self> {
        let raised = |exponent: i8| {
            let product = f64::from(exponent) * power;
            (product.fract() == 0.0 && product.abs() < f64::from(i8::MAX)).then_some(product as i8)
        };
        Some(Self {
            mass: raised(self.mass)?,
            length: raised(self.length)?,
            time: raised(self.time)?,
            angle: raised(self.angle)?,
            current: raised(self.current)?,
        })
    }

    /// Returns the size of the unit of this dimension, from the sizes of those of mass, length and
    /// time.
    pub fn size(self, [mass, length, time]: [f64; 3]) -> f64 {
        let power = |base, exponent: i8| libm::pow(base, f64::from(exponent));
        power(mass, self.mass) * power(length, self.length) * power(time, self.time)
    }

    /// Returns true if a unit of dimension `found` is accepted where `self` is required.
    ///
    /// Angle exponents are optional where the physics permits it: one in ω (1/s), and, because L =
    /// I ω and τ = I α + ω × L, up to two in any quantity with both a mass and a rate.
    pub fn accepts(self, found: Self) -> bool {
        let rate = self.mass == 0 && self.length == 0 && self.time < 0 && self.angle == 1;
        let dynamic = self.mass != 0 && self.time < 0 && self.angle == 0 && self.current == 0;
        self == Self { angle: self.angle, ..found }
            && (self.angle == found.angle
                || rate && found.angle == 0
                || dynamic && (0..=2).contains(&found.angle))
    }

    /// Returns true if gravity turns `found` into `self`: a pound into a force, a pound foot into a
    /// torque.
    pub fn is_weight_of(self, found: Self) -> bool {
        found.mass == 1 && found.times(Self::ACCELERATION, 1) == self
    }

    /// Returns an example of a quantity of this dimension.
    pub fn example(self) -> Option<&'static str> {
        NAMES.iter().find(|(dimension, ..)| *dimension == self).map(|&(.., example)| example)
    }
}

impl Dimension {
    /// Returns the SI unit as symbols, `kg·m²/s`, and as a suffix of column names, `kg_m2_s`. Both
    /// are empty for a plain number.
    pub fn unit(self) -> (String, String) {
        if let Some((_, symbols, suffix)) = NAMED_UNITS.iter().find(|(dimension, ..)| *dimension == self) {
            return ((*symbols).to_owned(), (*suffix).to_owned());
        }
        let powers = [
            ("kg", self.mass),
            ("A", self.current),
            ("m", self.length),
            ("rad", self.angle),
            ("s", self.time),
        ];
        let raised = |unit: &str, power: u8| match power {
            1 => unit.to_owned(),
            2 => format!("{unit}²"),
            3 => format!("{unit}³"),
            _ => format!("{unit}^{power}"),
        };
        let side = |above: bool| -> Vec<String> {
            let there = powers.iter().filter(|(_, power)| if above { *power > 0 } else { *power < 0 });
            there.map(|(unit, power)| raised(unit, power.unsigned_abs())).collect()
        };
        let (above, below) = (side(true), side(false));
        let numerator = if above.is_empty() { "1".to_owned() } else { above.join("·") };
        let symbols = match &below[..] {
            [] if above.is_empty() => String::new(),
            [] => numerator,
            [one] => format!("{numerator}/{one}"),
            _ => format!("{numerator}/({})", below.join("·")),
        };
        let plain = |unit: &String| unit.replace('²', "2").replace('³', "3").replace('^', "").to_lowercase();
        (symbols, above.iter().chain(&below).map(plain).collect::<Vec<_>>().join("_"))
    }
}

/// Dimensions whose units have names of their own: symbols, and suffix of column names.
const NAMED_UNITS: [(Dimension, &str, &str); 6] = [
    (Dimension::TORQUE, "N·m", "n_m"),
    (Dimension::FORCE, "N", "n"),
    (Dimension::MAGNETIC_FIELD, "T", "t"),
    (Dimension::STIFFNESS, "N·m/rad", "n_m_rad"),
    (Dimension::DRAG, "N·m·s/rad", "n_m_s_rad"),
    (Dimension::QUADRATIC_DRAG, "N·m·s²/rad²", "n_m_s2_rad2"),
];

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((_, name, _)) = NAMES.iter().find(|(dimension, ..)| dimension == self) {
            return f.write_str(name);
        }
        f.write_str("a quantity in")?;
        [("kg", self.mass), ("m", self.length), ("s", self.time), ("rad", self.angle), ("A", self.current)]
            .into_iter()
            .filter(|&(_, power)| power != 0)
            .try_for_each(|(unit, power)| match power {
                1 => write!(f, " {unit}"),
                _ => write!(f, " {unit}^{power}"),
            })
    }
}

/// Dimension, its name with an article, and an example.
const NAMES: [(Dimension, &str, &str); 24] = [
    (Dimension::NONE, "a plain number", "0.5"),
    (Dimension::MASS, "a mass", "12 kg"),
    (Dimension::LENGTH, "a length", "25 mm"),
    (Dimension::VOLUME, "a volume", "30 cm^3"),
    (Dimension::TIME, "a time", "90 s"),
    (Dimension::ANGLE, "an angle", "30 deg"),
    (Dimension::VELOCITY, "a velocity", "3.5 m/s"),
    (Dimension::ACCELERATION, "an acceleration", "9.8 m/s^2"),
    (Dimension::ANGULAR_VELOCITY, "an angular velocity", "30 deg/s"),
    (Dimension::ANGULAR_ACCELERATION, "an angular acceleration", "0.2 rad/s^2"),
    (Dimension::DENSITY, "a density", "2700 kg/m^3"),
    (Dimension::AREA_DENSITY, "a mass per area", "5.4 kg/m^2"),
    (Dimension::LINE_DENSITY, "a mass per length", "0.3 kg/m"),
    (Dimension::INERTIA, "a moment of inertia", "4 kg m^2"),
    (Dimension::ANGULAR_MOMENTUM, "an angular momentum", "12 N m s"),
    (Dimension::TORQUE, "a torque", "0.1 N m"),
    (Dimension::FORCE, "a force", "20 N"),
    (Dimension::GRAVITATIONAL_PARAMETER, "a gravitational parameter", "398600.4418 km^3/s^2"),
    (Dimension::CURRENT, "an electric current", "0.2 A"),
    (Dimension::MAGNETIC_FIELD, "a magnetic field", "30 µT"),
    (Dimension::MAGNETIC_MOMENT, "a magnetic moment", "5 A m^2"),
    (Dimension::STIFFNESS, "a torque per angle", "0.1 N m/rad"),
    (Dimension::DRAG, "a torque per angular velocity", "0.1 N m s/rad"),
    (Dimension::QUADRATIC_DRAG, "a torque per squared angular velocity", "0.1 N m s^2/rad^2"),
];
