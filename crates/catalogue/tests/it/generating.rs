//! Programs that make models: what they get, what becomes of what they make, and all the ways in which they fail.
#![cfg(unix)]

use crate::made::{block, usual};
use scenelang_catalogue::generator::{Bounds, Command, Generator};
use scenelang_catalogue::{AssetProvider, Query, Reply, Why};
use scenelang_layout::Vec3;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use tempfile::tempdir;

pub fn query(category: &str, size: [f64; 3]) -> Query {
    let text = |s: &str| s.to_owned();
    Query {
        name: text("it"),
        what: text(category),
        category: text(category),
        color: text("red"),
        size: Some(Vec3::from(size)),
        usual: usual(category),
        ..Query::default()
    }
}

pub fn bounds(kept: &Path, most: usize) -> Bounds {
    Bounds { timeout: Duration::from_secs(30), most, kept: Some(kept.to_owned()), stop: || false }
}

/// A program of a line of shell; `$1` is a folder of the test.
fn shell(script: &str, folder: &Path, bounds: Bounds) -> Generator {
    let argv = ["sh", "-c", script, "sh", folder.to_str().unwrap()].map(str::to_owned);
    Generator::new(Box::new(Command::new(&argv).unwrap()), bounds)
}

pub fn ask(generator: &Generator, queries: &[Query]) -> Vec<Reply> {
    generator.provide(&queries.iter().collect::<Vec<_>>(), &mut |_| {})
}

/// What was said against the only answer.
fn refused(mut replies: Vec<Reply>) -> (Why, String) {
    assert!(replies[0].given.is_none(), "{replies:?}");
    let remark = replies.remove(0).remarks.remove(0);
    (remark.why, remark.say)
}

#[test]
fn a_program_gets_the_order_and_what_it_makes_is_kept() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("made.glb"), block(1.0, 2.0, 1.0).glb()).unwrap();
    let script = "cat >> $1/asked; cat $1/made.glb; echo 50 % >&2";
    let kept = folder.path().join("kept");
    let generator = shell(script, folder.path(), bounds(&kept, 9));
    let chair = query("chair", [0.5, 0.9, 0.5]);
    let replies = ask(&generator, &[chair.clone(), chair.clone()]);
    for reply in &replies {
        let given = reply.given.as_ref().unwrap_or_else(|| panic!("{reply:?}"));
        assert_eq!((given.piece.size, given.source.as_str()), (Vec3::new(0.5, 0.9, 0.5), "red chair"));
    }
    // Equal orders are one order, and it is a line of JSON.
    let asked = fs::read_to_string(folder.path().join("asked")).unwrap();
    let order: Value = serde_json::from_str(asked.trim()).unwrap();
    assert_eq!((order["prompt"].as_str(), order["size"][1].as_f64()), (Some("red chair"), Some(0.9)));
    // The next time it is there already; for another size it is not.
    assert!(ask(&shell(script, folder.path(), bounds(&kept, 0)), &[chair])[0].given.is_some());
    let larger = query("chair", [0.6, 0.9, 0.5]);
    let (why, say) = refused(ask(&shell(script, folder.path(), bounds(&kept, 0)), &[larger]));
    assert_eq!((why, say.as_str()), (Why::Budget, "no models may be made in this run"));
}

#[test]
fn a_program_may_write_to_the_path_in_the_order() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("made.glb"), block(1.0, 2.0, 1.0).glb()).unwrap();
    let script = "out=$(sed 's/.*\"out\":\"\\([^\"]*\\)\".*/\\1/'); cp $1/made.glb \"$out\"";
    let generator = shell(script, folder.path(), bounds(&folder.path().join("kept"), 1));
    let reply = &ask(&generator, &[query("chair", [0.5, 0.9, 0.5])])[0];
    assert!(reply.given.is_some(), "{reply:?}");
}

#[test]
fn each_way_to_fail_is_one_remark() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("short.glb"), &block(1.0, 2.0, 1.0).glb()[..50]).unwrap();
    fs::write(folder.path().join("flat.glb"), block(1.0, 0.001, 1.0).glb()).unwrap();
    for (script, why, say) in [
        ("echo no graphics card >&2; exit 3", Why::Failed, "it ended with exit status: 3: no graphics card"),
        ("true", Why::Failed, "it produced no model"),
        ("echo hello", Why::Broken, "it is not a GLB file"),
        ("cat $1/short.glb", Why::Broken, "it is truncated"),
        ("cat $1/flat.glb", Why::Size, "it would be stretched"),
        ("head -c 70000000 /dev/zero", Why::Broken, "it is larger than 64 MB"),
    ] {
        let generator = shell(script, folder.path(), bounds(&folder.path().join("kept"), 9));
        let got = refused(ask(&generator, &[query("chair", [0.5, 0.9, 0.5])]));
        assert!(got.0 == why && got.1.contains(say), "{script}: {got:?}");
    }
    let missing = Command::new(&["/no/such/program".to_owned()]).unwrap();
    let generator = Generator::new(Box::new(missing), bounds(folder.path(), 9));
    let (why, say) = refused(ask(&generator, &[query("chair", [0.5, 0.9, 0.5])]));
    assert!(why == Why::Failed && say.contains("/no/such/program cannot be started"), "{say}");
    assert!(Command::new(&[]).is_none() && Command::new(&[" ".to_owned()]).is_none());
}

#[test]
fn who_takes_too_long_is_ended_and_so_is_everything_when_somebody_says_so() {
    static STOP: AtomicBool = AtomicBool::new(false);
    let folder = tempdir().unwrap();
    let slow = "sleep 60 & echo $! > $1/child; wait";
    let short = Bounds { timeout: Duration::from_millis(300), ..bounds(folder.path(), 9) };
    let (why, say) = refused(ask(&shell(slow, folder.path(), short), &[query("chair", [0.5, 0.9, 0.5])]));
    assert_eq!((why, say.as_str()), (Why::Failed, "it took too long"));
    // What it had started is gone, too.
    let child = fs::read_to_string(folder.path().join("child")).unwrap();
    let state = || fs::read_to_string(format!("/proc/{}/stat", child.trim())).unwrap_or_default();
    if cfg!(target_os = "linux") {
        let gone = (0..100).any(|_| {
            let gone = state().is_empty() || state().contains(") Z");
            std::thread::sleep(Duration::from_millis(if gone { 0 } else { 20 }));
            gone
        });
        assert!(gone, "{}", state());
    }
    STOP.store(true, Ordering::SeqCst);
    let asked = Bounds { stop: || STOP.load(Ordering::SeqCst), ..bounds(folder.path(), 9) };
    let (_, say) = refused(ask(&shell(slow, folder.path(), asked), &[query("chair", [0.5, 0.9, 0.5])]));
    assert_eq!(say, "it was interrupted");
}

#[test]
fn what_is_kept_is_noticed_to_be_damaged_and_made_again() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("made.glb"), block(1.0, 2.0, 1.0).glb()).unwrap();
    let script = "echo x >> $1/asked; cat $1/made.glb";
    let (kept, chair) = (folder.path().join("kept"), query("chair", [0.5, 0.9, 0.5]));
    let asked = || fs::read_to_string(folder.path().join("asked")).unwrap().lines().count();
    let again = || {
        let reply = ask(&shell(script, folder.path(), bounds(&kept, 9)), std::slice::from_ref(&chair)).remove(0);
        assert!(reply.given.is_some(), "{reply:?}");
        asked()
    };
    let file = || {
        let inner = fs::read_dir(&kept).unwrap().next().unwrap().unwrap().path();
        fs::read_dir(inner).unwrap().next().unwrap().unwrap().path()
    };
    assert_eq!((again(), again()), (1, 1));
    let good = fs::read(file()).unwrap();
    // A bit of a coordinate, the end, the sum, everything: none of it is taken for the model.
    let mut bit = good.clone();
    let last = bit.len() - 160;
    bit[last] ^= 1;
    let mut sum = good.clone();
    sum[0] ^= 1;
    let damages = [bit, good[..good.len() - 1].to_vec(), sum, Vec::new()];
    for (i, damaged) in damages.into_iter().enumerate() {
        fs::write(file(), damaged).unwrap();
        assert_eq!(again(), i + 2, "it is made again");
        assert_eq!(fs::read(file()).unwrap(), good, "and kept as it was");
        assert_eq!(again(), i + 2);
    }
    // Nowhere, nothing is kept.
    let nowhere = || Bounds { kept: None, ..bounds(&kept, 9) };
    for _ in 0..2 {
        assert!(ask(&shell(script, folder.path(), nowhere()), std::slice::from_ref(&chair))[0].given.is_some());
    }
    assert_eq!(asked(), 7);
}

#[test]
fn the_budget_is_for_the_first_ones() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("made.glb"), block(1.0, 2.0, 1.0).glb()).unwrap();
    let generator = shell("cat $1/made.glb", folder.path(), bounds(&folder.path().join("kept"), 2));
    let queries: Vec<Query> = (0..4).map(|i| query("chair", [0.5, 0.9 + 0.01 * f64::from(i), 0.5])).collect();
    let got: Vec<bool> = ask(&generator, &queries).iter().map(|reply| reply.given.is_some()).collect();
    assert_eq!(got, [true, true, false, false]);
    // Who starts again goes on where it was.
    let got: Vec<bool> = ask(&generator, &queries).iter().map(|reply| reply.given.is_some()).collect();
    assert_eq!(got, [true; 4]);
}
