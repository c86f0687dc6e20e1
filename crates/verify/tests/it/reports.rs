//! Reports in their formats: what people read, SARIF, JUnit, and JSON that comes back as it went.

use crate::given::{judged, layout};
use scenelang_verify::report::{Human, compact, github, human, json, junit, model::Report, sarif};
use scenelang_verify::{Checked, Options};
use serde_json::Value;

const SCENE: &str = "\
object bed;
object nightstand;
@req(\"the lamp is <above> the table\")
assert nightstand.pos.x > 2.5;
assert not collides(bed, nightstand);
prefer nightstand.rot.y = 90 weight 2;
bed.pos <- vec3(1, 0, 2);
";

const LAYOUT: &str = "object bed 1 0 2 | 2 0.55 1.6
object nightstand 2.13 0 2 | 0.4 0.5 0.4";

fn bedroom() -> Checked {
    judged(SCENE, &layout(LAYOUT), &Options::default())
}

#[test]
fn people_read_both_sides_and_the_measured_values() {
    insta::assert_snapshot!(human(&bedroom(), Human::default()), @r##"
    [V0101] Error: `nightstand.pos.x` is 2.13, but must be more than 2.5
       ╭─[ room.scene:4:1 ]
       │
     2 │ object nightstand;
       │        ─────┬────
       │             ╰────── `nightstand` is at (2.13, 0.00, 2.00), faces north (+z), 0.40 × 0.50 × 0.40 m
       │
     4 │ assert nightstand.pos.x > 2.5;
       │ ──────────────┬──────────────
       │               ╰──────────────── fails in room.layout.json: margin -0.37 m
       │
       │ Help: move `nightstand` 0.38 m east; the move causes no new violations and also satisfies `not collides(bed, nightstand)` (line 5) and P-COLLIDE for `bed` and `nightstand`
       │
       │ Note: required by "the lamp is <above> the table"
    ───╯
    [V0102] Error: `bed` overlaps `nightstand` by 0.07 m
       ╭─[ room.scene:5:1 ]
       │
     1 │ object bed;
       │        ─┬─
       │         ╰─── `bed` is at (1.00, 0.00, 2.00), faces north (+z), 2.00 × 0.55 × 1.60 m
     2 │ object nightstand;
       │        ─────┬────
       │             ╰────── `nightstand` is at (2.13, 0.00, 2.00), faces north (+z), 0.40 × 0.50 × 0.40 m
       │
     5 │ assert not collides(bed, nightstand);
       │ ──────────────────┬─────────────────
       │                   ╰─────────────────── fails in room.layout.json: margin -0.069 m
       │
       │ Help: move `nightstand` 0.38 m east; the move causes no new violations and also satisfies `nightstand.pos.x > 2.5` (line 4) and P-COLLIDE for `bed` and `nightstand`
       │
       │ Note: the physical rule P-COLLIDE also forbids this overlap
    ───╯
    [V0106] Advice: `nightstand.rot.y` is 0°, but must be equal to 90°
       ╭─[ room.scene:6:1 ]
       │
     2 │ object nightstand;
       │        ─────┬────
       │             ╰────── `nightstand` is at (2.13, 0.00, 2.00), faces north (+z), 0.40 × 0.50 × 0.40 m
       │
     6 │ prefer nightstand.rot.y = 90 weight 2;
       │ ──────────────────┬──────────────────
       │                   ╰──────────────────── not met in room.layout.json: margin -89.9°
       │
       │ Help: turn `nightstand` by 90° clockwise; the move causes no new violations
    ───╯
    room.layout.json: 0 of 2 assertions, 1 of 1 assignments, 0 of 1 preferences, 2 of 3 physical rules hold
    "##);
}

#[test]
fn what_people_read_has_colours_only_if_asked() {
    let color = human(&bedroom(), Human { color: true, all: false });
    assert!(color.contains("\u{1b}["));
    assert!(!human(&bedroom(), Human::default()).contains('\u{1b}'));
}

#[test]
fn a_finding_in_a_very_long_line_is_named_not_shown() {
    let scene = format!("object a; assert {} 1 > ;\n", "1 + ".repeat(5000));
    let text = human(&judged(&scene, &layout("object a 0 0 0"), &Options::default()), Human::default());
    assert!(text.len() < 1500 && text.contains("room.scene:1:"), "{text}");
}

#[test]
fn json_comes_back_as_it_went() {
    let report = bedroom().report;
    let line = json(&report);
    assert!(!line.contains('\n'));
    assert_eq!(serde_json::from_str::<Report>(&line).unwrap(), report);
    let keys: Vec<String> =
        serde_json::from_str::<serde_json::Map<String, Value>>(&line).unwrap().keys().cloned().collect();
    assert_eq!(keys, ["format", "file", "ok", "summary", "constraints", "diagnostics", "tolerances", "eta"]);
}

fn line(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("made of strings and numbers")
}

#[test]
fn rows_say_what_they_should() {
    let report = bedroom().report;
    insta::assert_snapshot!(line(&report.constraints[0]), @r##"{"id":"room.scene:4:1","kind":"assert","rule":null,"code":"V0101","satisfied":false,"margin":-0.3700000000000001,"unit":"m","objects":["nightstand"],"text":"nightstand.pos.x > 2.5","message":"`nightstand.pos.x` is 2.13, but must be more than 2.5; `nightstand` is at (2.13, 0.00, 2.00), faces north (+z), 0.40 × 0.50 × 0.40 m","span":{"file":"room.scene","start":[4,1],"end":[4,30]},"requirements":["the lamp is <above> the table"],"explanation":{"measured":{"left":2.13,"right":2.5,"unit":"m"},"objects":[{"name":"nightstand","pos":[2.13,0.0,2.0],"rot":[0.0,0.0,0.0],"size":[0.4,0.5,0.4],"text":"`nightstand` is at (2.13, 0.00, 2.00), faces north (+z), 0.40 × 0.50 × 0.40 m"}],"move":{"object":"nightstand","by":[0.38,0.0,0.0],"turn":0.0,"breaks":[],"repairs":["room.scene:5:1","P-COLLIDE:bed:nightstand"],"text":"move `nightstand` 0.38 m east"},"choices":[{"object":"nightstand","by":[0.38,0.0,0.0],"turn":0.0,"breaks":[],"repairs":["room.scene:5:1","P-COLLIDE:bed:nightstand"],"text":"move `nightstand` 0.38 m east"}]}}"##);
    insta::assert_snapshot!(line(&report.constraints[3]), @r##"{"id":"room.scene:7:1","kind":"pin","rule":null,"code":null,"satisfied":true,"margin":0.001,"unit":"m","objects":["bed"],"text":"bed.pos <- vec3(1, 0, 2)","message":"`bed.pos` is (1, 0, 2), equal to (1, 0, 2)","span":{"file":"room.scene","start":[7,1],"end":[7,25]}}"##);
    insta::assert_snapshot!(line(&report.constraints[4]), @r##"{"id":"P-COLLIDE:bed:nightstand","kind":"collision","rule":"P-COLLIDE","code":"V0102","satisfied":false,"margin":-0.06900000000000012,"unit":"m","objects":["bed","nightstand"],"text":"`bed` and `nightstand` do not collide","message":"`bed` overlaps `nightstand` by 0.07 m; `bed` is at (1.00, 0.00, 2.00), faces north (+z), 2.00 × 0.55 × 1.60 m; `nightstand` is at (2.13, 0.00, 2.00), faces north (+z), 0.40 × 0.50 × 0.40 m","span":{"file":"room.scene","start":[1,8],"end":[1,11]},"explanation":{"measured":{"left":-0.07000000000000012,"right":-0.001,"unit":"m"},"objects":[{"name":"bed","pos":[1.0,0.0,2.0],"rot":[0.0,0.0,0.0],"size":[2.0,0.55,1.6],"text":"`bed` is at (1.00, 0.00, 2.00), faces north (+z), 2.00 × 0.55 × 1.60 m"},{"name":"nightstand","pos":[2.13,0.0,2.0],"rot":[0.0,0.0,0.0],"size":[0.4,0.5,0.4],"text":"`nightstand` is at (2.13, 0.00, 2.00), faces north (+z), 0.40 × 0.50 × 0.40 m"}],"move":{"object":"nightstand","by":[0.38,0.0,0.0],"turn":0.0,"breaks":[],"repairs":["room.scene:4:1","room.scene:5:1"],"text":"move `nightstand` 0.38 m east"},"choices":[{"object":"nightstand","by":[0.38,0.0,0.0],"turn":0.0,"breaks":[],"repairs":["room.scene:4:1","room.scene:5:1"],"text":"move `nightstand` 0.38 m east"}]}}"##);
    insta::assert_snapshot!(line(&report.summary), @r##"{"assertions":{"total":2,"satisfied":0},"preferences":{"total":1,"satisfied":0},"physical":{"total":3,"satisfied":2},"pins":{"total":1,"satisfied":1}}"##);
}

#[test]
fn sarif_has_a_result_per_violation_and_diagnostic() {
    let log: Value = serde_json::from_str(&sarif(&[bedroom()])).unwrap();
    let results = log["runs"][0]["results"].as_array().unwrap();
    let ids: Vec<&str> = results.iter().map(|r| r["ruleId"].as_str().unwrap()).collect();
    assert_eq!(ids, ["V0101", "V0102", "V0106", "V0102"]);
    assert_eq!(results[0]["locations"][0]["physicalLocation"]["region"]["startLine"], 4);
    assert_eq!(results[2]["level"], "note");
    let broken = judged("object a", &layout("object a 0 0 0"), &Options::default());
    let log: Value = serde_json::from_str(&sarif(&[broken])).unwrap();
    assert_eq!(log["runs"][0]["results"].as_array().unwrap().len(), 2);
}

#[test]
fn junit_escapes_and_counts() {
    let text = junit(&[bedroom().report]);
    assert_eq!(text.matches("<failure ").count(), 3);
    assert_eq!(text.matches("<skipped ").count(), 1);
    assert!(text.contains("failures=\"3\"") && text.contains("tests=\"5\""), "{text}");
    assert!(text.contains("nightstand.pos.x &gt; 2.5") && !text.contains("<above>"), "{text}");
}

#[test]
fn sarif_says_what_a_rule_means_what_belongs_to_it_and_what_repairs_it() {
    let log: Value = serde_json::from_str(&sarif(&[bedroom()])).unwrap();
    let run = &log["runs"][0];
    let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
    assert_eq!(rules.iter().map(|r| r["id"].as_str().unwrap()).collect::<Vec<_>>(), ["V0101", "V0102", "V0106"]);
    let help = "https://github.com/scenelang/scenelang/blob/main/spec/src/codes/V0102.md";
    assert_eq!(
        (&rules[1]["shortDescription"]["text"], &rules[1]["helpUri"]),
        (&"two objects collide".into(), &help.into())
    );
    for result in run["results"].as_array().unwrap() {
        assert_eq!(rules[result["ruleIndex"].as_u64().unwrap() as usize]["id"], result["ruleId"]);
    }
    let related = run["results"][1]["relatedLocations"].as_array().unwrap();
    let lines: Vec<_> = related.iter().map(|r| r["physicalLocation"]["region"]["startLine"].as_u64()).collect();
    assert_eq!(lines, [Some(1), Some(2)]);

    let broken = judged("object a", &layout("object a 0 0 0"), &Options::default());
    let log: Value = serde_json::from_str(&sarif(&[broken])).unwrap();
    let fixed: Vec<&Value> =
        log["runs"][0]["results"].as_array().unwrap().iter().filter(|r| !r["fixes"].is_null()).collect();
    insta::assert_snapshot!(line(&fixed[0]["fixes"]), @r##"[{"description":{"text":"insert `;`"},"artifactChanges":[{"artifactLocation":{"uri":"room.scene"},"replacements":[{"deletedRegion":{"startLine":1,"startColumn":9,"endLine":1,"endColumn":9},"insertedContent":{"text":";"}}]}],"properties":{"applicability":"safe"}}]"##);
}

#[test]
fn a_compact_report_has_a_line_for_each_finding() {
    let report = bedroom().report;
    insta::assert_snapshot!(compact(&report, Human::default()), @r##"
    room.scene:4:1: error[V0101]: nightstand.pos.x > 2.5 fails: `nightstand.pos.x` is 2.13, but must be more than 2.5 (margin -0.370 m)
    room.scene:5:1: error[V0102]: not collides(bed, nightstand) fails: `bed` overlaps `nightstand` by 0.07 m (margin -0.069 m)
    room.scene:6:1: advice[V0106]: nightstand.rot.y = 90 weight 2 is not met: `nightstand.rot.y` is 0°, but must be equal to 90° (margin -89.9°)
    room.scene:1:8: error[V0102]: `bed` overlaps `nightstand` by 0.07 m (margin -0.069 m)
    room.layout.json: 0 of 2 assertions, 1 of 1 assignments, 0 of 1 preferences, 2 of 3 physical rules hold
    "##);
    let color = compact(&report, Human { color: true, all: true });
    assert!(
        color.contains("\u{1b}[31merror[V0101]\u{1b}[0m") && color.contains("bed.pos <- vec3(1, 0, 2) holds"),
        "{color}"
    );
    let broken = judged("object a", &layout("object a 0 0 0"), &Options::default()).report;
    insta::assert_snapshot!(compact(&broken, Human::default()), @r##"
    room.layout.json:1:40: error[E0510]: the program room.scene has errors
    room.scene:1:9: error[E0111]: missing `;` at the end of this statement
    room.layout.json: 2 errors
    "##);
}

#[test]
fn annotations_are_escaped_as_the_runner_undoes_it() {
    let mut report = bedroom().report;
    insta::assert_snapshot!(github(&[report.clone()]), @r##"
    ::error file=room.scene,line=4,endLine=4,col=1,endColumn=29,title=V0101::nightstand.pos.x > 2.5 fails: `nightstand.pos.x` is 2.13, but must be more than 2.5 (margin -0.370 m)
    ::error file=room.scene,line=5,endLine=5,col=1,endColumn=36,title=V0102::not collides(bed, nightstand) fails: `bed` overlaps `nightstand` by 0.07 m (margin -0.069 m)
    ::notice file=room.scene,line=6,endLine=6,col=1,endColumn=37,title=V0106::nightstand.rot.y = 90 weight 2 is not met: `nightstand.rot.y` is 0°, but must be equal to 90° (margin -89.9°)
    ::error file=room.scene,line=1,endLine=1,col=8,endColumn=10,title=V0102::`bed` overlaps `nightstand` by 0.07 m (margin -0.069 m)
    "##);
    report.constraints.truncate(1);
    report.constraints[0].message = "100 %\r\nand: more, too".into();
    let span = report.constraints[0].span.as_mut().unwrap();
    (span.file, span.end) = ("a:b,c%.scene".into(), [5, 2]);
    insta::assert_snapshot!(github(&[report]), @r##"::error file=a%3Ab%2Cc%25.scene,line=4,endLine=5,title=V0101::nightstand.pos.x > 2.5 fails: 100 %25  and: more, too (margin -0.370 m)"##);
}
