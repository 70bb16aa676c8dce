//! Figures for the questions of a sweep: answers against inputs, and convergence of the share.

use polhode_document::Picture;
use polhode_document::figure::axes::{Area, Axes, Axis};
use polhode_document::figure::legend::{Key, heading};
use polhode_document::figure::sheet::{Colour, Mark, Pen, Point, Sheet};
use polhode_document::layout::printable;
use polhode_document::number::number;

use super::{Panels, Shown, SweepFigures, axis_of};
use crate::report::SweepQuestion;

/// Maximum number of questions shown.
const MOST: usize = 8;
/// Name and colour of members that do not fulfil the condition, and of those that do.
const ANSWERS: [(bool, &str, Colour); 2] = [(false, "no", Colour::AXES[0]), (true, "yes", Colour::AXES[1])];

impl<'a> SweepFigures<'a> {
    /// Draws two panels for each question; `None` without questions.
    ///
    /// The first panel shows the condition's outcome against the most decisive input. The second
    /// shows the share that fulfils the condition against the number of members.
    pub fn questions(&self) -> Option<Picture> {
        (!self.summary.questions.is_empty()).then(|| self.together(&self.of_questions()))
    }

    /// Returns two pictures for each question.
    pub(crate) fn each_question(&self) -> Vec<Picture> {
        self.of_questions().each()
    }

    fn of_questions(&self) -> Panels<'a> {
        let questions: Vec<_> = self.summary.questions.iter().take(MOST).collect();
        let note = format!("dots: {} sampled members; band: 95 % confidence interval", self.sample.rows());
        let figures = *self;
        Panels::new("Questions", note, [2 * questions.len(), 2], move |sheet, area, k| {
            let Some(question) = questions.get(k / 2) else { return };
            if k.is_multiple_of(2) {
                figures.deciding(sheet, area, k / 2, question);
            } else {
                settling(sheet, area, question);
            }
        })
    }

    /// Draws the outcome against the input, each member in the colour of its answer.
    fn deciding(&self, sheet: &mut Sheet, area: Area, k: usize, question: &SweepQuestion) {
        let Some(answers) = self.sample.answers.get(k) else { return };
        let keys = ANSWERS.map(|(_, name, colour)| Key::dot(Pen::solid(colour, 5.0), name));
        let used = heading(sheet, area, &printable(&question.condition), "", &keys);
        let area = area.below(used);
        let (Some((input, x)), Some((outcome, y))) = (self.input(answers), self.outcome(&question.condition))
        else {
            sheet.text(
                [area.left, area.top + 20.0],
                polhode_document::figure::sheet::Anchor::Start,
                Colour::FAINT,
                "no outcome in the condition varies",
            );
            return;
        };
        let axes = Axes::within(
            area,
            axis_of(&x.statistic, area.width(), 70.0),
            axis_of(&y.statistic, area.height(), 34.0),
            None,
        );
        axes.draw(sheet);
        for (answer, _, colour) in ANSWERS {
            let places = self.places(&axes, [&input, &outcome], [x.factor, y.factor]).zip(answers);
            let dots: Vec<Point> =
                places.filter(|(_, given)| **given == Some(answer)).filter_map(|(place, _)| place).collect();
            sheet.dots(dots, Pen::solid(colour, 2.4).faint(0.55));
        }
    }

    /// Returns the most decisive input. It has the largest difference between both answers, either
    /// of the means or of the mean distances from the overall mean, in standard deviations.
    fn input(&self, answers: &[Option<bool>]) -> Option<(String, Shown)> {
        let difference = |name: &String| -> Option<f64> {
            let k = self.sample.names.iter().position(|other| other == name)?;
            let column = self.sample.columns.get(k)?;
            let mean = |answer: bool, of: &dyn Fn(f64) -> f64| {
                let members = column.iter().zip(answers).filter(|(_, given)| **given == Some(answer));
                let values: Vec<f64> = members.filter_map(|(x, _)| x.map(of)).collect();
                (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
            };
            let statistic = self.summary.inputs.iter().find(|statistic| statistic.name == *name)?;
            let (middle, spread) = (statistic.mean?, statistic.standard_deviation?);
            let differ = |of: &dyn Fn(f64) -> f64| {
                mean(true, of).zip(mean(false, of)).map_or(0.0, |(a, b)| (a - b).abs() / spread)
            };
            (spread > 0.0).then(|| differ(&|x| x).max(differ(&|x| (x - middle).abs())))
        };
        let inputs = self.sample.inputs.iter().filter_map(|name| Some((name, difference(name)?)));
        let (name, _) = inputs.max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some((name.clone(), self.shown(name)?))
    }

    /// Returns the first outcome in a condition that varies.
    fn outcome(&self, condition: &str) -> Option<(String, Shown)> {
        let words = condition.split(|c: char| !c.is_alphanumeric() && c != '_');
        let is_outcome = |word: &&str| !self.sample.inputs.iter().any(|input| input == word);
        let shown = |word: &str| self.shown(word).filter(|shown| shown.statistic.varies());
        words.filter(is_outcome).find_map(|word| Some((word.to_owned(), shown(word)?)))
    }
}

/// Draws the share among the first members, in %, with its confidence interval.
fn settling(sheet: &mut Sheet, area: Area, question: &SweepQuestion) {
    let percent = |x: f64| 100.0 * x;
    let share = question.share.map_or_else(String::new, |share| match question.interval {
        Some([low, high]) => {
            let [low, share, high] = [low, share, high].map(|x| number(percent(x), 4));
            format!("{share} % ({low} … {high} %)")
        }
        None => format!("{} %", number(percent(share), 4)),
    });
    let area = area.below(heading(sheet, area, &printable(&question.name), &share, &[]));
    let steps = &question.convergence;
    let (Some(first), Some(last)) = (steps.first(), steps.last()) else { return };
    // The first stretches contain few members, so the axis need not cover the first eighth. It
    // always covers the final interval.
    let settled = steps.iter().skip(steps.len() / 8);
    let ends = settled.flat_map(|step| step.interval.unwrap_or([step.share; 2]));
    let ends = ends.chain(question.interval.into_iter().flatten());
    let [low, high] = ends.fold([f64::INFINITY, 0.0], |[low, high], x| [low.min(x), f64::max(high, x)]);
    let pad = (0.08 * (high - low)).max(0.002);
    let [low, high] = [percent((low - pad).max(0.0)), percent((high + pad).min(1.0))];
    let x = Axis::linear(
        [first.members as f64, last.members as f64],
        0.0,
        (area.width() / 70.0).clamp(2.0, 6.0),
        "members",
        "",
    );
    let y = Axis::linear([low, high], 0.0, (area.height() / 34.0).clamp(2.0, 6.0), "share", "%");
    let axes = Axes::within(area, x, y, None);
    axes.draw(sheet);
    let inside = |[x, y]: Point| [x, y.clamp(axes.area.top, axes.area.bottom)];
    let at = |members: u64, share: f64| inside(axes.at([members as f64, percent(share)]));
    let bounds: Vec<(u64, [f64; 2])> =
        steps.iter().filter_map(|step| Some((step.members, step.interval?))).collect();
    if bounds.len() > 1 {
        let above = bounds.iter().map(|(n, [_, high])| at(*n, *high));
        let below = bounds.iter().rev().map(|(n, [low, _])| at(*n, *low));
        sheet.marks.push(Mark::Polygon {
            corners: above.chain(below).collect(),
            fill: Colour(0xd6_e8_f2),
            opacity: 1.0,
        });
    } else if let Some([low, high]) = question.interval {
        // Confidence intervals from independent sets hold for all members only.
        let dashed = Pen::solid(Colour::AXES[0], 1.0).dashed(&[3.0, 2.5]);
        for end in [low, high] {
            sheet.line(vec![at(first.members, end), at(last.members, end)], dashed);
        }
    }
    let line = steps.iter().map(|step| at(step.members, step.share)).collect();
    sheet.line(line, Pen::solid(Colour::BLACK, 1.4));
}
