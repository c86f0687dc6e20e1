//! `syntax`, `hir` and `constraints`: what they print of a small program and of a broken one, and what holds for every
//! example. What the language book shows of them is run here, too.

use crate::support::{Ended, example, for_each_example, root, scenelang, scenelang_with_input};
use serde_json::Value;
use std::fs;
use std::path::Path;

const SMALL: &str = "\
region room;
/// Two of them.
object chair[2];
object rug;
Number space;
Degree turn;
space <- 40cm; // as measured
rug.rot <- rot(0, 90, 0);
@req(\"chairs stand apart\")
assert forall i in 0..1: chair[i + 1].pos.x - chair[i].pos.x >= space and chair[i].rot.y < 180 - 2 * turn;
prefer near(chair[0], rug, rand(1, 2)) weight 2;
@req(\"a rug lies under things\")
allowCollide(rug, chair);
predicate low(Object a) := a.top < 1 and inside(a, room);
assert count(c in objects where .color = \"\": low(c)) >= 2 or clear(rug, front, 1);
assert wallMounted(rug, room);
";

const BROKEN: &str = "\
object lamp, table;
lamp.pos <- vec3(1,
assert near(lamp, table.
lamp.colour <- \"red;
assert lamp.pos.x > unknown;
";

/// JSON with what is short on one line.
fn spread(json: &Value, indent: usize) -> String {
    let line = json.to_string();
    if line.len() + indent <= 120 {
        return line;
    }
    let inner = indent + 1;
    let (brackets, parts): (_, Vec<String>) = match json {
        Value::Array(items) => ("[]", items.iter().map(|item| spread(item, inner)).collect()),
        Value::Object(members) => {
            let member = |(name, value): (&String, &Value)| format!("\"{name}\": {}", spread(value, inner));
            ("{}", members.iter().map(member).collect())
        }
        _ => return line,
    };
    let (open, close) = brackets.split_at(1);
    let separator = format!(",\n{}", " ".repeat(inner));
    format!("{open}\n{0}{1}\n{2}{close}", " ".repeat(inner), parts.join(&separator), " ".repeat(indent))
}

/// What a command said, for a snapshot.
fn shown(ended: &Ended) -> String {
    let stdout = match serde_json::from_str::<Value>(&ended.stdout) {
        Ok(json) => format!("{}\n", spread(&json, 0)),
        Err(_) => ended.stdout.clone(),
    };
    format!("exit code {}\n── standard output\n{stdout}── standard error\n{}", ended.code, ended.stderr)
}

#[test]
fn what_they_print() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("small", SMALL), ("broken", BROKEN)] {
        let file = format!("{name}.scene");
        fs::write(folder.path().join(&file), text).unwrap();
        for command in ["syntax", "hir", "constraints"] {
            for format in ["text", "json"] {
                let ended = scenelang(folder.path(), [command, &file, "--format", format]);
                insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
                    insta::assert_snapshot!(format!("{command}-{name}-{format}"), shown(&ended));
                });
            }
        }
    }
}

#[test]
fn exit_codes() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("good", SMALL), ("broken", BROKEN), ("unknown", "assert a.pos.x > 1;\n")] {
        fs::write(folder.path().join(format!("{name}.scene")), text).unwrap();
    }
    fs::write(folder.path().join("bytes.scene"), b"object a; // \xff\n").unwrap();
    for (file, syntax, hir, constraints) in [
        ("good.scene", 0, 0, 0),
        ("broken.scene", 1, 1, 2),
        ("unknown.scene", 0, 1, 2),
        ("bytes.scene", 2, 2, 2),
        ("nowhere.scene", 2, 2, 2),
    ] {
        for (command, wanted) in [("syntax", syntax), ("hir", hir), ("constraints", constraints)] {
            for format in ["text", "json"] {
                let ended = scenelang(folder.path(), [command, file, "--format", format]);
                assert_eq!(ended.code, wanted, "{command} {file}: {}", ended.stderr);
                assert_eq!(ended.stderr.is_empty(), wanted == 0, "{command} {file}: {}", ended.stderr);
                assert_eq!(ended.stdout.is_empty(), wanted == 2, "{command} {file}: {}", ended.stdout);
            }
        }
    }
}

#[test]
fn standard_input_is_a_file_like_others() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.scene"), SMALL).unwrap();
    for command in ["syntax", "hir", "constraints"] {
        let of = |path| scenelang_with_input(folder.path(), [command, path, "--format", "json"], SMALL.as_bytes());
        let (file, input) = (of("a.scene"), of("-"));
        assert_eq!(input.stdout.replace("<stdin>", "a.scene"), file.stdout, "{command}");
    }
}

/// A chain of definitions nests as deeply as it is long; sharing makes a formula larger than its nodes.
#[test]
fn formulas_may_be_deep_and_shared() {
    let folder = tempfile::tempdir().unwrap();
    let deep: String = (1..5000).map(|i| format!("Number v{i}; v{i} <- abs(v{} * w) + 1;\n", i - 1)).collect();
    fs::write(folder.path().join("deep.scene"), format!("Number w; Number v0;\n{deep}assert v4999 > 0;\n")).unwrap();
    let wide: String = (1..99).map(|i| format!("Number v{i}; v{i} <- v{0} * v{0} + w;\n", i - 1)).collect();
    fs::write(folder.path().join("wide.scene"), format!("Number w; Number v0;\n{wide}assert v98 > 0;\n")).unwrap();
    for file in ["deep.scene", "wide.scene"] {
        for (format, most) in [("text", 200_000), ("json", 2_000_000)] {
            let ended = scenelang(folder.path(), ["constraints", file, "--format", format]);
            assert_eq!(ended.code, 0, "{file}: {}", ended.stderr);
            assert!(ended.stdout.len() < most, "{file}: {} bytes", ended.stdout.len());
        }
    }
}

mod every_example {
    use super::*;

    fn json(command: &str, scene: &Path) -> Value {
        let ended = scenelang(&root(), [command.as_ref(), scene.as_os_str(), "--format".as_ref(), "json".as_ref()]);
        assert_eq!(ended.code, 0, "{command}: {}", ended.stderr);
        assert_eq!(ended.stdout.lines().count(), 1);
        serde_json::from_str(&ended.stdout).unwrap()
    }

    /// The text of the leaves, each where it says it is.
    fn leaves(node: &Value, text: &mut String) {
        assert_eq!(node["range"][0], text.len());
        match node["children"].as_array() {
            Some(children) => children.iter().for_each(|child| leaves(child, text)),
            None => text.push_str(node["text"].as_str().unwrap()),
        }
        assert_eq!(node["range"][1], text.len());
    }

    /// Every reference leads to a part that was written before, and what is a leaf says what it is.
    fn well_made(formula: &Value, ids: &mut Vec<u64>) {
        ids.extend(formula["id"].as_u64());
        if let Some(id) = formula["ref"].as_u64() {
            assert!(ids.contains(&id), "{formula}");
        } else if let Some(operands) = formula["operands"].as_array() {
            assert!(formula["op"].is_string(), "{formula}");
            operands.iter().for_each(|operand| well_made(operand, ids));
        } else {
            let says = ["number", "truth", "property", "variable", "draw", "object", "region", "side"];
            assert!(says.iter().any(|member| !formula[member].is_null()), "{formula}");
            assert_eq!(formula["number"].is_null(), formula["unit"].is_null(), "{formula}");
        }
    }

    fn is_shown(name: &str) {
        let scene = example(name);
        let written = fs::read_to_string(&scene).unwrap();

        let mut text = String::new();
        leaves(&json("syntax", &scene)["tree"], &mut text);
        assert_eq!(text, written);

        let hir = json("hir", &scene);
        for stmt in hir["statements"].as_array().unwrap() {
            let exprs = stmt["expressions"].as_array().unwrap();
            for (at, expr) in exprs.iter().enumerate() {
                assert!(expr["type"].as_str().is_some_and(|ty| ty != "Error"), "{expr}");
                assert!(expr["kind"] != "NameRef" || !expr["resolution"].is_null(), "{expr}");
                let before = |child: &Value| child.as_u64().is_some_and(|child| child < at as u64);
                assert!(expr["children"].as_array().unwrap().iter().all(before), "{expr}");
            }
        }

        let constraints = json("constraints", &scene);
        let rows = constraints["constraints"].as_array().unwrap();
        assert!(!rows.is_empty());
        rows.iter().for_each(|row| well_made(&row["formula"], &mut Vec::new()));
        let report = scenelang(&root(), ["check".as_ref(), scene.as_os_str(), "--format".as_ref(), "json".as_ref()]);
        assert_eq!(report.reports()[0]["file"], constraints["file"]);
    }
    for_each_example!(is_shown);
}

/// Whether all that `part` says is in `whole`: members of objects, and items of arrays in their order.
fn contains(whole: &Value, part: &Value) -> bool {
    match (whole, part) {
        (Value::Object(whole), Value::Object(part)) => {
            part.iter().all(|(name, value)| whole.get(name).is_some_and(|w| contains(w, value)))
        }
        (Value::Array(whole), Value::Array(part)) if part.iter().any(Value::is_object) => {
            let mut rest = whole.iter();
            part.iter().all(|value| rest.any(|w| contains(w, value)))
        }
        _ => whole == part,
    }
}

/// A block `text syntax`, `json hir`, … of the book is what the command prints of the program before it; of JSON a part
/// is enough.
#[test]
fn the_book_shows_what_they_print() {
    let mut shown = 0;
    for page in ["command-line.md", "reports.md"] {
        let text = fs::read_to_string(root().join("spec/src").join(page)).unwrap();
        let mut scene = "";
        for block in text.split("\n```").skip(1).step_by(2) {
            let (info, body) = block.split_once('\n').unwrap();
            let (format, command) = info.split_once(' ').unwrap_or((info, ""));
            match (format, command) {
                ("scene", "") => scene = body,
                ("text" | "json", "syntax" | "hir") | ("json", "constraints") => {
                    let folder = tempfile::tempdir().unwrap();
                    fs::write(folder.path().join("room.scene"), format!("{scene}\n")).unwrap();
                    let ended = scenelang(folder.path(), [command, "room.scene", "--format", format]);
                    if format == "text" {
                        assert_eq!(ended.stdout.trim_end(), body.trim_end(), "{page}: {info}");
                    } else {
                        let part: Value = serde_json::from_str(body).unwrap_or_else(|e| panic!("{page}: {info}: {e}"));
                        let whole: Value = serde_json::from_str(&ended.stdout).unwrap();
                        assert!(contains(&whole, &part), "{page}: {info}: not in {whole:#}");
                    }
                    shown += 1;
                }
                _ => {}
            }
        }
    }
    assert!(shown >= 5, "only {shown} blocks");
}
