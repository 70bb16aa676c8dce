//! A recognized system, and its solution as a document.

use polhode::motion::Scenario;
use polhode_algebra::{Formula, RationalFunction, Relation, Symbol, Variable};
use polhode_document::number::{counted, error, tidy_beside};
use polhode_document::{Document, Section};

use super::Formalism;
use super::error::LagrangianError;
use super::in_symbols::in_symbols;
use super::system::{Coordinate, Hamiltonian, System, half_square, velocity};
use super::verify::{Course, Departure, Motion};
use super::write::{n, put};
use crate::symbolic::Symbolic;

/// Largest relative residual of an equation that holds.
const TOLERANCE: f64 = 1e-8;

/// Recognized system with what its document states.
pub(super) struct Case {
    /// Name with its article.
    pub name: &'static str,
    pub system: System,
    /// Section on the coordinates.
    pub coordinates: Section,
    /// Sentence before T and U.
    pub energies: &'static str,
    /// Section on equilibrium and small oscillations.
    pub oscillations: Section,
    /// Motion of the run; `None` without a run.
    pub motion: Option<Motion>,
    /// Further equations to verify, `left side = 0`, with their names.
    pub others: Vec<(String, RationalFunction)>,
    /// Further conserved quantity, with its name and the reason.
    pub conserved: Option<(&'static str, RationalFunction, &'static str)>,
}

/// Row of the verification.
struct Row {
    name: String,
    kind: &'static str,
    departure: Departure,
}

impl Case {
    /// Creates a case without further equations; its motion is set later if there is a run.
    pub(super) fn new(
        name: &'static str,
        system: System,
        energies: &'static str,
        [coordinates, oscillations]: [Section; 2],
    ) -> Self {
        Self {
            name,
            system,
            coordinates,
            energies,
            oscillations,
            motion: None,
            others: Vec::new(),
            conserved: None,
        }
    }

    /// Returns the document.
    pub(super) fn document(
        &self,
        scenario: &Scenario,
        formalism: Formalism,
        symbolic: Option<&Symbolic>,
    ) -> Result<Document, LagrangianError> {
        let singular = || LagrangianError::because("its velocities do not follow from the momenta");
        let hamiltonian = match formalism {
            Formalism::Lagrange => None,
            Formalism::Hamilton => Some(self.system.hamiltonian().ok_or_else(singular)?),
        };
        let (title, equations) = match &hamiltonian {
            None => ("Lagrange's equations", self.lagrange()),
            Some(h) => ("Hamilton's equations", self.hamilton(h)),
        };
        let motion = self.motion.as_ref().filter(|motion| !motion.instants.is_empty());
        let course = motion.map(|motion| Course::of(&self.system, motion).ok_or(LagrangianError::OutOfRange));
        let course = course.transpose()?;
        let rows = course.as_ref().map(|course| self.rows(course, hamiltonian.as_ref())).transpose()?;
        let mut energies = self.energies();
        if let Some(of) = symbolic {
            in_symbols(&self.system, of, &mut energies);
        }
        Ok(Document {
            title: scenario.title().unwrap_or("A rigid body").to_owned(),
            verdict: None,
            answer: self.answer(title, rows.as_deref()),
            sections: vec![
                self.coordinates.clone(),
                energies,
                equations,
                self.constants(hamiltonian.is_some()),
                self.oscillations.clone(),
                self.values(course.as_ref(), hamiltonian.as_ref()),
                self.verification(course.as_ref(), rows.as_deref()),
            ],
            findings: scenario.findings().to_vec(),
        })
    }

    fn answer(&self, title: &str, rows: Option<&[Row]>) -> Vec<String> {
        let degrees = counted(self.system.coordinates.len(), "degree");
        let mut lines = vec![format!("{title} of {}, with {degrees} of freedom.", self.name)];
        if let Some(rows) = rows {
            let largest = |kind: &str| {
                let rows = rows.iter().filter(|row| row.kind == kind);
                rows.map(|row| row.departure.relative).fold(0.0, f64::max)
            };
            lines.push(format!(
                "Along the computed motion the equations hold to {} (largest relative residual), and the conserved quantities are constant to {}.",
                error(largest(EQUATION)),
                error(largest(CONSTANT))
            ));
        }
        lines
    }

    /// Writes T, U and L.
    fn energies(&self) -> Section {
        let system = &self.system;
        let mut s = Section::new(2, "Kinetic and potential energy");
        s.say(self.energies);
        let energy = |name: &str, terms: &[RationalFunction]| Formula::named(name).equals(system.sum(terms));
        if let Some(body) = &system.body {
            let square = |k: usize| half_square(&body.moments[k], &body.omega[k].into());
            put(&mut s, &energy("T", &[0, 1, 2].map(square)));
        } else {
            put(&mut s, &energy("T", &system.kinetic));
        }
        put(&mut s, &energy("U", std::slice::from_ref(&system.potential)));
        let [t, u] = ["T", "U"].map(Formula::named);
        let difference = Formula::named("L").equals(Formula::Sum(vec![t, u.negative()]));
        put(&mut s, &self.with_terms(difference, -&system.potential));
        s
    }

    fn lagrange(&self) -> Section {
        let system = &self.system;
        let lagrangian = system.lagrangian();
        let mut s = Section::new(3, "Momenta and equations of motion");
        s.say(
            "Each coordinate q has the momentum p = ∂L/∂q\u{307}, which for an angle is an angular momentum:",
        );
        for c in &system.coordinates {
            let l = Formula::named("L");
            let left = system.letter(c.momentum).equals(l.derivative(self.dotted(c.symbol), true));
            put(&mut s, &left.equals(self.momentum(c)));
        }
        s.say("and Lagrange's equation (d/dt) ∂L/∂q\u{307} − ∂L/∂q = 0:");
        for c in &system.coordinates {
            let zero = Formula::integer(0);
            let formula = if system.is_cyclic(c) {
                let rate = Formula::named("L").derivative(self.dotted(c.symbol), true).time_derivative();
                let constant = system.letter(c.momentum).equals(Formula::text("constant"));
                rate.equals(zero).related(Relation::Implies, constant)
            } else if let Some(body) = &system.body {
                let rate = self.momentum(c).time_derivative();
                rate.equals(system.sum(&body.derivative(c.symbol)))
            } else {
                let equation = lagrangian.lagrange_equation(c.symbol, &system.symbols);
                system.collected(&equation, &system.rates()).equals(zero)
            };
            put(&mut s, &formula);
        }
        s
    }

    fn hamilton(&self, h: &Hamiltonian) -> Section {
        let system = &self.system;
        let mut s = Section::new(3, "Hamiltonian and canonical equations");
        s.say("The momenta p = ∂L/∂q\u{307} are linear in the velocities:");
        for c in &system.coordinates {
            put(&mut s, &system.letter(c.momentum).equals(self.momentum(c)));
        }
        s.say("Solved for the velocities, they give the Hamiltonian H = Σ p q\u{307} − L. It is T + U, because T is quadratic in the velocities and U does not contain them:");
        let left = Formula::named("H");
        let momenta: Vec<_> = system.coordinates.iter().map(|c| Variable::Symbol(c.momentum)).collect();
        if let Some(body) = &system.body {
            let square = |k: usize| {
                half_square(&RationalFunction::one(), &body.momenta[k].into()).over(&body.moments[k])
            };
            let terms: Vec<_> = (0..3).filter_map(square).collect();
            put(&mut s, &left.equals(system.sum(&terms)));
            for (letter, value) in body.momenta.iter().zip(system.body_momenta(h)) {
                let value = system.collected(&value, &momenta);
                put(&mut s, &system.letter(*letter).equals(value));
            }
        } else {
            put(&mut s, &left.equals(system.sum(&h.terms)));
        }
        s.say("The canonical equations are q\u{307} = ∂H/∂p and p\u{307} = −∂H/∂q:");
        for c in &system.coordinates {
            put(&mut s, &self.dotted(c.symbol).equals(system.sum(&system.slope(h, c.momentum))));
        }
        for c in &system.coordinates {
            let force: Vec<_> = system.slope(h, c.symbol).iter().map(|term| -term).collect();
            put(&mut s, &self.dotted(c.momentum).equals(system.sum(&force)));
        }
        s
    }

    /// Returns ∂L/∂q̇ as a sum over the velocities, or over the components of ω.
    fn momentum(&self, c: &Coordinate) -> Formula {
        let system = &self.system;
        match (&system.body, c.symbol.dot()) {
            (Some(body), Some(velocity)) => system.sum(&body.derivative(velocity)),
            _ => system.collected(&system.lagrangian().momentum(c.symbol), &system.rates()),
        }
    }

    fn constants(&self, is_hamiltonian: bool) -> Section {
        let system = &self.system;
        let mut s = Section::new(4, "Conserved quantities");
        for c in system.coordinates.iter().filter(|c| system.is_cyclic(c)) {
            let [letter, momentum] = [c.symbol, c.momentum].map(|symbol| system.letter(symbol).to_text());
            s.say(match is_hamiltonian {
                false => format!("{letter} is cyclic: L contains {letter}\u{307}, and not {letter} itself. So {momentum} is constant."),
                true => format!("{letter} is cyclic: H does not contain {letter}. So {momentum} is constant."),
            });
        }
        if let Some((.., why)) = &self.conserved {
            s.say(why);
        }
        s.say(match is_hamiltonian {
            false => "L does not depend on time explicitly, so the energy function h = Σ q\u{307} ∂L/∂q\u{307} − L is constant. It is the energy E = T + U:",
            true => "H does not depend on time explicitly, so dH/dt = ∂H/∂t = 0. H is the energy E = T + U:",
        });
        let sum = Formula::Sum(["T", "U"].map(Formula::named).to_vec());
        put(&mut s, &self.with_terms(Formula::named("E").equals(sum), system.potential.clone()));
        s
    }

    /// Returns `left = T + last` with the terms of T, unless these are in the components of ω.
    fn with_terms(&self, left: Formula, last: RationalFunction) -> Formula {
        if self.system.body.is_some() {
            return left;
        }
        let mut terms = self.system.kinetic.clone();
        terms.push(last);
        terms.retain(|term| !term.is_zero());
        left.equals(self.system.sum(&terms))
    }

    fn values(&self, course: Option<&Course>, h: Option<&Hamiltonian>) -> Section {
        let system = &self.system;
        let mut s = Section::new(6, "Values of this scenario");
        for c in &system.constants {
            let letter = system.letter(c.symbol).to_text();
            s.line(format!("{letter} = {} {}: {}", n(c.value), c.unit, c.meaning));
        }
        let Some(course) = course else { return s };
        s.say("At the first instant:");
        let value = |f: &RationalFunction| course.first(f).map_or_else(|| "—".to_owned(), n);
        for c in &system.coordinates {
            let scales = [c.size, course.rate() * c.size, course.momentum_scale(c.size)];
            let functions = [c.symbol.into(), velocity(c.symbol), c.momentum.into()];
            let [q, v, p] = std::array::from_fn(|k| {
                let tidy = |x: f64| n(tidy_beside([x, 0.0, 0.0], scales[k])[0]);
                course.first(&functions[k]).map_or_else(|| "—".to_owned(), tidy)
            });
            let [letter, rate, momentum] =
                [system.letter(c.symbol), self.dotted(c.symbol), system.letter(c.momentum)]
                    .map(|f| f.to_text());
            let unit = if c.unit == "m" { "kg·m/s" } else { "kg·m²/s" };
            s.line(format!("{letter} = {q} {0},  {rate} = {v} {0}/s,  {momentum} = {p} {unit}", c.unit));
        }
        s.line(format!(
            "T = {} J,  U = {} J,  E = T + U = {} J",
            value(&system.kinetic_energy()),
            value(&system.potential),
            value(&system.energy())
        ));
        if let Some(h) = h {
            s.line(format!("H = {} J", value(&h.function)));
        }
        s
    }

    /// Evaluates all equations and conserved quantities along the motion.
    fn rows(&self, course: &Course, h: Option<&Hamiltonian>) -> Result<Vec<Row>, LagrangianError> {
        let system = &self.system;
        let lagrangian = system.lagrangian();
        let mut rows = Vec::new();
        let mut add = |name: String, kind, departure: Option<Departure>| {
            let departure = departure.unwrap_or(Departure { relative: f64::NAN, time: 0.0 });
            rows.push(Row { name, kind, departure });
        };
        let text = |formula: Formula| formula.to_text();
        for c in &system.coordinates {
            let force = course.energy() / c.size;
            match h {
                None => {
                    let equation = lagrangian.lagrange_equation(c.symbol, &system.symbols);
                    let name = format!("Lagrange's equation for {}", text(system.letter(c.symbol)));
                    add(name, EQUATION, course.residual(&equation, force));
                }
                Some(h) => {
                    let [q, p] = [c.symbol, c.momentum];
                    let forward = velocity(q) - h.function.derivative(p);
                    let rate = lagrangian.momentum(q).time_derivative(&system.symbols);
                    let backward = rate + h.function.derivative(q);
                    let name = |left, sign, by| {
                        format!("{} = {sign}∂H/∂{}", text(self.dotted(left)), text(system.letter(by)))
                    };
                    add(name(q, "", p), EQUATION, course.residual(&forward, course.rate() * c.size));
                    add(name(p, "−", q), EQUATION, course.residual(&backward, force));
                }
            }
        }
        for (name, equation) in &self.others {
            let size = system.coordinates.first().map_or(1.0, |c| c.size);
            add(name.clone(), EQUATION, course.residual(equation, course.energy() / size));
        }
        for c in system.coordinates.iter().filter(|c| system.is_cyclic(c)) {
            let drift = course.drift(&lagrangian.momentum(c.symbol), course.momentum_scale(c.size));
            add(text(system.letter(c.momentum)), CONSTANT, drift);
        }
        if let Some((name, quantity, _)) = &self.conserved {
            add((*name).to_owned(), CONSTANT, course.drift(quantity, 0.0));
        }
        match h {
            None => add("E".to_owned(), CONSTANT, course.drift(&system.energy(), course.energy())),
            Some(h) => add("H".to_owned(), CONSTANT, course.drift(&h.function, course.energy())),
        }
        if rows.iter().any(|row| !row.departure.relative.is_finite()) {
            return Err(LagrangianError::OutOfRange);
        }
        match rows.iter().find(|row| row.kind == EQUATION && row.departure.relative > TOLERANCE) {
            None => Ok(rows),
            Some(row) => Err(LagrangianError::NotVerified {
                equation: row.name.clone(),
                residual: row.departure.relative,
                time: row.departure.time,
            }),
        }
    }

    fn verification(&self, course: Option<&Course>, rows: Option<&[Row]>) -> Section {
        let mut s = Section::new(7, "Verification along the computed motion");
        let (Some(course), Some(rows)) = (course, rows) else {
            s.say(match &self.motion {
                None => "The equations are not verified, because the scenario has no [run].",
                Some(_) => "The coordinates are singular at all samples of the run: θ = 0 or 180°, where φ and ψ are not defined. The equations are not verified.",
            });
            return s;
        };
        let left_out = self.motion.as_ref().map_or(0, |motion| motion.left_out);
        s.say(format!(
            "The motion is computed from Euler's equations or in closed form, without these equations. Its coordinates, velocities and accelerations are put into them at {}; the accelerations follow from the forces and torques. Residuals are relative to the largest term of the equation along the run, drifts to the \
             largest term of the quantity. If this is less than a thousandth of what the kinetic energy makes possible, they are relative to that.",
            counted(course.count(), "sample")
        ));
        if left_out > 0 {
            s.say(format!(
                "Left out: {} with sin θ < 0.01, where φ and ψ are nearly undefined.",
                counted(left_out, "sample")
            ));
        }
        let cells = |row: &Row| {
            vec![row.name.clone(), row.kind.to_owned(), error(row.departure.relative), n(row.departure.time)]
        };
        s.table(&["quantity", "kind", "largest", "at t, s"], rows.iter().map(cells).collect());
        s
    }

    fn dotted(&self, symbol: Symbol) -> Formula {
        symbol.dot().map_or_else(|| Formula::text("?"), |velocity| self.system.letter(velocity))
    }
}

/// Kinds of rows of the verification.
const EQUATION: &str = "relative residual";
const CONSTANT: &str = "relative drift";
