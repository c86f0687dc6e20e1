//! A disk that does not answer, as one behind a network that is gone: what is asked about other programs is answered.

use crate::client::{Client, at, room, usual};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// Mounts a file system that nobody serves: every look at a file in it waits, until this ends.
const MOUNT: &str = "
import ctypes, os, sys
fd = os.open('/dev/fuse', os.O_RDWR)
options = f'fd={fd},rootmode=40000,user_id=0,group_id=0'.encode()
if ctypes.CDLL(None).mount(b'hanging', sys.argv[1].encode(), b'fuse', 0, options):
    sys.exit(1)
print('mounted', flush=True)
sys.stdin.read()
";

/// A folder that hangs until it is dropped.
struct Hanging {
    mount: Child,
    path: PathBuf,
}

impl Hanging {
    /// `None`: this machine does not let us make one.
    fn new(path: &Path) -> Option<Self> {
        fs::create_dir(path).unwrap();
        let mut command = Command::new("python3");
        command.args(["-c", MOUNT]).arg(path).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut mount = command.spawn().ok()?;
        let mut said = [0; 7];
        let mounted = std::io::Read::read_exact(mount.stdout.as_mut().unwrap(), &mut said).is_ok();
        if !mounted {
            mount.wait().unwrap();
            return None;
        }
        Some(Self { mount, path: path.to_owned() })
    }
}

impl Drop for Hanging {
    fn drop(&mut self) {
        // Whoever waits is told that the file system is gone.
        let _ = self.mount.kill();
        let _ = self.mount.wait();
        let _ = Command::new("umount").arg("-l").arg(&self.path).status();
    }
}

fn hover(client: &mut Client, uri: &str, text: &str, place: &str) -> Value {
    let params = json!({ "textDocument": { "uri": uri }, "position": at(text, place) });
    client.ask("textDocument/hover", params)["contents"]["value"].clone()
}

fn others_are_answered(capabilities: Value) {
    let (folder, scene, _) = room();
    let Some(hanging) = Hanging::new(&folder.path().join("gone")) else {
        eprintln!("skipped: no file system can be mounted here");
        return;
    };
    let mut client = Client::start_with(folder.path(), capabilities, Value::Null);
    // A program there, one that imports something there, and one whose layout is looked for there.
    let inside = "object chair;\n";
    let there = client.open("gone/there.scene", inside);
    client.open("near.scene", "import \"gone/parts.scene\";\nobject o;\n");
    let place = json!({ "textDocument": { "uri": there }, "position": at(inside, "object |chair") });
    let waiting = client.begin("textDocument/hover", place);
    let uri = client.open("room.scene", &scene);
    for _ in 0..20 {
        assert!(hover(&mut client, &uri, &scene, "object |bed").as_str().unwrap().contains("object bed"));
    }
    assert_eq!(client.next_verdict(&uri)["holds"], 9);
    client.set(&uri, &format!("{scene}object late;\n"));
    assert!(hover(&mut client, &uri, &scene, "object |bed").as_str().unwrap().contains("object bed"));
    // Asked again while nothing has come of the first.
    client.set(&there, "object chair;\nobject other;\n");
    drop(hanging);
    // The disk is gone for good.
    let answer = client.end(waiting);
    assert!(
        answer["result"]["contents"]["value"].as_str().is_some_and(|text| text.contains("object chair")),
        "{answer}"
    );
    assert_eq!(client.stop(), 0);
}

#[test]
fn a_disk_that_hangs_keeps_nobody_else_waiting() {
    others_are_answered(usual());
}

/// The same where the server looks itself whether files change.
#[test]
fn a_disk_that_hangs_and_is_not_watched_keeps_nobody_else_waiting() {
    let mut can = usual();
    can["workspace"]["didChangeWatchedFiles"] = json!({});
    others_are_answered(can);
}
