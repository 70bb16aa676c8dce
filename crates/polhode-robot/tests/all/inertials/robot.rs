//! Robot whose links have exact inertials by closed forms, in four languages without inertials.

use std::fmt::Write as _;

use crate::common::{Matrix, applied, matrix_about, plus, times, transposed};

/// Solid in its own frame.
#[derive(Clone, Copy)]
pub(super) enum Solid {
    Box([f64; 3]),
    Cylinder(f64, f64),
    Sphere(f64),
    Capsule(f64, f64),
    Ellipsoid([f64; 3]),
    /// The tetrahedron of [`WEDGE`], scaled.
    Wedge([f64; 3]),
}

/// Solid placed in a link: position, roll, pitch, yaw.
#[derive(Clone, Copy)]
pub(super) struct Placed(pub(super) Solid, pub(super) [f64; 3], pub(super) [f64; 3]);

pub(super) struct Link {
    pub(super) name: &'static str,
    pub(super) density: f64,
    pub(super) solids: Vec<Placed>,
}

/// Mass, centre, and tensor about the centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exact(pub(super) f64, pub(super) [f64; 3], pub(super) Matrix);

/// Corners of a tetrahedron without symmetry.
const CORNERS: [[f64; 3]; 4] = [[0.1, -0.2, 0.05], [1.3, 0.2, -0.1], [0.2, 1.1, 0.3], [0.4, 0.3, 0.9]];

/// Mesh file of the tetrahedron.
pub(super) fn wedge() -> String {
    let corners = CORNERS.map(|[x, y, z]| format!("v {x} {y} {z}\n")).concat();
    corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
}

/// The tetrahedron as arrays of USD, in centimetres.
fn wedge_arrays() -> String {
    let corners = CORNERS.map(|corner| format!("({})", words(corner.map(|c| 100.0 * c), ", "))).join(", ");
    format!(
        "int[] faceVertexCounts = [3, 3, 3, 3]\n            int[] faceVertexIndices = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]\n            \
         point3f[] points = [{corners}]"
    )
}

/// Links without the ellipsoid, which URDF does not have; its cylinder touches no other solid.
pub(super) fn links() -> Vec<Link> {
    let link = |name, density, solids| Link { name, density, solids };
    vec![
        link(
            "base",
            2700.0,
            vec![Placed(Solid::Box([0.31, 0.22, 0.13]), [0.04, -0.03, 0.11], [0.3, -0.5, 1.1])],
        ),
        link(
            "upper_arm",
            1410.0,
            vec![
                Placed(Solid::Cylinder(0.043, 0.37), [0.01, 0.02, 0.19], [0.7, 0.2, -0.4]),
                Placed(Solid::Sphere(0.051), [-0.23, 0.31, 0.02], [0.0; 3]),
            ],
        ),
        link("ball", 7850.0, vec![Placed(Solid::Sphere(0.067), [0.02, -0.05, 0.03], [0.4, 0.1, 0.2])]),
        link(
            "forearm",
            950.0,
            vec![Placed(Solid::Capsule(0.031, 0.24), [-0.02, 0.07, 0.1], [-1.2, 0.6, 0.3])],
        ),
        link(
            "wedge",
            1130.0,
            vec![Placed(Solid::Wedge([0.21, 0.17, 0.26]), [0.05, 0.02, -0.04], [0.9, -0.2, 0.5])],
        ),
    ]
}

/// Links with an ellipsoid.
pub(super) fn links_and_egg() -> Vec<Link> {
    let egg = Placed(Solid::Ellipsoid([0.08, 0.05, 0.03]), [0.03, 0.01, -0.06], [0.2, 0.9, -0.7]);
    let mut links = links();
    links.push(Link { name: "egg", density: 3300.0, solids: vec![egg] });
    links
}

fn rotation([roll, pitch, yaw]: [f64; 3]) -> Matrix {
    times(matrix_about(2, yaw), times(matrix_about(1, pitch), matrix_about(0, roll)))
}

/// Quaternion (w, x, y, z) of roll, pitch, yaw.
fn quaternion(angles: [f64; 3]) -> [f64; 4] {
    let [(sr, cr), (sp, cp), (sy, cy)] = angles.map(|angle| (0.5 * angle).sin_cos());
    [
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    ]
}

impl Solid {
    /// Returns volume, centroid, and tensor about it at density 1, in the solid's frame.
    fn exact(self) -> Exact {
        let pi = std::f64::consts::PI;
        let diagonal = |volume: f64, [a, b, c]: [f64; 3]| {
            Exact(volume, [0.0; 3], [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]])
        };
        match self {
            Self::Box([a, b, c]) => {
                let v = a * b * c;
                diagonal(v, [b * b + c * c, a * a + c * c, a * a + b * b].map(|sum| v * sum / 12.0))
            }
            Self::Cylinder(r, h) => {
                let v = pi * r * r * h;
                let across = v * (3.0 * r * r + h * h) / 12.0;
                diagonal(v, [across, across, 0.5 * v * r * r])
            }
            Self::Sphere(r) => {
                let v = 4.0 / 3.0 * pi * r * r * r;
                diagonal(v, [0.4 * v * r * r; 3])
            }
            Self::Capsule(r, h) => {
                let (tube, balls) = (pi * r * r * h, 4.0 / 3.0 * pi * r * r * r);
                let axial = 0.5 * tube * r * r + 0.4 * balls * r * r;
                let across = tube * (3.0 * r * r + h * h) / 12.0
                    + balls * (0.4 * r * r + 0.25 * h * h + 3.0 / 8.0 * r * h);
                diagonal(tube + balls, [across, across, axial])
            }
            Self::Ellipsoid([a, b, c]) => {
                let v = 4.0 / 3.0 * pi * a * b * c;
                diagonal(v, [b * b + c * c, a * a + c * c, a * a + b * b].map(|sum| 0.2 * v * sum))
            }
            Self::Wedge(scale) => {
                let corners = CORNERS.map(|v| std::array::from_fn::<f64, 3, _>(|k| scale[k] * v[k]));
                let edge = |i: usize| std::array::from_fn::<f64, 3, _>(|k| corners[i][k] - corners[0][k]);
                let [a, b, c] = [edge(1), edge(2), edge(3)];
                let triple = a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0]);
                let v = triple.abs() / 6.0;
                let center: [f64; 3] =
                    std::array::from_fn(|k| corners.iter().map(|p| p[k]).sum::<f64>() / 4.0);
                // ∫x xᵀ dV about the centroid = V/20 Σ d dᵀ, as Σ d = 0.
                let second: Matrix = std::array::from_fn(|i| {
                    std::array::from_fn(|j| {
                        v / 20.0
                            * corners.iter().map(|p| (p[i] - center[i]) * (p[j] - center[j])).sum::<f64>()
                    })
                });
                let trace = second[0][0] + second[1][1] + second[2][2];
                let tensor = std::array::from_fn(|i| {
                    std::array::from_fn(|j| if i == j { trace - second[i][j] } else { -second[i][j] })
                });
                Exact(v, center, tensor)
            }
        }
    }
}

impl Link {
    /// Returns the exact inertial.
    pub(super) fn exact(&self) -> Exact {
        let parts: Vec<Exact> = self
            .solids
            .iter()
            .map(|Placed(solid, position, angles)| {
                let Exact(volume, center, tensor) = solid.exact();
                let turn = rotation(*angles);
                let tensor = times(times(turn, tensor), transposed(turn));
                let mass = self.density * volume;
                Exact(
                    mass,
                    plus(*position, applied(turn, center)),
                    tensor.map(|row| row.map(|x| self.density * x)),
                )
            })
            .collect();
        combined(&parts)
    }
}

/// Joins bodies by the parallel-axis theorem.
pub(super) fn combined(parts: &[Exact]) -> Exact {
    let mass: f64 = parts.iter().map(|part| part.0).sum();
    let center: [f64; 3] =
        std::array::from_fn(|k| parts.iter().map(|part| part.0 * part.1[k]).sum::<f64>() / mass);
    let mut tensor = [[0.0; 3]; 3];
    for Exact(m, c, own) in parts {
        let d: [f64; 3] = std::array::from_fn(|k| c[k] - center[k]);
        let square = d.iter().map(|x| x * x).sum::<f64>();
        for i in 0..3 {
            for j in 0..3 {
                tensor[i][j] += own[i][j] + m * (if i == j { square } else { 0.0 } - d[i] * d[j]);
            }
        }
    }
    Exact(mass, center, tensor)
}

fn words<const N: usize>(numbers: [f64; N], between: &str) -> String {
    numbers.map(|x| x.to_string()).join(between)
}

pub(super) fn urdf(links: &[Link]) -> String {
    let mut text = "<?xml version=\"1.0\"?>\n<!-- kept -->\n<robot name=\"r\">\n".to_owned();
    for Link { name, solids, .. } in links {
        let _ = writeln!(text, "  <link name=\"{name}\">");
        for Placed(solid, position, angles) in solids {
            let shape = match *solid {
                Solid::Box(size) => format!("<box size=\"{}\"/>", words(size, " ")),
                Solid::Cylinder(r, h) => format!("<cylinder radius=\"{r}\" length=\"{h}\"/>"),
                Solid::Sphere(r) => format!("<sphere radius=\"{r}\"/>"),
                Solid::Capsule(r, h) => format!("<capsule radius=\"{r}\" length=\"{h}\"/>"),
                Solid::Wedge(scale) => {
                    format!("<mesh filename=\"wedge.obj\" scale=\"{}\"/>", words(scale, " "))
                }
                Solid::Ellipsoid(_) => continue,
            };
            let (xyz, rpy) = (words(*position, " "), words(*angles, " "));
            let _ = writeln!(
                text,
                "    <visual><origin xyz=\"{xyz}\" rpy=\"{rpy}\"/><geometry>{shape}</geometry></visual>"
            );
        }
        text += "  </link>\n";
    }
    for pair in links.windows(2) {
        let _ = writeln!(
            text,
            "  <joint name=\"to_{1}\" type=\"revolute\"><parent link=\"{0}\"/><child link=\"{1}\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"9\" velocity=\"1\"/></joint>",
            pair[0].name, pair[1].name
        );
    }
    text + "</robot>\n"
}

pub(super) fn sdf(links: &[Link]) -> String {
    let mut text = "<sdf version=\"1.11\">\r\n\t<model name=\"r\">\r\n".to_owned();
    for Link { name, solids, .. } in links {
        let _ = write!(text, "\t\t<link name=\"{name}\">\r\n\t\t\t<pose>0.1 0.2 0.3 0.4 0.5 0.6</pose>\r\n");
        for (k, Placed(solid, position, angles)) in solids.iter().enumerate() {
            let shape = match *solid {
                Solid::Box(size) => format!("<box><size>{}</size></box>", words(size, " ")),
                Solid::Cylinder(r, h) => {
                    format!("<cylinder><radius>{r}</radius><length>{h}</length></cylinder>")
                }
                Solid::Sphere(r) => format!("<sphere><radius>{r}</radius></sphere>"),
                Solid::Capsule(r, h) => {
                    format!("<capsule><radius>{r}</radius><length>{h}</length></capsule>")
                }
                Solid::Ellipsoid(radii) => {
                    format!("<ellipsoid><radii>{}</radii></ellipsoid>", words(radii, " "))
                }
                Solid::Wedge(scale) => {
                    format!("<mesh><uri>wedge.obj</uri><scale>{}</scale></mesh>", words(scale, " "))
                }
            };
            let _ = write!(
                text,
                "\t\t\t<collision name=\"c{k}\"><pose>{} {}</pose><geometry>{shape}</geometry></collision>\r\n",
                words(*position, " "),
                words(*angles, " ")
            );
        }
        text += "\t\t</link>\r\n";
    }
    for pair in links.windows(2) {
        let _ = write!(
            text,
            "\t\t<joint name=\"to_{1}\" type=\"revolute\"><parent>{0}</parent><child>{1}</child><axis><xyz>0 0 1</xyz></axis></joint>\r\n",
            pair[0].name, pair[1].name
        );
    }
    text + "\t</model>\r\n</sdf>\r\n"
}

pub(super) fn mjcf(links: &[Link]) -> String {
    let mut text = "<mujoco model=\"r\">\n  <asset>\n".to_owned();
    for Placed(solid, ..) in links.iter().flat_map(|link| &link.solids) {
        if let Solid::Wedge(scale) = solid {
            let _ = writeln!(
                text,
                "    <mesh name=\"wedge\" file=\"wedge.obj\" scale=\"{}\" inertia=\"exact\"/>",
                words(*scale, " ")
            );
        }
    }
    text += "  </asset>\n  <worldbody>\n";
    for (depth, Link { name, solids, .. }) in links.iter().enumerate() {
        let _ = writeln!(
            text,
            "    <body name=\"{name}\" pos=\"0.1 0.2 0.3\"><joint name=\"to_{name}\" axis=\"0 0 1\"/>"
        );
        for Placed(solid, position, angles) in solids {
            let shape = match *solid {
                Solid::Box(size) => format!("type=\"box\" size=\"{}\"", words(size.map(|c| 0.5 * c), " ")),
                Solid::Cylinder(r, h) => format!("type=\"cylinder\" size=\"{r} {}\"", 0.5 * h),
                Solid::Sphere(r) => format!("size=\"{r}\""),
                Solid::Capsule(r, h) => format!("type=\"capsule\" size=\"{r} {}\"", 0.5 * h),
                Solid::Ellipsoid(radii) => format!("type=\"ellipsoid\" size=\"{}\"", words(radii, " ")),
                Solid::Wedge(_) => "type=\"mesh\" mesh=\"wedge\"".to_owned(),
            };
            let (pos, quat) = (words(*position, " "), words(quaternion(*angles), " "));
            let _ = writeln!(text, "      <geom {shape} pos=\"{pos}\" quat=\"{quat}\"/>");
        }
        let _ = depth;
    }
    text + &"    </body>\n".repeat(links.len()) + "  </worldbody>\n</mujoco>\n"
}

/// USD in centimetres and grams; the wedge is a `Mesh`.
pub(super) fn usda(links: &[Link]) -> String {
    let mut text = "#usda 1.0\n(\n    defaultPrim = \"r\"\n    kilogramsPerUnit = 0.001\n    metersPerUnit = 0.01\n)\n\ndef Xform \"r\"\n{\n".to_owned();
    let cm = |v: [f64; 3]| words(v.map(|c| 100.0 * c), ", ");
    for Link { name, solids, .. } in links {
        let _ = write!(
            text,
            "    def Xform \"{name}\" (\n        prepend apiSchemas = [\"PhysicsRigidBodyAPI\"]\n    )\n    {{\n"
        );
        for (k, Placed(solid, position, angles)) in solids.iter().enumerate() {
            let (kind, size, scale) = match *solid {
                Solid::Box(size) => ("Cube", "double size = 100".to_owned(), size),
                Solid::Cylinder(r, h) => (
                    "Cylinder",
                    format!("double radius = {}\n            double height = {}", 100.0 * r, 100.0 * h),
                    [1.0; 3],
                ),
                Solid::Capsule(r, h) => (
                    "Capsule",
                    format!("double radius = {}\n            double height = {}", 100.0 * r, 100.0 * h),
                    [1.0; 3],
                ),
                Solid::Sphere(r) => ("Sphere", format!("double radius = {}", 100.0 * r), [1.0; 3]),
                Solid::Ellipsoid(radii) => ("Sphere", "double radius = 100".to_owned(), radii),
                Solid::Wedge(scale) => ("Mesh", wedge_arrays(), scale),
            };
            let _ = write!(
                text,
                "        def {kind} \"shape{k}\" (\n            prepend apiSchemas = [\"PhysicsCollisionAPI\"]\n        )\n        {{\n            {size}\n            \
                 double3 xformOp:translate = ({})\n            quatd xformOp:orient = ({})\n            double3 xformOp:scale = ({})\n            \
                 uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\", \"xformOp:scale\"]\n        }}\n",
                cm(*position),
                words(quaternion(*angles), ", "),
                words(scale, ", ")
            );
        }
        text += "    }\n";
    }
    for pair in links.windows(2) {
        let _ = write!(
            text,
            "    def PhysicsRevoluteJoint \"to_{1}\"\n    {{\n        uniform token physics:axis = \"Z\"\n        rel physics:body0 = </r/{0}>\n        rel physics:body1 = </r/{1}>\n    }}\n",
            pair[0].name, pair[1].name
        );
    }
    text + "}\n"
}
