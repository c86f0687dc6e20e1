//! Who said that a language model is asked, and what it may spend. A workspace may come from a stranger: what its
//! `scenelang.toml` says of models configures one, and never turns it on, says where a key is sent, or allows more than the
//! user does. The user is the command line, `SCENELANG_MODEL`, the file `config.toml` of their own, or the editor's setting.

use crate::args::ModelOptions;
use scenelang_base::door::Door;
use scenelang_base::{FileId, SourceFile, SourceMap};
use scenelang_lang::sources::plain as why;
use scenelang_layout::file::decode;
use scenelang_llm::{Budget, Error, plain};
use scenelang_verify::settings::{Assets, Llm, Settings, read_user};
use std::env;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Says which model is asked, as `--model` does.
const MODEL: &str = "SCENELANG_MODEL";
/// Nobody is asked.
const NONE: &str = "none";
/// The model that the settings name.
pub const CONFIGURED: &str = "configured";

/// What is asked, and within which bounds.
#[derive(Debug, PartialEq)]
pub struct Allowed {
    /// `PROVIDER:NAME`.
    pub model: String,
    /// In place of the provider's own address.
    pub base: Option<String>,
    /// All the rest, as the user and the workspace have it together.
    pub llm: Llm,
    /// What the user should know before.
    pub notes: Vec<String>,
}

/// What came of all that was said.
#[derive(Debug, PartialEq)]
pub enum Consent {
    /// A model is asked.
    Given(Box<Allowed>),
    /// Nobody is; the workspace names this model all the same.
    Unasked(Option<String>),
}

/// What the command line, the environment and the user's own file say of a workspace's settings.
///
/// # Errors
/// The user's own file cannot be used, or the model is to come from settings that name none.
pub fn consent(given: &ModelOptions, workspace: &Llm) -> Result<Consent, Error> {
    if given.model.as_deref() == Some(NONE) {
        return Ok(Consent::Unasked(None));
    }
    let said = env::var(MODEL).ok().filter(|m| !m.trim().is_empty());
    decide(given, said.as_deref(), &own()?, workspace)
}

fn decide(given: &ModelOptions, environment: Option<&str>, own: &Llm, workspace: &Llm) -> Result<Consent, Error> {
    let named = |llm: &Llm| llm.model.clone().filter(|m| m != NONE && m != CONFIGURED);
    let wanted = given.model.as_deref().or(environment).or(own.model.as_deref());
    let model = match wanted {
        None => return Ok(Consent::Unasked(named(workspace))),
        Some(NONE) => return Ok(Consent::Unasked(None)),
        Some(CONFIGURED) => match (named(workspace), named(own)) {
            (Some(model), _) if model.starts_with("replay:") => {
                let say = format!(
                    "the settings of a workspace cannot name a recording ({}); use `--model replay:FILE`",
                    plain(&model, 100)
                );
                return Err(Error::Setup(say));
            }
            (Some(model), _) | (None, Some(model)) => model,
            (None, None) if given.model.is_some() => {
                let say = "`--model configured` needs a model in scenelang.toml: `model = \"PROVIDER:NAME\"` in its section [llm]";
                return Err(Error::Setup(say.to_owned()));
            }
            (None, None) => return Ok(Consent::Unasked(None)),
        },
        Some(model) => model.to_owned(),
    };
    let base = given.base_url.clone().or_else(|| {
        // The address is that of the provider that stands beside it, and of no other: each has a key of its own.
        let same = own.model.as_deref().is_some_and(|beside| provider(beside) == provider(&model));
        own.base_url.clone().filter(|_| same)
    });
    let mut notes = Vec::new();
    let llm = together(given, own, workspace, &mut notes);
    Ok(Consent::Given(Box::new(Allowed { model, base, llm, notes })))
}

/// `provider/name` is what others write.
fn provider(model: &str) -> &str {
    model.split([':', '/']).next().unwrap_or(model)
}

/// The settings of both. How a model is asked is for the workspace to say, what it may cost for the user.
fn together(given: &ModelOptions, own: &Llm, workspace: &Llm, notes: &mut Vec<String>) -> Llm {
    let mut most = |option: &str, given: Option<u64>, own: Option<u64>, usual: u64, asked: Option<u64>| {
        let allowed = given.unwrap_or(own.unwrap_or(usual));
        match asked {
            Some(asked) if given.is_none() && asked > allowed => {
                let what = option.replace("max-", "");
                notes.push(format!(
                    "scenelang.toml asks for {asked} {what}; {allowed} are allowed unless you pass --{option} {asked}"
                ));
            }
            Some(asked) if given.is_none() => return Some(asked),
            _ => {}
        }
        Some(allowed)
    };
    let max_calls = most("max-calls", given.max_calls, own.max_calls, Budget::CALLS, workspace.max_calls);
    let max_tokens = most("max-tokens", given.max_tokens, own.max_tokens, Budget::TOKENS, workspace.max_tokens);
    // A stranger's prices must not make the user's money last longer.
    let theirs = workspace.prices.iter().filter(|_| own.max_money.is_none());
    let prices = own.prices.iter().chain(theirs).cloned().collect();
    Llm {
        model: None,
        base_url: None,
        batch: workspace.batch.or(own.batch),
        rounds: least(workspace.rounds, own.rounds),
        temperature: workspace.temperature.or(own.temperature),
        max_output: least(workspace.max_output, own.max_output),
        timeout: workspace.timeout.or(own.timeout),
        tries: least(workspace.tries, own.tries),
        per_minute: least(workspace.per_minute, own.per_minute),
        max_calls,
        max_tokens,
        max_money: least(workspace.max_money, own.max_money),
        cache: workspace.cache.or(own.cache),
        prices,
    }
}

fn least<T: PartialOrd>(a: Option<T>, b: Option<T>) -> Option<T> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b < a { b } else { a }),
        (a, b) => a.or(b),
    }
}

/// What the user's own file says of language models; nothing, where there is none.
fn own() -> Result<Llm, Error> {
    own_settings().map(|settings| settings.llm)
}

/// What the user's own file says of furniture; nothing, where there is none.
///
/// # Errors
/// It cannot be used.
pub fn own_assets() -> Result<Assets, Error> {
    own_settings().map(|settings| settings.assets)
}

fn own_settings() -> Result<Settings, Error> {
    let Some(path) = own_file() else { return Ok(Settings::default()) };
    // Many keep such files elsewhere, and a link here: it is theirs wherever it is.
    let real = path.canonicalize().unwrap_or_else(|_| path.clone());
    match Door::of(&real).read(&real) {
        Ok(bytes) => read(&path, bytes),
        Err(e) if matches!(e.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => Ok(Settings::default()),
        Err(e) => Err(Error::Setup(format!("cannot read {}: {}", path.display(), why(&e)))),
    }
}

fn read(path: &Path, bytes: Vec<u8>) -> Result<Settings, Error> {
    let name = path.display().to_string();
    let text = decode(bytes).map_err(|d| Error::Setup(format!("{name}: {}", d.message)))?;
    let mut sources = SourceMap::new();
    let id: FileId = sources.add(SourceFile::new(name.as_str(), path, text));
    read_user(sources.get(id).text(), id).map_err(|found| {
        let said = found.iter().map(|d| match &d.primary {
            Some(label) => {
                let (at, _) = sources.lines(label.place);
                format!("{name}:{}:{}: {}", at.line, at.column, d.message)
            }
            None => format!("{name}: {}", d.message),
        });
        Error::Setup(said.collect::<Vec<_>>().join("\n"))
    })
}

/// Where the user's own file is.
fn own_file() -> Option<PathBuf> {
    // A relative path would lead into the workspace.
    let set = |name: &str| env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let folder = if cfg!(windows) {
        set("APPDATA")
    } else {
        set("XDG_CONFIG_HOME").or_else(|| set("HOME").map(|home| home.join(".config")))
    };
    folder.map(|folder| folder.join("scenelang").join("config.toml"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_verify::settings::read_own;

    fn llm(text: &str) -> Llm {
        read_own(&format!("[llm]\n{text}"), FileId(0)).unwrap()
    }

    fn flag(model: Option<&str>, base: Option<&str>) -> ModelOptions {
        ModelOptions { model: model.map(str::to_owned), base_url: base.map(str::to_owned), ..ModelOptions::default() }
    }

    #[test]
    fn only_the_user_turns_a_model_on() {
        let here = "model = \"openai:here\"";
        let mine = "model = \"openai:mine\"";
        for (given, environment, own, workspace, wanted) in [
            (None, None, "", "", None),
            (None, None, "", here, None),
            (None, None, "model = \"none\"", here, None),
            (None, Some("none"), mine, here, None),
            (Some("none"), Some("configured"), mine, here, None),
            (Some("none"), None, mine, here, None),
            (None, None, "model = \"configured\"", "", None),
            (None, Some("configured"), "", "", None),
            (None, None, "", "model = \"configured\"", None),
            (None, Some("configured"), "", "model = \"configured\"", None),
            (None, None, "model = \"configured\"", here, Some("openai:here")),
            (None, Some("configured"), "", here, Some("openai:here")),
            (Some("configured"), None, "", here, Some("openai:here")),
            (Some("configured"), None, mine, "", Some("openai:mine")),
            (None, None, mine, here, Some("openai:mine")),
            (None, Some("gemini:m"), mine, here, Some("gemini:m")),
            (Some("gemini:m"), Some("none"), mine, here, Some("gemini:m")),
        ] {
            let got = decide(&flag(given, None), environment, &llm(own), &llm(workspace)).unwrap();
            let model = match got {
                Consent::Given(allowed) => Some(allowed.model),
                Consent::Unasked(_) => None,
            };
            assert_eq!(model.as_deref(), wanted, "{given:?} {environment:?} {own} {workspace}");
        }
        // Who is not asked is named, where nobody has said anything yet.
        let unasked =
            |given: &ModelOptions, environment| decide(given, environment, &Llm::default(), &llm(here)).unwrap();
        assert_eq!(unasked(&flag(None, None), None), Consent::Unasked(Some("openai:here".to_owned())));
        assert_eq!(unasked(&flag(None, None), Some("none")), Consent::Unasked(None));
    }

    #[test]
    fn what_cannot_be_asked_is_said() {
        for (given, workspace, wanted) in [
            (Some("configured"), "", "needs a model in scenelang.toml"),
            (Some("configured"), "model = \"none\"", "needs a model in scenelang.toml"),
            (
                Some("configured"),
                "model = \"replay:/etc/passwd\"",
                "the settings of a workspace cannot name a recording",
            ),
        ] {
            let error = decide(&flag(given, None), None, &Llm::default(), &llm(workspace)).unwrap_err();
            assert!(error.to_string().contains(wanted), "{error}");
        }
    }

    #[test]
    fn an_address_is_the_users_and_that_of_one_provider() {
        let own = llm("model = \"compatible:mine\"\nbase_url = \"https://mine.example\"");
        for (given, base, workspace, wanted) in [
            (None, None, "", Some("https://mine.example")),
            (Some("compatible:other"), None, "", Some("https://mine.example")),
            (Some("configured"), None, "model = \"compatible:here\"", Some("https://mine.example")),
            (Some("configured"), None, "model = \"openai:here\"", None),
            (Some("openai:m"), None, "", None),
            (Some("openai:m"), Some("https://typed.example"), "", Some("https://typed.example")),
            (None, Some("https://typed.example"), "", Some("https://typed.example")),
            // A file that was read as a workspace's cannot have one; if it had, it would not count.
            (Some("configured"), None, "model = \"openai:m\"\nbase_url = \"https://evil.example\"", None),
        ] {
            let got = decide(&flag(given, base), None, &own, &llm(workspace)).unwrap();
            let Consent::Given(allowed) = got else { panic!("{given:?}") };
            assert_eq!(allowed.base.as_deref(), wanted, "{given:?} {base:?} {workspace}");
        }
    }

    #[test]
    fn a_workspace_may_lower_what_is_spent_and_not_raise_it() {
        for (given, own, workspace, wanted, note) in [
            (None, "", "", (100, 500_000), None),
            (None, "", "max_calls = 7\nmax_tokens = 9", (7, 9), None),
            (
                None,
                "",
                "max_calls = 1000",
                (100, 500_000),
                Some("scenelang.toml asks for 1000 calls; 100 are allowed unless you pass --max-calls 1000"),
            ),
            (None, "max_calls = 2000", "max_calls = 1000", (1000, 500_000), None),
            (
                None,
                "max_calls = 20",
                "max_calls = 1000",
                (20, 500_000),
                Some("scenelang.toml asks for 1000 calls; 20 are allowed unless you pass --max-calls 1000"),
            ),
            (Some(3000), "max_calls = 20", "max_calls = 1000", (3000, 500_000), None),
            (Some(3), "max_calls = 20", "max_tokens = 1000", (3, 1000), None),
            (
                None,
                "max_calls = 0",
                "max_calls = 1",
                (0, 500_000),
                Some("scenelang.toml asks for 1 calls; 0 are allowed unless you pass --max-calls 1"),
            ),
        ] {
            let flags =
                ModelOptions { model: Some("ollama:m".to_owned()), max_calls: given, ..ModelOptions::default() };
            let Consent::Given(allowed) = decide(&flags, None, &llm(own), &llm(workspace)).unwrap() else { panic!() };
            let Allowed { llm, notes, .. } = *allowed;
            assert_eq!((llm.max_calls.unwrap(), llm.max_tokens.unwrap()), wanted, "{own} {workspace}");
            assert_eq!(notes.first().map(String::as_str), note, "{own} {workspace}");
        }
        // Prices of strangers do not stretch a budget of money.
        let own = llm("max_money = 1\nprices.\"openai:m\" = { input = 1, output = 2 }");
        let workspace = llm("max_money = 5\nrounds = 9\nprices.\"openai:m\" = { input = 0, output = 0 }");
        let both = together(&ModelOptions::default(), &own, &workspace, &mut Vec::new());
        assert_eq!((both.max_money, both.rounds), (Some(1.0), Some(9)));
        assert_eq!(both.prices, [("openai:m".to_owned(), [1.0, 2.0])]);
    }
}
