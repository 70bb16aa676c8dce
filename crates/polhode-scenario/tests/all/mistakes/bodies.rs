//! Errors in scenario files: unphysical bodies.

use polhode::body::BodyError;
use polhode_source::FormatErrorKind;

use super::{parse, refuses};

#[test]
fn impossible_bodies_are_refused_where_they_are_impossible() {
    let tensor = |text: &str| format!("[[body.part]]\nshape='tensor'\nmass=1\n{text}");
    let error = refuses(
        &tensor("moments=«['1 kg m^2', '1 kg m^2', '3 kg m^2']»"),
        "the inertia tensor is impossible: i1 + i2 = 2 kg·m² is less than i3 = 3 kg·m² (principal moments 1, 1, 3)",
        "check the sign convention",
    );
    assert!(matches!(error.kind(), FormatErrorKind::Body(BodyError::TriangleInequality { .. })));
    refuses(
        &tensor("inertia=[[2,«0.5»,0],[0.4,2,0],[0,0,2]]"),
        "the inertia tensor is not symmetric: I12 = 0.5, but I21 = 0.4",
        "give each product of inertia on both sides of the",
    );
    refuses(
        &tensor("products='positive_integral'\ninertia=[[2,0,0],[0,2,«0.5»],[0,0.4,2]]"),
        "the inertia tensor is not symmetric: I23 = 0.5, but I32 = 0.4",
        "give each",
    );
    refuses(
        &tensor("about=[2,0,0]\ninertia=«[[1,0,0],[0,1,0],[0,0,1]]»"),
        "the inertia tensor is impossible about the centre of mass: I = J - M (d² 1 - d dᵀ), with M = 1 kg and d = (-2, 0, 0) m from the point of \
         J, takes its principal moments 1, 1, 1 to -3, -3, 1 kg·m², and none may be negative",
        "check the centre of mass and the reference point of the tensor (perhaps it is already about the centre of mass),",
    );
    refuses(
        &tensor("moments=[1,1,1]\nproducts=«'negative_integral'»"),
        "moments and products are both given: with principal moments the products are zero",
        "leave",
    );
    refuses(
        "[[body.part]]\nshape='torus'\nring_radius=1\ntube_radius=«2»\nmass=1",
        "the torus's tube radius = 2 must be at most its ring radius",
        "ring_radius is the radius of the tube's centre",
    );
    for (shape, size) in [("cylinder", "\nlength=1"), ("sphere", "")] {
        let hollow = |inner: &str| {
            format!("[[body.part]]\nshape='{shape}'{size}\nradius='40 mm'\ninner_radius={inner}\nmass=1")
        };
        refuses(
            &hollow("«'5 cm'»"),
            &format!("the {shape}'s inner radius = 0.05 must be less than its radius"),
            "inner_radius is the radius of the cavity",
        );
        refuses(
            &hollow("«'40 mm'»"),
            &format!("the {shape}'s inner radius = 0.04 must be less than its radius"),
            "inner_radius is",
        );
        refuses(&hollow("«-0.01»"), "inner_radius = -0.01 must be zero or positive", "a radius has no sign");
        for value in ["nan", "inf"] {
            let error = parse(&hollow(value)).unwrap_err();
            assert!(error.message().contains("inner_radius"), "{error}");
        }
    }
    refuses(
        "[[body.part]]\nshape='cone_shell'\nradius=«0»\nheight=1\nmass=1",
        "the larger radius of the conical shell = 0 must be positive and finite",
        "a cone has at most one tip: make radius",
    );
    for (shape, name, length) in [
        ("triangular_plate", "the triangular plate", ""),
        ("triangular_prism", "the triangular prism", "length=2\n"),
    ] {
        let triangle =
            |corners: &str| format!("[[body.part]]\nshape='{shape}'\n{length}vertices={corners}\nmass=1");
        refuses(
            &triangle("«[[0,0],[1,0.5],[-2,-1]]»"),
            &format!("{name}'s area = 0 must be positive: its corners may not lie on one line"),
            "the three vertices are on one line: move one",
        );
        for few in ["[[0,0],[1,0.5]]", "[[0,0,0],[1,0.5,0],[0,1,0]]"] {
            let error = parse(&triangle(few)).unwrap_err();
            assert!(error.message().contains("vertices"), "{error}");
        }
    }
    refuses(
        "[[body.part]]\nshape='particles'\nparticles=[{mass=1,position=[0,0,1]},{mass=«-1»,position=[0,0,0]}]",
        "mass = -1 must be positive",
        "negative mass",
    );
    refuses(
        "[[body.part]]\nshape='particles'\nparticles=«[]»",
        "there are no particles",
        "give at least one",
    );
    refuses(
        "[[body.part]]\nshape='rod'\nlength=1\nmass=1\n[start]\nspin={momentum=«[0,1,1]»}",
        "momentum = [0,1,1] must be across the axis (0, 0, 1) of the body, about which it has no inertia",
        "give the spin instead",
    );
}

#[test]
fn a_density_fits_its_part() {
    let part = |text: &str| format!("[[body.part]]\n{text}");
    refuses(
        &part("shape='plate'\nsize=[1,2]\ndensity=«'2700 kg/m^3'»"),
        "\"kg/m^3\" is a density where a mass per area belongs",
        "a thin part has a density per area; with thickness = \"2",
    );
    refuses(
        &part("shape='disk'\nradius=1\nthickness='2 mm'\ndensity=«'5 kg/m^2'»"),
        "\"kg/m^2\" is a mass per area where a density belongs",
        "with a thickness the density is per volume;",
    );
    refuses(
        &part("shape='rod'\nlength=1\ndensity=«'5 g/cc'»"),
        "\"g/cc\" is a density where a mass per length belongs",
        "give density = \"0.3 kg/m\"",
    );
    refuses(
        &part("shape='rod'\nlength=1\ndensity=«'5 s'»"),
        "\"s\" is a time where a mass per length belongs",
        "write a mass per length",
    );
}

#[test]
fn bodies_beyond_the_range_of_a_double_are_refused() {
    let beyond = "must be positive and finite: too large or too small for f64";
    let text = |size: &str, mass: &str| format!("[[body.part]]\nshape='box'\nsize={size}\nmass={mass}");
    for (size, hint) in [("«[1,2,1e300]»", "it is larger"), ("«[1e-110,1e-110,1e-110]»", "it is smaller")]
    {
        let error = parse(&text(size, "1").replace(['«', '»'], "")).unwrap_err();
        assert!(error.message().ends_with(beyond), "{error}");
        assert_eq!(error.place().map(|place| place.line), Some(3), "{error}");
        assert!(error.hint().unwrap().starts_with(hint), "{error}");
    }
    refuses(
        &text("[1e80,1e80,1e80]", "«1e300»"),
        &format!("the moment of inertia = inf {beyond}"),
        "it is larger",
    );
    refuses(
        &text("[1e-80,1e-80,1e-80]", "«1e-300»"),
        &format!("the moment of inertia = 0 {beyond}"),
        "it is smaller",
    );
}

#[test]
fn a_point_has_no_momentum_of_its_own() {
    let point = "[[body.part]]\nshape='particles'\nparticles=[{mass=1,position=[0,0,1]}]\n[start]\n";
    refuses(
        &format!("{point}spin={{momentum=«[0,1,1]»}}"),
        "momentum = [0,1,1] must be zero: the body has no inertia about any axis",
        "give the spin instead",
    );
    assert!(parse(&format!("{point}spin={{momentum=[0,0,0]}}")).is_ok());
}
