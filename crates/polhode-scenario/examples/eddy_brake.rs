//! A bracket from a mesh, tumbling in a magnetic field that brakes it, until half of its kinetic energy
//! is gone: a table of its motion.

use std::path::Path;

use polhode::motion::{EventAction, Measure, Sense};
use polhode::prelude::*;
use polhode_shape::mesh::{MeshFormat, MeshSolid};
use polhode_source::files::Disk;

/// N = k B × (B × ω): eddy currents brake what turns across the field B, which is fixed in space.
#[derive(Debug)]
struct EddyBrake {
    coefficient: f64,
    field: Direction<Space>,
}

impl Law for EddyBrake {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let b = at.in_space(self.field);
        b.cross(b.cross(at.omega())).scaled(self.coefficient)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mesh = MeshSolid::read(&Disk, Path::new("examples/bracket.stl"), MeshFormat::Stl, Some(1e-3))?;
    let body = mesh.mass_properties(Substance::Density(2700.0))?.into_body();
    eprintln!("{body}");

    let brake = EddyBrake { coefficient: 2e-5, field: Direction::new(0.0, 0.6, 0.8) };
    let (rotor, torques) = (Rotor::free(&body), [TorqueModel::own("eddy brake", brake)]);
    let start = State { time: 0.0, attitude: Attitude::identity(), omega: [3.0, 0.5, 1.0].into() };
    let half = 0.5 * rotor.kinetic_energy(start.omega);
    let stop = Event::new("braked", Measure::KineticEnergy, half, Sense::Falling, EventAction::Stop)?;
    let times: Vec<f64> = (0..=600).map(|k| f64::from(k) * 0.1).collect();
    let motion = Simulation::new(&rotor, &torques, start, &times).events(&[stop]).run()?;
    motion.events().iter().for_each(|event| eprintln!("{} at {:.6} s", event.name, event.state.time));
    Ok(polhode_table::output::Table::of(&motion, &Default::default()).write_csv(std::io::stdout())?)
}
