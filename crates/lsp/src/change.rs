//! A change of the workspace, as the protocol has it. The types of the protocol's library would do, but for two things: they
//! list files in no fixed order, and an edit with an annotation is another type than one without.

use serde::Serialize;
use std::collections::BTreeMap;
use tower_lsp::ls_types::{ChangeAnnotation, Range, RenameFile, RenameFileOptions, ResourceOp, Uri};

/// The one annotation that a change has.
const ANNOTATION: &str = "change";

/// Another text for a part of a document.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct TextChange {
    pub range: Range,
    pub new_text: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    annotation_id: Option<&'static str>,
}

impl TextChange {
    pub fn new(range: Range, new_text: String) -> Self {
        Self { range, new_text, annotation_id: None }
    }
}

/// `WorkspaceEdit`
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct WorkspaceChange {
    #[serde(flatten)]
    files: Changed,
    #[serde(skip_serializing_if = "Option::is_none")]
    change_annotations: Option<BTreeMap<&'static str, ChangeAnnotation>>,
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
enum Changed {
    /// For clients that know no versions, by address.
    Changes(BTreeMap<String, Vec<TextChange>>),
    DocumentChanges(Vec<Operation>),
}

#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
enum Operation {
    #[serde(rename_all = "camelCase")]
    Edit {
        text_document: Document,
        edits: Vec<TextChange>,
    },
    File(ResourceOp),
}

#[derive(Clone, Debug, Serialize)]
struct Document {
    /// `None`: it is not open.
    version: Option<i32>,
    uri: String,
}

impl WorkspaceChange {
    /// Edits by address, with versions if the client knows these.
    pub fn new(by_file: BTreeMap<String, Vec<TextChange>>, versions: Option<&BTreeMap<String, i32>>) -> Self {
        let files = match versions {
            None => Changed::Changes(by_file),
            Some(versions) => {
                let operation = |(uri, edits): (String, Vec<TextChange>)| Operation::Edit {
                    text_document: Document { version: versions.get(&uri).copied(), uri },
                    edits,
                };
                Changed::DocumentChanges(by_file.into_iter().map(operation).collect())
            }
        };
        Self { files, change_annotations: None }
    }

    /// Renames a file, too; only clients that know versions know how.
    pub fn rename(&mut self, old_uri: Uri, new_uri: Uri) {
        if let Changed::DocumentChanges(list) = &mut self.files {
            let options = RenameFileOptions { overwrite: None, ignore_if_exists: Some(true) };
            let rename = RenameFile { old_uri, new_uri, options: Some(options), annotation_id: None };
            list.push(Operation::File(ResourceOp::Rename(rename)));
        }
    }

    /// Whether the client gets versions with the edits.
    pub fn has_versions(&self) -> bool {
        matches!(self.files, Changed::DocumentChanges(_))
    }

    /// Says what the change does, for clients that show that before it is made.
    pub fn annotate(&mut self, annotation: ChangeAnnotation) {
        match &mut self.files {
            Changed::Changes(files) => files.values_mut().flatten().for_each(TextChange::annotate),
            Changed::DocumentChanges(list) => {
                for operation in list {
                    if let Operation::Edit { edits, .. } = operation {
                        edits.iter_mut().for_each(TextChange::annotate);
                    }
                }
            }
        }
        self.change_annotations = Some(BTreeMap::from([(ANNOTATION, annotation)]));
    }

    /// Has the client ask before it makes the change, if that says what it does.
    pub fn ask_first(&mut self) {
        let annotations = self.change_annotations.iter_mut().flat_map(BTreeMap::values_mut);
        annotations.for_each(|annotation| annotation.needs_confirmation = Some(true));
    }
}

impl TextChange {
    fn annotate(&mut self) {
        self.annotation_id = Some(ANNOTATION);
    }
}
