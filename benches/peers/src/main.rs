//! Mass properties of a mesh by parry, as one line of JSON. The input is an STL file or a list of
//! f64 triangles.
//!
//! peers stl FILE.stl        read by stl_io, as people do
//! peers raw FILE            nine little-endian f64 a triangle

use std::time::Instant;

use parry3d_f64::mass_properties::MassProperties;
use parry3d_f64::math::Vector;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let begin = Instant::now();
    let (vertices, indices) = match arguments[1].as_str() {
        "stl" => {
            let mut file = std::io::BufReader::new(std::fs::File::open(&arguments[2]).expect("a file"));
            let mesh = stl_io::read_stl(&mut file).expect("an STL file");
            let vertex = |v: &stl_io::Vertex| Vector::new(f64::from(v[0]), f64::from(v[1]), f64::from(v[2]));
            let faces = mesh.faces.iter().map(|f| f.vertices.map(|i| i as u32)).collect::<Vec<_>>();
            (mesh.vertices.iter().map(vertex).collect::<Vec<_>>(), faces)
        }
        _ => {
            let bytes = std::fs::read(&arguments[2]).expect("a file");
            let numbers: Vec<f64> =
                bytes.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().expect("eight bytes"))).collect();
            let vertices: Vec<_> = numbers.chunks_exact(3).map(|v| Vector::new(v[0], v[1], v[2])).collect();
            let faces = (0..vertices.len() as u32 / 3).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
            (vertices, faces)
        }
    };
    let properties = MassProperties::from_trimesh(1.0, &vertices, &indices);
    let seconds = begin.elapsed().as_secs_f64();
    let i = properties.reconstruct_inertia_matrix();
    let c = properties.local_com;
    println!(
        "{{\"mass\": {:?}, \"center\": [{:?}, {:?}, {:?}], \"inertia\": [[{:?}, {:?}, {:?}], [{:?}, {:?}, {:?}], [{:?}, {:?}, {:?}]], \"seconds\": {seconds:?}}}",
        properties.mass(),
        c.x, c.y, c.z,
        i.x_axis.x, i.y_axis.x, i.z_axis.x,
        i.x_axis.y, i.y_axis.y, i.z_axis.y,
        i.x_axis.z, i.y_axis.z, i.z_axis.z,
    );
}
