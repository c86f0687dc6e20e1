//! The committed suite: none of its figures may fall. `./x evaluation` measures it anew.

use scenelang_eval::resemblance::Lexical;
use scenelang_eval::suite::{Figures, Means, Suite, page, parse};
use scenelang_solve::Stop;
use std::path::Path;

fn read(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/evaluation").join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn reader(request: &str) -> String {
    let options = scenelang_formalize::Options { literal: true };
    scenelang_formalize::write::write(&scenelang_formalize::read(request, &options).draft)
}

fn committed() -> (Suite, Figures) {
    let mut figures: serde_json::Value = serde_json::from_str(&read("figures.json")).unwrap();
    figures.as_object_mut().unwrap().remove("written");
    (parse(&read("suite.json")).unwrap(), serde_json::from_value(figures).unwrap())
}

#[test]
fn no_committed_figure_falls() {
    let (suite, before) = committed();
    let stop = Stop::default();
    let means = Means { reader: &reader, similarity: &Lexical, draw: None, stop: &stop };
    let cases: Vec<_> = (0..suite.scenes).map(|n| suite.case(n, &means, None).unwrap().unwrap()).collect();
    let now = Figures::of(&suite.name, &cases);
    let fallen = now.fallen(&before);
    assert!(
        fallen.is_empty(),
        "these figures are lower than those in tests/evaluation/figures.json (what, before, now): {fallen:?}"
    );
}

/// The page of the book says what the committed figures are.
#[test]
fn the_page_has_the_committed_figures() {
    let (_, figures) = committed();
    let page = page(&figures, &[]).markdown("images");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/evaluation.md");
    let book = std::fs::read_to_string(path).unwrap();
    let rows = |text: &str| text.lines().filter(|l| l.starts_with('|')).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(rows(&page), rows(&book), "`./x evaluation` writes docs/evaluation.md anew");
}

#[test]
fn a_fall_is_seen() {
    let (_, figures) = committed();
    assert!(figures.fallen(&figures).is_empty());
    let mut lower = figures.clone();
    lower.search[3] -= 0.1;
    lower.resemblance[1][2] -= 0.1;
    let what: Vec<String> = lower.fallen(&figures).into_iter().map(|(what, ..)| what).collect();
    assert_eq!(what, ["relations after iteration 3", "F1 of objects at 0.8"]);
    lower.search.pop();
    assert_eq!(lower.fallen(&figures).len(), 3);
}

#[test]
fn a_suite_is_checked() {
    for (text, why) in [
        ("{}", "missing field"),
        (r#"{"format": "x", "name": "a", "scenes": 1, "seed": 0}"#, "its format is"),
        (r#"{"format": "scenelang.suite/1", "name": "a", "scenes": 0, "seed": 0}"#, "it has no scenes"),
        (r#"{"format": "scenelang.suite/1", "name": "a", "scenes": 20000, "seed": 0}"#, "it has more than"),
        (r#"{"format": "scenelang.suite/1", "name": "a", "scenes": 1, "seed": 0, "x": 1}"#, "unknown field"),
    ] {
        let error = parse(text).unwrap_err();
        assert!(error.starts_with(why), "{error}");
    }
}
