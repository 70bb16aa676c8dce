//! Sign of products of inertia: stated, proved, or requested.

use polhode_budget::ProductSign;

use super::{budget, csv};

/// About the origin, 1 kg at (0.3, 0.2, 0.1) m with a small box around it. Only ∫xy dm = +0.06 and
/// so on make a possible body.
const FAR: &str = "name,mass [kg],x [m],y [m],z [m],Ixx [kg m^2],Iyy [kg m^2],Izz [kg m^2],Ixy [kg m^2],Ixz [kg m^2],Iyz [kg m^2],about\n\
                   box,1.000,0.3000,0.2000,0.1000,0.0520,0.1021,0.1322,PRODUCTS,origin\n";

#[test]
fn a_sign_is_proved_where_the_other_makes_no_body() {
    let sign = |products: &str| {
        let file = csv(&FAR.replace("PRODUCTS", products)).unwrap();
        let lines = file.sources().join("\n");
        let row = &file.configurations[0].budget.list().rows[0];
        (row.part.as_ref().unwrap().tensor.sign, lines)
    };
    let (elements, lines) = sign("-0.06,-0.03,-0.02");
    assert_eq!(elements, ProductSign::NegativeIntegral);
    assert!(
        lines.contains("1 tensor with products taken as tensor elements, −∫xy dm: the other sign"),
        "{lines}"
    );
    let (integrals, lines) = sign("0.06,0.03,0.02");
    assert_eq!(integrals, ProductSign::PositiveIntegral);
    assert!(lines.contains("1 tensor with products taken as positive integrals, +∫xy dm"), "{lines}");
}

#[test]
fn a_sign_that_nothing_proves_is_asked_for() {
    let central = "name,mass,Ixx,Iyy,Izz,Ixy,Ixz,Iyz\nbox,1,0.01,0.012,0.015,0.001,-0.002,0.0005\n";
    let error = csv(central).unwrap_err();
    assert!(
        error.to_string().starts_with("list.csv:2:24: are the products of inertia elements of the tensor"),
        "{error}"
    );
    assert!(error.hint().unwrap().contains("products = \"positive integrals\""));
    for (told, sign) in [
        ("tensor elements", ProductSign::NegativeIntegral),
        ("positive integrals", ProductSign::PositiveIntegral),
    ] {
        let told = budget(&format!("# products = \"{told}\"\n{central}"));
        assert_eq!(told.list().rows[0].part.as_ref().unwrap().tensor.sign, sign);
    }
    // The statement of a row overrides that of the file.
    let row = "# products = \"tensor elements\"\nname,mass,Ixx,Iyy,Izz,Ixy,Ixz,Iyz,products\nbox,1,0.01,0.012,0.015,0.001,-0.002,0.0005,positive integrals\n";
    assert_eq!(budget(row).list().rows[0].part.as_ref().unwrap().tensor.sign, ProductSign::PositiveIntegral);
    // About the frame of another row, nothing is proved here.
    let framed = FAR
        .replace("PRODUCTS,origin", "-0.06,-0.03,-0.02,datum")
        .replace("about\n", "about\ndatum,,,,,,,,,,,\n");
    assert!(csv(&framed).unwrap_err().to_string().contains("products of inertia"));
    // Without products, the sign does not matter.
    assert_eq!(
        budget("name,mass,Ixx,Iyy,Izz,Ixy,Ixz,Iyz\nbox,1,0.01,0.012,0.015,0,0,0\n").list().rows.len(),
        1
    );
}

#[test]
fn rounding_proves_nothing() {
    // A thin plate: its exact tensor is at the limit of possible tensors, and rounding may put it
    // beyond.
    let plate = |digits: usize, sign: f64| {
        // Rotated by 0.4 about x, 0.5 about y and 0.6 about z, so that no product is 0.
        let (a, b) = (0.010_f64, 0.023_f64);
        let rotation =
            polhode::math::Rotation::<polhode::math::Body, polhode::math::Part>::from_roll_pitch_yaw([
                0.4, 0.5, 0.6,
            ])
            .unwrap();
        let m = rotation.matrix();
        let moments = [a, b, a + b];
        let element = |i: usize, j: usize| (0..3).map(|k| m[i][k] * moments[k] * m[j][k]).sum::<f64>();
        let products = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| format!("{:.digits$}", sign * element(i, j)));
        let moments = [0, 1, 2].map(|k| format!("{:.digits$}", element(k, k)));
        format!("name,mass,Ixx,Iyy,Izz,Ixy,Ixz,Iyz\nplate,1,{},{}\n", moments.join(","), products.join(","))
    };
    let mut refused = 0;
    for digits in 3..9 {
        for sign in [1.0, -1.0] {
            match csv(&plate(digits, sign)) {
                // With enough digits, the sign may be proved. It is then right.
                Ok(file) => {
                    let part = file.configurations[0].budget.rows().part(0).unwrap();
                    let tensor = &part.tensor;
                    let expected = if sign > 0.0 {
                        ProductSign::NegativeIntegral
                    } else {
                        ProductSign::PositiveIntegral
                    };
                    assert_eq!(tensor.sign, expected, "{digits} digits");
                }
                Err(_) => refused += 1,
            }
        }
    }
    assert!(refused > 0);
}
