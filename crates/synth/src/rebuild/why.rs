//! Why a stage is made again, in words.

use super::Inputs;

/// So many reasons are said; the rest is counted.
const SAID: usize = 8;

/// What differs between two sets of inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Only the new one has it.
    Added,
    /// Only the old one has it.
    Removed,
    /// Both have it, with different sums.
    Changed,
}

/// All differences, by what differs.
pub fn changes<'i>(before: &'i Inputs, now: &'i Inputs) -> Vec<(&'i str, Change)> {
    let mut out: Vec<(&str, Change)> = Vec::new();
    for (key, sum) in now {
        match before.get(key) {
            None => out.push((key, Change::Added)),
            Some(old) if old != sum => out.push((key, Change::Changed)),
            Some(_) => {}
        }
    }
    out.extend(before.keys().filter(|key| !now.contains_key(*key)).map(|key| (key.as_str(), Change::Removed)));
    out
}

/// The files of a program that differ, in words.
pub fn of_program(before: &Inputs, now: &Inputs) -> Vec<String> {
    short(changes(before, now).into_iter().map(|(file, change)| format!("{file} {}", verb(change))).collect())
}

/// The differences between what a layout was made from, in words.
pub fn of_layout(before: &Inputs, now: &Inputs) -> Vec<String> {
    let mut said: Vec<String> = Vec::new();
    for (key, change) in changes(before, now) {
        let (kind, rest) = key.split_once(' ').unwrap_or((key, ""));
        let sentence = match (kind, change) {
            // It follows from the assignment that is told.
            ("value", _) => continue,
            ("object", Change::Changed) => format!("`{rest}` has a different shape or role"),
            ("rules", _) => "other objects are contained, mounted or connected".to_owned(),
            ("judging", _) => "the settings of the check have changed".to_owned(),
            ("seed" | "effort" | "quality", _) => {
                let old = before.get(key).map_or("", String::as_str);
                let new = now.get(key).map_or("", String::as_str);
                format!("--{kind} has changed from {old} to {new}")
            }
            ("time", _) => "--time was given, or no longer is".to_owned(),
            ("model", _) => "a language model is asked, or no longer is".to_owned(),
            ("scenelang", _) => "it was written by another version of scenelang".to_owned(),
            ("object" | "region" | "variable" | "draw", change) => format!("`{rest}` {}", verb(change)),
            ("statement", change) => format!("`{rest}` {}", verb(change)),
            (_, change) => format!("`{key}` {}", verb(change)),
        };
        said.push(sentence);
    }
    short(said)
}

/// The differences between what a format shows, in words.
pub fn of_format(before: &Inputs, now: &Inputs) -> Vec<String> {
    let mut said: Vec<String> = Vec::new();
    for (key, change) in changes(before, now) {
        let (kind, rest) = key.split_once(' ').unwrap_or((key, ""));
        let sentence = match (kind, change) {
            ("look", Change::Changed) => format!("`{rest}` looks different"),
            ("look", change) => format!("`{rest}` {}", verb(change)),
            ("place", Change::Changed) => format!("`{rest}` stands elsewhere"),
            // Said of its look already.
            ("place", _) => continue,
            ("building", _) => "floors, walls or ceilings have changed".to_owned(),
            ("lights", _) => "the lights have changed".to_owned(),
            ("options", _) => "its options have changed".to_owned(),
            ("scenelang", _) => "it was written by another version of scenelang".to_owned(),
            (what, _) => format!("the text of the {what} has changed"),
        };
        said.push(sentence);
    }
    short(said)
}

fn verb(change: Change) -> &'static str {
    match change {
        Change::Added => "was added",
        Change::Removed => "was removed",
        Change::Changed => "was changed",
    }
}

/// The first ones, and how many more there are.
fn short(mut said: Vec<String>) -> Vec<String> {
    let more = said.len().saturating_sub(SAID);
    said.truncate(SAID);
    if more > 0 {
        said.push(format!("and {more} more"));
    }
    said
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inputs(pairs: &[(&str, &str)]) -> Inputs {
        pairs.iter().map(|(key, sum)| ((*key).to_owned(), (*sum).to_owned())).collect()
    }

    #[test]
    fn each_difference_is_a_sentence() {
        let old = inputs(&[("assert a", "1"), ("object lamp", "1"), ("seed", "0"), ("value of lamp Pos", "1")]);
        let new = inputs(&[("assert b", "1"), ("object lamp", "2"), ("seed", "7")]);
        let wanted = [
            "`assert b` was added",
            "`lamp` has a different shape or role",
            "--seed has changed from 0 to 7",
            "`assert a` was removed",
        ];
        assert_eq!(of_layout(&old, &new), wanted);
        assert!(of_layout(&new, &new).is_empty());
        let old =
            inputs(&[("look lamp", "1"), ("place lamp", "1"), ("report", "1"), ("look bed", "1"), ("place bed", "1")]);
        let new = inputs(&[("look lamp", "2"), ("place lamp", "2"), ("report", "2")]);
        let wanted = [
            "`lamp` looks different",
            "`lamp` stands elsewhere",
            "the text of the report has changed",
            "`bed` was removed",
        ];
        assert_eq!(of_format(&old, &new), wanted);
    }

    #[test]
    fn a_long_list_is_cut() {
        let many = (0..20).map(|i| i.to_string()).collect();
        assert_eq!(short(many).last().unwrap(), "and 12 more");
    }
}
