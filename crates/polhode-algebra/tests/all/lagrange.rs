//! Total time derivatives, and Lagrange's equations of the lecture notes.

use polhode_algebra::RationalFunction;

use crate::common::{symbols, value};

#[test]
fn chain_rule_over_the_coordinates() {
    let symbols = symbols();
    for (text, expected) in [
        ("theta", "theta_dot"),
        ("M*b^2", "0"),
        ("x*theta_dot", "x*theta_ddot"),
        ("sin(theta)", "theta_dot*cos(theta)"),
        ("theta_dot^2*cos(theta)", "2*theta_dot*theta_ddot*cos(theta) - theta_dot^3*sin(theta)"),
        ("phi/theta", "phi_dot/theta - phi*theta_dot/theta^2"),
        ("sin(theta - phi)", "(theta_dot - phi_dot)*cos(theta - phi)"),
    ] {
        assert_eq!(value(text).time_derivative(&symbols), value(expected), "{text}");
    }
    let (f, g) = (value("theta*sin(phi)"), value("phi_dot/(1 + theta)"));
    let product = (&f * &g).time_derivative(&symbols);
    assert_eq!(product, f.time_derivative(&symbols) * &g + &f * g.time_derivative(&symbols));
}

/// Example 11.4 of the notes, with the sign that they lose.
#[test]
fn pendulum_of_the_notes() {
    let symbols = symbols();
    let theta = symbols.find("theta").unwrap();
    let lagrangian = value("(m_1 + m_2/4)*b^2*theta_dot^2/2 + m_1*g*b*cos(theta) + m_2*g*b/2*cos(theta)");
    let equation = lagrangian.lagrange_equation(theta, &symbols);
    assert_eq!(equation, value("(m_1 + m_2/4)*b^2*theta_ddot + (m_1 + m_2/2)*g*b*sin(theta)"));
    assert_eq!(lagrangian.momentum(theta), value("(m_1 + m_2/4)*b^2*theta_dot"));
    // dh/dt = θ̇ times the left side of Lagrange's equation.
    let energy = lagrangian.energy_function(&[theta]);
    assert_eq!(energy.time_derivative(&symbols), equation * value("theta_dot"));
}

#[test]
fn heavy_top() {
    let symbols = symbols();
    let coordinates = ["theta", "phi", "psi"].map(|name| symbols.find(name).unwrap());
    let lagrangian = value(
        "I_1/2*(theta_dot^2 + phi_dot^2*sin(theta)^2) + I_3/2*(psi_dot + phi_dot*cos(theta))^2 - M*g*h*cos(theta)",
    );
    let spin = value("I_3*(psi_dot + phi_dot*cos(theta))");
    assert_eq!(lagrangian.momentum(coordinates[2]), spin);
    let vertical = value("I_1*phi_dot*sin(theta)^2") + &spin * value("cos(theta)");
    assert_eq!(lagrangian.momentum(coordinates[1]), vertical);
    // φ and ψ are cyclic: their equations say that the momenta are constant.
    for q in &coordinates[1..] {
        assert!(lagrangian.derivative(*q).is_zero());
    }
    let sum = coordinates.iter().fold(RationalFunction::zero(), |sum, &q| {
        sum + lagrangian.lagrange_equation(q, &symbols) * RationalFunction::from(q.dot().unwrap())
    });
    assert_eq!(lagrangian.energy_function(&coordinates).time_derivative(&symbols), sum);
}

/// N = dL/dt in body axes gives Euler's equations.
#[test]
fn euler_equations() {
    use polhode_algebra::Vector;
    let symbols = symbols();
    let omega = Vector(["omega_1", "omega_2", "omega_3"].map(value));
    let momentum = Vector(["I_1*omega_1", "I_2*omega_2", "I_3*omega_3"].map(value));
    let torque = momentum.map(|component| component.time_derivative(&symbols)) + omega.cross(&momentum);
    assert_eq!(torque.0[0], value("I_1*omega_1_dot - (I_2 - I_3)*omega_2*omega_3"));
    assert_eq!(torque.0[1], value("I_2*omega_2_dot - (I_3 - I_1)*omega_3*omega_1"));
    assert_eq!(torque.0[2], value("I_3*omega_3_dot - (I_1 - I_2)*omega_1*omega_2"));
}
