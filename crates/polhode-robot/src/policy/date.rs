//! Calendar dates.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Date in the Gregorian calendar, ordered. It serializes as text: 2027-01-31.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Date {
    year: i64,
    month: u8,
    day: u8,
}

impl Date {
    /// Returns a date from its parts; 2027-01-31 is `new(2027, 1, 31)`. The parts are not checked.
    pub const fn new(year: u16, month: u8, day: u8) -> Self {
        Self { year: year as i64, month, day }
    }

    /// Returns the date a number of days after 1970-01-01.
    ///
    /// The computation starts each year in March, so that the leap day is the last day of the year.
    /// A cycle of 400 years has 146,097 days.
    pub fn of_days(days: u64) -> Self {
        const OF_400_YEARS: u64 = 146_097;
        let days = days + 719_468; // from 0000-03-01
        let (era, of_era) = (days / OF_400_YEARS, days % OF_400_YEARS);
        let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
        let of_year = of_era - (365 * year + year / 4 - year / 100);
        let from_march = (5 * of_year + 2) / 153;
        let day = of_year - (153 * from_march + 2) / 5 + 1;
        let month = if from_march < 10 { from_march + 3 } else { from_march - 9 };
        let year = year + 400 * era + u64::from(month <= 2);
        let small = |number: u64| u8::try_from(number).unwrap_or(u8::MAX);
        Self { year: i64::try_from(year).unwrap_or(i64::MAX), month: small(month), day: small(day) }
    }
}

impl fmt::Display for Date {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04}-{:02}-{:02}", self.year, self.month, self.day)
    }
}

impl From<Date> for String {
    fn from(date: Date) -> Self {
        date.to_string()
    }
}

impl TryFrom<String> for Date {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        match text.parse() {
            Ok(toml::value::Datetime { date: Some(day), time: None, .. }) => {
                Ok(Self::new(day.year, day.month, day.day))
            }
            _ => Err("expected a date, such as 2027-01-31"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_those_of_the_calendar() {
        for (days, written) in [
            (0, "1970-01-01"),
            (58, "1970-02-28"),
            (59, "1970-03-01"),
            (11_016, "2000-02-29"),
            (11_017, "2000-03-01"),
            (20_782, "2026-11-25"),
            (47_540, "2100-02-28"),
            (47_541, "2100-03-01"),
        ] {
            assert_eq!(Date::of_days(days).to_string(), written);
        }
        assert_eq!(Date::try_from("2027-01-31".to_owned()), Ok(Date::new(2027, 1, 31)));
        assert!(Date::try_from("2027-01-31T12:00:00".to_owned()).is_err());
        assert!(Date::new(2026, 12, 31) < Date::new(2027, 1, 1));
    }
}
