//! Game objects and their components as a tree, and the tree as documents that refer to each other.

use super::ids::anchor;
use super::yaml::{Map, Stream, Yaml, asset, local, map, none, quaternion, vector};
use crate::geometry::frame::unity_euler;
use nalgebra::Matrix3;
use scenelang_layout::{Vec3, rotation};

pub(super) struct GameObject {
    /// What its identities are made from; unique in the scene.
    pub key: String,
    /// As shown in the editor.
    pub name: String,
    /// Relative to its parent.
    pub pos: Vec3,
    /// Relative to its parent.
    pub axes: Matrix3<f64>,
    /// Besides its transform.
    pub components: Vec<Component>,
    /// Below it, in this order.
    pub children: Vec<Child>,
    /// Never moves.
    pub fixed: bool,
    /// `Untagged`, `MainCamera`, one of [`Layer::tags`].
    pub tag: &'static str,
    /// What it is on; `None`: what its parent is on.
    pub layer: Option<Layer>,
}

/// What is below a game object.
pub(super) enum Child {
    /// Another one, written out.
    Node(GameObject),
    /// An instance of a prefab.
    Instance(Instance),
}

impl From<GameObject> for Child {
    fn from(node: GameObject) -> Self {
        Self::Node(node)
    }
}

impl Child {
    fn transform(&self) -> i64 {
        match self {
            Self::Node(node) => node.transform(),
            Self::Instance(instance) => anchor(&instance.key, "Transform"),
        }
    }
}

/// An instance of a prefab, with what is different of it.
pub(super) struct Instance {
    /// What its identities are made from; unique in the scene.
    pub key: String,
    /// The prefab's.
    pub guid: String,
    /// The transform of the prefab's root.
    pub root: i64,
    /// What it says otherwise than the prefab.
    pub changes: Vec<Change>,
}

/// A field of an instance.
pub(super) struct Change {
    /// The game object or component in the prefab.
    pub target: i64,
    /// The field: `m_LocalPosition.x`, `constraints.Array.data[0]`.
    pub path: String,
    /// What it is in the instance.
    pub value: Yaml,
}

impl Instance {
    fn write(&self, stream: &mut Stream, father: i64) {
        let own = anchor(&self.key, "PrefabInstance");
        let of_prefab = |id: i64| asset(id, &self.guid, 3);
        let change = |change: &Change| -> Yaml {
            map! {
                "target" => of_prefab(change.target),
                "propertyPath" => change.path.as_str(),
                "value" => change.value.clone(),
                "objectReference" => none(),
            }
            .into()
        };
        stream.document(
            1001,
            own,
            "PrefabInstance",
            &map! {
                "m_ObjectHideFlags" => 0,
                "serializedVersion" => 2,
                "m_Modification" => map! {
                    "serializedVersion" => 3,
                    "m_TransformParent" => local(father),
                    "m_Modifications" => self.changes.iter().map(change).collect::<Vec<_>>(),
                    "m_RemovedComponents" => Vec::<Yaml>::new(),
                    "m_RemovedGameObjects" => Vec::<Yaml>::new(),
                    "m_AddedGameObjects" => Vec::<Yaml>::new(),
                    "m_AddedComponents" => Vec::<Yaml>::new(),
                },
                "m_SourcePrefab" => of_prefab(SOURCE),
            },
        );
        // What its parent lists as its child: the transform of the instance, without fields of its own.
        stream.stripped(
            4,
            anchor(&self.key, "Transform"),
            "Transform",
            &map! {
                "m_CorrespondingSourceObject" => of_prefab(self.root),
                "m_PrefabInstance" => local(own),
                "m_PrefabAsset" => none(),
            },
        );
    }
}

/// What Unity calls a prefab as a whole.
const SOURCE: i64 = 100_100_000;

/// A layer of the scene, by what is on it; the number is that of Unity, and of `ScenelangLayers` in the scripts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Layer {
    Floor = 8,
    Wall = 9,
    Ceiling = 10,
    Opening = 11,
    Furniture = 12,
    Handle = 13,
}

impl Layer {
    pub const ALL: [Self; 6] = [Self::Floor, Self::Wall, Self::Ceiling, Self::Opening, Self::Furniture, Self::Handle];

    /// Its name, and the tag of what was put on it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Floor => "Floor",
            Self::Wall => "Wall",
            Self::Ceiling => "Ceiling",
            Self::Opening => "Opening",
            Self::Furniture => "Furniture",
            Self::Handle => "Handle",
        }
    }

    /// All tags that Unity does not have itself; parts that move have one, and the layer of their object.
    pub fn tags() -> impl Iterator<Item = &'static str> {
        Self::ALL.into_iter().map(Self::name).chain(["Part"])
    }
}

pub(super) struct Component {
    /// Unity's number of its class.
    pub class: u32,
    /// Unity's name of its class.
    pub kind: &'static str,
    /// Tells components of one object apart: `BoxCollider2`.
    pub key: String,
    /// Its own fields.
    pub fields: Map,
}

impl GameObject {
    /// An object at the origin, without components.
    pub fn new(key: impl Into<String>, name: impl Into<String>) -> Self {
        Self {
            key: key.into(),
            name: name.into(),
            pos: Vec3::zeros(),
            axes: Matrix3::identity(),
            components: Vec::new(),
            children: Vec::new(),
            fixed: false,
            tag: "Untagged",
            layer: None,
        }
    }

    /// Puts it on a layer, and what is below it, and tags it so.
    pub fn place_on(&mut self, layer: Layer) {
        self.layer = Some(layer);
        self.tag = layer.name();
    }

    /// Adds a component; the second of a kind gets a number.
    pub fn add(&mut self, class: u32, kind: &'static str, fields: Map) {
        let before = self.components.iter().filter(|c| c.class == class).count();
        let key = if before == 0 { kind.to_owned() } else { format!("{kind}{}", before + 1) };
        self.components.push(Component { class, kind, key, fields });
    }

    /// The anchor of its transform.
    pub fn transform(&self) -> i64 {
        self.anchor("Transform")
    }

    /// The anchor of one of its components, by key, or of itself: `GameObject`.
    pub fn anchor(&self, component: &str) -> i64 {
        anchor(&self.key, component)
    }

    /// Adds its documents and those of all below it.
    pub fn write(&self, stream: &mut Stream, father: i64, above: Option<Layer>) {
        let layer = self.layer.or(above);
        let own = self.anchor("GameObject");
        let ids: Vec<i64> = self.components.iter().map(|c| anchor(&self.key, &c.key)).collect();
        let listed = std::iter::once(self.transform()).chain(ids.iter().copied());
        let mut fields = hidden();
        fields.extend(map! {
            "serializedVersion" => 6,
            "m_Component" => listed.map(|id| map! { "component" => local(id) }.into()).collect::<Vec<Yaml>>(),
            "m_Layer" => layer.map_or(0, |layer| layer as i32),
            "m_Name" => self.name.as_str(),
            "m_TagString" => self.tag,
            "m_Icon" => none(),
            "m_NavMeshLayer" => 0,
            "m_StaticEditorFlags" => if self.fixed { 2_147_483_647 } else { 0 },
            "m_IsActive" => 1,
        });
        stream.document(1, own, "GameObject", &fields);
        let [pos, rot, hint] = pose(self.pos, &self.axes);
        let mut fields = prefix(own);
        fields.extend(map! { "serializedVersion" => 2 });
        fields.extend([rot, pos]);
        fields.extend(map! {
            "m_LocalScale" => vector([1.0; 3]),
            "m_ConstrainProportionsScale" => 0,
            "m_Children" => self.children.iter().map(|c| local(c.transform())).collect::<Vec<_>>(),
            "m_Father" => local(father),
        });
        fields.push(hint);
        stream.document(4, self.transform(), "Transform", &fields);
        for (component, id) in self.components.iter().zip(ids) {
            let mut fields = prefix(own);
            fields.extend(component.fields.iter().cloned());
            stream.document(component.class, id, component.kind, &fields);
        }
        for child in &self.children {
            match child {
                Child::Node(node) => node.write(stream, self.transform(), layer),
                Child::Instance(instance) => instance.write(stream, self.transform()),
            }
        }
    }
}

/// Where a transform is, and how it is turned: its fields for position, rotation and the angles that the inspector shows.
pub(super) fn pose(pos: Vec3, axes: &Matrix3<f64>) -> [(String, Yaml); 3] {
    let turned = rotation::quaternion(axes).map(|v| v as f32);
    [
        ("m_LocalPosition".into(), vector(narrow(pos))),
        ("m_LocalRotation".into(), quaternion(turned)),
        ("m_LocalEulerAnglesHint".into(), vector(unity_euler(axes).map(|v| v as f32))),
    ]
}

/// A prefab file: one tree.
pub(super) fn prefab_file(root: &GameObject) -> Vec<u8> {
    let mut stream = Stream::new();
    root.write(&mut stream, 0, None);
    stream.into_bytes()
}

/// The scene file: settings, the trees, and the list of their roots.
pub(super) fn scene_file(settings: impl FnOnce(&mut Stream), roots: &[GameObject]) -> Vec<u8> {
    let mut stream = Stream::new();
    settings(&mut stream);
    for root in roots {
        root.write(&mut stream, 0, None);
    }
    let all: Vec<Yaml> = roots.iter().map(|r| local(r.transform())).collect();
    stream.document(1_660_057_539, i64::MAX, "SceneRoots", &map! { "m_ObjectHideFlags" => 0, "m_Roots" => all });
    stream.into_bytes()
}

fn hidden() -> Map {
    map! {
        "m_ObjectHideFlags" => 0,
        "m_CorrespondingSourceObject" => none(),
        "m_PrefabInstance" => none(),
        "m_PrefabAsset" => none(),
    }
}

/// What every component begins with.
fn prefix(owner: i64) -> Map {
    let mut fields = hidden();
    fields.extend(map! { "m_GameObject" => local(owner) });
    fields
}

/// As Unity stores it.
pub(super) fn narrow(v: Vec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}
