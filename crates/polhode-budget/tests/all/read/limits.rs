//! Limits and sites of ballast.

use polhode::math::{Direction, Position};
use polhode_budget::{About, BallastPlace, Basis, Measure, PrincipalAxis, ProductSign};

use super::{Folder, csv};

/// Returns the limits of a list with these lines in its head.
fn limits(lines: &str) -> Result<Vec<polhode_budget::Limit>, String> {
    let head: String = lines.lines().map(|line| format!("# {line}\n")).collect();
    let file = csv(&format!("{head}name,mass [kg],x [m],y [m],z [m]\na,1,0.1,0.2,-0.3\nb,2,0,0.5,0\n"));
    file.map(|file| file.limits).map_err(|error| format!("{error} | {}", error.hint().unwrap_or_default()))
}

fn measure(lines: &str) -> Measure {
    limits(&format!("[[limit]]\n{lines}")).unwrap_or_else(|error| panic!("{lines}: {error}")).remove(0).of
}

#[test]
fn every_measure_is_read() {
    let (x, z) = (Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 0.0, 1.0));
    let at = Position::new(0.01, 0.0, -0.02);
    let point = "from = [\"1 cm\", 0, \"-20 mm\"]";
    for (lines, want) in [
        ("of = \"mass\"\nmost = \"3 kg\"".to_owned(), Measure::Mass),
        (
            format!("of = \"center\"\nalong = \"z\"\n{point}\nmost = \"2 mm\""),
            Measure::Center { along: z, from: at },
        ),
        (format!("of = \"center distance\"\n{point}\nmost = 1"), Measure::CenterFromPoint(at)),
        (
            format!("of = \"center distance\"\nalong = \"z\"\n{point}\nmost = 1"),
            Measure::CenterFromLine { point: at, along: z },
        ),
        (
            "of = \"static unbalance\"\nalong = \"-z\"\nmost = \"5 g mm\"".to_owned(),
            Measure::StaticUnbalance { point: Position::ZERO, along: -z },
        ),
        (
            "of = \"couple unbalance\"\nalong = [0, 0, 2]\nmost = \"5 g mm^2\"".to_owned(),
            Measure::CoupleUnbalance { point: Position::ZERO, along: Direction::new(0.0, 0.0, 2.0) },
        ),
        (
            "of = \"moment\"\nalong = \"x\"\nabout = \"origin\"\nleast = 0.1".to_owned(),
            Measure::Moment { axis: x, about: About::Point(Position::ZERO) },
        ),
        (
            "of = \"product\"\naxes = [\"x\", \"z\"]\nproducts = \"positive integrals\"\nmost = 0.1"
                .to_owned(),
            Measure::Product {
                axes: [x, z],
                sign: ProductSign::PositiveIntegral,
                about: About::CenterOfMass,
            },
        ),
        ("of = \"principal moment\"\nnumber = 3\nmost = 1".to_owned(), Measure::PrincipalMoment(2)),
        ("of = \"principal ratio\"\nnumbers = [1, 3]\nmost = 1".to_owned(), Measure::PrincipalRatio([0, 2])),
        (
            "of = \"tilt\"\nalong = \"z\"\nmost = \"1 deg\"".to_owned(),
            Measure::Tilt { axis: PrincipalAxis::Nearest, from: z },
        ),
        (
            "of = \"tilt\"\nalong = \"z\"\nnumber = 1\nmost = \"1 deg\"".to_owned(),
            Measure::Tilt { axis: PrincipalAxis::Number(0), from: z },
        ),
        ("of = \"spin ratio\"\nalong = \"z\"\nleast = 1".to_owned(), Measure::SpinRatio(z)),
        ("of = \"spin stability\"\nalong = \"x\"\nleast = 0".to_owned(), Measure::SpinStability(x)),
    ] {
        assert_eq!(measure(&lines), want, "{lines}");
    }
}

#[test]
fn bounds_have_units_and_a_basis() {
    let all = limits(
        "[[limit]]\nof = \"center\"\nalong = \"x\"\nwithin = \"2 mm\"\n[[limit]]\nname = \"tilt\"\nof = \"tilt\"\nalong = \"z\"\nleast = \"0.5 deg\"\nmost = \"90 deg\"\nbasis = \"basic\"",
    )
    .unwrap();
    assert_eq!(
        (all[0].name.as_str(), all[0].least, all[0].most),
        ("center along x", Some(-0.002), Some(0.002))
    );
    assert_eq!((all[0].basis, all[1].basis), (Basis::Predicted, Basis::Basic));
    assert!((all[1].least.unwrap() - 0.5_f64.to_radians()).abs() < 1e-16);
    assert_eq!(all[1].name, "tilt");
}

#[test]
fn the_sign_of_a_product_matters_where_the_limit_is_to_one_side() {
    let product = "[[limit]]\nof = \"product\"\naxes = [\"x\", \"y\"]\n";
    assert!(limits(&format!("{product}within = 0.1")).is_ok());
    assert!(limits(&format!("products = \"tensor elements\"\n{product}most = 0.1")).is_ok());
    assert!(limits(&format!("{product}most = 0.1")).unwrap_err().contains("products"));
}

#[test]
fn what_says_nothing_is_refused() {
    for (lines, says) in [
        ("of = \"mass\"", "most"),
        ("of = \"mass\"\nmost = \"2 mm\"", "a length where a mass belongs"),
        ("of = \"mass\"\nmost = 2\nalong = \"x\"", "left out of a limit on \"mass\""),
        ("of = \"weight\"\nmost = 2", "mass"),
        ("of = \"tilt\"\nmost = 2", "along"),
        ("of = \"tilt\"\nalong = [0, 0, 0]\nmost = 2", "not zero"),
        ("of = \"center\"\nalong = \"z\"\nleast = 2\nmost = 1", "at least the value of least"),
        ("of = \"center\"\nalong = \"z\"\nwithin = 2\nmost = 1", "within sets both"),
        ("of = \"principal moment\"\nnumber = 4\nmost = 1", "1, 2 or 3"),
        ("of = \"product\"\naxes = [\"x\", [1, 1, 0]]\nwithin = 1", "perpendicular"),
        ("of = \"mass\"\nmost = 1\n[[limit]]\nof = \"mass\"\nleast = 1", "unique among the limits"),
    ] {
        let error = limits(&format!("[[limit]]\n{lines}")).unwrap_err();
        assert!(error.contains(says) && error.starts_with("list.csv:"), "{lines}: {error}");
    }
}

const LIMIT: &str = "[[limit]]\nof = \"center distance\"\nalong = \"z\"\nmost = \"1 mm\"\n";

#[test]
fn sites_have_their_forms() {
    let folder = Folder::new("sites");
    folder.write("parts.csv", "name,mass [kg],x [m],y [m],z [m]\na,1,0.1,0.2,-0.3\n");
    let plan = |text: &str| folder.read("plan.toml", format!("parts = \"parts.csv\"\n{LIMIT}{text}"));
    let file = plan(
        "[ballast]\nmost = \"200 g\"\ndeviations = 2\n[[site]]\nname = \"a\"\nat = [1, 2, 3]\nmost = \"50 g\"\nsizes = [\"5 g\", \"10 g\"]\n\
         [[site]]\nname = \"b\"\nat = [0, 0, 0]\nto = [\"10 cm\", 0, 0]\nsizes = [\"20 g\"]\n[[site]]\nname = \"c\"\nat = [0, 0, 1]\nradius = \"20 cm\"\nnormal = \"z\"\n\
         [[site]]\nname = \"d\"\nat = [0, 0, 1]\nradius = \"20 cm\"\nnormal = \"z\"\nrim = true\n\
         [[site]]\nname = \"e\"\nat = [0, 0, 1]\nradius = \"20 cm\"\nnormal = \"z\"\nholes = 4\nfirst = \"x\"\n",
    )
    .unwrap();
    let ballast = file.ballast.unwrap();
    assert_eq!((ballast.most, ballast.deviations), (Some(0.2), 2.0));
    let names: Vec<&str> = ballast.sites.iter().map(|site| site.name.as_str()).collect();
    assert_eq!(names, ["a", "b", "c", "d", "e 1", "e 2", "e 3", "e 4"]);
    assert_eq!((ballast.sites[0].most, &ballast.sites[0].sizes[..]), (Some(0.05), &[0.005, 0.01][..]));
    let BallastPlace::Line([_, end]) = ballast.sites[1].place else { panic!() };
    assert_eq!((end.to_array(), &ballast.sites[1].sizes[..]), ([0.1, 0.0, 0.0], &[0.02][..]));
    assert!(
        matches!(ballast.sites[2].place, BallastPlace::Disc(_))
            && matches!(ballast.sites[3].place, BallastPlace::Circle(_))
    );
    let BallastPlace::Point(second) = ballast.sites[5].place else { panic!() };
    assert!((second - Position::new(0.0, 0.2, 1.0)).norm() < 1e-15);
    for (text, says) in [
        ("[ballast]\nmost = 1", "[[site]]"),
        ("[[site]]\nname = \"a\"\nat = [0, 0, 0]\nrim = true", "without a radius"),
        ("[[site]]\nname = \"a\"\nat = [0, 0, 0]\nto = [1, 0, 0]\nsizes = [0]", "positive"),
        ("[[site]]\nname = \"a\"\nat = [0, 0, 0]\nto = [1, 0, 0]\nradius = 1", "to is for a line"),
        (
            "[[site]]\nname = \"a\"\nat = [0, 0, 0]\n[[site]]\nname = \"a\"\nat = [1, 0, 0]",
            "unique among the sites",
        ),
        (
            "[[site]]\nname = \"a\"\nat = [0, 0, 0]\nradius = 1\nnormal = \"z\"\nholes = 3\nfirst = \"z\"",
            "not along the normal",
        ),
    ] {
        let error = plan(text).unwrap_err();
        assert!(error.contains(says), "{text}: {error}");
    }
    let error = folder
        .read("alone.toml", "parts = \"parts.csv\"\n[[site]]\nname = \"a\"\nat = [0, 0, 0]\n")
        .unwrap_err();
    assert!(error.contains("with [[limit]]"), "{error}");
}
