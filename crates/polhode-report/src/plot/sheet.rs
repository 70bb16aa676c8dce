//! A sheet: what a picture is made of, before it is SVG or pixels.
//!
//! Lengths are CSS pixels, 96 to an inch, y downward. Everything drawn is one of five marks, so that both writers are
//! short and show the same.

use super::font;
use super::line;
pub(super) use super::line::Point;

/// Red, green and blue, as 0xrrggbb.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Colour(pub(super) u32);

impl Colour {
    #[cfg(feature = "png")]
    pub(super) const WHITE: Self = Self(0xff_ff_ff);
    /// Titles, and the curve that a figure is about.
    pub(super) const BLACK: Self = Self(0x1f_23_28);
    /// Ordinary text.
    pub(super) const TEXT: Self = Self(0x3d_44_4d);
    /// Text that may be overlooked.
    pub(super) const FAINT: Self = Self(0x6e_77_81);
    /// The lines of a grid.
    pub(super) const GRID: Self = Self(0xe3_e7_eb);
    /// The frame of a plot.
    pub(super) const FRAME: Self = Self(0x81_8b_98);
    /// Of axes 1, 2 and 3, by Okabe and Ito: different to every eye.
    pub(super) const AXES: [Self; 3] = [Self(0x00_72_b2), Self(0xd5_5e_00), Self(0x00_9e_73)];
    /// Theirs too.
    pub(super) const ORANGE: Self = Self(0xe6_9f_00);

    #[cfg(feature = "png")]
    pub(super) const fn rgb(self) -> [u8; 3] {
        let [_, r, g, b] = self.0.to_be_bytes();
        [r, g, b]
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pen {
    pub(super) colour: Colour,
    pub(super) width: f64,
    /// Lengths drawn and left out by turns; empty for a whole line.
    pub(super) dash: &'static [f64],
    pub(super) opacity: f64,
}

impl Pen {
    pub(super) const fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, dash: &[], opacity: 1.0 }
    }

    pub(super) const fn dashed(self, dash: &'static [f64]) -> Self {
        Self { dash, ..self }
    }

    pub(super) const fn faint(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// Of the component along axis k = 0, 1, 2: its colour, and dashes of its own, which are there in grey too.
    pub(super) fn axis(k: usize) -> Self {
        let dash: [&[f64]; 3] = [&[7.0, 2.5], &[], &[1.6, 2.4]];
        let pen = Self::solid(Colour::AXES.get(k).copied().unwrap_or(Colour::BLACK), 1.5);
        pen.dashed(dash.get(k).copied().unwrap_or(&[]))
    }
}

/// On which side of its place a text stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A line of text; its place is on the base line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Text {
    pub(super) at: Point,
    pub(super) anchor: Anchor,
    pub(super) size: f64,
    pub(super) colour: Colour,
    /// Read from below.
    pub(super) upward: bool,
    /// Surrounded by white, where it stands on lines.
    pub(super) halo: bool,
    pub(super) content: String,
}

/// What a sheet is made of.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Mark {
    Lines {
        lines: Vec<Vec<Point>>,
        pen: Pen,
    },
    /// Round dots as wide as the pen.
    Dots {
        dots: Vec<Point>,
        pen: Pen,
    },
    Polygon {
        corners: Vec<Point>,
        fill: Colour,
        opacity: f64,
    },
    /// A ball with a light on it.
    Ball {
        center: Point,
        radius: f64,
    },
    Text(Text),
}

/// Marks in the order in which they are drawn.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sheet {
    pub(super) width: f64,
    pub(super) height: f64,
    /// What readers of the screen are told.
    pub(super) title: String,
    pub(super) marks: Vec<Mark>,
    /// The command that made it.
    pub(super) maker: Option<String>,
}

/// Sizes of text.
pub(super) const LARGE: f64 = 13.5;
pub(super) const SMALL: f64 = 11.5;

impl Sheet {
    pub(super) fn new(width: f64, height: f64, title: String) -> Self {
        Self { width, height, title, marks: Vec::new(), maker: None }
    }

    /// Draws curves, without the points that are not seen.
    pub(super) fn lines(&mut self, lines: impl IntoIterator<Item = Vec<Point>>, pen: Pen) {
        let thinned = lines.into_iter().map(|points| line::thinned(&points));
        let lines: Vec<_> = thinned.filter(|points| points.len() > 1).collect();
        if !lines.is_empty() {
            self.marks.push(Mark::Lines { lines, pen });
        }
    }

    /// Draws a curve, without the points that are not seen.
    pub(super) fn line(&mut self, points: Vec<Point>, pen: Pen) {
        self.lines([points], pen);
    }

    pub(super) fn dots(&mut self, dots: Vec<Point>, pen: Pen) {
        if !dots.is_empty() {
            self.marks.push(Mark::Dots { dots, pen });
        }
    }

    pub(super) fn circle(&mut self, [x, y]: Point, radius: f64, pen: Pen) {
        let at = |k: u16| {
            let (sin, cos) = (f64::from(k) / 180.0 * std::f64::consts::PI).sin_cos();
            [x + radius * cos, y + radius * sin]
        };
        self.line((0..=360).map(at).collect(), pen);
    }

    pub(super) fn text(&mut self, at: Point, anchor: Anchor, colour: Colour, content: &str) {
        self.marks.push(Mark::Text(Text::small(at, anchor, colour, content)));
    }
}

impl Text {
    pub(super) fn small(at: Point, anchor: Anchor, colour: Colour, content: &str) -> Self {
        Self { at, anchor, size: SMALL, colour, upward: false, halo: false, content: content.to_owned() }
    }

    /// Where it begins and ends along its base line, from its place.
    pub(super) fn extent(&self) -> [f64; 2] {
        let width = font::width(&self.content, self.size);
        match self.anchor {
            Anchor::Start => [0.0, width],
            Anchor::Middle => [-0.5 * width, 0.5 * width],
            Anchor::End => [-width, 0.0],
        }
    }
}
