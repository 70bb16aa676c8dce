//! Scenarios of bodies on the ground.

use polhode::motion::GroundContact;
use polhode::motion::contact::{
    BodySurface, Contact, ContactLaw, ContactState, Friction, Ground, GroundShape, GroundSide, Resistance,
    StartVelocity, SurfaceShape,
};
use polhode::prelude::*;

pub const G: f64 = 9.72;

pub const UP: Direction<Space> = Direction::new(0.0, 0.0, 1.0);

/// Parameters of a scenario on the ground.
#[derive(Clone, Copy)]
pub struct Setting {
    pub mass: f64,
    pub moments: [f64; 3],
    pub products: [f64; 3],
    pub shape: SurfaceShape,
    /// Centre of the surface relative to the centre of mass, m.
    pub center: [f64; 3],
    pub ground: Ground,
    pub law: ContactLaw,
    pub attitude: Attitude,
    pub omega: [f64; 3],
    pub at: Position<Space>,
    pub velocity: StartVelocity,
}

impl Setting {
    pub fn new(mass: f64, moments: [f64; 3], shape: SurfaceShape) -> Self {
        Self {
            mass,
            moments,
            products: [0.0; 3],
            shape,
            center: [0.0; 3],
            ground: Ground::LEVEL,
            law: ContactLaw::ROLLING,
            attitude: Attitude::identity(),
            omega: [0.0; 3],
            at: Position::ZERO,
            velocity: StartVelocity::Rolling,
        }
    }

    pub fn scenario(&self, title: &str, duration: f64, samples: usize) -> Scenario {
        let inertia = InertiaTensor::with_negative_products(self.moments, self.products).unwrap();
        // The centre of mass is not at the origin of the body axes.
        let origin = Position::new(0.3, -0.2, 0.1);
        let body = MassProperties::new(self.mass, origin, inertia).unwrap();
        let center = origin + Position::from_array(self.center);
        let surface = BodySurface::new(self.shape, center, Rotation::identity()).unwrap();
        let gravity = Acceleration::new(0.0, 0.0, -G);
        let contact = Contact { surface, ground: self.ground, law: self.law, gravity };
        let scenario = super::facing(Scenario::new(body).titled(title), self.attitude);
        let scenario = super::spinning(scenario, AngularVelocity::from_array(self.omega));
        let ground = GroundContact { contact, at: self.at, velocity: self.velocity };
        scenario.on_ground(ground).unwrap().sampled(super::run(duration, samples))
    }

    /// Continues from a sample of the motion.
    pub fn from(&self, sample: &ContactState) -> Self {
        Self {
            attitude: sample.state.attitude,
            omega: sample.state.omega.to_array(),
            at: sample.contact,
            velocity: StartVelocity::Along(sample.velocity),
            ..*self
        }
    }
}

/// Returns an attitude whose z axis is inclined at `angle`, rad, from the vertical, in a generic
/// direction.
pub fn leaning(angle: f64) -> Attitude {
    Rotation::<Space, Space>::from_axis_angle(UP, 0.7).unwrap()
        * Attitude::from_axis_angle(Direction::new(1.0, 0.0, 0.0), angle).unwrap()
}

pub fn dry(friction: f64) -> ContactLaw {
    ContactLaw::with_friction(Friction { sticking: friction, kinetic: friction, viscous: 0.0 }).unwrap()
}

pub fn resisted(law: ContactLaw, rolling: f64) -> ContactLaw {
    law.resisted_by(Resistance { rolling, pivoting: 0.0 }).unwrap()
}

pub fn slope(angle: f64) -> Ground {
    let normal = Direction::new(0.6 * angle.sin(), -0.8 * angle.sin(), angle.cos());
    Ground::new(GroundShape::Plane, normal).unwrap()
}

pub fn bowl(radius: f64, side: GroundSide) -> Ground {
    Ground::new(GroundShape::Sphere { radius, side }, UP).unwrap()
}

/// Ball that slips, with nearly the moment of a hollow one.
pub fn ball() -> Setting {
    let (mass, radius) = (0.31, 0.043);
    let moment = 0.53 * mass * radius * radius;
    Setting {
        law: dry(0.21),
        attitude: leaning(0.8),
        omega: [11.0, -23.0, 7.0],
        velocity: StartVelocity::Along(Velocity::new(1.3, -0.9, 0.0)),
        ..Setting::new(mass, [moment; 3], SurfaceShape::Sphere { radius })
    }
}

/// Thin rolling disk.
pub fn disk(tilt: f64, rates: [f64; 2]) -> Setting {
    let [rate, spin] = rates;
    Setting {
        attitude: leaning(tilt),
        omega: [0.0, rate * tilt.sin(), spin],
        ..Setting::new(
            0.42,
            [7.3e-4, 7.3e-4, 1.31e-3],
            SurfaceShape::Rim { radius: 0.081, tube: 0.0, thickness: 0.0 },
        )
    }
}

/// Tippe top of group II, spun with its centre of mass lowest.
pub fn tippe_top() -> Setting {
    Setting {
        center: [0.0, 0.0, 0.0041],
        law: dry(0.32),
        attitude: leaning(0.12),
        omega: [0.0, 140.0 * 0.12_f64.sin(), 140.0 * 0.12_f64.cos()],
        velocity: StartVelocity::Along(Velocity::ZERO),
        ..Setting::new(0.0163, [1.93e-6, 1.93e-6, 2.04e-6], SurfaceShape::Sphere { radius: 0.0187 })
    }
}

/// Rattleback spun against its preferred direction, with a small tilt.
pub fn rattleback(spin: f64, departure: f64) -> Setting {
    Setting {
        center: [0.0, 0.0, 0.011],
        products: [-3.1e-5, 0.0, 0.0],
        attitude: leaning(departure),
        omega: [0.0, 0.0, spin],
        ..Setting::new(
            0.9,
            [2.1e-4, 1.57e-3, 1.65e-3],
            SurfaceShape::Ellipsoid { semi_axes: [0.19, 0.031, 0.021] },
        )
    }
}

pub fn egg() -> Setting {
    let semi_axes = [0.021, 0.021, 0.028];
    Setting {
        law: dry(0.23),
        attitude: leaning(1.51),
        omega: [0.0, 160.0 * 1.51_f64.sin(), 160.0 * 1.51_f64.cos()],
        velocity: StartVelocity::Along(Velocity::ZERO),
        ..Setting::new(0.055, [1.37e-5, 1.37e-5, 1.01e-5], SurfaceShape::Ellipsoid { semi_axes })
    }
}

/// Marble in or on a bowl, which also spins about the normal.
pub fn marble(side: GroundSide) -> Setting {
    let up = if side == GroundSide::Inside { -1.0 } else { 1.0 };
    let (bowl_radius, part) = (0.37, [0.11, -0.07]);
    let [x, y]: [f64; 2] = part;
    let height = (1.0 - x * x - y * y).sqrt();
    Setting {
        ground: bowl(bowl_radius, side),
        law: ContactLaw::ROLLING,
        omega: [3.1, -1.2, 9.0],
        at: Position::new(x * bowl_radius, y * bowl_radius, up * height * bowl_radius),
        velocity: StartVelocity::Rolling,
        ..ball()
    }
}

/// Cylinder lying across a slope.
pub fn cylinder(angle: f64) -> Setting {
    let normal = Direction::<Space>::new(angle.sin(), 0.0, angle.cos());
    Setting {
        ground: Ground::new(GroundShape::Plane, normal).unwrap(),
        attitude: Attitude::from_axis_angle(Direction::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_2)
            .unwrap(),
        omega: [0.0, 0.0, -3.0],
        law: dry(0.4),
        ..Setting::new(
            0.8,
            [0.004, 0.004, 1.7e-3],
            SurfaceShape::Cylinder { radius: 0.061, length: Some(0.3) },
        )
    }
}

/// Returns scenarios of every kind, including kinds without a closed form.
pub fn all() -> Vec<Scenario> {
    let viscous = ContactLaw::with_friction(Friction { sticking: 0.0, kinetic: 0.0, viscous: 0.4 }).unwrap();
    let both = ContactLaw::with_friction(Friction { sticking: 0.2, kinetic: 0.1, viscous: 0.3 }).unwrap();
    let rolling = StartVelocity::Rolling;
    let on = |ground: Ground, setting: Setting| {
        let StartVelocity::Along(velocity) = setting.velocity else { return Setting { ground, ..setting } };
        let away = Velocity::from_array((ground.axis() * ground.axis().dot(velocity)).to_array());
        Setting { ground, velocity: StartVelocity::Along(velocity - away), ..setting }
    };
    let mut all = vec![
        ball(),
        Setting { law: both, ..ball() },
        Setting { law: viscous, ..ball() },
        Setting { law: ContactLaw::FRICTIONLESS, ..ball() },
        Setting { law: resisted(dry(0.21), 1e-3), ..ball() },
        Setting { law: resisted(ContactLaw::ROLLING, 1e-3), velocity: rolling, ..ball() },
        on(slope(0.3), ball()),
        on(slope(0.9), ball()),
        on(slope(0.3), Setting { law: viscous, ..ball() }),
        on(slope(0.3), Setting { law: ContactLaw::FRICTIONLESS, ..ball() }),
        Setting { law: ContactLaw::ROLLING, velocity: rolling, ..ball() },
        on(slope(0.3), Setting { law: dry(0.02), velocity: rolling, ..ball() }),
        on(
            Ground::LEVEL.turning_at(2.1).unwrap(),
            Setting { law: ContactLaw::ROLLING, velocity: rolling, ..ball() },
        ),
        on(
            slope(0.1).turning_at(2.1).unwrap(),
            Setting { law: ContactLaw::ROLLING, velocity: rolling, ..ball() },
        ),
        on(slope(0.1).turning_at(2.1).unwrap(), ball()),
        // Chaplygin's ball, and a ball without any symmetry.
        Setting {
            moments: [1e-4, 2e-4, 2.5e-4],
            products: [1e-5, 0.0, -2e-5],
            law: ContactLaw::ROLLING,
            velocity: rolling,
            ..ball()
        },
        Setting { moments: [1e-4, 2e-4, 2.5e-4], center: [0.01, 0.003, -0.005], ..ball() },
        disk(1.1, [2.0, -13.0]),
        disk(0.3, [44.0, 0.0]),
        disk(std::f64::consts::FRAC_PI_2, [0.0, -9.0]),
        disk(1.5, [0.0, -9.0]),
        disk(1.0, [0.0, 0.0]),
        Setting { law: resisted(ContactLaw::ROLLING, 2e-4), ..disk(0.3, [44.0, 0.0]) },
        Setting { law: ContactLaw::FRICTIONLESS, ..disk(1.1, [2.0, -13.0]) },
        Setting { law: dry(0.1), velocity: StartVelocity::Along(Velocity::ZERO), ..disk(1.1, [2.0, -13.0]) },
        Setting {
            shape: SurfaceShape::Rim { radius: 0.081, tube: 0.01, thickness: 0.0 },
            ..disk(1.1, [2.0, -13.0])
        },
        Setting {
            shape: SurfaceShape::Rim { radius: 0.081, tube: 0.0, thickness: 0.02 },
            ..disk(0.4, [30.0, 1.0])
        },
        Setting { moments: [7.3e-4, 6.1e-4, 1.31e-3], ..disk(1.1, [2.0, -13.0]) },
        on(slope(0.2), disk(1.1, [2.0, -13.0])),
        tippe_top(),
        Setting { law: viscous, ..tippe_top() },
        Setting { law: ContactLaw::ROLLING, velocity: rolling, ..tippe_top() },
        Setting { law: ContactLaw::FRICTIONLESS, ..tippe_top() },
        Setting { moments: [1.2e-6, 1.2e-6, 2.04e-6], ..tippe_top() },
        Setting { moments: [3.1e-6, 3.1e-6, 2.04e-6], ..tippe_top() },
        Setting { moments: [1.93e-6, 1.7e-6, 2.04e-6], ..tippe_top() },
        on(slope(0.2), tippe_top()),
        rattleback(-4.0, 0.01),
        rattleback(4.0, 0.01),
        Setting {
            law: ContactLaw::FRICTIONLESS,
            velocity: StartVelocity::Along(Velocity::ZERO),
            ..rattleback(4.0, 0.01)
        },
        Setting { center: [0.0, 0.0, -0.005], ..rattleback(4.0, 0.01) },
        rattleback(4.0, 1.0),
        Setting { products: [0.0; 3], ..rattleback(40.0, 0.01) },
        egg(),
        Setting { law: ContactLaw::ROLLING, velocity: rolling, ..egg() },
        Setting { law: ContactLaw::FRICTIONLESS, ..egg() },
        Setting { attitude: leaning(0.02), omega: [0.0, 0.0, 60.0], velocity: rolling, ..egg() },
        Setting { shape: SurfaceShape::Ellipsoid { semi_axes: [0.028, 0.028, 0.019] }, ..egg() },
        on(slope(0.2), egg()),
        on(
            bowl(0.4, GroundSide::Inside),
            Setting {
                at: Position::new(0.0, 0.0, -0.4),
                law: ContactLaw::ROLLING,
                velocity: rolling,
                ..egg()
            },
        ),
        marble(GroundSide::Inside),
        marble(GroundSide::Outside),
        Setting {
            law: dry(0.2),
            velocity: StartVelocity::Along(Velocity::ZERO),
            ..marble(GroundSide::Inside)
        },
        cylinder(0.0),
        cylinder(0.2),
        Setting { velocity: StartVelocity::Along(Velocity::ZERO), ..cylinder(0.0) },
        Setting { velocity: StartVelocity::Along(Velocity::new(0.0, 0.3, 0.0)), ..cylinder(0.0) },
        Setting { center: [0.01, 0.0, 0.0], ..cylinder(0.2) },
    ];
    let pipe = GroundShape::Cylinder { radius: 0.3, side: GroundSide::Inside };
    let pipe = Ground::new(pipe, Direction::new(0.0, 1.0, 0.0)).unwrap();
    let low = 0.3 * 0.2_f64.cos();
    all.push(Setting {
        ground: pipe,
        at: Position::new(0.3 * 0.2_f64.sin(), 0.0, -low),
        law: ContactLaw::ROLLING,
        ..cylinder(0.0)
    });
    let scenarios =
        all.iter().enumerate().map(|(k, setting)| setting.scenario(&format!("On the ground {k}"), 0.2, 5));
    let scenarios: Vec<Scenario> = scenarios.collect();
    let still = ball().scenario("Without a run", 0.2, 5).not_sampled();
    scenarios.into_iter().chain([still]).collect()
}
