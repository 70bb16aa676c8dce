//! Models of several files, in a folder.

use crate::client::Folder;

/// Mesh of a tetrahedron without edges of equal length, m.
pub(crate) const SOLID: &str = "mtllib paint.mtl\nv 0.1 0.2 -0.1\nv 1.3 0.1 0.2\nv 0.4 1.7 0.3\nv 0.2 0.5 1.9\n\
                                f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

/// Scenario with a mesh in another folder.
pub(crate) const SCENARIO: &str = "[[body.part]]\nshape = \"mesh\"\nfile = \"../meshes/solid.obj\"\nunit = \"m\"\nmass = 1.5\n\
                                   [start]\nspin = { body = [0.1, 0.7, -0.2] }\n[run]\nduration = 1\nsamples = 3\n";

/// Robot with a mesh of its package.
const ROBOT: &str = "<robot name=\"arm\"><link name=\"base\"><inertial><mass value=\"1.3\"/>\
                     <inertia ixx=\"1.1\" ixy=\"0.1\" ixz=\"0\" iyy=\"1.2\" iyz=\"0\" izz=\"1.3\"/></inertial>\
                     <visual><geometry><mesh filename=\"package://arm/meshes/solid.obj\"/></geometry></visual></link></robot>";

/// Writes a scenario and a robot that use one mesh, and a file that nothing names.
pub(crate) fn model(name: &str) -> Folder {
    let folder = Folder::new(name);
    folder.file("meshes/solid.obj", SOLID);
    folder.file("scenarios/one.toml", SCENARIO);
    folder.file("package.xml", "<package><name>arm</name></package>");
    folder.file("urdf/arm.urdf", ROBOT);
    folder.file("notes.txt", "private");
    folder
}
