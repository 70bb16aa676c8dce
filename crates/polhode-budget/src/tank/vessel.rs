//! Tank described by its shape: integrals over its sections up to a level, and the level of a
//! volume.
//!
//! Within a band of sections of one kind, the height above its lower end is u = ½ h (1 − cos φ).
//! Every moment of a section is then a polynomial in sin φ and cos φ of degree at most six, also at
//! round walls. Gauss's rule with [`NODES`] nodes integrates it to rounding. Nothing cancels, even
//! for very little liquid.

use core::f64::consts::PI;

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::Position;

use super::shape::{Down, TankShape};
use super::{Fill, Slice};
use crate::sequence_error::SequenceError;

const NODES: usize = 24;

/// Tank described by its shape, with a liquid of one density that has settled in one direction.
///
/// ```
/// use polhode_budget::{Down, Liquid, TankShape, Vessel};
/// // A half-full sphere: 2/3 π r³, its centre 3/8 r below the middle.
/// let sphere = Vessel::new(TankShape::Ellipsoid([0.4; 3]), 1000.0, Down::MinusZ)?;
/// let half = Liquid::Vessel(Box::new(sphere.clone())).at(0.5 * sphere.capacity()).ok_or("it holds that")?;
/// let liquid = half.properties.ok_or("there is some")?;
/// assert!((liquid.center_of_mass().z + 0.15).abs() < 1e-15 && (half.level.ok_or("it has one")? - 0.4).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Vessel {
    shape: TankShape,
    density: f64,
    down: Down,
    /// Bands of height above the bottom, m, each with its volume, m³.
    bands: Vec<([f64; 2], f64)>,
    /// Nodes and weights of Gauss's rule on 0 … 1.
    nodes: Vec<[f64; 2]>,
}

impl Vessel {
    /// Makes a tank of this shape, for a liquid of a density, kg/m³, that settles in a direction.
    ///
    /// # Errors
    /// [`SequenceError::Value`] if a size or the density is not positive and finite.
    pub fn new(shape: TankShape, density: f64, down: Down) -> Result<Self, SequenceError> {
        let is_density = density > 0.0 && density.is_finite();
        let wrong = shape.wrong().or_else(|| (!is_density).then_some(("the density of a liquid", density)));
        if let Some((what, value)) = wrong {
            return Err(SequenceError::Value { what, value, rule: "positive and finite" });
        }
        let mut vessel = Self { shape, density, down, bands: Vec::new(), nodes: gauss() };
        vessel.bands =
            shape.bands(down).into_iter().map(|band| (band, vessel.volume_of(down, band, PI))).collect();
        Ok(vessel)
    }

    /// Returns the inner shape of the tank.
    pub const fn shape(&self) -> &TankShape {
        &self.shape
    }

    /// Returns the density of the liquid, kg/m³.
    pub const fn density(&self) -> f64 {
        self.density
    }

    /// Returns the direction in which the liquid settles.
    pub const fn down(&self) -> Down {
        self.down
    }

    /// Returns the mass of a full tank, kg.
    pub fn capacity(&self) -> f64 {
        self.density * self.bands.iter().map(|(_, volume)| volume).sum::<f64>()
    }

    /// Returns the level of a mass, kg, above the bottom, m.
    ///
    /// The level in each band is found from its nearer end, because the volume hardly depends on
    /// the level near the other end. For the upper half, the tank is turned upside down.
    fn level(&self, mass: f64) -> f64 {
        let mut below = mass / self.density;
        let above = (self.capacity() - mass) / self.density;
        let Some(([_, top], _)) = self.bands.last() else { return 0.0 };
        if above <= 0.0 {
            return *top;
        }
        let upside_down = self.down.opposite();
        for (&(band, volume), turned) in self.bands.iter().zip(self.shape.bands(upside_down).iter().rev()) {
            if below <= 0.5 * volume {
                return band[0] + height(band, self.phase(self.down, band, below.max(0.0)));
            }
            let higher = self.bands.iter().filter(|(other, _)| other[0] >= band[1]);
            let empty = above - higher.map(|(_, volume)| volume).sum::<f64>();
            if empty >= 0.0 {
                return band[1] - height(*turned, self.phase(upside_down, *turned, empty.min(0.5 * volume)));
            }
            below -= volume;
        }
        *top
    }

    /// Returns the phase φ up to which a band has a volume, m³. Newton's method, safeguarded by
    /// bisection.
    fn phase(&self, down: Down, band: [f64; 2], volume: f64) -> f64 {
        if volume == 0.0 {
            return 0.0;
        }
        let [mut low, mut high] = [0.0, PI];
        let mut phi = 0.5 * PI;
        loop {
            let over = self.volume_of(down, band, phi) - volume;
            if over > 0.0 {
                high = phi;
            } else {
                low = phi;
            }
            let slope = self.shape.section(down, band[0] + height(band, phi)).area
                * 0.5
                * (band[1] - band[0])
                * libm::sin(phi);
            let newton = phi - over / slope;
            // Convergence: the step is within rounding.
            if (newton - phi).abs() <= 2.0 * f64::EPSILON * phi {
                return newton.clamp(low, high);
            }
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if next == low || next == high {
                return next;
            }
            phi = next;
        }
    }

    fn volume_of(&self, down: Down, band: [f64; 2], until: f64) -> f64 {
        let mut sum = 0.0;
        self.sections(down, [(band, until)], |_, section, weight| sum += weight * section.area);
        sum
    }

    /// Iterates over the bands below a level, each with the phase φ up to which it is filled.
    fn filled(&self, level: f64) -> impl Iterator<Item = ([f64; 2], f64)> + '_ {
        self.bands.iter().filter(move |(band, _)| level > band[0]).map(move |&(band, _)| {
            let part = ((level - band[0]) / (band[1] - band[0])).min(1.0);
            (band, 2.0 * libm::asin(part.sqrt()))
        })
    }

    /// Applies Gauss's rule over sections: calls `take` with each height, section and weight.
    fn sections(
        &self,
        down: Down,
        parts: impl IntoIterator<Item = ([f64; 2], f64)>,
        mut take: impl FnMut(f64, super::section::Section, f64),
    ) {
        for (band, until) in parts {
            for &[place, weight] in &self.nodes {
                let phi = until * place;
                let above = band[0] + height(band, phi);
                let weight = weight * until * 0.5 * (band[1] - band[0]) * libm::sin(phi);
                take(above, self.shape.section(down, above), weight);
            }
        }
    }

    pub(super) fn at(&self, mass: f64) -> Option<Fill> {
        let level = self.level(mass);
        let next = self.slice(level);
        if mass == 0.0 {
            return Some(Fill { properties: None, level: Some(0.0), next });
        }
        let (mut volume, mut first) = (0.0, [0.0; 3]);
        self.sections(self.down, self.filled(level), |above, section, weight| {
            volume += weight * section.area;
            first[0] += weight * above * section.area;
            first[1] += weight * section.first[0];
            first[2] += weight * section.first[1];
        });
        let center = first.map(|x| x / volume);
        let mut second = [0.0; 6];
        self.sections(self.down, self.filled(level), |above, section, weight| {
            for (sum, x) in second.iter_mut().zip(moments(above, section, center)) {
                *sum += weight * x;
            }
        });
        // The result has exactly the requested mass, without the rounding error of the level.
        let tensor = self.tensor(second.map(|x| mass / volume * x));
        let inertia = InertiaTensor::from_matrix(crate::tensor::rows(tensor)).ok()?;
        let properties = MassProperties::new(mass, Position::from_array(self.place(center)), inertia).ok();
        Some(Fill { properties, level: Some(level), next })
    }

    /// Returns the slice at the surface of a level, m.
    fn slice(&self, level: f64) -> Slice {
        // If the section is a single point, the first liquid is added there.
        let section = self.shape.section(self.down, level);
        if section.area == 0.0 {
            return Slice { center: self.place([level, 0.0, 0.0]), tensor: [0.0; 6] };
        }
        let [p, q] = section.first.map(|x| x / section.area);
        let center = [level, p, q];
        let tensor = self.tensor(moments(level, section, center).map(|x| x / section.area));
        Slice { center: self.place(center), tensor }
    }

    /// Converts a height and the coordinates along the two following axes to tank axes.
    fn place(&self, [above, p, q]: [f64; 3]) -> [f64; 3] {
        let (axis, up) = self.down.axis();
        let mut place = [0.0; 3];
        place[axis] = self.shape.bottom(self.down) + up * above;
        (place[(axis + 1) % 3], place[(axis + 2) % 3]) = (p, q);
        place
    }

    /// Returns the tensor from the second moments uu, pp, qq, up, uq, pq.
    fn tensor(&self, [uu, pp, qq, up, uq, pq]: [f64; 6]) -> [f64; 6] {
        let (axis, sign) = self.down.axis();
        let mut s = [[0.0; 3]; 3];
        let [u, p, q] = [axis, (axis + 1) % 3, (axis + 2) % 3];
        (s[u][u], s[p][p], s[q][q]) = (uu, pp, qq);
        for (i, j, x) in [(u, p, sign * up), (u, q, sign * uq), (p, q, pq)] {
            (s[i][j], s[j][i]) = (x, x);
        }
        [s[1][1] + s[2][2], s[0][0] + s[2][2], s[0][0] + s[1][1], -s[0][1], -s[0][2], -s[1][2]]
    }
}

/// Returns the second moments uu, pp, qq, up, uq, pq of a section at a height, about a point.
fn moments(above: f64, section: super::section::Section, [u, p, q]: [f64; 3]) -> [f64; 6] {
    let (d, area) = (above - u, section.area);
    let [fp, fq] = section.first;
    let [sp, sq] = section.second;
    let [gp, gq] = [fp - area * p, fq - area * q];
    [
        area * d * d,
        sp - 2.0 * p * fp + area * p * p,
        sq - 2.0 * q * fq + area * q * q,
        d * gp,
        d * gq,
        // about the point: ∫ (y − p)(z − q) dA, with ∫ y z dA = 0
        area * p * q - p * fq - q * fp,
    ]
}

/// Returns ½ h (1 − cos φ).
fn height([from, to]: [f64; 2], phi: f64) -> f64 {
    let s = libm::sin(0.5 * phi);
    (to - from) * s * s
}

/// Returns the nodes and weights of Gauss's rule on 0 … 1, by Newton's method on the Legendre
/// polynomial.
fn gauss() -> Vec<[f64; 2]> {
    let n = NODES as f64;
    let node = |k: usize| {
        let mut x = libm::cos(PI * (k as f64 + 0.75) / (n + 0.5));
        let mut slope = 1.0;
        for _ in 0..8 {
            let (mut p, mut before) = (x, 1.0);
            for j in 2..=NODES {
                let j = j as f64;
                (p, before) = (((2.0 * j - 1.0) * x * p - (j - 1.0) * before) / j, p);
            }
            slope = n * (x * p - before) / (x * x - 1.0);
            x -= p / slope;
        }
        [0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)]
    };
    (0..NODES).map(node).collect()
}
