//! The pages of the book for those who come from elsewhere: every command that they print is run, in its order.

use crate::mcp::client::Client;
use crate::support::{binary, root, run, scenelang, skip};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The blocks of a page that begin with these words.
fn blocks(page: &str, info: &str) -> Vec<String> {
    let text = fs::read_to_string(root().join("spec/src/for").join(page)).unwrap();
    let starts = format!("```{info}\n");
    text.split(starts.as_str()).skip(1).map(|rest| rest.split("\n```").next().unwrap().to_owned()).collect()
}

/// The words of a command; none of the pages needs more of a shell than quotation marks.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('"').enumerate();
    parts
        .flat_map(|(i, part)| match i % 2 {
            1 => vec![part.to_owned()],
            _ => part.split_whitespace().map(str::to_owned).collect(),
        })
        .collect()
}

/// Runs all commands of a page in a folder.
fn follow(page: &str, folder: &Path) {
    let mut ran = 0;
    for line in blocks(page, "sh").iter().flat_map(|block| block.lines()) {
        let words = words(line);
        assert_eq!(words[0], "scenelang", "{page}: {line}");
        // A block that begins anew finds what it is to make.
        if words[1] == "new" && folder.join(&words[2]).exists() {
            continue;
        }
        let ended = scenelang(folder, &words[1..]);
        assert_eq!(ended.code, 0, "{page}: {line}\n{}{}", ended.stdout, ended.stderr);
        ran += 1;
    }
    assert!(ran > 0, "{page}");
}

#[test]
fn unity() {
    let folder = tempfile::tempdir().unwrap();
    follow("unity.md", folder.path());
    assert!(folder.path().join("study/unity/Assets/Scenes/study.unity").is_file());
}

#[test]
fn simulators() {
    let folder = tempfile::tempdir().unwrap();
    follow("simulators.md", folder.path());
    for file in ["office/room.mjcf.xml", "office/room.usda", "office/sdf/room.sdf", "study/study.mjcf.xml"] {
        assert!(folder.path().join(file).is_file(), "{file}");
    }
}

#[test]
fn three() {
    let folder = tempfile::tempdir().unwrap();
    follow("three.md", folder.path());
    let has_node = Command::new("node").arg("--version").output().is_ok();
    if !has_node || !root().join("viewer/node_modules/three").exists() {
        return skip("three.js is not installed in viewer/");
    }
    let code = blocks("three.md", "js three").concat();
    // Beside the packages that it imports.
    let script = tempfile::Builder::new().suffix(".mjs").tempfile_in(root().join("viewer")).unwrap();
    let tried = format!(
        "import {{ readFileSync }} from \"node:fs\";\n{code}\nconst file = readFileSync(process.argv[2]);\n\
         globalThis.self = globalThis;\n\
         const {{ size, desk }} = await room(file.buffer.slice(file.byteOffset, file.byteOffset + file.length));\n\
         console.log(desk.name, size.x > 3, size.y > 2);\n"
    );
    fs::write(script.path(), tried).unwrap();
    let ended = run(Command::new("node").arg(script.path()).arg(folder.path().join("study/study.glb")), b"");
    assert_eq!((ended.code, ended.stdout.trim()), (0, "desk true true"), "{}", ended.stderr);
}

#[test]
fn assistants() {
    let entry: Value = serde_json::from_str(&blocks("assistants.md", "json client").concat()).unwrap();
    let server = &entry["mcpServers"]["scenelang"];
    let args: Vec<&str> = server["args"].as_array().unwrap().iter().map(|arg| arg.as_str().unwrap()).collect();
    assert_eq!((server["command"].as_str(), args[0]), (Some("scenelang"), "mcp"));
    let folder = tempfile::tempdir().unwrap();
    let ended = run(binary().arg("mcp").arg(folder.path()), b"");
    assert!(ended.code == 2 && ended.stderr.contains("the connection to the MCP client failed"), "{}", ended.stderr);
    // The table has a row for each tool, with all that it takes.
    let text = fs::read_to_string(root().join("spec/src/for/assistants.md")).unwrap();
    let tools = Client::new(folder.path(), &[]).ask("tools/list", &json!({}));
    for tool in tools["tools"].as_array().unwrap() {
        let head = format!("| `{}` |", tool["name"].as_str().unwrap());
        let row = text.lines().find_map(|line| line.strip_prefix(&head)).unwrap_or_else(|| panic!("{head}"));
        let told: BTreeSet<&str> = row.split('|').next().unwrap().split('`').skip(1).step_by(2).collect();
        let taken: BTreeSet<&str> =
            tool["inputSchema"]["properties"].as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(told, taken, "{head}");
    }
}
