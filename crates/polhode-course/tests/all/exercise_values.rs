//! Right values of exercises, compared with the crate `polhode` and with formulas of other sources.

use std::f64::consts::PI;

use polhode::body::shape::{BoxShape, Disk, Rod, Shape, Sphere, Substance};
use polhode::body::{InertiaAbout, InertiaTensor, MassProperties, Particle, mass_properties_of_particles};
use polhode::math::{Body, Part, Position, Vector};
use polhode::motion::Rotor;
use serde_json::Value;

use crate::exercises::solved;

/// Seeds of each comparison.
const SEEDS: std::ops::Range<u64> = 100..120;

/// Exercise with its values by name.
struct Solved(Value);

impl Solved {
    fn all(topic: &'static str) -> impl Iterator<Item = Self> {
        SEEDS.map(move |seed| Self(solved(topic, seed)))
    }

    fn given(&self, name: &str) -> f64 {
        let all = self.0["data"].as_array().unwrap();
        all.iter().find(|datum| datum["symbol"] == name).unwrap_or_else(|| panic!("{name}"))["value"]
            .as_f64()
            .unwrap()
    }

    fn vector(&self, names: [&str; 3]) -> [f64; 3] {
        names.map(|name| self.given(name))
    }

    /// Returns the given tensor.
    fn tensor(&self) -> [[f64; 3]; 3] {
        let [xx, yy, zz, xy, xz, yz] =
            ["I_xx", "I_yy", "I_zz", "I_xy", "I_xz", "I_yz"].map(|name| self.given(name));
        [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    }

    fn answer(&self, name: &str) -> Vec<f64> {
        let all = self.0["solution"].as_array().unwrap();
        let answer = all.iter().find(|answer| answer["name"] == name).unwrap_or_else(|| panic!("{name}"));
        answer["value"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    }

    /// Panics unless an answer is this value.
    fn require(&self, name: &str, expected: &[f64]) {
        let found = self.answer(name);
        let size = expected.iter().fold(0.0, |most, x| f64::max(most, x.abs()));
        let is_near = found.len() == expected.len()
            && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12 * size);
        assert!(is_near, "{} {}: {name} = {found:?}, not {expected:?}", self.0["topic"], self.0["seed"]);
    }

    /// Panics unless an answer is this tensor.
    fn require_tensor(&self, name: &str, m: [[f64; 3]; 3]) {
        self.require(name, &[m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]]);
    }
}

fn rotor(tensor: [[f64; 3]; 3]) -> Rotor {
    let tensor = InertiaTensor::<Body>::from_matrix(tensor).unwrap();
    Rotor::free(&MassProperties::new(1.0, Position::ZERO, tensor).unwrap())
}

fn diagonal(moments: [f64; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { moments[i] } else { 0.0 }))
}

#[test]
fn tensors_are_those_of_polhode() {
    for e in Solved::all("tensor-of-particles") {
        let particles = ["1", "2", "3"].map(|k| {
            let [x, y, z] = ["x", "y", "z"].map(|axis| e.given(&format!("{axis}_{k}")));
            Particle::<Body>::new(e.given(&format!("m_{k}")), Position::new(x, y, z)).unwrap()
        });
        let body = mass_properties_of_particles(&particles).unwrap();
        e.require_tensor("I", body.inertia_about(Position::ZERO).matrix());
    }
    for e in Solved::all("box-about-corner") {
        let size = e.vector(["a", "b", "c"]);
        let body = BoxShape::new(size).unwrap().mass_properties(Substance::Mass(e.given("M"))).unwrap();
        let [x, y, z] = size.map(|edge| -edge / 2.0);
        e.require_tensor("I", body.inertia_about(Position::new(x, y, z)).matrix());
    }
    for e in Solved::all("parallel-axes") {
        let [x, y, z] = e.vector(["d_x", "d_y", "d_z"]);
        let tensor = InertiaTensor::<Body>::from_matrix(e.tensor()).unwrap();
        let body = MassProperties::new(e.given("M"), Position::new(x, y, z), tensor).unwrap();
        e.require_tensor("J", body.inertia_about(Position::ZERO).matrix());
    }
    for e in Solved::all("composite-body") {
        let size = e.vector(["a", "b", "c"]);
        let block = BoxShape::new(size).unwrap().mass_properties(Substance::Mass(e.given("m_1"))).unwrap();
        let ball = Sphere::new(e.given("D") / 2.0)
            .unwrap()
            .mass_properties(Substance::Mass(e.given("m_2")))
            .unwrap();
        let [x, y, z] = e.vector(["x", "y", "z"]);
        let ball = MassProperties::<Part>::new(ball.mass(), Position::new(x, y, z), *ball.inertia()).unwrap();
        let both = MassProperties::combined(&[block, ball]).unwrap();
        e.require_tensor("I", both.inertia_about(Position::ZERO).matrix());
    }
}

#[test]
fn moments_about_axes_are_those_of_polhode() {
    for e in Solved::all("moment-about-axis") {
        let [u, v, w] = e.vector(["u", "v", "w"]);
        let axis = Position::<Body>::new(u, v, w).direction().unwrap();
        e.require("I_axis", &[InertiaTensor::from_matrix(e.tensor()).unwrap().about_axis(axis)]);
    }
    for e in Solved::all("rod-with-disk") {
        let (length, [m, disk]) = (e.given("l"), [e.given("m"), e.given("M")]);
        let rod = Rod::new(length).unwrap().mass_properties(Substance::Mass(m)).unwrap().inertia().matrix();
        let own = Disk::new(e.given("D") / 2.0)
            .unwrap()
            .mass_properties(Substance::Mass(disk))
            .unwrap()
            .inertia()
            .matrix();
        let across = rod.iter().enumerate().map(|(k, row)| row[k]).fold(0.0, f64::max);
        e.require("I", &[across + m * length * length / 4.0 + own[2][2] + disk * length * length]);
        e.require("d", &[(m * length / 2.0 + disk * length) / (m + disk)]);
    }
    for e in Solved::all("parallel-axes-twice") {
        let [mass, i, a, b] = ["M", "I_A", "d_A", "d_B"].map(|name| e.given(name));
        e.require("I_C", &[i - mass * a * a]);
        e.require("I_B", &[i - mass * (a - b) * (a + b)]);
    }
    for e in Solved::all("rotated-body") {
        let phi = e.given("phi");
        let (moments, axes) = (
            e.vector(["I_1", "I_2", "I_3"]),
            [[phi.cos(), phi.sin(), 0.0], [-phi.sin(), phi.cos(), 0.0], [0.0, 0.0, 1.0]],
        );
        let element = |i: usize, j: usize| (0..3).map(|k| moments[k] * axes[k][i] * axes[k][j]).sum::<f64>();
        for (name, i, j) in [("I_xx", 0, 0), ("I_yy", 1, 1), ("I_xy", 0, 1)] {
            e.require(name, &[element(i, j)]);
        }
    }
}

#[test]
fn principal_moments_and_axes_are_those_of_polhode() {
    for e in Solved::all("principal-moments") {
        let moments = rotor(e.tensor()).principal().moments();
        for (name, moment) in ["I_1", "I_2", "I_3"].iter().zip(moments) {
            e.require(name, &[moment]);
        }
    }
    for e in Solved::all("principal-axes") {
        let rotor = rotor(e.tensor());
        for (name, k) in [("e_1", 0), ("e_3", 2)] {
            let found = e.answer(name);
            let dot: f64 = rotor.principal().axis(k).to_array().iter().zip(&found).map(|(a, b)| a * b).sum();
            assert!((dot.abs() - 1.0).abs() < 1e-12, "{name} {found:?}");
        }
    }
    for e in Solved::all("axes-of-plate") {
        let [xx, yy, xy] = ["I_xx", "I_yy", "I_xy"].map(|name| e.given(name));
        let about = InertiaAbout::<Body>::from_matrix(
            Position::ZERO,
            [[xx, xy, 0.0], [xy, yy, 0.0], [0.0, 0.0, xx + yy]],
        );
        let moments = polhode::body::PrincipalFrame::about_pivot(&about.unwrap()).moments();
        e.require("Delta", &[moments[1] - moments[0]]);
        let angle = 0.5 * e.answer("tan_2theta")[0].atan();
        let mixed = (yy - xx) * angle.sin() * angle.cos() + xy * (2.0 * angle).cos();
        assert!(mixed.abs() < 1e-14, "{mixed}");
    }
}

#[test]
fn momentum_energy_and_torque_are_those_of_polhode() {
    let omega = |e: &Solved, names| {
        let [x, y, z] = e.vector(names);
        Vector::new(x, y, z)
    };
    for e in Solved::all("angular-momentum") {
        let momentum = rotor(e.tensor()).angular_momentum(omega(&e, ["omega_x", "omega_y", "omega_z"]));
        e.require("L", &momentum.to_array());
    }
    for e in Solved::all("sign-of-products") {
        let [xy, xz, yz] = e.vector(["P_xy", "P_xz", "P_yz"]);
        let moments = e.vector(["I_xx", "I_yy", "I_zz"]);
        let tensor = InertiaTensor::<Body>::with_positive_products(moments, [xy, xz, yz]).unwrap().matrix();
        e.require(
            "L",
            &rotor(tensor).angular_momentum(omega(&e, ["omega_x", "omega_y", "omega_z"])).to_array(),
        );
    }
    for e in Solved::all("kinetic-energy") {
        e.require("T", &[rotor(e.tensor()).kinetic_energy(omega(&e, ["omega_x", "omega_y", "omega_z"]))]);
    }
    let principal = |e: &Solved| rotor(diagonal(e.vector(["I_1", "I_2", "I_3"])));
    for e in Solved::all("angle-between-omega-and-L") {
        let spin = omega(&e, ["omega_1", "omega_2", "omega_3"]);
        let momentum = principal(&e).angular_momentum(spin).to_array();
        let dot: f64 = momentum.iter().zip(spin.to_array()).map(|(a, b)| a * b).sum();
        let size = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        e.require("phi", &[(dot / size(momentum) / size(spin.to_array())).acos()]);
    }
    for e in Solved::all("euler-acceleration") {
        let torque = {
            let [x, y, z] = e.vector(["N_1", "N_2", "N_3"]);
            Vector::new(x, y, z)
        };
        let acceleration = principal(&e).acceleration(omega(&e, ["omega_1", "omega_2", "omega_3"]), torque);
        e.require("omega_dot", &acceleration.to_array());
    }
    for e in Solved::all("euler-torque") {
        let rates = {
            let [x, y, z] = e.vector(["alpha_1", "alpha_2", "alpha_3"]);
            Vector::new(x, y, z)
        };
        let torque = principal(&e).torque_for(omega(&e, ["omega_1", "omega_2", "omega_3"]), rates, 0.0);
        e.require("N", &torque.to_array());
    }
}

#[test]
fn dumbbells_have_the_torque_of_their_forces() {
    for e in Solved::all("dumbbell-torque") {
        let [m1, m2, b, omega, alpha] = ["m_1", "m_2", "b", "omega", "alpha"].map(|name| e.given(name));
        let particles =
            [(m1, b), (m2, -b)].map(|(m, z)| Particle::<Body>::new(m, Position::new(0.0, 0.0, z)).unwrap());
        let rotor = Rotor::pivoted(&mass_properties_of_particles(&particles).unwrap(), Position::ZERO);
        let spin = Vector::new(0.0, omega * alpha.sin(), omega * alpha.cos());
        let torque = rotor.torque_for(spin, Vector::new(0.0, 0.0, 0.0), 0.0);
        e.require("N_x", &[torque.x]);
    }
    for e in Solved::all("dumbbell-forces") {
        let [m1, m2, b, omega, alpha] = ["m_1", "m_2", "b", "omega", "alpha"].map(|name| e.given(name));
        let acceleration = omega * omega * b * alpha.sin();
        e.require("F_1", &[m1 * acceleration]);
        e.require("F_2", &[m2 * acceleration]);
        e.require("F_p", &[m1 * acceleration * alpha.cos()]);
    }
}

#[test]
fn pendulums_have_the_frequency_of_their_moments() {
    for e in Solved::all("physical-pendulum") {
        let [l, d, g] = ["l", "d", "g"].map(|name| e.given(name));
        let i = Rod::new(l).unwrap().mass_properties(Substance::Mass(2.0)).unwrap().inertia().matrix();
        let across = i.iter().enumerate().map(|(k, row)| row[k]).fold(0.0, f64::max);
        e.require("tau", &[2.0 * PI / (2.0 * g * d / (across + 2.0 * d * d)).sqrt()]);
    }
    for e in Solved::all("two-mass-pendulum") {
        let [m1, m2, b, g] = ["m_1", "m_2", "b", "g"].map(|name| e.given(name));
        let moment = m1 * b * b + m2 * b * b / 4.0;
        e.require("omega_0", &[((m1 * b + m2 * b / 2.0) * g / moment).sqrt()]);
    }
    for e in Solved::all("centre-of-percussion") {
        // It is the centre of oscillation: a simple pendulum of this length has the same period.
        let [mass, d, i] = ["M", "d", "I_C"].map(|name| e.given(name));
        e.require("p", &[(i + mass * d * d) / (mass * d)]);
    }
    for e in Solved::all("torsion-pendulum") {
        let [mass, diameter, kappa] = ["M", "D", "kappa"].map(|name| e.given(name));
        let disk = Disk::new(diameter / 2.0).unwrap().mass_properties(Substance::Mass(mass)).unwrap();
        let moment = disk.inertia().matrix()[2][2];
        e.require("I", &[moment]);
        e.require("tau", &[2.0 * PI * (moment / kappa).sqrt()]);
    }
}

#[test]
fn rolling_bodies_keep_their_energy() {
    for e in Solved::all("rolling-ball") {
        let [beta, s, g] = ["beta", "s", "g"].map(|name| e.given(name));
        let (v, a) = (e.answer("v")[0], e.answer("a")[0]);
        // ½ v² + ½ · 2/5 v² = g s sin β
        assert!((0.7 * v * v / (g * s * beta.sin()) - 1.0).abs() < 1e-12);
        assert!((v * v / (2.0 * a * s) - 1.0).abs() < 1e-12);
    }
    for e in Solved::all("rolling-disk") {
        let [mass, beta, g] = ["M", "beta", "g"].map(|name| e.given(name));
        let friction = e.answer("F")[0];
        // The net force and the friction give the same acceleration: a = F R²/I = 2 F/M.
        assert!((mass * g * beta.sin() - friction - 2.0 * friction).abs() < 1e-12 * friction);
        e.require("mu", &[friction / (mass * g * beta.cos())]);
    }
}

#[test]
fn tops_precess_as_their_vectors_do() {
    for e in Solved::all("free-symmetric-top") {
        let [i1, i3, w3] = ["I_1", "I_3", "omega_3"].map(|name| e.given(name));
        let spin = Vector::new(0.3, 0.0, w3);
        let rates = rotor(diagonal([i1, i1, i3])).acceleration(spin, Vector::new(0.0, 0.0, 0.0));
        // ω₁ = A cos Ωt, ω₂ = A sin Ωt at t = 0
        e.require("Omega", &[rates.y / 0.3]);
    }
    for e in Solved::all("cones") {
        let [i1, i3, w3, wp] = ["I_1", "I_3", "omega_3", "omega_p"].map(|name| e.given(name));
        let (alpha, theta) = ((wp / w3).atan(), (i1 * wp).atan2(i3 * w3));
        e.require("alpha", &[alpha]);
        e.require("theta", &[theta]);
        e.require("gamma", &[(alpha - theta).abs()]);
    }
    for e in Solved::all("precession-rate") {
        let [i1, i3, w3, wp] = ["I_1", "I_3", "omega_3", "omega_p"].map(|name| e.given(name));
        let momentum = rotor(diagonal([i1, i1, i3])).angular_momentum(Vector::new(wp, 0.0, w3)).to_array();
        let size = momentum[0].hypot(momentum[2]);
        e.require("L", &[size]);
        // Across the axis ω has only the precession, P sin θ.
        e.require("P", &[wp * size / momentum[0]]);
    }
    for e in Solved::all("stability") {
        let moments = e.vector(["I_1", "I_2", "I_3"]);
        let n = e.given("n");
        for (name, k, sign) in [("Omega_1", 0, -1.0), ("k", 1, 1.0), ("Omega_3", 2, -1.0)] {
            // d²/dt² of a small component across the axis, from Euler's equations twice
            let small = 1e-3;
            let spin = |a: f64, b: f64| {
                let mut all = [0.0; 3];
                (all[k], all[(k + 1) % 3], all[(k + 2) % 3]) = (n, a, b);
                Vector::new(all[0], all[1], all[2])
            };
            let rate = |a, b| {
                rotor(diagonal(moments)).acceleration(spin(a, b), Vector::new(0.0, 0.0, 0.0)).to_array()
            };
            let product = rate(0.0, small)[(k + 1) % 3] / small * (rate(small, 0.0)[(k + 2) % 3] / small);
            e.require(name, &[(sign * product).sqrt()]);
        }
    }
    for e in Solved::all("heavy-top") {
        let [mass, l, g, i3, i1, n] = ["M", "l", "g", "I_3", "I_1", "n"].map(|name| e.given(name));
        // The slower root of I₁ cos θ P² − I₃ n P + M g l = 0, at θ = 30°
        let (a, b, c) = (i1 * 0.75_f64.sqrt(), i3 * n, mass * g * l);
        let exact = 2.0 * c / (b + (b * b - 4.0 * a * c).sqrt());
        assert!((e.answer("P")[0] / exact - 1.0).abs() < 2e-3, "{exact}");
    }
}

#[test]
fn energies_and_units_are_those_of_si() {
    for e in Solved::all("energy-lost") {
        let [i1, i3, n] = ["I_1", "I_3", "n"].map(|name| e.given(name));
        let last = e.answer("omega")[0];
        assert!((i1 * n - i3 * last).abs() < 1e-12 * i1 * n && i3 > i1);
        e.require("lost", &[0.5 * i1 * n * n - 0.5 * i3 * last * last]);
    }
    for e in Solved::all("units") {
        let text = |name: &str| {
            let all = e.0["data"].as_array().unwrap();
            let text = all.iter().find(|datum| datum["symbol"] == name).unwrap()["text"].as_str().unwrap();
            text.split(' ').next().unwrap().parse::<f64>().unwrap()
        };
        let (i, omega, t) = (text("I") * 1e-4, text("n") * 2.0 * PI / 60.0, text("t") * 60.0);
        e.require("omega", &[omega]);
        e.require("L", &[i * omega]);
        e.require("T", &[0.5 * i * omega * omega]);
        e.require("N", &[i * omega / t]);
    }
}
