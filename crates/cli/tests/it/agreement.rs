//! The command line and the server say the same of the same files, word for word.

use crate::speaking::Client;
use crate::support::{EXAMPLES, binary, example, root, scenelang};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

#[path = "../../../lang/tests/it/blocks.rs"]
#[allow(dead_code, reason = "only the blocks are of use here")]
mod blocks;

/// What is said at a place: line, column, severity, code, message with notes.
type Said = BTreeSet<(u64, u64, u64, String, String)>;

/// The examples, and the programs of the compiler's own cases.
fn corpus(folder: &Path) -> Vec<String> {
    let mut files = Vec::new();
    let mut add = |name: String, text: &str| {
        fs::write(folder.join(&name), text).unwrap();
        files.push(name);
    };
    for name in EXAMPLES {
        add(format!("{name}.scene"), &fs::read_to_string(example(name)).unwrap());
    }
    let mut pages: Vec<_> = fs::read_dir(root().join("crates/lang/tests/it/cases")).unwrap().collect();
    pages.sort_by_key(|page| page.as_ref().unwrap().path());
    for page in pages {
        let page = page.unwrap().path();
        let stem = page.file_stem().unwrap().to_string_lossy().into_owned();
        for (i, block) in blocks::blocks(&fs::read_to_string(&page).unwrap()).iter().enumerate() {
            if block.is_scene() && !block.words().contains(&"core") {
                add(format!("{stem}-{i}.scene"), &block.text);
            }
        }
    }
    files
}

/// What the command line says of a file, at places in the file `of`.
fn by_command(report: &Value, of: &str) -> Said {
    let number = |value: &Value| value.as_u64().unwrap_or(1);
    let text = |value: &Value| value.as_str().unwrap().to_owned();
    let found = report["diagnostics"].as_array().unwrap().iter();
    let here = found.filter(|d| d["span"].is_null() || d["span"]["file"] == of);
    here.map(|d| {
        let lines: Vec<String> =
            std::iter::once(&d["message"]).chain(d["notes"].as_array().unwrap()).map(text).collect();
        let [line, column] = [0, 1].map(|i| number(&d["span"]["start"][i]));
        (line, column, if d["severity"] == "error" { 1 } else { 2 }, text(&d["code"]), lines.join("\n"))
    })
    .collect()
}

/// What the server has published last about a file; violations apart, which reports have as rows.
fn by_server(published: &Value) -> Said {
    let marks = published["params"]["diagnostics"].as_array().unwrap().iter();
    marks
        .filter(|mark| !mark["code"].as_str().unwrap().starts_with('V'))
        .map(|mark| {
            let [line, column] = ["line", "character"].map(|at| mark["range"]["start"][at].as_u64().unwrap() + 1);
            let text = |key: &str| mark[key].as_str().unwrap().to_owned();
            (line, column, mark["severity"].as_u64().unwrap(), text("code"), text("message"))
        })
        .collect()
}

/// A server with a folder as its workspace, that counts columns as reports do.
fn server(folder: &Path) -> Client {
    let mut command = binary();
    command.arg("lsp").current_dir(folder);
    let mut client = Client::start(command, "agreement");
    let can = json!({ "general": { "positionEncodings": ["utf-32"] } });
    let root = format!("file://{}", folder.display());
    client.ask("initialize", &json!({ "processId": null, "rootUri": root, "capabilities": can }));
    client.tell("initialized", &json!({}));
    client
}

/// Opens a program; what is said of it in the end, when proofs have been looked for, too.
fn open(client: &mut Client, folder: &Path, file: &str) -> Said {
    let uri = format!("file://{}/{file}", folder.display());
    let text = fs::read_to_string(folder.join(file)).unwrap();
    let document = json!({ "uri": uri, "languageId": "scenelang", "version": 1, "text": text });
    client.tell("textDocument/didOpen", &json!({ "textDocument": document }));
    by_server(&published(client, folder, file, 2))
}

/// The message with what is said of a file, the so-manieth.
fn published(client: &mut Client, folder: &Path, file: &str, count: usize) -> Value {
    let uri = format!("file://{}/{file}", folder.display());
    client.wait_for(count, |m| m["method"] == "textDocument/publishDiagnostics" && m["params"]["uri"] == uri.as_str())
}

fn agree_on_the_corpus(settings: Option<&str>) {
    let folder = tempfile::tempdir().unwrap();
    let files = corpus(folder.path());
    if let Some(text) = settings {
        fs::write(folder.path().join("scenelang.toml"), text).unwrap();
    }
    let ended =
        scenelang(folder.path(), ["check", "--format", "json"].into_iter().chain(files.iter().map(String::as_str)));
    let reports = ended.reports();
    assert_eq!(reports.len(), files.len());
    let mut client = server(folder.path());
    let mut said = 0;
    for (file, report) in files.iter().zip(&reports) {
        let (server, command) = (open(&mut client, folder.path(), file), by_command(report, file));
        assert_eq!(server, command, "{file} with {settings:?}");
        said += command.len();
        let broken = by_command(report, "scenelang.toml");
        if settings.is_some_and(|text| text.contains("physik")) {
            let server = by_server(&published(&mut client, folder.path(), "scenelang.toml", 1));
            assert!(server == broken && broken.len() == 1, "{server:?} and {broken:?}");
        }
    }
    assert!(said > 100 || settings.is_some(), "only {said} diagnostics");
    client.end();
}

#[test]
fn without_settings() {
    agree_on_the_corpus(None);
}

#[test]
fn with_settings() {
    agree_on_the_corpus(Some("physics = false\n[lints]\nallow = [\"W0201\", \"W0203\", \"W0401\"]\n"));
}

#[test]
fn with_settings_that_are_broken() {
    agree_on_the_corpus(Some("physik = false\n"));
}

#[test]
fn of_layouts() {
    let good =
        r#"{"format":"scenelang.layout/1","scene":"room.scene","objects":{"a":{"pos":[2,0,0],"scale":[1,1,1]}}}"#;
    for (what, layout) in [
        ("good", good.to_owned()),
        ("no JSON", good.replace("]}}}", "]}}")),
        ("no layout", "[]".to_owned()),
        ("an object too many", good.replace("{\"a\":", "{\"b\":{\"pos\":[0,0,0],\"scale\":[1,1,1]},\"a\":")),
        ("an object too few", good.replace("\"a\":{\"pos\":[2,0,0],\"scale\":[1,1,1]}", "")),
        ("a number out of range", good.replace("[2,", "[1e9,")),
        ("a member given twice", good.replace("[2,0,0],", "[2,0,0],\"pos\":[2,0,0],")),
    ] {
        for settings in [None, Some("[lints]\nallow = [\"W0201\"]\n"), Some("eta = []\n")] {
            let folder = tempfile::tempdir().unwrap();
            fs::write(folder.path().join("room.scene"), "object a;\nassert a.pos.x > 1;\n").unwrap();
            fs::write(folder.path().join("room.layout.json"), &layout).unwrap();
            if let Some(text) = settings {
                fs::write(folder.path().join("scenelang.toml"), text).unwrap();
            }
            let ended = scenelang(folder.path(), ["check", "room.layout.json", "--format", "json"]);
            let command = by_command(&ended.reports()[0], "room.layout.json");
            let mut client = server(folder.path());
            open(&mut client, folder.path(), "room.scene");
            let server = by_server(&published(&mut client, folder.path(), "room.layout.json", 1));
            assert_eq!(server, command, "{what} with {settings:?}");
            client.end();
        }
    }
}
