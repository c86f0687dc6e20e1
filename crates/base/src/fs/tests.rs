//! Writes, as other programs and the next run find them.

use super::*;
use std::time::{Duration, SystemTime};

#[test]
fn replaces_a_file_and_leaves_nothing_else() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("deep/er/a.txt");
    write_whole(&path, b"one").unwrap();
    write_whole(&path, b"two").unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), b"two");
    assert_eq!(std::fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
}

#[test]
fn a_failed_write_says_the_path() {
    let dir = tempfile::tempdir().unwrap();
    let e = write_whole(dir.path(), b"x").unwrap_err();
    assert!(e.to_string().contains(&dir.path().display().to_string()), "{e}");
}

#[test]
fn what_a_killed_process_left_is_swept() {
    let dir = tempfile::tempdir().unwrap();
    let made = |name: &str, age: u64| {
        let file = File::create(dir.path().join(name)).unwrap();
        file.set_modified(SystemTime::now() - Duration::from_secs(age)).unwrap();
        file
    };
    let written = made(".scenelang-wRiTe1.part", 600);
    written.lock().unwrap();
    for (name, age) in [
        (".scenelang-aB3dE6.part", 600),
        (".scenelang-young1.part", 5),
        // Ours are not called like this.
        (".scenelang-backup", 600),
        (".scenelang-seven77.part", 600),
        (".scenelang-a.b_c1.part", 600),
        ("scenelang-aB3dE6.part", 600),
    ] {
        made(name, age);
    }
    std::fs::create_dir(dir.path().join(".scenelang-folder.part")).unwrap();
    write_whole(&dir.path().join("room.scene"), b"").unwrap();
    let mut left: Vec<String> =
        std::fs::read_dir(dir.path()).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    left.sort();
    let expected = [
        ".scenelang-a.b_c1.part",
        ".scenelang-backup",
        ".scenelang-folder.part",
        ".scenelang-seven77.part",
        ".scenelang-wRiTe1.part",
        ".scenelang-young1.part",
        "room.scene",
        "scenelang-aB3dE6.part",
    ];
    assert_eq!(left, expected);
}

#[cfg(unix)]
mod on_unix {
    use super::*;
    use std::os::unix::fs::{PermissionsExt, symlink};

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> =
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_link_stays_and_its_file_is_replaced() {
        let dir = tempfile::tempdir().unwrap();
        let real = dir.path().join("far/real.txt");
        write_whole(&real, b"one").unwrap();
        for (link, to) in [("link", Path::new("far/real.txt")), ("second", Path::new("link"))] {
            symlink(to, dir.path().join(link)).unwrap();
        }
        write_whole(&dir.path().join("second"), b"two").unwrap();
        assert_eq!(std::fs::read(&real).unwrap(), b"two");
        assert!(std::fs::symlink_metadata(dir.path().join("second")).unwrap().is_symlink());
        assert_eq!(names(dir.path()), ["far", "link", "second"]);
        assert_eq!(names(&dir.path().join("far")), ["real.txt"]);
    }

    #[test]
    fn a_link_to_nothing_and_a_link_to_itself_are_refused() {
        let dir = tempfile::tempdir().unwrap();
        for (link, to) in [("nothing", "absent.txt"), ("round", "round")] {
            symlink(to, dir.path().join(link)).unwrap();
            let e = write_whole(&dir.path().join(link), b"x").unwrap_err().to_string();
            assert!(e.starts_with("cannot write ") && e.contains(link), "{e}");
        }
        assert_eq!(names(dir.path()), ["nothing", "round"]);
    }

    #[test]
    fn a_read_only_file_stays() {
        let dir = tempfile::tempdir().unwrap();
        let (path, other) = (dir.path().join("a.txt"), dir.path().join("b.txt"));
        for path in [&path, &other] {
            std::fs::write(path, "old").unwrap();
        }
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o444)).unwrap();
        let e = write_set(&[(other.clone(), b"new"), (path.clone(), b"new")]).unwrap_err().to_string();
        assert!(e.contains("a.txt: it is read-only"), "{e}");
        for path in [&path, &other] {
            assert_eq!(std::fs::read(path).unwrap(), b"old", "neither is written");
        }
        assert_eq!(names(dir.path()), ["a.txt", "b.txt"]);
    }

    #[test]
    fn the_mode_is_kept() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.sh");
        write_whole(&path, b"one").unwrap();
        for mode in [0o755, 0o600, 0o664] {
            std::fs::set_permissions(&path, std::fs::Permissions::from_mode(mode)).unwrap();
            write_whole(&path, b"two").unwrap();
            assert_eq!(std::fs::metadata(&path).unwrap().permissions().mode() & 0o7777, mode);
        }
    }

    #[test]
    fn a_device_is_written_to() {
        write_whole(Path::new("/dev/null"), b"gone").unwrap();
        assert!(!std::fs::metadata("/dev/null").unwrap().is_file());
        assert!(is_stream(Path::new("/dev/null")) && is_stream(Path::new("/dev/stdout")));
    }

    #[test]
    fn a_file_is_known_by_all_its_names() {
        let dir = tempfile::tempdir().unwrap();
        let at = |name: &str| dir.path().join(name);
        std::fs::write(at("a"), "").unwrap();
        std::fs::write(at("b"), "").unwrap();
        symlink("a", at("link")).unwrap();
        std::fs::hard_link(at("a"), at("hard")).unwrap();
        for (name, same) in [("a", true), ("./a", true), ("link", true), ("hard", true), ("b", false), ("none", false)]
        {
            assert_eq!(is_same(&at("a"), &at(name)), same, "{name}");
        }
    }
}
