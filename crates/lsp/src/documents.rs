//! Open documents, and the programs among them.

use crate::config::Config;
use crate::disk::{Files, Folders, Stamp, is_file, path_of, settings_for};
use crate::dispatch::Tokens;
use crate::proved::{Proofs, Said};
use crate::reading::Reading;
use crate::shelf::{Shelf, Shelved};
use crate::state::{Event, State, guarded};
use crate::text::{Encoding, Text};
use scenelang_analysis::FileSettings;
use scenelang_base::door::Door;
use scenelang_export::scene::Memory;
use scenelang_ide::Host;
use scenelang_lang::sources::{Loader, normal};
use scenelang_verify::settings::Settings;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tower_lsp::ls_types::Uri;

/// What was read longer ago is read again beside what else is done, in case that the editor does not say that it changed.
const FRESH: Duration = Duration::from_secs(2);

/// A document that the editor has open.
pub struct OpenDocument {
    /// As the editor calls it.
    pub uri: Uri,
    /// Where it is.
    pub path: PathBuf,
    /// What the editor counts.
    pub version: i32,
    pub text: Arc<Text>,
    /// What can be said of it, if it is a program.
    pub scene: Option<OpenScene>,
}

/// An open program with its layout.
pub struct OpenScene {
    /// What is known of it.
    pub host: Host,
    /// Where its layout is, or would be.
    pub layout: Option<PathBuf>,
    /// The settings of its workspace.
    pub settings: Arc<FileSettings>,
    /// The text is newer than what the host knows.
    pub stale_text: bool,
    /// The layout, or the settings, are newer than what the host knows.
    pub stale_layout: bool,
    /// Another number whenever something has changed that could change a verdict.
    pub generation: u64,
    /// The generation whose verdict was published.
    pub published: u64,
    /// Whether a verdict is being worked out.
    pub judging: bool,
    /// Something else than the document has changed since the last verdict: the editor must be told to ask again.
    pub outside: bool,
    /// What is proved of the program, until it says something else.
    pub proofs: Proofs,
    /// Another number whenever the program says something else: what was proved of it is true as long as this is the same.
    pub meaning: u64,
    /// What it said when its text was last looked at.
    said: Option<Said>,
    /// Whether the editor was told of proofs.
    pub told_proofs: bool,
    /// Proofs are to be looked for.
    pub unproved: bool,
    /// What the disk has of its files.
    shelf: Option<Arc<Shelf>>,
    /// The shelf lacks something, or is not what the disk has now: nothing can be said before it was read.
    unread: bool,
    /// Another number whenever something was found to be unread.
    wanted: u64,
    /// Whether its files are being read.
    reading: bool,
    /// When its files were read.
    read_at: Option<Instant>,
    /// Another number for each program that was opened.
    opening: u64,
    /// The semantic tokens that were sent last.
    pub tokens: Tokens,
    /// What the objects of its room look like.
    pub looks: Arc<Memory>,
}

/// All open documents by their address.
#[derive(Default)]
pub struct Documents {
    open: BTreeMap<String, OpenDocument>,
    /// Texts that the editor was given to write into files, and has not said since what became of them.
    assumed: BTreeMap<PathBuf, Arc<Text>>,
    /// By address of a program: objects, or arrays of them, that stay where they are.
    locks: BTreeMap<String, Vec<String>>,
    /// The last generation of any program.
    generation: u64,
    /// The folders of the workspace.
    folders: Arc<Folders>,
    /// How many programs were opened.
    openings: u64,
    /// Who reads for the thread that owns all of this.
    reading: Option<Arc<Reading>>,
    /// How positions in marks count.
    encoding: Encoding,
}

impl Documents {
    /// From now on positions count so.
    pub fn count_in(&mut self, encoding: Encoding) {
        self.encoding = encoding;
    }

    /// Opens a document, or takes it over anew.
    pub fn open(&mut self, uri: Uri, language: &str, version: i32, text: String, config: &Config) {
        let path = path_of(&uri);
        self.assumed.remove(&path);
        let text = Arc::new(Text::new(text));
        let key = uri.as_str().to_owned();
        self.open.insert(key.clone(), OpenDocument { uri, path: path.clone(), version, text, scene: None });
        if !is_data(&path, language) {
            self.openings += 1;
            let document = &self.open[&key];
            let name = name_of(&path);
            // What it imports is read soon.
            let mut host = Host::new(&name, &path, document.text.as_str(), &Shelved::new(None, &BTreeMap::new()));
            host.set_locks(self.locks.get(&key).map_or(&[], Vec::as_slice));
            let layout = if is_file(&document.uri) { layout_of(&path, config) } else { None };
            let scene = OpenScene {
                host,
                layout,
                settings: Arc::default(),
                stale_text: true,
                stale_layout: true,
                generation: 0,
                published: 0,
                judging: false,
                outside: false,
                proofs: Proofs::default(),
                meaning: 0,
                said: None,
                told_proofs: false,
                unproved: true,
                shelf: None,
                unread: true,
                wanted: 0,
                reading: false,
                read_at: None,
                opening: self.openings,
                tokens: Tokens::default(),
                looks: Arc::default(),
            };
            if let Some(document) = self.open.get_mut(&key) {
                document.scene = Some(scene);
            }
        }
        self.touched(&path, &key);
    }

    /// From now on these objects of a program, or arrays of them, stay where they are, whether it is open or not.
    pub fn lock(&mut self, uri: &str, objects: Vec<String>) {
        if let Some(scene) = self.open.get_mut(uri).and_then(|document| document.scene.as_mut()) {
            scene.host.set_locks(&objects);
        }
        if objects.is_empty() {
            self.locks.remove(uri);
        } else {
            self.locks.insert(uri.to_owned(), objects);
        }
    }

    /// Closes a document; whether it was open.
    pub fn close(&mut self, uri: &str) -> bool {
        let Some(document) = self.open.remove(uri) else { return false };
        // Others read it from disk again.
        self.touched(&document.path, uri);
        true
    }

    /// A file or a document has changed: whoever reads it is told, `except` the document itself.
    pub fn touched(&mut self, path: &Path, except: &str) {
        let on_disk = self.at(path).is_none() && !self.assumed.contains_key(path);
        for (key, document) in &mut self.open {
            let Some(scene) = &mut document.scene else { continue };
            let data = scene.layout.as_deref() == Some(path) || path.ends_with(scenelang_verify::settings::FILE);
            if data {
                scene.stale_layout = true;
                scene.outside = true;
            }
            let known = scene.shelf.as_ref().is_some_and(|shelf| shelf.knows(path));
            let imports = key != except && (known || scene.host.files().any(|file| normal(file) == path));
            let imports = imports && document.path != path;
            if imports {
                scene.stale_text = true;
                scene.outside = true;
            }
            if on_disk && (data || imports) {
                scene.lacks();
            }
        }
    }

    /// What files were when they were read that are not open.
    pub fn stamps(&self) -> Vec<(PathBuf, Stamp)> {
        let shelves = self.open.values().filter_map(|document| document.scene.as_ref()?.shelf.as_ref());
        let closed = |path: &PathBuf| self.at(path).is_none();
        shelves
            .flat_map(|shelf| shelf.stamps())
            .filter(|(path, _)| closed(path))
            .map(|(path, stamp)| (path.clone(), *stamp))
            .collect()
    }

    /// The settings of the editor have changed.
    pub fn reconfigured(&mut self, config: &Config) {
        for document in self.open.values_mut() {
            let Some(scene) = &mut document.scene else { continue };
            scene.layout = if is_file(&document.uri) { layout_of(&document.path, config) } else { None };
            scene.stale_layout = true;
            scene.outside = true;
        }
    }

    /// The document of an address.
    pub fn get(&self, uri: &str) -> Option<&OpenDocument> {
        self.open.get(uri)
    }
    /// The document of an address.
    pub fn get_mut(&mut self, uri: &str) -> Option<&mut OpenDocument> {
        self.open.get_mut(uri)
    }
    pub fn at(&self, path: &Path) -> Option<&OpenDocument> {
        self.open.values().find(|document| document.path == path)
    }
    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &OpenDocument> {
        self.open.values()
    }

    /// Their texts before the disk.
    pub fn files(&self) -> Files {
        let mut texts = self.assumed.clone();
        texts.extend(self.open.values().map(|d| (d.path.clone(), Arc::clone(&d.text))));
        Files { texts: Arc::new(texts), folders: Arc::clone(&self.folders), reading: self.reading.clone() }
    }

    /// From now on files are read by somebody else.
    pub fn read_by(&mut self, reading: Arc<Reading>) {
        self.reading = Some(reading);
    }

    /// The workspace has other folders.
    pub fn set_folders(&mut self, folders: &[PathBuf]) {
        self.folders = Folders::new(folders);
        self.read_again();
    }

    /// Whatever was read is read again.
    pub fn read_again(&mut self) {
        for scene in self.open.values_mut().filter_map(|document| document.scene.as_mut()) {
            (scene.stale_text, scene.stale_layout, scene.outside) = (true, true, true);
            scene.lacks();
        }
    }

    /// The editor has made an edit of a file that it has not opened with us: until it says more of it, this is its text.
    pub fn assume(&mut self, path: &Path, text: String) {
        if self.at(path).is_none() {
            self.assumed.insert(path.to_owned(), Arc::new(Text::new(text)));
            self.touched(path, "");
        }
    }

    /// A file is what the disk has of it again.
    pub fn forget(&mut self, path: &Path) {
        self.assumed.remove(path);
    }

    /// Brings what is known of a program up to its text and its layout, as far as that was read; has read what was not.
    pub fn sync(&mut self, uri: &str) {
        let stale = |s: &OpenScene| s.stale_text || s.stale_layout;
        let Some(scene) = self.open.get(uri).and_then(|d| d.scene.as_ref()).filter(|s| stale(s)) else { return };
        if scene.unread {
            return self.fetch(uri);
        }
        let old = scene.read_at.is_none_or(|at| at.elapsed() > FRESH);
        let texts = self.files().texts;
        self.generation += 1;
        let Some(OpenDocument { text, scene: Some(scene), .. }) = self.open.get_mut(uri) else { return };
        let Some(shelf) = scene.shelf.clone() else { return };
        let files = Shelved::new(Some(&shelf), &texts);
        let (stale_text, stale_layout) = (scene.stale_text, scene.stale_layout);
        if std::mem::take(&mut scene.stale_text) {
            scene.host.set_text(text.as_str(), &files);
            let said = Said::new(&scene.host.snapshot(), text);
            if scene.said.as_ref().is_some_and(|before| before.means_the_same(&said)) {
                scene.proofs.follow(uri, text, self.encoding);
            } else {
                scene.meaning += 1;
                scene.proofs = Proofs::default();
            }
            scene.said = Some(said);
        }
        if std::mem::take(&mut scene.stale_layout) {
            let before = scene.host.snapshot().judging().clone();
            scene.settings = judge_by(&mut scene.host, scene.layout.as_deref(), &shelf.door, &files);
            if *scene.host.snapshot().judging() != before {
                scene.proofs = Proofs::default();
                scene.unproved = true;
            }
        }
        if files.is_missing() {
            (scene.stale_text, scene.stale_layout) = (stale_text, stale_layout);
            scene.lacks();
            return self.fetch(uri);
        }
        scene.generation = self.generation;
        if old {
            self.fetch(uri);
        }
    }

    /// Whether files of a program have to be read before anything can be said of it.
    pub fn is_unread(&self, uri: &str) -> bool {
        self.open.get(uri).and_then(|d| d.scene.as_ref()).is_some_and(|scene| scene.unread)
    }

    /// Has the files of a program read by a thread of their own, which tells the state.
    fn fetch(&mut self, uri: &str) {
        let files = self.files();
        let Some(OpenDocument { path, text, scene: Some(scene), .. }) = self.open.get_mut(uri) else { return };
        let Some(reading) = self.reading.as_ref().filter(|_| !scene.reading) else { return };
        let (events, key, path) = (reading.events(), uri.to_owned(), path.clone());
        let (text, layout, wanted, opening) = (Arc::clone(text), scene.layout.clone(), scene.wanted, scene.opening);
        let thread = std::thread::Builder::new().name("files".to_owned()).stack_size(8 << 20);
        let spawned = thread.spawn(move || {
            let found = guarded(|| Ok(Shelf::fill(&files, &path, &text, layout.as_deref())));
            let tell = move |state: &mut State| state.fetched(&key, opening, wanted, found.ok());
            let _ = events.send(Event::Done(Box::new(tell)));
        });
        scene.reading = spawned.is_ok();
    }

    /// What came of reading the files of a program; `None`: a mistake of ours.
    pub fn shelve(&mut self, uri: &str, opening: u64, wanted: u64, shelf: Option<Shelf>) {
        let scene = self.open.get_mut(uri).and_then(|d| d.scene.as_mut()).filter(|s| s.opening == opening);
        let Some(scene) = scene else { return };
        scene.reading = false;
        let Some(shelf) = shelf else {
            scene.unread = false;
            return;
        };
        let first = scene.shelf.is_none();
        if !scene.shelf.as_ref().is_some_and(|old| old.is_like(&shelf)) {
            (scene.stale_text, scene.stale_layout) = (true, true);
            scene.outside |= !first;
        }
        scene.shelf = Some(Arc::new(shelf));
        scene.read_at = Some(Instant::now());
        // What was changed in the meantime is read again.
        scene.unread &= scene.wanted != wanted;
    }
}

impl OpenScene {
    /// Whether what is known of it is older than what it is.
    pub fn is_stale(&self) -> bool {
        self.stale_text || self.stale_layout || self.unread
    }

    /// What the shelf has is not enough any more.
    fn lacks(&mut self) {
        self.unread = true;
        self.wanted += 1;
    }
}

/// Gives a program its layout and the settings of its workspace.
pub fn judge_by(host: &mut Host, layout: Option<&Path>, door: &Door, files: &dyn Loader) -> Arc<FileSettings> {
    let found = settings_for(door, files);
    host.set_judging(found.judging(&Settings::default()));
    let layout = layout.map(|path| (name_of(path), path, files.load(path)));
    host.set_layout(layout);
    Arc::new(found)
}

/// How a file is called in messages.
pub fn name_of(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

/// Whether a document is a layout or other data, no program.
fn is_data(path: &Path, language: &str) -> bool {
    let extension = path.extension().unwrap_or_default();
    extension.eq_ignore_ascii_case("json")
        || extension.eq_ignore_ascii_case("toml")
        || matches!(language, "json" | "jsonc" | "toml")
}

/// Where the layout of a program is: where the settings say, else beside it.
pub fn layout_of(program: &Path, config: &Config) -> Option<PathBuf> {
    let stem = program.file_stem()?.to_string_lossy();
    Some(match &config.layout {
        Some(pattern) => normal(&program.parent()?.join(pattern.replace("{stem}", &stem))),
        None => program.with_extension("layout.json"),
    })
}
