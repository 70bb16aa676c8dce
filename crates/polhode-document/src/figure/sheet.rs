//! A sheet: what a picture is made of, before it is SVG or pixels.
//!
//! Lengths are CSS pixels, 96 to an inch, y downward. Everything drawn is one of five marks, so that both writers are
//! short and show the same.

use super::font;
use super::line;

pub use super::line::Point;

/// Keyword of the text in a PNG that says how it was made.
pub(super) const MAKER: &str = "Source";

/// Red, green and blue, as 0xrrggbb.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub u32);

impl Colour {
    /// Paper.
    #[cfg(feature = "png")]
    pub const WHITE: Self = Self(0xff_ff_ff);
    /// Titles, and the curve that a figure is about.
    pub const BLACK: Self = Self(0x1f_23_28);
    /// Ordinary text.
    pub const TEXT: Self = Self(0x3d_44_4d);
    /// Text that may be overlooked.
    pub const FAINT: Self = Self(0x6e_77_81);
    /// The lines of a grid.
    pub const GRID: Self = Self(0xe3_e7_eb);
    /// The frame of a plot.
    pub const FRAME: Self = Self(0x81_8b_98);
    /// Of axes 1, 2 and 3, by Okabe and Ito: different to every eye.
    pub const AXES: [Self; 3] = [Self(0x00_72_b2), Self(0xd5_5e_00), Self(0x00_9e_73)];
    /// Theirs too.
    pub const ORANGE: Self = Self(0xe6_9f_00);

    /// Red, green and blue, each from 0 to 255.
    #[cfg(feature = "png")]
    pub const fn rgb(self) -> [u8; 3] {
        let [_, r, g, b] = self.0.to_be_bytes();
        [r, g, b]
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Colour of the line.
    pub colour: Colour,
    /// Width, px.
    pub width: f64,
    /// Lengths drawn and left out by turns; empty for a whole line.
    pub dash: &'static [f64],
    /// Opacity, from 0 to 1.
    pub opacity: f64,
}

impl Pen {
    /// Whole, opaque line.
    pub const fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, dash: &[], opacity: 1.0 }
    }

    /// The same pen with dashes.
    pub const fn dashed(self, dash: &'static [f64]) -> Self {
        Self { dash, ..self }
    }

    /// The same pen with an opacity.
    pub const fn faint(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// Of the component along axis k = 0, 1, 2: its colour, and dashes of its own, which are there in grey too.
    pub fn axis(k: usize) -> Self {
        let dash: [&[f64]; 3] = [&[7.0, 2.5], &[], &[1.6, 2.4]];
        let pen = Self::solid(Colour::AXES.get(k).copied().unwrap_or(Colour::BLACK), 1.5);
        pen.dashed(dash.get(k).copied().unwrap_or(&[]))
    }
}

/// On which side of its place a text stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins at its place.
    Start,
    /// The middle of the text is at its place.
    Middle,
    /// The text ends at its place.
    End,
}

/// A line of text; its place is on the base line.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// Place on the base line.
    pub at: Point,
    /// Point of the text that is at its place.
    pub anchor: Anchor,
    /// Size of the letters, px.
    pub size: f64,
    /// Colour of the letters.
    pub colour: Colour,
    /// Read from below.
    pub upward: bool,
    /// Surrounded by white, where it stands on lines.
    pub halo: bool,
    /// The text itself, one line.
    pub content: String,
}

/// What a sheet is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// Curves.
    Lines {
        /// Points of each curve.
        lines: Vec<Vec<Point>>,
        /// Pen of all of them.
        pen: Pen,
    },
    /// Round dots as wide as the pen.
    Dots {
        /// Middle of each dot.
        dots: Vec<Point>,
        /// Pen, as wide as the dots.
        pen: Pen,
    },
    /// A filled polygon.
    Polygon {
        /// Its corners.
        corners: Vec<Point>,
        /// Its colour.
        fill: Colour,
        /// Its opacity, from 0 to 1.
        opacity: f64,
    },
    /// A ball with a light on it.
    Ball {
        /// Its middle.
        center: Point,
        /// Its radius, px.
        radius: f64,
    },
    /// A line of text.
    Text(Text),
}

/// Marks in the order in which they are drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Width, px.
    pub width: f64,
    /// Height, px.
    pub height: f64,
    /// What readers of the screen are told.
    pub title: String,
    /// The marks.
    pub marks: Vec<Mark>,
    /// The command that made it.
    pub maker: Option<String>,
}

/// Sizes of text.
pub const LARGE: f64 = 13.5;
/// Size of ordinary text, px.
pub const SMALL: f64 = 11.5;

impl Sheet {
    /// Empty sheet.
    pub fn new(width: f64, height: f64, title: String) -> Self {
        Self { width, height, title, marks: Vec::new(), maker: None }
    }

    /// Draws curves, without the points that are not seen.
    pub fn lines(&mut self, lines: impl IntoIterator<Item = Vec<Point>>, pen: Pen) {
        let thinned = lines.into_iter().map(|points| line::thinned(&points));
        let lines: Vec<_> = thinned.filter(|points| points.len() > 1).collect();
        if !lines.is_empty() {
            self.marks.push(Mark::Lines { lines, pen });
        }
    }

    /// Draws a curve, without the points that are not seen.
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

    /// Writes a line of ordinary text.
    pub fn text(&mut self, at: Point, anchor: Anchor, colour: Colour, content: &str) {
        self.marks.push(Mark::Text(Text::small(at, anchor, colour, content)));
    }
}

impl Text {
    /// A line of ordinary text.
    pub fn small(at: Point, anchor: Anchor, colour: Colour, content: &str) -> Self {
        Self { at, anchor, size: SMALL, colour, upward: false, halo: false, content: content.to_owned() }
    }

    /// Where it begins and ends along its base line, from its place.
    pub fn extent(&self) -> [f64; 2] {
        let width = font::width(&self.content, self.size);
        match self.anchor {
            Anchor::Start => [0.0, width],
            Anchor::Middle => [-0.5 * width, 0.5 * width],
            Anchor::End => [-width, 0.0],
        }
    }
}
