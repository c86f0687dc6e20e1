//! What the disk has of the files of one open program. Another thread looks for it, so that the thread that owns all state
//! never touches the disk: a file that hangs keeps waiting only those who ask about the programs that read it.
//!
//! Texts of open documents are not kept here, only that they may be read: they change with each key.

use crate::disk::{Files, Reach, Stamp, settings_for, stamp};
use crate::documents::name_of;
use crate::reading::copied;
use crate::text::Text;
use scenelang_base::door::{Door, outside};
use scenelang_ide::Host;
use scenelang_lang::sources::Loader;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// What was found of a file.
enum Found {
    Bytes(Arc<[u8]>),
    /// It is open in the editor, and may be read.
    Open,
    Refused(io::Error),
}

impl PartialEq for Found {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Bytes(a), Self::Bytes(b)) => a == b,
            (Self::Open, Self::Open) => true,
            (Self::Refused(a), Self::Refused(b)) => a.kind() == b.kind() && a.to_string() == b.to_string(),
            _ => false,
        }
    }
}

/// What was found of the files of a program.
pub struct Shelf {
    /// Where they may be.
    pub door: Arc<Door>,
    files: BTreeMap<PathBuf, Found>,
    /// What those were that are not open, when they were looked at; not of those that take long.
    stamps: BTreeMap<PathBuf, Stamp>,
}

impl Shelf {
    /// Reads what a program at `path` with this text imports, its settings, and its layout.
    pub fn fill(files: &Files, path: &Path, text: &Text, layout: Option<&Path>) -> Self {
        let reach = files.of(path);
        let seen = Seen { reach, found: RefCell::default(), stamps: RefCell::default() };
        // Their places are looked for here, and not where they are used.
        let _settings = settings_for(seen.reach.door(), &seen);
        if let Some(layout) = layout {
            // What cannot be read is kept, too.
            let _ = seen.load(layout);
        }
        drop(Host::new(&name_of(path), path, text.as_str(), &seen));
        let door = Arc::clone(seen.reach.door());
        Self { door, files: seen.found.into_inner(), stamps: seen.stamps.into_inner() }
    }

    /// Whether a file was looked for.
    pub fn knows(&self, path: &Path) -> bool {
        self.files.contains_key(path)
    }

    /// Whether the same was found.
    pub fn is_like(&self, other: &Self) -> bool {
        self.files == other.files && self.door.root() == other.door.root()
    }

    /// What files were.
    pub fn stamps(&self) -> impl Iterator<Item = (&PathBuf, &Stamp)> {
        self.stamps.iter()
    }
}

/// Reads, and remembers what was read.
struct Seen {
    reach: Reach,
    found: RefCell<BTreeMap<PathBuf, Found>>,
    stamps: RefCell<BTreeMap<PathBuf, Stamp>>,
}

impl Loader for Seen {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        if !path.is_absolute() {
            return Err(io::ErrorKind::NotFound.into());
        }
        let looked: Arc<Mutex<Option<Stamp>>> = Arc::default();
        let (file, own) = (path.to_owned(), Arc::clone(&looked));
        // Before it is read: what changes in between is then seen to have changed.
        let first = move || *own.lock().unwrap_or_else(PoisonError::into_inner) = Some(stamp(&file));
        let (read, open) = self.reach.load_after(path, first);
        let found = match &read {
            Ok(_) if open => Found::Open,
            Ok(bytes) => Found::Bytes(bytes.as_slice().into()),
            Err(e) => Found::Refused(copied(e)),
        };
        if let Some(stamp) = looked.lock().unwrap_or_else(PoisonError::into_inner).take().filter(|_| !open) {
            self.stamps.borrow_mut().insert(path.to_owned(), stamp);
        }
        self.found.borrow_mut().insert(path.to_owned(), found);
        read
    }
}

/// The files of a shelf, with the texts of open documents before them.
pub struct Shelved<'a> {
    shelf: Option<&'a Shelf>,
    texts: &'a BTreeMap<PathBuf, Arc<Text>>,
    /// Whether something was asked for that is not on the shelf.
    missing: Cell<bool>,
}

impl<'a> Shelved<'a> {
    /// `None`: nothing has been read yet.
    pub fn new(shelf: Option<&'a Shelf>, texts: &'a BTreeMap<PathBuf, Arc<Text>>) -> Self {
        Self { shelf, texts, missing: Cell::new(false) }
    }

    /// Whether something was asked for that has to be read first.
    pub fn is_missing(&self) -> bool {
        self.missing.get()
    }
}

impl Loader for Shelved<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        if !path.is_absolute() {
            return Err(io::ErrorKind::NotFound.into());
        }
        let found = self.shelf.and_then(|shelf| shelf.files.get(path));
        match (self.texts.get(path), found) {
            // A file that is new need not be on the disk.
            (Some(text), Some(found)) => match found {
                Found::Refused(e) if outside(e).is_some() => Err(copied(e)),
                _ => Ok(text.as_str().as_bytes().to_vec()),
            },
            (None, Some(Found::Bytes(bytes))) => Ok(bytes.to_vec()),
            (None, Some(Found::Refused(e))) => Err(copied(e)),
            (None, Some(Found::Open)) | (_, None) => {
                self.missing.set(true);
                Err(io::Error::new(io::ErrorKind::WouldBlock, "it is still being read"))
            }
        }
    }
}
