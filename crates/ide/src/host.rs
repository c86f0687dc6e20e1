//! A program under edit beside its layout: the one place that is written to, and snapshots that everything else reads.

use scenelang_analysis::{Judging, silence};
use scenelang_base::{Diagnostic, FileId, SourceFile, SourceMap, Span, codes};
use scenelang_engine::{check_read, check_read_locked};
use scenelang_lang::Program;
use scenelang_lang::db::{Analysis, Cancelled};
use scenelang_lang::hir::Meanings;
use scenelang_lang::program::{Object, ObjectId};
use scenelang_lang::sources::{Loader, unreadable};
use scenelang_layout::{ReadLayout, file as layout_file};
use scenelang_verify::{CheckVerdict, Explain};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// A program and its layout. Snapshots of it say what is known; a change of its text ends their questions.
pub struct Host {
    analysis: Analysis,
    known: Known,
}

/// What a host knew at one moment. For one thread; questions end with [`Cancelled`] when the text changes.
pub struct Snapshot {
    analysis: Analysis,
    known: Known,
}

/// What a host shares with its snapshots.
#[derive(Clone)]
struct Known {
    sources: Arc<SourceMap>,
    main: FileId,
    layout: Option<Arc<LayoutFile>>,
    judging: Arc<Judging>,
    /// Objects, or arrays of them, that no move which is offered moves.
    locks: Arc<[String]>,
    /// What follows from these, as far as somebody asked.
    compiled: Arc<Memo<Compiled>>,
    judged: Arc<Memo<Judged>>,
    explained: Arc<Memo<CheckVerdict>>,
}

/// A program as far as it can be judged.
#[derive(Debug)]
pub struct Compiled {
    /// Without statements that have errors, and those that need one of them.
    pub program: Program,
    /// Whether there is no error.
    pub complete: bool,
    /// Errors and warnings, by file and place.
    pub diagnostics: Vec<Diagnostic>,
}

/// The layout of a program.
#[derive(Debug)]
pub struct LayoutFile {
    /// Its id among the sources.
    pub file: FileId,
    /// Where it is.
    pub path: PathBuf,
    /// What it says, with places.
    pub read: ReadLayout,
    /// Why it cannot be read at all.
    pub unreadable: Option<Diagnostic>,
}

/// What holds in a layout. No violation in it is explained: that takes longer than the verdict.
#[derive(Debug)]
pub struct Judged {
    /// Rows and findings about the layout. While the program has errors, what the physical rules say is left out, since a
    /// statement that is missing may have lifted them.
    pub verdict: CheckVerdict,
    /// The program that was judged by.
    pub compiled: Arc<Compiled>,
}

impl Host {
    /// A host of the program called `name` at `path`, with its text.
    pub fn new(name: &str, path: &Path, text: &str, loader: &dyn Loader) -> Self {
        let mut sources = SourceMap::new();
        let main = sources.add(SourceFile::new(name, path, text));
        let mut analysis = Analysis::new(scenelang_lang::Options::default());
        analysis.update(main, &mut sources, loader);
        let known = Known {
            sources: Arc::new(sources),
            main,
            layout: None,
            judging: Arc::default(),
            locks: Arc::default(),
            compiled: Arc::default(),
            judged: Arc::default(),
            explained: Arc::default(),
        };
        Self { analysis, known }
    }

    /// Takes over a new text of the program, and reads again what it imports.
    pub fn set_text(&mut self, text: &str, loader: &dyn Loader) {
        let file = self.known.sources.get(self.known.main);
        let (name, path) = (file.name().to_owned(), file.path().to_owned());
        let sources = Arc::make_mut(&mut self.known.sources);
        sources.put(SourceFile::new(name, path, text));
        self.analysis.update(self.known.main, sources, loader);
        self.known.compiled = Arc::default();
        self.forget();
    }

    /// Takes over the layout called `name` at `path`; `None`: there is none.
    pub fn set_layout(&mut self, layout: Option<(String, &Path, io::Result<Vec<u8>>)>) {
        self.known.layout = layout.and_then(|(name, path, bytes)| {
            let missing = bytes.as_ref().err().is_some_and(|e| e.kind() == io::ErrorKind::NotFound);
            if missing {
                return None;
            }
            let sources = Arc::make_mut(&mut self.known.sources);
            let told = |e: io::Error| Box::new(unreadable(&format!("read {name}"), &e));
            let (text, unreadable) = match bytes.map_err(told).and_then(layout_file::decode) {
                Ok(text) => (text, None),
                Err(finding) => (String::new(), Some(*finding)),
            };
            let file = sources.put(SourceFile::new(name, path, text));
            let read = layout_file::read(sources.get(file).text(), file);
            Some(Arc::new(LayoutFile { file, path: path.to_owned(), read, unreadable }))
        });
        self.forget();
    }

    /// Judges in another way from now on.
    pub fn set_judging(&mut self, judging: Judging) {
        if *self.known.judging != judging {
            self.known.judging = Arc::new(judging);
            self.forget();
        }
    }

    /// From now on no move is offered of these objects, or arrays of them.
    pub fn set_locks(&mut self, locks: &[String]) {
        if *self.known.locks != *locks {
            self.known.locks = locks.into();
            self.known.explained = Arc::default();
        }
    }

    fn forget(&mut self) {
        self.known.judged = Arc::default();
        self.known.explained = Arc::default();
    }

    /// What is known now, for another thread.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot { analysis: self.analysis.reader(), known: self.known.clone() }
    }

    /// Where the program is.
    pub fn path(&self) -> &Path {
        self.known.sources.get(self.known.main).path()
    }

    /// The files that were read for the program, itself included, its layout not.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        let layout = self.known.layout.as_ref().map(|l| l.file);
        self.known.sources.iter().filter(move |(id, _)| Some(*id) != layout).map(|(_, file)| file.path())
    }
}

impl Snapshot {
    /// The program's files, and its layout.
    pub fn sources(&self) -> &SourceMap {
        &self.known.sources
    }
    /// The program's own file.
    pub fn main(&self) -> FileId {
        self.known.main
    }
    /// The text of the program's own file.
    pub fn text(&self) -> &str {
        self.known.sources.get(self.known.main).text()
    }
    /// The program's layout, if there is one.
    pub fn layout(&self) -> Option<&LayoutFile> {
        self.known.layout.as_deref()
    }
    /// The same, to keep.
    pub fn layout_file(&self) -> Option<Arc<LayoutFile>> {
        self.known.layout.clone()
    }
    /// How its layout is judged.
    pub fn judging(&self) -> &Judging {
        &self.known.judging
    }
    /// The objects of a program that are locked.
    pub fn locked(&self, program: &Program) -> Vec<ObjectId> {
        let is_locked = |object: &Object| self.known.locks.iter().any(|name| object.is_meant_by(name));
        let objects = (0..).map(ObjectId).zip(&program.objects);
        objects.filter(|(_, object)| is_locked(object)).map(|(id, _)| id).collect()
    }
    /// The front end.
    pub fn analysis(&self) -> &Analysis {
        &self.analysis
    }
    /// The files alone, with the id of the program's own: what is left of a snapshot that no change has to wait for.
    pub fn into_sources(self) -> (Arc<SourceMap>, FileId) {
        (self.known.sources, self.known.main)
    }
    /// The text of a place.
    pub fn slice(&self, span: Span) -> &str {
        self.known.sources.text(span)
    }

    /// What the statements of the program's own file mean.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn meanings(&self) -> Result<Meanings<'_>, Cancelled> {
        self.analysis.meanings(self.known.main)
    }

    /// The program; worked out once.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn compiled(&self) -> Result<Arc<Compiled>, Cancelled> {
        self.known.compiled.get_or(|| {
            let (program, mut diagnostics) = self.analysis.partial(&self.known.sources)?;
            let complete = !diagnostics.iter().any(Diagnostic::is_error);
            silence(&mut diagnostics, &self.known.judging);
            Ok(Compiled { program, complete, diagnostics })
        })
    }

    /// What holds in the layout; `None`: there is none that can be read. Worked out once.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn judged(&self) -> Result<Option<Arc<Judged>>, Cancelled> {
        let Some(layout) = self.known.layout.as_ref().filter(|l| l.read.usable) else { return Ok(None) };
        self.known
            .judged
            .get_or(|| {
                let compiled = self.compiled()?;
                let mut options = self.known.judging.options;
                options.detail.explain = Explain::First(0);
                options.detail.sentences = false;
                options.physics &= compiled.complete;
                let mut verdict = check_read(&compiled.program, &layout.read, &options);
                if !compiled.complete {
                    // What the layout has and the program has not may be declared where the program is broken.
                    verdict.diagnostics.retain(|d| d.code != codes::E0506);
                }
                scenelang_lang::lint::allow::silence(&self.known.sources, &mut verdict.diagnostics);
                silence(&mut verdict.diagnostics, &self.known.judging);
                Ok(Judged { verdict, compiled })
            })
            .map(Some)
    }

    /// The same with sentences, and with every violation explained; rows are in the same order. Takes much longer.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn explained(&self) -> Result<Option<Arc<CheckVerdict>>, Cancelled> {
        let Some(layout) = self.known.layout.as_ref().filter(|l| l.read.usable) else { return Ok(None) };
        self.known
            .explained
            .get_or(|| {
                let compiled = self.compiled()?;
                let mut options = self.known.judging.options;
                options.detail.sentences = true;
                options.physics &= compiled.complete;
                let locked = self.locked(&compiled.program);
                Ok(check_read_locked(&compiled.program, &layout.read, &options, &locked))
            })
            .map(Some)
    }
}

/// A value that is worked out once, by whoever needs it first.
#[derive(Debug)]
struct Memo<T>(Mutex<Option<Arc<T>>>);

impl<T> Default for Memo<T> {
    fn default() -> Self {
        Self(Mutex::new(None))
    }
}

impl<T> Memo<T> {
    fn get_or(&self, make: impl FnOnce() -> Result<T, Cancelled>) -> Result<Arc<T>, Cancelled> {
        // A thread that panicked while it held the lock has left nothing half-made.
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match &*known {
            Some(value) => Ok(Arc::clone(value)),
            None => Ok(Arc::clone(known.insert(Arc::new(make()?)))),
        }
    }
}
