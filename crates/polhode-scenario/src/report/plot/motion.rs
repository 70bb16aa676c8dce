//! Figures of a motion: the list of those that apply, and their drawings.

use polhode::motion::{FreeMotion, MethodReason, Regime, Scenario, Trajectory};
use polhode_document::Picture;
use polhode_document::figure::axes::Area;
use polhode_document::figure::legend::{Key, heading};
use polhode_document::figure::sheet::{Anchor, Colour, LARGE, Mark, Sheet, Text};
use polhode_document::layout::printable;

use super::axis_path::TopAxis;
use super::chart::Chart;
use super::error::PlotError;
use super::figure::Figure;
use super::plotted::PlottedMotion;
use super::{axis_path, drift, euler, plane, series, sphere, wheels};
use crate::report::balance::Driven;

/// Figures of a motion.
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, State, Trajectory};
/// use polhode_scenario::report::{Figure, MotionFigures};
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
    pub(crate) motion: PlottedMotion<'a>,
    /// Axis of a body that gravity turns about a pivot; `None` for other bodies.
    axis: Option<TopAxis>,
}

impl<'a> MotionFigures<'a> {
    /// Creates the figures of a scenario's motion; `trajectory` is the result of
    /// [`Scenario::simulate`].
    pub fn of_scenario(scenario: &Scenario, trajectory: &'a Trajectory) -> Self {
        let rotor = scenario.rotor();
        let driven = Driven::of(scenario);
        let motion = PlottedMotion {
            title: printable(scenario.title().unwrap_or_default()),
            trajectory,
            principal: *rotor.principal(),
            free: FreeMotion::of(rotor, scenario.start()).ok().filter(|_| !driven.at_all()),
            driven,
            wheels: crate::report::torque::named_wheels(scenario),
            pointings: series::pointings(scenario),
        };
        Self { motion, axis: TopAxis::of(scenario, rotor) }
    }

    /// Creates the figures of a free motion; `trajectory` has samples of it.
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

    /// Returns the figures that apply to this motion, in the order of [`Figure::ALL`].
    pub fn figures(&self) -> Vec<Figure> {
        Figure::ALL.into_iter().filter(|figure| self.why_not(*figure).is_none()).collect()
    }

    /// Draws one figure, 672 px (7 in) wide.
    ///
    /// # Errors
    /// [`PlotError`] for a figure that does not apply to this motion, for fewer than two samples,
    /// and for a curve with too many points.
    pub fn draw(&self, figure: Figure) -> Result<Picture, PlotError> {
        const MARGIN: f64 = 14.0;
        const WIDTH: f64 = 672.0;
        /// Height without the margins.
        const HEIGHT: f64 = 385.0;
        let content = self.content(figure)?;
        let content = match content {
            Content::Chart(chart) => Content::Chart(chart.naming_events(true)),
            other => other,
        };
        let height = self.height(figure, &content, WIDTH - 2.0 * MARGIN, HEIGHT);
        let mut sheet =
            Sheet::new(WIDTH, (height + 2.0 * MARGIN).ceil(), self.spoken(figure.title(&self.motion)));
        let area = Area { left: MARGIN, top: MARGIN, right: WIDTH - MARGIN, bottom: MARGIN + height };
        self.panel(figure, &content, &mut sheet, area, &self.motion.title)?;
        Ok(Picture { sheet })
    }

    /// Draws all figures that apply to this motion, in two columns; a torque that is always zero is
    /// omitted.
    ///
    /// # Errors
    /// Same as [`MotionFigures::draw`], except for curves with too many points and angles that
    /// cannot be followed. For these the sheet contains the reason instead of the figure.
    pub fn overview(&self) -> Result<Picture, PlotError> {
        let mut cells = Vec::new();
        for figure in self.figures() {
            let content = match self.draw(figure) {
                Err(error @ (PlotError::Curve { .. } | PlotError::TooCoarse { .. })) => {
                    Content::Refused(error.to_string())
                }
                Err(error) => return Err(error),
                Ok(_) => self.content(figure)?,
            };
            let is_zero = matches!(&content, Content::Chart(chart) if chart.is_zero());
            if figure != Figure::Torque || !is_zero {
                cells.push((figure, content));
            }
        }
        self.beside_each_other(cells)
    }

    /// Draws these figures in two columns; those with words alone come last.
    ///
    /// # Errors
    /// Same as [`MotionFigures::draw`].
    pub fn side_by_side(&self, figures: &[Figure]) -> Result<Picture, PlotError> {
        let cells = figures.iter().map(|&figure| Ok((figure, self.content(figure)?)));
        self.beside_each_other(cells.collect::<Result<_, PlotError>>()?)
    }

    fn beside_each_other(&self, cells: Vec<(Figure, Content<'_>)>) -> Result<Picture, PlotError> {
        const WIDTH: f64 = 448.0;
        const HEIGHT: f64 = 302.0;
        const MARGIN: f64 = 16.0;
        const BELOW: f64 = 4.0;
        let named = |(figure, content)| match content {
            Content::Chart(chart) => {
                let names_events = matches!(figure, Figure::Omega | Figure::Pointing);
                (figure, Content::Chart(chart.naming_events(names_events)))
            }
            other => (figure, other),
        };
        let cells = cells.into_iter().map(named);
        let (words, drawn): (Vec<_>, Vec<_>) = cells.partition(|(_, content)| content.is_words());
        let head = if self.motion.title.is_empty() { 0.0 } else { 26.0 };
        let mut sheet = Sheet::new(2.0 * WIDTH, head, self.spoken("motion"));
        if head > 0.0 {
            let room = sheet.width - 2.0 * MARGIN;
            let title = polhode_document::figure::font::fitted(&self.motion.title, LARGE + 2.0, room);
            let text = Text::small([MARGIN, 26.0], Anchor::Start, Colour::BLACK, &title);
            sheet.marks.push(Mark::Text(Text { size: LARGE + 2.0, ..text }));
        }
        for row in drawn.chunks(2).chain(words.chunks(2)) {
            let top = sheet.height + MARGIN;
            // A single figure in a row has the full width.
            let width = if row.len() == 1 { 2.0 * WIDTH } else { WIDTH };
            let heights = row
                .iter()
                .map(|(figure, content)| self.height(*figure, content, width - 2.0 * MARGIN, HEIGHT));
            let height = heights.fold(0.0, f64::max);
            for (k, (figure, content)) in row.iter().enumerate() {
                let left = k as f64 * width;
                let area =
                    Area { left: left + MARGIN, top, right: left + width - MARGIN, bottom: top + height };
                self.panel(*figure, content, &mut sheet, area, "")?;
            }
            sheet.height = (top + height + BELOW).ceil();
        }
        sheet.height += if words.is_empty() { 0.0 } else { MARGIN - BELOW };
        Ok(Picture { sheet })
    }

    /// Returns the content of a figure.
    fn content(&self, figure: Figure) -> Result<Content<'_>, PlotError> {
        if let Some(why) = self.why_not(figure) {
            return Err(PlotError::NotThere { figure, why });
        }
        let count = self.motion.samples().len();
        if !matches!(figure, Figure::Polhodes | Figure::Herpolhode) && count < 2 {
            return Err(PlotError::TooFewSamples { count });
        }
        Ok(match figure {
            Figure::Drift | Figure::Axis | Figure::Polhodes | Figure::Herpolhode => Content::Own,
            Figure::Euler => Content::Chart(euler::chart(&self.motion)?),
            Figure::Wheels => Content::Chart(Chart::new(&self.motion, wheels::quantities(&self.motion))),
            _ => Content::Chart(Chart::new(&self.motion, vec![series::quantity(&self.motion, figure)])),
        })
    }

    /// Returns the height of a figure of this width, px; `usual` for most figures.
    fn height(&self, figure: Figure, content: &Content<'_>, width: f64, usual: f64) -> f64 {
        /// Height of a heading of two lines.
        const HEADING: f64 = 44.0;
        let mut scratch = Sheet::new(width, usual, String::new());
        let area = Area { left: 0.0, top: 0.0, right: width, bottom: usual };
        let mut with_keys = |keys: &[Key]| heading(&mut scratch, area, figure.title(&self.motion), "", keys);
        match content {
            Content::Chart(chart) => with_keys(&chart.keys()) + chart.height(usual - HEADING),
            Content::Refused(why) => with_keys(&[Key::words(why)]),
            Content::Own => usual,
        }
    }

    /// Draws a figure into an area of a sheet.
    fn panel(
        &self,
        figure: Figure,
        content: &Content<'_>,
        sheet: &mut Sheet,
        area: Area,
        subject: &str,
    ) -> Result<(), PlotError> {
        let keyed = |sheet: &mut Sheet, keys: &[_]| {
            area.below(heading(sheet, area, figure.title(&self.motion), subject, keys))
        };
        match (content, figure, &self.motion.free) {
            (Content::Chart(chart), ..) => chart.draw(sheet, &keyed),
            (Content::Refused(why), ..) => {
                keyed(sheet, &[Key::words(why)]);
            }
            (Content::Own, Figure::Axis, _) => {
                if let Some(axis) = &self.axis {
                    axis_path::draw(&self.motion, axis, sheet, &keyed)?;
                }
            }
            (Content::Own, Figure::Polhodes, Some(motion)) => {
                sphere::draw(motion, sheet, &keyed).map_err(|error| PlotError::Curve { figure, error })?;
            }
            (Content::Own, Figure::Herpolhode, Some(motion)) => {
                plane::draw(motion, self.motion.duration(), sheet, &keyed)
                    .map_err(|error| PlotError::Curve { figure, error })?;
            }
            (Content::Own, ..) => drift::draw(&self.motion, sheet, &keyed),
        }
        Ok(())
    }

    /// Returns the reason why a figure does not apply to this motion; `None` if it applies.
    fn why_not(&self, figure: Figure) -> Option<&'static str> {
        match (figure, &self.motion.free) {
            (Figure::Torque, _) if !self.motion.driven.by_torques => Some("no torque acts on the body"),
            (Figure::Wheels, _) if self.motion.wheels.is_empty() => Some("the body has no wheels"),
            (Figure::Pointing, _) if self.motion.pointings.is_empty() => {
                Some("there is neither an [orbit] nor a [[pointing]]")
            }
            (Figure::Axis, _) if self.axis.is_none() => {
                Some("this figure needs a body with a pivot under gravity")
            }
            (Figure::Drift, _) if self.motion.is_prescribed() => {
                Some("the motion is prescribed, so it has no integration drift")
            }
            (Figure::Polhodes | Figure::Herpolhode, None) if self.motion.is_prescribed() => {
                Some("the motion is prescribed, not free: it has no polhode")
            }
            (Figure::Polhodes | Figure::Herpolhode, None) => Some(match self.motion.trajectory.reason() {
                MethodReason::Contact => "the ground holds the body: it has no polhode",
                MethodReason::Gimbals => "gimbals hold the body: it has no polhode",
                _ => "a torque acts on the body: it has no polhode",
            }),
            (Figure::Polhodes | Figure::Herpolhode, Some(motion)) => match motion.regime() {
                Regime::AtRest => Some("the body is at rest"),
                Regime::Permanent(_) if figure == Figure::Herpolhode => {
                    Some("ω remains along L: its path on the plane is a point")
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

/// Content of a figure.
enum Content<'a> {
    /// Curves against time.
    Chart(Chart<'a>),
    /// Marks of another kind of figure.
    Own,
    /// Reason why it cannot be drawn.
    Refused(String),
}

impl Content<'_> {
    fn is_words(&self) -> bool {
        match self {
            Self::Chart(chart) => chart.is_words(),
            Self::Own => false,
            Self::Refused(_) => true,
        }
    }
}

impl Figure {
    /// Returns the title above the figure.
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
            Self::Drift => "Drift: dots are samples, the line is the running maximum",
            Self::Polhodes => "Angular momentum in the body",
            Self::Axis => "Path of the axis in space",
            Self::Wheels => "Wheels along their axes",
            Self::Herpolhode => "Herpolhode: ω on the invariable plane",
        }
    }
}
