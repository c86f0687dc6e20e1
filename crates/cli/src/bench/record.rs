//! What `--format json` and `-o` write.

use super::families::{self, SHARES};
use super::others;
use super::trial::{BenchRun, TrialEnd};
use crate::args::BenchSolve;
use scenelang_verify::report::model::Tally;
use serde_json::{Map, Value, json};
use std::time::Duration;

/// The value of `format`.
const FORMAT: &str = "scenelang.bench/1";

/// All runs, the table, and the figures of others. Times are seconds.
pub fn json(args: &BenchSolve, trials: &[BenchRun]) -> Value {
    json!({
        "format": FORMAT,
        "version": env!("CARGO_PKG_VERSION"),
        "seeds": args.seeds,
        "threads": args.threads,
        "time": args.time,
        "families": families::of(trials).iter().map(family).collect::<Vec<_>>(),
        "runs": trials.iter().map(run).collect::<Vec<_>>(),
        "others": others::value(),
    })
}

fn family(family: &families::Family<'_>) -> Value {
    let times: Map<String, Value> =
        SHARES.iter().map(|(name, share)| ((*name).to_owned(), json!(family.within(*share).map(seconds)))).collect();
    json!({
        "family": family.name,
        "problems": family.problems,
        "runs": family.trials.len(),
        "solved": family.solved(),
        "refuted": family.refuted(),
        "constraints": tally(family.stated()),
        "preferences": tally(family.preferences()),
        "seconds": times,
    })
}

fn run(trial: &BenchRun) -> Value {
    let (answer, contradictions) = match &trial.answer {
        TrialEnd::Solved => ("solved", None),
        TrialEnd::Unsolved => ("unsolved", None),
        TrialEnd::Refuted(sets) => ("refuted", Some(sets)),
    };
    let mut out = json!({
        "problem": trial.problem,
        "family": trial.family,
        "seed": trial.seed,
        "objects": trial.objects,
        "answer": answer,
        "constraints": tally(trial.stated()),
        "physical": tally(trial.held.physical),
        "preferences": tally(trial.held.preferences),
        "first": trial.first.map(seconds),
        "total": seconds(trial.total),
        "proving": seconds(trial.proving),
        "work": trial.work,
        "rounds": trial.rounds,
        "cut": trial.cut,
    });
    if let Some(sets) = contradictions {
        out["contradictions"] = json!(sets);
    }
    out
}

fn tally(tally: Tally) -> Value {
    json!({ "held": tally.satisfied, "of": tally.total })
}

/// Seconds, to the microsecond.
fn seconds(time: Duration) -> f64 {
    (time.as_secs_f64() * 1e6).round() / 1e6
}
