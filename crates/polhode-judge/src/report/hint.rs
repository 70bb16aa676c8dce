//! Hints for runs that cannot be judged.

use polhode::infer::judge::JudgeError;

/// Returns a hint on how to judge a run after an error, by the options of the command.
pub fn judge_hint(error: &JudgeError) -> Option<&'static str> {
    Some(match error {
        JudgeError::Motion(error) => return error.hint(),
        JudgeError::NoMotion => {
            "give a scenario with [start]; of a prescribed motion `polhode torque` says what it needs"
        }
        JudgeError::Changing => {
            "leave out [mass_history] if the run is of the body as it is at the start; `polhode simulate` computes the motion of one that changes"
        }
        JudgeError::OnGround | JudgeError::InGimbals => "`polhode simulate` computes its motion",
        JudgeError::BeforeStart { .. } => "--time-origin says the run's time at the scenario's time 0",
        JudgeError::Ends { .. } => "leave the event that stops the scenario out, or judge the rows before it",
        // If only one quaternion order was tried, it is known.
        JudgeError::NoReading { tried }
            if tried.windows(2).all(|pair| pair[0].reading.order == pair[1].reading.order) =>
        {
            "is it the run of another scenario? Else say which way its rotations go: --sense body-to-space or space-to-body"
        }
        JudgeError::NoReading { .. } => {
            "is it the run of another scenario? Else say what its numbers are: --quaternion wxyz or xyzw, and --sense body-to-space or space-to-body"
        }
        JudgeError::OtherRate { .. } => {
            "check the unit of the angular velocity that the program was given: deg/s for rad/s is 57.3 times; and that of its times: --columns \"time ms = t\""
        }
        JudgeError::NotSearched { .. } => {
            "--time-origin says the run's time at the scenario's time 0; --quaternion and --sense say what its numbers are"
        }
        JudgeError::Ambiguous { .. } => {
            "say what its numbers are: --quaternion, --sense, --axes, --time-origin"
        }
        JudgeError::AmbiguousOmega { .. } => "say it: --omega body or --omega space; or is it not in rad/s?",
        JudgeError::NoOmega { .. } => {
            "--omega body or --omega space compares it as it is; --columns \"omega = none\" leaves it out"
        }
        JudgeError::FarTimes { .. } => "--time-origin is the run's time at the scenario's time 0",
        _ => "say what its numbers are: --quaternion, --sense, --omega, --axes, --time-origin",
    })
}
