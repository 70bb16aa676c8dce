//! Torques, wheels and events of the members of an ensemble; Python functions may compute some of
//! them.

use std::path::{Path, PathBuf};

use polhode::motion::torque::TorqueModel;
use polhode::motion::{Event, EventFunction, Member, Rotor, State};
use polhode_scenario::read::Actions;
use polhode_source::files::Disk;
use pyo3::prelude::*;

use crate::error::{Raise, refused};
use crate::function::PythonFunction;
use crate::scenario::{Raised, function, measured, measuring, vectorized};

/// Torque computed in Python: true for components along space axes, and the function.
pub(crate) type PythonTorque = (bool, Called);

/// Python function of a torque.
#[derive(Debug, FromPyObject)]
pub(crate) enum Called {
    /// One call handles one member.
    One(PythonFunction),
    /// One call handles many members.
    Many(Py<PyAny>),
}

/// Event measure computed in Python: true if it depends on the body, and the function.
pub(crate) type PythonMeasure = (bool, PythonFunction);

/// Torques and event measures computed in Python.
pub(crate) type PythonFunctions = (Vec<PythonTorque>, Vec<PythonMeasure>);

/// Assignments of Python functions: (number of the torque, number of the function), and the same
/// for event measures.
pub(crate) type Placed = (Vec<(usize, usize)>, Vec<(usize, usize)>);

/// Actions on members: their name in messages, the TOML of `[[torque]]`s, the TOML of `[[wheel]]`s
/// and `[[event]]`s, and the assigned functions.
pub(crate) type PythonActions = (PathBuf, String, String, Placed);

/// Python functions of an ensemble.
#[derive(Clone, Debug)]
pub(crate) struct Functions {
    torques: Vec<TorqueModel>,
    measures: Vec<EventFunction>,
    /// Exception raised by one of the functions.
    pub(crate) raised: Raised,
    /// True if a function is called for one member at a time; such calls never run in parallel.
    pub(crate) is_called: bool,
}

impl Functions {
    pub(crate) fn new((torques, measures): PythonFunctions) -> Self {
        let is_called =
            !measures.is_empty() || torques.iter().any(|(_, called)| matches!(called, Called::One(_)));
        let raised = Raised::default();
        let made = |(in_space, called)| match called {
            Called::One(law) => function(in_space, law, Raised::clone(&raised)),
            Called::Many(law) => vectorized(in_space, law, Raised::clone(&raised)),
        };
        let torques = torques.into_iter().map(made).collect();
        let measure = |(needs_body, measure)| measured(needs_body, measure, Raised::clone(&raised));
        let measures = measures.into_iter().map(measure).collect();
        Self { torques, measures, raised, is_called }
    }

    /// Replaces the assigned torques and event measures by Python functions.
    pub(crate) fn replace(
        &self,
        torques: &mut [TorqueModel],
        events: &mut [Event],
        (of_torques, of_events): &Placed,
    ) -> PyResult<()> {
        for (place, which) in of_torques {
            let (Some(torque), Some(made)) = (torques.get_mut(*place), self.torques.get(*which)) else {
                return Err(refused(format!("torque {place} does not exist"), None));
            };
            *torque = made.clone();
        }
        for (place, which) in of_events {
            let (Some(event), Some(made)) = (events.get_mut(*place), self.measures.get(*which)) else {
                return Err(refused(format!("event {place} does not exist"), None));
            };
            *event = measuring(event, made.clone())?;
        }
        Ok(())
    }
}

/// Actions that several members share.
pub(crate) struct SharedActions {
    pub(crate) actions: Actions,
    torques: Vec<TorqueModel>,
    events: Vec<Event>,
}

impl SharedActions {
    pub(crate) fn read(
        (path, torques, others, placed): &PythonActions,
        is_held: bool,
        functions: &Functions,
    ) -> PyResult<Self> {
        require_torques(torques)?;
        let actions =
            Actions::parse(&Disk, format!("{torques}{others}"), path, is_held).map_err(Raise::raise)?;
        let mut torques = actions.scenario().torques().to_vec();
        let mut events = actions.scenario().events().to_vec();
        functions.replace(&mut torques, &mut events, placed)?;
        Ok(Self { actions, torques, events })
    }

    /// Creates a member with these actions.
    pub(crate) fn on(&self, rotor: Rotor, start: State) -> Member {
        let switched_off = self.actions.scenario().switched_off().to_vec();
        Member::new(rotor, self.torques.clone(), start)
            .switched_off(switched_off)
            .watching(self.events.clone())
    }
}

/// Reads the torques of a text without other tables, for a free body.
pub(crate) fn read_torques(text: &str) -> PyResult<Vec<TorqueModel>> {
    require_torques(text)?;
    let actions =
        Actions::parse(&Disk, text.to_owned(), Path::new("torques"), false).map_err(Raise::raise)?;
    if actions.pivot().is_none() && actions.scenario().switched_off().is_empty() {
        return Ok(actions.scenario().torques().to_vec());
    }
    Err(refused("torques may contain only [[torque]] tables of free bodies, all switched on", None))
}

/// Refuses a text of torques that has other tables.
fn require_torques(text: &str) -> PyResult<()> {
    let known = ["torque", "orbit"];
    // Syntax errors are reported later, with their place, by the reader of the text.
    let tables = toml::from_str::<toml::Table>(text).unwrap_or_default();
    if tables.keys().all(|key| known.contains(&key.as_str())) {
        return Ok(());
    }
    let hint = "use the ensemble's other arguments for the other sections of a scenario";
    Err(refused("torques may contain only [[torque]] tables and their [orbit]", Some(hint)))
}
