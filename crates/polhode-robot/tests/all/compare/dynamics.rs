//! Comparisons held against the mass matrix: models are equal if and only if their floating-base
//! mass matrices agree at all joint values, with the stated offsets.

use polhode_document::Report as _;

use super::between;
use super::robots::{Frame, LANGUAGES, Robot, robot};
use crate::common::{matrix_about_axis, times};

/// Linear congruential generator of Knuth's MMIX.
struct Random(u64);

impl Random {
    /// Returns a number from -1 to 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 32).unwrap()) / f64::from(u32::MAX) * 2.0 - 1.0
    }

    fn below(&mut self, count: usize) -> usize {
        self.next();
        usize::try_from(self.0 >> 33).unwrap() % count
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Joint above a link, in the model's frame: index, axis, point, and true if it slides.
type Moving = (usize, [f64; 3], [f64; 3], bool);

/// Returns the mass matrix for the velocity and the angular velocity of the whole robot at the
/// model's origin, and the rates of the joints in the order of `joints`, at these joint values.
///
/// M_ij = Σ m v_i·v_j + ω_i·I ω_j over the links, with the velocities v of the centre of mass.
fn mass_matrix(robot: &Robot, joints: &[&str], q: &[f64]) -> Vec<Vec<f64>> {
    let size = 6 + joints.len();
    let mut matrix = vec![vec![0.0; size]; size];
    let mut frames: Vec<Frame> = Vec::new();
    let mut above: Vec<Vec<Moving>> = Vec::new();
    for part in &robot.0 {
        let (mut frame, mut moving) =
            part.parent.map_or((part.pose, Vec::new()), |k| (frames[k].then(&part.pose), above[k].clone()));
        if let Some(joint) = part.joint.as_ref().filter(|joint| joint.kind != "fixed") {
            let index = joints.iter().position(|name| *name == joint.name).unwrap();
            let slides = joint.kind == "prismatic";
            let motion = if slides {
                Frame { p: joint.axis.map(|c| q[index] * c), ..Frame::IDENTITY }
            } else {
                let r = matrix_about_axis(joint.axis, q[index]);
                let turned = Frame { r, p: [0.0; 3] }.point(joint.anchor);
                Frame { r, p: [0, 1, 2].map(|k| joint.anchor[k] - turned[k]) }
            };
            frame = frame.then(&motion);
            let origin = Frame { r: frame.r, p: [0.0; 3] };
            moving.push((index, origin.point(joint.axis), frame.point(joint.anchor), slides));
        }
        if let Some(solid) = &part.solid {
            let center = frame.point(solid.center);
            let transposed = std::array::from_fn(|i| std::array::from_fn(|j| frame.r[j][i]));
            let tensor = times(times(frame.r, solid.tensor), transposed);
            // Velocity of the centre and angular velocity for each unit rate.
            let mut rates = vec![([0.0; 3], [0.0; 3]); size];
            for k in 0..3 {
                let unit = [0, 1, 2].map(|j| f64::from(u8::from(j == k)));
                rates[k] = (unit, [0.0; 3]);
                rates[3 + k] = (cross(unit, center), unit);
            }
            for (index, axis, point, slides) in &moving {
                let lever = [0, 1, 2].map(|k| center[k] - point[k]);
                rates[6 + index] = if *slides { (*axis, [0.0; 3]) } else { (cross(*axis, lever), *axis) };
            }
            for (i, (v, w)) in rates.iter().enumerate() {
                for (j, (u, x)) in rates.iter().enumerate() {
                    matrix[i][j] += solid.mass * dot(*v, *u) + dot(*w, tensor.map(|row| dot(row, *x)));
                }
            }
        }
        frames.push(frame);
        above.push(moving);
    }
    matrix
}

/// Returns the largest difference of elements of two mass matrices, relative to the largest element.
fn apart(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let largest = a.iter().flatten().fold(0.0, |max: f64, x| max.max(x.abs()));
    let differences = a.iter().flatten().zip(b.iter().flatten()).map(|(x, y)| (x - y).abs());
    differences.fold(0.0, f64::max) / largest
}

const JOINTS: [&str; 4] = ["shoulder", "elbow", "slide", "knuckle"];
const LINKS: [&str; 6] = ["base", "upper", "fore", "hand", "rail", "finger"];

/// Changes one number of a robot by a slip of random size, from 1e-5 to 0.3.
fn slip(robot: &mut Robot, random: &mut Random) -> String {
    let size = 0.3 * 10f64.powf(2.2 * (random.next() - 1.0));
    let link = LINKS[random.below(LINKS.len())];
    let axis = random.below(3);
    let kind = random.below(6);
    match kind {
        0 => robot.solid(link).mass *= 1.0 + size,
        1 => robot.solid(link).center[axis] += 0.1 * size,
        2 => robot.solid(link).tensor[axis][axis] *= 1.0 + size,
        3 => {
            let tensor = &mut robot.solid(link).tensor;
            let (i, j) = (axis, (axis + 1) % 3);
            tensor[i][j] += size * tensor[0][0];
            tensor[j][i] = tensor[i][j];
        }
        // Across the axis of each joint, none of which is along x, y or z.
        4 if link != "base" => robot.part(link).pose.p[axis] += 0.1 * size,
        5 if link != "base" && link != "hand" => {
            let joint = robot.part(link).joint.as_mut().unwrap();
            joint.axis[axis] += size;
            let length = dot(joint.axis, joint.axis).sqrt();
            joint.axis = joint.axis.map(|c| c / length);
        }
        _ => robot.solid(link).mass *= 1.0 - size,
    }
    format!("kind {kind} of {link}, {axis}, {size:e}")
}

#[test]
fn models_are_equal_if_and_only_if_their_mass_matrices_are() {
    let mut random = Random(7);
    let (mut equal, mut different) = (0, 0);
    for trial in 0..400 {
        let [of_a, of_b] = [0, 1].map(|_| LANGUAGES[random.below(4)]);
        let mut other = robot();
        let mut shifts = [0.0; 4];
        for (k, link) in ["upper", "fore", "rail", "finger"].into_iter().enumerate() {
            if random.below(2) == 0 {
                shifts[k] = if link == "rail" { 0.2 } else { 3.0 } * random.next();
                other = other.rezeroed(link, shifts[k]);
            }
        }
        let is_slipped = random.below(2) == 0;
        let what = if is_slipped { slip(&mut other, &mut random) } else { String::new() };
        if random.below(3) == 0 {
            other = other.merged();
        }
        if random.below(2) == 0 {
            other = other.reframed(of_b);
        }
        let comparison = between((&robot(), of_a), (&other, of_b));
        let text = || format!("trial {trial}: {of_a} {of_b} {what}\n{}", comparison.to_text(None));
        let mut offsets = [0.0; 4];
        for note in comparison.notes().filter(|note| note.code == "compare.zero") {
            let name = note.subject.rsplit('/').next().unwrap();
            offsets[JOINTS.iter().position(|joint| *joint == name).unwrap()] = note.numbers[0].1;
        }
        let q = [0, 1, 2, 3].map(|_| random.next());
        let q_b = [0, 1, 2, 3].map(|k| q[k] + offsets[k]);
        let apart = apart(&mass_matrix(&robot(), &JOINTS, &q), &mass_matrix(&other, &JOINTS, &q_b));
        if comparison.is_equal() {
            assert!(apart < 1e-12, "{apart:e} {}", text());
            equal += 1;
        } else {
            assert!(is_slipped && apart > 1e-9, "{apart:e} {}", text());
            different += 1;
        }
        assert_eq!(comparison.is_equal(), !is_slipped, "{}", text());
    }
    assert!(equal > 150 && different > 150, "{equal} {different}");
}
