//! What acts on the members of an ensemble: torques, some of which Python computes, wheels and events.

use std::path::{Path, PathBuf};

use polhode::motion::torque::TorqueModel;
use polhode::motion::{Member, Rotor, State};
use polhode_formats::scenario::Actions;
use pyo3::prelude::*;

use crate::error::{Raise, refused};
use crate::scenario::{Raised, function, vectorized};

/// A torque that Python computes: whether it is along space axes, a function, and whether that is of many members at once.
pub(crate) type PythonTorque = (bool, Py<PyAny>, bool);

/// Which torque it is in the place of, and which of the functions it is.
pub(crate) type Placed = (usize, usize);

/// What acts on members: what messages call it, the text of `[[torque]]`s, that of `[[wheel]]`s and `[[event]]`s, and which torques functions take the place of.
pub(crate) type PythonActions = (PathBuf, String, String, Vec<Placed>);

/// The torques that Python computes.
#[derive(Clone, Debug)]
pub(crate) struct Functions {
    torques: Vec<TorqueModel>,
    /// By one of them.
    pub(crate) raised: Raised,
    /// Whether Python computes a torque for one member at a time: it does so for no two of them at once.
    pub(crate) is_called: bool,
}

impl Functions {
    pub(crate) fn new(given: Vec<PythonTorque>) -> Self {
        let (raised, is_called) = (Raised::default(), given.iter().any(|(_, _, many)| !many));
        let made = |(in_space, law, many)| {
            let made = if many { vectorized } else { function };
            made(in_space, law, Raised::clone(&raised))
        };
        let torques = given.into_iter().map(made).collect();
        Self { torques, raised, is_called }
    }

    /// Puts them in the place of some torques.
    pub(crate) fn replace(&self, torques: &mut [TorqueModel], placed: &[Placed]) -> PyResult<()> {
        for (place, which) in placed {
            let (Some(torque), Some(made)) = (torques.get_mut(*place), self.torques.get(*which)) else {
                return Err(refused(format!("there is no torque {place}"), None));
            };
            *torque = made.clone();
        }
        Ok(())
    }
}

/// What acts on some members.
pub(crate) struct SharedActions {
    pub(crate) actions: Actions,
    torques: Vec<TorqueModel>,
}

impl SharedActions {
    pub(crate) fn read(
        (path, torques, others, placed): &PythonActions,
        is_held: bool,
        functions: &Functions,
    ) -> PyResult<Self> {
        require_torques(torques)?;
        let actions = Actions::parse(format!("{torques}{others}"), path, is_held).map_err(Raise::raise)?;
        let mut torques = actions.scenario().torques().to_vec();
        functions.replace(&mut torques, placed)?;
        Ok(Self { actions, torques })
    }

    /// The member that they act on.
    pub(crate) fn on(&self, rotor: Rotor, start: State) -> Member {
        let scenario = self.actions.scenario();
        let member = Member::new(rotor, self.torques.clone(), start);
        member.switched_off(scenario.switched_off().to_vec()).watching(scenario.events().to_vec())
    }
}

/// The torques of a text that holds nothing else, on a free body.
pub(crate) fn read_torques(text: &str) -> PyResult<Vec<TorqueModel>> {
    require_torques(text)?;
    let actions = Actions::parse(text.to_owned(), Path::new("torques"), false).map_err(Raise::raise)?;
    if actions.pivot().is_none() && actions.scenario().switched_off().is_empty() {
        return Ok(actions.scenario().torques().to_vec());
    }
    Err(refused("torques may hold [[torque]] tables only, of free bodies, all switched on", None))
}

/// Refuses a text of torques with other tables.
fn require_torques(text: &str) -> PyResult<()> {
    let known = ["torque", "orbit"];
    // What is no TOML is said with its place by whoever reads it.
    let tables = toml::from_str::<toml::Table>(text).unwrap_or_default();
    if tables.keys().all(|key| known.contains(&key.as_str())) {
        return Ok(());
    }
    let hint = "what a scenario's other sections say is what an ensemble's other arguments say";
    Err(refused("torques may hold [[torque]] tables only, and the [orbit] of these", Some(hint)))
}
