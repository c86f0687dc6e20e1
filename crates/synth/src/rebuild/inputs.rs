//! What goes into the stages: the look of each object, and all that decides where things are.
//!
//! A colour does not decide that, nor does a comment or the line that a statement stands in. So a layout is kept when only those
//! change.

use super::sum;
use scenelang_lang::Program;
use scenelang_lang::program::{ConstraintKind, Formula, Object, Owner};
use scenelang_layout::{Layout, Placement, Vec3};
use scenelang_verify::Options;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::{Debug, Write};

/// Sums of what goes into a stage, by what it is.
pub type Inputs = BTreeMap<String, String>;
/// What objects were given, by name.
pub type Looks = BTreeMap<String, AssetInput>;

/// So much of a statement names it.
const NAMED: usize = 120;

/// What an object was asked to be, and what it was given.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AssetInput {
    /// Assigned text, or empty.
    pub category: String,
    /// Assigned text, or empty.
    pub color: String,
    /// Assigned text, or empty.
    pub material: String,
    /// Assigned text, or empty.
    pub features: String,
    /// Full extents (metres).
    pub size: [f64; 3],
    /// Whether the library knows such a thing.
    pub is_known: bool,
    /// The sum of its parts; empty: not made yet.
    pub shape: String,
    /// The version of the library that made it.
    pub library: String,
}

impl AssetInput {
    pub fn asked(object: &Object, size: Vec3) -> Self {
        Self {
            category: object.category.clone(),
            color: object.color.clone(),
            material: object.material.clone(),
            features: object.features.clone(),
            size: size.into(),
            is_known: true,
            shape: String::new(),
            library: env!("CARGO_PKG_VERSION").to_owned(),
        }
    }

    /// The same with what was given.
    pub fn given(self, placement: &Placement, is_known: bool) -> Self {
        Self { is_known, shape: shape(placement), ..self }
    }

    /// Whether the same is asked for.
    pub fn asks_the_same(&self, other: &Self) -> bool {
        let asked = |look: &Self| Self { is_known: true, shape: String::new(), ..look.clone() };
        asked(self) == asked(other)
    }

    /// What differs, in words.
    pub fn changes(&self, before: &Self) -> Vec<String> {
        let mut out = Vec::new();
        let texts = [
            ("category", &before.category, &self.category),
            ("color", &before.color, &self.color),
            ("material", &before.material, &self.material),
            ("features", &before.features, &self.features),
            ("version of the library", &before.library, &self.library),
        ];
        for (what, old, new) in texts.into_iter().filter(|(_, old, new)| old != new) {
            out.push(format!("{what} has changed from \"{old}\" to \"{new}\""));
        }
        if before.size != self.size {
            out.push(format!("size has changed from {} to {}", metres(before.size), metres(self.size)));
        }
        if out.is_empty() && before.shape != self.shape {
            out.push("it has another shape".to_owned());
        }
        out
    }
}

fn metres(size: [f64; 3]) -> String {
    size.map(|v| format!("{v}")).join(" × ") + " m"
}

/// The sum of what a placement is made of, wherever it stands.
pub fn shape(placement: &Placement) -> String {
    sum_of(&(placement.scale, &placement.parts, &placement.surface, &placement.joints))
}

fn sum_of(value: &impl Debug) -> String {
    sum(format!("{value:?}").as_bytes())
}

/// How a layout is looked for, besides the program.
#[derive(Clone, Copy, Debug)]
pub struct How<'a> {
    pub judge: &'a Options,
    /// Fixes draws and every random choice.
    pub seed: u64,
    /// How many times the usual work.
    pub effort: u64,
    /// What part of it may go into preferences.
    pub quality: u8,
    /// Whether it may take only so long.
    pub limited: bool,
    /// Whether a language model proposes moves.
    pub advised: bool,
}

/// What decides where things are; `layout` has the shapes of the objects.
pub fn layout_inputs(program: &Program, layout: &Layout, how: &How<'_>) -> Inputs {
    let names = Names(program);
    let mut out = Inputs::new();
    for (object, (name, placement)) in program.objects.iter().zip(&layout.objects) {
        let said = (&object.role, &object.category, &object.features, shape(placement));
        out.insert(format!("object {name}"), sum_of(&said));
    }
    for region in &program.regions {
        let said = (region.text("features"), region.has_vertices, region.has_scale);
        out.insert(format!("region {}", region.name), sum_of(&said));
    }
    for variable in &program.variables {
        out.insert(format!("variable {}", variable.name), sum_of(&(variable.kind, variable.used)));
    }
    for draw in &program.draws {
        let bounds = names.formula(&draw.lo) + &names.formula(&draw.hi);
        out.insert(format!("draw {}", draw.key), sum(bounds.as_bytes()));
    }
    for constraint in &program.constraints {
        let (kind, weight) = match constraint.kind {
            ConstraintKind::Assert => ("assert", 0.0),
            ConstraintKind::Prefer { weight } => ("prefer", weight),
            ConstraintKind::Pin => ("assign", 0.0),
        };
        let said = names.formula(&constraint.formula) + &weight.to_string();
        insert(&mut out, &format!("{kind} {}", constraint.text), &sum(said.as_bytes()));
    }
    for pin in &program.pins {
        let owner = match pin.owner {
            Owner::Object(id) => &program.objects[id.0 as usize].name,
            Owner::Region(id) => &program.regions[id.0 as usize].name,
        };
        let values: String = pin.values.iter().map(|value| names.formula(value)).collect();
        insert(&mut out, &format!("value of {owner} {:?}", pin.property), &sum(values.as_bytes()));
    }
    let allow = &program.allow;
    for stated in &allow.stated {
        insert(
            &mut out,
            &format!("statement {}", stated.text),
            &sum(names.of(&(stated.rule, &stated.arguments)).as_bytes()),
        );
    }
    let mounts: Vec<_> = allow.mounts.iter().map(|mount| (mount.object, mount.region, mount.on)).collect();
    out.insert("rules".into(), sum(names.of(&(&allow.contents, mounts, &allow.doors)).as_bytes()));
    out.insert("judging".into(), sum_of(how.judge));
    out.insert("seed".into(), how.seed.to_string());
    out.insert("effort".into(), how.effort.to_string());
    out.insert("quality".into(), how.quality.to_string());
    out.insert("time".into(), how.limited.to_string());
    out.insert("model".into(), how.advised.to_string());
    out.insert("scenelang".into(), env!("CARGO_PKG_VERSION").to_owned());
    out
}

/// Adds an input; the second of a name gets a number.
fn insert(inputs: &mut Inputs, name: &str, sum: &str) {
    let short: String = name.chars().take(NAMED).collect();
    let mut key = short.clone();
    let mut count = 1;
    while inputs.contains_key(&key) {
        count += 1;
        key = format!("{short} #{count}");
    }
    inputs.insert(key, sum.to_owned());
}

/// Whether what is preferred, or how much is done for it, differs.
pub fn prefers_otherwise(before: &Inputs, now: &Inputs) -> bool {
    let told = |inputs: &Inputs| -> Vec<(String, String)> {
        let is_told =
            |key: &str| ["prefer ", "quality", "effort", "judging", "time"].iter().any(|start| key.starts_with(start));
        inputs.iter().filter(|(key, _)| is_told(key)).map(|(k, v)| (k.clone(), v.clone())).collect()
    };
    told(before) != told(now)
}

/// Values with names of objects in place of their numbers, which change when another one is declared before them.
struct Names<'a>(&'a Program);

impl Names<'_> {
    fn formula(&self, formula: &Formula) -> String {
        self.of(&(&formula.nodes, formula.root))
    }

    fn of(&self, value: &impl Debug) -> String {
        let text = format!("{value:?}");
        let mut out = String::with_capacity(text.len());
        let mut rest = text.as_str();
        while let Some(at) = rest.find("Id(") {
            let (before, from) = rest.split_at(at + 3);
            let digits = from.bytes().take_while(u8::is_ascii_digit).count();
            out.push_str(before);
            let name = from[..digits].parse().ok().and_then(|index: usize| self.name(before, index));
            match name {
                Some(name) => drop(write!(out, "{name:?}")),
                None => out.push_str(&from[..digits]),
            }
            rest = &from[digits..];
        }
        out + rest
    }

    /// What is called so; `None`: its number says it.
    fn name(&self, before: &str, index: usize) -> Option<&str> {
        let Program { objects, regions, variables, draws, .. } = self.0;
        if before.ends_with("ObjectId(") {
            objects.get(index).map(|object| object.name.as_str())
        } else if before.ends_with("RegionId(") {
            regions.get(index).map(|region| region.name.as_str())
        } else if before.ends_with("VariableId(") {
            variables.get(index).map(|variable| variable.name.as_str())
        } else if before.ends_with("DrawId(") {
            draws.get(index).map(|draw| draw.key.as_str())
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::furnish;
    use scenelang_lang::compile::compile_text;
    use std::path::Path;

    fn inputs(text: &str) -> Inputs {
        let compiled = compile_text("room.scene", Path::new("room.scene"), text, scenelang_lang::Options::default());
        let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let judge = Options::default();
        let layout = furnish(&program, Vec::new(), None, &judge).layout;
        layout_inputs(
            &program,
            &layout,
            &How { judge: &judge, seed: 0, effort: 1, quality: 20, limited: false, advised: false },
        )
    }

    const ROOM: &str = "region room; object desk; desk.category <- \"desk\"; object lamp; lamp.category <- \"lamp\";\n\
        assert above(lamp, desk); assert desk.pos.x > 1; prefer desk.pos.z > 0;";

    #[test]
    fn what_does_not_decide_where_things_are_is_no_input() {
        let room = inputs(ROOM);
        let same = [
            ROOM.replace("region room;", "// A room.\n\nregion room;"),
            ROOM.replace("desk.category", "desk.color <- \"red\"; desk.category"),
            ROOM.replace("region room;", "region room; room.wallColor <- \"red\";"),
        ];
        for text in same {
            assert_eq!(inputs(&text), room, "{text}");
        }
    }

    #[test]
    fn what_decides_where_things_are_is_one_input_each() {
        let room = inputs(ROOM);
        let changed = |text: &str| -> Vec<String> {
            let now = inputs(text);
            let keys: std::collections::BTreeSet<&String> = room.keys().chain(now.keys()).collect();
            keys.into_iter().filter(|key| room.get(*key) != now.get(*key)).cloned().collect()
        };
        let chair = "object chair; chair.category <- \"chair\"; region room;";
        for (old, new, wanted) in [
            ("x > 1", "x > 2", vec!["assert desk.pos.x > 1", "assert desk.pos.x > 2"]),
            // The numbers of all other objects change with it.
            ("region room;", chair, vec!["object chair"]),
            (
                "desk.category",
                "desk.dimensions <- vec3(2, 0.7, 1); desk.category",
                vec!["assign desk.dimensions <- vec3(2, 0.7, 1)", "object desk", "value of desk Scale"],
            ),
            ("prefer", "allowCollide(lamp, desk); prefer", vec!["statement allowCollide(lamp, desk)"]),
            (
                "desk.pos.z > 0;",
                "desk.pos.z > 0 weight 3;",
                vec!["prefer desk.pos.z > 0", "prefer desk.pos.z > 0 weight 3"],
            ),
        ] {
            assert_eq!(changed(&ROOM.replacen(old, new, 1)), wanted, "{new}");
        }
    }

    #[test]
    fn a_look_says_what_differs() {
        let old = AssetInput { color: "oak".into(), size: [1.0, 2.0, 0.5], ..AssetInput::default() };
        let new = AssetInput { color: "red".into(), size: [1.0, 2.0, 1.5], ..AssetInput::default() };
        assert_eq!(
            new.changes(&old),
            ["color has changed from \"oak\" to \"red\"", "size has changed from 1 × 2 × 0.5 m to 1 × 2 × 1.5 m"]
        );
        assert!(new.changes(&new).is_empty() && !new.asks_the_same(&old));
    }
}
