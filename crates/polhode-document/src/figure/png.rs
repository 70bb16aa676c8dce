//! PNG writer: pixels of the marks, letters from the embedded font.

use std::fmt;

use tiny_skia::{
    Color, FillRule, GradientStop, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Point as At,
    RadialGradient, Shader, SpreadMode, Stroke, StrokeDash, Transform,
};
use ttf_parser::{Face, OutlineBuilder};

use super::font;
use super::sheet::{Anchor, Colour, MAKER, Mark, Pen, Point, Sheet, Text};

/// Pixels per CSS pixel (1/96 in), which gives 288 pixels per inch.
const SCALE: f32 = 3.0;

/// Reason why a picture cannot be written as PNG.
#[derive(Clone, Debug, PartialEq)]
pub struct PngError(String);

impl PngError {
    /// Returns advice for the user.
    pub const fn hint(&self) -> &'static str {
        "write SVG"
    }
}

impl fmt::Display for PngError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a PNG cannot be made: {}", self.0)
    }
}

impl std::error::Error for PngError {}

pub(super) fn write(sheet: &Sheet) -> Result<Vec<u8>, PngError> {
    let size = |length: f64| (length * f64::from(SCALE)).ceil() as u32;
    let (width, height) = (size(sheet.width), size(sheet.height));
    let failed = |why: &str| PngError(why.to_owned());
    let mut pixels = Pixmap::new(width, height).ok_or_else(|| failed("the picture has no size"))?;
    pixels.fill(Color::WHITE);
    let face = font::face().ok_or_else(|| failed("the font cannot be read"))?;
    let mut canvas = Canvas { pixels, face };
    for mark in &sheet.marks {
        canvas.draw(mark);
    }
    encoded(&canvas.pixels, sheet.maker.as_deref()).map_err(|error| failed(&error.to_string()))
}

/// Encodes opaque pixels as a PNG with its physical size.
fn encoded(pixels: &Pixmap, maker: Option<&str>) -> Result<Vec<u8>, png::EncodingError> {
    let rgb: Vec<u8> = pixels.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let per_meter = (f64::from(SCALE) * 96.0 / 0.0254).round() as u32;
    let unit = png::Unit::Meter;
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: per_meter, yppu: per_meter, unit }));
    if let Some(maker) = maker {
        // The line end prevents a match with a longer command.
        encoder.add_itxt_chunk(MAKER.to_owned(), format!("{maker}\n"))?;
    }
    encoder.write_header()?.write_image_data(&rgb)?;
    Ok(file)
}

struct Canvas {
    pixels: Pixmap,
    face: Face<'static>,
}

impl Canvas {
    fn draw(&mut self, mark: &Mark) {
        match mark {
            Mark::Lines { lines, pen } => self.stroke(path(lines, false), pen),
            // A line of almost no length with round ends is a dot.
            Mark::Dots { dots, pen } => {
                let reach = 1e-3;
                let lines: Vec<_> = dots.iter().map(|&[x, y]| vec![[x, y], [x + reach, y]]).collect();
                self.stroke(path(&lines, false), pen);
            }
            Mark::Polygon { corners, fill, opacity } => {
                self.fill(path(std::slice::from_ref(corners), true), &solid(*fill, *opacity));
            }
            Mark::Ball { center, radius } => self.ball(*center, *radius),
            Mark::Text(text) => self.text(text),
        }
    }

    fn stroke(&mut self, path: Option<Path>, pen: &Pen) {
        let Some(path) = path else { return };
        let dash = StrokeDash::new(pen.dash.iter().map(|&x| x as f32).collect(), 0.0);
        let line_cap = if pen.dash.is_empty() { LineCap::Round } else { LineCap::Butt };
        let stroke = Stroke {
            width: pen.width as f32,
            line_cap,
            line_join: LineJoin::Round,
            dash,
            ..Stroke::default()
        };
        let paint = solid(pen.colour, pen.opacity);
        self.pixels.stroke_path(&path, &paint, &stroke, Transform::from_scale(SCALE, SCALE), None);
    }

    fn fill(&mut self, path: Option<Path>, paint: &Paint<'_>) {
        let Some(path) = path else { return };
        self.pixels.fill_path(&path, paint, FillRule::Winding, Transform::from_scale(SCALE, SCALE), None);
    }

    /// Draws a ball with the same shading as in `svg.rs`.
    fn ball(&mut self, [x, y]: Point, radius: f64) {
        let circle = PathBuilder::from_circle(x as f32, y as f32, radius as f32);
        let part = |cx: f64, cy: f64| {
            At::from_xy((x + (2.0 * cx - 1.0) * radius) as f32, (y + (2.0 * cy - 1.0) * radius) as f32)
        };
        let light = part(0.38, 0.3);
        let stops = vec![
            GradientStop::new(0.0, Color::WHITE),
            GradientStop::new(1.0, Color::from_rgba8(0xe4, 0xe9, 0xef, 255)),
        ];
        let reach = (1.6 * radius) as f32;
        let shader =
            RadialGradient::new(light, 0.0, light, reach, stops, SpreadMode::Pad, Transform::identity());
        let paint = Paint { shader: shader.unwrap_or(Shader::SolidColor(Color::WHITE)), ..Paint::default() };
        self.fill(circle.clone(), &paint);
        self.stroke(circle, &Pen::solid(Colour(0xd1_d9_e0), 1.0));
    }

    fn text(&mut self, text: &Text) {
        let units = f64::from(self.face.units_per_em());
        let scale = text.size / units;
        let width = font::advance(&self.face, &text.content) * text.size;
        let mut along = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * width,
            Anchor::End => -width,
        };
        let mut letters =
            Letters { builder: PathBuilder::new(), at: text.at, along, scale, upward: text.upward };
        for c in text.content.chars() {
            let Some(glyph) = font::glyph(&self.face, c) else { continue };
            letters.along = along;
            let _ = self.face.outline_glyph(glyph, &mut letters);
            along += f64::from(self.face.glyph_hor_advance(glyph).unwrap_or(0)) * scale;
        }
        let path = letters.builder.finish();
        if text.halo {
            self.stroke(path.clone(), &Pen::solid(Colour::WHITE, 3.5));
        }
        self.fill(path, &solid(text.colour, 1.0));
    }
}

fn solid(colour: Colour, opacity: f64) -> Paint<'static> {
    let [r, g, b] = colour.rgb();
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, (255.0 * opacity).round() as u8);
    paint
}

fn path(lines: &[Vec<Point>], closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for points in lines {
        for (k, &[x, y]) in points.iter().enumerate() {
            if k == 0 {
                builder.move_to(x as f32, y as f32);
            } else {
                builder.line_to(x as f32, y as f32);
            }
        }
        if closed {
            builder.close();
        }
    }
    builder.finish()
}

/// Outlines of letters at their positions.
struct Letters {
    builder: PathBuilder,
    at: Point,
    along: f64,
    scale: f64,
    upward: bool,
}

impl Letters {
    fn place(&self, x: f32, y: f32) -> [f32; 2] {
        let (along, up) = (self.along + f64::from(x) * self.scale, f64::from(y) * self.scale);
        let [x0, y0] = self.at;
        let [x, y] = if self.upward { [x0 - up, y0 - along] } else { [x0 + along, y0 - up] };
        [x as f32, y as f32]
    }
}

impl OutlineBuilder for Letters {
    fn move_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.place(x, y);
        self.builder.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.place(x, y);
        self.builder.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ([x1, y1], [x, y]) = (self.place(x1, y1), self.place(x, y));
        self.builder.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ([x1, y1], [x2, y2], [x, y]) = (self.place(x1, y1), self.place(x2, y2), self.place(x, y));
        self.builder.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}
