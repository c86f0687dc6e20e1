//! Prefabs: objects that look the same, are made of the same parts and weigh the same are instances of one. An object like no
//! other stands in the scene itself.
//!
//! A prefab says nothing of any single object, not even of the first: its script is empty, and each instance fills it in. So
//! its bytes stay the same when one of the objects is painted, moved or taken away.

use super::object::{key, told};
use super::scene::Writer;
use super::tree::{Change, Child, GameObject, Instance, pose, prefab_file};
use super::yaml::Yaml;
use crate::names::Stems;
use crate::physics::piece_name;
use crate::scene::Object;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Fewer objects than this share nothing.
const SHARED: usize = 2;
/// Letters of a category that a file is called by; it may be any text.
const LONGEST: usize = 40;

/// A prefab that was written.
struct Prefab {
    guid: String,
    root: GameObject,
}

/// What objects are made of: files of meshes, and the prefab, have its name.
struct Asset {
    name: String,
    is_shared: bool,
}

impl Writer<'_> {
    /// What is below the object `Objects`, in the order of the program.
    pub fn objects(&mut self) -> Vec<Child> {
        let scene = self.scene;
        let materials = self.materials;
        let (assets, of) = assets(&scene.objects, |surface| materials[surface].name.clone());
        let mut prefabs: BTreeMap<usize, Prefab> = BTreeMap::new();
        let mut out = Vec::with_capacity(scene.objects.len());
        for (object, index) in scene.objects.iter().zip(of) {
            let asset = &assets[index];
            if !asset.is_shared {
                out.push(self.object(object, &asset.name).into());
                continue;
            }
            let prefab = prefabs.entry(index).or_insert_with(|| self.prefab(object, &asset.name));
            out.push(Child::Instance(self.instance(object, prefab)));
        }
        out
    }

    /// Writes the prefab of an object and those equal to it.
    fn prefab(&mut self, object: &Object, name: &str) -> Prefab {
        let mut root = self.bare(object, &format!("prefab:{name}"), name);
        name.clone_into(&mut root.name);
        let guid = self.project.asset(&format!("Assets/Scenelang/Prefabs/{name}.prefab"), prefab_file(&root));
        Prefab { guid, root }
    }

    fn instance(&self, object: &Object, prefab: &Prefab) -> Instance {
        let root = &prefab.root;
        let mut changes = Vec::new();
        let place = pose(object.place.pos, &object.axes);
        changed(root.transform(), &place, &[], &mut changes);
        changed(root.anchor("GameObject"), &[("m_Name".into(), object.name.as_str().into())], &[], &mut changes);
        let script = root.anchor("MonoBehaviour");
        changed(script, &told(Some((self.scene, object))), &told(None), &mut changes);
        for (joint, piece) in object.place.joints.iter().zip(pieces(root)) {
            let id = [("id".to_owned(), piece_name(&object.name, joint).as_str().into())];
            changed(piece.anchor("MonoBehaviour"), &id, &[], &mut changes);
        }
        Instance { key: key(object), guid: prefab.guid.clone(), root: root.transform(), changes }
    }
}

/// The parts of a prefab that move, in the order of its joints.
fn pieces(root: &GameObject) -> impl Iterator<Item = &GameObject> {
    root.children.iter().filter_map(|child| match child {
        Child::Node(node) if node.tag == "Part" => Some(node),
        _ => None,
    })
}

/// What an instance says otherwise, of one component: a change for each number, text and entry of a list.
fn changed(target: i64, now: &[(String, Yaml)], before: &[(String, Yaml)], into: &mut Vec<Change>) {
    let differs = |field: &&(String, Yaml)| !before.contains(field);
    let mut say = |path: String, value: Yaml| into.push(Change { target, path, value });
    for (key, value) in now.iter().filter(differs) {
        match value {
            Yaml::Flow(members) => {
                for (member, number) in members {
                    say(format!("{key}.{member}"), Yaml::Word(number.clone()));
                }
            }
            Yaml::List(entries) => {
                say(format!("{key}.Array.size"), Yaml::from(entries.len() as i64));
                for (i, entry) in entries.iter().enumerate() {
                    say(format!("{key}.Array.data[{i}]"), entry.clone());
                }
            }
            other => say(key.clone(), other.clone()),
        }
    }
}

/// The assets of some objects, and which of them each object has. One that is shared is called by what it is and a sum of what it
/// is like, so that it keeps its name, and with it its identity, whichever of its objects is painted or taken away.
fn assets(objects: &[Object], material: impl Fn(usize) -> String) -> (Vec<Asset>, Vec<usize>) {
    let likes: Vec<[u8; 32]> = objects.iter().map(|object| like(object, &material)).collect();
    let mut groups: BTreeMap<[u8; 32], Vec<usize>> = BTreeMap::new();
    for (index, like) in likes.iter().enumerate() {
        groups.entry(*like).or_default().push(index);
    }
    let (shared, single): (Vec<_>, Vec<_>) = groups.into_iter().partition(|(_, members)| members.len() >= SHARED);
    let mut stems = Stems::default();
    let mut of = vec![0; objects.len()];
    let mut found = Vec::with_capacity(shared.len() + single.len());
    // An object that stands alone has the name that it always has; its stem is taken before others may ask for it.
    for (like, members) in single.into_iter().chain(shared) {
        let (first, is_shared) = (&objects[members[0]], members.len() >= SHARED);
        let name = if is_shared {
            let kind: String = kind(objects, &members).chars().take(LONGEST).collect();
            format!("{kind}-{:02x}{:02x}{:02x}", like[0], like[1], like[2])
        } else {
            first.stem.clone()
        };
        members.iter().for_each(|&member| of[member] = found.len());
        found.push(Asset { name: stems.take(&name), is_shared });
    }
    (found, of)
}

/// What objects are, in a word that can be part of a file's name: their category, or what draws them.
fn kind<'a>(objects: &'a [Object], members: &[usize]) -> &'a str {
    let first = &objects[members[0]];
    let is_common = members.iter().all(|&member| objects[member].category == first.category);
    let is_plain = first.category.chars().any(|c| c.is_ascii_alphanumeric());
    if is_common && is_plain { &first.category } else { &first.family }
}

/// A sum of all that a prefab holds of an object: of what is the same for all that differ only in where they are and in what
/// the program says of them.
fn like(object: &Object, material: impl Fn(usize) -> String) -> [u8; 32] {
    let place = &object.place;
    // Their text has each of their numbers, to the last digit.
    let mut bytes = format!("{} {:?} {:?} {:?}\n", object.family, object.body, place.parts, place.joints).into_bytes();
    let doubles = place.scale.iter().chain(&object.weights);
    doubles.for_each(|v| bytes.extend(v.to_le_bytes()));
    for light in &object.lights {
        light.pos.iter().chain(&[light.lumens]).for_each(|v| bytes.extend(v.to_le_bytes()));
        light.color.iter().for_each(|v| bytes.extend(v.to_le_bytes()));
    }
    for group in &object.mesh {
        bytes.extend(
            format!("\n{} {} {}\n", material(group.surface), group.positions.len(), group.indices.len()).into_bytes(),
        );
        let floats = group.positions.iter().chain(&group.normals).flatten().chain(group.uvs.iter().flatten());
        floats.for_each(|v| bytes.extend(v.to_le_bytes()));
        group.indices.iter().for_each(|v| bytes.extend(v.to_le_bytes()));
    }
    Sha256::digest(&bytes).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Exporter;
    use crate::physics::fixture::cupboard;
    use crate::unity::Unity;
    use nalgebra::Matrix3;
    use scenelang_layout::Vec3;

    /// Cupboards of these names and colours.
    fn cupboards(painted: &[(&str, usize)]) -> Vec<Object> {
        let original = cupboard().objects.remove(0);
        let copy = |&(name, surface): &(&str, usize)| {
            let mut object = original.clone();
            name.clone_into(&mut object.name);
            object.stem = name.replace('[', "_").replace(']', "");
            object.mesh[0].surface = surface;
            object
        };
        painted.iter().map(copy).collect()
    }

    fn like(object: &Object) -> [u8; 32] {
        super::like(object, |surface| surface.to_string())
    }

    /// The names of their assets.
    fn names(painted: &[(&str, usize)]) -> Vec<String> {
        let (assets, of) = assets(&cupboards(painted), |surface| surface.to_string());
        let name = |&index: &usize| {
            let asset = &assets[index];
            assert_eq!(asset.is_shared, of.iter().filter(|other| **other == index).count() > 1);
            asset.name.clone()
        };
        of.iter().map(name).collect()
    }

    #[test]
    fn an_asset_keeps_its_name_while_others_are_painted() {
        let of = |colors: [usize; 4]| {
            let objects: Vec<String> = (0..4).map(|i| format!("box[{i}]")).collect();
            names(&objects.iter().map(String::as_str).zip(colors).collect::<Vec<_>>())
        };
        let all = of([0; 4]);
        assert!(all[0].starts_with("cupboard-") && all.iter().all(|name| *name == all[0]), "{all:?}");
        for single in 0..4 {
            let mut colors = [0; 4];
            colors[single] = 7;
            for (i, name) in of(colors).iter().enumerate() {
                assert_eq!(*name, if i == single { format!("box_{i}") } else { all[0].clone() });
            }
        }
        let halves = of([7, 7, 0, 0]);
        assert!(halves[0] == halves[1] && halves[0] != all[0] && halves[2..] == all[2..], "{halves:?}");
        assert_eq!(of([7, 8, 9, 0]), ["box_0", "box_1", "box_2", "box_3"]);
    }

    #[test]
    fn an_asset_is_called_by_the_category_of_its_objects() {
        let name = |categories: [&str; 2]| {
            let mut objects = cupboards(&[("a", 0), ("b", 0)]);
            objects.iter_mut().zip(categories).for_each(|(object, category)| category.clone_into(&mut object.category));
            let (assets, _) = assets(&objects, |surface| surface.to_string());
            assets[0].name.split('-').next().unwrap().to_owned()
        };
        assert_eq!(name(["filing cabinet"; 2]), "filing_cabinet");
        let long = "x".repeat(500);
        assert_eq!(name([&long, &long]).len(), LONGEST);
        // They have nothing in common but how they look.
        for others in [["wardrobe", "locker"], ["灯"; 2], [""; 2]] {
            assert_eq!(name(others), cupboard().objects[0].family);
        }
    }

    #[test]
    fn an_object_has_its_own_name_though_an_asset_is_called_like_it() {
        let shared = names(&[("a", 0), ("b", 0)]).remove(0);
        let found = names(&[("a", 0), ("b", 0), (&shared, 7)]);
        assert_eq!(found, [format!("{shared}-2"), format!("{shared}-2"), shared]);
    }

    #[test]
    fn what_is_made_otherwise_is_another_asset() {
        let objects = cupboards(&[("a", 0), ("b", 0)]);
        assert_eq!(like(&objects[0]), like(&objects[1]));
        let differ: [fn(&mut Object); 8] = [
            |o| o.place.scale.x += 1e-9,
            |o| o.place.joints[0].limits[1] = 90.0,
            |o| o.weights[0] += 1.0,
            |o| o.mesh[0].positions[0][0] += 1e-6,
            |o| o.mesh[0].surface += 1,
            |o| o.body = crate::scene::Body::Held,
            |o| drop(o.place.parts.pop()),
            |o| o.lights.push(scenelang_assets::Light { pos: Vec3::zeros(), color: [1.0; 3], lumens: 400.0 }),
        ];
        for change in differ {
            let mut other = objects[1].clone();
            change(&mut other);
            assert_ne!(like(&objects[0]), like(&other));
        }
        let mut elsewhere = objects[1].clone();
        (elsewhere.place.pos, elsewhere.axes) = (Vec3::new(3.0, 0.0, 1.0), Matrix3::identity());
        "other".clone_into(&mut elsewhere.category);
        assert_eq!(like(&objects[0]), like(&elsewhere));
    }

    #[test]
    fn what_opens_in_a_prefab_hangs_on_the_prefab() {
        let mut scene = cupboard();
        scene.objects = cupboards(&[("box[0]", 0), ("box[1]", 0)]);
        scene.objects[1].place.pos.x = 3.0;
        let files = Unity::default().files(&scene).unwrap();
        let texts = |end: &str| -> Vec<&str> {
            let files = files.iter().filter(|f| f.path.to_str().unwrap().ends_with(end));
            files.map(|f| std::str::from_utf8(&f.bytes).unwrap()).collect()
        };
        let ([prefab], [scene]) = (&texts(".prefab")[..], &texts(".unity")[..]) else { panic!("one of each") };
        assert_eq!([1001, 59, 153].map(|class| scene.matches(&format!("--- !u!{class} ")).count()), [2, 0, 0]);
        assert_eq!([54, 59, 153].map(|class| prefab.matches(&format!("--- !u!{class} ")).count()), [3, 1, 1]);
        let base = prefab.split("--- !u!54 &").nth(1).unwrap().split('\n').next().unwrap();
        assert_eq!(prefab.matches(&format!("m_ConnectedBody: {{fileID: {base}}}\n")).count(), 2);
        // Nothing in it is of one of the two.
        assert!(!prefab.contains("box[") && prefab.contains("  id: \"/door\"\n"), "{prefab}");
        for door in ["box[0]/door", "box[0]/drawer", "box[1]/door", "box[1]/drawer"] {
            assert!(scene.contains(&format!("      propertyPath: id\n      value: \"{door}\"\n")), "{door}");
        }
        let meshes = files
            .iter()
            .filter(|f| f.path.to_str().unwrap().contains("/Objects/") && f.path.extension().unwrap() == "obj");
        assert_eq!(meshes.count(), 3, "the case, the door and the drawer");
    }
}
