//! Settings in `<compiler>`.

use crate::finding::Severity;
use crate::model::{Note, Number, Pose};
use crate::pose::{about, about_axis, of_x_and_y, of_z_axis, product, unit};
use crate::read::pose::Reading;
use crate::read::xml::{Element, Written, is_true};

use super::defaults::Source;

/// Setting `inertiafromgeom`: use of geoms for masses and tensors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FromGeometry {
    /// Geoms are never used.
    Never,
    /// Geoms are used for bodies without `<inertial>`.
    Auto,
    /// Geoms are always used; `<inertial>` is ignored.
    Always,
}

/// Settings for angles, files and inertials.
#[derive(Debug)]
pub(super) struct Settings<'a> {
    radians: bool,
    euler_order: &'a str,
    pub(super) mesh_folder: &'a str,
    pub(super) strip_path: bool,
    pub(super) from_geometry: FromGeometry,
    /// Range of geom groups that have mass.
    pub(super) groups: [f64; 2],
    /// True if mesh volumes use signed triangles: a setting of versions before MuJoCo 3.3.
    pub(super) exact_meshes: bool,
    /// True if primitives are fitted to the bounds of a mesh instead of its moments.
    pub(super) fit_bounds: bool,
    /// True if a range implies that a joint has limits: `autolimits`.
    pub(super) limits_by_range: bool,
    /// Lower bound on the mass of a body, kg.
    pub(super) bound_mass: f64,
    /// Lower bound on the moments of a body, kg·m².
    pub(super) bound_inertia: f64,
    /// True if unphysical moments are replaced by equal ones.
    pub(super) balance: bool,
    /// Required total mass, kg; not applied if it is not positive.
    pub(super) total_mass: f64,
    /// Reason why the masses are unknown: a setting that cannot be read.
    pub(super) unreadable: Option<String>,
}

/// Settings with a fixed set of values; MuJoCo rejects others.
const WORDS: [(&str, &[&str]); 9] = [
    ("angle", &["degree", "radian"]),
    ("inertiafromgeom", &["false", "true", "auto"]),
    ("strippath", TRUTHS),
    ("exactmeshinertia", TRUTHS),
    ("fitaabb", TRUTHS),
    ("balanceinertia", TRUTHS),
    ("fusestatic", TRUTHS),
    ("autolimits", TRUTHS),
    ("coordinate", &["local", "global"]),
];
const TRUTHS: &[&str] = &["false", "true"];

impl<'a> Settings<'a> {
    /// Combines the settings of all `<compiler>` elements; the last value of a setting counts.
    pub(super) fn of(root: Element<'a>, notes: &mut Vec<Note>) -> Self {
        let mut settings = Self {
            radians: false,
            euler_order: "xyz",
            mesh_folder: "",
            strip_path: false,
            from_geometry: FromGeometry::Auto,
            groups: [0.0, 5.0],
            exact_meshes: false,
            fit_bounds: false,
            limits_by_range: true,
            bound_mass: 0.0,
            bound_inertia: 0.0,
            balance: false,
            total_mass: -1.0,
            unreadable: None,
        };
        for element in root.named("compiler") {
            settings.radians = element.word("angle").map_or(settings.radians, |angle| angle == "radian");
            settings.euler_order = element.word("eulerseq").unwrap_or(settings.euler_order);
            let folder = element.word("meshdir").or(element.word("assetdir"));
            settings.mesh_folder = folder.unwrap_or(settings.mesh_folder);
            settings.from_geometry = match element.word("inertiafromgeom") {
                Some("true") => FromGeometry::Always,
                Some("false") => FromGeometry::Never,
                Some(_) => FromGeometry::Auto,
                None => settings.from_geometry,
            };
            let groups = element.attribute("inertiagrouprange").and_then(|range| range.array());
            settings.groups = groups.unwrap_or(settings.groups);
            for (name, setting) in [
                ("strippath", &mut settings.strip_path),
                ("exactmeshinertia", &mut settings.exact_meshes),
                ("fitaabb", &mut settings.fit_bounds),
                ("autolimits", &mut settings.limits_by_range),
                ("balanceinertia", &mut settings.balance),
            ] {
                *setting = element.word(name).map_or(*setting, is_true);
            }
            for (name, setting) in [
                ("boundmass", &mut settings.bound_mass),
                ("boundinertia", &mut settings.bound_inertia),
                ("settotalmass", &mut settings.total_mass),
            ] {
                *setting = element.word(name).and_then(|word| word.parse().ok()).unwrap_or(*setting);
            }
            notes.extend(Self::not_done(element));
            settings.refused(element, notes);
        }
        settings
    }

    /// Reports settings that MuJoCo rejects. The masses are then unknown.
    fn refused(&mut self, compiler: Element<'a>, notes: &mut Vec<Note>) {
        let mut refuse = |written: Written<'a>, name: &str, expected: &str| {
            let says = if is_hexadecimal(written.value) {
                "is hexadecimal, which is not read".to_owned()
            } else {
                format!("is not {expected}: MuJoCo refuses the file")
            };
            let message = format!("{name}={:?} {says}", written.value);
            self.unreadable.get_or_insert(format!("<compiler> has {name}={:?}", written.value));
            let note = Note::new("read.compiler", "", written.span, message);
            notes.push(Note { severity: Severity::Suspect, ..note });
        };
        for (name, words) in WORDS {
            if let Some(written) = compiler.attribute(name).filter(|written| !words.contains(&written.value))
            {
                refuse(written, name, &words.join(" or "));
            }
        }
        for (name, count) in
            [("boundmass", 1), ("boundinertia", 1), ("settotalmass", 1), ("inertiagrouprange", 2)]
        {
            let is_right = |written: &Written<'_>| {
                // An empty text leaves the setting unchanged, and MuJoCo accepts NaN.
                let is_number = |number: Number| number.value.is_some_and(|value| !value.is_infinite());
                written.value.is_empty()
                    || written.numbers().count() == count && written.numbers().all(is_number)
            };
            if let Some(written) = compiler.attribute(name).filter(|written| !is_right(written)) {
                refuse(written, name, if count == 1 { "a number" } else { "two numbers" });
            }
        }
        if let Some(written) = compiler.attribute("eulerseq").filter(|written| written.value.len() != 3) {
            refuse(written, "eulerseq", "three of x y z X Y Z");
        }
    }

    /// Returns notes on settings that are not applied here.
    fn not_done(compiler: Element<'a>) -> impl Iterator<Item = Note> {
        let global = compiler.attribute("coordinate").filter(|written| written.value == "global");
        let fused = compiler.attribute("fusestatic").filter(|written| is_true(written.value));
        let global = global.map(|written| {
            (written, "global coordinates are read as local ones: MuJoCo does not support them since 2.3.4")
        });
        let fused = fused.map(|written| {
            (
                written,
                "fusestatic merges bodies without joints into their parents; `check` treats each separately",
            )
        });
        let note = |(written, message): (Written<'a>, &str)| {
            Note::new("read.compiler", "", written.span, message.to_owned())
        };
        global.into_iter().chain(fused).map(note)
    }

    /// Converts an angle to radians.
    pub(super) fn angle(&self, angle: f64) -> f64 {
        if self.radians { angle } else { angle.to_radians() }
    }

    /// Returns the attitude in `quat`, `axisangle`, `euler`, `xyaxes` or `zaxis`; `None` if there
    /// is none of them.
    pub(super) fn attitude(&self, reading: &mut Reading, source: &Source<'_, 'a>) -> Option<[f64; 4]> {
        let forms = ["quat", "axisangle", "euler", "xyaxes", "zaxis"];
        let (form, written) =
            forms.iter().find_map(|form| source.written(form).map(|written| (*form, written)))?;
        let rotation = match form {
            "quat" => unit(numbers(reading, &written)),
            "axisangle" => {
                let [x, y, z, angle] = numbers(reading, &written);
                about_axis([x, y, z], self.angle(angle))
            }
            "euler" => self.euler(numbers(reading, &written)),
            "xyaxes" => {
                let [a, b, c, d, e, f] = numbers(reading, &written);
                of_x_and_y([a, b, c], [d, e, f])
            }
            _ => of_z_axis(numbers(reading, &written)),
        };
        if rotation.is_none() {
            reading.refuse(&written);
        }
        Some(rotation.unwrap_or(Pose::IDENTITY.rotation))
    }

    /// Composes three rotations in order, about rotating axes (x, y, z) or fixed axes (X, Y, Z).
    pub(super) fn euler(&self, angles: [f64; 3]) -> Option<[f64; 4]> {
        let axes = self.euler_order.as_bytes();
        let mut rotation = Pose::IDENTITY.rotation;
        for (axis, angle) in axes.iter().zip(angles) {
            let number = [b'x', b'y', b'z'].iter().position(|name| name.eq_ignore_ascii_case(axis))?;
            let turn = about(number, self.angle(angle));
            rotation =
                if axis.is_ascii_lowercase() { product(rotation, turn) } else { product(turn, rotation) };
        }
        (axes.len() == 3).then_some(rotation)
    }
}

/// Returns true for hexadecimal numbers such as `0x10`, which MuJoCo accepts.
fn is_hexadecimal(text: &str) -> bool {
    let digits = text.trim().trim_start_matches(['+', '-']);
    digits.get(..2).is_some_and(|start| start.eq_ignore_ascii_case("0x"))
}

fn numbers<const N: usize>(reading: &mut Reading, written: &Written<'_>) -> [f64; N] {
    reading.numbers(Some(written), [0.0; N])
}
