//! `[[site]]` and `[ballast]`: sites and amount of ballast.

use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::limit::{direction, point};
use crate::{Ballast, BallastPlace, Round, Site};

const KEYS: [&str; 10] = ["name", "at", "to", "radius", "normal", "rim", "holes", "first", "most", "sizes"];

/// Reads all sites, and the options of the ballast.
pub(crate) fn ballast(sites: &Value<'_>, asked: Option<&Value<'_>>) -> Result<Ballast, FormatError> {
    let mut ballast = Ballast::default();
    for table in sites.tables("site")? {
        let all = of_table(&table)?;
        if let Some(site) = all.iter().find(|site| ballast.sites.iter().any(|other| other.name == site.name))
        {
            let rule = format!("unique among the sites: \"{}\" exists already", site.name);
            return Err(table.require("name", "")?.invalid(rule));
        }
        ballast.sites.extend(all);
    }
    if let Some(asked) = asked {
        let table = asked.table()?;
        table.allow(&["most", "deviations"])?;
        ballast.most = table.get("most").map(|value| value.positive(Dimension::MASS)).transpose()?;
        if let Some(value) = table.get("deviations") {
            ballast.deviations = value.number()?;
            if !(ballast.deviations >= 0.0) {
                return Err(value.invalid("zero or positive").with_hint("standard deviations to each limit"));
            }
        }
    }
    Ok(ballast)
}

fn of_table(table: &Table<'_>) -> Result<Vec<Site>, FormatError> {
    table.allow(&KEYS)?;
    let name = table.require("name", "name = \"end plate\"")?.string()?.to_owned();
    let at = point(&table.require("at", "at = [\"40 mm\", 0, 0]")?)?;
    table.at_most_one(&["to", "radius"], "to is for a line, radius for a disc")?;
    let most = table.get("most").map(|value| value.positive(Dimension::MASS)).transpose()?;
    let round = || -> Result<Option<Round>, FormatError> {
        let Some(radius) = table.get("radius") else { return Ok(None) };
        let radius = radius.positive(Dimension::LENGTH)?;
        let normal = direction(&table.require("normal", "normal = \"z\"")?)?;
        Ok(Some(Round { center: at, normal, radius }))
    };
    let is_rim = table.get("rim").map_or(Ok(false), |value| value.boolean())?;
    let mut sites = match (round()?, table.get("holes")) {
        (Some(round), Some(holes)) => {
            /// Largest number of holes. More would be a circle.
            const MOST: u64 = 360;
            let count = holes.count()?;
            if !(1..=MOST).contains(&count) {
                return Err(holes
                    .invalid(format!("from 1 to {MOST}"))
                    .with_hint("rim = true is the whole circle"));
            }
            let first = table.require("first", "first = \"x\"")?;
            let sites = Site::bolt_circle(&name, round, direction(&first)?, count as u32);
            if sites.is_empty() {
                return Err(first.invalid("a direction that is not along the normal"));
            }
            sites
        }
        (Some(round), None) if is_rim => vec![Site::new(name, BallastPlace::Circle(round))],
        (Some(round), None) => vec![Site::new(name, BallastPlace::Disc(round))],
        (None, _) => {
            for key in ["normal", "rim", "holes", "first"] {
                if let Some(value) = table.get(key) {
                    return Err(value.invalid("left out of a site without a radius"));
                }
            }
            vec![Site::new(
                name,
                match table.get("to") {
                    Some(to) => BallastPlace::Line([at, point(&to)?]),
                    None => BallastPlace::Point(at),
                },
            )]
        }
    };
    if table.get("holes").is_none()
        && let Some(value) = table.get("first")
    {
        return Err(value
            .invalid("left out without holes")
            .with_hint("it is the direction of the first hole"));
    }
    let mut sizes = Vec::new();
    if let Some(value) = table.get("sizes") {
        for size in value.elements("a list of masses")? {
            sizes.push(size.positive(Dimension::MASS)?);
        }
    }
    for site in &mut sites {
        (site.most, site.sizes) = (most, sizes.clone());
    }
    Ok(sites)
}
