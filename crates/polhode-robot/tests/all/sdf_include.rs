//! SDF models that include models.

use polhode_robot::line_index::Places;
use polhode_robot::model::{JointKind, RobotModel};
use polhode_robot::read::{ReadOptions, read_model};

use crate::common::{Folder, applied, assert_close, assert_near, matrix_about, plus, times, transposed};

const WHEEL: &str = r#"<sdf version="1.9"><model name="wheel">
  <pose>9 9 9 0 0 0</pose>
  <link name="rim"><pose>0 0 0.3 0.2 0 0</pose><inertial><mass>2.5</mass></inertial></link>
  <frame name="hub"><pose relative_to="rim">0.1 0 0 0 0.4 0</pose></frame>
  <link name="cap"><pose relative_to="hub">0 0.2 0 0 0 0</pose></link>
  <joint name="push" type="fixed"><parent>rim</parent><child>cap</child></joint></model></sdf>"#;

const CONFIG: &str =
    r#"<model><name>Wheel</name><sdf version="1.4">old.sdf</sdf><sdf version="1.10">model.sdf</sdf></model>"#;

fn files(world: &str) -> [(&str, &str); 4] {
    [
        ("world.sdf", world),
        ("wheel/model.config", CONFIG),
        ("wheel/model.sdf", WHEEL),
        ("wheel/old.sdf", "<sdf><model name='old'><link name='x'/></model></sdf>"),
    ]
}

fn read(folder: &Folder) -> RobotModel {
    read_model(&folder.path("world.sdf"), &ReadOptions::default()).unwrap()
}

fn names(model: &RobotModel) -> Vec<&str> {
    model.links.iter().map(|link| link.name.text.as_str()).collect()
}

#[test]
fn an_included_model_has_the_name_and_the_place_that_its_include_gives() {
    let world = r#"<sdf version="1.9"><world name="w">
      <include><uri>model://wheel</uri><name>left</name><pose>1 2 3 0 0 0.5</pose></include>
      <include><uri>wheel</uri></include>
      <model name="cart"><pose>0 0 5 0 0 0</pose><link name="bed"><pose>1 0 0 0.7 0 0</pose></link>
        <include><uri>wheel/model.sdf</uri><name>spare</name><pose relative_to="bed">0 1 0 0 0 0</pose><placement_frame>hub</placement_frame><static>1</static></include>
        <joint name="hold" type="fixed"><parent>bed</parent><child>spare::cap</child></joint>
      </model></world></sdf>"#;
    let folder = Folder::of("sdf-include", &files(world));
    let model = read(&folder);
    assert!(model.notes.is_empty(), "{:?}", model.notes);
    assert_eq!(
        names(&model),
        [
            "left::rim",
            "left::cap",
            "wheel::rim",
            "wheel::cap",
            "cart::bed",
            "cart::spare::rim",
            "cart::spare::cap"
        ]
    );
    let still: Vec<_> = model.links.iter().map(|link| link.is_static).collect();
    assert_eq!(still, [false, false, false, false, false, true, true]);

    let turn = matrix_about(2, 0.5);
    assert_close(model.links[0].pose.position, plus([1.0, 2.0, 3.0], [0.0, 0.0, 0.3]), 1e-15);
    assert_near(&model.links[0].pose.matrix(), &times(turn, matrix_about(0, 0.2)), 1e-15);
    // Without a pose in the include, the model's own pose is used.
    assert_close(model.links[2].pose.position, [9.0, 9.0, 9.3], 1e-14);

    // X_cart_spare X_spare_hub = X_cart_bed X_bed_placement.
    let rim = matrix_about(0, 0.2);
    let hub_in_model =
        (plus([0.0, 0.0, 0.3], applied(rim, [0.1, 0.0, 0.0])), times(rim, matrix_about(1, 0.4)));
    let bed = matrix_about(0, 0.7);
    let hub_in_cart = (plus([1.0, 0.0, 0.0], applied(bed, [0.0, 1.0, 0.0])), bed);
    let model_in_cart = times(hub_in_cart.1, transposed(hub_in_model.1));
    let origin = plus(hub_in_cart.0, applied(model_in_cart, hub_in_model.0.map(|c| -c)));
    let rim_in_world = plus(plus(origin, applied(model_in_cart, [0.0, 0.0, 0.3])), [0.0, 0.0, 5.0]);
    assert_close(model.links[5].pose.position, rim_in_world, 1e-14);
    assert_near(&model.links[5].pose.matrix(), &times(model_in_cart, rim), 1e-14);

    let joint = &model.joints[3];
    assert_eq!((joint.name.text.as_str(), joint.kind), ("cart::hold", JointKind::Fixed));
    assert_eq!(
        (joint.parent.as_ref().unwrap().text.as_str(), joint.child.text.as_str()),
        ("cart::bed", "cart::spare::cap")
    );
    // A number in an included file is reported with that file.
    let place = Places::of(&model).place(&model.links[5].inertial.as_ref().unwrap().mass.span());
    assert!(place.file.ends_with("wheel/model.sdf"));
    assert_eq!((place.line, place.column), (3, 1 + WHEEL.lines().nth(2).unwrap().find("2.5").unwrap()));
}

#[test]
fn a_merged_model_gives_its_elements_to_the_one_around() {
    let world = r#"<sdf version="1.9"><model name="cart"><link name="bed"/>
      <include merge="true"><uri>wheel</uri><pose>1 2 3 0 0 0.5</pose></include>
      <joint name="turn" type="revolute"><parent>bed</parent><child>cap</child></joint>
      <frame name="mark"><pose relative_to="hub">0 0 1 0 0 0</pose></frame></model></sdf>"#;
    let folder = Folder::of("sdf-merge", &files(world));
    let model = read(&folder);
    assert!(model.notes.is_empty(), "{:?}", model.notes);
    assert_eq!(names(&model), ["bed", "rim", "cap"]);
    assert_close(model.links[1].pose.position, [1.0, 2.0, 3.3], 1e-15);
    let joints: Vec<_> = model.joints.iter().map(|j| (j.name.text.as_str(), j.child.text.as_str())).collect();
    assert_eq!(joints, [("push", "cap"), ("turn", "cap")]);
}

#[test]
fn what_includes_itself_is_refused_and_what_is_not_there_noted() {
    let circle = "<sdf><model name='a'><include><uri>b.sdf</uri></include></model></sdf>";
    let back = "<sdf><model name='b'><include><uri>world.sdf</uri></include></model></sdf>";
    let folder = Folder::of("sdf-circle", &[("world.sdf", circle), ("b.sdf", back)]);
    let error = read_model(&folder.path("world.sdf"), &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("a model that includes itself"), "{error}");

    // Ten files, each including the next twice, give a thousand links; thirty would be rejected.
    let double = |k: usize| {
        format!(
            "<sdf><model name='m'><include><uri>{k}.sdf</uri><name>a</name></include><include><uri>{k}.sdf</uri><name>b</name></include></model></sdf>"
        )
    };
    let texts: Vec<(String, String)> = (0..30).map(|k| (format!("{k}.sdf"), double(k + 1))).collect();
    let mut all: Vec<(&str, &str)> =
        texts.iter().map(|(file, text)| (file.as_str(), text.as_str())).collect();
    all.push(("30.sdf", "<sdf><model name='m'><link name='l'/></model></sdf>"));
    let folder = Folder::of("sdf-double", &all);
    let count = read_model(&folder.path("20.sdf"), &ReadOptions::default()).unwrap().links.len();
    assert_eq!(count, 1024);
    assert!(read_model(&folder.path("0.sdf"), &ReadOptions::default()).is_err());

    let gone = "<sdf><world name='w'><include><uri>model://gone</uri></include><include><uri>https://fuel/x</uri></include></world></sdf>";
    let folder = Folder::of("sdf-gone", &[("world.sdf", gone)]);
    let notes: Vec<_> = read(&folder).notes.iter().map(|note| note.code).collect();
    assert_eq!(notes, ["read.include", "read.include"]);
}

#[test]
fn a_placement_frame_that_is_not_in_its_model_is_noted() {
    for (frames, code) in [
        ("", "read.frame"),
        (
            "<frame name='f'><pose relative_to='g'/></frame><frame name='g'><pose relative_to='f'/></frame>",
            "read.frame_circle",
        ),
    ] {
        let world = format!(
            "<sdf><world name='w'><model name='m' placement_frame='f'><pose>1 2 3 0 0 0</pose><link name='l'/>{frames}</model></world></sdf>"
        );
        let folder = Folder::of("sdf-placement", &[("world.sdf", &world)]);
        let model = read(&folder);
        assert_eq!(model.notes[0].code, code, "{:?}", model.notes);
        assert_eq!(model.links[0].pose.position, [1.0, 2.0, 3.0]);
    }
}
