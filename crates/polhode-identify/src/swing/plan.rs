//! Plan of swing tests of one body.

use super::hung_mass::{Fixture, HungMass, Placement};
use super::measurement::Measurement;
use super::number::{GRAVITY, Linear, MASS, Measured, NumberId, Numbers, TENSOR};
use super::rig::{Load, Oscillator, Rig};
use crate::coordinates::{Coordinates, Part};
use crate::error::IdentifyError;
use crate::six::{ELEMENTS, between};

/// Swing tests of one body, and the numbers that they share.
///
/// ```
/// use polhode::math::{Attitude, Body, Direction, Rotation, Space};
/// use polhode_identify::swing::{Counted, Measured, Measurement, Placement, Rig};
/// use polhode_identify::swing::{SwingPlan, SwingTest, Wires, identify_swings};
///
/// let mut plan = SwingPlan::new(Measured::new(3.2, 0.001), [Measured::exact(0.0); 3]);
/// let radius = plan.number("wire radius", "m", Measured::new(0.15, 0.2e-3));
/// let length = plan.number("wire length", "m", Measured::new(1.2, 0.5e-3));
/// let rig = Rig::Wires(Wires::bifilar(radius, radius, length));
/// // 50 swings took 103.2 s, while the amplitude fell from 0.31 to 0.26 rad
/// let swings = Measurement::Counted(Counted::new(50.0, (103.2, 0.2), [0.31, 0.26], 0.005));
/// plan.add(SwingTest::new("about z", Placement::AS_IT_IS, rig, swings));
///
/// let found = identify_swings(&plan)?;
/// let z = found.tests[0].moment.as_ref().unwrap();
/// assert!((z.value - 0.06285).abs() < 5e-5 && z.sd.unwrap() < 4e-4, "{z:?}");
/// // one axis says nothing of the others
/// assert_eq!(found.estimate.get("Izz").unwrap().sd, z.sd);
/// assert_eq!(found.estimate.get("Ixx").unwrap().sd, None);
/// assert_eq!(found.estimate.unknown.len(), 5);
/// # Ok::<(), polhode_identify::IdentifyError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SwingPlan {
    mass: Measured,
    center: [Measured; 3],
    gravity: Measured,
    numbers: Vec<(String, &'static str, Measured)>,
    pub(super) tests: Vec<SwingTest>,
}

/// One swing test.
#[derive(Clone, Debug, PartialEq)]
pub struct SwingTest {
    /// Name of the test.
    pub name: String,
    /// Placement of the body in the rig; `None` for a test of the rig without the body.
    pub body: Option<Placement>,
    /// Object that moves with the body, if any.
    pub fixture: Option<Fixture>,
    /// Suspension of the body.
    pub rig: Rig,
    /// Effects of the air other than damping.
    pub air: Air,
    /// Readings of the swing.
    pub measurement: Measurement,
}

/// Stated corrections for the air other than damping; they have an error if they depend on a number
/// of the plan.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Air {
    /// Added moment of inertia of the moving air about the axis of the swing, kg·m²; default 0.
    pub moment: Linear,
    /// Mass of the displaced air, kg, which reduces the weight; default 0.
    pub displaced: Linear,
}

impl SwingTest {
    /// Creates a test of the body alone, without corrections for the air.
    pub fn new(name: impl Into<String>, body: Placement, rig: Rig, measurement: Measurement) -> Self {
        Self { name: name.into(), body: Some(body), fixture: None, rig, air: Air::default(), measurement }
    }

    pub(super) fn oscillator(&self, numbers: &Numbers) -> Result<Box<dyn Oscillator>, IdentifyError> {
        let body = self.body.as_ref().map(|placement| HungMass::of_body(numbers, placement));
        let fixture = self.fixture.as_ref().map(|fixture| HungMass::of_fixture(numbers, fixture));
        let mass = match (body, fixture) {
            (Some(body), Some(fixture)) => body.joined(&fixture),
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => {
                return Err(IdentifyError::TooFew { what: "bodies in a rig", given: 0, needed: 1 });
            }
        };
        IdentifyError::above_zero("the mass in a rig", mass.mass.value)?;
        let heavy = mass.mass.minus(&numbers.linear(&self.air.displaced));
        let weight = heavy.times(numbers.at(GRAVITY));
        IdentifyError::above_zero("the weight less the buoyancy", weight.value)?;
        let mass = mass.with_moment(self.rig.axis(), &numbers.linear(&self.air.moment));
        self.rig.oscillator(numbers, &Load { mass, weight })
    }

    /// Returns the derivatives of nᵀ I n by the tensor's elements, with n the axis of the swing in
    /// body axes.
    pub(super) fn moment_gradient(&self) -> Option<[f64; 6]> {
        let r = self.body?.rotation.matrix();
        let axis = self.rig.axis();
        let n = [0, 1, 2].map(|j| (0..3).map(|i| r[i][j] * axis[i]).sum::<f64>());
        Some(between(n, n))
    }
}

/// Standard gravity, m/s².
const STANDARD: f64 = 9.80665;

impl SwingPlan {
    /// Creates a plan for a body with its measured mass (kg) and centre of mass (m). Gravity is
    /// exactly the standard value; [`SwingPlan::with_gravity`] changes it.
    pub fn new(mass: Measured, center: [Measured; 3]) -> Self {
        Self { mass, center, gravity: Measured::exact(STANDARD), numbers: Vec::new(), tests: Vec::new() }
    }

    /// Sets the measured gravity, m/s².
    #[must_use]
    pub fn with_gravity(mut self, gravity: Measured) -> Self {
        self.gravity = gravity;
        self
    }

    /// Adds a number that rigs may share, such as a radius, a length or a stiffness, and returns
    /// its identifier.
    pub fn number(&mut self, name: impl Into<String>, unit: &'static str, measured: Measured) -> NumberId {
        self.numbers.push((name.into(), unit, measured));
        NumberId(self.numbers.len() - 1)
    }

    /// Adds one test.
    pub fn add(&mut self, test: SwingTest) {
        self.tests.push(test);
    }

    /// Returns the plan with other tests.
    pub(super) fn with_tests(&self, tests: Vec<SwingTest>) -> Self {
        Self { tests, ..self.clone() }
    }

    /// Returns the tests in order.
    pub fn tests(&self) -> &[SwingTest] {
        &self.tests
    }

    /// Returns all numbers as measured; the elements of the tensor are unknown.
    pub(super) fn measured(&self) -> Vec<Measured> {
        let mut all = vec![self.mass];
        all.extend(self.center);
        all.extend([Measured::unknown(0.0); 6]);
        all.push(self.gravity);
        all.extend(self.numbers.iter().map(|(_, _, measured)| *measured));
        all
    }

    /// Returns the name and unit of each number.
    pub(super) fn names(&self) -> Vec<(String, &'static str)> {
        let mut all = vec![("mass".to_owned(), "kg")];
        all.extend(["x", "y", "z"].map(|axis| (format!("center {axis}"), "m")));
        all.extend(ELEMENTS.map(|element| (format!("I{element}"), "kg·m²")));
        all.push(("gravity".to_owned(), "m/s²"));
        all.extend(self.numbers.iter().map(|(name, unit, _)| (name.clone(), *unit)));
        all
    }

    /// Returns an entry for each measured number with an error, in order. It is the name and half
    /// the value in standard deviations if the number is a length of the plan, and `None`
    /// otherwise.
    pub(super) fn lengths(&self) -> impl Iterator<Item = Option<(&str, f64)>> {
        let is_measured = |measured: &Measured| measured.sd > 0.0 && measured.sd.is_finite();
        let body = [self.mass].into_iter().chain(self.center).chain([self.gravity]);
        let body = body.filter(is_measured).map(|_| None);
        let own = self.numbers.iter().filter(move |(_, _, measured)| is_measured(measured));
        body.chain(own.map(|(name, unit, measured)| {
            let is_length = *unit == "m" && measured.value > 0.0;
            is_length.then(|| (name.as_str(), 0.5 * measured.value / measured.sd))
        }))
    }

    pub(super) fn check(&self) -> Result<(), IdentifyError> {
        for (k, Measured { value, sd }) in self.measured().into_iter().enumerate() {
            if k == MASS || k == GRAVITY {
                IdentifyError::require("a mass or gravity", value, value > 0.0, "above zero, and finite")?;
            }
            IdentifyError::require("a measured number", value, true, "finite")?;
            if !(sd >= 0.0) {
                return Err(IdentifyError::Value {
                    what: "the standard deviation of a measured number",
                    value: sd,
                    rule: "zero or more",
                });
            }
        }
        if self.tests.is_empty() {
            return Err(IdentifyError::TooFew { what: "swing tests", given: 0, needed: 1 });
        }
        for test in &self.tests {
            test.check(self.numbers.len())?;
        }
        Ok(())
    }

    /// Returns the coordinates of the estimated parameters, in order.
    pub(super) fn coordinates(&self) -> Coordinates {
        let mut parts = Vec::new();
        for (k, measured) in self.measured().into_iter().enumerate() {
            match k {
                TENSOR => parts.push(Part::RootedTensor),
                _ if k > TENSOR && k < TENSOR + 6 => {}
                _ if measured.sd == 0.0 => {}
                MASS => parts.push(Part::Positive),
                _ => parts.push(Part::Free(1)),
            }
        }
        Coordinates::new(parts)
    }

    /// Returns the index of each number among the estimated parameters; `None` for exact numbers.
    pub(super) fn places(&self) -> Vec<Option<usize>> {
        let mut next = 0;
        let place = |measured: Measured| {
            (measured.sd != 0.0).then(|| {
                next += 1;
                next - 1
            })
        };
        self.measured().into_iter().map(place).collect()
    }
}

impl SwingTest {
    fn check(&self, count: usize) -> Result<(), IdentifyError> {
        self.rig.check(count)?;
        let fixture = self
            .fixture
            .iter()
            .flat_map(|fixture| [&fixture.mass].into_iter().chain(&fixture.center.0).chain(&fixture.inertia));
        super::rig::all_of(fixture.chain([&self.air.moment, &self.air.displaced]), count)
    }
}
