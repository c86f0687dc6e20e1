//! Layout files good and broken: which error, and where.

use proptest::prelude::*;
use scenelang_base::{Code, FileId, codes::*};
use scenelang_layout::file::{ReadLayout, decode, read};
use scenelang_layout::{DecisionValue, Part, Vec3};

const GOOD: &str = r#"{ "format": "scenelang.layout/1",
  "scene": "room.scene",
  "seed": 7,
  "objects": {
    "lamp": { "pos": [1, 0, 1], "rot": [0, 0, 0], "scale": [0.3, 1.5, 0.3] },
    "chair[0]": { "pos": [-1, 0, 0], "rot": [0, 90, 0], "scale": [0.5, 0.9, 0.5],
      "asset": { "parts": [{ "shape": "box", "pos": [0, 0.45, 0], "size": [0.5, 0.9, 0.5] }], "surface": 0.45 } }
  },
  "regions": {
    "office": { "pos": [0, 0, 0], "scale": [6, 3, 5], "vertices": [[-3, -3], [3, -3], [3, 3], [-3, 3]] }
  },
  "variables": { "space": 1, "on": true, "at": [1, 2, 3] },
  "draws": { "lamp.pos/0": 0.5 }
}
"#;

fn open(text: &str) -> ReadLayout {
    read(text, FileId(0))
}

/// Code and marked text of every finding.
fn found(text: &str) -> Vec<(Code, &str)> {
    let range = |d: &scenelang_base::Diagnostic| d.primary.as_ref().unwrap().place.range.bytes();
    open(text).diagnostics.iter().map(|d| (d.code, &text[range(d)])).collect()
}

#[test]
fn a_good_file_is_read_whole() {
    let file = open(GOOD);
    assert!(file.usable && file.diagnostics.is_empty(), "{:?}", file.diagnostics);
    let l = &file.layout;
    assert_eq!((l.scene.as_deref(), l.seed), (Some("room.scene"), Some(7)));
    assert_eq!(l.object("lamp").unwrap().scale, Vec3::new(0.3, 1.5, 0.3));
    let chair = l.object("chair[0]").unwrap();
    assert_eq!((chair.surface, chair.parts.len()), (Some(0.45), 1));
    assert!(matches!(chair.parts[0], Part::Box { rot, .. } if rot == Vec3::zeros()));
    assert_eq!(l.region("office").unwrap().rot, Vec3::zeros());
    let values: Vec<DecisionValue> = l.variables.iter().map(|v| v.1).collect();
    assert_eq!(values, [DecisionValue::Number(1.0), DecisionValue::Bool(true), DecisionValue::Triple([1.0, 2.0, 3.0])]);
    assert_eq!(l.draws, [("lamp.pos/0".to_owned(), 0.5)]);
}

/// What is replaced in the good file, by what, and the findings then: code and marked text.
type Case = (&'static str, &'static str, &'static [(Code, &'static str)]);

#[test]
fn what_is_wrong_is_said_where_it_is() {
    let cases: &[Case] = &[
        // Not JSON.
        ("[1, 0, 1]", "[NaN, 0, 1]", &[(E0501, "NaN")]),
        ("[1, 0, 1]", "[1, -Infinity, 1]", &[(E0501, "-Infinity")]),
        ("[1, 0, 1]", "[1, 0, 1,]", &[(E0501, ",")]),
        ("[1, 0, 1]", "[1, 0 1]", &[(E0501, "1")]),
        ("[1, 0, 1]", "[01, .5, 1.]", &[(E0501, "01"), (E0501, ".5"), (E0501, "1.")]),
        ("[1, 0, 1]", "[+1, 1e, 0x1]", &[(E0501, "+1"), (E0501, "1e"), (E0501, "0x1")]),
        ("[1, 0, 1]", "[1, 0, 1e999]", &[(E0505, "1e999")]),
        ("[1, 0, 1]", "[1, 0, /* here */ 1]", &[(E0501, "/* here */")]),
        ("[1, 0, 1]", "[1, 0, 1", &[(E0501, "\"rot\"")]),
        ("[0, 0, 0], \"scale\": [0.3", "[0, 0, 0] \"scale\": [0.3", &[(E0501, "\"")]),
        ("\"seed\": 7", "'seed': 7", &[(E0501, "'seed'")]),
        ("\"seed\": 7", "seed: 7", &[(E0501, "seed")]),
        ("\"seed\": 7", "\"seed\" 7", &[(E0501, "7")]),
        ("\"seed\": 7", "\"seed\": ", &[(E0501, ",")]),
        ("0.5 }\n}", "0.5 },\n}", &[(E0501, ",")]),
        ("0.5 }\n}", "0.5 }\n} x", &[(E0501, "x")]),
        ("0.5 }\n}", "0.5 }\n", &[(E0501, "")]),
        ("room.scene", "room\tscene", &[(E0501, "\t")]),
        ("room.scene", "\\x41 \\ud800", &[(E0501, "\\x"), (E0501, "\\ud800")]),
        ("\"room.scene\"", "\"room.scene", &[(E0501, "\"room.scene,")]),
        // No layout.
        ("layout/1", "layout/2", &[(E0502, "\"scenelang.layout/2\"")]),
        ("\"format\": \"scenelang.layout/1\",", "", &[(E0502, "{")]),
        ("\"scenelang.layout/1\"", "1", &[(E0504, "1")]),
        // Members.
        ("\"room.scene\"", "5", &[(E0504, "5")]),
        ("\"seed\": 7", "\"seed\": \"7\"", &[(E0504, "\"7\"")]),
        ("\"seed\": 7", "\"seed\": -7", &[(E0505, "-7")]),
        ("\"seed\": 7", "\"seed\": 7.5", &[(E0505, "7.5")]),
        ("\"seed\": 7", "\"seed\": 18446744073709551616", &[(E0505, "18446744073709551616")]),
        ("\"seed\": 7", "\"seed\": 7, \"seed\": 8", &[(E0509, "\"seed\"")]),
        ("\"seed\": 7", "\"x\": {\"a\": 1, \"\\u0061\": 1}", &[(E0509, "\"\\u0061\"")]),
        ("[1, 0, 1]", "[1, 0, 1, 0]", &[(E0504, "[1, 0, 1, 0]")]),
        ("[1, 0, 1]", "[1, null, \"1\"]", &[(E0504, "null"), (E0504, "\"1\"")]),
        ("[1, 0, 1]", "[1, 0, 1000000.1]", &[(E0505, "1000000.1")]),
        ("[1, 0, 1]", "{\"x\": 1}", &[(E0504, "{\"x\": 1}")]),
        ("1.5, 0.3]", "-1.5, 0]", &[(E0505, "-1.5"), (E0505, "0")]),
        (", \"scale\": [0.3, 1.5, 0.3]", "", &[(E0503, "\"lamp\"")]),
        ("{ \"pos\": [1, 0, 1], \"rot\": [0, 0, 0], \"scale\": [0.3, 1.5, 0.3] }", "{}", &[(E0503, "\"lamp\"")]),
        ("{ \"pos\": [1, 0, 1], \"rot\": [0, 0, 0], \"scale\": [0.3, 1.5, 0.3] }", "7", &[(E0504, "7")]),
        ("{ \"lamp.pos/0\": 0.5 }", "[]", &[(E0504, "[]")]),
        ("0.5 }\n}", "true }\n}", &[(E0504, "true")]),
        // A variable of the wrong type is for those to tell who know the program.
        ("\"space\": 1", "\"space\": \"one\"", &[]),
        // Parts.
        ("\"shape\": \"box\"", "\"shape\": \"ball\"", &[(E0504, "\"ball\"")]),
        ("\"shape\": \"box\", ", "", &[(E0503, "{")]),
        ("\"shape\": \"box\"", "\"shape\": \"cylinder\"", &[(E0503, "{"), (E0503, "{")]),
        ("[0.5, 0.9, 0.5] }]", "[0.5, -0.9, 0.5] }]", &[(E0505, "-0.9")]),
        ("[0.5, 0.9, 0.5] }]", "[0.5, 0.902, 0.5] }]", &[]),
        ("[0.5, 0.9, 0.5] }]", "[0.5, 0.903, 0.5] }]", &[(W0501, "\"parts\"")]),
        ("\"surface\": 0.45", "\"surface\": {}", &[(E0504, "{}")]),
        (
            "{ \"shape\": \"box\", \"pos\": [0, 0.45, 0], \"size\": [0.5, 0.9, 0.5] }",
            "{\"shape\": \"hull\", \"points\": [[0,0,0],[1,0,0],[1,0,1],[0,0,1]]}",
            &[(E0505, "[[0,0,0],[1,0,0],[1,0,1],[0,0,1]]")],
        ),
        // Regions.
        ("[6, 3, 5]", "[6, 3, 5], \"rot\": [0, 45, 0.1]", &[]),
        ("[6, 3, 5]", "[6, 3, 5], \"rot\": [359.95, 45, -720]", &[]),
        ("[6, 3, 5]", "[6, 3, 5], \"rot\": [0, 45, 0.2]", &[(E0511, "[0, 45, 0.2]")]),
        ("[6, 3, 5]", "[6, 3, 5], \"rot\": [180, 45, 180]", &[(E0511, "[180, 45, 180]")]),
        ("[[-3, -3], [3, -3], [3, 3], [-3, 3]]", "[]", &[(E0508, "[]")]),
        ("[[-3, -3], [3, -3], [3, 3], [-3, 3]]", "[[1, 1], [2, 2]]", &[(E0508, "[[1, 1], [2, 2]]")]),
        ("[3, -3], [3, 3]", "[3, 3], [3, -3]", &[(E0508, "[[-3, -3], [3, 3], [3, -3], [-3, 3]]")]),
        ("[3, -3], [3, 3]", "{\"x\": 1}, {\"x\": 2}", &[(E0504, "{\"x\": 1}")]),
        ("[3, -3], [3, 3]", "[3, -3, 0], [3, 3]", &[(E0504, "[3, -3, 0]")]),
        ("[3, -3], [3, 3]", "[3, -3e6], [3, 3]", &[(E0505, "-3e6")]),
        ("[-3, 3]]", "[-3, 3], [-3, -3]]", &[]),
        ("[0, 0, 0], \"scale\": [6, 3, 5]", "[0, 0, 0]", &[(E0503, "\"office\"")]),
    ];
    for (old, new, expected) in cases {
        assert_eq!(GOOD.matches(old).count(), 1, "{old}");
        let text = GOOD.replace(old, new);
        let got = found(&text);
        let fits = got.len() == expected.len()
            && got
                .iter()
                .zip(*expected)
                .all(|(g, e)| g.0 == e.0 && (g.1 == e.1 || e.1.is_empty() == g.1.is_empty() && g.1.starts_with(e.1)));
        assert!(fits, "{new}: {:#?}", open(&text).diagnostics);
    }
}

#[test]
fn an_error_in_one_object_leaves_the_others() {
    let text = GOOD.replace("[1, 0, 1]", "[1, 0]").replace("[6, 3, 5]", "[6, 3, 0]");
    let file = open(&text);
    assert!(file.usable);
    assert!(file.layout.object("lamp").is_none() && file.layout.region("office").is_none());
    assert!(file.layout.object("chair[0]").is_some());
    assert!(file.places.objects.get("lamp").is_some(), "it is there, only not readable");
}

#[test]
fn what_breaks_off_or_is_something_else_is_not_judged() {
    let cases = [
        "",
        " \n",
        "[1]",
        "7",
        "{",
        "{\"a\": {",
        "{}",
        "{\"format\": \"x\", \"objects\": {}}",
        "\u{feff}",
        "NaN",
        "\0",
    ];
    for text in cases {
        let file = open(text);
        assert!(!file.usable && file.diagnostics.len() == 1, "{text:?}: {:?}", file.diagnostics);
    }
    assert!(open(&format!("\u{feff}{GOOD}")).diagnostics.is_empty());
}

#[test]
fn other_spellings_of_the_same() {
    let text = GOOD
        .replace("[1, 0, 1]", "[-0, 0e5, 10.0E-1]")
        .replace("\"lamp\"", "\"\\u006camp\"")
        .replace("\"seed\": 7", "\"seed\": 7e0")
        .replace("room.scene", "\\ud83d\\ude00\\/\\n\\\"");
    let file = open(&text);
    assert!(file.diagnostics.is_empty(), "{:?}", file.diagnostics);
    assert_eq!(file.layout.object("lamp").unwrap().pos, Vec3::new(0.0, 0.0, 1.0));
    assert_eq!(file.layout.seed, Some(7));
    assert_eq!(file.layout.scene.as_deref(), Some("😀/\n\""));
    let large = open(&GOOD.replace("\"seed\": 7", "\"seed\": 18446744073709551615"));
    assert_eq!(large.layout.seed, Some(u64::MAX));
}

#[test]
fn places_of_everything() {
    let file = open(GOOD);
    let slice = |s: scenelang_base::Span| &GOOD[s.range.bytes()];
    let p = &file.places;
    assert_eq!(slice(p.objects.get("lamp").unwrap().place.key), "\"lamp\"");
    assert_eq!(slice(p.objects.get("lamp").unwrap().member("pos").unwrap().value), "[1, 0, 1]");
    assert_eq!(slice(p.regions.get("office").unwrap().member("scale").unwrap().key), "\"scale\"");
    assert_eq!(slice(p.variables.get("at").unwrap().place.value), "[1, 2, 3]");
    assert_eq!(slice(p.draws.get("lamp.pos/0").unwrap().place.value), "0.5");
    assert_eq!(slice(p.block("objects")), "\"objects\"");
    assert_eq!(slice(p.block("nothing")), "{");
    assert_eq!(slice(p.document), GOOD.trim_end());
    assert_eq!(p.objects.iter().map(|e| e.name.as_str()).collect::<Vec<_>>(), ["lamp", "chair[0]"]);
    assert!(p.objects.get("office").is_none() && p.objects.get("lamp").unwrap().member("asset").is_none());
}

#[test]
fn hostile_files_end_in_one_error() {
    let deep = "[".repeat(1_000_000);
    assert_eq!(open(&deep).diagnostics[0].code, E0004);
    let deep = "{\"a\":".repeat(1_000_000);
    assert_eq!(open(&deep).diagnostics[0].code, E0004);
    let long = GOOD.replace("\"seed\": 7", &format!("\"note\": \"{}\"", "x".repeat(10_000_000)));
    assert!(open(&long).diagnostics.is_empty());
    let many = format!("[{}]", "01,".repeat(1_000_000));
    assert_eq!(open(&many).diagnostics.len(), 100);
    let digits = GOOD.replace("[1, 0, 1]", &format!("[{}, 0, 1]", "9".repeat(100_000)));
    let digits = open(&digits).diagnostics;
    assert!(digits.len() == 1 && digits[0].message.len() < 100, "{digits:?}");
}

#[test]
fn only_utf8_is_text() {
    assert_eq!(decode(GOOD.as_bytes().to_vec()).unwrap(), GOOD);
    assert_eq!(decode(b"\xef\xbb\xbf{}".to_vec()).unwrap(), "\u{feff}{}");
    for bytes in [&b"\xff\xfe{\0}\0"[..], b"\xfe\xff\0{\0}", b"{\n\x80}", b"\xed\xa0\x80"] {
        assert_eq!(decode(bytes.to_vec()).unwrap_err().code, E0003);
    }
    assert!(decode(b"{\n\x80}".to_vec()).unwrap_err().message.contains("byte 80 on line 2"));
}

#[test]
fn every_prefix_is_an_error() {
    for end in (0..GOOD.trim_end().len()).filter(|&i| GOOD.is_char_boundary(i)) {
        let file = open(&GOOD[..end]);
        // Where a number or word is cut off, that too.
        assert!(!file.usable && (1..=2).contains(&file.diagnostics.len()), "{end}: {:?}", file.diagnostics);
    }
}

#[test]
fn fixes_repair() {
    let broken = GOOD
        .replace("[1, 0, 1]", "[1, 0 1,]")
        .replace("\"seed\": 7", "seed: 7 // lucky")
        .replace("\"room.scene\"", "'room\"scene'")
        .replace("[6, 3, 5]", "[6,, 3, 5]");
    let mut edits: Vec<_> =
        open(&broken).diagnostics.iter().flat_map(|d| d.fixes.clone()).flat_map(|f| f.edits).collect();
    // The comment swallows a comma: one edit more than slips.
    assert_eq!(edits.len(), 7);
    edits.sort_by_key(|e| std::cmp::Reverse(e.place.range.start));
    let mut repaired = broken;
    for e in edits {
        repaired.replace_range(e.place.range.bytes(), &e.text);
    }
    let file = open(&repaired);
    assert!(file.diagnostics.is_empty(), "{repaired}");
    assert_eq!(file.layout.scene.as_deref(), Some("room\"scene"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn json_is_what_others_take_for_json(
        edits in prop::collection::vec((0usize..GOOD.len(), 0usize..3, prop::sample::select(
            vec!["", "{", "}", "[", "]", ",", ":", "\"", "\\", "0", "-", ".", "e", " ", "\n", "\t", "\u{1}", "é", "\\u12", "null", "tru", "'", "/", "1e5"],
        )), 1..4),
    ) {
        let mut text = GOOD.to_owned();
        for (at, cut, new) in edits {
            let at = at.min(text.len() - 1);
            let end = (at + cut).min(text.len());
            if text.is_char_boundary(at) && text.is_char_boundary(end) {
                text.replace_range(at..end, new);
            }
        }
        let bad = |c: Code| c == E0501 || c == E0004;
        let ours = found(&text).iter().any(|(c, t)| bad(*c) || *c == E0505 && t.parse::<f64>().is_ok_and(f64::is_infinite));
        let theirs = serde_json::from_str::<serde_json::Value>(&text).is_err();
        prop_assert_eq!(ours, theirs, "{}", text);
    }

    #[test]
    fn strings_and_numbers_mean_what_others_take_them_for(scene in ".*", x in -1e6..1e6f64) {
        let value = serde_json::json!({ "format": "scenelang.layout/1", "scene": scene, "draws": { scene.as_str(): x } });
        let file = open(&value.to_string()).layout;
        prop_assert_eq!(file.scene, Some(scene.clone()));
        prop_assert_eq!(file.draws, vec![(scene, x)]);
    }
}

/// An asset with a door, of which one member is replaced.
fn with_joint(old: &str, new: &str) -> String {
    let joint = r#""joints": [{ "name": "door", "motion": "hinge", "parts": [0], "axis": [0, 1, 0], "anchor": [0.25, 0, 0],
        "limits": [0, 110], "useful": 90 }], "surface""#;
    assert!(old.is_empty() || joint.matches(old).count() == 1, "{old}");
    GOOD.replace("\"surface\"", &joint.replace(old, new))
}

#[test]
fn a_malformed_joint_is_one_error_at_its_place() {
    let good = with_joint("110", "110");
    assert!(found(&good).is_empty(), "{:?}", found(&good));
    let cases: &[Case] = &[
        ("\"name\": \"door\", ", "", &[(E0503, "{")]),
        ("\"name\": \"door\"", "\"name\": \" \"", &[(E0505, "\" \"")]),
        ("\"hinge\"", "\"swing\"", &[(E0504, "\"swing\"")]),
        ("\"hinge\"", "1", &[(E0504, "1")]),
        ("[0], ", "[1], ", &[(E0505, "1")]),
        ("[0], ", "[-1], ", &[(E0505, "-1")]),
        ("[0], ", "[0.5], ", &[(E0505, "0.5")]),
        ("[0], ", "[0, 0], ", &[(E0505, "0")]),
        ("[0], ", "[], ", &[(E0505, "[]")]),
        ("[0], ", "0, ", &[(E0504, "0")]),
        ("[0, 1, 0]", "[0, 0, 0]", &[(E0505, "[0, 0, 0]")]),
        ("[0, 1, 0]", "[0, 1]", &[(E0504, "[0, 1]")]),
        ("[0, 1, 0]", "[0, NaN, 0]", &[(E0501, "NaN")]),
        (", \"anchor\": [0.25, 0, 0]", "", &[(E0503, "{")]),
        ("[0, 110]", "[110, 0]", &[(E0505, "[110, 0]")]),
        ("[0, 110]", "[0, 0]", &[(E0505, "[0, 0]")]),
        ("[0, 110]", "110", &[(E0504, "110")]),
        ("\"useful\": 90", "\"useful\": 111", &[(E0505, "111")]),
        ("\"useful\": 90", "\"useful\": 0", &[(E0505, "0")]),
        ("\"useful\": 90", "\"handle\": 0", &[(E0504, "0")]),
        ("\"useful\": 90 }]", "\"useful\": 90 }, 7]", &[(E0504, "7")]),
    ];
    for (old, new, expected) in cases {
        let text = with_joint(old, new);
        let got = found(&text);
        assert!(
            got.len() == expected.len() && got.iter().zip(*expected).all(|(g, e)| g.0 == e.0 && g.1.starts_with(e.1)),
            "{new}: {:#?}",
            open(&text).diagnostics
        );
    }
}
