//! A Unity project as text, for 2022.3 or 6000: scene, prefabs, meshes, materials, colliders, lights, and the program with its
//! layout and report as text assets. Opens without packages from elsewhere and without a first import by hand.

mod component;
mod editor;
mod ids;
mod joint;
mod material;
mod mesh_obj;
mod object;
mod prefab;
mod project;
mod scene;
mod tree;
mod yaml;

use crate::names::Stems;
use crate::{ExportError, Exporter, OutFile, Scene, textures};
pub use editor::Editor;
use project::Project;
pub use project::{ROOT, VERSION};
use scenelang_assets::Surface;
use scenelang_assets::textures::Texture;
use std::collections::BTreeMap;

/// The `unity/` folder.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unity {
    /// Which shaders materials use.
    pub pipeline: Pipeline,
    pub editor: Editor,
}

/// A render pipeline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pipeline {
    /// The built-in one: nothing to install.
    #[default]
    BuiltIn,
    /// The Universal one: for a project that has its package.
    Urp,
}

impl Exporter for Unity {
    fn name(&self) -> &'static str {
        "unity"
    }

    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let mut project = Project::new(self.editor);
        let materials = self.materials(scene, &mut project)?;
        if let Some(imports) = scene.imports() {
            project.asset("Assets/Scenelang/imports.json", format!("{imports:#}\n"));
        }
        let texts = scene::Texts {
            spec: project.asset("Assets/Scenelang/spec.scene.txt", scene.main_text()),
            layout: project.asset("Assets/Scenelang/layout.json", scene.layout_text.as_str()),
            report: project.asset("Assets/Scenelang/report.json", format!("{:#}\n", scene.report)),
            rows: project.asset("Assets/Scenelang/constraints.json", scene::rows(scene)),
        };
        let scripts = scripts(&mut project);
        let mut writer = scene::Writer {
            scene,
            project: &mut project,
            materials: &materials,
            scripts: &scripts,
            editor: self.editor,
            stems: Stems::default(),
        };
        let bytes = writer.write(&texts);
        let name = Stems::default().take(&scene.name);
        project.asset(&format!("Assets/Scenes/{name}.unity"), bytes);
        Ok(project.finish(&name, self.pipeline))
    }
}

/// A script of the project: its file name and its text.
macro_rules! script {
    ($name:literal) => {
        ($name, include_str!(concat!("../../unity/", $name)))
    };
}

/// For the editor only.
const EDITOR_SCRIPTS: [(&str, &str); 3] =
    [script!("ScenelangJointTest.cs"), script!("ScenelangSelfTest.cs"), script!("ScenelangWindow.cs")];

/// Adds the scripts; the GUIDs of those that are components.
fn scripts(project: &mut Project) -> scene::Scripts {
    for (name, text) in EDITOR_SCRIPTS {
        project.asset(&format!("Assets/Editor/{name}"), text);
    }
    let mut add = |(name, text): (&str, &str)| project.asset(&format!("Assets/Scenelang/Scripts/{name}"), text);
    add(script!("ScenelangConstraint.cs"));
    scene::Scripts {
        scene: add(script!("ScenelangScene.cs")),
        object: add(script!("ScenelangObject.cs")),
        joint: add(script!("ScenelangJoint.cs")),
        nav_mesh: add(script!("ScenelangNavMesh.cs")),
    }
}

/// A material of the project.
struct Material {
    /// Its file's stem, which meshes also call it by.
    name: String,
    guid: String,
}

impl Unity {
    fn materials(self, scene: &Scene, project: &mut Project) -> Result<Vec<Material>, ExportError> {
        let mut stems = Stems::default();
        let mut maps = Maps::default();
        let mut out = Vec::with_capacity(scene.surfaces.len());
        for surface in &scene.surfaces {
            let name = stems.take(&surface.name);
            let maps = maps.of(surface, project)?;
            let bytes = material::material(surface, &name, maps.as_ref(), self.pipeline);
            let guid = project.asset(&format!("Assets/Scenelang/Materials/{name}.mat"), bytes);
            out.push(Material { name, guid });
        }
        Ok(out)
    }
}

/// The textures of the project: a set for each kind, and how it shines for each finish.
#[derive(Default)]
struct Maps {
    /// GUIDs by file name.
    written: BTreeMap<String, String>,
}

impl Maps {
    /// What a surface is covered with; its files are written when they are first asked for.
    fn of(&mut self, surface: &Surface, project: &mut Project) -> Result<Option<material::Maps>, ExportError> {
        let Some(texture) = Texture::of(surface) else { return Ok(None) };
        let kind = texture.name();
        let finish = surface.name.split('-').next().unwrap_or(kind);
        Ok(Some(material::Maps {
            texture,
            color: self.guid(&format!("{kind}_color"), project, || textures::color(texture))?,
            normal: self.guid(&format!("{kind}_normal"), project, || textures::normal(texture))?,
            gloss: self.guid(&format!("{finish}_gloss"), project, || {
                textures::gloss(texture, surface.metallic, surface.roughness)
            })?,
        }))
    }

    fn guid(
        &mut self,
        name: &str,
        project: &mut Project,
        png: impl FnOnce() -> Result<Vec<u8>, ExportError>,
    ) -> Result<String, ExportError> {
        if let Some(guid) = self.written.get(name) {
            return Ok(guid.clone());
        }
        let guid = project.asset(&format!("Assets/Scenelang/Textures/{name}.png"), png()?);
        self.written.insert(name.to_owned(), guid.clone());
        Ok(guid)
    }
}
