//! Code actions: each is made, and the program read again.

use crate::client::{Client, at, edited, edits_of, room};
use serde_json::{Value, json};

impl Client {
    /// What is offered where some text stands.
    fn offered(&mut self, uri: &str, text: &str, marked: &str, only: Option<&str>) -> Vec<Value> {
        self.offered_beside(uri, text, marked, only, &[])
    }

    /// The same where the client shows these diagnostics.
    fn offered_beside(
        &mut self,
        uri: &str,
        text: &str,
        marked: &str,
        only: Option<&str>,
        marks: &[Value],
    ) -> Vec<Value> {
        let (from, to) = match marked.split_once('‹') {
            None => (at(text, marked), at(text, marked)),
            Some((before, rest)) => {
                let (inner, after) = rest.split_once('›').expect("a selection has two ends");
                (at(text, &format!("{before}|{inner}{after}")), at(text, &format!("{before}{inner}|{after}")))
            }
        };
        let context = json!({ "diagnostics": marks, "only": only.map(|kind| vec![kind]) });
        let ask = json!({ "textDocument": { "uri": uri }, "range": { "start": from, "end": to }, "context": context });
        self.ask("textDocument/codeAction", ask).as_array().unwrap().clone()
    }

    /// The text after an action of this title.
    fn made(&mut self, uri: &str, text: &str, marked: &str, title: &str) -> String {
        let all = self.offered(uri, text, marked, None);
        let titles: Vec<&str> = all.iter().map(|a| a["title"].as_str().unwrap()).collect();
        let action = all.iter().find(|a| a["title"] == title).unwrap_or_else(|| panic!("{marked}: {titles:?}"));
        let whole =
            if action["edit"].is_null() { self.ask("codeAction/resolve", action.clone()) } else { action.clone() };
        edited(text, edits_of(&whole["edit"], uri))
    }
}

#[test]
fn fixes_and_changes_of_form() {
    let (folder, scene, _) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    for (added, place, title, wanted) in [
        ("assert bed.tpo > 0;", "bed.t|po", "Write `top`", "assert bed.top > 0;"),
        ("object a1", "object a1|", "Insert `;`", "object a1;"),
        ("assert vase.top > 0;", "va|se.top", "Declare `vase` as an object", "object vase;\nassert vase.top > 0;"),
        (
            "assert gap(bed, hall) > 0;",
            "ha|ll",
            "Declare `hall` as a region",
            "region hall;\nassert gap(bed, hall) > 0;",
        ),
        ("assert bed.top <-1;", "<|-1", "Write a space between them", "assert bed.top < -1;"),
        ("object idle;", "object id|le", "Allow W0201 here", "object idle; // allow(W0201)"),
        (
            "assert bed.top > 0 and lamp.top > 0;",
            "bed.t|op > 0 and",
            "Split into 2 assertions",
            "assert bed.top > 0;\nassert lamp.top > 0;",
        ),
        (
            "@req(\"low\")\nassert (bed.top < 1 or bed.top > 9) and lamp.top < 2;",
            "bed.t|op < 1",
            "Split into 2 assertions",
            "@req(\"low\")\nassert (bed.top < 1 or bed.top > 9);\n@req(\"low\")\nassert lamp.top < 2;",
        ),
        (
            "assert ‹gap(lamp, bed) > 0.1› and lamp.top > 0;",
            "assert ‹gap(lamp, bed) > 0.1› and lamp",
            "Extract predicate `holds`",
            "predicate holds(Object a, Object b) := gap(a, b) > 0.1;\nassert holds(lamp, bed) and lamp.top > 0;",
        ),
        (
            "assert forall s in stand: near(s, stand[0], 9);",
            "forall s in stand: ‹near(s, stand[0], 9)›;",
            "Extract predicate `holds`",
            "predicate holds(Object a, Object b) := near(a, b, 9);\nassert forall s in stand: holds(s, stand[0]);",
        ),
        ("assert low(lamp, 1 + 1);", "assert l|ow(lamp", "Inline predicate `low`", "assert (lamp.top < (1 + 1));"),
        (
            "object cup1;\nobject cup2;\nassert cup1.top > cup2.top;",
            "object c|up1",
            "Combine these objects into the array `cup[2]`",
            "object cup[2];\nassert cup[0].top > cup[1].top;",
        ),
    ] {
        let text = format!("{scene}{}\n", added.replace(['‹', '›'], ""));
        client.set(&uri, &text);
        let found = client.made(&uri, &text, place, title);
        assert_eq!(found, format!("{scene}{wanted}\n"), "{title}");
    }
    // The place in the layout as assignments.
    client.set(&uri, &scene);
    let pinned = client.made(&uri, &scene, "object |bed", "Pin `bed` at its current position");
    assert!(pinned.contains("object bed;\nbed.pos <- vec3(0, 0, -0.9);\nbed.rot <- rot(0, 0, 0);\n"), "{pinned}");
    client.set(&uri, &pinned);
    let again = client.offered(&uri, &pinned, "object |bed", None);
    assert!(again.iter().all(|a| !a["title"].as_str().unwrap().starts_with("Pin")), "{again:?}");
    // All safe fixes at once, where somebody asks for that.
    let text = format!("{scene};;\nobject a\n");
    client.set(&uri, &text);
    let all = client.offered(&uri, &text, "|// A bed", Some("source.fixAll"));
    assert_eq!(all.len(), 1);
    assert_eq!(edited(&text, edits_of(&all[0]["edit"], &uri)), format!("{scene}\nobject a;\n"));
    assert!(client.offered(&uri, &text, "object |bed", Some("refactor.inline")).is_empty());
    client.stop();
}

#[test]
fn the_smallest_move_is_offered_at_once() {
    let (folder, scene, layout) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let all = client.offered(&uri, &scene, "assert g|ap(stand", Some("quickfix"));
    let step = all.iter().find(|a| a["title"].as_str().unwrap().starts_with("Move `stand[1]`")).expect("a move");
    assert_eq!((&step["isPreferred"], &step["diagnostics"][0]["code"]), (&json!(true), &json!("V0101")));
    let data = client.uri("room.layout.json");
    let after = edited(&layout, edits_of(&step["edit"], &data));
    let data = client.open("room.layout.json", &after);
    client.published(&data);
    client.until("it to hold", |c| {
        let marks = c.published(&uri);
        marks.iter().all(|m| m["code"] != "V0101").then_some(())
    });
    client.stop();
}

/// What the user has locked is moved by none of the offers; where nothing else helps, the refusal names it.
#[test]
fn no_offer_moves_what_is_locked() {
    let (folder, scene, _) = room();
    let scene = format!("{scene}assert gap(bed, stand[1]) >= 0.03;\n");
    let mut client = Client::start(folder.path());
    let uri = client.uri("room.scene");
    // Before the program is opened, too.
    client.tell("scenelang/lock", json!({ "uri": uri, "objects": ["stand"] }));
    client.open("room.scene", &scene);
    client.published(&uri);
    let offered = |client: &mut Client| client.offered(&uri, &scene, "assert g|ap(bed", Some("quickfix"));
    let moved = |actions: &[Value]| -> Vec<String> {
        let moves = actions.iter().filter_map(|a| a["data"]["moves"].as_array()).flatten();
        moves.map(|m| m["object"].as_str().unwrap().to_owned()).collect()
    };
    let all = offered(&mut client);
    assert!(moved(&all).iter().all(|object| !object.starts_with("stand")), "{:?}", moved(&all));
    let repair = all.iter().find(|a| a["title"] == "Repair this constraint").expect("repair").clone();
    let whole = client.ask("codeAction/resolve", repair.clone());
    assert_eq!(moved(&[whole]), ["bed"], "the search goes another way");
    client.tell("scenelang/lock", json!({ "uri": uri, "objects": ["stand", "bed"] }));
    let (_, why) = client.refused("codeAction/resolve", repair);
    assert!(why.ends_with("leaves what is locked in place: `bed`, `stand[0]`, `stand[1]`"), "{why}");
    client.tell("scenelang/lock", json!({ "uri": uri, "objects": [] }));
    assert!(moved(&offered(&mut client)).contains(&"stand[1]".to_owned()));
    client.stop();
}

#[test]
fn repair_is_listed_at_once_and_worked_out_on_demand() {
    let (folder, scene, layout) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let all = client.offered(&uri, &scene, "assert g|ap(stand", None);
    let repair = all.iter().find(|a| a["title"] == "Repair this constraint").expect("repair").clone();
    assert!(repair.get("edit").is_none() && repair.get("command").is_none());
    let whole = client.ask("codeAction/resolve", repair);
    let data = client.uri("room.layout.json");
    let after = edited(&layout, edits_of(&whole["edit"], &data));
    assert!(after.contains("\"note\": \"mine\""));
    // The preview says what moves, and which margins change.
    let note = &whole["edit"]["changeAnnotations"]["change"];
    assert!(note["label"].as_str().unwrap().contains("move `stand[1]`"), "{note}");
    assert_eq!(whole["data"]["moves"][0]["object"], "stand[1]", "an editor can show it before");
    assert!(whole["title"].as_str().unwrap().starts_with("Move `stand[1]`"), "{whole}");
    assert!(note["description"].as_str().unwrap().contains("−0.12 m → +"), "{note}");
    assert_eq!(note["needsConfirmation"], true);
    for kind in ["begin", "end"] {
        client.until(kind, |c| {
            let of = |m: &&Value| m["method"] == "$/progress" && m["params"]["value"]["kind"] == kind;
            c.told.iter().find(of).map(|_| ())
        });
    }
    // No number of the program is to blame, and an assertion is weakened by nothing that does not say so.
    let other = all.iter().find(|a| a["title"] == "Change the program so that this holds").expect("the other").clone();
    let (_, why) = client.refused("codeAction/resolve", other);
    assert!(why.contains("no number was found"), "{why}");
    let title = "Make the assertion a preference: `prefer` instead of `assert`";
    let weaker = all.iter().find(|a| a["title"] == title).expect("a weaker program");
    let changed = edited(&scene, edits_of(&weaker["edit"], &uri));
    assert!(changed.contains("prefer gap(stand[1], bed) >= space"), "{changed}");
    assert_ne!(changed, scene);
    client.set(&uri, &changed);
    assert!(client.published(&uri).iter().all(|m| m["code"] != "V0101"), "{changed}");
    // It holds now: there is nothing to be repaired.
    let all = client.offered(&uri, &changed, "room.scale", None);
    assert!(all.iter().all(|a| a["title"] != "Repair this constraint"));
    client.stop();
}

/// Whoever can show a change before it is made is asked to; where objects would be is said, too.
#[test]
fn choices_are_shown_before_they_are_made() {
    let (folder, scene, _) = room();
    let text = format!("{scene}assert distance(lamp, bed) <= 0.4;\n");
    let mut plain = crate::client::usual();
    plain["workspace"]["workspaceEdit"] = json!({ "documentChanges": true });
    for (can, asks) in [(crate::client::usual(), true), (plain, false)] {
        let mut client = Client::start_with(folder.path(), can, Value::Null);
        let uri = client.open("room.scene", &text);
        client.published(&uri);
        let all = client.offered(&uri, &text, "assert g|ap(stand", Some("quickfix"));
        let first = &all[0];
        assert_eq!(first["title"], "Move `stand[1]` 0.12 m east");
        let moves = &first["data"]["moves"];
        assert_eq!((&first["data"]["uri"], &moves[0]["object"]), (&json!(uri), &json!("stand[1]")));
        assert_eq!(moves[0]["pos"].as_array().map(Vec::len), Some(3));
        assert_eq!(&client.ask("codeAction/resolve", first.clone()), first, "it is complete");
        let number = client.offered(&uri, &text, "assert dist|ance(lamp", Some("quickfix"));
        let number = number.iter().find(|a| a["title"].as_str().unwrap().starts_with("Require ")).expect("a number");
        assert!(number["title"].as_str().unwrap().ends_with(" m instead of 0.4 m"), "{number}");
        assert!(edited(&text, edits_of(&number["edit"], &uri)).contains("assert distance(lamp, bed) <= "));
        for action in [first, number] {
            let note = &action["edit"]["changeAnnotations"]["change"];
            assert_eq!(note["needsConfirmation"] == true, asks, "{action}");
            assert_eq!(note["label"] == action["title"], asks, "{action}");
        }
        client.stop();
    }
}

#[test]
fn contradictions_are_refused_with_their_smallest_set() {
    let (folder, scene, _) = room();
    let text = format!("{scene}assert bed.pos.x > 0.3;\nassert bed.pos.x < 0.2;\n");
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &text);
    client.published(&uri);
    let all = client.offered(&uri, &text, "assert b|ed.pos.x > 0.3", None);
    let repair = all.iter().find(|a| a["title"] == "Repair this constraint").expect("repair").clone();
    let (_, why) = client.refused("codeAction/resolve", repair);
    assert!(why.contains("`bed.pos.x > 0.3` (line ") && why.contains("`bed.pos.x < 0.2` (line "), "{why}");
    assert!(!why.contains("gap("), "nothing else is in it: {why}");
    // Once it is proved, no repair is offered for what no layout repairs; a change of the program still is.
    let marks = client.until("a contradiction", |c| {
        let marks: Vec<Value> =
            c.published(&uri).iter().filter(|m| m["code"] == "E0401" || m["code"] == "E0402").cloned().collect();
        (!marks.is_empty()).then_some(marks)
    });
    for statement in ["assert b|ed.pos.x > 0.3", "assert b|ed.pos.x < 0.2"] {
        let all = client.offered_beside(&uri, &text, statement, None, &marks);
        assert!(all.iter().all(|a| a["title"] != "Repair this constraint"), "{statement}: {all:?}");
    }
    client.stop();
}

#[test]
fn clients_that_cannot_complete_an_action_get_a_command() {
    let (folder, scene, _) = room();
    let mut can = crate::client::usual();
    can["textDocument"]["codeAction"] = json!({});
    let mut client = Client::start_with(folder.path(), can, Value::Null);
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let all = client.offered(&uri, &scene, "assert g|ap(stand", None);
    let repair = all.iter().find(|a| a["title"] == "Repair this constraint").expect("repair");
    let command = &repair["command"];
    let run = json!({ "command": command["command"], "arguments": command["arguments"] });
    assert!(client.ask("workspace/executeCommand", run)["message"].as_str().unwrap().contains("stand[1]"));
    assert!(client.asked.iter().any(|m| m["method"] == "workspace/applyEdit"));
    client.stop();
}

#[test]
fn long_edits_are_worked_out_when_they_are_chosen() {
    let (folder, scene, _) = room();
    let text = format!("{scene}object cup1;\nobject cup2;\nassert cup1.top > cup2.top;\n");
    let wanted = format!("{scene}object cup[2];\nassert cup[0].top > cup[1].top;\n");
    let title = "Combine these objects into the array `cup[2]`";
    let mut cannot = crate::client::usual();
    cannot["textDocument"]["codeAction"] = json!({});
    for (can, at_once) in [(crate::client::usual(), false), (cannot, true)] {
        let mut client = Client::start_with(folder.path(), can, Value::Null);
        let uri = client.open("room.scene", &scene);
        client.set(&uri, &text);
        let all = client.offered(&uri, &text, "object c|up1", None);
        let mut action = all.into_iter().find(|a| a["title"] == title).expect("an array");
        assert_eq!(action["edit"].is_object(), at_once, "{action}");
        if !at_once {
            let whole = client.ask("codeAction/resolve", action.clone());
            assert_eq!((&whole["title"], &whole["kind"]), (&action["title"], &action["kind"]));
            // Of another text it is the edit for that, or none.
            client.set(&uri, &format!("// cups\n{scene}"));
            let (_, late) = client.refused("codeAction/resolve", action);
            assert!(late.contains("is no longer possible"), "{late}");
            client.set(&uri, &text);
            action = whole;
        }
        assert_eq!(edited(&text, edits_of(&action["edit"], &uri)), wanted);
        client.stop();
    }
}

/// What leaves the program as it is comes first; what no number can change is not offered as if one could.
#[test]
fn the_program_is_changed_last() {
    let (folder, scene, layout) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let titles = |actions: &[Value]| -> Vec<String> {
        actions.iter().map(|a| a["title"].as_str().unwrap().to_owned()).collect()
    };
    let found = titles(&client.offered(&uri, &scene, "assert g|ap(stand", Some("quickfix")));
    let at = |start: &str| found.iter().position(|title| title.starts_with(start));
    let repair = at("Repair this constraint").unwrap_or_else(|| panic!("{found:?}"));
    assert!(at("Move ").is_some_and(|i| i < repair), "{found:?}");
    for weaker in ["Make the assertion a preference", "Change the program"] {
        assert!(at(weaker).is_some_and(|i| i > repair), "{found:?}");
    }
    // A physical rule has no numbers in the program.
    let data = client.open(
        "room.layout.json",
        &layout.replace("\"lamp\": { \"pos\": [", "\"lamp\": { \"pos\": [0.4, 2, 0], \"was\": ["),
    );
    client.published(&data);
    client.until("the lamp to float", |c| c.published(&uri).iter().any(|m| m["code"] == "V0104").then_some(()));
    let found = titles(&client.offered(&uri, &scene, "object |lamp", Some("quickfix")));
    assert!(found.iter().any(|t| t == "Repair this constraint"), "{found:?}");
    assert!(found.iter().all(|t| !t.starts_with("Change the program")), "{found:?}");
    client.stop();
}

/// An editor that shows a quick fix before it is made asks which margins it changes.
#[test]
fn the_effect_of_a_fix_can_be_asked_for() {
    let (folder, scene, _) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let all = client.offered(&uri, &scene, "assert g|ap(stand", Some("quickfix"));
    let moves = all.iter().find(|a| a["data"]["moves"].as_array().is_some_and(|m| !m.is_empty())).expect("a move");
    let mut held = moves.clone();
    held.as_object_mut().unwrap().remove("edit");
    let judged = client.ask("codeAction/resolve", held);
    let margins: Vec<&str> = judged["data"]["margins"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    assert!(margins.iter().any(|m| m.contains("gap(stand[1], bed)") && m.contains(" → ")), "{judged}");
    assert_eq!(judged["data"]["moves"], moves["data"]["moves"]);
    assert!(judged["edit"].is_null(), "the editor has it");
    // So it is where a number of the program changes.
    let scene = scene.replace("gap(stand[1], bed) >= space", "gap(stand[1], bed) >= 0.02");
    client.set(&uri, &scene);
    let all = client.offered(&uri, &scene, "assert g|ap(stand", Some("quickfix"));
    let number = all.iter().find(|a| a["title"].as_str().unwrap().starts_with("Require ")).expect("a number");
    let mut held = number.clone();
    held.as_object_mut().unwrap().remove("edit");
    let judged = client.ask("codeAction/resolve", held);
    let margins = judged["data"]["margins"].as_array().unwrap();
    assert!(
        margins.iter().any(|m| m.as_str().unwrap().contains("fails") || m.as_str().unwrap().contains(" → +")),
        "{judged}"
    );
    client.stop();
}
