//! Scenes and layouts in short, as tests write them.
//!
//! A case starts at `# title`; its parts at `## scene`, `## layout` and `## expect`. A layout is written in short, see
//! [`layout`], or as JSON.

use scenelang_engine::check_layout_text;
use scenelang_lang::sources::Loader;
use scenelang_verify::{Checked, Options};
use serde_json::{Map, Value, json};
use std::io;
use std::path::Path;

/// One file, whatever it is called.
struct Scene(String);

impl Loader for Scene {
    fn load(&self, _: &Path) -> io::Result<Vec<u8>> {
        Ok(self.0.clone().into_bytes())
    }
}

/// Judges a scene with a layout, both as text.
pub fn judged(scene: &str, layout_json: &str, options: &Options) -> Checked {
    let (name, compile) = ("room.layout.json", scenelang_lang::Options::default());
    check_layout_text(name, Path::new(name), layout_json.to_owned(), options, compile, &Scene(scene.to_owned()))
}

/// A layout in short. A line is `object NAME x y z | w h d | rx ry rz | asset`, `region NAME x y z | w h d | ry`,
/// `outline NAME floor height | x z, x z, …`, `value NAME json` or `draw KEY number`; what follows a `|` may be left out.
pub fn layout(text: &str) -> String {
    if text.trim_start().starts_with('{') {
        return text.to_owned();
    }
    let numbers = |text: &str| -> Vec<f64> { text.split_whitespace().map(|n| n.parse().expect(n)).collect() };
    let mut blocks: [(&str, Map<String, Value>); 4] =
        [("objects", Map::new()), ("regions", Map::new()), ("variables", Map::new()), ("draws", Map::new())];
    for line in text.lines().filter(|line| !line.trim().is_empty()) {
        let (what, rest) = line.trim().split_once(' ').expect(line);
        let (name, rest) = rest.trim().split_once(' ').expect(line);
        let mut parts = rest.splitn(4, '|');
        let mut next = || parts.next().map(str::trim).filter(|part| !part.is_empty());
        let (block, value) = match what {
            "object" => {
                let pos = numbers(next().expect(line));
                let scale = next().map_or(vec![1.0; 3], numbers);
                let rot = next().map_or(vec![0.0; 3], numbers);
                let asset: Value = next().map_or(json!({}), |asset| serde_json::from_str(asset).expect(asset));
                (0, json!({ "pos": pos, "rot": rot, "scale": scale, "asset": asset }))
            }
            "region" => {
                let pos = numbers(next().expect(line));
                let scale = numbers(next().expect(line));
                let turned = next().map_or(0.0, |degrees| numbers(degrees)[0]);
                (1, json!({ "pos": pos, "rot": [0.0, turned, 0.0], "scale": scale }))
            }
            "outline" => {
                let heights = numbers(next().expect(line));
                let vertices: Vec<Vec<f64>> = next().expect(line).split(',').map(numbers).collect();
                let (pos, scale) = (json!([0.0, heights[0], 0.0]), json!([1.0, heights[1], 1.0]));
                (1, json!({ "pos": pos, "scale": scale, "vertices": vertices }))
            }
            "value" => (2, serde_json::from_str(rest).expect(rest)),
            "draw" => (3, json!(numbers(rest)[0])),
            _ => panic!("what is {line:?}?"),
        };
        blocks[block].1.insert(name.to_owned(), value);
    }
    let mut document = json!({ "format": "scenelang.layout/1", "scene": "room.scene" });
    for (key, block) in blocks {
        document[key] = Value::Object(block);
    }
    document.to_string()
}

/// A case.
pub struct Case<'a> {
    pub title: &'a str,
    pub scene: String,
    pub layout: String,
    pub expect: String,
}

/// The cases of a file.
pub fn cases(text: &str) -> Vec<Case<'_>> {
    let mut out: Vec<Case<'_>> = Vec::new();
    let mut part = String::new();
    for line in text.lines() {
        if let Some(title) = line.strip_prefix("# ") {
            out.push(Case { title, scene: String::new(), layout: String::new(), expect: String::new() });
        } else if let Some(name) = line.strip_prefix("## ") {
            part = name.to_owned();
        } else if let Some(case) = out.last_mut() {
            let text = match part.as_str() {
                "scene" => &mut case.scene,
                "layout" => &mut case.layout,
                "expect" => &mut case.expect,
                _ => panic!("a line before its part: {line:?}"),
            };
            text.push_str(line);
            text.push('\n');
        }
    }
    out
}
