//! Report of a budget as JSON.

use std::io;

use polhode::math::{Body, Position, Rotation};
use polhode_document::VERSION;
use polhode_document::finding;
use polhode_document::json::{matrix, pretty, pretty_at};
use serde_json::{Value, json};

use super::ballast::OfCase;
use super::case::{AXES, Case, Drawn, SpreadResult};
use super::changing::Changing;
use super::influence::{share, source_name};
use super::numbers::ten;
use super::whole::{asked, correlation};
use super::{BudgetReport, limits, parts, principal};
use crate::tensor::rows;
use crate::{Basis, ComparedNumber, Estimate, MassStatement, NUMBERS};

/// Largest number of errors of a result that are listed. The rest is given as a sum.
const ERRORS: usize = 25;

impl BudgetReport {
    /// Returns the report of all configurations as JSON, SI units.
    pub fn to_json(&self) -> Value {
        self.with_rows(&|case| (0..case.statements.len()).map(|k| row(case, k)).collect())
    }

    /// Writes [`BudgetReport::to_json`] as [`pretty`] prints it.
    ///
    /// Rows are written one by one, to save memory.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_json(&self, out: &mut dyn io::Write) -> io::Result<()> {
        // Placeholder for rows that are left out. No other value of this key is null, and quotes in
        // strings are escaped.
        const LEFT_OUT: &str = "\"rows\": null";
        let text = pretty(&self.with_rows(&|_| Value::Null));
        let mut pieces = text.split(LEFT_OUT);
        out.write_all(pieces.next().unwrap_or_default().as_bytes())?;
        for (case, behind) in self.cases.iter().zip(pieces) {
            out.write_all(b"\"rows\": [")?;
            for k in 0..case.statements.len() {
                let comma = if k > 0 { "," } else { "" };
                // Nesting: document, list of configurations, configuration, list of rows.
                let depth = 4;
                write!(out, "{comma}\n{}{}", "  ".repeat(depth), pretty_at(&row(case, k), depth))?;
            }
            write!(out, "\n{}]{behind}", "  ".repeat(3))?;
        }
        Ok(())
    }

    fn with_rows(&self, rows: &dyn Fn(&Case) -> Value) -> Value {
        json!({
            "polhode": VERSION,
            "kind": "budget",
            "title": self.title,
            "sources": self.sources,
            "basis": self.options.basis.name(),
            "configurations": self.cases.iter().map(|case| self.case_to_json(case, &rows(case))).collect::<Value>(),
            "findings": finding::to_json(&self.findings()),
        })
    }

    fn case_to_json(&self, case: &Case, rows: &Value) -> Value {
        let basis = self.options.basis;
        let estimate = case.estimate(basis);
        json!({
            "name": case.name,
            "mass": statement(&case.whole_statement()),
            "limits": limits::to_json(case, &self.limits),
            "ballast": self.ballast.as_ref().and_then(|all| Some(OfCase::new(case, &self.limits)?.to_json(all))),
            "changing": case.changing.as_ref().map(Changing::to_json),
            "estimate": estimate_to_json(estimate),
            "basic": estimate_to_json(case.estimate(Basis::Basic)),
            "predicted": estimate_to_json(case.estimate(Basis::Predicted)),
            "asked": self.asked_to_json(estimate),
            "principal": principal_to_json(case, basis),
            "errors": case.results.iter().map(|result| errors(case, result)).collect::<Value>(),
            "draws": case.drawn.as_ref().map(|drawn| self.drawn_to_json(drawn)),
            "picture": parts::solids(case, basis).to_json(),
            "rows": rows,
        })
    }

    fn asked_to_json(&self, estimate: &Estimate<Body>) -> Value {
        asked(estimate, &self.options).map_or(Value::Null, |asked| {
            let [_, x, y, z, inertia @ ..] = asked.numbers;
            json!({
                "about": self.options.about.map(Position::to_array),
                "axes": self.options.axes.map(Rotation::matrix),
                "center_of_mass": [x, y, z],
                "inertia": matrix(rows(inertia)),
                "covariance": asked.covariance,
            })
        })
    }

    fn drawn_to_json(&self, drawn: &Drawn) -> Value {
        let comparison = &drawn.comparison;
        let number = |n: &ComparedNumber| {
            json!({
                "name": n.name,
                "unit": n.unit,
                "value": n.value,
                "first_order_sd": n.first_order_sd,
                "mean": n.mean,
                "mean_error": n.mean_error,
                "sd": n.sd,
                "sd_error": n.sd_error,
                "differs": n.differs(),
            })
        };
        json!({
            "count": comparison.draws,
            "seed": self.options.seed,
            "moved": comparison.moved,
            "numbers": comparison.numbers.iter().map(number).collect::<Value>(),
            "covariance": comparison.covariance,
            "tilt_quantiles": drawn.tilts,
        })
    }
}

fn statement(s: &MassStatement) -> Value {
    json!({
        "basic": s.basic,
        "predicted": s.predicted,
        "growth_allowance": s.growth_allowance(),
        "allowable": s.allowable,
        "margin": s.margin(),
        "relative_margin": s.relative_margin(),
    })
}

fn estimate_to_json(estimate: &Estimate<Body>) -> Value {
    let values = ten(&estimate.properties);
    let number = |k: usize| {
        let (name, unit) = NUMBERS[k];
        json!({ "name": name, "unit": unit, "value": values[k], "sd": estimate.sd(k) })
    };
    let correlations = |i: usize| -> Value {
        (0..10).map(|j| correlation(&estimate.covariance, i, j).map_or(Value::Null, Value::from)).collect()
    };
    json!({
        "mass": estimate.properties.mass(),
        "center_of_mass": estimate.properties.center_of_mass().to_array(),
        "inertia": matrix(estimate.properties.inertia().matrix()),
        "numbers": (0..10).map(number).collect::<Value>(),
        "covariance": estimate.covariance,
        "correlation": (0..10).map(correlations).collect::<Value>(),
    })
}

fn principal_to_json(case: &Case, basis: Basis) -> Value {
    let found = case.principal(basis);
    let ratios = principal::Ratios::of(&found);
    let tilt = |k: usize| {
        let axis = &case.tilts[k];
        json!({
            "from": AXES[axis.from],
            "direction": axis.direction.to_array(),
            "angle": axis.tilt.angle,
            "sd": axis.tilt.sd,
            "axis_sd": axis.tilt.axis_sd,
        })
    };
    let moment_sd = [0, 1, 2].map(|k| principal::moment_sd(&found, k));
    let axes = [0, 1, 2].map(|k| found.frame.axis(k).to_array());
    let tilts = [0, 1, 2].map(tilt);
    json!({
        "moments": found.frame.moments(),
        "moment_sd": moment_sd,
        "moment_covariance": found.moment_covariance,
        "ratios": ratios.values,
        "ratio_sd": ratios.sd,
        "ratio_correlation": ratios.correlation,
        "axes": axes,
        "turn_sd": found.turn_sd,
        "tilts": tilts,
        "triangle": principal::triangle(case, &found).to_json(),
    })
}

fn errors(case: &Case, result: &SpreadResult) -> Value {
    let one = |by: &crate::Sensitivity| {
        json!({
            "source": source_name(case, by),
            "of": by.kind.name(),
            "variance": by.variance,
            "share": share(result, by),
        })
    };
    let rest = result.by.iter().skip(ERRORS).map(|by| by.variance).sum::<f64>() + result.rest;
    json!({
        "number": result.name,
        "unit": result.unit,
        "sd": result.sd,
        "by": result.by.iter().take(ERRORS).map(one).collect::<Value>(),
        "rest": rest,
    })
}

fn row(case: &Case, k: usize) -> Value {
    let rows = case.budget.rows();
    let mut value = statement(&case.statements[k]);
    if let Some(map) = value.as_object_mut() {
        map.shift_insert(0, "name".to_owned(), Value::from(rows.name(k)));
        let parent = case.budget.parent(k).map_or(Value::Null, |parent| Value::from(rows.name(parent)));
        map.shift_insert(1, "in".to_owned(), parent);
        map.shift_insert(2, "quantity".to_owned(), Value::from(rows.quantity(k).count));
    }
    value
}
