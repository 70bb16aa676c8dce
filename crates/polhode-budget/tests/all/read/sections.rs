//! Statements of a file outside its parts.

use polhode::math::{Body, Part, Rotation};
use polhode_budget::{Basis, CopyErrors, Group, Growth};

use super::{budget, csv, estimate};

#[test]
fn a_head_says_what_is_asked() {
    let file = csv(
        "# title = \"A list\"\n## for people: # not TOML\n# [result]\n# about = [\"10 mm\", 0, \"-2 cm\"]\n# axes = { axis = [0, 0, 1], angle = \"30 deg\" }\n\
         # draws = 5000\n# seed = 42\n# basis = \"basic\"\nname,mass\na,1\n",
    )
    .unwrap();
    assert_eq!(file.title.as_deref(), Some("A list"));
    let asked = file.questions;
    assert_eq!(asked.about.unwrap().to_array(), [0.01, 0.0, -0.02]);
    let turn = Rotation::<Body, Part>::from_roll_pitch_yaw([0.0, 0.0, 30_f64.to_radians()]).unwrap();
    assert!((asked.axes.unwrap().matrix()[1][0] - turn.matrix()[1][0]).abs() < 1e-15);
    assert_eq!((asked.draws, asked.seed, asked.basis), (Some(5000), 42, Basis::Basic));
    let names = |text: &str| budget(text).list().rows.iter().map(|row| row.name.clone()).collect::<Vec<_>>();
    assert_eq!(names("# title = \"A/B\"\nname,mass\na,1\nb,1\n"), ["a", "b", "A B"]);
    assert_eq!(names("# title = \"a\"\nname,mass\na,1\nwhole,1\n"), ["a", "whole", "whole 2"]);
    let plain = csv("name,mass\na,1\n").unwrap().questions;
    assert_eq!((plain.draws, plain.basis, plain.about), (None, Basis::Predicted, None));
}

#[test]
fn growth_is_given_by_codes_or_by_fractions() {
    let list = budget(
        "# growth = { E = \"25 %\", C = 0.08 }\nname,mass [kg],maturity,growth,allowable [kg]\na,1,E,,\nb,2,C,8 %,\nc,4,,12.5 %,\nd,8,,0.05,9\ne,16,,,\n",
    );
    let growth = |k: usize| list.list().rows[k].growth.clone();
    assert_eq!(growth(0), Growth::Code("E".to_owned()));
    assert_eq!([1, 2, 3].map(growth), [0.08, 0.125, 0.05].map(Growth::Fraction));
    assert_eq!(list.list().rows[3].allowable, Some(9.0));
    let statement = list.mass_statements().unwrap()[list.root()];
    assert_eq!(statement.basic, 31.0);
    assert!((statement.predicted - (1.25 + 2.16 + 4.5 + 8.4 + 16.0)).abs() < 1e-12);
    let percent = budget("name,mass,growth [%]\na,1,25\nb,2,8\nc,4,12.5 %\n");
    assert_eq!(percent.list().rows[1].growth, Growth::Fraction(0.08));
    assert_eq!(percent.list().rows[2].growth, Growth::Fraction(0.125));
}

#[test]
fn groups_correlate_what_they_say() {
    let list = |head: &str| {
        budget(&format!(
            "{head}name,mass [kg],x [m],y [m],z [m],group\na,1 ± 0.02,0.1,0,0,g\nb,3 ± 0.06,0.5 ± 0.01,0,0,g\nc,2 ± 0.5,0,0,0,\n"
        ))
    };
    let all = list("# [[group]]\n# name = \"g\"\n# correlation = 0.5\n");
    assert_eq!(all.list().groups[0].center, 0.5);
    let masses = list("# [[group]]\n# name = \"g\"\n# mass = \"50 %\"\n");
    assert_eq!(masses.list().groups, [Group::of_masses("g", 0.5)]);
    let variance = 0.02_f64.powi(2) + 0.06_f64.powi(2) + 2.0 * 0.5 * 0.02 * 0.06 + 0.25;
    assert!((estimate(&masses).sd(0) - variance.sqrt()).abs() < 1e-15);
}

#[test]
fn copies_and_configurations_are_told_apart() {
    let file = csv(
        "# configurations = [\"stowed\", \"deployed\"]\nname,parent,quantity,copies,mass [g],at x [mm],configuration\nsat,,,,,,\nbody,sat,1,,1000,0,\n\
         panel,sat,2,independent,50 ± 1,10,stowed\npanel,sat,2,independent,50 ± 1,200,deployed\ncover,sat,1,,5,0,\"stowed, launch\"\n"
            .replace("[\"stowed\", \"deployed\"]", "[\"stowed\", \"deployed\", \"launch\"]")
            .as_str(),
    )
    .unwrap();
    let names: Vec<_> = file.configurations.iter().map(|c| c.name.as_deref().unwrap()).collect();
    assert_eq!(names, ["stowed", "deployed", "launch"]);
    let masses: Vec<f64> =
        file.configurations.iter().map(|c| estimate(&c.budget).properties.mass()).collect();
    for (mass, expected) in masses.iter().zip([1.105, 1.1, 1.005]) {
        assert!((mass - expected).abs() < 1e-15);
    }
    let quantity = file.configurations[1].budget.list().rows[2].quantity;
    assert_eq!((quantity.count, quantity.errors), (2, CopyErrors::Independent));
    // Without a list of configurations, their order is that of the rows.
    let file = csv("name,mass,configuration\na,1,late\nb,1,early; late\n").unwrap();
    let names: Vec<_> = file.configurations.iter().map(|c| c.name.as_deref().unwrap()).collect();
    assert_eq!(names, ["late", "early"]);
}

#[test]
fn subtotals_hold_to_half_of_their_last_digit() {
    let list = |subtotal: &str| {
        csv(&format!("name,parent,mass [g],subtotal [g]\nbox,,,{subtotal}\na,box,12.34,\nb,box,5.02,\n"))
    };
    for right in ["17.36", "17.4", "17", "2e1", "17.3 ± 0.1", "0.017 kg", "0.0174 kg"] {
        assert!(list(right).is_ok(), "{right}");
    }
    for wrong in ["17.37", "17.3", "18", "17.30", "17.3 ± 0.01", "0.0173 kg"] {
        let error = list(wrong).unwrap_err().to_string();
        assert!(error.starts_with("list.csv:2:7: \"box\" states"), "{wrong}: {error}");
    }
}

#[test]
fn tolerances_of_subtotals_know_no_coverage_factor() {
    let list = |subtotal: &str| {
        csv(&format!(
            "# coverage_factor = 2\nname,mass [kg],subtotal [kg],subtotal sd [kg]\na,1.26,{subtotal}\n"
        ))
    };
    assert!(list("1.4,0.15").is_ok());
    assert!(list("1.4,0.08").unwrap_err().to_string().contains("differs by more than 0.08 kg"));
}
