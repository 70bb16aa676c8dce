//! Packages that no root is or holds: found in an ancestor folder of their name, or below the
//! checked folder. Other files are not accessible.

use std::path::PathBuf;
use std::sync::Arc;

use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::model::{GeometryShape, RobotModel};
use polhode_robot::read::{CheckedFolder, ReadOptions, read_model};
use polhode_source::files::Disk;

use crate::common::Folder;

/// STL of a tetrahedron.
const STL: &str = "solid t
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 2 0 vertex 1 0 0 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 0 3 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 3 vertex 0 2 0 endloop endfacet
facet normal 0 0 0 outer loop vertex 1 0 0 vertex 0 2 0 vertex 0 0 3 endloop endfacet
endsolid t
";

fn urdf(uri: &str) -> String {
    format!(
        r#"<robot name="r"><link name="a"><collision><geometry><mesh filename="{uri}"/></geometry></collision></link></robot>"#
    )
}

fn in_folder(folder: &Folder, checked: &str) -> ReadOptions<'static> {
    let checked = CheckedFolder::new(&Disk, &folder.path(checked)).map(Arc::new);
    assert!(checked.is_some());
    ReadOptions { checked, ..ReadOptions::default() }
}

fn mesh(model: &RobotModel) -> Result<PathBuf, String> {
    let GeometryShape::Mesh { path, .. } = &model.links[0].geometry[0].shape else { panic!("a mesh") };
    path.clone()
}

fn notes(model: &RobotModel) -> Vec<(&str, &str)> {
    model.notes.iter().map(|note| (note.code, note.message.as_str())).collect()
}

#[test]
fn an_ancestor_folder_with_the_packages_name_is_the_package() {
    let folder = Folder::of(
        "ancestor",
        &[
            ("thing_description/urdf/deep/thing.urdf", &urdf("package://thing_description/meshes/block.stl")),
            ("thing_description/meshes/block.stl", STL),
            ("source/package.xml", "<package><name>other_description</name></package>"),
            ("source/nested/model.config", "<model/>"),
            ("source/nested/thing.urdf", &urdf("package://other_description/meshes/block.stl")),
            ("source/meshes/block.stl", STL),
        ],
    );
    let model =
        read_model(&folder.path("thing_description/urdf/deep/thing.urdf"), &ReadOptions::default()).unwrap();
    assert_eq!(mesh(&model), Ok(folder.path("thing_description/meshes/block.stl")));
    let told =
        "package://thing_description/… was found at ../.., an ancestor folder of the model with that name";
    assert_eq!(notes(&model), [("read.package", told)]);
    let found = inspect(&model, &Shapes::default()).findings;
    assert!(found.iter().all(|finding| finding.code != "geometry.unreadable"), "{found:?}");
    // Beyond the nearest package, by the name in `package.xml`.
    let model = read_model(&folder.path("source/nested/thing.urdf"), &ReadOptions::default()).unwrap();
    assert_eq!(mesh(&model), Ok(folder.path("source/meshes/block.stl")));
    // Not found if only the roots may be opened.
    let roots = vec![folder.path("thing_description/urdf")];
    let confined = ReadOptions { roots, confined: true, ..ReadOptions::default() };
    let model = read_model(&folder.path("thing_description/urdf/deep/thing.urdf"), &confined).unwrap();
    assert!(mesh(&model).unwrap_err().contains("no root contains it"));
}

#[test]
fn what_lies_outside_of_a_found_package_stays_closed() {
    let folder = Folder::of(
        "closed",
        &[
            ("thing/urdf/up.urdf", &urdf("package://thing/../secret.stl")),
            ("thing/urdf/absolute.urdf", &urdf("package://thing//secret.stl")),
            ("thing/urdf/link.urdf", &urdf("package://thing/meshes/link.stl")),
            ("thing/urdf/relative.urdf", &urdf("../../secret.stl")),
            ("thing/urdf/other.urdf", &urdf("package://nothing/secret.stl")),
            ("thing/meshes/own.stl", STL),
            ("secret.stl", STL),
        ],
    );
    #[cfg(unix)]
    std::os::unix::fs::symlink(folder.path("secret.stl"), folder.path("thing/meshes/link.stl")).unwrap();
    for name in ["up", "absolute", "link", "relative", "other"] {
        let path = folder.path(&format!("thing/urdf/{name}.urdf"));
        for options in [ReadOptions::default(), in_folder(&folder, "thing")] {
            assert!(mesh(&read_model(&path, &options).unwrap()).is_err(), "{name}");
        }
    }
}

#[test]
fn a_package_below_the_checked_folder_is_found_if_it_is_the_only_one() {
    let uri = "package://arm_description/meshes/block.stl";
    let folder = Folder::of(
        "below",
        &[
            ("ws/bringup/urdf/arm.urdf", &urdf(uri)),
            ("ws/vendor/arm_description/meshes/block.stl", STL),
            // A folder with that name but without the file.
            ("ws/old/arm_description/readme", ""),
            ("ws/.hidden/arm_description/meshes/block.stl", STL),
            ("arm_description/meshes/block.stl", STL),
        ],
    );
    let path = folder.path("ws/bringup/urdf/arm.urdf");
    assert!(mesh(&read_model(&path, &ReadOptions::default()).unwrap()).is_err());
    let model = read_model(&path, &in_folder(&folder, "ws")).unwrap();
    assert_eq!(mesh(&model), Ok(folder.path("ws/vendor/arm_description/meshes/block.stl")));
    let told = "package://arm_description/… was found at ../../vendor/arm_description, the only folder of that name below the checked folder \
                that contains this file";
    assert_eq!(notes(&model), [("read.package", told)]);

    std::fs::create_dir_all(folder.path("ws/new/description/meshes")).unwrap();
    std::fs::write(folder.path("ws/new/description/meshes/block.stl"), STL).unwrap();
    std::fs::write(
        folder.path("ws/new/description/package.xml"),
        "<package> <name>arm_description</name></package>",
    )
    .unwrap();
    let why = mesh(&read_model(&path, &in_folder(&folder, "ws")).unwrap()).unwrap_err();
    assert_eq!(
        why,
        "2 folders named arm_description contain it, ../../new/description and ../../vendor/arm_description; choose one with --root DIR"
    );
    let options = ReadOptions { roots: vec![folder.path("ws/vendor")], ..in_folder(&folder, "ws") };
    let model = read_model(&path, &options).unwrap();
    assert_eq!(mesh(&model), Ok(folder.path("ws/vendor/arm_description/meshes/block.stl")));
    assert_eq!(notes(&model), []);
}

#[test]
fn uris_without_a_package_and_files_above_the_model_are_found_in_the_checked_folder() {
    let include = r#"<mujoco><include file="../../common/body.xml"/></mujoco>"#;
    let body =
        r#"<mujocoinclude><worldbody><body name="a"><geom size="0.1"/></body></worldbody></mujocoinclude>"#;
    let folder = Folder::of(
        "above",
        &[
            ("ws/robot/urdf/empty.urdf", &urdf("package:///meshes/block.stl")),
            ("ws/robot/urdf/slip.urdf", &urdf("package:///robot/meshes/block.stl")),
            ("ws/robot/urdf/file.urdf", &urdf("file://meshes/block.stl")),
            ("ws/robot/urdf/above.urdf", &urdf("../meshes/block.stl")),
            ("ws/robot/meshes/block.stl", STL),
            ("ws/robot/urdf/scene.xml", include),
            ("ws/common/body.xml", body),
        ],
    );
    for (name, told) in [
        ("empty", Some("package:///… names no package; its files were found relative to ..")),
        ("slip", Some("package:///… names no package; its files were found relative to ../..")),
        ("file", Some("file://… names no package; its files were found relative to ..")),
        ("above", None),
    ] {
        let path = folder.path(&format!("ws/robot/urdf/{name}.urdf"));
        let model = read_model(&path, &in_folder(&folder, "ws")).unwrap();
        assert_eq!(mesh(&model), Ok(folder.path("ws/robot/meshes/block.stl")), "{name}");
        assert_eq!(notes(&model), told.map(|told| ("read.package", told)).as_slice(), "{name}");
        let alone = mesh(&read_model(&path, &ReadOptions::default()).unwrap());
        assert_eq!(alone.is_ok(), name == "slip", "{name}: {alone:?}");
    }
    // A third slash before the package.
    let model = read_model(&folder.path("ws/robot/urdf/slip.urdf"), &ReadOptions::default()).unwrap();
    let told = "package:///robot/… was found at .., an ancestor folder of the model with that name";
    assert_eq!(notes(&model), [("read.package", told)]);
    let scene = folder.path("ws/robot/urdf/scene.xml");
    let model = read_model(&scene, &in_folder(&folder, "ws")).unwrap();
    assert_eq!((model.links.len(), model.included.len()), (1, 1));
    let alone = read_model(&scene, &ReadOptions::default()).unwrap();
    assert_eq!((alone.links.len(), notes(&alone)[0].0), (0, "read.include"));
}
