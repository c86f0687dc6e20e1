//! Surfaces as Unity materials, for the built-in pipeline and for the Universal one: both sets of names are always
//! written, so that a change of shader keeps the look.

use super::Pipeline;
use super::yaml::{Map, Stream, Yaml, asset, color, map, none, pair};
use crate::glb::linear;
use scenelang_assets::Surface;
use scenelang_assets::textures::{Pixels, Texture, encoded};

/// The textures of a material, and their GUIDs.
pub(super) struct Maps {
    pub texture: Texture,
    pub color: String,
    pub normal: String,
    pub gloss: String,
}

/// A material's `.mat` file.
pub(super) fn material(surface: &Surface, name: &str, maps: Option<&Maps>, pipeline: Pipeline) -> Vec<u8> {
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
    if maps.is_some() {
        keywords.extend(match pipeline {
            Pipeline::BuiltIn => ["_METALLICGLOSSMAP", "_NORMALMAP"],
            Pipeline::Urp => ["_METALLICSPECGLOSSMAP", "_NORMALMAP"],
        });
    }
    let tags = if clear {
        map! { "RenderType" => "Transparent" }
    } else {
        Map::new()
    };
    let smoothness = 1.0 - surface.roughness;
    let flag = |on: bool| if on { 1.0 } else { 0.0 };
    let floats = [
        ("_BumpScale", 1.0),
        ("_DstBlend", if clear { 10.0 } else { 0.0 }),
        // The map of the gloss has the smoothness itself.
        ("_GlossMapScale", 1.0),
        ("_Glossiness", smoothness),
        ("_Metallic", surface.metallic),
        ("_Mode", if clear { 3.0 } else { 0.0 }),
        ("_Smoothness", if maps.is_some() { 1.0 } else { smoothness }),
        ("_SrcBlend", 1.0),
        ("_Surface", flag(clear)),
        ("_ZWrite", flag(!clear)),
    ];
    // As colours are multiplied in linear light, and said in sRGB.
    let factor = |pixels: &Pixels| pixels.factor(surface.color.map(|c| linear(c) as f32)).map(encoded);
    let base = color(maps.map_or(surface.color, |m| factor(m.texture.pixels())), surface.opacity);
    let colors = [
        ("_BaseColor", base.clone()),
        ("_Color", base),
        ("_EmissionColor", color(surface.emissive.unwrap_or_default(), 1.0)),
    ];
    let guid = |of: fn(&Maps) -> &str| maps.map_or_else(none, |m| asset(2_800_000, of(m), 3));
    // Places on materials are in metres.
    let scale = maps.map_or([1.0; 2], |m| m.texture.pixels().tile.map(|metres| (1.0 / metres) as f32));
    let textures = [
        ("_BaseMap", guid(|m| &m.color)),
        ("_BumpMap", guid(|m| &m.normal)),
        ("_MainTex", guid(|m| &m.color)),
        ("_MetallicGlossMap", guid(|m| &m.gloss)),
    ]
    .map(|(slot, texture)| {
        Yaml::from(map! { slot => map! {
            "m_Texture" => texture,
            "m_Scale" => pair(scale),
            "m_Offset" => pair([0.0; 2]),
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
