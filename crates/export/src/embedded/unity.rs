//! The scene in a Unity project: program and layout as text assets, objects by the script that each of them carries. Poses
//! are those in relation to the root of the scene, so that all of it may stand anywhere.

use super::documents::{UnityDocument, documents};
use super::prefab::{Expanded, Prefabs};
use super::stand::{FramePose, Standing, UNREADABLE, transform};
use super::{Embedded, embedded, nothing};
use nalgebra::Matrix4;
use scenelang_base::{Diagnostic, codes};
use scenelang_lang::sources::Loader;
use scenelang_layout::file::decode;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

pub(super) const GAME_OBJECT: u32 = 1;
pub(super) const TRANSFORM: u32 = 4;
pub(super) const MESH_FILTER: u32 = 33;
pub(super) const MONO_BEHAVIOUR: u32 = 114;
/// Below this game object is the building, below that one the objects.
const BUILDING: &str = "Building";
const OBJECTS: &str = "Objects";
/// Game objects that are deeper than this are not looked at.
const DEEPEST: usize = 64;
/// So many files of a project are asked whether they are a scene, and so many scenes are read that no list has.
const MOST_FILES: usize = 100_000;
const MOST_SCENES: usize = 64;
/// What our script at the root of a scene calls the sum of its layout.
const LAYOUT_SUM: &str = "layoutSha256";

/// Reads a project.
pub(super) fn read(name: &str, path: &Path, loader: &dyn Loader) -> Result<Embedded, Box<Diagnostic>> {
    let text = |file: &str| loader.load(&path.join(file)).ok().map(decode).transpose();
    let own = |file: &str| text(&format!("Assets/Scenelang/{file}"));
    let (spec, layout) = (own("spec.scene.txt")?, own("layout.json")?);
    let (Some(spec), Some(layout)) = (spec, layout) else {
        return Err(nothing(format!("{name} is a Unity project without an embedded program and layout")));
    };
    let imports = own("imports.json")?.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default();
    let file = "Assets/Scenelang/layout.json";
    let found = embedded(format!("{name}/{file}"), path.join(file), &layout, &spec, &imports);
    let mut scenes = scenes(&text("ProjectSettings/EditorBuildSettings.asset")?.unwrap_or_default());
    let listed = scenes.len();
    // A scene that was renamed, or saved under another name, is in no list.
    let more: Vec<String> = below(path).into_iter().filter(|scene| !scenes.contains(scene)).collect();
    scenes.extend(more);
    let mut own = Vec::new();
    for (i, scene) in scenes.into_iter().enumerate() {
        // In a listed one our script may also be in a prefab.
        let Some(text) = text(&scene)?.filter(|text| i < listed || text.contains(LAYOUT_SUM)) else { continue };
        let things = Things::new(Prefabs::new(path, loader).expand(documents(&text)));
        if let (Some(standing), Some(of)) = (things.standing(), things.layout_sum()) {
            own.push((scene, standing, of));
        }
    }
    let Some((scene, standing, _)) = own.iter().find(|(.., of)| *of == sum(&layout)) else {
        // Whoever has edited the layout itself wants that judged.
        let why = format!("none of the scenes of {name} has the object with the script that scenelang writes");
        return Ok(if own.is_empty() { found.unread(why) } else { found });
    };
    let mut updated = found.clone().updated(standing);
    for (other, standing, _) in own.iter().filter(|(other, ..)| other != scene) {
        if !found.clone().updated(standing).changes.is_empty() {
            let message = format!("`{other}` is another scene of this layout, and was edited; `{scene}` is checked");
            updated.changes.push(Diagnostic::without_place(codes::W0504, message));
        }
    }
    Ok(updated)
}

/// The scenes below the assets of a project, by name. Links are not followed.
fn below(project: &Path) -> Vec<String> {
    let mut folders = vec![project.join("Assets")];
    let (mut found, mut seen) = (Vec::new(), 0);
    while let Some(folder) = folders.pop() {
        let entries = folder.read_dir().into_iter().flatten().flatten().take(MOST_FILES - seen);
        for entry in entries.inspect(|_| seen += 1) {
            let path = entry.path();
            if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == "unity") {
                found
                    .extend(path.strip_prefix(project).ok().and_then(Path::to_str).map(|path| path.replace('\\', "/")));
            }
        }
    }
    found.sort();
    found.truncate(MOST_SCENES);
    found
}

/// The scenes that a project is built of.
fn scenes(settings: &str) -> Vec<String> {
    let paths = settings.lines().filter_map(|line| line.trim().trim_start_matches("- ").strip_prefix("path: "));
    // A path that leads out of the project is none of its scenes; the door refuses it, too.
    paths.map(|path| path.trim_matches(['"', '\'']).to_owned()).filter(|p| p.starts_with("Assets/")).collect()
}

fn sum(text: &str) -> String {
    Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The documents of a scene, by what they refer to.
struct Things {
    all: Vec<UnityDocument>,
    /// By anchor of a game object: its transform.
    transforms: BTreeMap<i64, usize>,
    by_anchor: BTreeMap<i64, usize>,
    /// Game objects that are roots of prefabs without an object of ours.
    foreign: BTreeSet<i64>,
}

impl Things {
    fn new(Expanded { documents: all, foreign, .. }: Expanded) -> Self {
        let owner = |d: &UnityDocument| d.reference("m_GameObject");
        let of = |class: u32| all.iter().enumerate().filter(move |(_, d)| d.class == class);
        let transforms = of(TRANSFORM).filter_map(|(i, d)| Some((owner(d)?, i))).collect();
        let by_anchor = all.iter().enumerate().map(|(i, d)| (d.anchor, i)).collect();
        Self { transforms, by_anchor, foreign, all }
    }

    /// The script of a scene of ours.
    fn root(&self) -> Option<&UnityDocument> {
        self.all.iter().find(|d| d.class == MONO_BEHAVIOUR && d.text(LAYOUT_SUM).is_some())
    }

    /// The sum of the layout that the scene was written with.
    fn layout_sum(&self) -> Option<String> {
        self.root()?.text(LAYOUT_SUM)
    }

    fn get(&self, anchor: i64) -> Option<&UnityDocument> {
        self.by_anchor.get(&anchor).map(|&i| &self.all[i])
    }

    fn name(&self, object: i64) -> String {
        self.get(object).and_then(|d| d.text("m_Name")).unwrap_or_default()
    }

    fn father(&self, transform: &UnityDocument) -> Option<&UnityDocument> {
        transform.reference("m_Father").and_then(|id| self.get(id))
    }

    /// Everything that one sees; `None`: there is no scene of ours.
    fn standing(&self) -> Option<Vec<Standing>> {
        let root = self.root()?.reference("m_GameObject")?;
        let scripts = self.all.iter().filter(|d| d.class == MONO_BEHAVIOUR);
        let ids: BTreeMap<i64, String> =
            scripts.filter_map(|d| Some((d.reference("m_GameObject")?, d.told_id()?))).collect();
        let seen: BTreeSet<i64> =
            self.all.iter().filter(|d| d.class == MESH_FILTER).filter_map(|d| d.reference("m_GameObject")).collect();
        let mut out = Vec::new();
        for object in self.all.iter().filter(|d| d.class == GAME_OBJECT) {
            let id = ids.get(&object.anchor);
            let is_seen = seen.contains(&object.anchor) || self.foreign.contains(&object.anchor);
            let Some(&transform) = self.transforms.get(&object.anchor) else { continue };
            if id.is_none() && !is_seen || object.text("m_IsActive").as_deref() == Some("0") {
                continue;
            }
            let above = self.above(&self.all[transform]);
            let names: Vec<String> = above.iter().take_while(|o| **o != root).map(|o| self.name(*o)).collect();
            let own = self.name(object.anchor);
            let is_building = names.iter().any(|name| name == BUILDING);
            // What hangs on one of our objects belongs to it, and what is in a prefab of others to that. Somebody may have made
            // a prefab of the building.
            let belongs = |o: &i64| ids.contains_key(o) || self.foreign.contains(o) && self.name(*o) != BUILDING;
            let is_group = !seen.contains(&object.anchor) && own == BUILDING;
            if id.is_none() && (is_group || above.iter().any(belongs)) {
                continue;
            }
            let father = names.first().filter(|name| id.is_some() && *name != OBJECTS);
            let lost = id.is_some() && names.is_empty();
            out.push(Standing {
                id: id.cloned(),
                name: own,
                parent: father.cloned().or_else(|| lost.then(|| "the scene".to_owned())),
                is_building,
                place: self.within(&self.all[transform], root).ok_or(UNREADABLE).and_then(|m| FramePose::of(&m)),
            });
        }
        Some(out)
    }

    /// The game objects above a transform, nearest first.
    fn above(&self, transform: &UnityDocument) -> Vec<i64> {
        let mut found = Vec::new();
        let mut at = self.father(transform);
        while let Some(father) = at.filter(|_| found.len() < DEEPEST) {
            found.extend(father.reference("m_GameObject"));
            at = self.father(father);
        }
        found
    }

    /// A transform in relation to that of a game object above it, or to the world where that is not above it.
    fn within(&self, transform: &UnityDocument, root: i64) -> Option<Matrix4<f64>> {
        let mut found = local(transform)?;
        let mut at = self.father(transform);
        for _ in 0..DEEPEST {
            let Some(father) = at.filter(|d| d.reference("m_GameObject") != Some(root)) else { return Some(found) };
            found = local(father)? * found;
            at = self.father(father);
        }
        None
    }
}

fn local(document: &UnityDocument) -> Option<Matrix4<f64>> {
    let xyz = ["x", "y", "z"];
    let pos = document.numbers("m_LocalPosition", xyz)?;
    let rot = document.numbers("m_LocalRotation", ["x", "y", "z", "w"])?;
    Some(transform(pos, rot, document.numbers("m_LocalScale", xyz).unwrap_or([1.0; 3])))
}

#[cfg(test)]
mod tests {
    use super::super::{Carrier, read};
    use crate::Exporter;
    use crate::physics::fixture::cupboard;
    use crate::unity::Unity;
    use scenelang_lang::sources::Loader;
    use std::collections::BTreeMap;
    use std::io;
    use std::path::{Path, PathBuf};

    struct Files(BTreeMap<PathBuf, String>);

    impl Loader for Files {
        fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
            self.0.get(path).map(|text| text.clone().into_bytes()).ok_or_else(|| io::ErrorKind::NotFound.into())
        }
    }

    /// What is said of the cupboard after an edit of the scene file, and whether its layout is still the exported one.
    fn after(edit: impl Fn(String) -> String) -> (Vec<String>, bool) {
        let text = |path: &Path, bytes: &[u8]| {
            let text = String::from_utf8_lossy(bytes).into_owned();
            if path.ends_with("room.unity") { edit(text) } else { text }
        };
        let files = Unity::default().files(&cupboard()).unwrap();
        let files = Files(files.into_iter().map(|f| (f.path.clone(), text(&f.path, &f.bytes))).collect());
        let found = read("unity", Path::new("unity"), Carrier::Unity, &files).unwrap();
        let said = found.changes.iter().map(|change| change.message.clone()).collect();
        (said, found.layout == found.exported)
    }

    /// Moves the game object of a name.
    fn moved(text: &str, name: &str) -> String {
        let at = text.find(&format!("m_Name: {name}\n")).unwrap();
        let from = at + text[at..].find("m_LocalPosition: {").unwrap();
        let to = from + text[from..].find('\n').unwrap();
        format!("{}m_LocalPosition: {{x: 0.1, y: 0, z: 0.5}}{}", &text[..from], &text[to..])
    }

    #[test]
    fn an_opened_drawer_is_no_change_of_its_cupboard() {
        assert_eq!(after(|text| text), (Vec::new(), true));
        assert_eq!(after(|text| moved(&text, "drawer")), (Vec::new(), true));
        let (said, same) = after(|text| moved(&text, "cupboard"));
        assert!(said.len() == 1 && said[0].starts_with("`cupboard` was moved by") && !same, "{said:?}");
    }
}
