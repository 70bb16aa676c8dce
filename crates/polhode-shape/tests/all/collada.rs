//! COLLADA: one solid with every kind of face and placement, and broken files.

use polhode::body::mesh::ClosedMesh;
use polhode_shape::mesh::collada::{UpAxis, read, read_with_axis};
use polhode_shape::mesh::{MeshContents, MeshFormat, MeshSolid};
use polhode_source::files::Disk;
use polhode_source::{ContentError, ContentErrorKind as Kind, ContentPlace};

/// Corners of a slanted prism.
const POINTS: [[f64; 3]; 6] = [
    [0.1, -2.5, 3.25],
    [1.75, 0.3, 0.1],
    [-6.5, 4.2, 0.9],
    [0.6, -2.3, 6.75],
    [2.25, 0.5, 3.6],
    [-6.0, 4.4, 4.4],
];
const TRIANGLES: [[usize; 3]; 8] =
    [[0, 2, 1], [3, 4, 5], [0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];

/// Three inputs; the vertex is the second of the three numbers of a corner.
const INPUTS: &str = "<input semantic='TEXCOORD' source='#uv' offset='2' set='0'/><input semantic='VERTEX' source='#v' \
                      offset='1'/><input semantic='NORMAL' source='#n' offset='0'/>";

fn corners(all: &[usize]) -> String {
    all.iter().map(|k| format!("9 {k} 7 ")).collect()
}

/// Returns a faces element: `<triangles count='8'>…`
fn faces(kind: &str, count: usize, lists: &[&[usize]]) -> String {
    let lists: String = lists.iter().map(|list| format!("<p>{}</p>", corners(list))).collect();
    format!("<{kind} count='{count}' material='steel'>{INPUTS}{lists}</{kind}>")
}

fn triangles() -> String {
    faces("triangles", 8, &[TRIANGLES.as_flattened()])
}

/// Returns a document with these faces in geometry g, and these nodes in its scene.
fn document(faces: &str, nodes: &str) -> String {
    let numbers = POINTS.as_flattened().iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
    format!(
        "<?xml version='1.0'?>
<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>
<asset><unit name='inch' meter='0.0254'/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id='g' name='stone'><mesh>
<source id='s'><float_array id='f' count='18'>{numbers}</float_array>
<technique_common><accessor source='#f' count='6' stride='3'><param name='X' type='float'/><param name='Y' type='float'/>\
<param name='Z' type='float'/></accessor></technique_common></source>
<vertices id='v'><input semantic='POSITION' source='#s'/></vertices>
{faces}
</mesh></geometry>
<geometry id='wire'><mesh><lines count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1</p></lines></mesh></geometry>
</library_geometries>
<library_visual_scenes><visual_scene id='scene' name='yard'>{nodes}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url='#scene'/></scene></COLLADA>"
    )
}

const NODE: &str = "<node name='heap'><instance_geometry url='#g'/></node>";

fn plain() -> String {
    document(&triangles(), NODE)
}

/// Returns the corners of all triangles, in an order independent of the file.
fn soup(contents: &MeshContents) -> Vec<[[f64; 3]; 3]> {
    sorted(contents.parts.iter().flat_map(|part| part.mesh.corners()).collect())
}

fn sorted(mut triangles: Vec<[[f64; 3]; 3]>) -> Vec<[[f64; 3]; 3]> {
    for triangle in &mut triangles {
        let first = (0..3).min_by(|&a, &b| triangle[a].partial_cmp(&triangle[b]).unwrap()).unwrap();
        triangle.rotate_left(first);
    }
    triangles.sort_by(|a, b| a.partial_cmp(b).unwrap());
    triangles
}

fn expected() -> Vec<[[f64; 3]; 3]> {
    sorted(TRIANGLES.map(|triangle| triangle.map(|k| POINTS[k])).to_vec())
}

/// Asserts that the triangles are the mapped triangles of the prism, and still wound outward.
fn assert_placed(contents: &MeshContents, map: impl Fn([f64; 3]) -> [f64; 3], mirrors: bool) {
    let wanted = TRIANGLES.map(|[a, b, c]| if mirrors { [a, c, b] } else { [a, b, c] });
    let wanted = sorted(wanted.map(|triangle| triangle.map(|k| map(POINTS[k]))).to_vec());
    let got = soup(contents);
    assert_eq!(got.len(), wanted.len());
    for (a, b) in got.as_flattened().as_flattened().iter().zip(wanted.as_flattened().as_flattened()) {
        assert!((a - b).abs() < 4e-14, "{a} is not {b}");
    }
    assert!(!ClosedMesh::from_triangles(got).unwrap().inverted());
}

/// Returns the error for a text, and the text at its place.
fn error(text: &str) -> (Kind, &str) {
    let error = read(text).unwrap_err();
    match error.place {
        ContentPlace::Text(span) => (error.kind, &text[span.start..]),
        place => panic!("{place:?}: {}", error.kind),
    }
}

#[test]
fn the_plain_solid() {
    let (contents, up) = read_with_axis(&plain()).unwrap();
    assert_eq!((contents.unit, contents.name.as_str(), up), (Some(0.0254), "yard", Some(UpAxis::Z)));
    assert_eq!((contents.parts.len(), contents.parts[0].name.as_str()), (1, "heap"));
    assert_eq!(contents.parts[0].mesh.coordinates(), POINTS);
    assert!(contents.findings.is_empty());
    assert_placed(&contents, |p| p, false);
}

#[test]
fn every_kind_of_faces_gives_the_same_solid() {
    let (quads, ends) = ([[0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]], [[0, 2, 1], [3, 4, 5]]);
    let list = format!(
        "<polylist count='5'>{INPUTS}<vcount>3 4 4\n 4 3</vcount><p>{}{}{}</p></polylist>",
        corners(&ends[0]),
        corners(quads.as_flattened()),
        corners(&ends[1])
    );
    let strips = faces("tristrips", 3, &[&[1, 4, 0, 3], &[2, 5, 1, 4], &[0, 3, 2, 5]]);
    let fans = faces("trifans", 2, &[&[3, 4, 5, 2, 0], &[1, 0, 2]]);
    let polygons = faces("polygons", 5, &[&quads[0], &quads[1], &quads[2], &ends[0], &ends[1]]);
    let of_ends = faces("triangles", 2, &[ends.as_flattened()]);
    let fan_and_rest = format!("{fans}{}", faces("triangles", 4, &[&[0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4]]));
    for faces in [list, format!("{strips}{of_ends}"), fan_and_rest, polygons] {
        let contents = read(&document(&faces, NODE)).unwrap();
        assert_eq!((contents.parts.len(), soup(&contents)), (1, expected()), "{faces}");
        assert_eq!(contents.parts[0].mesh.coordinates().len(), 6);
    }
}

#[test]
fn a_polygon_with_a_dent_is_no_fan() {
    // An arrowhead in a plane that is not parallel to a coordinate plane.
    let plane = [[0.0, 0.0, 0.0], [3.0, 1.0, 0.5], [1.0, 0.5, 0.2], [0.5, 3.0, 0.7]]
        .map(|[x, y, _]: [f64; 3]| [x, y, 0.25 * x - 0.5 * y]);
    let text = document(&faces("polygons", 1, &[&[0, 1, 2, 3]]), NODE);
    let mut text = text;
    for (old, new) in POINTS.iter().zip(plane) {
        let words = |p: &[f64; 3]| format!("{} {} {}", p[0], p[1], p[2]);
        text = text.replacen(&words(old), &words(&new), 1);
    }
    let contents = read(&text).unwrap();
    let area =
        |[a, b, c]: [[f64; 3]; 3]| 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    let areas: Vec<f64> = contents.parts[0].mesh.corners().map(area).collect();
    assert!(areas.len() == 2 && areas.iter().all(|area| *area > 0.0), "{areas:?}");
}

#[test]
fn nodes_place_what_they_hold() {
    let turned = |axis: [f64; 3], degrees: f64, p: [f64; 3]| {
        let n = axis.map(|c| c / axis.iter().map(|c| c * c).sum::<f64>().sqrt());
        let (sin, cos) = degrees.to_radians().sin_cos();
        let along: f64 = (0..3).map(|k| n[k] * p[k]).sum();
        let cross = [n[1] * p[2] - n[2] * p[1], n[2] * p[0] - n[0] * p[2], n[0] * p[1] - n[1] * p[0]];
        [0, 1, 2].map(|k| cos * p[k] + sin * cross[k] + (1.0 - cos) * along * n[k])
    };
    let nested = "<node><translate>1 2 3</translate><node><rotate>0.3 -0.5 0.8 50</rotate><scale>1 -2 1.5</scale>\
                  <instance_geometry url='#g'/></node></node>";
    let contents = read(&document(&triangles(), nested)).unwrap();
    let place = |p: [f64; 3]| {
        let q = turned([0.3, -0.5, 0.8], 50.0, [p[0], -2.0 * p[1], 1.5 * p[2]]);
        [q[0] + 1.0, q[1] + 2.0, q[2] + 3.0]
    };
    assert_placed(&contents, place, true);

    // Matrices are by rows; the last transformation is applied first.
    let matrix = "<node><rotate>1e-200 0 0 90</rotate><matrix>0.5 0.1 0 7  -0.2 2 0.3 -8  0 0.4 -1.5 9  0 0 0 1</matrix>\
                  <rotate>0 0 0 0</rotate><instance_geometry url='#g'/></node>";
    let contents = read(&document(&triangles(), matrix)).unwrap();
    let place = |[x, y, z]: [f64; 3]| {
        let [x, y, z] =
            [0.5 * x + 0.1 * y + 7.0, -0.2 * x + 2.0 * y + 0.3 * z - 8.0, 0.4 * y - 1.5 * z + 9.0];
        [x, -z, y]
    };
    assert_placed(&contents, place, true);
}

#[test]
fn instances_are_parts_with_names() {
    let library = "<library_nodes><node id='pair' name='pair'><translate>0 0 20</translate><instance_geometry url='#g'/>\
                   <node id='upper'><translate>0 0 10</translate><instance_geometry url='#g'/></node></node></library_nodes>\
                   <library_visual_scenes>";
    let nodes = "<node id='low'><instance_geometry url='#g'/></node><node name='other'><translate>40 0 0</translate>\
                 <instance_node url='#pair'/></node>\
                 <node name='two'><translate>-40 0 0</translate><instance_geometry url='#g' name='left'/><instance_geometry url='#wire'/></node>";
    let text = document(&triangles(), nodes).replace("<library_visual_scenes>", library);
    let contents = read(&text).unwrap();
    let names: Vec<_> = contents.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["stone", "pair", "stone", "left"]);
    let firsts: Vec<_> = contents.parts.iter().map(|part| part.mesh.coordinates()[0]).collect();
    let at = |x: f64, z: f64| [POINTS[0][0] + x, POINTS[0][1], POINTS[0][2] + z];
    assert_eq!(firsts, [at(0.0, 0.0), at(40.0, 20.0), at(40.0, 30.0), at(-40.0, 0.0)]);
    let [finding] = contents.findings.as_slice() else { panic!("{:?}", contents.findings) };
    assert_eq!((finding.code, finding.place.as_deref()), ("mesh.not_a_surface", Some("geometry \"wire\"")));

    // Each part is a solid, in metres.
    let solid = MeshSolid::of(contents, "yard.dae".as_ref(), MeshFormat::Collada, None).unwrap();
    let volume = ClosedMesh::from_triangles(expected()).unwrap().volume() * 0.0254_f64.powi(3);
    assert_eq!(solid.parts.len(), 4);
    for part in &solid.parts {
        assert!((part.mesh.volume() / volume - 1.0).abs() < 1e-13);
    }
}

#[test]
fn axes_are_kept_and_said() {
    for (said, up, note) in [
        ("<up_axis>X_UP</up_axis>", Some(UpAxis::X), Some("has x up")),
        ("<up_axis> Y_UP\n</up_axis>", Some(UpAxis::Y), Some("has y up")),
        ("<up_axis>Z_UP</up_axis>", Some(UpAxis::Z), None),
        ("<!-- <up_axis>Y_UP</up_axis> -->", None, None),
    ] {
        let (contents, got) = read_with_axis(&plain().replace("<up_axis>Z_UP</up_axis>", said)).unwrap();
        assert_eq!(got, up, "{said}");
        assert_eq!(soup(&contents), expected());
        let notes: Vec<_> = contents.findings.iter().map(|finding| finding.message.as_str()).collect();
        assert_eq!(notes.len(), usize::from(note.is_some()), "{notes:?}");
        assert!(note.is_none_or(|note| notes[0].contains(note)), "{notes:?}");
    }
    // Unknown names and rounded numbers do not contradict the unit.
    for (unit, meter) in [
        ("name='mil' meter='0.0000254'", 2.54e-5),
        ("name='foot' meter='0.305'", 0.305),
        ("meter='0.4'", 0.4),
    ] {
        let contents = read(&plain().replace("name='inch' meter='0.0254'", unit)).unwrap();
        assert_eq!(contents.unit, Some(meter));
    }
    let metres = read(&plain().replace("<unit name='inch' meter='0.0254'/>", "")).unwrap();
    assert_eq!((metres.unit, metres.findings[0].code), (Some(1.0), "mesh.unit_default"));
}

#[test]
fn numbers_may_be_laid_out_otherwise() {
    let wanted = expected();
    let numbers = POINTS.as_flattened().iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
    // A weight before each point, and one additional unused point.
    let wide: String = POINTS.iter().map(|[x, y, z]| format!("{x} {y} {z} 0.5 ")).collect();
    let wide = format!("8 8 {wide}1 2 3 0.5");
    let text = plain()
        .replace(&numbers, &wide)
        .replace("count='18'", "count='30'")
        .replace("count='6' stride='3'", "count='6' offset='2' stride='4'");
    assert_eq!(soup(&read(&text).unwrap()), wanted);
    // Parameters without a name are skipped.
    let text = plain()
        .replace(&numbers, &POINTS.iter().map(|[x, y, z]| format!("{x} {y} 7.5 {z} ")).collect::<String>())
        .replace("count='18'", "count='24'")
        .replace("stride='3'", "stride='4'")
        .replace("<param name='Z'", "<param type='float'/><param name='Z'");
    assert_eq!(soup(&read(&text).unwrap()), wanted);
    // The numbers are the whole text of an element.
    for (sections, bare) in [
        ("<![CDATA[9 3 7]]> 9 4 7<!-- --> 9 5", "9 3 7 9 4 7 9 5"),
        ("9 3 7 <![CDATA[9 4 7]]> 9 5", "9 3 7 9 4 7 9 5"),
    ] {
        let text = plain().replacen(bare, sections, 1);
        assert_ne!(text, plain());
        assert_eq!(soup(&read(&text).unwrap()), wanted);
    }
    // A computed matrix with rounding errors.
    let matrix = "<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5e-8 1.0000001</matrix><instance_geometry";
    assert_eq!(soup(&read(&plain().replace("<instance_geometry", matrix)).unwrap()), wanted);
    // A node may have the same id as its geometry.
    let same = plain().replace("<node name='heap'>", "<node id='g'>");
    assert_eq!(soup(&read(&same).unwrap()), wanted);
    // Without optional attributes.
    let bare =
        plain().replace(" count='18'", "").replace("count='6' stride='3'", "").replace("count='8'", "");
    assert_eq!(soup(&read(&bare).unwrap()), wanted);
    let first = plain().replace("<scene><instance_visual_scene url='#scene'/></scene>", "");
    assert_eq!(soup(&read(&first).unwrap()), wanted);
}

#[test]
fn what_is_wrong_is_refused_where_it_stands() {
    let text = plain();
    let polylist = document(
        &format!(
            "<polylist count='2'>{INPUTS}<vcount>3 3</vcount><p>{}</p></polylist>",
            corners(&[0, 2, 1, 3, 4, 5])
        ),
        NODE,
    );
    let strip = document(&faces("tristrips", 1, &[&[0, 1, 2]]), NODE);
    for (text, right, wrong, said, place) in [
        (&text, "url='#g'", "url='#h'", "no geometry \"h\"", "<instance_geometry"),
        (&text, "url='#g'", "url='#s'", "no geometry \"s\"", "<instance_geometry"),
        (&text, "url='#scene'", "url='#other'", "no visual_scene \"other\"", "<instance_visual_scene"),
        (&text, "source='#v'", "source='#w'", "no vertices \"w\"", "<input semantic='VERTEX'"),
        (&text, "source='#s'", "source='#t'", "no source \"t\"", "<input semantic='POSITION'"),
        (&text, "source='#f'", "source='#s'", "no float_array \"s\"", "<accessor"),
        (&text, "url='#g'", "url='walls.dae#g'", "in another file, \"walls.dae\"", "<instance_geometry"),
        (&text, "id='wire'", "id='g'", "the id of <geometry> = \"g\"", "<geometry id='g'><mesh><lines"),
        (&text, "name='Y' ", "", "parameters are not X, Y and Z", "<accessor"),
        (
            &text,
            "<scene>",
            "<library_visual_scenes><visual_scene id='other'/></library_visual_scenes><extra>",
            "no <scene>, which selects the visual scene",
            "<visual_scene id='other'",
        ),
        (
            &text,
            "url='#scene'/>",
            "url='#scene'/><instance_visual_scene url='#scene'/>",
            "<instance_visual_scene> of COLLADA after another one",
            "<instance_visual_scene url='#scene'/></scene>",
        ),
        (&text, " meter='0.0254'", "", "no meter of the unit \"inch\"", "<unit"),
        (&text, "meter='0.0254'", "meter=''", "a positive number, found \"nothing\"", "'/><up_axis>"),
        (&text, "9 0 7 9 2 7", "9 0 7 9 <q/> 7", "the number of a vertex, found \"<q/>\"", "<q/>"),
        (&text, "9 0 7 9 2 7", "9 <q/> 7 <q/> 2 7", "the number of a vertex, found \"<q/>\"", "<q/>"),
        (&text, "1.75", "1.75<q/>", "a finite number", "1.75<q/>"),
        (&text, "'VERTEX'", "'POSITION'", "no input of vertices", "<triangles"),
        (&text, "'POSITION'", "'NORMAL'", "no positions", "<vertices"),
        (&text, "instance_geometry", "instance_node", "no node \"g\"", "<instance_node"),
        (&text, "instance_geometry", "instance_controller", "skins and morphs", "<instance_controller"),
        (&text, "<p>9 0", "<p>9 6", "vertex 6 does not exist: there are 6", "6 7"),
        (&text, "<p>9 0", "<p>9 -1", "vertex -1 does not exist", "-1 7"),
        (&text, "<p>9 0", "<p>9 0.5", "expected the number of a vertex", "0.5 7"),
        (&text, "<p>9 0 7 ", "<p>", "corner of the last face", "<p>"),
        (&text, "<p>9", "<p>", "a multiple of 3", "<p>"),
        (&text, "count='8'", "count='7'", "7 faces are declared, but the file has 8", "<triangles"),
        (&text, "count='18'", "count='21'", "21 numbers of <float_array> are declared", "<float_array"),
        (&text, "count='6'", "count='7'", "7 points are declared, but the file has 6", "<accessor"),
        (&text, "count='6'", "count='5'", "vertex 5 does not exist: there are 5", "5"),
        (&text, "stride='3'", "stride='2'", "no three coordinates", "<source"),
        (&text, "stride='3'", "stride='three'", "a whole number", "three"),
        (&text, "offset='1'", "offset='1.0'", "a whole number", "1.0"),
        (&text, "name='X'", "name='Z'", "parameters are not X, Y and Z", "<accessor"),
        (&text, "meter='0.0254'", "meter='0,0254'", "a finite number", "0,0254"),
        (&text, "meter='0.0254'", "meter='-1'", "a positive number", "-1"),
        // A number that contradicts the name.
        (&text, "meter='0.0254'", "meter='1'", "meter of the unit \"inch\"", "1'/><up_axis>"),
        (
            &text,
            "name='inch' meter='0.0254'",
            "name='Millimeter' meter='1'",
            "0.001, as its name implies",
            "1'/><up_axis>",
        ),
        (&text, "name='inch' meter='0.0254'", "name='meter' meter='0.01'", "1, as its name implies", "0.01"),
        (
            &text,
            "name='inch' meter='0.0254'",
            "name='yard' meter='0.5'",
            "0.9144, as its name implies",
            "0.5",
        ),
        (
            &text,
            "name='inch' meter='0.0254'",
            "name='MM' meter='1'",
            "0.001, as its name implies",
            "1'/><up_axis>",
        ),
        (
            &text,
            "name='inch' meter='0.0254'",
            "name='1mm' meter='1'",
            "0.001, as its name implies",
            "1'/><up_axis>",
        ),
        (
            &text,
            "name='inch' meter='0.0254'",
            "name='mile' meter='1'",
            "1609.344, as its name implies",
            "1'/><up_axis>",
        ),
        (
            &text,
            "name='inch' meter='0.0254'",
            "name='micrometer' meter='1'",
            "0.000001, as its name implies",
            "1'/><up_axis>",
        ),
        (
            &text,
            "name='inch' meter='0.0254'",
            "name='inch' meter='0.0256'",
            "0.0254, as its name implies",
            "0.0256",
        ),
        (&text, "Z_UP", "UP", "X_UP, Y_UP or Z_UP", "UP"),
        (&text, "1.75", "1e400", "a finite number", "1e400"),
        (&text, "version='1.4.1'", "version='1.3.0'", "COLLADA 1.3.0", "1.3.0"),
        (&text, "<instance_geometry", "<translate>1 2</translate><instance_geometry", "3 numbers", "1 2"),
        (&text, "<instance_geometry", "<scale>1 2 nan</scale><instance_geometry", "a finite number", "nan"),
        (
            &text,
            "<instance_geometry",
            "<rotate>0 0 0 5</rotate><instance_geometry",
            "no axis of the rotation",
            "<rotate",
        ),
        (&text, "<instance_geometry", "<skew>5 1 0 0 0 1 0</skew><instance_geometry", "<skew>", "<skew"),
        (
            &text,
            "<instance_geometry",
            "<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1</matrix><instance_geometry",
            "last row",
            "<matrix",
        ),
        (
            &text,
            "url='#g'/>",
            "url='#g'/><translate>1 2 3</translate>",
            "after the geometry that it would place",
            "<translate",
        ),
        (
            &text,
            "<instance_geometry",
            "<scale>1e200 1 1</scale><scale>1e200 1 1</scale><instance_geometry",
            "placed vertex",
            "<instance_geometry",
        ),
        (
            &text,
            "<geometry id='g' name='stone'><mesh>",
            "<geometry id='g'><mesh/></geometry><geometry id='h'><mesh>",
            "no triangles",
            "<geometry",
        ),
        (
            &text,
            "<geometry id='g' name='stone'><mesh>",
            "<geometry id='g'/><geometry id='h'><mesh>",
            "no mesh",
            "<geometry",
        ),
        (
            &text,
            "<geometry id='g' name='stone'>",
            "<geometry id='g'><asset><unit meter='1'/></asset>",
            "another unit",
            "<asset",
        ),
        (&polylist, "3 3<", "3 4<", "no corner of the last face", "<p>"),
        (&polylist, "3 3<", "3 3 3<", "3 faces of <vcount> are declared, but the file has 2", "<polylist"),
        (&polylist, "3 3<", "6 0<", "2 faces of <vcount> are declared, but the file has 1", "<polylist"),
        (&polylist, "3 3<", "3 0 3<", "expected the count of a face's corners, found \"0\"", "0 3<"),
        (&strip, "9 2 7 ", "", "no corner of the last face", "<p>"),
        (&strip, "count='1'", "count='2'", "2 faces are declared, but the file has 1", "<tristrips"),
        (&strip, "<p>", "<ph><p>", "polygons with holes", "<ph>"),
    ] {
        let mut wrong = text.replacen(right, wrong, 1);
        if right == "<scene>" && wrong.contains("<extra>") {
            wrong = wrong.replace("</scene></COLLADA>", "</extra></COLLADA>");
        }
        if said.contains("holes") {
            wrong = wrong.replacen("</p>", "</p><h>0</h></ph>", 1);
        }
        assert_ne!(&wrong, text, "{right} is not there");
        let (kind, at) = error(&wrong);
        let message = kind.to_string();
        assert!(message.contains(said), "{wrong}: {message}");
        assert!(at.starts_with(place), "{said}: at {:?}", &at[..at.len().min(30)]);
    }
    let root = error("<html/>");
    assert_eq!(root.0, Kind::Expected { what: "<COLLADA>".to_owned(), found: "<html>".to_owned() });
}

#[test]
fn errors_have_lines() {
    let text = plain().replace("<p>9 0", "<p>9 6");
    let error =
        MeshContents::parse(&Disk, text.as_bytes(), "yard.dae".as_ref(), MeshFormat::Collada).unwrap_err();
    let place = error.place().unwrap();
    let line = text.lines().position(|line| line.contains("<p>9 6")).unwrap() + 1;
    let column = text.lines().nth(line - 1).unwrap().find("6 7").unwrap() + 1;
    assert_eq!((place.line, place.column), (line, column));
    let empty = plain().replace(NODE, "<node/>");
    let error =
        MeshContents::parse(&Disk, empty.as_bytes(), "yard.dae".as_ref(), MeshFormat::Collada).unwrap_err();
    assert!(error.message().contains("no triangles"));
    let latin = [text.as_bytes(), b"<!-- \xe9 -->"].concat();
    let error = MeshContents::parse(&Disk, &latin, "yard.dae".as_ref(), MeshFormat::Collada).unwrap_err();
    assert!(error.hint().unwrap().contains("UTF-8"));
}

#[test]
fn a_few_bytes_do_not_fill_the_memory() {
    let refused = |text: &str| -> ContentError { read(text).unwrap_err() };
    let library = |nodes: &str, root: &str| {
        let nodes = format!("<library_nodes>{nodes}</library_nodes><library_visual_scenes>");
        document(&triangles(), root).replace("<library_visual_scenes>", &nodes)
    };
    let root = "<node><instance_node url='#n0'/></node>";
    let circle = library("<node id='n0'><node><instance_node url='#n0'/></node></node>", root);
    assert!(refused(&circle).kind.to_string().contains("the node = n0 must be acyclic: it contains itself"));
    // Each node contains the next one ten times.
    let deep = |last: &str| -> String {
        let node = |k: usize| {
            let inner = format!("<instance_node url='#n{}'/>", k + 1).repeat(10);
            format!("<node id='n{k}'>{inner}</node>")
        };
        (0..8).map(node).collect::<String>() + &format!("<node id='n8'>{last}</node>")
    };
    for last in ["<instance_geometry url='#g'/>", ""] {
        let error = refused(&library(&deep(last), root));
        assert!(error.kind.to_string().contains("expands to more than 256 MiB"), "{error}");
        assert!(matches!(error.place, ContentPlace::Text(_)));
    }
}
