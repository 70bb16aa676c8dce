//! Where ballast may be.

use polhode::math::{Body, Direction, Position};

/// A place for ballast.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// What to call it.
    pub name: String,
    /// Where it is.
    pub place: Place,
    /// The most mass that it takes, kg.
    pub most: Option<f64>,
    /// The masses that pieces have, kg: a point takes one or none, other places any number. Without, any mass.
    pub sizes: Vec<f64>,
}

/// The form of a place, in the body. Of all but a point, several masses may be in it.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// A point, m.
    Point(Position<Body>),
    /// A line from one point to another, m.
    Line([Position<Body>; 2]),
    /// A disc.
    Disc(Round),
    /// A circle: the rim of a disc.
    Circle(Round),
}

/// A circle in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// Its middle, m.
    pub center: Position<Body>,
    /// A direction across its plane, of any length.
    pub normal: Direction<Body>,
    /// m
    pub radius: f64,
}

impl Site {
    /// Any mass at a place.
    pub fn new(name: impl Into<String>, place: Place) -> Self {
        Self { name: name.into(), place, most: None, sizes: Vec::new() }
    }

    /// The holes of a bolt circle, each a point, evenly from a direction on, right-handed about the normal, named by their numbers from 1. None if a direction is zero or along the normal.
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
