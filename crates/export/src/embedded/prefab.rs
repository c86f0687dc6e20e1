//! Instances of prefabs in a Unity scene, put in among its documents as if they had been written out: those of the exporter,
//! those that somebody made of parts of the scene, and those that have others in them.
//!
//! An instance is the prefab's documents with some fields changed and some documents left out. An object of it has the anchor
//! that Unity gives it, which is made of that of the instance and its own; documents that only stand for one (`stripped`) lead
//! there. What cannot be read of a prefab (a model file, one that is missing) is known by the changes alone.

use super::documents::{Node, UnityDocument, documents};
use super::unity::{GAME_OBJECT, MESH_FILTER, MONO_BEHAVIOUR, TRANSFORM};
use scenelang_lang::sources::Loader;
use scenelang_layout::file::decode;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::rc::Rc;

const PREFAB_INSTANCE: u32 = 1001;
/// Where the exporter writes prefabs.
const OWN: &str = "Assets/Scenelang/Prefabs";
/// Prefabs that are deeper within each other are not looked at.
const DEEPEST: usize = 16;
/// So many documents of instances are put in; a few files of prefabs within prefabs could ask for any number.
const MOST: usize = 200_000;
/// So many files of a project are asked whether they are a prefab.
const FILES: usize = 100_000;

/// The documents of a file, its instances among them.
#[derive(Clone, Debug, Default)]
pub(super) struct Expanded {
    pub documents: Vec<UnityDocument>,
    /// The game objects that are roots of instances in which there is no object of ours.
    pub foreign: BTreeSet<i64>,
    /// What stands for an object of an instance: by its anchor, that of the object.
    stands_for: BTreeMap<i64, i64>,
}

/// What a scene says of an instance.
#[derive(Debug, Default)]
struct Instance {
    anchor: i64,
    /// Of the prefab.
    guid: Option<String>,
    /// The transform that it is below; 0: none.
    parent: i64,
    changes: Vec<Change>,
    /// What of the prefab it does not have.
    removed: Vec<i64>,
}

/// A field that is otherwise than in the prefab.
#[derive(Debug, Default)]
struct Change {
    target: i64,
    path: String,
    value: String,
}

/// The prefabs of a project.
pub(super) struct Prefabs<'a> {
    project: &'a Path,
    loader: &'a dyn Loader,
    /// Where they are, by GUID, as far as that has been looked up.
    paths: BTreeMap<String, PathBuf>,
    is_searched: [bool; 2],
    /// Those that have been read; `None`: they cannot be, or are being read.
    read: BTreeMap<String, Option<Rc<Expanded>>>,
    left: usize,
}

impl<'a> Prefabs<'a> {
    /// Of the project in a folder.
    pub fn new(project: &'a Path, loader: &'a dyn Loader) -> Self {
        Self { project, loader, paths: BTreeMap::new(), is_searched: [false; 2], read: BTreeMap::new(), left: MOST }
    }

    /// Puts the instances of a file in among its documents.
    pub fn expand(&mut self, all: Vec<UnityDocument>) -> Expanded {
        self.expand_within(all, 0)
    }

    fn expand_within(&mut self, all: Vec<UnityDocument>, depth: usize) -> Expanded {
        let mut out = Expanded::default();
        let (instances, own): (Vec<UnityDocument>, Vec<UnityDocument>) =
            all.into_iter().partition(|d| d.class == PREFAB_INSTANCE);
        let mut sources = BTreeMap::new();
        for instance in instances.iter().map(Instance::of) {
            let source = self.source(&instance, depth);
            out.put(&instance, &source);
            sources.insert(instance.anchor, source);
        }
        for document in own {
            if !document.is_stripped {
                out.documents.push(document);
                continue;
            }
            let instance = document.reference("m_PrefabInstance");
            let object = document.reference("m_CorrespondingSourceObject");
            if let (Some(instance), Some(object)) = (instance, object) {
                let object = sources.get(&instance).map_or(object, |source| source.meant(object));
                out.stands_for.insert(document.anchor, combined(instance, object));
            }
        }
        let meant = |id| out.stands_for.get(&id).copied().unwrap_or(id);
        out.documents.iter_mut().for_each(|document| document.refer(meant));
        out
    }

    fn source(&mut self, instance: &Instance, depth: usize) -> Rc<Expanded> {
        let found = instance.guid.as_deref().and_then(|guid| self.prefab(guid, depth));
        let found = found.filter(|source| source.documents.len() <= self.left);
        let source = found.unwrap_or_else(|| Rc::new(instance.guessed()));
        self.left = self.left.saturating_sub(source.documents.len());
        source
    }

    fn prefab(&mut self, guid: &str, depth: usize) -> Option<Rc<Expanded>> {
        if let Some(known) = self.read.get(guid) {
            return known.clone();
        }
        // One that has itself in it is not read again.
        self.read.insert(guid.to_owned(), None);
        let path = self.path(guid).filter(|_| depth < DEEPEST)?;
        let text = decode(self.loader.load(&path).ok()?).ok()?;
        let found = Rc::new(self.expand_within(documents(&text), depth + 1));
        self.read.insert(guid.to_owned(), Some(Rc::clone(&found)));
        Some(found)
    }

    fn path(&mut self, guid: &str) -> Option<PathBuf> {
        for (i, folder) in [OWN, "Assets"].into_iter().enumerate() {
            if !self.paths.contains_key(guid) && !std::mem::replace(&mut self.is_searched[i], true) {
                self.search(&self.project.join(folder));
            }
        }
        self.paths.get(guid).cloned()
    }

    /// Looks for prefabs in a folder and those below it. Links are not followed.
    fn search(&mut self, folder: &Path) {
        let mut folders = vec![folder.to_path_buf()];
        let mut seen = 0;
        while let Some(folder) = folders.pop() {
            let entries = folder.read_dir().into_iter().flatten().flatten();
            let mut found: Vec<_> = entries.take(FILES - seen).map(|entry| (entry.path(), entry.file_type())).collect();
            seen += found.len();
            found.sort_by(|a, b| b.0.cmp(&a.0));
            for (path, kind) in found {
                let name = path.to_string_lossy();
                if kind.is_ok_and(|kind| kind.is_dir()) {
                    folders.push(path);
                } else if let Some(prefab) = name.strip_suffix(".meta").filter(|name| name.ends_with(".prefab")) {
                    let text = self.loader.load(&path).ok().and_then(|bytes| decode(bytes).ok()).unwrap_or_default();
                    if let Some(guid) = text.lines().find_map(|line| line.strip_prefix("guid:")) {
                        self.paths.entry(guid.trim().to_owned()).or_insert_with(|| prefab.into());
                    }
                }
            }
        }
    }
}

impl Expanded {
    /// The object that an anchor of the file means.
    fn meant(&self, id: i64) -> i64 {
        self.stands_for.get(&id).copied().unwrap_or(id)
    }

    /// Adds the documents of an instance.
    fn put(&mut self, instance: &Instance, source: &Self) {
        let gone = source.without(instance.removed.iter().map(|id| source.meant(*id)).collect());
        let mut all: Vec<UnityDocument> =
            source.documents.iter().filter(|d| !gone.contains(&d.anchor)).cloned().collect();
        let by_anchor: BTreeMap<i64, usize> = all.iter().enumerate().map(|(i, d)| (d.anchor, i)).collect();
        for change in &instance.changes {
            if let Some(&index) = by_anchor.get(&source.meant(change.target)) {
                all[index].set(&change.path, &change.value);
            }
        }
        let within = |id| combined(instance.anchor, id);
        let is_ours = all.iter().any(|document| document.told_id().is_some());
        for document in &mut all {
            let is_root = document.class == TRANSFORM && document.reference("m_Father").is_none();
            document.anchor = within(document.anchor);
            document.refer(within);
            if is_root {
                document.refer_to("m_Father", instance.parent);
                self.foreign.extend(document.reference("m_GameObject").filter(|_| !is_ours));
            }
        }
        self.foreign.extend(source.foreign.iter().map(|id| within(*id)));
        self.documents.append(&mut all);
    }

    /// What is left out with some documents: components with their game object, and what is below it.
    fn without(&self, mut gone: BTreeSet<i64>) -> BTreeSet<i64> {
        let mut before = usize::MAX;
        while !gone.is_empty() && gone.len() != before {
            before = gone.len();
            for document in &self.documents {
                let is_gone = |key| document.reference(key).is_some_and(|id| gone.contains(&id));
                if is_gone("m_Father") {
                    gone.extend(document.reference("m_GameObject"));
                }
                if document.reference("m_GameObject").is_some_and(|id| gone.contains(&id)) {
                    gone.insert(document.anchor);
                }
            }
        }
        gone
    }
}

impl Instance {
    fn of(document: &UnityDocument) -> Self {
        let id = |node: Option<&Node>| node.and_then(Node::reference).unwrap_or_default();
        let text = |node: &Node, key: &str| node.get(key).and_then(Node::text).unwrap_or_default().to_owned();
        let change = |node: &Node| Change {
            target: id(node.get("target")),
            path: text(node, "propertyPath"),
            value: text(node, "value"),
        };
        let said = |key: &str| document.field("m_Modification").and_then(|node| node.get(key));
        let list = |key: &str| said(key).map(Node::items).unwrap_or_default();
        let removed = ["m_RemovedComponents", "m_RemovedGameObjects"];
        Self {
            anchor: document.anchor,
            guid: document.field("m_SourcePrefab").map(|node| text(node, "guid")),
            parent: id(said("m_TransformParent")),
            changes: list("m_Modifications").iter().map(change).collect(),
            removed: removed.into_iter().flat_map(list).map(|node| id(Some(node))).collect(),
        }
    }

    /// What is known of the prefab by the changes alone: one game object, whose transform is the first that is placed.
    fn guessed(&self) -> Expanded {
        let target = |path: &str| self.changes.iter().find(|c| c.path.starts_with(path)).map(|c| c.target);
        // No anchor of a file is so small.
        let object = target("m_Name").unwrap_or(i64::MIN);
        let mut all = vec![UnityDocument::new(GAME_OBJECT, object)];
        all[0].set("m_Name", "an instance of a prefab");
        let placed = target("m_LocalPosition.").unwrap_or(i64::MIN + 1);
        let components =
            [(TRANSFORM, Some(placed)), (MESH_FILTER, Some(i64::MIN + 2)), (MONO_BEHAVIOUR, target("declaration"))];
        for (class, anchor) in components {
            let Some(anchor) = anchor else { continue };
            let mut component = UnityDocument::new(class, anchor);
            component.refer_to("m_GameObject", object);
            all.push(component);
        }
        Expanded { documents: all, ..Expanded::default() }
    }
}

/// What Unity calls an object of a prefab in an instance of it.
fn combined(instance: i64, object: i64) -> i64 {
    (instance ^ object) & i64::MAX
}
