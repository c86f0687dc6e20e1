//! Six requests with annotations of our own, hand-made layouts for five of them, and the scores that these have.

use scenelang_base::{FileId, SourceFile, SourceMap};
use scenelang_eval::sceneeval::{Case, Made, Scores, Table, read};
use scenelang_lang::{Options, compile_text};
use scenelang_layout::Layout;
use scenelang_layout::file;
use std::path::Path;

const ANNOTATIONS: &str = include_str!("../sceneeval/annotations.csv");

/// A layout in a room of 4 m by 4 m by 2.6 m around the origin: names with pos, yaw and scale.
fn layout(objects: &[(&str, [f64; 3], f64, [f64; 3])]) -> Layout {
    let entry = |(name, pos, yaw, scale): &(&str, _, f64, _)| {
        format!("{name:?}: {{ \"pos\": {pos:?}, \"rot\": [0, {yaw}, 0], \"scale\": {scale:?} }}")
    };
    let objects: Vec<String> = objects.iter().map(entry).collect();
    let text = format!(
        "{{ \"format\": \"scenelang.layout/1\", \"objects\": {{ {} }},
            \"regions\": {{ \"room\": {{ \"pos\": [0, 0, 0], \"scale\": [4, 2.6, 4] }} }} }}",
        objects.join(", ")
    );
    let mut sources = SourceMap::new();
    let id: FileId = sources.add(SourceFile::new("x.layout.json", "x.layout.json", text.clone()));
    let read = file::read(&text, id);
    assert!(read.usable && read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    read.layout
}

const DEN: &str = r#"
region room;
object desk;
desk.material <- "walnut";
object lamp;
object chair;
@req("a chair faces it")
assert near(chair, desk, 2);
assert on(lamp, desk);
"#;

fn scores() -> Scores {
    let benchmark = read(ANNOTATIONS).unwrap();
    let table = Table::new();
    let layouts = [
        // The chair has its back to the desk.
        layout(&[
            ("desk", [-1.4, 0.0, -1.6], 0.0, [1.2, 0.7, 0.8]),
            ("lamp", [-1.4, 0.7, -1.6], 0.0, [0.2, 0.4, 0.2]),
            ("chair", [-1.4, 0.0, -0.8], 0.0, [0.5, 0.9, 0.5]),
        ]),
        // One bench stands free, and no program says what is red.
        layout(&[
            ("bench1", [-1.7, 0.0, 0.0], 90.0, [1.2, 0.5, 0.4]),
            ("bench2", [1.0, 0.0, 0.0], 90.0, [1.2, 0.5, 0.4]),
            ("rug", [0.0, 0.0, 0.0], 0.0, [1.0, 0.01, 1.0]),
        ]),
        layout(&[
            ("table", [0.0, 0.0, 0.0], 0.0, [1.0, 0.7, 1.0]),
            ("stool[0]", [0.8, 0.0, 0.0], 0.0, [0.4, 0.5, 0.4]),
            ("stool[1]", [-0.8, 0.0, 0.0], 0.0, [0.4, 0.5, 0.4]),
            ("stool[2]", [0.0, 0.0, 0.8], 0.0, [0.4, 0.5, 0.4]),
            ("stool[3]", [0.0, 0.0, -0.8], 0.0, [0.4, 0.5, 0.4]),
        ]),
        // It stands at the sofa's own left, which is on the right of who looks at its front; half of it is outside, where
        // there is no floor to stand on.
        layout(&[
            ("couch", [-0.8, 0.0, -1.5], 0.0, [2.0, 0.8, 0.9]),
            ("plant", [-2.0, 0.0, -1.5], 0.0, [0.4, 1.0, 0.4]),
        ]),
        // The mirror's back is 4 mm from the wall; the lantern hangs 20 cm below the ceiling.
        layout(&[
            ("mirror", [0.0, 1.0, -1.976], 0.0, [0.6, 0.8, 0.04]),
            ("pendantLamp", [0.0, 2.1, 0.0], 0.0, [0.3, 0.3, 0.3]),
        ]),
    ];
    let compiled = compile_text("a.scene", Path::new("a.scene"), DEN, Options::default());
    let program = compiled.program.as_ref().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let mut cases = Vec::new();
    for (i, asked) in benchmark.requests.iter().enumerate() {
        cases.push(match layouts.get(i) {
            Some(layout) => {
                let program = (i == 0).then_some((program, compiled.main, DEN));
                let made = Made { layout, program, holds: program.map(|_| true) };
                Case::of(asked, &made, &table).unwrap()
            }
            None => Case::without(asked, "nothing was made".to_owned(), &table),
        });
    }
    Scores { cases, unread: benchmark.unread }
}

/// What hangs without a program is held by its noun: the mirror by a wall; a pendant lamp is a lamp, and has to stand.
#[test]
fn the_summary() {
    let want = "\
id,difficulty,layout,objects,CNT,CNT_of,ATR,ATR_of,OOR,OOR_of,OAR,OAR_of,supported,not_colliding,in_bounds,navigability,accessibility,unjudged
1,easy,holds,3,3,3,1,1,1,2,1,1,3,3,3,1.0000,0.7917,0
2,easy,unjudged,3,2,2,0,1,0,0,1,2,3,3,3,1.0000,1.0000,0
3,medium,unjudged,5,2,2,0,0,1,1,0,0,5,5,5,1.0000,1.0000,1
4,medium,unjudged,2,2,2,0,0,0,1,0,0,1,2,1,1.0000,1.0000,1
5,hard,unjudged,2,2,2,0,0,0,0,1,2,1,2,2,1.0000,,0
6,hard,none,0,0,1,0,0,0,0,0,1,0,0,0,,,0
";
    let found = scores().csv();
    // Walkable and reachable shares are looked at by themselves: only that they are there, and their range.
    let without = |text: &str| -> Vec<String> {
        let cut = |line: &str| {
            line.split(',')
                .enumerate()
                .filter(|(i, _)| ![15, 16].contains(i))
                .map(|(_, f)| f.to_owned())
                .collect::<Vec<_>>()
                .join(",")
        };
        text.lines().map(cut).collect()
    };
    assert_eq!(without(&found), without(want), "{found}");
    for line in found.lines().skip(1).take(5) {
        let walked: f64 = line.split(',').nth(15).unwrap().parse().unwrap();
        assert!(0.5 < walked && walked <= 1.0, "{line}");
    }
    assert_eq!(found, scores().csv());
}

#[test]
fn the_report() {
    let scores = scores();
    let found = scores.json();
    assert_eq!(found["format"], "scenelang.sceneeval/1");
    let all = &found["summary"]["all"];
    assert_eq!(all["good"], serde_json::json!([5, 6]));
    assert_eq!(all["scores"], serde_json::json!({ "CNT": [11, 12], "ATR": [1, 2], "OOR": [2, 4], "OAR": [3, 6] }));
    assert_eq!(all["perfect"], serde_json::json!([1, 6]));
    assert_eq!(found["summary"]["medium"]["scores"]["OOR"], serde_json::json!([1, 2]));
    let first = &found["requests"][0]["misses"];
    let want = serde_json::json!([{
        "measure": "OOR",
        "annotation": "eq,1,facing,0,desk,chair",
        "sentence": "A lamp stands on the desk, and a chair faces it.",
        "found": 0,
        "wanted": 1,
        "absent": false,
        "fate": "read wrongly",
        "statements": ["assert near(chair, desk, 2)"],
    }]);
    assert_eq!(*first, want);
    // Without a program nobody knows where it got lost.
    assert_eq!(found["requests"][1]["misses"][0]["fate"], serde_json::Value::Null);
    assert_eq!(found["requests"][4]["plausibility"]["unsupported"], serde_json::json!(["pendantLamp"]));
    assert_eq!(found["requests"][5]["trouble"], "nothing was made");
    assert_eq!(scores.fates(), [("not read", 0), ("read wrongly", 1), ("not satisfied", 0), ("not known", 6)]);
}
