//! Programs that no layout satisfies: whoever looks for one is refused with the smallest set of statements that contradict each
//! other, as soon as that is known, instead of after a search that cannot end well.

use crate::dispatch::Fault;
use crate::jobs::Job;
use scenelang_layout::Layout;
use scenelang_solve::repair::is_usual;
use scenelang_synth::{Ended, doubted};
use scenelang_verify::prove::Contradiction;

/// What a search for a layout comes to.
pub struct Sought<T> {
    pub result: Result<T, Fault>,
    /// Whether all holds in the layout that was found.
    pub converged: bool,
}

impl<T> Sought<T> {
    /// A search that ended without any layout.
    pub fn failed(fault: Fault) -> Self {
        Self { result: Err(fault), converged: false }
    }
}

/// What a search finds, beside which a contradiction is looked for: if there is one, that ends it. `from`: the layout in
/// which it begins; proofs may take for granted only what is so in that.
///
/// # Errors
/// No layout satisfies the program, or the search failed.
pub fn unless_refuted<T>(
    job: &Job,
    from: Option<&Layout>,
    search: impl FnOnce(&crate::state::Stop) -> Sought<T>,
) -> Result<T, Fault> {
    let usual = from.is_none_or(is_usual);
    let search = |stop: &crate::state::Stop| {
        let Sought { result, converged } = search(stop);
        let ended = match result {
            Ok(_) if converged => Ended::Found,
            Ok(_) => Ended::Unfound,
            Err(_) => Ended::Cut,
        };
        (result, ended)
    };
    let judging = job.judging.options;
    match doubted(&job.compiled.program, judging, &job.stop, (false, usual), search) {
        Ok(result) => result,
        Err(_) if job.stop.is_set() => Err(Fault::Cancelled),
        Err(findings) => {
            // Where several sets contradict each other, each would have to go; one is enough to begin with.
            let first = findings.contradictions.first();
            let message =
                first.map_or_else(|| "no layout satisfies the program".to_owned(), |found| refusal(job, found));
            Err(Fault::Failed(message))
        }
    }
}

/// Why there is nothing to look for: the smallest set of statements that cannot hold together.
pub fn refusal(job: &Job, found: &Contradiction) -> String {
    let places = job.places();
    let constraints = &job.compiled.program.constraints;
    let member = |i: &usize| {
        let line = places.range(constraints[*i].span).start.line + 1;
        format!("`{}` (line {line})", constraints[*i].text.split_whitespace().collect::<Vec<_>>().join(" "))
    };
    let members: Vec<String> = found.statements.iter().map(member).collect();
    match members.as_slice() {
        [one] => format!("no layout satisfies {one}"),
        all => format!("no layout satisfies all of these statements: {}", all.join(", ")),
    }
}
