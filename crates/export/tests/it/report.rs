//! The report as a page.

use crate::fixture::{named, parts, scene};
use roxmltree::{Document, Node, ParsingOptions};
use scenelang_export::report::Report;
use scenelang_export::{Exporter, Scene};

fn page(scene: &Scene) -> String {
    let files = Report.files(scene).unwrap();
    assert_eq!(files.len(), 1);
    assert_eq!(files[0].path.to_str(), Some("report.html"));
    String::from_utf8(files[0].bytes.clone()).unwrap()
}

fn read(page: &str) -> Document<'_> {
    Document::parse_with_options(page, ParsingOptions { allow_dtd: true, ..ParsingOptions::default() }).unwrap()
}

fn text(node: Node<'_, '_>) -> String {
    node.descendants().filter_map(|n| if n.is_text() { n.text() } else { None }).collect()
}

/// The cells of the rows below a heading.
fn rows(document: &Document<'_>, heading: &str) -> Vec<Vec<String>> {
    let heading = document.descendants().find(|n| n.has_tag_name("h2") && text(*n) == heading).unwrap();
    let table = heading.next_siblings().find(|n| n.has_tag_name("table")).unwrap();
    let body = table.descendants().find(|n| n.has_tag_name("tbody")).unwrap();
    let cells = |row: Node<'_, '_>| row.children().filter(Node::is_element).map(text).collect();
    body.children().filter(Node::is_element).map(cells).collect()
}

#[test]
fn it_says_what_holds_and_by_how_much_and_what_the_objects_are() {
    let scene = scene();
    let page = page(&scene);
    assert!(page == self::page(&scene), "two runs give the same bytes");
    assert!(page.starts_with("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>"));
    let document = read(&page);
    let requirements = rows(&document, "Requirements");
    assert_eq!(requirements[0], ["holds", "0.1 m", "forall c in chair: gap(c, table) >= 0", ""]);
    assert_eq!(requirements[1], ["fails", "-0.999 m", "table.pos.x = 1 </script><b>", ""]);
    assert_eq!(rows(&document, "Preferences"), [["fails", "-1 m", "balloon.pos.y < 1", ""]]);
    let objects = rows(&document, "Objects");
    assert_eq!(objects.len(), scene.objects.len());
    assert_eq!(objects[0][..4], ["table", "table", "table", "1.60 × 0.75 × 0.80"]);
    assert_eq!(objects[0][4], format!("{:.1}", scene.objects[0].mass));
    assert!(rows(&document, "Versions").contains(&vec!["scenelang".to_owned(), env!("CARGO_PKG_VERSION").to_owned()]));
    // Plan and picture are in it, and nothing is loaded or run.
    assert_eq!(document.descendants().filter(|n| n.tag_name().name() == "svg").count(), 1);
    for node in document.descendants().filter(Node::is_element) {
        assert!(!["script", "link", "iframe", "object", "embed"].contains(&node.tag_name().name()));
        for attribute in node.attributes().filter(|a| ["src", "href"].contains(&a.name())) {
            assert!(attribute.value().starts_with("data:image/png;base64,"));
        }
        assert!(node.attributes().all(|a| !a.name().starts_with("on")));
    }
}

#[test]
fn the_request_is_what_is_quoted_at_the_beginning_of_the_program() {
    let mut scene = scene();
    let quoted = |scene: &Scene| {
        let page = page(scene);
        let document = read(&page);
        let quote = document.descendants().find(|n| n.has_tag_name("blockquote"));
        quote.map(|quote| (text(quote.prev_sibling_element().unwrap()), text(quote)))
    };
    assert_eq!(quoted(&scene), None);
    scene.program[0].1 =
        "// Written by scenelang; checksum 0\n// From a request:\n//\n// > a hall &\n// > <b>two\n".into();
    assert_eq!(quoted(&scene), Some(("Request".into(), "a hall &\n<b>two".into())));
    scene.program[0].1 = "// A hall\n// with chairs.\n\n// Not this.\nregion room;\n".into();
    assert_eq!(quoted(&scene), Some(("About".into(), "A hall\nwith chairs.".into())));
}

#[test]
fn hostile_names_stay_text() {
    const HOSTILE: &str = "\"'><script>alert(1)</script><img src=x onerror=alert(1)>&lt;\u{202e}\u{0}";
    let mut parts = parts();
    parts.report["constraints"][0]["message"] = HOSTILE.into();
    parts.report["constraints"][0]["requirements"] = vec![HOSTILE].into();
    parts.report["constraints"][0]["id"] = HOSTILE.into();
    parts.report["constraints"][0]["unit"] = HOSTILE.into();
    parts.report["diagnostics"] = serde_json::json!([{ "severity": HOSTILE, "code": HOSTILE, "message": HOSTILE }]);
    parts.report["tolerances"] = serde_json::json!({ HOSTILE: 1 });
    let mut scene = parts.build().unwrap();
    scene.name = HOSTILE.into();
    scene.program[0].1 = format!("// > {HOSTILE}\n");
    for (index, object) in scene.objects.iter_mut().enumerate() {
        object.name = format!("{HOSTILE}{index}");
        object.label = HOSTILE.into();
        object.category = HOSTILE.into();
        object.requirements = vec![HOSTILE.into()];
    }
    scene.regions[0].name = HOSTILE.into();
    let page = page(&scene);
    let document = read(&page);
    assert!(document.descendants().all(|n| n.tag_name().name() != "script"));
    assert_eq!(document.descendants().filter(|n| n.has_tag_name("img")).count(), 1);
    assert!(!page.contains(['\u{0}', '\u{202e}']));
    assert!(rows(&document, "Objects").iter().all(|row| row[0].starts_with("\"'><script>alert(1)</script>")));
    // Whatever script a name is in.
    assert!(self::page(&named("größe灯").build().unwrap()).contains("<code>größe灯</code>"));
}
