//! `export --only report`: the page of each example has every statement once.

use crate::support::{folder_with, for_each_example, scenelang};
use serde_json::Value;
use std::fs;

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;").replace('\n', "&#10;")
}

fn every_statement_is_there_once(name: &str) {
    let (folder, scene) = folder_with(name);
    let ended = scenelang(folder.path(), ["solve", &scene.display().to_string()]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let layout = scene.with_extension("layout.json").display().to_string();
    let page = |out: &str| {
        let ended = scenelang(folder.path(), ["export", &layout, "-o", out, "--only", "report"]);
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        fs::read_to_string(folder.path().join(out).join("report.html")).unwrap()
    };
    let (first, second) = (page("first"), page("second"));
    assert!(first == second, "two runs give the same bytes");
    let report = scenelang(folder.path(), ["check", &layout, "--format", "json"]).reports().remove(0);
    let rows = report["constraints"].as_array().unwrap();
    assert!(!rows.is_empty());
    for row in rows {
        let (id, text) = (row["id"].as_str().unwrap(), row["text"].as_str().unwrap());
        // The page is of the layout's own folder: of a file only its name is the same.
        let place = escaped(id.rsplit_once('/').map_or(id, |(_, name)| name));
        let cells = first.split("<td title=\"").skip(1).filter(|cell| {
            let own = cell.split_once('"').map_or("", |(id, _)| id);
            own == place || own.ends_with(&format!("/{place}"))
        });
        let cells: Vec<&str> = cells.collect();
        assert_eq!(cells.len(), 1, "{id}");
        assert!(cells[0].split("</td>").next().unwrap().contains(&format!("<code>{}</code>", escaped(text))), "{id}");
        for said in row["requirements"].as_array().into_iter().flatten().filter_map(Value::as_str) {
            assert!(first.contains(&format!("<q>{}</q>", escaped(said))), "{said}");
        }
    }
    assert_eq!(first.matches("<td title=\"").count(), rows.len());
}
for_each_example!(every_statement_is_there_once);
