//! One page that shows a motion: a file of its own that a browser opens from disk.
//!
//! The page is the viewer (`viewer/`, whose build is `assets/viewer.html`) with the motion in it as JSON, as `viewer/src/data.ts`
//! says. Numbers are the trajectory's own, bit for bit; text from outside is inert.

mod atoms;
mod body;
mod caption;
mod cones;
mod contact;
mod data;
mod decimate;
mod explanation;
mod facts;
mod free;
mod motion;
mod outline;
mod packed;
mod placed;
mod rows;
mod scene;
mod shapes;
mod surface;
mod top;
mod turning;

pub use decimate::decimated;
use polhode::body::PrincipalFrame;
use polhode::math::Body;
use polhode::motion::{Scenario, Trajectory};
use serde_json::Value;
pub use shapes::shape_of;
pub use turning::equivalent_box;

use crate::report::page::data::Room;
use crate::report::page::rows::Rows;
use crate::report::page::turning::Turning;
use polhode_document::Document;
use polhode_document::mathml::escaped;

/// What a page shows.
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, State, Trajectory};
/// use polhode_scenario::report::{PageInput, PageSubject, page};
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.02) };
/// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
/// let times: Vec<f64> = (0..=200).map(|k| 0.2 * f64::from(k)).collect();
/// let html = page(&PageInput {
///     title: "1 < 2 < 3",
///     source: "an example",
///     scenario_text: None,
///     subject: PageSubject::Moments(motion.principal()),
///     trajectory: &Trajectory::of_motion(motion, &times)?,
///     explanation: None,
///     whole: true,
/// });
/// assert!(html.contains("<title>1 &lt; 2 &lt; 3</title>"));
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PageInput<'a> {
    /// What it is about; text, never markup.
    pub title: &'a str,
    /// What made it: `polhode 0.1.0 simulate examples/t-handle.toml`.
    pub source: &'a str,
    /// The scenario file as it was read.
    pub scenario_text: Option<&'a str>,
    /// What moves.
    pub subject: PageSubject<'a>,
    /// How it moves.
    pub trajectory: &'a Trajectory,
    /// The worked solution.
    pub explanation: Option<&'a Document>,
    /// Whether what the body alone says is in it: its shapes, and the other motions on its momentum sphere. Who shows one motion after
    /// another has them.
    pub whole: bool,
}

impl PageInput<'_> {
    /// True if the page shows the curves of a free motion.
    pub fn is_free(&self) -> bool {
        free::facts(self).is_some()
    }
}

/// What moves on a page.
#[derive(Clone, Copy, Debug)]
pub enum PageSubject<'a> {
    /// The body of a scenario.
    Scenario(&'a Scenario),
    /// A free body of which only the moments about its centre of mass are known.
    Moments(&'a PrincipalFrame<Body>),
}

/// The viewer, with a place for the data.
const TEMPLATE: &str = include_str!("../../../assets/viewer.html");

/// Where the data stand in the template.
const DATA: &str = "<!--polhode-data-->";

/// The page as HTML.
pub fn page(input: &PageInput<'_>) -> String {
    page_of(input.title, &page_data(input))
}

/// What a page holds besides the viewer, as JSON: [`page_of`] makes the page of it, here or elsewhere.
pub fn page_data(input: &PageInput<'_>) -> String {
    inert(&data::json(input, Room::Beside(TEMPLATE.len()), &mut Rows::Inside).to_string())
}

/// The same with triangles of so many bytes at most, for who has less room than a page of its own: [`has_triangles`] says whether it may
/// differ.
pub fn page_data_within(input: &PageInput<'_>, triangles: usize) -> String {
    inert(&data::json(input, Room::Of(triangles), &mut Rows::Inside).to_string())
}

/// Whether the body has triangles, which a page may have to show coarser than they are.
pub fn has_triangles(subject: &PageSubject<'_>) -> bool {
    shapes::has_triangles(&Turning::of(subject))
}

/// What a page holds besides the viewer, for who does not write it into a page: JSON, and its rows of numbers as little-endian f64, one after
/// the other. In their places the JSON has `{"f64": [at, count]}`, counted in numbers.
pub fn page_rows(input: &PageInput<'_>) -> (Value, Vec<u8>) {
    let mut rows = Rows::Beside(Vec::new());
    let value = data::json(input, Room::Beside(TEMPLATE.len()), &mut rows);
    (value, rows.bytes())
}

/// The page of a title and of what [`page_data`] gave.
pub fn page_of(title: &str, data: &str) -> String {
    // Only the template is searched: what is put in may say anything.
    let (before, after) = TEMPLATE.split_once(DATA).unwrap_or((TEMPLATE, ""));
    let (head, tail) = before.split_once("<title>").unwrap_or((before, "</title>"));
    let tail = tail.split_once("</title>").map_or(tail, |(_, rest)| rest);
    format!(
        "{head}<title>{}</title>{tail}<script id=\"polhode-data\" type=\"application/json\">{data}</script>{after}",
        escaped(title)
    )
}

/// JSON that no markup can hide in: these characters stand in its strings only.
fn inert(json: &str) -> String {
    let escaped = |text: String, c: char| text.replace(c, &format!("\\u{:04x}", u32::from(c)));
    ['<', '>', '&', '\u{2028}', '\u{2029}'].into_iter().fold(json.to_owned(), escaped)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_template_has_one_place_for_the_title_and_one_for_the_data() {
        for part in [DATA, "<title>", "</title>"] {
            assert_eq!(TEMPLATE.matches(part).count(), 1, "{part}");
        }
        assert!(TEMPLATE.find("<title>") < TEMPLATE.find(DATA));
    }

    #[test]
    fn inert_json_reads_back() {
        let value = serde_json::json!({ "a<b": "</script><!-- & \u{2028}\u{2029}\"\\" });
        let text = inert(&value.to_string());
        assert!(!text.contains(['<', '>', '&', '\u{2028}', '\u{2029}']), "{text}");
        assert_eq!(serde_json::from_str::<serde_json::Value>(&text).unwrap(), value);
    }
}
