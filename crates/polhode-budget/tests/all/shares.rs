//! Confidence intervals of shares compared with published ones.

use polhode_budget::Share;

#[test]
fn intervals_are_those_of_clopper_and_pearson() {
    // scipy.stats.beta.ppf and isf, 1.17
    let known = [
        (0, 10, 0.95, [0.0, 0.3084971078187607]),
        (10, 10, 0.95, [0.6915028921812392, 1.0]),
        (5, 20, 0.95, [0.08657146910143462, 0.49104587170795744]),
        (1, 1, 0.9, [0.05, 1.0]),
        (3, 1000, 0.99, [0.00033814452906649344, 0.01093377742040524]),
        (9876, 10_000, 0.95, [0.9852332341828884, 0.9896760388218261]),
        (9999, 10_000, 0.9999366575163338, [0.9987008701825867, 0.9999999968328257]),
        (123_456, 1_000_000, 0.95, [0.12281184162962973, 0.12410234027680268]),
    ];
    for (met, of, level, want) in known {
        let got = Share::new(met, of, level).unwrap().interval;
        for k in 0..2 {
            assert!((got[k] - want[k]).abs() <= 1e-9 * want[k], "{met}/{of}: {got:?} {want:?}");
        }
    }
    for (met, of, level) in [(0, 0, 0.95), (2, 1, 0.95), (1, 2, 0.0), (1, 2, 1.0), (1, 2, f64::NAN)] {
        assert_eq!(Share::new(met, of, level), None);
    }
}
