//! Sites of ballast.

use polhode::math::{Body, Direction, Position};

/// Site where ballast may be placed.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    pub name: String,
    /// Form and position of the site.
    pub place: Place,
    /// Largest mass at the site, kg.
    pub most: Option<f64>,
    /// Sizes of pieces, kg; empty if any mass is allowed. A point takes at most one piece, other
    /// places any number.
    pub sizes: Vec<f64>,
}

/// Form of a place, in the body. All forms except a point take several masses.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// Position of a point, m.
    Point(Position<Body>),
    /// Line from one point to another, m.
    Line([Position<Body>; 2]),
    /// Disc with its rim.
    Disc(Round),
    /// Circle: the rim of a disc.
    Circle(Round),
}

/// Circle in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// Centre of the circle, m.
    pub center: Position<Body>,
    /// Normal of its plane, of any length.
    pub normal: Direction<Body>,
    /// Radius of the circle, m.
    pub radius: f64,
}

impl Site {
    /// Returns a site for any mass.
    pub fn new(name: impl Into<String>, place: Place) -> Self {
        Self { name: name.into(), place, most: None, sizes: Vec::new() }
    }

    /// Returns the holes of a bolt circle as points, named by their numbers from 1.
    ///
    /// The holes are evenly spaced from the first direction on, right-handed about the normal.
    /// There are none if a direction is zero or along the normal.
    pub fn bolt_circle(name: &str, round: Round, first: Direction<Body>, holes: u32) -> Vec<Self> {
        let Some(n) = round.normal.direction() else { return Vec::new() };
        let Some(u) = (first - n * n.dot(first)).direction() else { return Vec::new() };
        let v = n.cross(u);
        let hole = |k: u32| {
            let (sin, cos) = libm::sincos(core::f64::consts::TAU * f64::from(k) / f64::from(holes));
            let out = (u * cos + v * sin) * round.radius;
            let at = round.center + Position::from_array(out.to_array());
            Self::new(format!("{name} {}", k + 1), Place::Point(at))
        };
        (0..holes).map(hole).collect()
    }
}
