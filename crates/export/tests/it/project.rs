//! Unity projects, and edits of them as an editor makes them: by text, without what reads them.

use scenelang_base::door::Door;
use scenelang_export::embedded::{self, Carrier, Embedded};
use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A project.
pub struct Project {
    folder: PathBuf,
}

/// The text of a file of documents.
pub struct Text(pub String);

impl Project {
    pub fn at(folder: &Path) -> Self {
        Self { folder: folder.to_path_buf() }
    }

    pub fn file(&self, path: &str) -> PathBuf {
        self.folder.join(path)
    }

    /// Changes the scene.
    pub fn edit(&self, change: impl FnOnce(&mut Text)) {
        self.change("Assets/Scenes/room.unity", change);
    }

    pub fn change(&self, path: &str, change: impl FnOnce(&mut Text)) {
        let path = self.file(path);
        let mut text = Text(fs::read_to_string(&path).unwrap());
        change(&mut text);
        fs::write(path, text.0).unwrap();
    }

    /// Adds a prefab that somebody has made.
    pub fn prefab(&self, name: &str, guid: &str, text: &str) {
        let folder = self.file("Assets/Mine");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join(format!("{name}.prefab")), text).unwrap();
        fs::write(folder.join(format!("{name}.prefab.meta")), format!("fileFormatVersion: 2\nguid: {guid}\n")).unwrap();
    }

    /// The prefab of the chairs, without its extension: the only one of the fixture.
    pub fn chair(&self) -> String {
        let folder = "Assets/Scenelang/Prefabs";
        let names =
            fs::read_dir(self.file(folder)).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let names: Vec<String> = names.filter_map(|name| Some(name.strip_suffix(".prefab")?.to_owned())).collect();
        let [name] = &names[..] else { panic!("{names:?}") };
        format!("{folder}/{name}")
    }

    pub fn read(&self) -> Embedded {
        embedded::read("it", &self.folder, Carrier::Unity, &Door::of(&self.folder)).unwrap()
    }
}

impl Text {
    /// The document that has a line.
    pub fn document(&self, class: u32, line: &str) -> Option<Range<usize>> {
        let header = format!("--- !u!{class} ");
        self.0.match_indices(&header).find_map(|(begin, _)| {
            let end = self.0[begin + 4..].find("\n--- ").map_or(self.0.len(), |at| begin + 4 + at + 1);
            self.0[begin..end].contains(line).then_some(begin..end)
        })
    }

    /// The instance of a name.
    pub fn instance(&self, name: &str) -> Option<Range<usize>> {
        let named = |quote: &str| format!("propertyPath: m_Name\n      value: {quote}{name}{quote}\n");
        self.document(1001, &named("\"")).or_else(|| self.document(1001, &named("")))
    }

    /// The game object of a name.
    pub fn object(&self, name: &str) -> Range<usize> {
        let object = self.document(1, &format!("  m_Name: {name}\n"));
        object.or_else(|| self.document(1, &format!("  m_Name: \"{name}\"\n"))).unwrap()
    }

    pub fn anchor(&self, document: &Range<usize>) -> i64 {
        let header = self.0[document.clone()].lines().next().unwrap();
        header.split('&').nth(1).unwrap().split(' ').next().unwrap().parse().unwrap()
    }

    /// The transform of a game object, or what stands for that of an instance.
    pub fn transform(&self, name: &str) -> Range<usize> {
        let line = match self.instance(name) {
            Some(instance) => format!("  m_PrefabInstance: {{fileID: {}}}\n", self.anchor(&instance)),
            None => format!("  m_GameObject: {{fileID: {}}}\n", self.anchor(&self.object(name))),
        };
        self.document(4, &line).unwrap()
    }

    /// Changes a line of a document, from a key on.
    pub fn line(&mut self, document: &Range<usize>, key: &str, line: &str) {
        let begin = document.start + self.0[document.clone()].find(key).unwrap();
        let end = begin + self.0[begin..].find('\n').unwrap();
        self.0.replace_range(begin..end, line);
    }

    /// Changes a field of an instance, as the editor does: the change that there is, or one more.
    pub fn set(&mut self, name: &str, path: &str, value: &str) {
        let instance = self.instance(name).unwrap();
        let found = format!("propertyPath: {path}\n      value: ");
        if let Some(at) = self.0[instance.clone()].find(&found) {
            let begin = instance.start + at + found.len();
            let end = begin + self.0[begin..].find('\n').unwrap();
            return self.0.replace_range(begin..end, value);
        }
        // The root's game object has the name, its transform the position.
        let beside = if path.starts_with("m_Local") { "m_LocalPosition.x" } else { "m_Name" };
        let at = self.0[instance.clone()].find(&format!("propertyPath: {beside}\n")).unwrap() + instance.start;
        let begin = self.0[..at].rfind("    - target:").unwrap();
        let target = self.0[begin..at].to_owned();
        self.0.insert_str(
            begin,
            &format!("{target}propertyPath: {path}\n      value: {value}\n      objectReference: {{fileID: 0}}\n"),
        );
    }

    /// Puts a thing elsewhere, and turns it.
    pub fn put(&mut self, name: &str, pos: [f64; 3], rot: [f64; 4]) {
        if self.instance(name).is_some() {
            for (axis, value) in ["x", "y", "z"].iter().zip(pos) {
                self.set(name, &format!("m_LocalPosition.{axis}"), &value.to_string());
            }
            for (axis, value) in ["x", "y", "z", "w"].iter().zip(rot) {
                self.set(name, &format!("m_LocalRotation.{axis}"), &value.to_string());
            }
            return;
        }
        let ([x, y, z], [i, j, k, w]) = (pos, rot);
        let transform = self.transform(name);
        self.line(&transform, "m_LocalPosition:", &format!("m_LocalPosition: {{x: {x}, y: {y}, z: {z}}}"));
        let transform = self.transform(name);
        self.line(&transform, "m_LocalRotation:", &format!("m_LocalRotation: {{x: {i}, y: {j}, z: {k}, w: {w}}}"));
    }

    pub fn rename(&mut self, name: &str, to: &str) {
        if self.instance(name).is_some() {
            return self.set(name, "m_Name", to);
        }
        let object = self.object(name);
        self.line(&object, "m_Name:", &format!("m_Name: {to}"));
    }

    pub fn switch_off(&mut self, name: &str) {
        if self.instance(name).is_some() {
            return self.set(name, "m_IsActive", "0");
        }
        let object = self.object(name);
        self.line(&object, "m_IsActive:", "m_IsActive: 0");
    }

    pub fn scale(&mut self, name: &str, [x, y, z]: [f64; 3]) {
        if self.instance(name).is_some() {
            for (axis, value) in [("x", x), ("y", y), ("z", z)] {
                self.set(name, &format!("m_LocalScale.{axis}"), &value.to_string());
            }
            return;
        }
        let transform = self.transform(name);
        self.line(&transform, "m_LocalScale:", &format!("m_LocalScale: {{x: {x}, y: {y}, z: {z}}}"));
    }

    /// Takes an instance away, and what stands for it.
    pub fn delete(&mut self, name: &str) {
        let transform = self.transform(name);
        self.0.replace_range(transform, "");
        let instance = self.instance(name).unwrap();
        self.0.replace_range(instance, "");
    }

    /// Copies an instance, as the editor does.
    pub fn duplicate(&mut self, name: &str, to: &str) {
        let (instance, transform) = (self.instance(name).unwrap(), self.transform(name));
        let (own, stands) = (self.anchor(&instance).to_string(), self.anchor(&transform).to_string());
        let copy =
            format!("{}{}", &self.0[instance], &self.0[transform]).replace(&own, "77001").replace(&stands, "77002");
        let at = self.document(1_660_057_539, "SceneRoots").unwrap().start;
        let copy = copy.replacen(&format!("value: \"{name}\""), &format!("value: \"{to}\""), 1);
        self.0.insert_str(at, &copy);
    }

    /// Puts a thing below another, where it keeps its own numbers.
    pub fn reparent(&mut self, name: &str, to: Option<&str>) {
        let father = to.map_or(0, |to| self.anchor(&self.transform(to)));
        let (document, key) = match self.instance(name) {
            Some(instance) => (instance, "m_TransformParent"),
            None => (self.transform(name), "m_Father"),
        };
        self.line(&document, key, &format!("{key}: {{fileID: {father}}}"));
    }
}

/// A change of an instance in the list of what it does not have, or has besides.
pub fn listed(scene: &mut Text, name: &str, list: &str, entry: &str) {
    let instance = scene.instance(name).unwrap();
    scene.line(&instance, &format!("{list}: []"), &format!("{list}:\n    - {entry}"));
}

/// Where the prefab of the chairs is, its GUID, and the anchor of the document of a class in it.
pub fn chair(project: &Project, class: u32) -> (String, i64) {
    let path = project.file(&project.chair());
    let meta = fs::read_to_string(path.with_extension("prefab.meta")).unwrap();
    let guid = meta.lines().find_map(|line| line.strip_prefix("guid: ")).unwrap().to_owned();
    let prefab = Text(fs::read_to_string(path.with_extension("prefab")).unwrap());
    let document = prefab.document(class, "").unwrap();
    (guid, prefab.anchor(&document))
}

/// An instance of some prefab below a transform.
pub fn put_in(scene: &mut Text, guid: &str, father: &str, changes: &str) {
    let father = scene.anchor(&scene.transform(father));
    let at = scene.document(1_660_057_539, "SceneRoots").unwrap().start;
    let list = if changes.is_empty() {
        "    m_Modifications: []".to_owned()
    } else {
        format!("    m_Modifications:{changes}")
    };
    scene.0.insert_str(
        at,
        &format!(
            "--- !u!1001 &88001\nPrefabInstance:\n  m_ObjectHideFlags: 0\n  serializedVersion: 2\n  m_Modification:\n    \
             serializedVersion: 3\n    m_TransformParent: {{fileID: {father}}}\n{list}\n    m_RemovedComponents: []\n    \
             m_RemovedGameObjects: []\n    m_AddedGameObjects: []\n    m_AddedComponents: []\n  m_SourcePrefab: {{fileID: \
             100100000, guid: {guid}, type: 3}}\n"
        ),
    );
}

pub fn change(target: i64, guid: &str, path: &str, value: &str) -> String {
    format!(
        "\n    - target: {{fileID: {target}, guid: {guid},\n        type: 3}}\n      propertyPath: {path}\n      value: {value}\n      \
         objectReference: {{fileID: 0}}"
    )
}

/// The scene without its settings, as a prefab.
pub fn as_prefab(scene: &Text) -> String {
    let documents = scene
        .0
        .split("--- !u!")
        .filter(|d| !["29 ", "104 ", "157 ", "196 ", "1660057539 "].iter().any(|c| d.starts_with(c)));
    documents.collect::<Vec<_>>().join("--- !u!")
}

/// As an editor writes an instance out in the scene.
pub fn unpacked(scene: &mut Text, name: &str, prefab: &str) {
    let (instance, transform) = (scene.instance(name).unwrap(), scene.transform(name));
    let (father, block) = (scene.anchor(&scene.transform("Objects")), scene.0[instance].to_owned());
    let mut told = BTreeMap::new();
    for part in block.split("    - target: {fileID: ").skip(1) {
        let target: i64 = part.split(',').next().unwrap().parse().unwrap();
        let field = |key: &str| part.split(&format!("{key}: ")).nth(1).unwrap().lines().next().unwrap().to_owned();
        told.insert((target, field("propertyPath")), field("value"));
    }
    let text = Text(prefab.split_once("--- !u!").map(|(_, text)| format!("--- !u!{text}")).unwrap());
    let root = text.anchor(&text.document(4, "m_Father: {fileID: 0}").unwrap());
    let object = text.anchor(&text.document(1, &format!("component: {{fileID: {root}}}")).unwrap());
    let script = text.anchor(&text.document(114, "declaration:").unwrap());
    let of = |id: i64, path: &str| told[&(id, path.to_owned())].clone();
    let vector = |path: &str, axes: &[&str]| {
        let numbers: Vec<String> =
            axes.iter().map(|axis| format!("{axis}: {}", of(root, &format!("{path}.{axis}")))).collect();
        format!("{path}: {{{}}}", numbers.join(", "))
    };
    let mut text = text;
    let place = |text: &Text| text.document(4, "m_Father: {fileID: 0}").unwrap();
    for (key, line) in [
        ("m_LocalPosition:", vector("m_LocalPosition", &["x", "y", "z"])),
        ("m_LocalRotation:", vector("m_LocalRotation", &["x", "y", "z", "w"])),
        ("m_Father:", format!("m_Father: {{fileID: {father}}}")),
    ] {
        let document = place(&text);
        text.line(&document, key, &line);
    }
    let document = text.document(1, &format!("component: {{fileID: {root}}}")).unwrap();
    text.line(&document, "m_Name:", &format!("m_Name: {}", of(object, "m_Name")));
    let document = text.document(114, "declaration:").unwrap();
    text.line(&document, "id:", &format!("id: {}", of(script, "id")));
    // Others than in the prefab, and than in another instance.
    let stands = scene.anchor(&transform);
    let anchors: Vec<String> =
        text.0.split(" &").skip(1).map(|part| part.split('\n').next().unwrap().to_owned()).collect();
    for (i, anchor) in anchors.iter().enumerate() {
        text.0 = text.0.replace(anchor, &format!("{}", (stands >> 8) + i as i64));
    }
    scene.delete(name);
    let at = scene.document(1_660_057_539, "SceneRoots").unwrap().start;
    scene.0.insert_str(at, &text.0);
}
