//! Where a file belongs: the folder that it may not lead out of, and where its settings may be.
//!
//! Folders are looked at from the file upward, to the folder of its repository or the user's home, and no further than
//! to a folder of somebody else. The nearest one with settings is the root; without settings the repository is, or the
//! folder that the user has opened, or the folder of the file.

use std::path::{Path, PathBuf};

/// What the settings of a workspace are called.
pub const MARK: &str = "scenelang.toml";
/// What makes a folder a repository; a folder, or a file in another worktree of one.
const REPOSITORY: &str = ".git";

/// Where a file belongs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilePlace {
    /// The folder that it may not lead out of.
    pub root: PathBuf,
    /// Where its settings may be, nearest first; whether they are there or not.
    pub settings: Vec<PathBuf>,
}

impl FilePlace {
    /// The place of a file or folder; `opened`: folders that the user has opened or named.
    pub(super) fn of(path: &Path, opened: &[PathBuf]) -> Self {
        let start = if path.is_dir() { path } else { path.parent().unwrap_or(path) };
        let home = std::env::home_dir();
        let owners = Owners::of(start);
        let mut root = None;
        let mut settings = Vec::new();
        for folder in start.ancestors() {
            if !owners.trust(folder) {
                break;
            }
            let file = folder.join(MARK);
            let (marked, repository) = (file.symlink_metadata().is_ok(), folder.join(REPOSITORY));
            if !marked || owners.trust(&file) {
                settings.push(file);
                // Settings in the home folder, or at the top, are for all that is below; they do not open all of it.
                let all = folder.parent().is_none() || home.as_deref() == Some(folder);
                if marked && !all {
                    root.get_or_insert_with(|| folder.to_path_buf());
                }
            }
            let end = home.as_deref() == Some(folder);
            if !end && repository.symlink_metadata().is_ok() && owners.trust(&repository) {
                root.get_or_insert_with(|| folder.to_path_buf());
                break;
            }
            if end {
                break;
            }
        }
        let around = || opened.iter().filter(|folder| start.starts_with(folder)).min_by_key(|f| f.as_os_str().len());
        let root = root.or_else(|| around().cloned()).unwrap_or_else(|| start.to_path_buf());
        Self { root, settings }
    }
}

/// Whose settings and repositories count: the user's, the administrator's, and those of whoever owns the folder of the
/// file. So a file that anybody may put into a shared folder such as `/tmp` judges nobody else's scenes, and a container
/// can work on a folder from outside.
#[cfg(unix)]
struct Owners([u32; 3]);

/// See above: elsewhere files have no such owners.
#[cfg(not(unix))]
struct Owners;

#[cfg(unix)]
impl Owners {
    fn of(folder: &Path) -> Self {
        use std::os::unix::fs::MetadataExt;
        let ours = rustix::process::geteuid().as_raw();
        Self([ours, 0, folder.metadata().map_or(ours, |data| data.uid())])
    }

    /// What is not there belongs to nobody, and does no harm.
    fn trust(&self, path: &Path) -> bool {
        use std::os::unix::fs::MetadataExt;
        // Of a link, who made it and who owns what it leads to.
        let owners = [path.symlink_metadata(), path.metadata()];
        owners.iter().flatten().all(|data| self.0.contains(&data.uid()))
    }
}

#[cfg(not(unix))]
impl Owners {
    fn of(_: &Path) -> Self {
        Self
    }

    fn trust(&self, _: &Path) -> bool {
        true
    }
}
