//! `polhode inertia`

#[cfg(not(feature = "robot"))]
mod no_robot;
mod output;
#[cfg(feature = "robot")]
mod robot;

use std::io::Write as _;
use std::path::Path;

use clap::{ArgGroup, Args};
use polhode_scenario::read::ScenarioFile;
use polhode_scenario::report::exact_tensor;
use polhode_scenario::symbolic::Exact;
use polhode_shape::report::InertiaReport;
use polhode_shape::{Host, Kind, Request, run_in};
use polhode_source::files::{Disk, Overlay};

#[cfg(not(feature = "robot"))]
use self::no_robot as robot;
use self::output::OutputFlags;
use self::robot::RobotFlags;
use crate::failure::Failure;
use crate::page;
use crate::partial;
use crate::progress::{FileProgress, SampleProgress};
use crate::stderr::tell;
use crate::stdout::print;

/// Compute mass, centre of mass, inertia tensor, principal moments and axes.
///
/// Input: scenarios (TOML), meshes, molecules, particles, voxel grids, CAD reports, robot models, or
/// the lengths of a shape (--box, --sphere, ...).
/// The tensor is about the centre of mass, along body axes; its off-diagonal elements are minus the
/// integrals, I_xy = -∫xy dm.
#[derive(Debug, Args)]
#[command(group = ArgGroup::new("written").args(robot::OUTPUTS).multiple(true), after_help = ["\
Examples:
  polhode inertia bracket.stl --unit mm --material aluminium
  polhode inertia bracket.stl --unit mm --mass \"85 g\" --about \"0,0,12 mm\" --json
  polhode inertia --box \"20 cm, 10 cm, 6 cm\" --mass \"2.5 kg\" --about corner
  polhode inertia arm.obj --part \"rod=steel\" --part \"grip=85 g\" --as urdf", robot::EXAMPLES, "
  polhode inertia torn.stl --unit mm --material steel --weld \"0.01 mm\" --write-mesh whole.stl
  polhode inertia scan.ply --unit mm --material steel --close-within 5%
  polhode inertia part.3mf --density \"1.24 g/cm^3\" --walls \"1.2 mm\" --infill 15%
  polhode inertia gripper.stl --unit mm --material steel --union
  polhode inertia parts/*.stl --unit mm --material steel --csv
  polhode inertia examples/notes/11-05-principal-axes.toml"].concat())]
pub(crate) struct Inertia {
    #[command(flatten)]
    request: Request,
    /// Replace an existing output file of --write-mesh or --write-inertials; never the model itself.
    #[arg(long, requires = "written", conflicts_with = "shell")]
    force: bool,
    /// Also print the tensor of a scenario in exact formulas of its [symbols], step by step.
    #[arg(long, conflicts_with_all = ["json", "csv", "as_format"])]
    symbols: bool,
    #[command(flatten)]
    robot: RobotFlags,
    #[command(flatten)]
    output: OutputFlags,
}

impl Inertia {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let Some(file) = &self.request.mesh.write_mesh {
            page::check_file(file, self.force)?;
        }
        let models = robot::expanded(&self.request.files, &self.robot)?;
        if let Some(done) =
            robot::write_inertials(&self.request, &self.robot, &self.output, self.force, &models)
        {
            return done;
        }
        let mut host = Command { robot: &self.robot, models: &models, files: None, samples: None };
        let steps = if self.symbols { self.in_symbols(&host)? } else { String::new() };
        let fits = |file: &Path| self.request.kind(file, &Disk, &host).map(drop);
        // A shape with --table is refused below.
        if !self.request.primitive.is_given()
            && let Some(done) = robot::tables(&self.request.files, &self.robot, &self.output, &models, fits)
        {
            return done;
        }
        host.files = Some(FileProgress::new(self.request.files.len()));
        let bodies = run_in(&self.request, &Disk, &mut host);
        drop(host);
        let bodies = bodies?;
        let text = self.output.text(&bodies);
        if self.output.has_no_room() {
            tell(&bodies.noticed());
        }
        let mut failures: Vec<Failure> =
            bodies.files.into_iter().filter_map(|file| file.reports.err()).map(Failure::from).collect();
        match text {
            Ok(text) => {
                if let Some(mesh) = bodies.mesh.filter(|_| failures.is_empty()) {
                    partial::write(&mesh.path, self.force, |out| out.write_all(&mesh.bytes))?;
                }
                print(&(text + &steps))?;
            }
            Err(failure) => failures.push(failure.into()),
        }
        Failure::unless_empty(failures)
    }

    /// Returns the steps to the tensors of scenarios, in exact formulas.
    fn in_symbols(&self, host: &Command<'_>) -> Result<String, Failure> {
        let hint = "leave out --symbols; it is for scenarios with [symbols], such as b = \"0.3 m\" and size = [\"b\", \"b\", \"2*b\"]";
        if self.request.files.is_empty() {
            return Err(Failure::usage("--symbols needs a scenario file", hint));
        }
        let mut text = String::new();
        for path in &self.request.files {
            let name = path.display();
            if self.request.kind(path, &Disk, host)? != Kind::Scenario {
                return Err(Failure::usage(format!("--symbols needs a scenario, and {name} is none"), hint));
            }
            let file = ScenarioFile::read(&Disk, path)?;
            let exact = file.exact();
            if let Exact::Gap(gap) = &exact {
                let hint = "name all lengths and masses under [symbols], or leave out --symbols";
                return Err(Failure::usage(format!("{name}: {gap}"), hint));
            }
            let document = exact_tensor(&file.scenario, &exact);
            let document = document.map_err(|error| Failure::motion(name.to_string(), error))?;
            let document =
                document.ok_or_else(|| Failure::usage(format!("{name} has no [symbols]"), hint))?;
            text += &format!("\n{}", document.to_text(100).trim_end());
            text.push('\n');
        }
        Ok(text)
    }
}

/// Readers of scenarios and robot models, and progress on the terminal.
struct Command<'a> {
    robot: &'a RobotFlags,
    /// Files of this machine, with the expansions of xacro files.
    models: &'a Overlay<'a>,
    files: Option<FileProgress>,
    samples: Option<SampleProgress>,
}

impl Host for Command<'_> {
    fn is_robot(&self, file: &Path) -> bool {
        robot::is_model(file, self.models)
    }

    fn robot_option(&self) -> Option<&'static str> {
        self.robot.given()
    }

    fn reports(&self, file: &Path, kind: Kind) -> Result<Vec<InertiaReport>, polhode_source::Failure> {
        match kind {
            Kind::Robot => robot::reports(file, self.robot, self.models),
            _ => Ok(vec![ScenarioFile::read(&Disk, file)?.inertia()]),
        }
    }

    fn begin(&mut self, file: &Path) {
        if let Some(files) = &mut self.files {
            files.next(file);
        }
    }

    fn begin_cubature(&mut self, pieces: usize) {
        self.samples = Some(SampleProgress::new(pieces));
    }

    fn sampled(&mut self, points: usize) {
        if let Some(samples) = &mut self.samples {
            samples.looked_at(points);
        }
    }
}
