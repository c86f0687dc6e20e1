//! The project around the scene: a `.meta` file beside every asset and folder, the package list, the settings.

use super::editor::Editor;
use super::tree::Layer;
use super::yaml::{Map, Stream, Yaml, asset, map, none};
use super::{Pipeline, ids};
use crate::OutFile;
use std::collections::BTreeSet;

/// The folder that the project is written to.
pub const ROOT: &str = "unity";
/// Where a project says which editor it is for.
pub const VERSION: &str = "ProjectSettings/ProjectVersion.txt";

/// Files as they come together.
#[derive(Default)]
pub(super) struct Project {
    editor: Editor,
    files: Vec<OutFile>,
    folders: BTreeSet<String>,
}

impl Project {
    /// One without files, for an editor.
    pub fn new(editor: Editor) -> Self {
        Self { editor, ..Self::default() }
    }

    /// Adds an asset (its path starts with `Assets/`) with its `.meta`, and those of its folders; returns its GUID.
    pub fn asset(&mut self, path: &str, bytes: impl Into<Vec<u8>>) -> String {
        for (i, _) in path.match_indices('/').skip(1) {
            if self.folders.insert(path[..i].to_owned()) {
                self.meta(&path[..i], &importer(None, self.editor));
            }
        }
        let fields = match path.strip_suffix(".png") {
            Some(picture) => texture(picture, self.editor),
            None => importer(path.rsplit('.').next(), self.editor),
        };
        self.files.push(OutFile::new(format!("{ROOT}/{path}"), bytes));
        self.meta(path, &fields)
    }

    /// All files of the project, with the list of packages and the settings.
    pub fn finish(mut self, scene: &str, pipeline: Pipeline) -> Vec<OutFile> {
        let scene = format!("Assets/Scenes/{scene}.unity");
        for (path, bytes) in [
            ("Packages/manifest.json", packages(pipeline, self.editor).into_bytes()),
            (VERSION, format!("m_EditorVersion: {}\n", self.editor.version()).into_bytes()),
            ("ProjectSettings/EditorSettings.asset", editor_settings(self.editor)),
            ("ProjectSettings/TagManager.asset", tag_manager(self.editor)),
            ("ProjectSettings/EditorBuildSettings.asset", build_settings(&scene)),
        ] {
            self.files.push(OutFile::new(format!("{ROOT}/{path}"), bytes));
        }
        self.files
    }

    fn meta(&mut self, path: &str, importer: &Map) -> String {
        let guid = ids::guid(path);
        let mut fields = map! { "fileFormatVersion" => 2, "guid" => Yaml::Word(guid.clone()) };
        fields.extend(importer.iter().cloned());
        self.files.push(OutFile::new(format!("{ROOT}/{path}.meta"), Stream::meta(&fields)));
        guid
    }
}

/// What a `.meta` file says of the importer, by extension; `None`: a folder.
fn importer(extension: Option<&str>, editor: Editor) -> Map {
    let with = |kind: &str, mut fields: Map| {
        fields.extend(map! { "userData" => "", "assetBundleName" => "", "assetBundleVariant" => "" });
        map! { kind => fields }
    };
    let plain = || map! { "externalObjects" => Map::new() };
    match extension {
        None => {
            let mut fields = map! { "folderAsset" => "yes" };
            fields.extend(with("DefaultImporter", plain()));
            fields
        }
        Some("unity") => with("DefaultImporter", plain()),
        Some("mat") => {
            let mut fields = plain();
            fields.extend(map! { "mainObjectFileID" => 2_100_000 });
            with("NativeFormatImporter", fields)
        }
        Some("cs") => {
            let mut fields = plain();
            fields.extend(map! {
                "serializedVersion" => 2, "defaultReferences" => Vec::<Yaml>::new(), "executionOrder" => 0, "icon" => none(),
            });
            with("MonoImporter", fields)
        }
        Some("obj") => with("ModelImporter", model(editor)),
        Some("prefab") => with("PrefabImporter", plain()),
        Some(_) => with("TextScriptImporter", plain()),
    }
}

/// Textures repeat and are smooth. One whose name says so has normals, and only one with colours is sRGB.
fn texture(picture: &str, editor: Editor) -> Map {
    let is_normal = picture.ends_with("_normal");
    let is_color = picture.ends_with("_color");
    map! { "TextureImporter" => map! {
        "internalIDToNameTable" => Vec::<Yaml>::new(),
        "externalObjects" => Map::new(),
        "serializedVersion" => editor.either(12, 13),
        "mipmaps" => map! {
            "mipMapMode" => 0,
            "enableMipMap" => 1,
            "sRGBTexture" => i32::from(is_color),
            "linearTexture" => 0,
            "fadeOut" => 0,
            "borderMipMap" => 0,
        },
        "bumpmap" => map! { "convertToNormalMap" => 0, "externalNormalMap" => 0, "flipGreenChannel" => 0 },
        "isReadable" => 0,
        "streamingMipmaps" => 0,
        "maxTextureSize" => 2048,
        "textureSettings" => map! {
            "serializedVersion" => 2,
            "filterMode" => 1,
            "aniso" => 8,
            "mipBias" => 0,
            "wrapU" => 0,
            "wrapV" => 0,
            "wrapW" => 0,
        },
        "nPOTScale" => 1,
        "alphaUsage" => 1,
        "alphaIsTransparency" => 0,
        "textureType" => i32::from(is_normal),
        "textureShape" => 1,
        "userData" => "",
        "assetBundleName" => "",
        "assetBundleVariant" => "",
    }}
}

/// Meshes come in metres, as they are, readable, without materials of their own.
fn model(editor: Editor) -> Map {
    map! {
        "serializedVersion" => editor.either(22200, 24200),
        "internalIDToNameTable" => Vec::<Yaml>::new(),
        "externalObjects" => Map::new(),
        "materials" => map! {
            "materialImportMode" => 0, "materialName" => 0, "materialSearch" => 1, "materialLocation" => 1,
        },
        "meshes" => map! {
            "lODScreenPercentages" => Vec::<Yaml>::new(),
            "globalScale" => 1,
            "meshCompression" => 0,
            "addColliders" => 0,
            "importVisibility" => 1,
            "importBlendShapes" => 0,
            "importCameras" => 0,
            "importLights" => 0,
            "fileIdsGeneration" => 2,
            "swapUVChannels" => 0,
            "generateSecondaryUV" => 0,
            "useFileUnits" => 1,
            "keepQuads" => 0,
            "weldVertices" => 1,
            "bakeAxisConversion" => 0,
            "preserveHierarchy" => 0,
            "indexFormat" => 0,
            "useFileScale" => 1,
            "isReadable" => 1,
        },
        "tangentSpace" => map! {
            "normalSmoothAngle" => 60, "normalImportMode" => 0, "tangentImportMode" => 3, "normalCalculationMode" => 4,
        },
        "importAnimation" => 0,
        "animationType" => 0,
    }
}

fn packages(pipeline: Pipeline, editor: Editor) -> String {
    let mut wanted = vec![
        ("com.unity.modules.ai", "1.0.0"),
        ("com.unity.modules.imgui", "1.0.0"),
        ("com.unity.modules.jsonserialize", "1.0.0"),
        ("com.unity.modules.physics", "1.0.0"),
    ];
    if pipeline == Pipeline::Urp {
        wanted.push(("com.unity.render-pipelines.universal", editor.universal()));
    }
    let list: serde_json::Map<String, serde_json::Value> =
        wanted.into_iter().map(|(name, version)| (name.to_owned(), version.into())).collect();
    format!("{:#}\n", serde_json::json!({ "dependencies": list }))
}

/// Text serialisation, so that whatever the editor saves stays readable and comparable.
fn editor_settings(editor: Editor) -> Vec<u8> {
    let mut stream = Stream::new();
    let fields = map! {
        "m_ObjectHideFlags" => 0,
        "serializedVersion" => editor.either(11, 13),
        "m_SerializationMode" => 2,
        "m_LineEndingsForNewScripts" => 0,
    };
    stream.document(159, 1, "EditorSettings", &fields);
    stream.into_bytes()
}

/// Names of tags and layers; a project has 32 layers, some of them Unity's own.
fn tag_manager(editor: Editor) -> Vec<u8> {
    let mut layers = vec![Yaml::from(""); 32];
    for (number, name) in [(0, "Default"), (1, "TransparentFX"), (2, "Ignore Raycast"), (4, "Water"), (5, "UI")] {
        layers[number] = name.into();
    }
    for layer in Layer::ALL {
        layers[layer as usize] = layer.name().into();
    }
    let mut fields = map! {
        "serializedVersion" => editor.either(2, 3),
        "tags" => Layer::tags().map(Yaml::from).collect::<Vec<_>>(),
        "layers" => layers,
        "m_SortingLayers" => vec![Yaml::from(map! { "name" => "Default", "uniqueID" => 0, "locked" => 0 })],
    };
    fields.extend(editor.either(Map::new(), map! { "m_RenderingLayers" => vec![Yaml::from("Default")] }));
    let mut stream = Stream::new();
    stream.document(78, 1, "TagManager", &fields);
    stream.into_bytes()
}

fn build_settings(scene: &str) -> Vec<u8> {
    let guid = Yaml::Word(ids::guid(scene));
    let mut stream = Stream::new();
    let fields = map! {
        "m_ObjectHideFlags" => 0,
        "serializedVersion" => 2,
        "m_Scenes" => vec![Yaml::from(map! { "enabled" => 1, "path" => scene, "guid" => guid })],
        "m_configObjects" => Map::new(),
    };
    stream.document(1045, 1, "EditorBuildSettings", &fields);
    stream.into_bytes()
}

/// The mesh of an OBJ file.
pub(super) fn mesh_of(guid: &str) -> Yaml {
    asset(ids::obj_mesh(), guid, 3)
}
