//! The table: a row for each family of problems.

use super::trial::{BenchRun, TrialEnd};
use crate::table::Table;
use scenelang_verify::report::model::Tally;
use std::time::Duration;

/// The runs of one family.
pub struct Family<'a> {
    pub name: &'a str,
    /// How many problems.
    pub problems: usize,
    /// Every run of them.
    pub trials: Vec<&'a BenchRun>,
}

impl Family<'_> {
    /// How many runs ended in a layout that the verifier accepts.
    pub fn solved(&self) -> usize {
        self.trials.iter().filter(|t| t.answer == TrialEnd::Solved).count()
    }
    /// How many ended in the proof that there is no layout.
    pub fn refuted(&self) -> usize {
        self.trials.iter().filter(|t| matches!(t.answer, TrialEnd::Refuted(_))).count()
    }
    /// How many of the constraints hold in all layouts together.
    pub fn stated(&self) -> Tally {
        self.sum(BenchRun::stated)
    }
    /// How many of the preferences.
    pub fn preferences(&self) -> Tally {
        self.sum(|t| t.held.preferences)
    }
    fn sum(&self, of: impl Fn(&BenchRun) -> Tally) -> Tally {
        self.trials
            .iter()
            .map(|t| of(t))
            .fold(Tally::default(), |a, b| Tally { total: a.total + b.total, satisfied: a.satisfied + b.satisfied })
    }
    /// The time within which so large a share of the runs had their answer; `None` if fewer ever had.
    pub fn within(&self, share: f64) -> Option<Duration> {
        let mut times: Vec<Duration> = self.trials.iter().filter_map(|t| t.first).collect();
        times.sort_unstable();
        let rank = (share * self.trials.len() as f64).ceil().max(1.0) as usize;
        times.get(rank - 1).copied()
    }
}

/// The shares of the runs that the table tells the time of.
pub const SHARES: [(&str, f64); 4] = [("median", 0.5), ("p90", 0.9), ("p99", 0.99), ("max", 1.0)];

/// Runs by family, in the order in which families first occur.
pub fn of(trials: &[BenchRun]) -> Vec<Family<'_>> {
    let mut out: Vec<Family<'_>> = Vec::new();
    for trial in trials {
        let at = out.iter().position(|f| f.name == trial.family).unwrap_or_else(|| {
            out.push(Family { name: &trial.family, problems: 0, trials: Vec::new() });
            out.len() - 1
        });
        let family = &mut out[at];
        family.problems += usize::from(!family.trials.iter().any(|t| t.problem == trial.problem));
        family.trials.push(trial);
    }
    out
}

/// The table as text.
pub fn text(trials: &[BenchRun]) -> String {
    let [median, p90, p99, max] = SHARES.map(|(name, _)| name);
    let head = ["family", "problems", "runs", "solved", "refuted", "constraints", "preferences", median, p90, p99, max];
    let mut table = Table::new(&head);
    for family in of(trials) {
        let runs = family.trials.len();
        let [median, p90, p99, max] = SHARES.map(|(_, share)| seconds(family.within(share)));
        table.row([
            family.name.to_owned(),
            family.problems.to_string(),
            runs.to_string(),
            percent(family.solved(), runs),
            percent(family.refuted(), runs),
            percent(family.stated().satisfied, family.stated().total),
            percent(family.preferences().satisfied, family.preferences().total),
            median,
            p90,
            p99,
            max,
        ]);
    }
    format!(
        "{}\n  solved: the verifier accepts the layout. Times: solver time until everything that must hold did, over all \
         runs;\n  — means that too few runs were solved.\n",
        table.render()
    )
}

/// A share in percent; of nothing, a dash.
pub fn percent(part: usize, whole: usize) -> String {
    if whole == 0 {
        return "—".into();
    }
    let share = 100.0 * part as f64 / whole as f64;
    // What is not all never reads as all.
    if part < whole && share > 99.9 { "99.9 %".into() } else { format!("{share:.1} %") }
}

fn seconds(time: Option<Duration>) -> String {
    let Some(time) = time else { return "—".into() };
    let s = time.as_secs_f64();
    if s < 0.001 {
        "<1 ms".into()
    } else if s < 1.0 {
        format!("{:.0} ms", s * 1e3)
    } else {
        format!("{s:.2} s")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_verify::report::model::Summary;

    fn trial(family: &str, problem: &str, first: Option<u64>) -> BenchRun {
        let assertions = Tally { total: 10, satisfied: if first.is_some() { 10 } else { 7 } };
        BenchRun {
            problem: problem.into(),
            family: family.into(),
            seed: 0,
            objects: 3,
            answer: if first.is_some() { TrialEnd::Solved } else { TrialEnd::Unsolved },
            held: Summary { assertions, ..Summary::default() },
            first: first.map(Duration::from_millis),
            total: Duration::from_secs(9),
            proving: Duration::ZERO,
            work: 0,
            rounds: 0,
            cut: false,
        }
    }

    #[test]
    fn a_run_without_an_answer_is_slower_than_any() {
        let trials = [trial("a", "p", Some(4)), trial("a", "q", None), trial("a", "p", Some(2)), trial("b", "r", None)];
        let found = of(&trials);
        assert_eq!(
            found.iter().map(|f| (f.name, f.problems, f.solved())).collect::<Vec<_>>(),
            [("a", 2, 2), ("b", 1, 0)]
        );
        assert_eq!(found[0].within(0.5), Some(Duration::from_millis(4)));
        assert_eq!(found[0].within(0.9), None);
        assert_eq!(found[0].stated(), Tally { total: 30, satisfied: 27 });
        let text = text(&trials);
        assert!(text.contains("66.7 %") && text.contains("90.0 %") && text.contains("4 ms"), "{text}");
    }

    #[test]
    fn what_is_not_all_never_reads_as_all() {
        assert_eq!(percent(9_999, 10_000), "99.9 %");
        assert_eq!(percent(10, 10), "100.0 %");
        assert_eq!(percent(0, 0), "—");
        assert_eq!(seconds(Some(Duration::from_micros(300))), "<1 ms");
    }
}
