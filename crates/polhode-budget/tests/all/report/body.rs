//! Body of a configuration, for other commands.

use polhode_budget::Basis;
use polhode_budget::report::BudgetReport;

use super::{limits, options, satellite, text};

#[test]
fn configurations_stand_side_by_side_and_a_body_is_one_of_them() {
    let both = [("stowed", false), ("deployed", true)]
        .map(|(name, wings)| (Some(name.to_owned()), satellite(wings)));
    let both =
        BudgetReport::new(Some("A CubeSat"), Vec::new(), both.to_vec(), limits(), options(100)).unwrap();
    let text = text(&both);
    assert!(text.contains("quantity  stowed  ") && text.contains("3. stowed: Mass breakdown"), "{text}");
    let none = both.body(None).unwrap_err();
    assert_eq!(
        (none.message(), none.hint()),
        (
            "the file has several configurations, but only one can be used".to_owned(),
            Some("name one of \"stowed\", \"deployed\"".to_owned()),
        )
    );
    assert_eq!(both.body(Some("flying")).unwrap_err().message(), "unknown configuration \"flying\"");
    let body = both.body(Some("stowed")).unwrap();
    assert_eq!(body, satellite(false).mass_properties(Basis::Predicted).unwrap());
    let toml = both.to_scenario(Some("stowed")).unwrap();
    assert!(
        toml.contains(&format!("mass = {:?}", body.mass())) && toml.contains("stowed, predicted masses"),
        "{toml}"
    );
}
