//! The fields of the components that a scene needs, for Unity 2022.3 or 6000.

use super::editor::Editor;
use super::tree::narrow;
use super::yaml::{Map, Stream, Yaml, asset, color, map, none, vector};
use crate::scene::Lamp;
use scenelang_layout::Vec3;

/// Class numbers.
pub(super) mod class {
    pub const CAMERA: u32 = 20;
    pub const MESH_RENDERER: u32 = 23;
    pub const MESH_FILTER: u32 = 33;
    pub const RIGIDBODY: u32 = 54;
    pub const HINGE_JOINT: u32 = 59;
    pub const MESH_COLLIDER: u32 = 64;
    pub const BOX_COLLIDER: u32 = 65;
    pub const AUDIO_LISTENER: u32 = 81;
    pub const LIGHT: u32 = 108;
    pub const MONO_BEHAVIOUR: u32 = 114;
    pub const CONFIGURABLE_JOINT: u32 = 153;
}

fn layers() -> Yaml {
    map! { "serializedVersion" => 2, "m_Bits" => 0 }.into()
}

fn collider() -> Map {
    map! {
        "m_Material" => none(),
        "m_IncludeLayers" => layers(),
        "m_ExcludeLayers" => layers(),
        "m_LayerOverridePriority" => 0,
        "m_IsTrigger" => 0,
        "m_ProvidesContacts" => 0,
        "m_Enabled" => 1,
    }
}

pub(super) fn box_collider(center: Vec3, size: Vec3) -> Map {
    let mut fields = collider();
    fields.extend(map! {
        "serializedVersion" => 3, "m_Size" => vector(narrow(size)), "m_Center" => vector(narrow(center)),
    });
    fields
}

/// What is touched but stops nothing.
pub(super) fn box_trigger(center: Vec3, size: Vec3) -> Map {
    let mut fields = box_collider(center, size);
    for (key, value) in &mut fields {
        if key == "m_IsTrigger" {
            *value = Yaml::from(1);
        }
    }
    fields
}

pub(super) fn mesh_collider(mesh: Yaml, convex: bool) -> Map {
    let mut fields = collider();
    fields.extend(map! {
        "serializedVersion" => 5, "m_Convex" => i32::from(convex), "m_CookingOptions" => 30, "m_Mesh" => mesh,
    });
    fields
}

pub(super) fn mesh_filter(mesh: Yaml) -> Map {
    map! { "m_Mesh" => mesh }
}

pub(super) fn mesh_renderer(materials: Vec<Yaml>) -> Map {
    map! {
        "m_Enabled" => 1,
        "m_CastShadows" => 1,
        "m_ReceiveShadows" => 1,
        "m_DynamicOccludee" => 1,
        "m_StaticShadowCaster" => 0,
        "m_MotionVectors" => 1,
        "m_LightProbeUsage" => 1,
        "m_ReflectionProbeUsage" => 1,
        "m_RayTracingMode" => 2,
        "m_RayTraceProcedural" => 0,
        "m_RenderingLayerMask" => 1,
        "m_RendererPriority" => 0,
        "m_Materials" => materials,
    }
}

/// A rigid body of a mass in kilograms; a held one is moved by scripts only.
pub(super) fn rigidbody(mass: f64, held: bool, editor: Editor) -> Map {
    let [linear, angular] = editor.either(["m_Drag", "m_AngularDrag"], ["m_LinearDamping", "m_AngularDamping"]);
    map! {
        "serializedVersion" => editor.either(4, 5),
        "m_Mass" => mass as f32,
        linear => 0,
        angular => 0.05,
        "m_CenterOfMass" => vector([0.0; 3]),
        "m_InertiaTensor" => vector([1.0; 3]),
        "m_InertiaRotation" => super::yaml::quaternion([0.0, 0.0, 0.0, 1.0]),
        "m_IncludeLayers" => layers(),
        "m_ExcludeLayers" => layers(),
        "m_ImplicitCom" => 1,
        "m_ImplicitTensor" => 1,
        "m_UseGravity" => i32::from(!held),
        "m_IsKinematic" => i32::from(held),
        "m_Interpolate" => 0,
        "m_Constraints" => 0,
        "m_CollisionDetection" => 0,
    }
}

/// A script with its own fields.
pub(super) fn script(guid: &str, own: Map) -> Map {
    let mut fields = map! {
        "m_Enabled" => 1,
        "m_EditorHideFlags" => 0,
        "m_Script" => asset(11_500_000, guid, 3),
        "m_Name" => "",
        "m_EditorClassIdentifier" => "",
    };
    fields.extend(own);
    fields
}

pub(super) enum Shine<'a> {
    /// Parallel light along the object's +z, with shadows.
    Sun,
    /// In all directions.
    Lamp(&'a Lamp),
}

/// Unity's intensity of a lamp for its square root of candelas: a lamp is as bright as the eye finds it.
const BRIGHT: f32 = 0.2;

pub(super) fn light(shine: &Shine<'_>, editor: Editor) -> Map {
    let (kind, range, intensity, tint, shadows) = match shine {
        Shine::Sun => (1, 10.0, 0.7, [1.0, 0.97, 0.92], 2),
        Shine::Lamp(lamp) => (2, lamp.range, BRIGHT * (lamp.candela as f32).sqrt(), lamp.color, 0),
    };
    map! {
        "m_Enabled" => 1,
        "serializedVersion" => editor.either(10, 11),
        "m_Type" => kind,
        "m_Shape" => 0,
        "m_Color" => color(tint, 1.0),
        "m_Intensity" => intensity,
        "m_Range" => range as f32,
        "m_SpotAngle" => 30,
        "m_InnerSpotAngle" => 21.8,
        "m_CookieSize" => 10,
        "m_Shadows" => map! {
            "m_Type" => shadows,
            "m_Resolution" => -1,
            "m_CustomResolution" => -1,
            "m_Strength" => 1,
            "m_Bias" => 0.05,
            "m_NormalBias" => 0.4,
            "m_NearPlane" => 0.2,
        },
        "m_Cookie" => none(),
        "m_DrawHalo" => 0,
        "m_Flare" => none(),
        "m_RenderMode" => 0,
        "m_CullingMask" => map! { "serializedVersion" => 2, "m_Bits" => 4_294_967_295_i64 },
        "m_RenderingLayerMask" => 1,
        "m_Lightmapping" => 4,
        "m_BounceIntensity" => 1,
        "m_ColorTemperature" => 6570,
        "m_UseColorTemperature" => 0,
    }
}

/// A camera with a vertical angle of view in degrees.
pub(super) fn camera(fov: f64) -> Map {
    map! {
        "m_Enabled" => 1,
        "serializedVersion" => 2,
        "m_ClearFlags" => 1,
        "m_BackGroundColor" => color([0.8, 0.86, 0.92], 0.0),
        "near clip plane" => 0.05,
        "far clip plane" => 500,
        "field of view" => fov as f32,
        "orthographic" => 0,
        "orthographic size" => 5,
        "m_Depth" => -1,
        "m_CullingMask" => map! { "serializedVersion" => 2, "m_Bits" => 4_294_967_295_i64 },
        "m_RenderingPath" => -1,
        "m_TargetTexture" => none(),
        "m_TargetDisplay" => 0,
        "m_HDR" => 1,
        "m_AllowMSAA" => 1,
        "m_OcclusionCulling" => 1,
    }
}

/// Who walks on the navigation mesh, in metres: half the width, the height, and what is no step.
pub(super) const RADIUS: f32 = 0.25;
pub(super) const HEIGHT: f32 = 1.8;
pub(super) const STEP: f32 = 0.05;

/// The four settings that a scene file begins with: evenly lit, without fog, nothing baked.
pub(super) fn settings(stream: &mut Stream, editor: Editor) {
    let ambient = [0.46, 0.47, 0.5];
    stream.document(29, 1, "OcclusionCullingSettings", &map! {
        "m_ObjectHideFlags" => 0,
        "serializedVersion" => 2,
        "m_OcclusionBakeSettings" => map! { "smallestOccluder" => 5, "smallestHole" => 0.25, "backfaceThreshold" => 100 },
        "m_SceneGUID" => Yaml::Word("0".repeat(32)),
        "m_OcclusionCullingData" => none(),
    });
    stream.document(
        104,
        2,
        "RenderSettings",
        &map! {
            "m_ObjectHideFlags" => 0,
            "serializedVersion" => editor.either(9, 10),
            "m_Fog" => 0,
            "m_AmbientSkyColor" => color(ambient, 1.0),
            "m_AmbientEquatorColor" => color(ambient, 1.0),
            "m_AmbientGroundColor" => color(ambient, 1.0),
            "m_AmbientIntensity" => 1,
            "m_AmbientMode" => 3,
            "m_SubtractiveShadowColor" => color([0.42, 0.478, 0.627], 1.0),
            "m_SkyboxMaterial" => asset(10304, "0000000000000000f000000000000000", 0),
            "m_ReflectionIntensity" => 1,
            "m_Sun" => none(),
        },
    );
    // Unity 6 bakes light when it is told to, and has no switch for it.
    let switch = editor.either(map! { "m_GIWorkflowMode" => 1 }, Map::new());
    let mut lightmaps = map! { "m_ObjectHideFlags" => 0, "serializedVersion" => editor.either(12, 13) };
    lightmaps.extend(switch);
    lightmaps.extend(map! {
            "m_GISettings" => map! {
                "serializedVersion" => 2, "m_BounceScale" => 1, "m_IndirectOutputScale" => 1, "m_AlbedoBoost" => 1,
                "m_EnvironmentLightingMode" => 0, "m_EnableBakedLightmaps" => 0, "m_EnableRealtimeLightmaps" => 0,
            },
            "m_LightingDataAsset" => none(),
            "m_LightingSettings" => none(),
    });
    stream.document(157, 3, "LightmapSettings", &lightmaps);
    stream.document(196, 4, "NavMeshSettings", &map! {
        "serializedVersion" => 2,
        "m_ObjectHideFlags" => 0,
        "m_BuildSettings" => map! {
            "serializedVersion" => 3, "agentTypeID" => 0, "agentRadius" => RADIUS, "agentHeight" => HEIGHT, "agentSlope" => 45,
            "agentClimb" => STEP, "ledgeDropHeight" => 0, "maxJumpAcrossDistance" => 0, "minRegionArea" => 0.2,
            "manualCellSize" => 0, "cellSize" => 0.08, "manualTileSize" => 0, "tileSize" => 256,
            "buildHeightMesh" => 0, "maxJobWorkers" => 0, "preserveTilesOutsideBounds" => 0,
        },
        "m_NavMeshData" => none(),
    });
}
