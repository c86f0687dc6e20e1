//! Where `solve` and `synth` get their furniture: folders of models, a generator, the furniture library.
//!
//! A workspace may come from a stranger. It names folders of its own, and can have no program run and no service asked:
//! that is for the command line and the user's own file, as it is with language models.

use crate::args::Furniture;
use crate::consent::own_assets;
use crate::interrupt;
use crate::model::cache_folder;
use crate::settings::find;
use scenelang_base::door::{Door, outside};
use scenelang_catalogue::generator::{Bounds, Command, Generator, Maker, Service, ServiceKind};
use scenelang_catalogue::{AssetProvider, Chain, Library, Local};
use scenelang_verify::settings::{Assets, ProviderKind, unknown};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The longest wait for a model (seconds), unless the settings say another.
const TIMEOUT: f64 = 300.0;
/// The most models in a run, unless the user says another number.
const MODELS: u64 = 20;
/// Nobody makes models.
const NONE: &str = "none";

/// Who makes models, and within which bounds.
type Bounded = (Box<dyn Maker>, Bounds);

/// A folder of models, and what it is called.
struct Folder {
    path: PathBuf,
    name: String,
}

/// The chain for the program of `door`, whose settings are `workspace`; `None` where only the library is asked.
///
/// # Errors
/// A folder is none, has nothing in it, or is none that the settings may name; a generator cannot even be tried.
pub fn chain(given: &Furniture, workspace: &Assets, door: &Door, offline: bool) -> Result<Option<Chain>, String> {
    let own = own_assets().map_err(|e| e.to_string())?;
    let folders = folders(given, workspace, &own, door)?;
    let order = workspace.order.as_ref().or(own.order.as_ref());
    let mut generator = generator(given, workspace, &own, offline)?;
    if folders.is_empty() && generator.is_none() && order.is_none() {
        return Ok(None);
    }
    let usual = ProviderKind::NAMES.map(|(_, source)| source);
    let least = workspace.least.or(own.least);
    let mut providers: Vec<Box<dyn AssetProvider>> = Vec::new();
    for source in order.map_or(&usual[..], Vec::as_slice) {
        match source {
            ProviderKind::Local => {
                for Folder { path, name } in &folders {
                    let local = Local::open(path, name, least).map_err(|d| format!("{name}: {}", d.message))?;
                    for refused in local.refused() {
                        eprintln!("warning: {name}/{} was skipped: {}", refused.file, refused.finding.message);
                    }
                    providers.push(Box::new(local));
                }
            }
            ProviderKind::Generator => {
                if let Some((maker, bounds)) = generator.take() {
                    let most = bounds.most;
                    eprintln!("asking the generator {} for missing models: at most {most}", maker.name());
                    providers.push(Box::new(Generator::new(maker, bounds)));
                }
            }
            ProviderKind::Library => providers.push(Box::new(Library)),
        }
    }
    Ok(Some(Chain::new(providers)))
}

/// Who makes models, and within which bounds; `None`: nobody does.
fn generator(given: &Furniture, workspace: &Assets, own: &Assets, offline: bool) -> Result<Option<Bounded>, String> {
    let Some(named) = given.generator.as_deref().or(own.generator.as_deref()).filter(|name| *name != NONE) else {
        return Ok(None);
    };
    let timeout = Duration::from_secs_f64(workspace.timeout.or(own.timeout).unwrap_or(TIMEOUT));
    let (name, rest) = named.split_once(':').map_or((named, None), |(name, rest)| (name, Some(rest)));
    // What stands beside the generator of the user's own file belongs to that one, and to no other.
    let same = own.generator.as_deref().is_some_and(|own| own.split(':').next() == Some(name));
    let maker: Box<dyn Maker> = if name == "command" {
        let argv = match rest {
            Some(program) => vec![program.to_owned()],
            None if same => own.command.clone(),
            None => Vec::new(),
        };
        let say = "`--generator command` needs a program: `command:PROGRAM`, or `command = [\"PROGRAM\", …]` in the section \
                   [assets] of your own config.toml";
        Box::new(Command::new(&argv).ok_or(say)?)
    } else {
        let Some((_, kind, ..)) = ServiceKind::ALL.into_iter().find(|(known, ..)| *known == name) else {
            let known: Vec<&str> = ServiceKind::ALL.iter().map(|(name, ..)| *name).chain(["command"]).collect();
            return Err(unknown("generator", name, &known));
        };
        let base = rest.or(own.url.as_deref().filter(|_| same));
        Box::new(Service::new(kind, base, timeout, interrupt::asked)?)
    };
    let allowed = given.max_models.unwrap_or(own.max_models.unwrap_or(MODELS));
    let most = match workspace.max_models.filter(|_| given.max_models.is_none()) {
        Some(asked) => asked.min(allowed),
        None => allowed,
    };
    let most = if offline { 0 } else { usize::try_from(most).unwrap_or(usize::MAX) };
    let kept = workspace.cache.or(own.cache).unwrap_or(true).then(|| cache_folder("assets")).flatten();
    let bounds = Bounds { timeout, most, kept, stop: interrupt::asked };
    Ok(Some((maker, bounds)))
}

/// The folders of the command line, else those of the workspace and then the user's own.
fn folders(given: &Furniture, workspace: &Assets, own: &Assets, door: &Door) -> Result<Vec<Folder>, String> {
    if !given.assets.is_empty() {
        let named = |path: &PathBuf| Folder { path: path.clone(), name: path.display().to_string() };
        return Ok(given.assets.iter().map(named).collect());
    }
    let mut out = Vec::new();
    if !workspace.folders.is_empty() {
        let file = find(door, door).file.unwrap_or_default();
        let base = file.parent().unwrap_or(Path::new("")).to_path_buf();
        for name in &workspace.folders {
            let path = base.join(name);
            if let Err(e) = door.permits(&path)
                && outside(&e).is_some()
            {
                return Err(format!(
                    "scenelang.toml names a folder of models outside its workspace; if you want to use it, pass --assets {name}"
                ));
            }
            out.push(Folder { path, name: name.clone() });
        }
    }
    for name in &own.folders {
        let path = PathBuf::from(name);
        if !path.is_absolute() {
            return Err(format!("`folders` in your own config.toml takes absolute paths, not {name}"));
        }
        out.push(Folder { path, name: name.clone() });
    }
    Ok(out)
}
