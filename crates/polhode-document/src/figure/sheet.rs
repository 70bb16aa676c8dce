//! Sheet of marks, the common input of the SVG and PNG writers.
//!
//! Lengths are in CSS pixels, 96 to an inch, y downward. There are only five kinds of marks. This
//! keeps both writers short, and their pictures agree.

use super::font;
use super::line;

pub use super::line::Point;

/// Keyword of the PNG text chunk with the command that made the picture.
pub(super) const MAKER: &str = "Source";

/// Colour as 0xrrggbb.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub u32);

impl Colour {
    /// Background of the sheet.
    #[cfg(feature = "png")]
    pub const WHITE: Self = Self(0xff_ff_ff);
    /// Colour of titles, and of the main curve of a figure.
    pub const BLACK: Self = Self(0x1f_23_28);
    /// Colour of ordinary text.
    pub const TEXT: Self = Self(0x3d_44_4d);
    /// Colour of secondary text.
    pub const FAINT: Self = Self(0x6e_77_81);
    /// Colour of grid lines.
    pub const GRID: Self = Self(0xe3_e7_eb);
    /// Colour of the frame of a plot.
    pub const FRAME: Self = Self(0x81_8b_98);
    /// Colours of axes 1, 2 and 3, by Okabe and Ito: distinguishable with any colour vision.
    pub const AXES: [Self; 3] = [Self(0x00_72_b2), Self(0xd5_5e_00), Self(0x00_9e_73)];
    /// Orange of the same palette.
    pub const ORANGE: Self = Self(0xe6_9f_00);

    /// Returns red, green and blue, each from 0 to 255.
    #[cfg(feature = "png")]
    pub const fn rgb(self) -> [u8; 3] {
        let [_, r, g, b] = self.0.to_be_bytes();
        [r, g, b]
    }
}

/// Style of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Colour of the line.
    pub colour: Colour,
    /// Width, px.
    pub width: f64,
    /// Alternating lengths of dashes and gaps, px; empty for a solid line.
    pub dash: &'static [f64],
    /// Opacity, from 0 to 1.
    pub opacity: f64,
}

impl Pen {
    /// Returns a solid, opaque pen; `width` in px.
    pub const fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, dash: &[], opacity: 1.0 }
    }

    /// Returns the pen with dashes.
    pub const fn dashed(self, dash: &'static [f64]) -> Self {
        Self { dash, ..self }
    }

    /// Returns the pen with an opacity, from 0 to 1.
    pub const fn faint(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// Returns the pen for the component along axis k = 0, 1, 2: its colour, and its dash pattern
    /// for grey prints.
    pub fn axis(k: usize) -> Self {
        let dash: [&[f64]; 3] = [&[7.0, 2.5], &[], &[1.6, 2.4]];
        let pen = Self::solid(Colour::AXES.get(k).copied().unwrap_or(Colour::BLACK), 1.5);
        pen.dashed(dash.get(k).copied().unwrap_or(&[]))
    }
}

/// Alignment of a text relative to its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins at its position.
    Start,
    /// The middle of the text is at its position.
    Middle,
    /// The text ends at its position.
    End,
}

/// Line of text, positioned on its baseline.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// Position on the baseline, px.
    pub at: Point,
    /// Alignment relative to the position.
    pub anchor: Anchor,
    /// Size of the letters, px.
    pub size: f64,
    /// Colour of the letters.
    pub colour: Colour,
    /// True for text rotated by 90°, read from bottom to top.
    pub upward: bool,
    /// True for text with a white outline, for text on lines.
    pub halo: bool,
    /// Text, one line.
    pub content: String,
}

/// Element of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// Curves.
    Lines {
        /// Points of each curve.
        lines: Vec<Vec<Point>>,
        /// Pen of all curves.
        pen: Pen,
    },
    /// Round dots, as wide as the pen.
    Dots {
        /// Centre of each dot.
        dots: Vec<Point>,
        /// Pen; its width is the diameter.
        pen: Pen,
    },
    /// Filled polygon.
    Polygon {
        /// Corners, px.
        corners: Vec<Point>,
        /// Fill colour.
        fill: Colour,
        /// Opacity, from 0 to 1.
        opacity: f64,
    },
    /// Shaded ball.
    Ball {
        /// Centre, px.
        center: Point,
        /// Radius, px.
        radius: f64,
    },
    /// Line of text.
    Text(Text),
}

/// Sheet of marks, in drawing order.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Width, px.
    pub width: f64,
    /// Height, px.
    pub height: f64,
    /// Title for screen readers.
    pub title: String,
    /// Marks in drawing order.
    pub marks: Vec<Mark>,
    /// Command that made the picture.
    pub maker: Option<String>,
}

/// Size of titles, px.
pub const LARGE: f64 = 13.5;
/// Size of ordinary text, px.
pub const SMALL: f64 = 11.5;

impl Sheet {
    /// Creates an empty sheet; sizes in px.
    pub fn new(width: f64, height: f64, title: String) -> Self {
        Self { width, height, title, marks: Vec::new(), maker: None }
    }

    /// Draws curves without their invisible points.
    pub fn lines(&mut self, lines: impl IntoIterator<Item = Vec<Point>>, pen: Pen) {
        let thinned = lines.into_iter().map(|points| line::thinned(&points));
        let lines: Vec<_> = thinned.filter(|points| points.len() > 1).collect();
        if !lines.is_empty() {
            self.marks.push(Mark::Lines { lines, pen });
        }
    }

    /// Draws a curve without its invisible points.
    pub fn line(&mut self, points: Vec<Point>, pen: Pen) {
        self.lines([points], pen);
    }

    /// Draws dots, if there are any.
    pub fn dots(&mut self, dots: Vec<Point>, pen: Pen) {
        if !dots.is_empty() {
            self.marks.push(Mark::Dots { dots, pen });
        }
    }

    /// Draws a circle.
    pub fn circle(&mut self, [x, y]: Point, radius: f64, pen: Pen) {
        let at = |k: u16| {
            let (sin, cos) = (f64::from(k) / 180.0 * std::f64::consts::PI).sin_cos();
            [x + radius * cos, y + radius * sin]
        };
        self.line((0..=360).map(at).collect(), pen);
    }

    /// Draws a line of ordinary text.
    pub fn text(&mut self, at: Point, anchor: Anchor, colour: Colour, content: &str) {
        self.marks.push(Mark::Text(Text::small(at, anchor, colour, content)));
    }
}

impl Text {
    /// Creates a line of ordinary text.
    pub fn small(at: Point, anchor: Anchor, colour: Colour, content: &str) -> Self {
        Self { at, anchor, size: SMALL, colour, upward: false, halo: false, content: content.to_owned() }
    }

    /// Returns the start and end along the baseline, relative to the position, px.
    pub fn extent(&self) -> [f64; 2] {
        let width = font::width(&self.content, self.size);
        match self.anchor {
            Anchor::Start => [0.0, width],
            Anchor::Middle => [-0.5 * width, 0.5 * width],
            Anchor::End => [-width, 0.0],
        }
    }
}
