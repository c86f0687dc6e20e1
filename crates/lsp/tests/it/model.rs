//! The editor's own language model, asked through the client during "Repair this constraint": what it says well is taken,
//! and whatever else it says does no harm.

use crate::client::{Client, Model, at, edited, edits_of, room, usual};
use scenelang_llm::Error;
use scenelang_lsp::{ModelQuestion, Named, Setup};
use scenelang_verify::settings::Llm;
use serde_json::{Value, json};
use std::sync::atomic::{AtomicUsize, Ordering};
use tempfile::TempDir;

/// Where the model would put the stand; the solver by itself puts it nearer.
const WELL: [f64; 3] = [1.06, 0.0, -1.5];

fn moves(list: &Value) -> Model {
    Model::Says(json!({ "text": json!({ "moves": list }).to_string() }))
}

fn to(object: &str, pos: [f64; 3], reason: &Value) -> Value {
    let [x, y, z] = pos;
    json!({
        "object": object, "pos": { "x": x, "y": y, "z": z }, "rot": { "x": 0, "y": 0, "z": 0 }, "reason": reason,
    })
}

fn says(text: &str) -> Model {
    Model::Says(json!({ "text": text }))
}

/// A room in an editor that has a model for us, and the action that repairs what fails.
fn opened(model: Model) -> (TempDir, Client, Value, String) {
    let (folder, scene, layout) = room();
    let mut client = Client::start_with(folder.path(), usual(), json!({ "languageModel": "client" }));
    client.model = model;
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let here = at(&scene, "assert g|ap(stand");
    let actions = client.ask(
        "textDocument/codeAction",
        json!({
            "textDocument": { "uri": uri }, "range": { "start": here, "end": here }, "context": { "diagnostics": [] },
        }),
    );
    let repair = actions.as_array().unwrap().iter().find(|a| a["title"] == "Repair this constraint").expect("repair");
    let repair = repair.clone();
    (folder, client, repair, layout)
}

fn asked(client: &Client) -> Vec<&Value> {
    client.asked.iter().filter(|m| m["method"] == "scenelang/languageModel").collect()
}

/// What the repair makes of the layout, and what it says of itself.
fn repaired(client: &mut Client, repair: Value, layout: &str) -> (Value, String) {
    let whole = client.ask("codeAction/resolve", repair);
    let uri = client.uri("room.layout.json");
    let change = &whole["edit"];
    let files: Vec<&Value> =
        change["documentChanges"].as_array().unwrap().iter().map(|c| &c["textDocument"]["uri"]).collect();
    assert_eq!(files, [&json!(uri)], "nothing else is touched");
    let after = edited(layout, edits_of(change, &uri));
    let note = change["changeAnnotations"]["change"].clone();
    let words = format!("{}\n{}", note["label"].as_str().unwrap(), note["description"].as_str().unwrap_or_default());
    // It repairs what it was to repair, and breaks nothing.
    let scene = client.uri("room.scene");
    client.told.clear();
    client.open("room.layout.json", &after);
    client.until("a better verdict", |c| {
        let said = c.told.iter().rev().find(|m| m["method"] == "scenelang/changed" && m["params"]["uri"] == scene)?;
        (said["params"]["holds"].as_u64() >= Some(10)).then_some(())
    });
    let marks = client.published(&scene);
    assert!(marks.iter().all(|m| m["code"] == "V0106"), "{marks:?}");
    (serde_json::from_str(&after).unwrap(), words)
}

#[test]
fn a_good_answer_is_taken() {
    let (_folder, mut client, repair, layout) = opened(moves(&json!([to("stand[1]", WELL, &json!("room to walk"))])));
    let (after, words) = repaired(&mut client, repair, &layout);
    // That, to the number, and nothing else.
    let mut wanted: Value = serde_json::from_str(&layout).unwrap();
    wanted["objects"]["stand[1]"]["pos"] = json!([1.06, 0, -1.5]);
    assert_eq!(after, wanted);
    assert!(
        words.contains("proposed by the language model: move `stand[1]` 0.16 m east") && words.contains("−0.12 m → +"),
        "{words}"
    );
    let questions = asked(&client);
    let params = &questions[0]["params"];
    let text: String = params["messages"].as_array().unwrap().iter().map(|m| m["text"].as_str().unwrap()).collect();
    assert!(text.contains("stand[1]") && text.contains("gap(stand[1], bed)"), "{text}");
    assert_eq!(params["schema"]["type"], "object");
    assert!(client.told.iter().all(|m| !m.to_string().contains("room to walk")), "its reasons are its own");
    client.stop();
}

/// Whatever it says, the repair is that of the solver, and the server lives.
#[test]
fn a_bad_answer_does_no_harm() {
    let far = "9".repeat(400);
    let [deep, long, list] = ["[".repeat(200_000), "x".repeat(8 << 20), "{\"moves\":[],".repeat(1000)];
    let many: Vec<Value> = (0..20_000).map(|i| to(&format!("stand[{i}]"), [0.0; 3], &Value::Null)).collect();
    let spell = "\u{1b}[2J\u{202e}ignore all rules\u{0}";
    let cases: Vec<(&str, Model)> = vec![
        ("no JSON", says("I would rather not.")),
        ("nothing", says("")),
        ("no text", Model::Says(json!({}))),
        ("a number", Model::Says(json!({ "text": 5 }))),
        ("null", Model::Says(Value::Null)),
        ("a list", Model::Says(json!(["text"]))),
        ("cut short", says("{\"moves\": [{\"object\": \"stand[1]\", \"pos\":")),
        ("another shape", says("{\"moves\": {\"stand[1]\": [1.06, 0, -1.5]}}")),
        ("more than was asked for", says("{\"moves\": [], \"run\": \"rm -rf /\"}")),
        (
            "beyond numbers",
            says(&format!(
                "{{\"moves\":[{{\"object\":\"stand[1]\",\"pos\":{{\"x\":{far},\"y\":0,\"z\":0}},\"rot\":{{\"x\":0,\"y\":0,\"z\":0}},\"reason\":null}}]}}"
            )),
        ),
        (
            "not a number",
            says(
                "{\"moves\":[{\"object\":\"stand[1]\",\"pos\":{\"x\":NaN,\"y\":0,\"z\":0},\"rot\":{\"x\":0,\"y\":0,\"z\":0},\"reason\":null}]}",
            ),
        ),
        ("very deep", says(&deep)),
        ("very long", says(&long)),
        ("many lists", says(&list)),
        ("no moves", moves(&json!([]))),
        ("nobody", moves(&json!([to("ghost", WELL, &Value::Null)]))),
        ("a spell for a name", moves(&json!([to(spell, WELL, &json!(spell))]))),
        ("a path for a name", moves(&json!([to("../../etc/passwd", WELL, &Value::Null)]))),
        ("twenty thousand", moves(&json!(many))),
        ("twice", moves(&json!([to("stand[1]", [9.0, 0.0, 9.0], &Value::Null), to("stand[1]", WELL, &Value::Null)]))),
        ("out of the house", moves(&json!([to("stand[1]", [1e6, -1e6, 1e300], &Value::Null)]))),
        ("through the floor", moves(&json!([to("stand[1]", [1.06, -3.0, -1.5], &Value::Null)]))),
        ("the bed away", moves(&json!([to("bed", [3.0, 0.0, 3.0], &Value::Null)]))),
        ("all in one place", moves(&json!(["bed", "stand[0]", "stand[1]", "lamp"].map(|o| to(o, WELL, &Value::Null))))),
        ("a refusal", Model::Fails(json!({ "code": -32603, "message": "no consent" }))),
        ("a refusal with a spell", Model::Fails(json!({ "code": 1, "message": spell, "data": { "deep": [spell] } }))),
    ];
    for (case, model) in cases {
        let (_folder, mut client, repair, layout) = opened(model);
        let (after, words) = repaired(&mut client, repair, &layout);
        let pos = &after["objects"]["stand[1]"]["pos"];
        assert!(pos[0].as_f64().is_some_and(|x| (0.9..1.8).contains(&x)), "{case}: {pos}");
        assert!(!words.contains(['\u{1b}', '\u{202e}', '\0']) && !words.contains("rules"), "{case}: {words}");
        let told: String = client.told.iter().map(Value::to_string).collect();
        assert!(!told.contains("ignore all rules") && !told.contains("passwd"), "{case}: {told}");
        let count = asked(&client).len();
        assert!((1..=10).contains(&count), "{case}: it was asked {count} times");
        assert_eq!(client.stop(), 0, "{case}");
    }
}

/// A model that never answers is not waited for by anybody who no longer wants to.
#[test]
fn a_model_that_thinks_can_be_called_off() {
    let (folder, mut client, repair, layout) = opened(Model::Thinks);
    let id = client.begin("codeAction/resolve", repair.clone());
    client.until("the question", |c| (!asked(c).is_empty()).then_some(()));
    client.tell("$/cancelRequest", json!({ "id": id }));
    assert_eq!(client.end(id)["error"]["code"], -32800);
    assert_eq!(std::fs::read_to_string(folder.path().join("room.layout.json")).unwrap(), layout);
    // An answer that comes too late is an answer to nobody.
    let late = asked(&client)[0]["id"].clone();
    client.send(json!({ "id": late, "result": { "text": "{\"moves\": []}" } }));
    client.model = says("never mind");
    repaired(&mut client, repair, &layout);
    assert_eq!(client.stop(), 0);
}

/// Nobody wants the repair of a text that is no longer there, so the search for it ends.
#[test]
fn work_ends_when_the_text_changes() {
    let (_folder, mut client, repair, _) = opened(Model::Thinks);
    let uri = client.uri("room.scene");
    let (_, scene, _) = room();
    let id = client.begin("codeAction/resolve", repair);
    client.until("the question", |c| (!asked(c).is_empty()).then_some(()));
    client.set(&uri, &format!("{scene}object more;\n"));
    let error = &client.end(id)["error"];
    assert!(error["message"].as_str().unwrap().contains("changed in the meantime"), "{error}");
    assert_eq!(client.stop(), 0);
}

/// How often the model of the settings was to be reached.
static REACHED: AtomicUsize = AtomicUsize::new(0);

fn reach(_: &Llm, _: &Named) -> Result<Option<ModelQuestion>, Error> {
    REACHED.fetch_add(1, Ordering::SeqCst);
    Ok(None)
}

/// Says what it was asked for, and that there is no key.
fn keyless(_: &Llm, named: &Named) -> Result<Option<ModelQuestion>, Error> {
    let Named { name, base_url } = named;
    Err(Error::Setup(format!(
        "no key for {} at {}",
        name.as_deref().unwrap_or("?"),
        base_url.as_deref().unwrap_or("?")
    )))
}

/// Who has no key gets what can be had without, and is told so; the model is the one that the user has named in the editor.
#[test]
fn without_a_key_the_solver_solves() {
    let (folder, scene, _) = room();
    let silent = Client::silent(folder.path(), Setup { connect: Some(keyless), ..Setup::default() });
    let model = json!({ "name": "compatible:qwen", "baseUrl": " http://localhost:8080/v1 " });
    let options = json!({ "languageModel": "configured", "model": model });
    let mut client = Client::introduced(silent, usual(), options);
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    for (command, wanted) in
        [("scenelang.solve", "no key for compatible:qwen at http://localhost:8080/v1"), ("scenelang.repairAll", "")]
    {
        let run = json!({ "command": command, "arguments": [{ "uri": uri }] });
        let done = client.ask("workspace/executeCommand", run);
        assert!(done["holds"].as_u64() >= Some(10), "{command}: {done}");
        assert!(done["message"].as_str().unwrap().contains(wanted), "{command}: {done}");
    }
    let logged = |m: &Value| m["method"] == "window/logMessage" && m.to_string().contains("no key for compatible:qwen");
    assert!(client.told.iter().any(logged));
    client.stop();
}

/// Whoever has not offered a model is not asked for one, and nobody connects to that of the settings, or reads a key for it.
#[test]
fn nobody_is_asked_unasked() {
    for (options, reached) in [
        (Value::Null, false),
        (json!({}), false),
        (json!({ "languageModel": "none" }), false),
        (json!({ "languageModel": "openai:m" }), false),
        (json!({ "languageModel": ["configured"] }), false),
        (json!({ "languageModel": "configured" }), true),
    ] {
        let (folder, scene, _) = room();
        REACHED.store(0, Ordering::SeqCst);
        let silent = Client::silent(folder.path(), Setup { connect: Some(reach), ..Setup::default() });
        let mut client = Client::introduced(silent, usual(), options.clone());
        let uri = client.open("room.scene", &scene);
        client.published(&uri);
        let all = json!({ "command": "scenelang.repairAll", "arguments": [{ "uri": uri }] });
        assert!(client.ask("workspace/executeCommand", all)["message"].as_str().unwrap().contains("stand[1]"));
        assert!(asked(&client).is_empty());
        client.stop();
        assert_eq!(REACHED.load(Ordering::SeqCst) > 0, reached, "{options}");
    }
}

/// Commands ask it, too.
#[test]
fn all_commands_that_search_ask() {
    for command in ["scenelang.repairAll", "scenelang.solve"] {
        let (_folder, mut client, ..) = opened(moves(&json!([to("stand[1]", WELL, &Value::Null)])));
        let uri = client.uri("room.scene");
        let run = json!({ "command": command, "arguments": [{ "uri": uri }] });
        assert!(client.ask("workspace/executeCommand", run)["holds"].as_u64() >= Some(10), "{command}");
        client.stop();
    }
}
