//! Six kinds of models, each with its own conventions.

use super::solid::{Spec, quaternion, roll_pitch_yaw};

/// Model language, or URDF with meshes as shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Language {
    Urdf,
    Sdf,
    Mjcf,
    Usd,
    Osim,
    UrdfOfMeshes,
}

impl Language {
    pub(super) const ALL: [Self; 6] =
        [Self::Urdf, Self::Sdf, Self::Mjcf, Self::Usd, Self::Osim, Self::UrdfOfMeshes];

    pub(super) const fn ending(self) -> &'static str {
        match self {
            Self::Urdf | Self::UrdfOfMeshes => "urdf",
            Self::Sdf => "sdf",
            Self::Mjcf => "xml",
            Self::Usd => "usda",
            Self::Osim => "osim",
        }
    }

    /// Returns a model of moving links.
    pub(super) fn model(self, specs: &[Spec]) -> String {
        let links: String = specs.iter().map(|spec| self.link(spec)).collect();
        let joints: String = specs.iter().map(|spec| self.joint(&spec.name)).collect();
        match self {
            Self::Urdf | Self::UrdfOfMeshes => {
                format!("<robot name=\"r\">\n<link name=\"base\"/>\n{links}{joints}</robot>\n")
            }
            Self::Sdf => format!("<sdf version=\"1.10\"><model name=\"r\">\n{links}{joints}</model></sdf>\n"),
            Self::Mjcf => format!(
                "<mujoco model=\"r\"><compiler inertiafromgeom=\"auto\"/><worldbody>\n{links}</worldbody></mujoco>\n"
            ),
            Self::Usd => format!(
                "#usda 1.0\n(\n    metersPerUnit = 1\n    upAxis = \"Y\"\n)\ndef Xform \"r\"\n{{\n{links}}}\n"
            ),
            Self::Osim => format!(
                "<OpenSimDocument Version=\"40000\"><Model name=\"r\"><BodySet><objects>\n{links}</objects></BodySet>\n\
                 <JointSet><objects>\n{joints}</objects></JointSet></Model></OpenSimDocument>\n"
            ),
        }
    }

    fn joint(self, name: &str) -> String {
        match self {
            Self::Urdf | Self::UrdfOfMeshes => format!(
                "<joint name=\"to_{name}\" type=\"continuous\"><parent link=\"base\"/><child link=\"{name}\"/><axis xyz=\"0 0 1\"/></joint>\n"
            ),
            Self::Osim => format!(
                "<FreeJoint name=\"to_{name}\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/{name}</socket_child_frame></FreeJoint>\n"
            ),
            Self::Sdf | Self::Mjcf | Self::Usd => String::new(),
        }
    }

    /// Returns a link in the language's conventions: rpy, rpy in degrees, quaternions (scalar
    /// first), half sizes, or a scaled cube.
    fn link(self, spec: &Spec) -> String {
        let Spec { name, mass, center: [x, y, z], six: [xx, yy, zz, xy, xz, yz], solid, .. } = spec;
        let ([a, b, c], [px, py, pz]) = (solid.edges, solid.place);
        let ([r, p, w], [sr, sp, sw]) = (roll_pitch_yaw(&spec.frame), roll_pitch_yaw(&solid.attitude));
        let ([qw, qx, qy, qz], [sqw, sqx, sqy, sqz]) = (quaternion(&spec.frame), quaternion(&solid.attitude));
        match self {
            Self::Urdf | Self::UrdfOfMeshes => {
                let shape = if self == Self::Urdf {
                    format!("<box size=\"{a} {b} {c}\"/>")
                } else {
                    format!("<mesh filename=\"cube.stl\" scale=\"{a} {b} {c}\"/>")
                };
                format!(
                    "<link name=\"{name}\"><inertial><origin xyz=\"{x} {y} {z}\" rpy=\"{r} {p} {w}\"/><mass value=\"{mass}\"/>\n\
                     <inertia ixx=\"{xx}\" ixy=\"{xy}\" ixz=\"{xz}\" iyy=\"{yy}\" iyz=\"{yz}\" izz=\"{zz}\"/></inertial>\n\
                     <collision><origin xyz=\"{px} {py} {pz}\" rpy=\"{sr} {sp} {sw}\"/><geometry>{shape}</geometry></collision></link>\n"
                )
            }
            Self::Sdf => {
                let [r, p, w] = [r, p, w].map(f64::to_degrees);
                format!(
                    "<link name=\"{name}\"><inertial><pose degrees=\"true\">{x} {y} {z} {r} {p} {w}</pose><mass>{mass}</mass>\n\
                     <inertia><ixx>{xx}</ixx><ixy>{xy}</ixy><ixz>{xz}</ixz><iyy>{yy}</iyy><iyz>{yz}</iyz><izz>{zz}</izz></inertia></inertial>\n\
                     <collision name=\"c\"><pose rotation_format=\"quat_xyzw\">{px} {py} {pz} {sqx} {sqy} {sqz} {sqw}</pose>\n\
                     <geometry><box><size>{a} {b} {c}</size></box></geometry></collision></link>\n"
                )
            }
            Self::Mjcf => {
                let tensor = if spec.is_diagonal() {
                    format!("quat=\"{qw} {qx} {qy} {qz}\" diaginertia=\"{xx} {yy} {zz}\"")
                } else {
                    format!("fullinertia=\"{xx} {yy} {zz} {xy} {xz} {yz}\"")
                };
                let [a, b, c] = [a, b, c].map(|edge| 0.5 * edge);
                format!(
                    "<body name=\"{name}\"><freejoint name=\"to_{name}\"/><inertial pos=\"{x} {y} {z}\" mass=\"{mass}\" {tensor}/>\n\
                     <geom type=\"box\" size=\"{a} {b} {c}\" pos=\"{px} {py} {pz}\" quat=\"{sqw} {sqx} {sqy} {sqz}\"/></body>\n"
                )
            }
            Self::Usd => format!(
                "def Xform \"{name}\" (\n prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]\n)\n{{\n\
                 float physics:mass = {mass}\npoint3f physics:centerOfMass = ({x}, {y}, {z})\n\
                 float3 physics:diagonalInertia = ({xx}, {yy}, {zz})\nquatf physics:principalAxes = ({qw}, {qx}, {qy}, {qz})\n\
                 def Cube \"shape\" ( prepend apiSchemas = [\"PhysicsCollisionAPI\"] )\n{{\ndouble size = 1\n\
                 double3 xformOp:translate = ({px}, {py}, {pz})\nquatd xformOp:orient = ({sqw}, {sqx}, {sqy}, {sqz})\n\
                 double3 xformOp:scale = ({a}, {b}, {c})\n\
                 uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\", \"xformOp:scale\"]\n}}\n}}\n"
            ),
            Self::Osim => format!(
                "<Body name=\"{name}\"><mass>{mass}</mass><mass_center>{x} {y} {z}</mass_center>\n\
                 <inertia>{xx} {yy} {zz} {xy} {xz} {yz}</inertia></Body>\n"
            ),
        }
    }

    /// Returns the numbers in the form of the language. If it has no products, these are moments in
    /// the body's principal axes.
    pub(super) fn spec(self, solid: &super::solid::Solid, name: &str) -> Spec {
        match self {
            Self::Urdf | Self::Sdf | Self::UrdfOfMeshes => {
                solid.framed(name, &crate::check_common::turn([0.3, -0.5, 0.8]))
            }
            Self::Mjcf | Self::Osim => solid.full(name),
            Self::Usd => solid.principal(name),
        }
    }
}
