//! Errors of tanks and of sequences of changes over time.

use polhode::motion::MotionError;

use crate::error::BudgetError;
use crate::errors::errors;

errors! {
    /// Error of tanks, or of a sequence of changes over time.
    SequenceError;

    /// A number is out of range.
    Value {
        /// Name of the quantity.
        what: &'static str,
        value: f64,
        /// Condition that the value has to meet.
        rule: &'static str,
    } => ("{what} is {value}, but must be {rule}");
    /// A table of a liquid has no rows, or its number of levels differs from its number of rows.
    EmptyTable => ("the table of a liquid has no rows, or the number of levels differs from the number of rows");
    /// A tank or a change refers to a row that the list does not have.
    MissingRow {
        /// Name of the item that refers to the row.
        by: String,
        /// Name of the missing row.
        row: String,
    } => ("{by} refers to the row \"{row}\", which is not in the list");
    /// A burn refers to a tank that does not exist.
    MissingTank {
        /// Name of the missing tank.
        tank: String,
    } => ("unknown tank \"{tank}\"");
    /// Two tanks have the same name.
    DuplicateTank {
        tank: String,
    } => ("duplicate tank \"{tank}\"");
    /// A tank would contain more than it holds, or less than nothing.
    Fill {
        tank: String,
        /// Mass that would be in the tank, kg.
        mass: f64,
        /// Mass that the tank holds, kg.
        capacity: f64,
        /// Time of the event, s.
        time: f64,
    } => ("at t = {time} s there would be {mass} kg in the tank \"{tank}\", which holds {capacity} kg"),
        hint: "check the outflow and the initial contents of the tank";
    /// A tank is in a row with several copies, so the filled one is ambiguous.
    Copies {
        tank: String,
        row: String,
    } => ("the tank \"{tank}\" is in \"{row}\", which has several copies"),
        hint: "give each copy its own row with its own tank";
    /// A change removes a row that was removed before, or liquid flows from a removed tank.
    Gone {
        /// Name of the removed item.
        what: String,
        /// Time of the event, s.
        time: f64,
    } => ("at t = {time} s \"{what}\" has already been removed");
    /// Two changes of the body have the same time.
    Simultaneous {
        /// Time of the changes, s.
        time: f64,
    } => ("the body changes twice at t = {time} s");
    /// A deployment changes the mass of the body.
    MassChanges {
        /// Time of the deployment, s.
        time: f64,
        /// Mass before, kg.
        before: f64,
        /// Mass after, kg.
        after: f64,
    } => ("the deployment at t = {time} s changes the mass from {before} kg to {after} kg"),
        hint: "a deployment keeps the mass: use [[drop]] at an earlier time for the difference";
    /// All mass of the body was removed.
    Nothing {
        /// Time of the event, s.
        time: f64,
    } => ("after t = {time} s the body has no mass left");
    /// Error of the parts list.
    Budget(error: BudgetError) => ("{error}"), hint: error.hint();
    /// Error of the mass history of the body.
    Motion(error: MotionError) => ("{error}"), hint: error.hint();
}
