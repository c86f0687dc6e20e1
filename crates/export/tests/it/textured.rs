//! Textures in files beside the scene: each that is referred to is there, once, and has the colour and the size that the
//! scene's surfaces have.

use crate::fixture::scene;
use scenelang_assets::textures::{Texture, encoded};
use scenelang_export::obj::Obj;
use scenelang_export::sdf::Sdf;
use scenelang_export::urdf::Urdf;
use scenelang_export::usd::{Usd, Usdz};
use scenelang_export::{Exporter, OutFile};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{Cursor, Read};

fn files(exporter: &dyn Exporter) -> BTreeMap<String, Vec<u8>> {
    let path = |file: &OutFile| file.path.to_string_lossy().replace('\\', "/");
    exporter.files(&scene()).unwrap().into_iter().map(|file| (path(&file), file.bytes)).collect()
}

fn text(files: &BTreeMap<String, Vec<u8>>, ending: &str) -> String {
    let found = files.iter().find(|(path, _)| path.ends_with(ending)).unwrap_or_else(|| panic!("no {ending}"));
    String::from_utf8(found.1.clone()).unwrap()
}

/// What the texts of some files refer to, below the folder of each.
fn referred(files: &BTreeMap<String, Vec<u8>>) -> Vec<String> {
    let mut found = Vec::new();
    for (path, bytes) in files.iter().filter(|(path, _)| path.ends_with(".mtl") || path.ends_with(".usda")) {
        let folder = path.rfind('/').map_or("", |at| &path[..=at]);
        for line in String::from_utf8(bytes.clone()).unwrap().lines() {
            let own = line.trim().strip_prefix("asset inputs:file = @./").and_then(|rest| rest.strip_suffix('@'));
            let map = ["map_Kd ", "norm ", "map_Pr "].iter().find_map(|keyword| line.strip_prefix(keyword));
            found.extend(own.or(map).map(|file| format!("{folder}{file}")));
        }
    }
    found.sort();
    found.dedup();
    found
}

#[test]
fn every_picture_is_there_and_none_is_for_nothing() {
    let one = Urdf { object: "chair[0]".into() };
    for exporter in [&Usd as &dyn Exporter, &Obj, &Sdf, &one] {
        let (name, files) = (exporter.name(), files(exporter));
        let pictures: Vec<String> = files.keys().filter(|path| path.ends_with(".png")).cloned().collect();
        assert_eq!(pictures, referred(&files), "{name}");
        let kinds = pictures.iter().filter(|path| path.ends_with("_color.png")).count();
        assert!(kinds > 0 && pictures.len() == 3 * kinds, "{name}: {pictures:?}");
        let sizes = pictures.iter().map(|path| {
            let reader = png::Decoder::new(Cursor::new(&files[path])).read_info().unwrap();
            assert!(reader.info().width >= 128, "{path}");
            files[path].len()
        });
        assert!(sizes.sum::<usize>() < 1_500_000, "{name}");
    }
    let colors = |files: &BTreeMap<String, Vec<u8>>| files.keys().filter(|p| p.ends_with("_color.png")).count();
    assert!(colors(&files(&one)) < colors(&files(&Sdf)), "a chair does not need the textures of the room");
}

#[test]
fn a_package_has_the_same_pictures_as_the_folder() {
    let folder = files(&Usd);
    let package = files(&Usdz).into_values().next().unwrap();
    let mut archive = zip::ZipArchive::new(Cursor::new(package)).unwrap();
    assert_eq!(archive.by_index(0).unwrap().name().unwrap(), "scene.usda");
    assert_eq!(archive.len(), folder.len());
    for (path, bytes) in folder.iter().filter(|(path, _)| path.ends_with(".png")) {
        let mut read = Vec::new();
        archive.by_name(path).unwrap().read_to_end(&mut read).unwrap();
        assert_eq!(&read, bytes, "{path}");
    }
}

#[test]
fn places_are_in_repeats_of_the_texture_and_colours_keep_their_mean() {
    let (scene, files) = (scene(), files(&Obj));
    let obj = text(&files, ".obj");
    let numbers = |line: &str| line.split(' ').skip(1).map(|n| n.parse::<f32>().unwrap()).collect::<Vec<_>>();
    let written: Vec<Vec<f32>> = obj.lines().filter(|line| line.starts_with("vt ")).map(numbers).collect();
    let objects = scene.objects.iter().flat_map(|o| &o.mesh);
    let groups = objects.chain(scene.shells.iter().map(|s| &s.group)).filter(|g| !g.indices.is_empty());
    let tile = |surface: usize| Texture::of(&scene.surfaces[surface]).map_or([1.0; 2], |t| t.pixels().tile);
    let own: Vec<[f32; 2]> = groups
        .flat_map(|g| {
            let [width, height] = tile(g.surface);
            g.uvs.iter().map(move |[u, v]| [u / width as f32, v / height as f32])
        })
        .collect();
    assert_eq!(written.len(), own.len());
    assert!(written.iter().zip(&own).all(|(a, b)| (a[0] - b[0]).abs() < 1e-4 && (a[1] - b[1]).abs() < 1e-4));

    let materials = text(&files, ".mtl");
    let mut textured = 0;
    for (surface, lines) in scene.surfaces.iter().zip(materials.split("newmtl ").skip(1)) {
        let said = |key: &str| lines.lines().find(|line| line.starts_with(key)).map(numbers);
        let color = said("Kd ").unwrap();
        let Some(texture) = Texture::of(surface) else {
            assert!(!lines.contains("map_") && color.iter().zip(surface.color).all(|(a, b)| (a - b).abs() < 1e-4));
            continue;
        };
        textured += 1;
        assert!(lines.contains(&format!("map_Kd textures/{}_color.png", texture.name())), "{lines}");
        for (i, mean) in texture.pixels().mean.iter().enumerate() {
            // What is multiplied in linear light is not brighter than 1.
            let shown = encoded(linear(color[i]) * mean);
            let want = surface.color[i].min(encoded(*mean));
            assert!((shown - want).abs() < 1e-3, "{lines}: {shown} is not {want}");
        }
    }
    assert!(textured > 3, "{materials}");
}

#[test]
fn meshes_of_usd_have_places_where_their_material_has_a_texture() {
    let layer = text(&files(&Usd), ".usda");
    let (mut with, mut without) = (0, 0);
    for mesh in layer.split("def Mesh \"look_").skip(1) {
        let (mesh, rest) = mesh.split_once("rel material:binding = <").unwrap();
        let path = rest.split('>').next().unwrap();
        let material = path.rsplit('/').next().unwrap();
        let looks = layer.split(&format!("def Material \"{material}\"")).nth(1).unwrap();
        let looks = looks.split("def Material").next().unwrap();
        let count = |key: &str, sign: char| {
            let line = mesh.lines().find(|line| line.contains(key))?;
            Some(line.split_once('[')?.1.split_once(" = [")?.1.matches(sign).count())
        };
        let corners = count("faceVertexIndices", ',').unwrap() + 1;
        let places = || {
            let (_, list) = mesh.split_once("primvars:st = [")?;
            Some(list.split(']').next().unwrap().split("), ").collect::<Vec<_>>())
        };
        if looks.contains("UsdUVTexture") {
            with += 1;
            let places = places().unwrap();
            assert_eq!(places.iter().collect::<BTreeSet<_>>().len(), places.len(), "{material}: each place once");
            let (_, list) = mesh.split_once("primvars:st:indices = [").unwrap();
            let indices: Vec<usize> = list.split(']').next().unwrap().split(", ").map(|i| i.parse().unwrap()).collect();
            assert_eq!(indices.len(), corners, "{material}");
            assert_eq!(indices.iter().max(), Some(&(places.len() - 1)), "{material}");
            for output in ["Color.outputs:rgb", "Normal.outputs:rgb", "Roughness.outputs:r"] {
                assert!(looks.contains(&format!("<{path}/{output}>")), "{looks}");
            }
            assert_eq!(looks.matches(&format!("inputs:st.connect = <{path}/Places.outputs:result>")).count(), 3);
        } else {
            without += 1;
            assert_eq!(places(), None, "{material}");
        }
    }
    assert!(with > 3 && without > 0, "{with} {without}");
}

fn linear(c: f32) -> f32 {
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}
