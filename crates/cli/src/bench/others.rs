//! Figures of others, each with its source and what is not comparable: data in `others.json`, shown beside ours.

use super::families::percent;
use crate::table::Table;
use serde_json::Value;

const DATA: &str = include_str!("others.json");

/// The figures.
pub fn value() -> Value {
    serde_json::from_str(DATA).expect("a test reads it")
}

/// The figures as text.
pub fn text() -> String {
    let data = value();
    let list = |name: &str| data[name].as_array().cloned().unwrap_or_default();
    let word = |value: &Value| value.as_str().unwrap_or("—").to_owned();
    let share = |part: &Value, whole: &Value| match (part.as_u64(), whole.as_u64()) {
        (Some(part), Some(whole)) => percent(part as usize, whole as usize),
        _ => "—".to_owned(),
    };
    let mut table = Table::new(&["others", "problems", "solved", "constraints", "source"]);
    for row in list("published") {
        let held = row["held_percent"].as_f64().map_or_else(|| "—".to_owned(), |p| format!("{p:.1} %"));
        table.row([word(&row["name"]), "—".into(), "—".into(), held, word(&row["source"])]);
    }
    for row in list("measured") {
        let problems = row["problems"].to_string();
        let solved = share(&row["solved"], &row["problems"]);
        table.row([word(&row["name"]), problems, solved, share(&row["held"], &row["of"]), word(&row["source"])]);
    }
    let mut out = table.render();
    for note in list("notes") {
        out += &format!("\n  {}", word(&note));
    }
    out + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_figure_has_a_source() {
        let data = value();
        let rows = ["published", "measured"].iter().flat_map(|part| data[*part].as_array().unwrap());
        let mut count = 0;
        for row in rows {
            assert!(row["source"].as_str().is_some_and(|s| !s.is_empty()), "{row}");
            count += 1;
        }
        assert!(count >= 8);
        assert!(text().contains("93.8 %"), "{}", text());
    }
}
