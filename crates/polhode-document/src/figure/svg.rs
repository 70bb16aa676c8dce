//! SVG writer. It uses plain attributes and no style sheet, for the widest support.

use std::fmt::Write as _;

use super::font::FAMILY;
use super::sheet::{Anchor, Colour, Mark, Pen, Point, SMALL, Sheet, Text};

/// Returns a sheet as SVG.
pub fn write(sheet: &Sheet) -> String {
    scaled(sheet, 1.0)
}

/// Returns a sheet as SVG, drawn larger by a factor.
pub fn scaled(sheet: &Sheet, factor: f64) -> String {
    let (width, height) = (length(sheet.width), length(sheet.height));
    let maker =
        sheet.maker.as_ref().map_or_else(String::new, |maker| format!("<desc>{}</desc>\n", escaped(maker)));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{}\" height=\"{}\" \
         role=\"img\" font-family=\"{FAMILY}\" font-size=\"{}\" fill=\"none\" stroke-linecap=\"round\" \
         stroke-linejoin=\"round\">\n<title>{}</title>\n{maker}<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n",
        length(factor * sheet.width),
        length(factor * sheet.height),
        length(SMALL),
        escaped(&sheet.title)
    );
    for mark in &sheet.marks {
        match mark {
            Mark::Lines { lines, pen } => {
                let d: String = lines.iter().map(|points| path(points)).collect();
                let _ = writeln!(svg, "<path d=\"{d}\"{}/>", stroke(pen));
            }
            Mark::Dots { dots, pen } => {
                let d: String =
                    dots.iter().map(|&[x, y]| format!("M{} {}h0", length(x), length(y))).collect();
                let _ = writeln!(svg, "<path d=\"{d}\"{}/>", stroke(pen));
            }
            Mark::Polygon { corners, fill, opacity } => {
                let faint = if *opacity < 1.0 {
                    format!(" fill-opacity=\"{}\"", length(*opacity))
                } else {
                    String::new()
                };
                let _ = writeln!(svg, "<path d=\"{}z\" fill=\"{}\"{faint}/>", path(corners), hex(*fill));
            }
            Mark::Ball { center: [x, y], radius } => svg.push_str(&ball(*x, *y, *radius)),
            Mark::Text(text) => svg.push_str(&written(text)),
        }
    }
    svg + "</svg>\n"
}

fn stroke(pen: &Pen) -> String {
    let mut text = format!(" stroke=\"{}\" stroke-width=\"{}\"", hex(pen.colour), length(pen.width));
    if !pen.dash.is_empty() {
        let dash: Vec<String> = pen.dash.iter().map(|&x| length(x)).collect();
        let _ = write!(text, " stroke-dasharray=\"{}\" stroke-linecap=\"butt\"", dash.join(" "));
    }
    if pen.opacity < 1.0 {
        let _ = write!(text, " stroke-opacity=\"{}\"", length(pen.opacity));
    }
    text
}

/// Draws a ball with the same shading as in `png.rs`. The gradient id contains the position, so
/// each ball has its own.
fn ball(x: f64, y: f64, radius: f64) -> String {
    let id = format!("ball-{x:.0}-{y:.0}");
    let [x, y, r] = [x, y, radius].map(length);
    format!(
        "<radialGradient id=\"{id}\" cx=\".38\" cy=\".3\" r=\".8\"><stop stop-color=\"#fff\"/><stop offset=\"1\" \
         stop-color=\"#e4e9ef\"/></radialGradient>\n\
         <circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"url(#{id})\" stroke=\"#d1d9e0\"/>\n"
    )
}

fn written(text: &Text) -> String {
    let [x, y] = text.at.map(length);
    let mut tag = format!("<text x=\"{x}\" y=\"{y}\" fill=\"{}\"", hex(text.colour));
    match text.anchor {
        Anchor::Start => {}
        Anchor::Middle => tag.push_str(" text-anchor=\"middle\""),
        Anchor::End => tag.push_str(" text-anchor=\"end\""),
    }
    if text.size != SMALL {
        let _ = write!(tag, " font-size=\"{}\"", length(text.size));
    }
    if text.upward {
        let _ = write!(tag, " transform=\"rotate(-90 {x} {y})\"");
    }
    if text.halo {
        tag.push_str(" paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"3.5\"");
    }
    format!("{tag}>{}</text>\n", escaped(&text.content))
}

fn path(points: &[Point]) -> String {
    let at = |&[x, y]: &Point| format!("{} {}", length(x), length(y));
    let corners: Vec<String> = points.iter().map(at).collect();
    format!("M{}", corners.join("L"))
}

/// Formats a length to 0.01 px without trailing zeros.
fn length(x: f64) -> String {
    let text = format!("{x:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

fn hex(Colour(rgb): Colour) -> String {
    format!("#{rgb:06x}")
}

/// Escapes a text for XML; characters that XML cannot contain become U+FFFD.
pub fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => safe.push('\u{fffd}'),
            c => safe.push(c),
        }
    }
    safe
}
