//! A folder of models: what is in it, read one file after the other, in the order of their names.

use crate::card::Card;
use crate::faults::{Fault, beyond, fault, unreadable};
use crate::features::{self, Features};
use crate::model::{Axes, CatalogueModel};
use crate::{glb, limits, obj, objathor};
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, codes};
use scenelang_layout::Vec3;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// What can be chosen from.
#[derive(Debug)]
pub struct Catalogue {
    folder: PathBuf,
    door: Door,
    /// The models, in the order of their names.
    pub entries: Vec<Entry>,
    /// What cannot be used, in the order of the names.
    pub refused: Vec<Refused>,
    /// What the models look like and are called, in vectors, where the folder has them.
    pub features: Option<Features>,
}

/// A model of a catalogue.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The file, below the folder, with `/` between the parts.
    pub file: String,
    /// What is known of it.
    pub card: Card,
    /// Extents w, h, d (metres), where they are known.
    pub size: Option<Vec3>,
    kind: Kind,
    /// The row of its vectors in the features of the folder.
    pub(crate) row: Option<u32>,
}

/// A file that cannot be used.
#[derive(Clone, Debug)]
pub struct Refused {
    /// The file, below the folder.
    pub file: String,
    /// Why.
    pub finding: Diagnostic,
}

/// How a file is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Glb,
    Obj,
    Objathor,
}

impl Entry {
    /// What features call it: the name of an object of objathor, else the file.
    pub fn name(&self) -> &str {
        match self.kind {
            Kind::Objathor => self.file.split('/').nth(1).unwrap_or(&self.file),
            Kind::Glb | Kind::Obj => &self.file,
        }
    }
}

impl Catalogue {
    /// Opens a folder. Each GLB and OBJ file is read once, so that what cannot be used is known; those of objathor are
    /// not, since what is known of them stands in one file.
    ///
    /// # Errors
    /// There is no such folder, there is nothing to read in it, or it has too much.
    pub fn open(folder: &Path) -> Result<Self, Box<Diagnostic>> {
        let mut catalogue = Self::list(folder)?;
        for mut entry in std::mem::take(&mut catalogue.entries) {
            if entry.kind != Kind::Objathor {
                match catalogue.model(&entry) {
                    Ok(model) => entry.size = Some(model.size),
                    Err(finding) => {
                        catalogue.refused.push(Refused { file: entry.file, finding: *finding });
                        continue;
                    }
                }
            }
            catalogue.entries.push(entry);
        }
        catalogue.refused.sort_by(|a, b| a.file.cmp(&b.file));
        Ok(catalogue)
    }

    /// The models by their names and cards; none is read.
    pub(crate) fn list(folder: &Path) -> Result<Self, Fault> {
        let door = Door::within(folder);
        let mut catalogue =
            Self { folder: folder.to_owned(), door, entries: Vec::new(), refused: Vec::new(), features: None };
        if let Some(annotations) = objathor::annotations(folder, &catalogue.door) {
            let (objects, wrong) = objathor::objects(folder, annotations, &catalogue.door)?;
            let entry = |o: objathor::Object| Entry {
                file: o.file,
                size: o.card.size,
                card: o.card,
                kind: Kind::Objathor,
                row: None,
            };
            catalogue.entries = objects.into_iter().map(entry).collect();
            catalogue.refused = wrong.into_iter().map(|(file, f)| Refused { file, finding: *f }).collect();
        } else {
            let mut files = Vec::new();
            below(folder, "", 0, &mut files)?;
            files.sort();
            files.into_iter().for_each(|(file, kind)| catalogue.add(file, kind));
        }
        if catalogue.entries.is_empty() && catalogue.refused.is_empty() {
            return Err(fault(codes::E0001, "there is no .glb and no .obj file in it"));
        }
        catalogue.look();
        Ok(catalogue)
    }

    /// Reads the features. Without them, and where they cannot be used, words decide.
    fn look(&mut self) {
        let file = || format!("{}/", features::FOLDER);
        match Features::open(&self.folder, &self.door) {
            Ok(features) => self.features = features,
            Err(finding) => self.refused.push(Refused { file: file(), finding: *finding }),
        }
        let Some(features) = &self.features else { return };
        self.entries.iter_mut().for_each(|entry| entry.row = features.row(entry.name()));
        let missing = self.entries.iter().filter(|entry| entry.row.is_none()).count();
        if missing > 0 {
            let say = format!(
                "{missing} of {} models have no features and are not found by feature search",
                self.entries.len()
            );
            self.refused.push(Refused { file: file(), finding: *features::broken(say) });
        }
    }

    /// Adds a file with its card.
    fn add(&mut self, file: String, kind: Kind) {
        let path = self.folder.join(&file);
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let card = match self.door.read(&path.with_extension("json")) {
            Ok(bytes) if bytes.len() > limits::CARD => {
                Err(beyond(format!("its card {stem}.json is larger than {} MB", limits::CARD >> 20)))
            }
            Ok(bytes) => Card::read(&bytes, &stem),
            Err(e) if matches!(e.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => Ok(Card::of_name(&stem)),
            Err(e) => {
                let mut fault = unreadable(&e);
                fault.message = format!("its card {stem}.json: {}", fault.message);
                Err(fault)
            }
        };
        match card {
            Ok(card) => self.entries.push(Entry { file, size: card.size, card, kind, row: None }),
            Err(finding) => self.refused.push(Refused { file, finding: *finding }),
        }
    }

    /// Reads a model.
    ///
    /// # Errors
    /// The file cannot be read, is not what its format says, or goes beyond the limits.
    pub fn model(&self, entry: &Entry) -> Result<CatalogueModel, Box<Diagnostic>> {
        self.model_of(entry, self.bytes(entry)?)
    }

    /// The file of a model.
    pub(crate) fn bytes(&self, entry: &Entry) -> Result<Vec<u8>, Fault> {
        let bytes = self.door.read(&self.folder.join(&entry.file)).map_err(|e| unreadable(&e))?;
        if bytes.len() > limits::BYTES {
            return Err(beyond(format!("it is {} MB; the maximum is {} MB", bytes.len() >> 20, limits::BYTES >> 20)));
        }
        Ok(bytes)
    }

    pub(crate) fn model_of(&self, entry: &Entry, bytes: Vec<u8>) -> Result<CatalogueModel, Fault> {
        let path = self.folder.join(&entry.file);
        let raw = match entry.kind {
            Kind::Objathor => return objathor::model(&entry.file, entry.card.clone(), bytes),
            Kind::Glb => glb::read(&bytes)?,
            Kind::Obj => obj::read(&bytes, path.parent().unwrap_or(&self.folder), &self.door)?,
        };
        CatalogueModel::new(&entry.file, entry.card.clone(), raw, Axes::RightHanded, Vec::new())
    }
}

/// The models below a folder. What is hidden is passed over; links to folders are not followed.
fn below(folder: &Path, name: &str, depth: usize, files: &mut Vec<(String, Kind)>) -> Result<(), Fault> {
    let found = std::fs::read_dir(folder).map_err(|e| match e.kind() {
        ErrorKind::NotFound => fault(codes::E0001, "there is no such folder"),
        ErrorKind::NotADirectory => fault(codes::E0001, "it is not a folder"),
        _ => unreadable(&e),
    });
    // What may not be looked at further down hides nothing of the rest.
    let found = match found {
        Err(e) if depth == 0 => return Err(e),
        Err(_) => return Ok(()),
        Ok(found) => found,
    };
    for entry in found.flatten() {
        let own = entry.file_name().to_string_lossy().into_owned();
        if own.starts_with('.') {
            continue;
        }
        let file = if name.is_empty() { own } else { format!("{name}/{own}") };
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            if depth < limits::FOLDERS {
                below(&entry.path(), &file, depth + 1, files)?;
            }
            continue;
        }
        let ending = Path::new(&file).extension().map(|e| e.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("glb") => files.push((file, Kind::Glb)),
            Some("obj") => files.push((file, Kind::Obj)),
            _ => continue,
        }
        if files.len() > limits::MODELS {
            return Err(beyond(format!("it has more than {} models", limits::MODELS)));
        }
    }
    Ok(())
}
