//! How long a server wants to be left alone: `Retry-After` as seconds or as a date, `retry-after-ms`.

use std::time::Duration;

/// Longer than this is as good as this.
const LONGEST: f64 = 1e9;

/// What the headers ask for; `header` finds one by its lower-case name.
pub(super) fn asked<'h>(header: impl Fn(&str) -> Option<&'h str>) -> Option<Duration> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite() && *x >= 0.0);
    let seconds = |x: f64| Duration::from_secs_f64(x.min(LONGEST));
    if let Some(ms) = header("retry-after-ms").and_then(number) {
        return Some(seconds(ms / 1000.0));
    }
    let text = header("retry-after")?;
    if let Some(s) = number(text) {
        return Some(seconds(s));
    }
    // A date counts from the server's own clock, so ours may be wrong.
    let (then, now) = (date(text)?, date(header("date")?)?);
    Some(seconds((then - now).max(0) as f64))
}

/// Seconds since 1970 of a date such as `Sun, 06 Nov 1994 08:49:37 GMT`.
fn date(text: &str) -> Option<i64> {
    let words: Vec<&str> = text.split_ascii_whitespace().collect();
    let [_, day, month, year, time, "GMT"] = words[..] else { return None };
    const MONTHS: &str = "JanFebMarAprMayJunJulAugSepOctNovDec";
    let month = MONTHS.find(month).filter(|at| month.len() == 3 && at % 3 == 0)? as i64 / 3 + 1;
    let small = |text: &str, most: i64| text.parse::<i64>().ok().filter(|n| (0..=most).contains(n));
    let (day, year) = (small(day, 31)?, small(year, 9999)?);
    let mut clock = time.split(':');
    let mut part = |most| clock.next().and_then(|t| small(t, most));
    let (h, m, s) = (part(23)?, part(59)?, part(60)?);
    // Days before the date, with years that begin in March.
    let (y, m_from_march) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    let days = 365 * y + y.div_euclid(4) - y.div_euclid(100) + y.div_euclid(400) + (153 * m_from_march + 2) / 5 + day;
    Some((days - 719_469) * 86_400 + h * 3600 + m * 60 + s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_read() {
        for (text, wanted) in [
            ("Thu, 01 Jan 1970 00:00:00 GMT", Some(0)),
            ("Sun, 06 Nov 1994 08:49:37 GMT", Some(784_111_777)),
            ("Thu, 29 Feb 2024 12:00:00 GMT", Some(1_709_208_000)),
            ("Fri, 01 Mar 2024 00:00:00 GMT", Some(1_709_251_200)),
            ("Sun, 06 Nuv 1994 08:49:37 GMT", None),
            ("Sun, 06 anF 1994 08:49:37 GMT", None),
            ("Sun, 06 Nov 99999999999999999999 08:49:37 GMT", None),
            ("Sun, 06 Nov 1994 08:49:37", None),
            ("", None),
        ] {
            assert_eq!(date(text), wanted, "{text}");
        }
    }

    #[test]
    fn waits_are_read() {
        let now = ("date", "Sun, 06 Nov 1994 08:49:37 GMT");
        for (headers, wanted) in [
            (vec![("retry-after", "7")], Some(7.0)),
            (vec![("retry-after", "0.5")], Some(0.5)),
            (vec![("retry-after", "7"), ("retry-after-ms", "250")], Some(0.25)),
            (vec![("retry-after", "Sun, 06 Nov 1994 08:50:37 GMT"), now], Some(60.0)),
            (vec![("retry-after", "Sun, 06 Nov 1994 08:00:00 GMT"), now], Some(0.0)),
            (vec![("retry-after", "Sun, 06 Nov 1994 08:50:37 GMT")], None),
            (vec![("retry-after", "1e400")], None),
            (vec![("retry-after", "1e300")], Some(LONGEST)),
            (vec![("retry-after", "-1")], None),
            (vec![("retry-after", "NaN")], None),
            (vec![("retry-after", "soon")], None),
            (vec![], None),
        ] {
            let find = |name: &str| headers.iter().find(|(n, _)| *n == name).map(|(_, v)| *v);
            assert_eq!(asked(find), wanted.map(Duration::from_secs_f64), "{headers:?}");
        }
    }
}
