//! The figures of a motion: which there are, and each on a sheet.

use polhode::motion::{FreeMotion, Regime, Scenario, Trajectory};

use super::axes::{Area, heading};
use super::axis_path::TopAxis;
use super::error::PlotError;
use super::figure::Figure;
use super::plotted::PlottedMotion;
use super::sheet::{Anchor, Colour, LARGE, Mark, Sheet, Text};
use super::{Picture, axis_path, drift, euler, plane, series, sphere, wheels};
use crate::balance::Driven;
use crate::layout::printable;

/// A motion, ready to be drawn.
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, State, Trajectory};
/// use polhode_report::{Figure, MotionFigures};
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.01) };
/// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
/// let times: Vec<f64> = (0..=400).map(|k| 0.1 * f64::from(k)).collect();
/// let trajectory = Trajectory::of_motion(motion, &times)?;
/// let figures = MotionFigures::of_motion("a book", &motion, &trajectory);
/// let svg = figures.draw(Figure::Omega)?.to_svg();
/// assert!(svg.starts_with("<svg ") && svg.contains("rad/s"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct MotionFigures<'a> {
    pub(super) motion: PlottedMotion<'a>,
    /// Of a body that gravity turns about a pivot.
    axis: Option<TopAxis>,
}

impl<'a> MotionFigures<'a> {
    /// Those of a scenario's motion; `trajectory` is what [`Scenario::simulate`] found.
    pub fn of_scenario(scenario: &Scenario, trajectory: &'a Trajectory) -> Self {
        let rotor = scenario.rotor();
        let driven = Driven::of(scenario);
        let motion = PlottedMotion {
            title: printable(scenario.title().unwrap_or_default()),
            trajectory,
            principal: *rotor.principal(),
            free: FreeMotion::of(rotor, scenario.start()).ok().filter(|_| !driven.at_all()),
            driven,
            wheels: crate::torque::named_wheels(scenario),
            pointings: series::pointings(scenario),
        };
        Self { motion, axis: TopAxis::of(scenario, rotor) }
    }

    /// Those of a free motion; `trajectory` is the same motion at some times.
    pub fn of_motion(title: &str, motion: &FreeMotion, trajectory: &'a Trajectory) -> Self {
        let motion = PlottedMotion {
            title: printable(title),
            trajectory,
            principal: *motion.principal(),
            free: Some(*motion),
            driven: Driven::default(),
            wheels: Vec::new(),
            pointings: Vec::new(),
        };
        Self { motion, axis: None }
    }

    /// The figures that this motion has, in the order in which they are read.
    pub fn figures(&self) -> Vec<Figure> {
        Figure::ALL.into_iter().filter(|figure| self.why_not(*figure).is_none()).collect()
    }

    /// One figure, 7 in wide.
    ///
    /// # Errors
    /// [`PlotError`] for a figure that this motion does not have, for fewer than two samples, and for a curve with too many
    /// points.
    pub fn draw(&self, figure: Figure) -> Result<Picture, PlotError> {
        const MARGIN: f64 = 14.0;
        let mut sheet = Sheet::new(672.0, 413.0, self.spoken(figure.title(&self.motion)));
        let area = Area { left: MARGIN, top: MARGIN, right: 672.0 - MARGIN, bottom: 413.0 - MARGIN };
        self.panel(figure, &mut sheet, area, &self.motion.title)?;
        Ok(Picture { sheet })
    }

    /// All figures that this motion has, two beside each other, but for a torque that is zero throughout.
    ///
    /// # Errors
    /// As [`MotionFigures::draw`], but a curve with too many points, and angles that cannot be followed, are left out.
    pub fn overview(&self) -> Result<Picture, PlotError> {
        let mut wanted = self.figures();
        wanted.retain(|figure| {
            *figure != Figure::Torque || !series::panel(&self.motion, Figure::Torque).is_zero()
        });
        let drawn = |figure: &Figure| {
            !matches!(self.draw(*figure), Err(PlotError::Curve { .. } | PlotError::TooCoarse { .. }))
        };
        let figures: Vec<Figure> = wanted.into_iter().filter(drawn).collect();
        self.side_by_side(&figures)
    }

    /// Some figures, two beside each other, on one sheet.
    ///
    /// # Errors
    /// As [`MotionFigures::draw`].
    pub fn side_by_side(&self, figures: &[Figure]) -> Result<Picture, PlotError> {
        const PANEL: [f64; 2] = [448.0, 322.0];
        const MARGIN: f64 = 16.0;
        let head = if self.motion.title.is_empty() { 0.0 } else { 26.0 };
        let rows = figures.len().div_ceil(2);
        let (width, height) = (2.0 * PANEL[0], head + rows as f64 * PANEL[1]);
        let mut sheet = Sheet::new(width, height, self.spoken("motion"));
        if head > 0.0 {
            let room = width - 2.0 * MARGIN;
            let title = super::font::fitted(&self.motion.title, LARGE + 2.0, room);
            let text = Text::small([MARGIN, 26.0], Anchor::Start, Colour::BLACK, &title);
            sheet.marks.push(Mark::Text(Text { size: LARGE + 2.0, ..text }));
        }
        for (k, figure) in figures.iter().enumerate() {
            let (row, column) = ((k / 2) as f64, (k % 2) as f64);
            let last_alone = k + 1 == figures.len() && k % 2 == 0;
            let left = column * PANEL[0];
            let area = Area {
                left: left + MARGIN,
                top: head + row * PANEL[1] + MARGIN,
                right: left + if last_alone { 2.0 } else { 1.0 } * PANEL[0] - MARGIN,
                bottom: head + (row + 1.0) * PANEL[1] - 4.0,
            };
            self.panel(*figure, &mut sheet, area, "")?;
        }
        Ok(Picture { sheet })
    }

    /// Draws a figure into a part of a sheet.
    fn panel(&self, figure: Figure, sheet: &mut Sheet, area: Area, subject: &str) -> Result<(), PlotError> {
        if let Some(why) = self.why_not(figure) {
            return Err(PlotError::NotThere { figure, why });
        }
        let count = self.motion.samples().len();
        let on_time = !matches!(figure, Figure::Polhodes | Figure::Herpolhode);
        if on_time && count < 2 {
            return Err(PlotError::TooFewSamples { count });
        }
        let keyed = |sheet: &mut Sheet, keys: &[_]| {
            area.below(heading(sheet, area, figure.title(&self.motion), subject, keys))
        };
        match (figure, &self.motion.free) {
            (Figure::Drift, _) => drift::draw(&self.motion, sheet, &keyed),
            (Figure::Euler, _) => euler::draw(&self.motion, sheet, &keyed)?,
            (Figure::Wheels, _) => wheels::draw(&self.motion, sheet, area.width(), &keyed),
            (Figure::Axis, _) => {
                if let Some(axis) = &self.axis {
                    axis_path::draw(&self.motion, axis, sheet, &keyed)?;
                }
            }
            (Figure::Polhodes, Some(motion)) => {
                sphere::draw(motion, sheet, &keyed).map_err(|error| PlotError::Curve { figure, error })?;
            }
            (Figure::Herpolhode, Some(motion)) => {
                plane::draw(motion, self.motion.duration(), sheet, &keyed)
                    .map_err(|error| PlotError::Curve { figure, error })?;
            }
            _ => series::draw(&self.motion, figure, sheet, area.width(), &keyed),
        }
        Ok(())
    }

    /// Why there is no such figure of this motion, if there is none.
    fn why_not(&self, figure: Figure) -> Option<&'static str> {
        match (figure, &self.motion.free) {
            (Figure::Torque, _) if !self.motion.driven.by_torques => Some("no torque acts on the body"),
            (Figure::Wheels, _) if self.motion.wheels.is_empty() => Some("the body has no wheels"),
            (Figure::Pointing, _) if self.motion.pointings.is_empty() => {
                Some("there is neither an [orbit] nor a [[pointing]]")
            }
            (Figure::Axis, _) if self.axis.is_none() => {
                Some("it is that of a body which gravity turns about a pivot")
            }
            (Figure::Drift, _) if self.motion.is_prescribed() => {
                Some("the motion is prescribed: nothing is solved, and nothing drifts")
            }
            (Figure::Polhodes | Figure::Herpolhode, None) if self.motion.is_prescribed() => {
                Some("the motion is prescribed, not free: it has no polhode")
            }
            (Figure::Polhodes | Figure::Herpolhode, None) => {
                Some("a torque acts on the body: it has no polhode")
            }
            (Figure::Polhodes | Figure::Herpolhode, Some(motion)) => match motion.regime() {
                Regime::AtRest => Some("the body is at rest"),
                Regime::Permanent(_) if figure == Figure::Herpolhode => {
                    Some("ω lies along L and stays there: its path on the plane is a point")
                }
                _ => None,
            },
            _ => None,
        }
    }

    fn spoken(&self, figure: &str) -> String {
        if self.motion.title.is_empty() {
            figure.to_owned()
        } else {
            format!("{}: {figure}", self.motion.title)
        }
    }
}

impl Figure {
    /// What stands above it.
    fn title(self, motion: &PlottedMotion<'_>) -> &'static str {
        match self {
            Self::Omega => "Angular velocity along the principal axes",
            Self::Euler => "Euler angles, 3-1-3",
            Self::Pointing => "Where the body points",
            Self::Energy if motion.driven.at_all() => "Energy",
            Self::Energy => "Kinetic energy, and its parts along the principal axes",
            Self::Momentum if !motion.wheels.is_empty() => "Angular momentum in space, wheels included",
            Self::Momentum if motion.driven.at_all() => "Angular momentum in space",
            Self::Momentum => "Angular momentum along the principal axes",
            Self::Torque if motion.is_prescribed() => "Torque that the motion needs, in body axes",
            Self::Torque => "Torque in body axes",
            Self::Drift => "Drift: a dot for each sample, a line for the largest so far",
            Self::Polhodes => "Angular momentum in the body",
            Self::Axis => "Path of the axis in space",
            Self::Wheels => "Wheels along their axes",
            Self::Herpolhode => "Herpolhode: ω on the invariable plane",
        }
    }
}
