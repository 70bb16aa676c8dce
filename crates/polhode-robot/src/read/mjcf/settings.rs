//! What `<compiler>` says of how the rest is meant.

use crate::model::{Note, Pose};
use crate::pose::{about, about_axis, of_x_and_y, of_z_axis, product, unit};
use crate::read::pose::Reading;
use crate::read::xml::{Element, Written, is_true};

use super::defaults::Source;

/// Whether masses and tensors come from geoms: `inertiafromgeom`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FromGeometry {
    /// Never.
    Never,
    /// For bodies that have no `<inertial>`.
    Auto,
    /// For all; `<inertial>` does not count.
    Always,
}

/// How angles, files and inertials are meant.
#[derive(Debug)]
pub(super) struct Settings<'a> {
    radians: bool,
    euler_order: &'a str,
    pub(super) mesh_folder: &'a str,
    pub(super) strip_path: bool,
    pub(super) from_geometry: FromGeometry,
}

impl<'a> Settings<'a> {
    /// The settings of all `<compiler>` elements together: of two that say the same thing, the later counts.
    pub(super) fn of(root: Element<'a>, notes: &mut Vec<Note>) -> Self {
        let mut settings = Self {
            radians: false,
            euler_order: "xyz",
            mesh_folder: "",
            strip_path: false,
            from_geometry: FromGeometry::Auto,
        };
        let mut asset_folder = "";
        for element in root.children() {
            match element.name() {
                "compiler" => {}
                "include" => {
                    let message = format!(
                        "<include> of {:?} is not read: defaults, meshes and bodies in it are not known here",
                        element.word("file").unwrap_or("")
                    );
                    notes.push(Note::new("read.include", "", element.span(), message));
                    continue;
                }
                _ => continue,
            }
            settings.radians = element.word("angle").map_or(settings.radians, |angle| angle == "radian");
            settings.euler_order = element.word("eulerseq").unwrap_or(settings.euler_order);
            settings.mesh_folder = element.word("meshdir").unwrap_or(settings.mesh_folder);
            asset_folder = element.word("assetdir").unwrap_or(asset_folder);
            settings.strip_path = element.word("strippath").map_or(settings.strip_path, is_true);
            settings.from_geometry = match element.word("inertiafromgeom") {
                Some("true") => FromGeometry::Always,
                Some("false") => FromGeometry::Never,
                Some(_) => FromGeometry::Auto,
                None => settings.from_geometry,
            };
            notes.extend(Self::changes(element));
        }
        if settings.mesh_folder.is_empty() {
            settings.mesh_folder = asset_folder;
        }
        settings
    }

    /// What MuJoCo does to masses and tensors after reading them, which is not done here.
    fn changes(compiler: Element<'a>) -> impl Iterator<Item = Note> {
        let active = |name: &str, word: &str| match name {
            "balanceinertia" => is_true(word),
            "coordinate" => word == "global",
            "settotalmass" => word.parse::<f64>().is_ok_and(|mass| mass > 0.0),
            _ => word.parse::<f64>().is_ok_and(|bound| bound != 0.0),
        };
        ["balanceinertia", "boundmass", "boundinertia", "settotalmass", "coordinate"].into_iter().filter_map(
            move |name| {
                let written = compiler.attribute(name).filter(|written| active(name, written.value))?;
                let message = match name {
                    "coordinate" => "global coordinates are read as local ones".to_owned(),
                    _ => format!("{name}: MuJoCo changes what it reads; here it stands as it is written"),
                };
                Some(Note::new("read.compiler", "", written.span, message))
            },
        )
    }

    /// An angle in radians.
    fn angle(&self, angle: f64) -> f64 {
        if self.radians { angle } else { angle.to_radians() }
    }

    /// The attitude that `quat`, `axisangle`, `euler`, `xyaxes` or `zaxis` says; `None` if there is none of them.
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

    /// Three turns in order: about axes that turn with the body (x, y, z), or that stay (X, Y, Z).
    fn euler(&self, angles: [f64; 3]) -> Option<[f64; 4]> {
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

fn numbers<const N: usize>(reading: &mut Reading, written: &Written<'_>) -> [f64; N] {
    reading.numbers(Some(written), [0.0; N])
}
