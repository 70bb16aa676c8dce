//! Hints for runs that cannot be judged.

use polhode::infer::judge::JudgeError;

/// Returns a hint on how to judge a run after an error, by the options of the command.
pub fn judge_hint(error: &JudgeError) -> Option<&'static str> {
    Some(match error {
        JudgeError::Motion(error) => return error.hint(),
        JudgeError::NoMotion => {
            "use a scenario with [start]; for a prescribed motion, `polhode torque` computes the torque"
        }
        JudgeError::Changing => {
            "remove [mass_history] if the body of the run does not change; `polhode simulate` computes the motion of one that does"
        }
        JudgeError::OnGround | JudgeError::InGimbals => "`polhode simulate` computes its motion",
        JudgeError::BeforeStart { .. } => "set --time-origin, the run's time at the scenario's time 0",
        JudgeError::Ends { .. } => {
            "remove the event that stops the scenario, or judge only the rows before it"
        }
        // If only one quaternion order was tried, it is known.
        JudgeError::NoReading { tried }
            if tried.windows(2).all(|pair| pair[0].reading.order == pair[1].reading.order) =>
        {
            "check that it is a run of this scenario; if so, state the sense of its rotations: --sense body-to-space or space-to-body"
        }
        JudgeError::NoReading { .. } => {
            "check that it is a run of this scenario; if so, state its conventions: --quaternion wxyz or xyzw, and --sense body-to-space or space-to-body"
        }
        JudgeError::OtherRate { .. } => {
            "check the unit of the program's angular velocity (deg/s for rad/s is a factor of 57.3) and of its times: --columns \"time ms = t\""
        }
        JudgeError::NotSearched { .. } => {
            "set --time-origin, the run's time at the scenario's time 0, or state its conventions: --quaternion, --sense"
        }
        JudgeError::Ambiguous { .. } => "state its conventions: --quaternion, --sense, --axes, --time-origin",
        JudgeError::AmbiguousOmega { .. } => {
            "state its axes: --omega body or --omega space; or check its unit"
        }
        JudgeError::NoOmega { .. } => {
            "--omega body or --omega space compares it as written; --columns \"omega = none\" ignores it"
        }
        JudgeError::FarTimes { .. } => "set --time-origin, the run's time at the scenario's time 0",
        _ => "state its conventions: --quaternion, --sense, --omega, --axes, --time-origin",
    })
}
