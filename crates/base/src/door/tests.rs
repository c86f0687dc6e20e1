//! Paths that lead out, things that are no files, and files without end.

use super::*;
use std::fs;

fn made(files: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for file in files {
        let path = folder.path().join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, file).unwrap();
    }
    folder
}

fn is_outside<T>(done: io::Result<T>) -> bool {
    done.is_err_and(|e| outside(&e).is_some())
}

fn is_unwritten(done: io::Result<()>) -> bool {
    done.is_err_and(|e| e.to_string().contains("leads outside"))
}

#[test]
fn files_below_the_root_are_read_and_written_and_others_are_not() {
    let folder = made(&["in/room.scene", "in/lib/a.scene", "secret"]);
    let at = |path: &str| folder.path().join(path);
    let door = Door::of(&at("in/room.scene"));
    assert_eq!(door.root(), at("in"));
    assert_eq!(door.read(&at("in/lib/a.scene")).unwrap(), b"in/lib/a.scene");
    assert_eq!(door.read(&at("in/lib/../room.scene")).unwrap(), b"in/room.scene");
    for path in ["secret", "in/../secret", "in/lib/../../secret", "not-there", "in/../nor/there"] {
        assert!(is_outside(door.read(&at(path))), "{path}");
        assert!(is_unwritten(door.write(&at(path), b"x")), "{path}");
    }
    assert!(is_outside(door.read(Path::new("/proc/self/environ"))) || !cfg!(target_os = "linux"));
    assert_eq!(door.read(&at("in/not-there")).unwrap_err().kind(), io::ErrorKind::NotFound);
    door.write(&at("in/new/deep"), b"x").unwrap();
    assert_eq!(fs::read_to_string(at("secret")).unwrap(), "secret");
    let door = door.named(&Named::new([at("secret").as_path()]));
    assert!(door.read(&at("secret")).is_ok() && is_outside(door.read(&at("other"))));
}

#[test]
fn settings_and_repositories_make_the_root() {
    let cases: &[(&[&str], &str)] = &[
        (&["a/b/room.scene"], "a/b"),
        (&["a/b/room.scene", "a/scenelang.toml"], "a"),
        (&["a/b/room.scene", "scenelang.toml", "a/.git/HEAD"], "a"),
        (&["a/b/room.scene", "a/b/scenelang.toml", "a/.git/HEAD"], "a/b"),
        (&["a/b/room.scene", "a/.git"], "a"),
    ];
    for (files, root) in cases {
        let folder = made(files);
        let door = Door::of(&folder.path().join("a/b/room.scene"));
        assert_eq!(door.root(), folder.path().join(root), "{files:?}");
        let above = folder.path().join("scenelang.toml");
        assert_eq!(door.settings().contains(&above), !files.iter().any(|f| f.contains(".git")), "{files:?}");
    }
    // Folders that are not there are no reason to refuse settings that could be in them.
    let folder = made(&["scenelang.toml"]);
    let door = Door::of(&folder.path().join("not/yet/there/room.scene"));
    assert!(door.settings().len() > 3 && door.settings().iter().all(|file| door.permits(file).is_ok()));
    let folder = made(&["a/b/room.scene"]);
    let door = Door::of(&folder.path().join("a/b/room.scene")).named(&Named::new([folder.path().join("a").as_path()]));
    assert_eq!(door.root(), folder.path().join("a"));
}

#[test]
fn a_folder_that_was_opened_is_not_left_for_its_repository() {
    let folder =
        made(&["secret", ".git/HEAD", "scenelang.toml", "in/deep/room.scene", "in/deep/scenelang.toml", "in/a.scene"]);
    let at = |path: &str| folder.path().join(path);
    for (file, root) in [("in/a.scene", "in"), ("in/deep/room.scene", "in/deep")] {
        let door = Door::of(&at(file)).inside(&at("in"));
        assert_eq!(door.root(), at(root));
        assert!(door.read(&at(file)).is_ok() && is_outside(door.read(&at("secret"))), "{file}");
        assert!(door.settings().contains(&at("scenelang.toml")) && door.read(&at("scenelang.toml")).is_ok());
    }
    #[cfg(unix)]
    {
        fs::create_dir(at("out")).unwrap();
        fs::write(at("out/room.scene"), "").unwrap();
        fs::write(at("out/scenelang.toml"), "").unwrap();
        std::os::unix::fs::symlink("../out", at("in/link")).unwrap();
        let door = Door::of(&at("in/link/room.scene")).inside(&at("in"));
        assert!(is_outside(door.read(&at("in/link/room.scene"))));
    }
}

#[cfg(unix)]
#[test]
fn settings_of_somebody_else_do_not_count() {
    let folder = made(&["a/b/room.scene", "a/scenelang.toml", "scenelang.toml"]);
    let at = |path: &str| folder.path().join(path);
    // Only the administrator can give files away; others have nothing to try this with.
    if std::os::unix::fs::chown(at("a/scenelang.toml"), Some(12345), None).is_err() {
        return;
    }
    let door = Door::of(&at("a/b/room.scene"));
    assert_eq!(door.root(), folder.path());
    assert!(!door.settings().contains(&at("a/scenelang.toml")));
    // Beyond a folder of somebody else nothing is looked for.
    std::os::unix::fs::chown(at("a"), Some(12345), None).unwrap();
    let door = Door::of(&at("a/b/room.scene"));
    assert_eq!((door.root(), door.settings().len()), (at("a/b").as_path(), 1));
    // What belongs to whoever owns the folder of the file is one workspace with it.
    std::os::unix::fs::chown(at("a/b"), Some(12345), None).unwrap();
    assert_eq!(Door::of(&at("a/b/room.scene")).root(), at("a"));
}

#[cfg(unix)]
#[test]
fn links_do_not_lead_out() {
    use std::os::unix::fs::symlink;
    let folder = made(&["in/room.scene", "secret", "out/deep/secret"]);
    let at = |path: &str| folder.path().join(path);
    for (to, from) in [("../secret", "in/link"), ("../out", "in/folder"), ("room.scene", "in/own"), ("loop", "in/loop")]
    {
        symlink(to, at(from)).unwrap();
    }
    symlink("../nothing", at("in/dangling")).unwrap();
    let door = Door::of(&at("in/room.scene"));
    for path in ["in/link", "in/folder/deep/secret", "in/folder/deep/nothing"] {
        assert!(is_outside(door.read(&at(path))), "{path}");
        assert!(is_unwritten(door.write(&at(path), b"x")), "{path}");
    }
    assert_eq!(door.read(&at("in/own")).unwrap(), b"in/room.scene");
    for path in ["in/loop", "in/dangling"] {
        assert!(door.read(&at(path)).is_err(), "{path}");
    }
    // Whoever names a link names what lies in the workspace, and not where somebody else lets it lead.
    assert!(is_outside(Door::of(&at("in/link")).read(&at("in/link"))));
    assert!(is_outside(
        Door::of(&at("in/room.scene")).named(&Named::new([at("in/link").as_path()])).read(&at("in/link"))
    ));
    assert!(is_unwritten(Door::within(&at("in/folder")).write(&at("in/folder/x"), b"x")));
    assert!(Door::within(&at("in/new")).write(&at("in/new/x"), b"x").is_ok());
}

#[cfg(unix)]
#[test]
fn only_regular_files_are_read_and_only_so_much() {
    let folder = made(&["in/room.scene"]);
    let at = |path: &str| folder.path().join(path);
    let door = Door::of(&at("in/room.scene"));
    let made = std::process::Command::new("mkfifo").arg(at("in/pipe")).status();
    if made.is_ok_and(|status| status.success()) {
        let e = door.read(&at("in/pipe")).unwrap_err();
        assert_eq!(e.to_string(), "it is a pipe, not a regular file");
    }
    let _socket = std::os::unix::net::UnixListener::bind(at("in/socket")).unwrap();
    assert_eq!(door.read(&at("in/socket")).unwrap_err().to_string(), "it is a socket, not a regular file");
    assert_eq!(door.read(&at("in")).unwrap_err().kind(), io::ErrorKind::IsADirectory);
    let device = Path::new("/dev/zero");
    assert_eq!(Door::of(device).read(device).unwrap_err().to_string(), "it is a device, not a regular file");
    let large = fs::File::create(at("in/large")).unwrap();
    large.set_len(MOST + 1).unwrap();
    assert_eq!(door.read(&at("in/large")).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
}

#[test]
fn paths_are_named_as_a_folder_sees_them() {
    for (path, folder, wanted) in [
        ("rooms/parts.scene", "rooms", "parts.scene"),
        ("parts.scene", "rooms/big", "../../parts.scene"),
        ("../lib/parts.scene", "../rooms", "../lib/parts.scene"),
        ("/a/b/c.scene", "/a/d", "../b/c.scene"),
        ("parts.scene", "", "parts.scene"),
    ] {
        assert_eq!(relative(Path::new(path), Path::new(folder)), wanted, "{path} from {folder}");
    }
}
