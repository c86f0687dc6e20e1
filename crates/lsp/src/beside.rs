//! A room in a browser beside an editor that has no panel for it: who shows it, and what is selected there as the cursor
//! moves. The protocol has no cursor, but editors ask about the place where it is.

use crate::dispatch::{Fault, params, sent};
use crate::state::{Event, State, guarded};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::path::Path;
use tower_lsp::jsonrpc::Id;
use tower_lsp::ls_types::{MessageType, Position, ShowMessageParams, Uri};

/// Shows the room of a program or a layout.
pub type Show = fn(&Path) -> Result<Beside, String>;

/// A room that is shown; it is gone when this is.
pub struct Beside {
    /// Where a browser finds it.
    pub address: String,
    /// Selects an object by name, or a row of the report by its id; false: nobody shows the room any more.
    pub select: Box<dyn FnMut(&str) -> bool + Send>,
}

/// What `scenelang.view` answers.
#[derive(Serialize)]
struct Viewed {
    /// Where the room is shown, in a sentence.
    message: String,
}

#[derive(Deserialize)]
struct Of {
    uri: Option<Uri>,
}

/// Where a client asks about a place: what all such requests have.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Asked {
    text_document: Document,
    position: Position,
}

#[derive(Deserialize)]
struct Document {
    uri: Uri,
}

impl State {
    /// `scenelang.view`: shows the room of a program or, if none is named, of the one that was asked about last.
    ///
    /// # Errors
    /// Nobody can show it.
    pub fn view(&mut self, id: &Id, argument: Value) -> Result<(), Fault> {
        let named = if argument.is_null() { None } else { params::<Of>(argument)?.uri };
        let named = named.map(|uri| uri.as_str().to_owned()).or_else(|| self.cursor.clone());
        let only = || self.documents.iter().find(|d| d.scene.is_some()).map(|d| d.uri.as_str().to_owned());
        let uri = named.or_else(only).ok_or_else(|| Fault::Failed("no program is open".to_owned()))?;
        let show = self.show.ok_or_else(|| Fault::Failed("this server cannot show rooms".to_owned()))?;
        let context = self.context(&uri);
        let context = context.ok_or_else(|| Fault::Invalid(format!("the program is not open: {uri}")))?;
        let layout = context.layout.filter(|path| path.exists());
        let (path, id, events) = (layout.unwrap_or(context.path), id.clone(), self.events());
        std::thread::spawn(move || {
            let shown = show(&path).map_err(Fault::Failed);
            let _ = events.send(Event::Done(Box::new(move |state: &mut State| {
                let answer = shown.and_then(|shown| {
                    let message = format!("the room is shown at {}", shown.address);
                    state.beside.insert(uri, shown);
                    // Not every editor shows what a command answers.
                    let told = ShowMessageParams { typ: MessageType::INFO, message: message.clone() };
                    state.tell("window/showMessage", told);
                    sent(Viewed { message })
                });
                state.reply(&id, answer);
            })));
        });
        Ok(())
    }

    /// Has what the cursor is on selected in the room beside, if there is one.
    pub fn follow(&mut self, method: &str, given: &Value) {
        if !matches!(method, "textDocument/documentHighlight" | "textDocument/hover" | "textDocument/definition") {
            return;
        }
        let Ok(Asked { text_document: Document { uri }, position }) = Asked::deserialize(given) else { return };
        let uri = uri.as_str().to_owned();
        self.cursor = Some(uri.clone());
        if !self.beside.contains_key(&uri) {
            return;
        }
        let Some(context) = self.context(&uri) else { return };
        let events = self.events();
        self.in_background(move || {
            let about = context.layout.as_ref().unwrap_or(&context.path).display().to_string();
            let found =
                guarded(|| Ok(scenelang_ide::spoken::spoken(&context.snapshot, context.offset(position), &about)?));
            drop(context);
            let Ok(Some(what)) = found else { return };
            let _ = events.send(Event::Done(Box::new(move |state: &mut State| {
                let gone = state.beside.get_mut(&uri).is_some_and(|shown| !(shown.select)(&what));
                if gone {
                    state.beside.remove(&uri);
                }
            })));
        });
    }
}
