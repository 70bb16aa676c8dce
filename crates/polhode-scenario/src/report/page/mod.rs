//! Interactive page of a motion: one file that a browser opens without a server.
//!
//! The page is the viewer (`viewer/`, built to `assets/viewer.html`) with the motion as JSON, in
//! the format of `viewer/src/data.ts`. Numbers are bit-identical to the trajectory. Text from
//! outside cannot become markup.

mod atoms;
mod body;
mod caption;
mod cones;
mod contact;
mod data;
mod decimate;
mod directions;
mod explanation;
mod facts;
mod free;
mod motion;
mod orbit;
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
pub use explanation::page_blocks;
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

/// Content of a page.
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
    /// Title of the page; text, never markup.
    pub title: &'a str,
    /// Command that made the page: `polhode 0.1.0 simulate examples/t-handle.toml`.
    pub source: &'a str,
    /// Text of the scenario file.
    pub scenario_text: Option<&'a str>,
    /// Body of the motion.
    pub subject: PageSubject<'a>,
    /// Motion to be shown.
    pub trajectory: &'a Trajectory,
    /// Worked solution of the motion.
    pub explanation: Option<&'a Document>,
    /// True to include the data that depend on the body alone: shapes, and other motions on the
    /// momentum sphere.
    ///
    /// A caller that shows several motions of one body needs them only once.
    pub whole: bool,
}

impl PageInput<'_> {
    /// Returns true if the page shows the curves of a free motion.
    pub fn is_free(&self) -> bool {
        free::facts(self).is_some()
    }
}

/// Body of a page.
#[derive(Clone, Copy, Debug)]
pub enum PageSubject<'a> {
    /// Body of a scenario.
    Scenario(&'a Scenario),
    /// Free body known by its moments about the centre of mass only.
    Moments(&'a PrincipalFrame<Body>),
}

/// Viewer as HTML, with a placeholder for the data.
const TEMPLATE: &str = include_str!("../../../assets/viewer.html");

/// Placeholder for the data in the template.
const DATA: &str = "<!--polhode-data-->";

/// Returns the page as HTML.
pub fn page(input: &PageInput<'_>) -> String {
    page_of(input.title, &page_data(input))
}

/// Returns the data of a page as JSON; [`page_of`] builds the page from it.
pub fn page_data(input: &PageInput<'_>) -> String {
    inert(&data::json(input, Room::Beside(TEMPLATE.len()), &mut Rows::Inside).to_string())
}

/// Returns the data of a page with meshes of at most `triangles` bytes, for callers with limited
/// space.
///
/// [`has_triangles`] returns whether the result may differ from that of [`page_data`].
pub fn page_data_within(input: &PageInput<'_>, triangles: usize) -> String {
    inert(&data::json(input, Room::Of(triangles), &mut Rows::Inside).to_string())
}

/// Returns true if the body has a mesh, which a page may have to simplify.
pub fn has_triangles(subject: &PageSubject<'_>) -> bool {
    shapes::has_triangles(&Turning::of(subject))
}

/// Returns the data of a page as JSON, with the long rows of numbers separate as little-endian f64.
///
/// The JSON contains `{"f64": [start, count]}` for each such row, in units of numbers.
pub fn page_rows(input: &PageInput<'_>) -> (Value, Vec<u8>) {
    let mut rows = Rows::Beside(Vec::new());
    let value = data::json(input, Room::Beside(TEMPLATE.len()), &mut rows);
    (value, rows.bytes())
}

/// Returns the page for a title and the result of [`page_data`].
pub fn page_of(title: &str, data: &str) -> String {
    // Only the template is searched, because the data may contain any text.
    let (before, after) = TEMPLATE.split_once(DATA).unwrap_or((TEMPLATE, ""));
    let (head, tail) = before.split_once("<title>").unwrap_or((before, "</title>"));
    let tail = tail.split_once("</title>").map_or(tail, |(_, rest)| rest);
    format!(
        "{head}<title>{}</title>{tail}<script id=\"polhode-data\" type=\"application/json\">{data}</script>{after}",
        escaped(title)
    )
}

/// Escapes characters of JSON that could start markup; they occur in strings only.
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
