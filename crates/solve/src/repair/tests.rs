//! Solved scenes of the sample problems, damaged: all that can be solved are repaired, by few moves, the same each time. And
//! what is offered for a small scene.

use super::judge::row;
use super::{Alternative, Damaged, How, RepairOptions, Repaired, Text, Which, repair};
use crate::pipeline::solve;
use crate::problem::{Options, Placed, Problem};
use scenelang_base::door::Door;
use scenelang_base::{SourceFile, SourceMap};
use scenelang_engine::check;
use scenelang_lang::Program;
use scenelang_lang::compile::compile_main;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, Vec3, file};
use scenelang_verify::Explain;
use scenelang_verify::check::{Judged, Subject};
use scenelang_verify::explain::{ObjectMove, RowRef};
use scenelang_verify::report::model::RowKind;
use std::ops::ControlFlow;
use std::path::Path;

#[path = "../../examples/repair_measure/damage.rs"]
mod damage;

use damage::{Damage, damaged, fails, scenes};

#[test]
fn damaged_samples_are_repaired_by_few_moves() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/problems/sample");
    let mut moved = Vec::new();
    let mut wrong = Vec::new();
    for (i, scene) in scenes(&folder).iter().enumerate() {
        for damage in [Damage::Displaced, Damage::Tightened] {
            let Some(hurt) = damaged(scene, damage, i as u64) else { continue };
            let name = format!("{}: {}", scene.display(), hurt.what);
            let asked = Damaged { program: &hurt.program, layout: &hurt.layout, text: None };
            let found = repair(&asked, &Which::All, &RepairOptions::default()).unwrap();
            assert!(!found.failing.is_empty(), "{name}");
            let Some(best) = found.alternatives.first().filter(|a| a.how == How::Moves) else {
                // Not all that is tightened can still be satisfied.
                let (program, start) = (&hurt.program, hurt.layout.clone());
                let problem = Problem { program, start, placed: Placed::None };
                let solver = Options { budget: RepairOptions::default().budget, ..Options::default() };
                if solve(&problem, &solver, &mut |_| ControlFlow::Continue(())).converged {
                    wrong.push(name);
                }
                continue;
            };
            assert!(!fails(&hurt.program, &best.layout), "{name}");
            assert!(fails(&hurt.program, &hurt.layout), "{name}");
            moved.push(best.moves.len());
            let again = repair(&asked, &Which::All, &RepairOptions::default()).unwrap();
            assert_eq!(found, again, "{name}");
        }
    }
    moved.sort_unstable();
    assert!(moved.len() >= 18, "{moved:?}");
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(moved[moved.len() / 2] <= 2, "{moved:?}");
}

/// The rows that fail.
fn failing(program: &Program, layout: &Layout, explain: Explain) -> Vec<Judged> {
    let mut options = scenelang_verify::Options::default();
    options.detail.explain = explain;
    let verdict = check(program, layout, &options);
    verdict.rows.into_iter().filter(|row| row.satisfied != Some(true)).collect()
}

#[test]
fn check_and_repair_offer_the_same_moves_and_these_break_nothing() {
    const ROWS: usize = 3;
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/problems/sample");
    let mut same = 0;
    for (i, scene) in scenes(&folder).iter().enumerate() {
        for damage in [Damage::Displaced, Damage::Tightened] {
            let Some(hurt) = damaged(scene, damage, i as u64) else { continue };
            let asked = Damaged { program: &hurt.program, layout: &hurt.layout, text: None };
            let rows = failing(&hurt.program, &hurt.layout, Explain::default());
            let before: Vec<RowRef> = rows.iter().map(row).collect();
            for judged in rows.iter().filter(|r| r.kind != RowKind::Prefer).take(ROWS) {
                let name = format!("{}, {}: {}", scene.display(), hurt.what, judged.text);
                let offered = judged.explanation.as_ref().and_then(|e| e.repair.as_ref());
                // What breaks something says so, and is not what repair offers.
                let Some(offered) = offered.filter(|m| m.breaks.is_empty()) else { continue };
                let found = repair(&asked, &Which::Rows(vec![row(judged)]), &RepairOptions::default()).unwrap();
                let best = &found.alternatives[0];
                assert_eq!(best.how, How::Moves, "{name}");
                let mut steps: Vec<&ObjectMove> = offered.steps.iter().collect();
                steps.sort_by_key(|step| step.object);
                let objects = |ids: &mut dyn Iterator<Item = ObjectId>| ids.collect::<Vec<_>>();
                let ours = objects(&mut steps.iter().map(|s| s.object));
                assert_eq!(ours, objects(&mut best.moves.iter().map(|m| m.object)), "{name}");
                for (step, m) in steps.iter().zip(&best.moves) {
                    assert!((m.to.pos - m.from.pos - Vec3::from(step.by)).amax() < 1e-3, "{name}");
                }
                let after = failing(&hurt.program, &best.layout, Explain::First(0));
                assert!(after.iter().all(|r| before.contains(&row(r)) && row(r) != row(judged)), "{name}");
                same += 1;
            }
        }
    }
    assert!(same >= 20, "{same}");
}

const SCENE: &str = "\
region room;
room.pos <- vec3(0, 0, 0);
room.scale <- vec3(4, 2.7, 4);
object sofa;
object table;
object lamp;
object plant;
Number near;
Number most;
most <- 30cm;
sofa.pos <- vec3(0, 0, -1.4);
assert gap(table, sofa) <= 0.3;
assert on(lamp, table);
assert gap(plant, sofa) <= most;
assert distance(lamp, plant) >= near;
prefer table.pos.x = 0;
";

fn layout(table: [f64; 3], lamp: [f64; 3], plant: [f64; 3]) -> Layout {
    let text = format!(
        r#"{{ "format": "scenelang.layout/1", "objects": {{
            "sofa": {{ "pos": [0, 0, -1.4], "scale": [1.8, 0.8, 0.9] }},
            "table": {{ "pos": {table:?}, "scale": [1, 0.45, 0.6] }},
            "lamp": {{ "pos": {lamp:?}, "scale": [0.2, 0.4, 0.2] }},
            "plant": {{ "pos": {plant:?}, "scale": [0.3, 1, 0.3] }} }},
          "regions": {{ "room": {{ "pos": [0, 0, 0], "scale": [4, 2.7, 4] }} }}, "variables": {{ "near": 0.1 }} }}"#
    );
    let read = file::read(&text, scenelang_base::FileId(0));
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    read.layout
}

/// The alternatives for a layout: what they move, which texts they replace by which, and how far at least.
fn told(scene: &str, layout: &Layout, which: &Which) -> (Repaired, Vec<String>) {
    let path = Path::new("room.scene");
    let mut sources = SourceMap::new();
    let main = sources.add(SourceFile::new("room.scene", path, scene));
    let compiled = compile_main(main, scenelang_lang::Options::default(), &Door::of(path), sources);
    let program = compiled.program.unwrap();
    struct Memory<'t>(&'t str);
    impl scenelang_lang::sources::Loader for Memory<'_> {
        fn load(&self, _: &Path) -> std::io::Result<Vec<u8>> {
            Ok(self.0.as_bytes().to_vec())
        }
    }
    let text = Text {
        name: "room.scene",
        path,
        compile: scenelang_lang::Options::default(),
        loader: &Memory(scene),
        sources: &compiled.sources,
    };
    let asked = Damaged { program: &program, layout, text: Some(text) };
    let found = repair(&asked, which, &RepairOptions::default()).unwrap();
    let name = |a: &Alternative| {
        let moves = a.moves.iter().map(|m| {
            let with = m.with.map_or(String::new(), |w| format!(" with {}", program.objects[w.0 as usize].name));
            let by = m.to.pos - m.from.pos;
            let name = &program.objects[m.object.0 as usize].name;
            format!("{name} ({:.2}, {:.2}, {:.2}){with}", by.x + 0.0, by.y + 0.0, by.z + 0.0)
        });
        let edits = a.edits.iter().enumerate().map(|(i, e)| {
            let least = a.least.get(i).map_or(String::new(), |l| format!(" by {l:.3}"));
            format!("{} -> {}{least}", compiled.sources.text(e.place), e.text)
        });
        let drops = a.drops.iter().map(|i| format!("drop {}", program.constraints[*i].text));
        let all: Vec<String> = moves.chain(edits).chain(drops).collect();
        format!("{:?}: {}", a.how, all.join(", "))
    };
    let words = found.alternatives.iter().map(name).collect();
    (found, words)
}

const GOOD: [[f64; 3]; 3] = [[0.0, 0.0, -0.4], [0.2, 0.45, -0.4], [1.2, 0.0, -1.4]];

#[test]
fn what_holds_needs_nothing() {
    let (found, _) = told(SCENE, &layout(GOOD[0], GOOD[1], GOOD[2]), &Which::All);
    assert_eq!(found, Repaired { failing: Vec::new(), contradiction: None, alternatives: Vec::new() });
}

#[test]
fn moves_numbers_and_preferences_are_offered_in_this_order() {
    let (_, words) = told(SCENE, &layout([0.0; 3], [0.2, 0.45, 0.0], GOOD[2]), &Which::All);
    assert_eq!(
        words,
        [
            "Moves: table (0.00, 0.00, -0.35), lamp (0.00, 0.00, -0.35) with table",
            "Numbers: 0.3 -> 0.65 by 0.350",
            "Prefer: assert -> prefer",
        ]
    );
}

#[test]
fn a_number_is_relaxed_where_it_is_written_and_in_its_unit() {
    let (_, words) = told(SCENE, &layout(GOOD[0], GOOD[1], [1.6, 0.0, -1.4]), &Which::All);
    assert_eq!(
        words,
        ["Moves: plant (-0.25, 0.00, 0.00)", "Numbers: 30cm -> 55cm by 25.000", "Prefer: assert -> prefer"]
    );
}

#[test]
fn one_row_is_repaired_and_others_may_go_on_failing() {
    let hurt = layout([0.0; 3], [0.2, 0.45, 0.0], [1.6, 0.0, -1.4]);
    let (all, words) = told(SCENE, &hurt, &Which::All);
    assert_eq!((all.failing.len(), all.alternatives[0].moves.len()), (2, 3), "{words:?}");
    let row = *all.failing.iter().find(|r| matches!(r.subject, Subject::Statement(_))).unwrap();
    let (one, words) = told(SCENE, &hurt, &Which::Rows(vec![row]));
    assert_eq!((one.failing.as_slice(), one.alternatives[0].moves.len()), ([row].as_slice(), 2), "{words:?}");
}

#[test]
fn a_preference_in_the_way_is_given_up_only_where_nothing_else_helps() {
    let scene = SCENE.replace("assert gap(table, sofa) <= 0.3;", "assert table.pos.x >= 0.5;");
    let (found, words) = told(&scene, &layout(GOOD[0], GOOD[1], GOOD[2]), &Which::All);
    assert_eq!(words[0], "Numbers: 0.5 -> 0 by -0.500", "{words:?}");
    assert!(
        words.iter().any(|w| w.starts_with("Drop: table (0.50,") && w.contains("drop table.pos.x = 0")),
        "{words:?}"
    );
    assert!(found.alternatives.iter().all(|a| a.how != How::Moves));
}

#[test]
fn a_pinned_object_goes_back_to_its_pin_and_a_preference_can_be_asked_for() {
    let mut hurt = layout(GOOD[0], GOOD[1], GOOD[2]);
    hurt.objects[0].1.pos.x = 0.3;
    let (found, words) = told(SCENE, &hurt, &Which::All);
    assert!(found.failing.iter().any(|r| r.kind == RowKind::Pin));
    assert_eq!(words[0], "Moves: sofa (-0.30, 0.00, 0.00)", "{words:?}");
    let preference = |found: &Repaired| found.failing.iter().all(|r: &RowRef| r.kind == RowKind::Prefer);
    let aside = layout([0.4, 0.0, -0.4], [0.4, 0.45, -0.4], GOOD[2]);
    let index = SCENE.lines().filter(|l| ["assert", "prefer"].iter().any(|k| l.starts_with(k))).count();
    let rows: Vec<RowRef> =
        (0..index + 8).map(|i| RowRef { kind: RowKind::Prefer, subject: Subject::Statement(i) }).collect();
    let (found, words) = told(SCENE, &aside, &Which::Rows(rows));
    assert!(preference(&found) && words[0].starts_with("Moves: table (-0.40, 0.00, 0.00)"), "{words:?}");
    assert!(told(SCENE, &aside, &Which::All).0.failing.is_empty());
}
