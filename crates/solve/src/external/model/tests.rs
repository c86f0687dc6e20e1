//! A model that plays a script, in the loop: what it is told, what is taken of what it says, what is refused.

use super::*;
use crate::problem::{Options, Placed, Problem};
use crate::{Outcome, solve};
use scenelang_lang::{Options as Reading, Program, compile_text};
use scenelang_layout::{Layout, Placement, Vec3};
use scenelang_llm::{Reply, Usage};
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::path::Path;

/// A table and two lamps in a room; the lamps belong to the right of the table, and they are not there.
const SCENE: &str = r#"
region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(6, 3, 5);
object table; table.dimensions <- vec3(1, 1, 1); table.pos <- vec3(0, 0, 0); table.rot <- rot(0, 0, 0);
object lamp; lamp.dimensions <- vec3(0.4, 1, 0.4);
object plant; plant.dimensions <- vec3(0.4, 1, 0.4);
@req("the lamp stands to the right of the table")
assert table.pos.x + 1 <= lamp.pos.x;
assert table.pos.x + 1 <= plant.pos.x;
assert lamp.pos.z <= 2;
prefer lamp.pos.z = 1 weight 2;
"#;

fn program(text: &str) -> Program {
    let compiled = compile_text("t.scene", Path::new("t.scene"), text, Reading::default());
    compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics))
}

fn start() -> Layout {
    let mut layout = Layout::default();
    for (name, x, edge) in [("table", 0.0, 1.0), ("lamp", -2.0, 0.4), ("plant", -1.0, 0.4)] {
        let scale = Vec3::new(edge, 1.0, edge);
        let placement = Placement {
            pos: Vec3::new(x, 0.0, 0.0),
            rot: Vec3::zeros(),
            scale,
            parts: vec![],
            surface: None,
            joints: Vec::new(),
        };
        layout.objects.push((name.into(), placement));
    }
    layout
}

/// Answers from a list, the last one again and again, and remembers the questions.
struct Scripted {
    says: Vec<Result<String, Error>>,
    asked: Vec<Request>,
}

impl Scripted {
    fn new(says: Vec<Result<String, Error>>) -> Self {
        Self { says, asked: Vec::new() }
    }
    fn told(&self, n: usize) -> Value {
        serde_json::from_str(&self.asked[n].messages[1].text).unwrap()
    }
}

impl Model for Scripted {
    fn name(&self) -> &str {
        "scripted"
    }
    fn ask(&mut self, request: &Request) -> Result<Reply, Error> {
        let n = self.asked.len().min(self.says.len() - 1);
        self.asked.push(request.clone());
        self.says[n].clone().map(|text| Reply { text, usage: Usage::default() })
    }
}

fn moves(moves: &[(&str, [f64; 3])]) -> Result<String, Error> {
    let one = |(name, pos): &(&str, [f64; 3])| {
        let zero = json!({ "x": 0, "y": 0, "z": 0 });
        json!({ "object": name, "reason": null, "pos": { "x": pos[0], "y": pos[1], "z": pos[2] }, "rot": zero })
    };
    Ok(json!({ "moves": moves.iter().map(one).collect::<Vec<_>>() }).to_string())
}

fn run(says: Vec<Result<String, Error>>, finisher: Finisher) -> (Hybrid, Scripted) {
    let program = program(SCENE);
    let problem = Problem { program: &program, start: start(), placed: Placed::All };
    let mut model = Scripted::new(says);
    let asking = Asking::default();
    let go = &mut |_| ControlFlow::Continue(());
    (hybrid(&problem, &Options::default(), &mut model, asking, finisher, go), model)
}

fn x(outcome: &Outcome, name: &str) -> f64 {
    outcome.layout.object(name).unwrap().pos.x
}

#[test]
fn a_good_answer_is_taken() {
    let (hybrid, model) = run(vec![moves(&[("lamp", [2.0, 0.0, 1.0]), ("plant", [2.0, 0.0, -1.0])])], Finisher::None);
    assert_eq!(hybrid.tally, Tally { rounds: 1, proposed: 2, taken: 2, failed: None });
    assert!(hybrid.outcome.converged && !hybrid.without);
    assert_eq!((x(&hybrid.outcome, "lamp"), x(&hybrid.outcome, "plant")), (2.0, 2.0));
    assert_eq!(model.asked.len(), 1);
}

#[test]
fn a_model_is_told_all_it_needs() {
    let (_, model) = run(vec![moves(&[])], Finisher::None);
    let request = &model.asked[0];
    assert_eq!((request.temperature, request.seed, request.messages[0].role), (Some(0.7), Some(1), Role::System));
    let told = model.told(0);
    assert_eq!(told["regions"][0]["size"], json!({ "x": 6.0, "y": 3.0, "z": 5.0 }));
    assert_eq!(told["objects"][0]["fixed"], true);
    let lamp = json!({ "x": -2.0, "y": 0.0, "z": 0.0 });
    assert_eq!((&told["objects"][1]["name"], &told["objects"][1]["pos"]), (&json!("lamp"), &lamp));
    let violated = told["violated"].as_array().unwrap();
    assert_eq!(violated.len(), 2);
    let of_lamp = violated.iter().find(|v| v["objects"].as_array().unwrap().contains(&json!("lamp"))).unwrap();
    assert_eq!(of_lamp["constraint"], "table.pos.x + 1 <= lamp.pos.x");
    assert_eq!(of_lamp["requirements"], json!(["the lamp stands to the right of the table"]));
    assert_eq!(of_lamp["margin"], -3.0);
    let all = told["constraints"].as_array().unwrap();
    assert!(all.iter().any(|c| c["constraint"] == "lamp.pos.z <= 2" && c["holds"] == true && c["margin"] == 2.0));
    assert!(all.iter().any(|c| c["preference_of_weight"] == 2.0));
}

#[test]
fn there_are_five_rounds_of_three_constraints() {
    let mut text = SCENE.to_owned();
    text += &(0..6).map(|i| format!("assert lamp.pos.x >= 1.{i};\n")).collect::<String>();
    let program = program(&text);
    let problem = Problem { program: &program, start: start(), placed: Placed::All };
    let mut model = Scripted::new(vec![moves(&[])]);
    let go = &mut |_| ControlFlow::Continue(());
    let hybrid = hybrid(&problem, &Options::default(), &mut model, Asking::default(), Finisher::None, go);
    assert!(!hybrid.outcome.converged);
    assert_eq!(model.asked.len(), 5);
    assert!((0..5).all(|n| model.told(n)["violated"].as_array().unwrap().len() == 3));
    let seeds: Vec<_> = model.asked.iter().map(|r| r.seed).collect();
    assert_eq!(seeds, (1..=5).map(Some).collect::<Vec<_>>(), "no question is asked twice");
}

#[test]
fn what_breaks_what_holds_is_refused_and_told() {
    // To the right of the table, but too far back: `lamp.pos.z <= 2` holds and would not.
    let says = vec![moves(&[("lamp", [2.0, 0.0, 2.2])]), moves(&[])];
    let (hybrid, model) = run(says, Finisher::None);
    assert_eq!((hybrid.tally.proposed, hybrid.tally.taken), (1, 0));
    assert_eq!(x(&hybrid.outcome, "lamp"), -2.0);
    let refused = &model.told(1)["refused_last_time"];
    assert_eq!(refused, &json!(["the new position of lamp repairs nothing, or violates a constraint that holds"]));
    assert_eq!(model.told(2).get("refused_last_time"), None);
}

#[test]
fn of_an_answer_the_good_part_is_taken() {
    let says = vec![
        moves(&[
            ("lamp", [2.0, 0.0, 1.0]),
            ("plant", [2.0, 0.0, 1.0]), // where the lamp is now
            ("table", [-2.0, 0.0, 0.0]),
            ("ghost\u{1b}[31m", [0.0, 0.0, 0.0]),
            ("lamp", [0.0, 0.0, 0.0]),
        ]),
        moves(&[]),
    ];
    let (hybrid, model) = run(says, Finisher::None);
    assert_eq!((hybrid.tally.proposed, hybrid.tally.taken), (5, 1));
    assert_eq!((x(&hybrid.outcome, "lamp"), x(&hybrid.outcome, "plant")), (2.0, -1.0));
    assert_eq!(
        model.told(1)["refused_last_time"],
        json!([
            "table is fixed",
            "there is no object `ghost [31m`",
            "lamp was moved twice",
            "the new position of plant repairs nothing, or violates a constraint that holds",
        ])
    );
}

#[test]
fn no_answer_is_no_harm() {
    let program = program(SCENE);
    let problem = Problem { program: &program, start: start(), placed: Placed::All };
    let alone = solve(&problem, &Options::default(), &mut |_| ControlFlow::Continue(()));
    assert!(alone.converged);
    let malformed = || Ok("no JSON".to_owned());
    for (says, asked, failed) in [
        (vec![Err(Error::Spent("2 of 2 calls".into()))], 1, Some(Error::Spent("2 of 2 calls".into()))),
        (vec![Err(Error::Offline)], 1, Some(Error::Offline)),
        // A bad answer is sent back once in each of the five rounds.
        (vec![malformed()], 10, Some(Error::Malformed("it contains no JSON object".into()))),
        (vec![malformed(), malformed(), moves(&[("lamp", [2.0, 0.0, 1.0]), ("plant", [2.0, 0.0, -1.0])])], 3, None),
        (vec![moves(&[("lamp", [1e300, 0.0, 0.0])])], 5, None),
        (vec![moves(&[("lamp", [-2.0, 2.0, 0.0]), ("plant", [0.0, 0.5, 0.0])])], 5, None),
    ] {
        let shown = format!("{says:?}");
        let (hybrid, model) = run(says, Finisher::Numeric);
        assert_eq!(model.asked.len(), asked, "{shown}");
        assert_eq!(hybrid.tally.failed, failed, "{shown}");
        assert!(hybrid.outcome.converged, "{shown}");
        assert!(hybrid.outcome.unsatisfied.len() <= alone.unsatisfied.len(), "{shown}");
    }
}

#[test]
fn the_same_answers_give_the_same_layout() {
    let says = || vec![moves(&[("lamp", [2.0, 0.0, 2.2])]), moves(&[("plant", [2.0, 0.0, 0.0])])];
    assert_eq!(run(says(), Finisher::Numeric).0, run(says(), Finisher::Numeric).0);
}

#[test]
fn without_rounds_nobody_is_asked() {
    let program = program(SCENE);
    let problem = Problem { program: &program, start: start(), placed: Placed::All };
    let mut model = Scripted::new(vec![moves(&[])]);
    let go = &mut |_| ControlFlow::Continue(());
    let asking = Asking { rounds: 0, ..Asking::default() };
    let hybrid = hybrid(&problem, &Options::default(), &mut model, asking, Finisher::Numeric, go);
    assert_eq!(model.asked.len(), 0);
    assert_eq!(hybrid.outcome, solve(&problem, &Options::default(), go));
}

#[test]
fn the_better_way_is_kept() {
    // Random answers over and over: whatever the model says, the end is never worse than without it.
    let mut text = SCENE.to_owned();
    for i in 0..6 {
        text +=
            &format!("object box{i}; box{i}.dimensions <- vec3(0.8, 0.8, 0.8); assert box{i}.pos.x >= table.pos.x;\n");
    }
    let program = program(&text);
    let badness = |o: &Outcome| hybrid::badness(&program, o);
    for seed in 0..6_u32 {
        let problem = Problem { program: &program, start: Layout::default(), placed: Placed::None };
        let options = Options { seed: u64::from(seed), budget: 3_000_000, ..Options::default() };
        let go = &mut |_| ControlFlow::Continue(());
        let alone = solve(&problem, &options, go);
        let at = |n: u32| f64::from((seed * 7 + n * 13) % 60) / 10.0 - 3.0;
        let says = (0..5).map(|n| moves(&[("lamp", [at(n), 0.0, at(n + 5)]), ("box1", [at(n + 3), 0.0, at(n + 1)])]));
        let mut model = Scripted::new(says.collect());
        let with = hybrid(&problem, &options, &mut model, Asking::default(), Finisher::Numeric, go);
        assert!(badness(&with.outcome) <= badness(&alone), "{seed}: {:?}", with.tally);
    }
}
