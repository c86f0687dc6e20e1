//! Exported scenes that somebody edited since we wrote them. A command that would write over one stops, unless the user has
//! it go on from the scene as it stands there (`--take`) or write over it (`--overwrite`).
//!
//! An edit is what [`embedded`] sees: where things stand, and which there are. What else was changed in a file cannot be
//! taken over; so a file that another program has saved is not written over without a word either.

use crate::args::Edits;
use crate::replace;
use scenelang_base::door::{Door, relative};
use scenelang_base::{owned, plain};
use scenelang_export::embedded::{self, Embedded, carrier};
use scenelang_export::{Exporter, glb, unity, usd};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// So many changes of a scene are listed.
const LISTED: usize = 50;
/// So many files of a Unity project are named that were edited beside its scene.
const NAMED: usize = 5;
/// Where a Unity project has its layout.
const LAYOUT: &str = "Assets/Scenelang/layout.json";

/// What may be done.
#[derive(Default)]
pub struct Permission {
    /// The scene to go on from.
    pub taken: Option<Taken>,
    /// Scenes that are written over, edited as they are.
    pub replaced: Vec<PathBuf>,
}

/// A scene that is taken as it stands now.
pub struct Taken {
    /// What the file or the folder is called.
    pub name: String,
    /// What it carries.
    pub scene: Embedded,
    /// What was changed, a line each; empty: nothing was.
    pub changes: Vec<String>,
    /// Whether the layout in it was edited by itself, so that it is not known what was exported.
    pub is_rewritten: bool,
}

/// An exported scene that is there.
struct Found {
    path: PathBuf,
    name: String,
    /// Its files that are not as we wrote them.
    edited: Vec<PathBuf>,
    /// Whether the list of the folder has it.
    is_listed: bool,
    /// What it carries, or why nothing can be read of it.
    scene: Result<Embedded, String>,
}

/// Looks at the scenes that these exporters would write over in a folder, before any work is done. What is lost or taken
/// over is told on standard error.
///
/// # Errors
/// What was edited, and how to go on.
pub fn ask(
    folder: &Path,
    stem: &str,
    exporters: &[Box<dyn Exporter>],
    said: Edits,
    force: bool,
) -> Result<Permission, String> {
    let written = written(folder, stem, exporters);
    let (mut edited, mut rest) = (BTreeMap::<PathBuf, Vec<PathBuf>>::new(), Vec::new());
    for file in owned::edited_below(folder) {
        match scene_of(&file, folder) {
            Some(scene) if written.contains(&scene) => edited.entry(scene).or_default().push(file),
            // What is not written over is in nobody's way.
            Some(_) => {}
            None => rest.push(file),
        }
    }
    let mut scenes = Vec::new();
    for path in written {
        let files = edited.remove(&path).unwrap_or_default();
        scenes.extend(Found::read(folder, path, files, said.take));
    }
    let lost: Vec<&Found> = scenes.iter().filter(|found| found.is_edited()).collect();
    let mut why = String::new();
    let is_asked_for = said.take || said.overwrite || force;
    if !is_asked_for && !lost.is_empty() {
        why = refused(&lost);
    }
    if let Err(others) = replace::still_ours(if force { Vec::new() } else { rest }) {
        why += if why.is_empty() { "" } else { "\n" };
        why += &others;
    }
    if !why.is_empty() {
        return Err(why);
    }
    let replaced = lost.iter().map(|found| found.path.clone()).collect();
    if !said.take {
        lost.iter().for_each(|found| found.tell("writing over"));
        return Ok(Permission { taken: None, replaced });
    }
    if let Some(found) = lost.iter().find(|found| found.scene.is_err()) {
        return Err(format!("{}\nuse --overwrite to discard the edits", found.words().join("\n  ")));
    }
    lost.iter().filter(|found| !found.is_changed()).for_each(|found| found.tell("writing over"));
    let taken = chosen(scenes)?;
    Ok(Permission { taken, replaced })
}

/// The scene to go on from: the one that was changed, else the first that is there.
fn chosen(scenes: Vec<Found>) -> Result<Option<Taken>, String> {
    let (mut changed, same): (Vec<Found>, Vec<Found>) =
        scenes.into_iter().filter(|found| found.scene.is_ok()).partition(Found::is_changed);
    let layout = |found: &Found| found.scene.as_ref().map_or_else(|_| String::new(), |scene| scene.layout.clone());
    if let [first, others @ ..] = changed.as_slice()
        && let Some(other) = others.iter().find(|other| layout(other) != layout(first))
    {
        return Err(format!(
            "{} and {} were both edited, and their objects are in different places, so it is not clear which one to use; move one of \
             them to another folder, from where `scenelang import` can read it",
            first.name, other.name
        ));
    }
    changed.iter().for_each(|found| found.tell("keeping the edits in"));
    changed.truncate(1);
    let Some(found) = changed.into_iter().chain(same).next() else { return Ok(None) };
    let (changes, is_rewritten) = (found.changes(), found.is_rewritten());
    Ok(found.scene.ok().map(|scene| Taken { name: found.name, scene, changes, is_rewritten }))
}

/// The scenes that are written.
fn written(folder: &Path, stem: &str, exporters: &[Box<dyn Exporter>]) -> Vec<PathBuf> {
    let writes = |name: &str| exporters.iter().any(|exporter| exporter.name() == name);
    let scenes = [
        (writes(glb::Glb.name()), format!("{stem}.glb")),
        (writes(usd::Usd.name()), format!("{stem}.usda")),
        (writes(usd::Usdz.name()), format!("{stem}.usdz")),
        (writes(unity::Unity::default().name()), unity::ROOT.to_owned()),
    ];
    scenes.into_iter().filter(|(is_written, _)| *is_written).map(|(_, name)| folder.join(name)).collect()
}

/// The scene that a file below a folder is, or is part of.
fn scene_of(file: &Path, folder: &Path) -> Option<PathBuf> {
    let above = file.ancestors().take_while(|path| *path != folder);
    above.filter(|path| carrier(path).is_some()).last().map(Path::to_path_buf)
}

fn refused(lost: &[&Found]) -> String {
    let mut out = "nothing was written, because an exported scene was edited:\n".to_owned();
    for found in lost {
        out += &format!("  {} has been edited since scenelang wrote it:\n", found.name);
        out.extend(found.words().iter().map(|line| format!("    {}\n", plain::line(line))));
    }
    out + "use --take to continue from the edited scene, --overwrite to discard the edits, or name another folder with -o"
}

impl Found {
    /// What is at the place of a scene; `None`: nothing of ours, or what need not be looked at. `always`: it is looked at
    /// even if it is as we wrote it.
    fn read(folder: &Path, path: PathBuf, edited: Vec<PathBuf>, always: bool) -> Option<Self> {
        let kind = carrier(&path)?;
        let is_listed = owned::knows(folder, path.strip_prefix(folder).ok()?);
        if edited.is_empty() && is_listed && !always {
            return None;
        }
        let name = path.display().to_string();
        let scene = match embedded::read(&name, &path, kind, &Door::within(folder)) {
            Ok(Embedded { unread: Some(why), .. }) => Err(why),
            Ok(scene) => Ok(scene),
            Err(finding) => Err(finding.message),
        };
        let nothing = scene.is_err() && edited.is_empty();
        (!nothing).then_some(Self { path, name, edited, is_listed, scene })
    }

    /// Whether something would be lost. What somebody has put there as it was exported is a file like any other.
    fn is_edited(&self) -> bool {
        !self.edited.is_empty() || !self.is_listed && self.is_changed()
    }

    /// Whether things stand elsewhere than they were exported.
    fn is_changed(&self) -> bool {
        self.is_rewritten() || self.scene.as_ref().is_ok_and(|scene| !scene.changes.is_empty())
    }

    fn is_rewritten(&self) -> bool {
        self.edited.iter().any(|file| *file == self.path.join(LAYOUT))
    }

    /// What was changed, a line each.
    fn changes(&self) -> Vec<String> {
        let Ok(scene) = &self.scene else { return Vec::new() };
        let mut out: Vec<String> = scene.changes.iter().map(|change| change.message.clone()).collect();
        if self.is_rewritten() {
            out.push(format!("`{LAYOUT}` was edited"));
        }
        out
    }

    /// Files beside the scene itself, of which nothing can be taken over.
    fn beside(&self) -> Vec<String> {
        let is_scene = |file: &Path| file.extension().is_some_and(|e| e == "unity") || file == self.path.join(LAYOUT);
        let others = self.edited.iter().filter(|file| **file != self.path && !is_scene(file));
        let mut out: Vec<String> = others.map(|file| relative(file, &self.path)).collect();
        let more = out.len().saturating_sub(NAMED);
        out.truncate(NAMED);
        out.iter_mut()
            .for_each(|file| *file = format!("`{file}` was edited as well and will be overwritten regardless"));
        if more > 0 {
            let [files, were] = if more == 1 { ["file", "was"] } else { ["files", "were"] };
            out.push(format!("{more} more {files} {were} edited as well"));
        }
        out
    }

    /// What is known of the edit, for people.
    fn words(&self) -> Vec<String> {
        if let Err(why) = &self.scene {
            return vec![format!("{why}, so its edits cannot be used")];
        }
        let mut out = self.changes();
        let more = out.len().saturating_sub(LISTED);
        out.truncate(LISTED);
        if more > 0 {
            out.push(format!("and {more} more changes"));
        }
        if out.is_empty() {
            out.push("another program has saved it; nothing was moved, added or removed".to_owned());
        }
        out.extend(self.beside());
        out
    }

    fn tell(&self, done: &str) {
        self.words().iter().for_each(|line| eprintln!("note: {done} {}: {}", self.name, plain::line(line)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn a_file_belongs_to_the_scene_that_it_is_in() {
        let folder = tempfile::tempdir().unwrap();
        let at = |path: &str| folder.path().join(path);
        for made in ["unity/Assets/Models", "unity/ProjectSettings", "other"] {
            fs::create_dir_all(at(made)).unwrap();
        }
        for (file, scene) in [
            ("room.glb", Some("room.glb")),
            ("unity/Assets/x.unity", Some("unity")),
            ("unity/Assets/Models/sofa.glb", Some("unity")),
            ("other/x.json", None),
            ("plan.svg", None),
        ] {
            assert_eq!(scene_of(&at(file), folder.path()), scene.map(at), "{file}");
        }
    }
}
