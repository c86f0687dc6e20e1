//! Every feature, on one room: asked over the protocol, and the answer read.

use crate::client::{Client, at, edited, edits_of, offset, room, slice, usual};
use serde_json::{Value, json};
use std::fmt::Write;

/// An open room.
fn opened() -> (tempfile::TempDir, Client, String, String) {
    let (folder, scene, _) = room();
    let mut client = Client::start(folder.path());
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    (folder, client, uri, scene)
}

impl Client {
    fn ask_at(&mut self, method: &str, uri: &str, text: &str, marked: &str) -> Value {
        let place = json!({ "textDocument": { "uri": uri }, "position": at(text, marked) });
        self.ask(&format!("textDocument/{method}"), place)
    }

    fn ask_of(&mut self, method: &str, uri: &str) -> Value {
        self.ask(&format!("textDocument/{method}"), json!({ "textDocument": { "uri": uri } }))
    }
}

fn slices(text: &str, ranges: &Value) -> Vec<String> {
    ranges.as_array().unwrap().iter().map(|r| slice(text, r.get("range").unwrap_or(r))).collect()
}

/// Only an editor that says so draws a picture; others would show its data.
#[test]
fn a_category_has_a_picture_where_the_editor_draws_it() {
    let (folder, scene, _) = room();
    for (options, drawn) in [(json!({ "pictures": true }), true), (Value::Null, false)] {
        let mut client = Client::start_with(folder.path(), usual(), options);
        let uri = client.open("room.scene", &scene);
        let text = format!("{scene}bed.category <- \"bed\";\n");
        client.set(&uri, &text);
        let said = client.ask_at("hover", &uri, &text, "category <- \"b|ed\"");
        let said = said["contents"]["value"].as_str().unwrap();
        assert!(said.contains("usual size"), "{said}");
        assert_eq!(said.contains("![bed](data:image/png;base64,iVBOR"), drawn, "{}", said.len());
        assert!(said.len() < 90_000, "an editor cuts what is longer");
        client.stop();
    }
}

#[test]
fn diagnostics_have_places_links_and_what_belongs_to_them() {
    let (_folder, mut client, uri, scene) = opened();
    let marks = client.published(&uri);
    let of = |code: &str| marks.iter().filter(|m| m["code"] == code).cloned().collect::<Vec<_>>();
    let [fails] = &of("V0101")[..] else { panic!("{marks:?}") };
    assert_eq!(slice(&scene, &fails["range"]), "assert gap(stand[1], bed) >= space and space > 0.01");
    assert_eq!(
        fails["message"],
        "`gap(stand[1], bed)` is -0.1, but must be at least `space`, which is 0.02 (margin −0.12 m)"
    );
    // The page comes with the server.
    let page = fails["codeDescription"]["href"].as_str().unwrap();
    let text = std::fs::read_to_string(page.strip_prefix("file://").unwrap()).unwrap();
    assert!(page.ends_with("/codes/V0101.md") && text.contains("V0101"), "{page}");
    assert_eq!(fails["relatedInformation"].as_array().unwrap().len(), 2);
    // A rule has no text: it is shown at the declarations of both.
    let places: Vec<String> = of("V0102").iter().map(|m| slice(&scene, &m["range"])).collect();
    assert_eq!(places, ["bed", "stand"]);
    assert_eq!(of("V0106")[0]["severity"], 2);
    client.stop();
}

#[test]
fn hovering() {
    let (_folder, mut client, uri, scene) = opened();
    for (place, wanted) in [
        (
            "object |bed",
            "object bed|Where one sleeps|`bed` is at (0, 0, -0.9), 1.60 × 0.55 × 2.00 m|fails: `bed` overlaps",
        ),
        ("|assert gap(stand[1]", "**fails**, margin **−0.12 m**|to repair it: move `stand[1]` 0.12 m east"),
        ("@r|eq(\"a lamp", "“a lamp stands on the left stand”|is met"),
    ] {
        let found = client.ask_at("hover", &uri, &scene, place);
        let text = found["contents"]["value"].as_str().unwrap_or_else(|| panic!("nothing at {place}"));
        for part in wanted.split('|') {
            assert!(text.contains(part), "{place}: no {part:?} in {text}");
        }
        let cursor = offset(&scene, &at(&scene, place));
        let (start, end) = (offset(&scene, &found["range"]["start"]), offset(&scene, &found["range"]["end"]));
        assert!(start <= cursor && cursor <= end, "{place}");
    }
    assert_eq!(client.ask_at("hover", &uri, &scene, "// A bed|room"), Value::Null);
    client.stop();
}

/// What is proposed at `|` in a line behind the room: in this order, among others. What else is, `ide` tests.
#[test]
fn completion() {
    let (_folder, mut client, uri, scene) = opened();
    let mut wrong = String::new();
    for (line, first, others, never) in [
        ("ass|", "", "assert object region prefer bed", "near true"),
        ("// as|", "", "", "assert bed"),
        ("assert bed.|", "", "pos top category color", "floor bed x"),
        ("assert near(|", "bed", "lamp stand room", "front true"),
        ("bed.color <- \"ste|\";", "", "steelblue red linen", "bed assert"),
        ("bed.material <- \"|\";", "", "oak", "assert"),
        ("import \"|\";", "parts.scene", "", "room.scene bed"),
        ("assert bed.top > 30c|", "30cm", "", "bed 30m"),
    ] {
        let text = format!("{scene}\n{}\nobject last;\n", line.replacen('|', "", 1));
        client.set(&uri, &text);
        let marked = format!("\n{line}\nobject last");
        let context = json!({ "triggerKind": 1 });
        let params = json!({ "textDocument": { "uri": uri }, "position": at(&text, &marked), "context": context });
        let answer = client.ask("textDocument/completion", params);
        let mut items: Vec<&Value> = answer["items"].as_array().unwrap().iter().collect();
        items.sort_by_key(|i| i["sortText"].as_str().unwrap().to_owned());
        let labels: Vec<&str> = items.iter().map(|i| i["label"].as_str().unwrap()).collect();
        // `linen` is a colour of walls that the library knows by its material's name.
        let missing = others.split_whitespace().filter(|w| *w != "linen").find(|w| !labels.contains(w));
        let there = never.split_whitespace().find(|w| labels.contains(w));
        let begins = first.is_empty() || labels.first() == Some(&first);
        if let Some(bad) = missing.or(there).or((!begins).then_some(first)) {
            let shown = &labels[..labels.len().min(40)];
            let _ = writeln!(wrong, "{line}: {bad}: {shown:?}");
        }
        for item in items {
            let range = &item["textEdit"]["range"];
            assert_eq!(range["start"]["line"], range["end"]["line"], "{line}: {item}");
            let cursor = offset(&text, &at(&text, &marked));
            assert!(
                offset(&text, &range["start"]) <= cursor && cursor <= offset(&text, &range["end"]),
                "{line}: {item}"
            );
            assert!(item.get("preselect").is_none() && item.get("commitCharacters").is_none());
        }
    }
    assert!(wrong.is_empty(), "{wrong}");

    // Numbers are proposed only where somebody asks, and snippets only where the rest is not there yet.
    let text = format!("{scene}assert bed.top > 3\n");
    client.set(&uri, &text);
    let typed = json!({ "triggerKind": 2 });
    let end = at(&text, "bed.top > 3|");
    let answer = client
        .ask("textDocument/completion", json!({ "textDocument": { "uri": uri }, "position": end, "context": typed }));
    assert_eq!(answer["items"], json!([]));
    for (line, label, inserted) in [
        ("assert nea|", "near", "near(${1:a}, ${2:b}, ${3:d})"),
        ("assert nea|(bed, lamp, 1);", "near", "near"),
        ("assert not lo|", "low", "low(${1:thing}, ${2:height})"),
        ("/* 1 */ obj|", "object", "object ${1:name};"),
        ("/* 2 */ obj| x;", "object", "object"),
    ] {
        let text = format!("{scene}{}\n", line.replacen('|', "", 1));
        client.set(&uri, &text);
        let place = json!({ "textDocument": { "uri": uri }, "position": at(&text, line) });
        let answer = client.ask("textDocument/completion", place);
        let item = answer["items"].as_array().unwrap().iter().find(|i| i["label"] == label).unwrap();
        assert_eq!(item["textEdit"]["newText"], inserted, "{line}");
        assert_eq!(item["insertTextFormat"], if inserted.contains('$') { 2 } else { 1 });
        if label == "near" {
            let whole = client.ask("completionItem/resolve", item.clone());
            assert!(whole["documentation"]["value"].as_str().unwrap().contains("predicate near("), "{whole}");
        }
    }
    client.stop();
}

#[test]
fn signatures() {
    let (_folder, mut client, uri, scene) = opened();
    for (line, label, active) in [
        ("assert near(bed, |", "near(Object a, Object b, Number d)", 1),
        ("assert atHand(bed, |);", "atHand(Object a, Object b)", 1),
        ("bed.pos <- vec3(1, 2, |", "vec3(Number x, Number y, Number z) -> Vector3", 2),
    ] {
        let text = format!("{scene}{}\n", line.replacen('|', "", 1));
        client.set(&uri, &text);
        let help = client.ask_at("signatureHelp", &uri, &text, line);
        let own = help["activeSignature"].as_u64().unwrap() as usize;
        assert_eq!(help["signatures"][own]["label"], label, "{line}");
        assert_eq!(help["activeParameter"], active, "{line}");
    }
    let text = format!("{scene}assert distance(bed, room) \n");
    client.set(&uri, &text);
    assert_eq!(client.ask_at("signatureHelp", &uri, &text, "distance(bed, room) |"), Value::Null);
    client.stop();
}

#[test]
fn going_places() {
    let (_folder, mut client, uri, scene) = opened();
    let mut text = scene;
    text.push_str("Number wide;\nwide <- 3;\nassert bed.top < wide;\n");
    client.set(&uri, &text);
    for (method, place, file, wanted) in [
        ("definition", "on(lamp, st|and[0])", "room.scene", "stand"),
        ("definition", "forall s in stand: near(|s", "room.scene", "s"),
        ("definition", "at|Hand(lamp", "parts.scene", "atHand"),
        ("definition", "assert o|n(lamp", "std/contact.scene", "on"),
        ("definition", "import \"par|ts", "parts.scene", ""),
        ("definition", "bed.top < wi|de", "room.scene", "wide"),
        ("declaration", "bed.top < wi|de", "room.scene", "wide"),
        ("declaration", "thing.t|op", "", ""),
        ("typeDefinition", "on(la|mp", "room.scene", "lamp.category"),
        ("typeDefinition", "near(|s, bed", "room.scene", "stand"),
    ] {
        let found = client.ask_at(method, &uri, &text, place);
        if file.is_empty() {
            assert_eq!(found, Value::Null, "{method} {place}");
            continue;
        }
        let target = found[0]["targetUri"].as_str().unwrap_or_else(|| panic!("{method} {place}: {found}"));
        assert!(target.ends_with(file), "{method} {place}: {target}");
        let other = std::fs::read_to_string(target.trim_start_matches("file://")).unwrap();
        let there = if target == uri { &text } else { &other };
        assert_eq!(slice(there, &found[0]["targetSelectionRange"]), wanted, "{method} {place}");
    }
    // A variable is declared in one place and defined in another.
    let lines: Vec<Value> = ["definition", "declaration"]
        .map(|m| client.ask_at(m, &uri, &text, "bed.top < wi|de")[0]["targetRange"]["start"]["line"].clone())
        .into();
    assert_ne!(lines[0], lines[1]);

    let count = |v: Value| v.as_array().unwrap().len();
    for (place, with, without) in [
        ("object |bed", 10, 9),
        ("for|all", 0, 0),
        ("forall |s in", 3, 2),
        ("atH|and(", 2, 1),
        ("predicate |low", 2, 1),
    ] {
        let mut params = json!({ "textDocument": { "uri": uri }, "position": at(&text, place), "context": {} });
        for (declaration, wanted) in [(true, with), (false, without)] {
            params["context"]["includeDeclaration"] = declaration.into();
            let found = client.ask("textDocument/references", params.clone());
            assert_eq!(if found.is_null() { 0 } else { count(found) }, wanted, "{place}");
        }
    }
    let marks = client.ask_at("documentHighlight", &uri, &text, "space >| 0.01");
    assert_eq!(marks, json!([]));
    let marks = client.ask_at("documentHighlight", &uri, &text, "Number wi|de");
    let kinds: Vec<u64> = marks.as_array().unwrap().iter().map(|m| m["kind"].as_u64().unwrap()).collect();
    assert_eq!((slices(&text, &marks), kinds), (vec!["wide".to_owned(); 3], vec![3, 3, 2]));
    client.stop();
}

#[test]
fn renaming_goes_into_the_layout() {
    let (folder, mut client, uri, scene) = opened();
    let layout = std::fs::read_to_string(folder.path().join("room.layout.json")).unwrap();
    let rename = |client: &mut Client, place: &str, new: &str| json!({ "textDocument": { "uri": uri }, "position": at(&scene, place), "newName": new, "context": client.capabilities["none"] });
    for (place, new, in_scene, in_layout) in [
        ("object |bed", "couch", "near(s, couch, 0.1)", "\"couch\": { \"pos\""),
        ("object st|and", "table", "object table[2];", "\"table[1]\": { \"pos\""),
        ("region |room", "hall", "hall.scale <-", "\"hall\": { \"pos\""),
        ("Number |space", "slack", "slack > 0.01", "{ \"slack\": 0.02 }"),
        ("forall |s in", "t", "forall t in stand: near(t, bed, 0.1) and t.pos.y", ""),
        ("low(Object |thing", "o", "(Object o, Number height) := o.top", ""),
        ("predicate |low", "flat", "assert flat(bed, 1)", ""),
    ] {
        let prepared = client.ask_at("prepareRename", &uri, &scene, place);
        assert_eq!(prepared["placeholder"], slice(&scene, &prepared["range"]), "{place}");
        let params = rename(&mut client, place, new);
        let change = client.ask("textDocument/rename", params);
        assert!(edited(&scene, edits_of(&change, &uri)).contains(in_scene), "{place}");
        let data = client.uri("room.layout.json");
        if in_layout.is_empty() {
            assert!(!change.to_string().contains(&data), "{place}");
        } else {
            let after = edited(&layout, edits_of(&change, &data));
            assert!(after.contains(in_layout) && after.contains("\"note\": \"mine\""), "{place}: {after}");
        }
    }
    // An imported predicate is renamed where it is defined, too.
    let params = rename(&mut client, "atH|and(", "close");
    let change = client.ask("textDocument/rename", params);
    let parts = client.uri("parts.scene");
    assert!(edits_of(&change, &parts).as_array().unwrap().len() == 1);
    for (place, new, why) in [
        ("object |bed", "lamp", "already"),
        ("object |bed", "9lives", "is not a name"),
        ("object |bed", "assert", "is not a name"),
        ("object |bed", "s", "already"),
        ("predicate |low", "inside", "is not a name"),
        ("predicate |low", "gap", "built-in"),
        ("assert o|n(lamp", "upon", "nothing here can be renamed"),
        ("lamp.t|op", "upper", "nothing here can be renamed"),
    ] {
        let params = rename(&mut client, place, new);
        let (code, message) = client.refused("textDocument/rename", params);
        assert_eq!(code, -32803);
        assert!(message.contains(why), "{place} {new}: {message}");
    }
    assert_eq!(client.ask_at("prepareRename", &uri, &scene, "assert o|n(lamp"), Value::Null);
    client.stop();
}

#[test]
fn outlines() {
    let (_folder, mut client, uri, scene) = opened();
    let symbols = client.ask_of("documentSymbol", &uri);
    let names: Vec<&str> = symbols.as_array().unwrap().iter().map(|s| s["name"].as_str().unwrap()).collect();
    assert_eq!(&names[..5], ["room", "bed", "stand", "lamp", "space"]);
    assert!(names.contains(&"low") && names.iter().any(|n| n.starts_with("assert on(lamp")));
    let stand = &symbols[2];
    assert_eq!((slice(&scene, &stand["selectionRange"]), &stand["detail"]), ("stand".to_owned(), &json!("[2]")));
    for (query, wanted) in [("stnd", vec!["stand"]), ("ATH", vec!["atHand"]), ("zzz", vec![])] {
        let found = client.ask("workspace/symbol", json!({ "query": query }));
        let names: Vec<&str> = found.as_array().unwrap().iter().map(|s| s["name"].as_str().unwrap()).collect();
        assert_eq!(names, wanted);
    }
    client.stop();
}

/// Tokens as `text type` with their modifiers.
fn decoded(client: &Client, text: &str, data: &Value) -> Vec<(String, String)> {
    let legend = &client.capabilities["semanticTokensProvider"]["legend"];
    let numbers: Vec<u64> = data.as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).collect();
    let (mut line, mut column) = (0, 0);
    let mut out = Vec::new();
    for token in numbers.chunks(5) {
        column = if token[0] == 0 { column + token[1] } else { token[1] };
        line += token[0];
        let range = json!({
            "start": { "line": line, "character": column }, "end": { "line": line, "character": column + token[2] },
        });
        let mut kind = legend["tokenTypes"][token[3] as usize].as_str().unwrap().to_owned();
        for (bit, name) in legend["tokenModifiers"].as_array().unwrap().iter().enumerate() {
            if token[4] & (1 << bit) != 0 {
                kind.push('.');
                kind.push_str(name.as_str().unwrap());
            }
        }
        out.push((slice(text, &range), kind));
    }
    out
}

#[test]
fn semantic_tokens() {
    let (_folder, mut client, uri, scene) = opened();
    let full = client.ask_of("semanticTokens/full", &uri);
    let tokens = decoded(&client, &scene, &full["data"]);
    for (text, kind) in [
        ("room", "namespace.declaration"),
        ("bed", "class.declaration"),
        ("bed", "class"),
        ("space", "variable.declaration"),
        ("category", "property.modification"),
        ("forall", "keyword"),
        ("s", "variable.declaration.readonly"),
        ("near", "function.defaultLibrary"),
        ("gap", "function.defaultLibrary"),
        ("atHand", "function"),
        ("thing", "parameter.declaration"),
        ("Object", "type"),
        ("/// Where one sleeps.", "comment.documentation"),
        ("\"steelblue\"", "string"),
        ("0.1", "number"),
        ("@req", "decorator"),
        (">=", "operator"),
    ] {
        assert!(tokens.contains(&(text.to_owned(), kind.to_owned())), "{text} {kind}");
    }
    // A part is what the whole has there.
    let (start, end) = (at(&scene, "|object bed"), at(&scene, "object stand|"));
    let part = json!({ "textDocument": { "uri": uri }, "range": { "start": start, "end": end } });
    let part = client.ask("textDocument/semanticTokens/range", part);
    let part = decoded(&client, &scene, &part["data"]);
    let first = tokens.iter().position(|t| *t == part[0]).unwrap();
    assert!(tokens[first..].starts_with(&part) || tokens.windows(part.len()).any(|w| w == part));
    // A change as the difference to what was sent last.
    let place = at(&scene, "|object lamp");
    client.change(&uri, json!([{ "range": { "start": place, "end": place }, "text": "// the third\n" }]));
    let ask = json!({ "textDocument": { "uri": uri }, "previousResultId": full["resultId"] });
    let delta = client.ask("textDocument/semanticTokens/full/delta", ask);
    let mut data: Vec<Value> = full["data"].as_array().unwrap().clone();
    let edits = delta["edits"].as_array().unwrap();
    assert_eq!(edits.len(), 1);
    let (start, count) =
        (edits[0]["start"].as_u64().unwrap() as usize, edits[0]["deleteCount"].as_u64().unwrap() as usize);
    assert!(count < data.len() / 2, "a difference, not the whole: {count} of {}", data.len());
    data.splice(start..start + count, edits[0]["data"].as_array().unwrap().iter().cloned());
    assert_eq!(json!(data), client.ask_of("semanticTokens/full", &uri)["data"]);
    // Of something long forgotten there is no difference.
    let ask = json!({ "textDocument": { "uri": uri }, "previousResultId": "long ago" });
    assert!(client.ask("textDocument/semanticTokens/full/delta", ask)["data"].is_array());
    // Comments over several lines are one token a line.
    let text = "/* a\n b */ object x;\n";
    client.set(&uri, text);
    let data = client.ask_of("semanticTokens/full", &uri)["data"].clone();
    let texts: Vec<String> = decoded(&client, text, &data).into_iter().map(|t| t.0).collect();
    assert_eq!(texts, ["/* a", " b */", "object", "x"]);
    client.stop();
}

#[test]
fn formatting() {
    let (_folder, mut client, uri, scene) = opened();
    let options = json!({ "tabSize": 2, "insertSpaces": true });
    let document = |extra: Value| {
        let mut params = json!({ "textDocument": { "uri": uri }, "options": options });
        params.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
        params
    };
    assert_eq!(client.ask("textDocument/formatting", document(json!({}))), json!([]));
    let text =
        scene.replace("object lamp;", "object    lamp;").replace("assert low(bed, 1);", "assert   low( bed,1 );");
    client.set(&uri, &text);
    let edits = client.ask("textDocument/formatting", document(json!({})));
    assert_eq!(edited(&text, &edits), scene);
    let line = json!({ "start": at(&text, "|object    lamp"), "end": at(&text, "lamp;|") });
    let edits = client.ask("textDocument/rangeFormatting", document(json!({ "range": line })));
    assert_eq!(edited(&text, &edits), scene.replace("assert low(bed, 1);", "assert   low( bed,1 );"));
    let ended = json!({ "position": at(&text, "low( bed,1 );|"), "ch": ";" });
    let edits = client.ask("textDocument/onTypeFormatting", document(ended));
    assert_eq!(edited(&text, &edits), scene.replace("object lamp;", "object    lamp;"));
    client.stop();
}

#[test]
fn shapes() {
    let (folder, mut client, uri, scene) = opened();
    let folds = client.ask_of("foldingRange", &uri);
    let kinds: Vec<&str> = folds.as_array().unwrap().iter().filter_map(|f| f["kind"].as_str()).collect();
    assert_eq!(kinds, ["region", "region"]);
    let positions = json!({ "textDocument": { "uri": uri }, "positions": [at(&scene, "near(s, b|ed")] });
    let mut grown = client.ask("textDocument/selectionRange", positions)[0].clone();
    let mut texts = Vec::new();
    while grown.is_object() {
        texts.push(slice(&scene, &grown["range"]));
        grown = grown["parent"].clone();
    }
    assert_eq!(&texts[..3], ["bed", "(s, bed, 0.1)", "near(s, bed, 0.1)"]);
    assert_eq!(texts.last(), Some(&scene));
    let linked = client.ask_at("linkedEditingRange", &uri, &scene, "forall |s");
    assert_eq!(slices(&scene, &linked["ranges"]), ["s", "s", "s"]);
    assert_eq!(client.ask_at("linkedEditingRange", &uri, &scene, "object |bed"), Value::Null);
    let links = client.ask_of("documentLink", &uri);
    assert_eq!(slices(&scene, &links), ["room.layout.json", "parts.scene"]);
    assert_eq!(links[0]["target"], client.uri("room.layout.json"));
    // And back; a layout of a program that is not there leads nowhere.
    let layout = std::fs::read_to_string(folder.path().join("room.layout.json")).unwrap();
    let data = client.open("room.layout.json", &layout);
    let back = client.ask_of("documentLink", &data);
    assert_eq!(slices(&layout, &back), ["room.scene"]);
    assert_eq!(back[0]["target"], uri);
    for other in [layout.replace("\"room.scene\"", "\"other.scene\""), "{".to_owned(), "\u{fffd}".to_owned()] {
        client.set(&data, &other);
        assert_eq!(client.ask_of("documentLink", &data), json!([]), "{other}");
    }
    client.stop();
}

#[test]
fn colours() {
    let (_folder, mut client, uri, scene) = opened();
    let found = client.ask_of("documentColor", &uri);
    let texts = slices(&scene, &found);
    assert_eq!(texts, ["linen", "steelblue"]);
    let blue = &found[1]["color"];
    assert_eq!((blue["red"].as_f64().unwrap() * 255.0).round(), 70.0);
    for (color, wanted) in [
        (blue.clone(), vec!["#4682b4", "steelblue"]),
        (json!({ "red": 0.0, "green": 1.0, "blue": 0.4, "alpha": 1 }), vec!["#00ff66"]),
    ] {
        let ask = json!({ "textDocument": { "uri": uri }, "color": color, "range": found[1]["range"] });
        let labels = client.ask("textDocument/colorPresentation", ask);
        let labels: Vec<&str> = labels.as_array().unwrap().iter().map(|p| p["label"].as_str().unwrap()).collect();
        assert_eq!(labels[..1], wanted[..1]);
        assert!(wanted.iter().all(|w| labels.contains(w)), "{labels:?}");
    }
    client.stop();
}

#[test]
fn hints_and_lenses() {
    let (folder, scene, _) = room();
    let mut can = usual();
    can["textDocument"]["inlayHint"] = json!({ "resolveSupport": { "properties": ["tooltip"] } });
    let mut client = Client::start_with(folder.path(), can, Value::Null);
    let uri = client.open("room.scene", &scene);
    client.published(&uri);
    let end = json!({ "line": 999, "character": 0 });
    let all =
        json!({ "textDocument": { "uri": uri }, "range": { "start": { "line": 0, "character": 0 }, "end": end } });
    let hints = client.ask("textDocument/inlayHint", all);
    let line = |n: &Value| scene.lines().nth(n.as_u64().unwrap() as usize).unwrap();
    let shown: Vec<(&str, &str)> = hints
        .as_array()
        .unwrap()
        .iter()
        .map(|h| (line(&h["position"]["line"]), h["label"].as_str().unwrap()))
        .collect();
    for wanted in [
        ("Number space;", "= 0.02"),
        ("assert gap(stand[1], bed) >= space and space > 0.01;", "✗ −0.12 m"),
        ("assert low(bed, 1);", "+0.45 m"),
        ("prefer bed.pos.x > 1;", "✗ −1.00 m"),
    ] {
        assert!(shown.contains(&wanted), "{wanted:?}: {shown:?}");
    }
    let fails = hints.as_array().unwrap().iter().find(|h| h["label"] == "✗ −0.12 m").unwrap().clone();
    let whole = client.ask("inlayHint/resolve", fails);
    let value = hints.as_array().unwrap().iter().find(|h| h["label"] == "= 0.02").unwrap().clone();
    assert_eq!(client.ask("inlayHint/resolve", value.clone()), value);
    assert!(whole["tooltip"]["value"].as_str().unwrap().contains("to repair it: move `stand[1]`"), "{whole}");
    let lenses = client.ask_of("codeLens", &uri);
    let titles: Vec<&str> =
        lenses.as_array().unwrap().iter().map(|l| l["command"]["title"].as_str().unwrap()).collect();
    assert_eq!(titles, ["Check", "Solve", "Repair", "Show", "Repair", "Repair"]);
    let commands: Vec<&str> =
        lenses.as_array().unwrap().iter().map(|l| l["command"]["command"].as_str().unwrap()).collect();
    let repair = "scenelang.repair";
    // This client has no command that shows the room.
    let wanted = ["scenelang.check", "scenelang.solve", "scenelang.repairAll", "scenelang.view", repair, repair];
    assert_eq!(commands, wanted);
    let last = &lenses[4];
    assert_eq!(last["command"]["arguments"][0]["line"], last["range"]["start"]["line"]);
    client.stop();
}

#[test]
fn who_speaks_of_whom() {
    let (_folder, mut client, uri, scene) = opened();
    let names = |v: &Value, key: &str| {
        let list = v.as_array().unwrap().iter().map(|c| c[key]["name"].as_str().unwrap().to_owned());
        list.collect::<Vec<_>>()
    };
    let items = client.ask_at("prepareCallHierarchy", &uri, &scene, "object |lamp");
    let lamp = items[0].clone();
    assert_eq!(lamp["name"], "lamp");
    let speaking = client.ask("callHierarchy/incomingCalls", json!({ "item": lamp }));
    assert_eq!(names(&speaking, "from"), ["assert on(lamp, stand[0])", "assert atHand(lamp, bed) and lamp.top > 0.5"]);
    let constraint = speaking[0]["from"].clone();
    let of = client.ask("callHierarchy/outgoingCalls", json!({ "item": constraint }));
    assert_eq!(names(&of, "to"), ["lamp", "stand"]);
    let asked = client.ask("callHierarchy/incomingCalls", json!({ "item": constraint }));
    assert_eq!(names(&asked, "from"), ["a lamp stands on the left stand"]);
    let requirement = asked[0]["from"].clone();
    let answers = client.ask("callHierarchy/outgoingCalls", json!({ "item": requirement }));
    assert_eq!(names(&answers, "to"), ["assert on(lamp, stand[0])"]);
    client.stop();
}

/// In a file that is broken in the middle, what is whole is served.
#[test]
fn broken_files_are_served() {
    let (_folder, mut client, uri, scene) = opened();
    let text = scene.replace("object lamp;", "object lamp;\nassert near(bed, ((;\nassert bed.");
    client.set(&uri, &text);
    let marks = client.published(&uri);
    assert!(marks.iter().any(|m| m["code"].as_str().unwrap().starts_with("E01")));
    assert!(marks.iter().any(|m| m["code"] == "V0101"), "violations elsewhere are still shown: {marks:?}");
    assert!(marks.iter().all(|m| m["code"] != "V0102" && m["code"] != "E0506"), "{marks:?}");
    let hover = client.ask_at("hover", &uri, &text, "object |bed");
    assert!(hover["contents"]["value"].as_str().unwrap().contains("Where one sleeps"));
    // Names in broken statements are renamed, too.
    let rename = json!({ "textDocument": { "uri": uri }, "position": at(&text, "object |bed"), "newName": "cot" });
    let change = client.ask("textDocument/rename", rename);
    assert!(edited(&text, edits_of(&change, &uri)).contains("assert near(cot, ((;"));
    client.stop();
}
