//! Surfaces as Unity materials, for the built-in pipeline and for the Universal one: both sets of names are always
//! written, so that a change of shader keeps the look.

use super::Pipeline;
use super::yaml::{Map, Stream, Yaml, asset, color, map, none, pair};
use scenelang_assets::Surface;

/// A material's `.mat` file.
pub(super) fn material(surface: &Surface, name: &str, pipeline: Pipeline) -> Vec<u8> {
    let shader = match pipeline {
        Pipeline::BuiltIn => asset(46, "0000000000000000f000000000000000", 0),
        Pipeline::Urp => asset(4_800_000, "933532a4fcc9baf4fa0491de14d08ed7", 3),
    };
    let clear = surface.opacity < 1.0;
    let mut keywords = Vec::new();
    if clear {
        keywords.extend(match pipeline {
            Pipeline::BuiltIn => ["_ALPHAPREMULTIPLY_ON"],
            Pipeline::Urp => ["_SURFACE_TYPE_TRANSPARENT"],
        });
    }
    if surface.emissive.is_some() {
        keywords.push("_EMISSION");
    }
    let tags = if clear {
        map! { "RenderType" => "Transparent" }
    } else {
        Map::new()
    };
    let smoothness = 1.0 - surface.roughness;
    let flag = |on: bool| if on { 1.0 } else { 0.0 };
    let floats = [
        ("_DstBlend", if clear { 10.0 } else { 0.0 }),
        ("_Glossiness", smoothness),
        ("_Metallic", surface.metallic),
        ("_Mode", if clear { 3.0 } else { 0.0 }),
        ("_Smoothness", smoothness),
        ("_SrcBlend", 1.0),
        ("_Surface", flag(clear)),
        ("_ZWrite", flag(!clear)),
    ];
    let base = color(surface.color, surface.opacity);
    let colors = [
        ("_BaseColor", base.clone()),
        ("_Color", base),
        ("_EmissionColor", color(surface.emissive.unwrap_or_default(), 1.0)),
    ];
    let textures = ["_BaseMap", "_MainTex"].map(|slot| {
        Yaml::from(map! { slot => map! {
            "m_Texture" => none(),
            "m_Scale" => pair(1.0),
            "m_Offset" => pair(0.0),
        }})
    });
    let fields = map! {
        "serializedVersion" => 8,
        "m_ObjectHideFlags" => 0,
        "m_CorrespondingSourceObject" => none(),
        "m_PrefabInstance" => none(),
        "m_PrefabAsset" => none(),
        "m_Name" => name,
        "m_Shader" => shader,
        "m_Parent" => none(),
        "m_ModifiedSerializedProperties" => 0,
        "m_ValidKeywords" => keywords.into_iter().map(Yaml::from).collect::<Vec<_>>(),
        "m_InvalidKeywords" => Vec::<Yaml>::new(),
        "m_LightmapFlags" => if surface.emissive.is_some() { 2 } else { 4 },
        "m_EnableInstancingVariants" => 0,
        "m_DoubleSidedGI" => 0,
        "m_CustomRenderQueue" => if clear { 3000 } else { -1 },
        "stringTagMap" => tags,
        "disabledShaderPasses" => Vec::<Yaml>::new(),
        "m_LockedProperties" => "",
        "m_SavedProperties" => map! {
            "serializedVersion" => 3,
            "m_TexEnvs" => textures.to_vec(),
            "m_Ints" => Vec::<Yaml>::new(),
            "m_Floats" => floats.map(|(k, v)| Yaml::from(map! { k => v })).to_vec(),
            "m_Colors" => colors.map(|(k, v)| Yaml::from(map! { k => v })).to_vec(),
        },
        "m_BuildTextureStacks" => Vec::<Yaml>::new(),
    };
    let mut stream = Stream::new();
    stream.document(21, 2_100_000, "Material", &fields);
    stream.into_bytes()
}
