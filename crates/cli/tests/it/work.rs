//! How much work the solver does for some scenes, held against a table: `tests/work/table.txt`.
//!
//! Work is counted, not timed, so the figures are the same on every machine. A change that makes a scene much dearer or
//! much cheaper, or no longer solves one, shows here. This is no test of layouts: other tests judge those.

use crate::problems::{file, sample};
use crate::support::{EXAMPLES, example, read_json, root};
use scenelang_lang::{Options, compile_file};
use scenelang_solve::{Outcome, Placed, Problem, draws, solve};
use scenelang_synth::furnish;
use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Work may differ from the table by this part of it.
const OFF: f64 = 0.2;
/// Set, it writes the table anew.
const UPDATE: &str = "WORK_UPDATE";
const HEAD: &str = "\
# Work of the solver for each scene, with seed 0: what crates/cli/tests/it/work.rs holds it to.
# WORK_UPDATE=1 cargo test -p scenelang-cli work writes it anew; budgets stay as they are here.
# A budget of - is the solver's own. Scenes that are not solved within it have a smaller one, so that the test is quick.
";

/// A row of the table.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    name: String,
    /// 0: the solver's own.
    budget: u64,
    solved: bool,
    work: u64,
}

impl Row {
    fn read(line: &str) -> Self {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [name, budget, answer, work] = words[..] else { panic!("a row of four words: {line}") };
        assert!(matches!(answer, "solved" | "unsolved"), "{line}");
        let budget = if budget == "-" { 0 } else { budget.parse().unwrap() };
        Self { name: name.to_owned(), budget, solved: answer == "solved", work: work.parse().unwrap() }
    }
    fn write(&self) -> String {
        let budget = if self.budget == 0 { "-".to_owned() } else { self.budget.to_string() };
        let answer = if self.solved { "solved" } else { "unsolved" };
        format!("{:48}{budget:>12}  {answer:8}{:>12}\n", self.name, self.work)
    }
    /// Whether the table says the same.
    fn is_near(&self, known: &Self) -> bool {
        self.solved == known.solved && self.work.abs_diff(known.work) as f64 <= OFF * known.work as f64
    }
}

fn folder() -> PathBuf {
    root().join("tests/work")
}

/// Names and files of the scenes: the examples, the sample of the problems, and those that are here for this test.
fn scenes() -> Vec<(String, PathBuf)> {
    let mut out: Vec<(String, PathBuf)> =
        EXAMPLES.iter().map(|name| (format!("examples/{name}"), example(name))).collect();
    for name in sample() {
        // What has no solution is proved to have none, not searched for.
        if read_json(&file(&name, "json"))["contradiction"].is_null() {
            out.push((format!("problems/{name}"), file(&name, "scene")));
        }
    }
    let mut own: Vec<PathBuf> = std::fs::read_dir(folder()).unwrap().map(|e| e.unwrap().path()).collect();
    own.retain(|path| path.extension().is_some_and(|e| e == "scene"));
    own.sort();
    out.extend(own.into_iter().map(|path| (format!("work/{}", path.file_stem().unwrap().to_str().unwrap()), path)));
    out
}

/// A scene solved as `scenelang solve` does, furniture included.
fn solved(path: &Path, budget: u64) -> Outcome {
    let compiled = compile_file(&path.display().to_string(), path, Options::default());
    let program =
        compiled.program.as_ref().unwrap_or_else(|| panic!("{}: {:#?}", path.display(), compiled.diagnostics));
    // What is in the way of a layout is another search, which is not counted here.
    let options = scenelang_solve::Options { budget, diagnose: false, ..Default::default() };
    let start = furnish(program, draws(program, options.seed), None, &options.judge).layout;
    let problem = Problem { program, placed: Placed::None, start };
    solve(&problem, &options, &mut |_| ControlFlow::Continue(()))
}

#[test]
fn the_solver_does_as_much_work_as_the_table_says() {
    let table = folder().join("table.txt");
    let known: Vec<Row> = std::fs::read_to_string(&table)
        .unwrap_or_default()
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(Row::read)
        .collect();
    let mut found: Vec<Row> = Vec::new();
    for (name, path) in scenes() {
        let budget = known.iter().find(|row| row.name == name).map_or(0, |row| row.budget);
        let outcome = solved(&path, budget);
        found.push(Row { name, budget, solved: outcome.converged, work: outcome.work });
    }
    if std::env::var_os(UPDATE).is_some() {
        let rows: String = found.iter().map(Row::write).collect();
        std::fs::write(&table, format!("{HEAD}{rows}")).unwrap();
        return;
    }
    let mut said = String::new();
    for row in &found {
        match known.iter().find(|other| other.name == row.name) {
            Some(other) if row.is_near(other) => {}
            Some(other) => {
                let share = row.work as f64 / other.work.max(1) as f64 * 100.0;
                writeln!(said, "now   {}table {}      {share:.0} % of the work", row.write(), other.write()).unwrap();
            }
            None => writeln!(said, "now   {}      not in the table", row.write()).unwrap(),
        }
    }
    for row in known.iter().filter(|row| found.iter().all(|other| other.name != row.name)) {
        writeln!(said, "table {}      there is no such scene", row.write()).unwrap();
    }
    assert!(
        said.is_empty(),
        "the solver's work differs from {}:\n{said}\
         if that is meant, write the table anew: {UPDATE}=1 cargo test -p scenelang-cli work",
        table.display(),
    );
}
