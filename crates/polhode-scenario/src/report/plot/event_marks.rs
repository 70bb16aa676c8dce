//! Event marks: dotted lines over the curves, letters above the frame, and names in the legend.

use polhode::motion::Trajectory;
use polhode_document::figure::axes::Axes;
use polhode_document::figure::font;
use polhode_document::figure::legend::Key;
use polhode_document::figure::sheet::{Anchor, Colour, Mark, Pen, SMALL, Sheet, Text};
use polhode_document::layout::printable;

/// Largest number of lines. More would hide the curves; they are replaced by short marks at the
/// upper edge.
const MOST_LINES: usize = 40;

/// Length of a short mark, px.
const SHORT: f64 = 7.0;

const PEN: Pen = Pen::solid(Colour::FAINT, 1.0).dashed(&[2.0, 3.0]);

/// Events of a motion, each with its times.
#[derive(Clone, Debug, Default)]
pub(crate) struct EventMarks {
    events: Vec<Marked>,
}

#[derive(Clone, Debug)]
struct Marked {
    number: usize,
    name: String,
    /// Times of the event, s.
    times: Vec<f64>,
}

impl EventMarks {
    pub(crate) fn of(trajectory: &Trajectory) -> Self {
        let mut events: Vec<Marked> = Vec::new();
        for crossing in trajectory.events() {
            let time = crossing.state.time;
            match events.iter_mut().find(|marked| marked.number == crossing.event) {
                Some(marked) => marked.times.push(time),
                None => events.push(Marked {
                    number: crossing.event,
                    name: printable(&crossing.name),
                    times: vec![time],
                }),
            }
        }
        Self { events }
    }

    /// Returns true if the events have letters, which distinguish several events.
    pub(crate) fn has_letters(&self) -> bool {
        self.events.len() > 1
    }

    /// Returns the letter of event `k`, from 0; after `z` its number.
    fn letter(k: usize) -> String {
        match u8::try_from(k) {
            Ok(k) if k < 26 => char::from(b'a' + k).to_string(),
            _ => (k + 1).to_string(),
        }
    }

    /// Returns the legend entries: `a: 7 × camera 12° off`.
    pub(crate) fn keys(&self) -> impl Iterator<Item = Key> {
        self.events.iter().enumerate().map(|(k, Marked { name, times, .. })| {
            let letter = if self.has_letters() { format!("{}: ", Self::letter(k)) } else { String::new() };
            let count = if times.len() > 1 { format!("{} × ", times.len()) } else { String::new() };
            Key::line(PEN, format!("{letter}{count}{name}"))
        })
    }

    /// Draws the marks over axes whose unit of time is `scale` seconds; letters are above the
    /// frame.
    pub(crate) fn draw(&self, axes: &Axes, scale: f64, lettered: bool, sheet: &mut Sheet) {
        let across = |time: f64| axes.at([time / scale, 0.0])[0];
        let mut places: Vec<(f64, usize)> = Vec::new();
        for (k, marked) in self.events.iter().enumerate() {
            places.extend(marked.times.iter().map(|&time| (across(time), k)));
        }
        places.retain(|(x, _)| (axes.area.left - 0.5..=axes.area.right + 0.5).contains(x));
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        let end = if places.len() > MOST_LINES { axes.area.top + SHORT } else { axes.area.bottom };
        let mut drawn = f64::NEG_INFINITY;
        for (x, _) in &places {
            if *x - drawn > 0.5 {
                sheet.line(vec![[*x, axes.area.top], [*x, end]], PEN);
                drawn = *x;
            }
        }
        if !(lettered && self.has_letters()) {
            return;
        }
        // Overlapping letters are joined into one label, each letter once.
        let mut groups: Vec<(f64, Vec<usize>)> = Vec::new();
        for (x, k) in places {
            let width = |letters: &[usize]| font::width(&joined(letters), SMALL) + 4.0;
            match groups.last_mut() {
                Some((from, letters)) if x - *from < width(letters) => {
                    if !letters.contains(&k) {
                        letters.push(k);
                    }
                }
                _ => groups.push((x, vec![k])),
            }
        }
        for (x, letters) in groups {
            // The first letter is centred above its mark.
            let shift = 0.5 * letters.first().map_or(0.0, |&k| font::width(&Self::letter(k), SMALL));
            let at = [x - shift, axes.area.top - 4.0];
            sheet.marks.push(Mark::Text(Text::small(at, Anchor::Start, Colour::FAINT, &joined(&letters))));
        }
    }
}

/// Joins letters to a label: `a,b`.
fn joined(letters: &[usize]) -> String {
    letters.iter().map(|&k| EventMarks::letter(k)).collect::<Vec<_>>().join(",")
}
