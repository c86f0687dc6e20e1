//! The language model that `formalize`, `solve` and `synth` may ask: from options and settings to a session, and what it came to.

use crate::args::ModelOptions;
use crate::consent::{Allowed, Consent, consent};
use crate::interrupt;
use scenelang_formalize::Formalized;
use scenelang_formalize::model::Asking as Formalizing;
use scenelang_llm::{Budget, Error, Limits, Price, Reach, Retry, Session, Spent, connect, plain};
use scenelang_solve::Asking;
use scenelang_synth::{Advice, Adviser};
use scenelang_verify::settings::Llm;
use serde_json::{Value, json};
use std::env;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The longest wait for an answer, unless the settings say another.
const TIMEOUT: Duration = Duration::from_secs(120);
/// The largest answer (bytes): some ten times of what the longest one would need.
const LARGEST: u64 = 4 << 20;
/// What a recorded conversation says of itself.
const CONVERSATION: &str = "\"format\": \"scenelang.conversation/";
/// Says where answers are kept.
const CACHE: &str = "SCENELANG_CACHE";

/// A model that is asked.
pub struct ModelSession {
    session: Session,
    asking: Asking,
}

impl ModelSession {
    /// The model that the user wants asked, if any; what they should know of it is said on standard error.
    ///
    /// # Errors
    /// It cannot even be tried: no such provider, no key.
    pub fn new(chosen: &ModelOptions, workspace: &Llm, seed: u64) -> Result<Option<Self>, Error> {
        match consent(chosen, workspace)? {
            Consent::Given(allowed) => {
                for note in &allowed.notes {
                    eprintln!("note: {note}");
                }
                let asked = Self::allowed(&allowed, chosen, seed)?;
                let session = asked.session.announced_by(|said| eprintln!("{said}"));
                Ok(Some(Self { session, ..asked }))
            }
            Consent::Unasked(Some(model)) => {
                eprintln!(
                    "note: the language model {} in scenelang.toml is not used; enable it with `--model configured`",
                    plain(&model, 100)
                );
                Ok(None)
            }
            Consent::Unasked(None) => Ok(None),
        }
    }

    /// The model that was allowed.
    ///
    /// # Errors
    /// It cannot even be tried.
    pub fn allowed(allowed: &Allowed, chosen: &ModelOptions, seed: u64) -> Result<Self, Error> {
        let Allowed { model, base, llm: settings, .. } = allowed;
        // `provider/name` is what others write; with a colon, a slash belongs to the name.
        let model = &if model.contains(':') { model.clone() } else { model.replacen('/', ":", 1) };
        let reach = Reach {
            model,
            base: base.as_deref(),
            offline: chosen.offline,
            timeout: settings.timeout.map_or(TIMEOUT, Duration::from_secs_f64),
            largest: LARGEST,
            stop: interrupt::asked,
        };
        if let Some(path) = &chosen.record {
            recordable(path)?;
        }
        let session = connect(&reach, |name| limits(chosen, settings, name))?;
        let usual = Asking::default();
        let count = |given: Option<u64>, usual: usize| given.and_then(|n| usize::try_from(n).ok()).unwrap_or(usual);
        let asking = Asking {
            batch: count(settings.batch, usual.batch),
            rounds: count(settings.rounds, usual.rounds),
            temperature: settings.temperature.or(usual.temperature),
            max_output: settings.max_output.unwrap_or(usual.max_output),
            seed,
        };
        Ok(Self { session, asking })
    }

    /// The session, and how it is asked.
    pub fn into_parts(self) -> (Session, Asking) {
        (self.session, self.asking)
    }

    /// Asks what a request says; where the model fails, the reader reads.
    ///
    /// # Errors
    /// The model failed, and the reader understood nothing.
    pub fn formalize(&mut self, request: &str, options: &scenelang_formalize::Options) -> Result<Formalized, Error> {
        let Asking { temperature, max_output, seed, .. } = self.asking;
        let asking = Formalizing { temperature, max_output, seed, ..Formalizing::default() };
        scenelang_formalize::formalize(request, options, Some((&mut self.session, &asking)))
    }

    /// What was spent so far.
    pub fn spent(&self) -> &Spent {
        self.session.spent()
    }

    /// For the corridor.
    pub fn adviser(&mut self) -> Adviser<'_> {
        Adviser { model: &mut self.session, asking: self.asking }
    }
}

/// A recording may take the place of another recording, and of nothing else.
fn recordable(path: &Path) -> Result<(), Error> {
    if !std::fs::metadata(path).is_ok_and(|data| data.is_file() && data.len() > 0) {
        return Ok(());
    }
    let mut start = Vec::new();
    let read = File::open(path).and_then(|file| file.take(200).read_to_end(&mut start));
    if read.is_ok() && String::from_utf8_lossy(&start).contains(CONVERSATION) {
        return Ok(());
    }
    let say = format!("{} exists already and is not a recorded conversation; name another file", path.display());
    Err(Error::File(say))
}

fn limits(chosen: &ModelOptions, settings: &Llm, name: &str) -> Limits {
    let usual = Retry::default();
    let tries = settings.tries.and_then(|n| u32::try_from(n).ok()).unwrap_or(usual.tries);
    let price = settings.prices.iter().find(|(model, _)| model == name);
    Limits {
        // Processes that fail together are not to come back together.
        retry: Retry { tries, seed: u64::from(std::process::id()), ..usual },
        per_minute: settings.per_minute,
        budget: Budget { calls: settings.max_calls, tokens: settings.max_tokens, money: settings.max_money },
        price: price.map(|(_, [input, output])| Price { input: *input, output: *output }),
        cache: if settings.cache.unwrap_or(true) { cache_folder("llm") } else { None },
        record: chosen.record.clone(),
    }
}

/// Where answers of a kind are kept: where the user says, else where the system keeps what can be made again.
pub fn cache_folder(kind: &str) -> Option<PathBuf> {
    let set = |name: &str| env::var_os(name).filter(|v| !v.is_empty()).map(PathBuf::from);
    if let Some(folder) = set(CACHE) {
        return Some(folder.join(kind));
    }
    let usual = if cfg!(windows) {
        set("LOCALAPPDATA")
    } else if cfg!(target_os = "macos") {
        set("HOME").map(|home| home.join("Library/Caches"))
    } else {
        set("XDG_CACHE_HOME").or_else(|| set("HOME").map(|home| home.join(".cache")))
    };
    usual.map(|folder| folder.join("scenelang").join(kind))
}

/// Prints what was asked and spent, if a model was there to ask.
pub fn summary(asked: Option<&ModelSession>, advice: Option<&Advice>) {
    let (Some(asked), Some(Advice { tally, without })) = (asked, advice) else { return };
    println!("\nmodel {}", asked.session.spent());
    let rounds = if tally.rounds == 1 { "round" } else { "rounds" };
    println!("  {} of its {} moves were made, in {} {rounds}", tally.taken, tally.proposed, tally.rounds);
    if *without {
        println!("  the numeric search found a better layout without the model; that layout was used");
    }
    if let Some(error) = &tally.failed {
        println!("  it stopped early: {error}");
    }
}

/// The same as JSON.
pub fn json(asked: Option<&ModelSession>, advice: Option<&Advice>) -> Option<Value> {
    let (asked, Advice { tally, without }) = (asked?, advice?);
    let spent = asked.session.spent();
    Some(json!({
        "name": spent.model,
        "calls": spent.calls,
        "again": spent.again,
        "cached": spent.cached,
        "input_tokens": spent.usage.input,
        "output_tokens": spent.usage.output,
        "estimated": spent.usage.estimated,
        "cost": spent.money(),
        "rounds": tally.rounds,
        "proposed": tally.proposed,
        "taken": tally.taken,
        "without": without,
        "failed": tally.failed.as_ref().map(ToString::to_string),
    }))
}
