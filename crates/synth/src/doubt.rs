//! A layout is looked for once the cheap proofs that there is none are done; if the search takes long, dearer ones are
//! tried beside it, so that neither waits; and where it ends without a layout, the dearest.
//!
//! What runs side by side is sound: of a program that has a layout nothing is refuted, and what is refuted has none. So
//! what comes of it does not depend on which of the two is faster. What takes things as usual (upright, unturned) is asked
//! before the search and after it.

use scenelang_lang::Program;
use scenelang_solve::Stop;
use scenelang_verify::prove::{DEAR, Findings, ProveOptions, WORK, prove};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Most layouts are found within this time; before it nobody doubts that there is one.
const PATIENCE: Duration = Duration::from_millis(50);
/// The work of the cheap proofs.
const CHEAP: u64 = WORK / 6;
/// The prover's stack (bytes): that of a main thread.
const STACK: usize = 8 << 20;

/// How a search for a layout ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// With a layout in which all holds: there is nothing to prove.
    Found,
    /// By the clock or by request: the prover has to end, too.
    Cut,
    /// Without such a layout.
    Unfound,
}

/// Searches, and looks for a contradiction beside it. `search` gets the request by which a contradiction that was found
/// ends it. With `at_once`, because a search is dear, all is proved before. With `usual` things are taken as they usually
/// are: not where a layout is there that says otherwise.
pub fn doubted<R>(
    program: &Program,
    judging: scenelang_verify::Options,
    stop: &Stop,
    (at_once, usual): (bool, bool),
    search: impl FnOnce(&Stop) -> (R, Ended),
) -> Result<R, Findings> {
    let quit = stop.below();
    let proofs = |usual: bool, work: u64| {
        let cancel = Some(quit.flag());
        prove(program, &ProveOptions { judging, redundant: false, usual, work, cancel, ..ProveOptions::default() })
    };
    let first = proofs(usual, if at_once { WORK } else { CHEAP });
    if !first.contradictions.is_empty() {
        return Err(first);
    }
    if at_once {
        return Ok(search(stop).0);
    }
    let look = || proofs(false, WORK);
    let enough = stop.below();
    let (look, enough) = (&look, &enough);
    let (tell, told) = channel();
    thread::scope(|scope| {
        let doubt = move || match told.recv_timeout(PATIENCE) {
            Ok(Ended::Unfound) | Err(RecvTimeoutError::Timeout) => {
                let findings = look();
                if !findings.contradictions.is_empty() {
                    enough.set();
                }
                findings
            }
            Ok(Ended::Found | Ended::Cut) | Err(RecvTimeoutError::Disconnected) => Findings::default(),
        };
        let prover = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, doubt);
        let (result, ended) = search(enough);
        if ended != Ended::Unfound {
            quit.set();
        }
        // The prover may be at work already, and then does not listen.
        let _ = tell.send(ended);
        let findings = match prover {
            Ok(prover) => prover.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            // No thread is to be had: one after the other, then.
            Err(_) if ended == Ended::Unfound => look(),
            Err(_) => Findings::default(),
        };
        if findings.contradictions.is_empty() { Ok((result, ended)) } else { Err(findings) }
    })
    .and_then(|(result, ended)| {
        let last = if ended == Ended::Unfound { proofs(usual, DEAR) } else { Findings::default() };
        if last.contradictions.is_empty() { Ok(result) } else { Err(last) }
    })
}
