//! Files that get other names: what imports them is edited, and layouts go with their programs.

use crate::client::{Client, edited, edits_of, room, usual};
use serde_json::{Value, json};

/// A client that asks before it renames.
fn asking(folder: &std::path::Path) -> Client {
    let mut can = usual();
    can["workspace"]["fileOperations"] = json!({ "willRename": true });
    can["workspace"]["workspaceEdit"]["resourceOperations"] = json!(["create", "rename"]);
    Client::start_with(folder, can, Value::Null)
}

fn renamed(client: &mut Client, pairs: &[(&str, &str)]) -> Value {
    let files: Vec<Value> =
        pairs.iter().map(|(old, new)| json!({ "oldUri": client.uri(old), "newUri": client.uri(new) })).collect();
    client.ask("workspace/willRenameFiles", json!({ "files": files }))
}

#[test]
fn imports_and_layouts_keep_up() {
    let (folder, scene, layout) = room();
    let below = folder.path().join("below");
    std::fs::create_dir(&below).unwrap();
    let other = "import \"../parts.scene\";\nobject cup;\n";
    std::fs::write(below.join("other.scene"), other).unwrap();
    let mut client = asking(folder.path());
    let filters = &client.capabilities["workspace"]["fileOperations"]["willRename"]["filters"];
    assert!(filters.to_string().contains("**/*.scene"), "{filters}");
    let [room_uri, layout_uri, other_uri] =
        ["room.scene", "room.layout.json", "below/other.scene"].map(|f| client.uri(f));
    // One program is open, the other is not.
    client.open("room.scene", &scene);
    client.published(&room_uri);

    let change = renamed(&mut client, &[("parts.scene", "below/pieces.scene")]);
    assert!(
        edited(&scene, edits_of(&change, &room_uri))
            .starts_with(&scene.replace("\"parts.scene\"", "\"below/pieces.scene\"")[..120])
    );
    assert_eq!(edited(other, edits_of(&change, &other_uri)), other.replace("../parts.scene", "pieces.scene"));

    // The layout goes with its program, and says where that is.
    let change = renamed(&mut client, &[("room.scene", "below/hall.scene")]);
    let moved = edited(&scene, edits_of(&change, &room_uri));
    assert!(moved.contains("import \"../parts.scene\";"), "{moved}");
    assert_eq!(edited(&layout, edits_of(&change, &layout_uri)), layout.replace("\"room.scene\"", "\"hall.scene\""));
    let last = change["documentChanges"].as_array().unwrap().last().unwrap().clone();
    assert_eq!(
        (&last["kind"], &last["oldUri"], &last["newUri"]),
        (&json!("rename"), &json!(layout_uri), &json!(client.uri("below/hall.layout.json")))
    );

    // A folder that is moved takes along what is in it; what leads into it and out of it is written anew.
    let change = renamed(&mut client, &[("below", "deep/er")]);
    assert_eq!(edited(other, edits_of(&change, &other_uri)), other.replace("../parts.scene", "../../parts.scene"));
    assert!(!change.to_string().contains("room.scene"), "{change}");

    // Whoever moves the layout, too, is not helped with that; and what changes nothing is no change.
    let change = renamed(&mut client, &[("room.scene", "hall.scene"), ("room.layout.json", "hall.layout.json")]);
    assert_eq!(edited(&layout, edits_of(&change, &layout_uri)), layout.replace("\"room.scene\"", "\"hall.scene\""));
    assert!(!change.to_string().contains("\"rename\""), "{change}");
    assert_eq!(renamed(&mut client, &[("nothing.scene", "else.scene")]), Value::Null);
    let layout_alone = renamed(&mut client, &[("room.layout.json", "below/room.layout.json")]);
    assert_eq!(
        edited(&layout, edits_of(&layout_alone, &layout_uri)),
        layout.replace("\"room.scene\"", "\"../room.scene\"")
    );
    assert_eq!(client.refused("workspace/willRenameFiles", json!({ "files": [{ "oldUri": 5 }] })).0, -32602);
    client.stop();
}

/// A client that cannot rename files is only told what to write.
#[test]
fn a_layout_stays_where_it_cannot_be_moved() {
    let (folder, ..) = room();
    let mut can = usual();
    can["workspace"]["fileOperations"] = json!({ "willRename": true });
    let mut client = Client::start_with(folder.path(), can, Value::Null);
    let change = renamed(&mut client, &[("room.scene", "hall.scene")]);
    let layout = std::fs::read_to_string(folder.path().join("room.layout.json")).unwrap();
    let uri = client.uri("room.layout.json");
    assert_eq!(edited(&layout, edits_of(&change, &uri)), layout.replace("\"room.scene\"", "\"hall.scene\""));
    assert_eq!(change["documentChanges"].as_array().unwrap().len(), 1);
    client.stop();
}

/// A client without versions gets edits by address, and no member that it does not know.
#[test]
fn edits_for_a_client_without_versions() {
    let (folder, ..) = room();
    let mut can = usual();
    can["workspace"]["fileOperations"] = json!({ "willRename": true });
    can["workspace"]["workspaceEdit"] = json!({});
    let mut client = Client::start_with(folder.path(), can, Value::Null);
    let change = renamed(&mut client, &[("room.scene", "hall.scene")]);
    let members: Vec<&String> = change.as_object().unwrap().keys().collect();
    assert_eq!(members, ["changes"], "{change}");
    client.stop();
}
