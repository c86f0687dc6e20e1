//! Solution correctness of our search, of the rebuilt floor solver, and of a model that answers by a script.

use scenelang_eval::correctness::{compiled, direct, grid, iterations, laid_out, satisfied};
use scenelang_eval::dataset::{DatasetScene, scene};
use scenelang_llm::{Error, Model, Reply, Request, Usage};
use scenelang_solve::Stop;
use serde_json::{Value, json};

const SEED: u64 = 7;

#[test]
fn the_search_gets_better_and_the_grid_is_behind_it() {
    let mut sums = [0; 3];
    for number in 0..3 {
        let scene = scene(SEED, number);
        let program = compiled(&scene.program).unwrap();
        let steps = iterations(&program, SEED, &Stop::default());
        assert_eq!(steps.len(), 6);
        let shares: Vec<usize> = steps.iter().map(|step| step.stated.part).collect();
        assert!(steps.iter().all(|step| step.stated.whole == scene.instances()), "{steps:?}");
        assert!(shares[5] >= shares[0], "{shares:?}");
        let placed = grid::place(&scene, &program, SEED);
        let judged = satisfied(&program, &placed.layout);
        assert!(!placed.is_cut && placed.work > 0 && judged.stated.whole == scene.instances());
        sums = [sums[0] + shares[0], sums[1] + shares[5], sums[2] + judged.stated.part];
    }
    assert!(sums[0] < sums[1] && sums[2] < sums[1] && sums[2] > 0, "{sums:?}");
}

/// What the floor solver places does not overlap on the floor, stands inside, and is the same each time.
#[test]
fn the_grid_keeps_its_own_rules() {
    for number in 0..6 {
        let scene = scene(SEED, number);
        let program = compiled(&scene.program).unwrap();
        let placed = grid::place(&scene, &program, SEED);
        assert_eq!(placed.layout, grid::place(&scene, &program, SEED).layout);
        assert_eq!(placed.layout.objects.len() + placed.dropped, program.objects.len());
        let floor: Vec<_> = placed.layout.objects.iter().filter(|(_, p)| p.pos.y == 0.0).collect();
        assert!(floor.len() > 3, "{}", scene.id);
        let half = |p: &scenelang_layout::Placement| {
            let turned = (p.rot.y / 90.0).round() as i64 % 2 != 0;
            if turned { [p.scale.z / 2.0, p.scale.x / 2.0] } else { [p.scale.x / 2.0, p.scale.z / 2.0] }
        };
        let is_link = |name: &str| scene.connections.iter().any(|c| c.name == name);
        for (i, (a, p)) in floor.iter().enumerate() {
            for (b, q) in &floor[..i] {
                let (h, k) = (half(p), half(q));
                let apart =
                    (p.pos.x - q.pos.x).abs() >= h[0] + k[0] - 1e-5 || (p.pos.z - q.pos.z).abs() >= h[1] + k[1] - 1e-5;
                assert!(apart || is_link(a) || is_link(b), "{}: {a} and {b}", scene.id);
            }
        }
    }
}

/// Answers with these texts, one after the other, and remembers what it was asked.
struct Script(Vec<String>, Vec<Request>);

impl Model for Script {
    fn name(&self) -> &str {
        "script"
    }
    fn ask(&mut self, request: &Request) -> Result<Reply, Error> {
        self.1.push(request.clone());
        Ok(Reply { text: self.0.remove(0), usage: Usage::default() })
    }
}

fn answer(scene: &DatasetScene, change: impl Fn(&str, &mut Value)) -> String {
    let program = compiled(&scene.program).unwrap();
    let laid = laid_out(&scene.program, SEED, &Stop::default()).unwrap();
    let one = |object: &scenelang_lang::program::Object| {
        let placement = laid.layout.object(&object.name).unwrap();
        let mut one = json!({
            "name": object.name.as_str(), "x": placement.pos.x, "y": placement.pos.y, "z": placement.pos.z,
            "yaw": placement.rot.y,
        });
        change(&object.name, &mut one);
        one
    };
    json!({ "objects": program.objects.iter().map(one).collect::<Vec<_>>() }).to_string()
}

#[test]
fn a_model_is_asked_directly() {
    let scene = scene(SEED, 0);
    let program = compiled(&scene.program).unwrap();
    // As good as our own layout; what it says of what there is not does no harm.
    let good = answer(&scene, |_, _| ());
    let mut script = Script(vec![format!("Here: {good}")], Vec::new());
    let answered = direct::place(&mut script, &scene, &program, SEED).unwrap();
    assert_eq!((answered.missing, answered.refused), (0, 0));
    let judged = satisfied(&program, &answered.layout);
    assert_eq!(judged.stated.part, judged.stated.whole);
    let told = &script.1[0].messages[1].text;
    let told: Value = serde_json::from_str(told).unwrap();
    assert_eq!(told["request"], scene.request.as_str());
    assert_eq!(told["objects"].as_array().map(Vec::len), Some(program.objects.len()));
    assert!(!told.to_string().contains("assert"), "it is not told the program");

    // Things that it leaves out, or puts nowhere, are missing; what depends on them does not hold.
    let first = program.objects[program.objects.len() - 1].name.clone();
    let bad = answer(&scene, |name, one| match name {
        name if name == first => one["name"] = "no such thing".into(),
        _ => {}
    });
    let mut script = Script(vec!["no".to_owned(), bad], Vec::new());
    let answered = direct::place(&mut script, &scene, &program, SEED).unwrap();
    assert_eq!((answered.missing, answered.refused, script.1.len()), (1, 1, 2));
    let judged = satisfied(&program, &answered.layout);
    assert!(judged.all.part < judged.all.whole);
    let mut script = Script(vec!["no".to_owned(), "{}".to_owned()], Vec::new());
    assert!(direct::place(&mut script, &scene, &program, SEED).is_err());
}
