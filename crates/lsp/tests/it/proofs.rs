//! What is proved stays marked as long as it is true: blanks, comments and moved objects change no proof.

use crate::client::{Client, room, slice};
use serde_json::{Value, json};

/// Two demands that contradict each other, and a room.
fn opened() -> (tempfile::TempDir, Client, String, String) {
    let (folder, scene, _) = room();
    let text = format!("{scene}assert bed.pos.x > 0.3;\nassert bed.pos.x < 0.2;\n");
    std::fs::write(folder.path().join("room.scene"), &text).unwrap();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &text);
    (folder, client, uri, text)
}

/// The contradictions that are marked, as text, once those of the newest version are there.
fn marked(client: &mut Client, uri: &str, text: &str) -> Vec<String> {
    let proved = |m: &&Value| m["code"].as_str().is_some_and(|code| code.starts_with("E04"));
    let found = client.until("a contradiction", |c| {
        let marks: Vec<Value> = c.published(uri).iter().filter(proved).cloned().collect();
        (!marks.is_empty()).then_some(marks)
    });
    let mut out: Vec<String> = found.iter().map(|m| slice(text, &m["range"])).collect();
    for place in found.iter().filter_map(|m| m["relatedInformation"].as_array()).flatten() {
        out.push(slice(text, &place["location"]["range"]));
    }
    out
}

#[test]
fn a_contradiction_outlives_what_means_nothing() {
    let (_folder, mut client, uri, text) = opened();
    let first = marked(&mut client, &uri, &text);
    assert!(first.iter().any(|t| t.contains("bed.pos.x")), "{first:?}");
    // One empty line above, and a comment between.
    for typed in [format!("\n{text}"), text.replace("assert bed.pos.x < 0.2", "// so near?\nassert  bed.pos.x  <  0.2")]
    {
        client.set(&uri, &typed);
        client.next_verdict(&uri);
        let now: Vec<String> = marked(&mut client, &uri, &typed);
        let folded = |list: &[String]| {
            list.iter().map(|t| t.split_whitespace().collect::<Vec<_>>().join(" ")).collect::<Vec<_>>()
        };
        assert_eq!(folded(&now), folded(&first), "{typed}");
        client.told.clear();
    }
    // What takes it away takes the mark away.
    let sound = text.replace("assert bed.pos.x < 0.2;", "assert bed.pos.x < 0.9;");
    client.set(&uri, &sound);
    client.until("no contradiction", |c| {
        c.published(&uri).iter().all(|m| m["code"] != "E0401" && m["code"] != "E0402").then_some(())
    });
    client.stop();
}

/// Program and layout are saved together, and the layout is changed while the proof goes on.
#[test]
fn a_contradiction_is_about_the_program_whatever_the_layout_is() {
    let (folder, mut client, uri, text) = opened();
    let layout = std::fs::read_to_string(folder.path().join("room.layout.json")).unwrap();
    let data = client.open("room.layout.json", &layout);
    let first = marked(&mut client, &uri, &text);
    for x in [0.1, 0.2, 0.3] {
        client.told.clear();
        client.set(&data, &layout.replace("\"bed\": { \"pos\": [0, ", &format!("\"bed\": {{ \"pos\": [{x}, ")));
        for saved in [&uri, &data] {
            client.tell("textDocument/didSave", json!({ "textDocument": { "uri": saved } }));
        }
        client.next_verdict(&uri);
        assert_eq!(marked(&mut client, &uri, &text), first, "{x}");
    }
    client.stop();
}
