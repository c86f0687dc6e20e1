//! Requests that are conversations: "User: … Assistant: … User: …". What the other side says asks for nothing, unless it
//! proposes something and the answer is "yes".

use super::token::{Token, WordKind};
use crate::brief::Note;

/// Who asks.
const ASKS: [&str; 7] = ["user", "human", "customer", "client", "me", "guest", "requester"];
/// Who answers.
const ANSWERS: [&str; 9] = ["assistant", "ai", "bot", "system", "agent", "designer", "chatbot", "architect", "planner"];

/// What an answer begins with that takes up a proposal.
const YES: [&str; 11] =
    ["yes", "yeah", "yep", "yup", "sure", "ok", "okay", "absolutely", "definitely", "certainly", "please"];
/// How a proposal begins, before what is proposed.
const PROPOSES: [&[&str]; 20] = [
    &["would", "you", "like", "me", "to"],
    &["do", "you", "want", "me", "to"],
    &["would", "you", "like", "to"],
    &["do", "you", "want", "to"],
    &["want", "me", "to"],
    &["would", "you", "like"],
    &["would", "you", "want"],
    &["do", "you", "want"],
    &["do", "you", "need"],
    &["shall", "i", "also"],
    &["should", "i", "also"],
    &["shall", "i"],
    &["should", "i"],
    &["shall", "we"],
    &["should", "we"],
    &["may", "i"],
    &["can", "i"],
    &["could", "i"],
    &["how", "about"],
    &["what", "about"],
];

/// What is proposed in the last question of an answer; nothing if it leaves a choice.
fn proposal(said: &[Token]) -> Option<(usize, &[Token])> {
    let end = said.len().checked_sub(1).filter(|k| said[*k].is("?"))?;
    let from = said[..end].iter().rposition(Token::stops).map_or(0, |k| k + 1);
    let question = &said[from..end];
    // "Great. Then shall I …", "Sure, what about …"
    let lead = (0..question.len().min(4)).find_map(|skip| {
        let rest = &question[skip..];
        let starts = |words: &&&[&str]| rest.len() > words.len() && words.iter().zip(rest).all(|(w, t)| t.is(w));
        PROPOSES.iter().find(starts).map(|words| skip + words.len())
    });
    let lead = lead?;
    let choice = question.iter().any(|t| t.is("or") || t.is("either"));
    (!choice).then_some((from, &question[lead..]))
}

/// A turn of a conversation: where its label is, and whether it is of one who answers.
type Turn = (usize, bool);

/// The turns of a conversation between those who are known to ask and to answer.
fn known(tokens: &[Token]) -> Vec<Turn> {
    let label = |i: usize| {
        let fresh = match i.checked_sub(1).map(|k| tokens[k].kind) {
            None | Some(WordKind::Line | WordKind::Bullet | WordKind::Sign('.' | '!' | '?' | ';' | '"' | '…')) => {
                true
            }
            Some(_) => false,
        };
        let colon = tokens.get(i + 1).is_some_and(|t| t.is(":"));
        let name = tokens[i].text.as_str();
        (fresh && colon && tokens[i].word() && (ASKS.contains(&name) || ANSWERS.contains(&name)))
            .then(|| ANSWERS.contains(&name))
    };
    let turns: Vec<Turn> = (0..tokens.len()).filter_map(|i| label(i).map(|answers| (i, answers))).collect();
    // "Client: a bank" alone is a heading; a conversation begins with a name, and another follows.
    let asked = turns.iter().any(|(_, answers)| !answers);
    if turns.len() < 2 || !asked { Vec::new() } else { turns }
}

/// The turns of a conversation between two others: their names begin all lines that begin with a name, in turn. If
/// neither name tells, it is the one who says more, without questions, that asks for something.
fn others(tokens: &[Token]) -> Vec<Turn> {
    const LEAST: usize = 4;
    let label = |i: &usize| {
        let fresh = i.checked_sub(1).is_none_or(|k| tokens[k].kind == WordKind::Line);
        fresh && tokens[*i].word() && tokens.get(i + 1).is_some_and(|t| t.is(":"))
    };
    let at: Vec<usize> = (0..tokens.len()).filter(label).collect();
    let [first, second, ..] = at[..] else { return Vec::new() };
    let (first, second) = (tokens[first].text.as_str(), tokens[second].text.as_str());
    let in_turn = |(n, i): (usize, &usize)| tokens[*i].is(if n % 2 == 0 { first } else { second });
    if at.len() < LEAST || first == second || !at.iter().enumerate().all(in_turn) {
        return Vec::new();
    }
    let words = |parity: usize| -> usize {
        let ends = at.iter().skip(1).copied().chain([tokens.len()]);
        let turns = at.iter().zip(ends).skip(parity).step_by(2);
        let sentences = turns.flat_map(|(from, to)| tokens[*from + 2..to].split_inclusive(Token::stops));
        sentences.filter(|s| s.last().is_some_and(|t| !t.is("?"))).map(<[Token]>::len).sum()
    };
    let told = |name: &str| if ASKS.contains(&name) { Some(true) } else { ANSWERS.contains(&name).then_some(false) };
    let first_asks = told(first).or(told(second).map(|asks| !asks)).unwrap_or(words(0) >= words(1));
    at.into_iter().enumerate().map(|(n, i)| (i, (n % 2 == 0) != first_asks)).collect()
}

/// The last room that is named: "And the kitchen?" Its words.
fn room(said: &[Token]) -> Option<&[Token]> {
    (0..said.len()).rev().find_map(|i| {
        let of_several = |n: &usize| i + n <= said.len() && said[i..i + n].iter().all(Token::word);
        (2..=3).rev().chain([1]).filter(of_several).find_map(|n| {
            let phrase = said[i..i + n].iter().map(|t| t.text.as_str()).collect::<Vec<_>>().join(" ");
            let named = super::lexicon::get().room(&phrase).is_some_and(|kind| !kind.loose) && phrase != "room";
            // "the living room", not the room that it ends in.
            let before = i.checked_sub(1).is_some_and(|k| {
                let longer = format!("{} {phrase}", said[k].text);
                super::lexicon::get().room(&longer).is_some()
            });
            // "kitchen corner?": no kitchen.
            let part = said.get(i + n).is_some_and(|t| {
                matches!(t.text.as_str(), "corner" | "area" | "nook" | "zone" | "island" | "counter" | "table" | "sink")
            });
            (named && !before && !part).then(|| &said[i..i + n])
        })
    })
}

/// What a question is about, as the beginning of its answer, and how many words of the answer it takes the place of:
/// "Where is the lamp? It hangs …": the lamp hangs. "Where do coats go? On a rack.": coats go on a rack. "What goes
/// between them? A table.": between them is a table.
fn topic(said: &[Token], answer: &[Token]) -> Option<(Vec<Token>, usize)> {
    let end = said.len().checked_sub(1).filter(|k| said[*k].is("?"))?;
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | '!' | '?' | ';' | ',' | ':'));
    let from = said[..end].iter().rposition(ends).map_or(0, |k| k + 1);
    let lead = said[from..end].iter().take_while(|t| matches!(t.text.as_str(), "and" | "so" | "then")).count();
    let question = &said[from + lead..end];
    if let Some(counted) = counted(question, answer) {
        return Some((counted, OF_THEM));
    }
    let [first, verb, rest @ ..] = question else { return None };
    let lexicon = super::lexicon::get();
    if rest.is_empty() {
        return None;
    }
    let is = Token { kind: WordKind::Word, text: "is".to_owned(), ..verb.clone() };
    match (first.text.as_str(), verb.text.as_str()) {
        ("where", "is" | "are" | "does" | "do" | "should" | "shall" | "will") => {
            let pronoun = matches!(answer.first()?.text.as_str(), "it" | "they" | "that" | "those" | "these");
            let verb = |t: &Token| matches!(t.text.as_str(), "go" | "stand" | "be" | "hang" | "sit");
            let subject = &rest[..rest.len() - usize::from(rest.last().is_some_and(verb))];
            if pronoun {
                return Some((subject.to_vec(), 1));
            }
            lexicon.relation(answer)?;
            let mut out = subject.to_vec();
            out.push(is);
            Some((out, 0))
        }
        ("what", "goes" | "stands" | "is" | "hangs") => {
            let new = matches!(answer.first()?.text.as_str(), "a" | "an") || super::number::count(answer).is_some();
            lexicon.relation(rest).filter(|_| new)?;
            let mut out = rest.to_vec();
            out.push(is);
            Some((out, 0))
        }
        _ => None,
    }
}

/// "Three of them", in words.
const OF_THEM: usize = 3;

/// "And bookshelves? Three of them …": three bookshelves.
fn counted(question: &[Token], answer: &[Token]) -> Option<Vec<Token>> {
    const MOST: usize = 3;
    let [n, of, them, ..] = answer else { return None };
    let is_so = of.is("of") && matches!(them.text.as_str(), "them" | "those" | "these");
    let named = question.len() <= MOST && question.iter().all(Token::word);
    let noun = question.last().filter(|_| is_so && named)?;
    let known = super::lexicon::get().noun(&super::lexicon::singular(&noun.text)).is_some();
    super::number::count(std::slice::from_ref(n)).filter(|_| known)?;
    Some([n].into_iter().chain(question).cloned().collect())
}

/// Takes the names of who speaks out of a conversation, and what is said by those who answer; notes on the latter.
pub fn turns(tokens: &mut Vec<Token>) -> Vec<Note> {
    // Where only one of two names is known, the lines that begin with the other are turns, too.
    let (mut labels, taking_turns) = (known(tokens), others(tokens));
    if taking_turns.len() > labels.len() {
        labels = taking_turns;
    }
    if labels.is_empty() {
        return Vec::new();
    }
    let mut notes = Vec::new();
    let mut kept = tokens[..labels[0].0].to_vec();
    let said_in = |n: usize| {
        let end = labels.get(n + 1).map_or(tokens.len(), |next: &Turn| next.0);
        &tokens[(labels[n].0 + 2).min(end)..end]
    };
    for (n, &(at, answers)) in labels.iter().enumerate() {
        let line = Token { kind: WordKind::Line, text: "\n".to_owned(), ..tokens[at].clone() };
        kept.push(line.clone());
        let said = said_in(n);
        // "Yes, please, and …": the rest of the answer is read.
        let yes =
            if answers { 0 } else { said.iter().take_while(|t| YES.contains(&t.text.as_str()) || t.is(",")).count() };
        let taken = labels.get(n + 1).is_some_and(|(next, answers)| {
            !answers && tokens.get(next + 2).is_some_and(|t| YES.contains(&t.text.as_str()))
        });
        let proposed = proposal(said).filter(|_| answers && taken);
        let (Some(first), Some(last)) = (said.first(), said.last()) else { continue };
        if !answers {
            let asked = n.checked_sub(1).filter(|before| labels[*before].1);
            let mut begins = if asked.is_some() { yes } else { 0 };
            let asked = asked.map_or(&said[..0], said_in);
            let body = asked.iter().rposition(|t| t.kind != WordKind::Line).map_or(0, |k| k + 1);
            if let Some((topic, instead)) = topic(&asked[..body], &said[begins..]) {
                kept.extend(topic);
                begins += instead;
            }
            kept.extend_from_slice(&said[begins..]);
            continue;
        }
        let mut at = first.at.start..last.at.end;
        let mut reason = "this is a reply in a conversation and requests nothing";
        if let Some(room) = room(said).filter(|_| proposed.is_none()) {
            kept.extend_from_slice(room);
            kept.push(Token { kind: WordKind::Sign(':'), text: ":".to_owned(), ..room[room.len() - 1].clone() });
            kept.push(line);
        }
        if let Some((from, asked)) = proposed {
            kept.extend_from_slice(asked);
            kept.push(Token { kind: WordKind::Sign('.'), text: ".".to_owned(), ..last.clone() });
            let Some(before) = from.checked_sub(1) else { continue };
            at = first.at.start..said[before].at.end;
        } else if taken {
            reason = "it is not clear what the answer agrees to";
        }
        notes.push(Note { at, reason: reason.to_owned() });
    }
    *tokens = kept;
    notes
}

/// Leaves out how a request begins that asks for a room: "can you make me a café" is "a café".
pub fn asking(tokens: &mut Vec<Token>) {
    const ASKS: [&str; 38] = [
        "hi", "hello", "please", "can", "could", "would", "will", "you", "i", "we", "i'd", "we'd", "i'm", "we're",
        "need", "want", "like", "love", "to", "make", "create", "design", "build", "give", "generate", "show", "model",
        "me", "us", "have", "get", "looking", "for", "see", "just", "let's", "set", "up",
    ];
    let said = tokens.iter().take_while(|t| t.is(",") || ASKS.iter().any(|word| t.is(word))).count();
    let named = tokens.get(said).is_some_and(|t| matches!(t.text.as_str(), "a" | "an" | "our" | "my" | "this"));
    // "I need to sleep", "we have a dog".
    const VERBS: [&str; 13] = [
        "need", "want", "like", "love", "make", "create", "design", "build", "give", "generate", "show", "model",
        "looking",
    ];
    let asks = tokens[..said].iter().any(|t| VERBS.iter().any(|verb| t.is(verb)));
    if named && asks {
        tokens.drain(..said);
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn only_who_asks_is_read() {
        for (text, left, notes) in [
            ("User: a bed. Assistant: Sure, a lamp? User: No.", "a bed . no .", 1),
            ("Client: a bank\nRoom: a hall", "client : a bank room : a hall", 0),
            ("A desk. Assistant: fine.", "a desk . assistant : fine .", 0),
            ("User: a bed.\nUser: a desk.", "a bed . a desk .", 0),
            ("User: a bed. Assistant: Shall I add a lamp? User: Yes.", "a bed . add a lamp . .", 0),
            ("User: a bed. AI: Nice. How about a rug? User: Sure, a red one.", "a bed . a rug . a red one .", 1),
            ("User: a bed. AI: A rug or a mat? User: Yes.", "a bed . .", 1),
            ("User: a bed. AI: Shall I add a lamp? User: No.", "a bed . no .", 1),
            ("Ann: a bed.\nBob: Where is the lamp?\nAnn: It hangs.\nBob: Bye.", "a bed . the lamp hangs .", 2),
            ("Jo: a bed.\nAl: What goes beside it?\nJo: A rug.\nAl: ok", "a bed . beside it is a rug .", 2),
            ("Jo: a hall, a bar.\nAl: And the kitchen?\nJo: A hob.\nAl: ok", "a hall , a bar . kitchen : a hob .", 2),
            ("Jo: a bed.\nAl: And lamps?\nJo: Two of them, on a desk.\nAl: ok", "a bed . two lamps , on a desk .", 2),
            ("Rep: Hi.\nClient: a bed.\nRep: Mirrors?\nClient: No.", "a bed . no .", 2),
            ("Bed: oak\nDesk: pine\nBed: big", "bed : oak desk : pine bed : big", 0),
        ] {
            let mut tokens = tokens(text, 100).0;
            assert_eq!(turns(&mut tokens).len(), notes, "{text}");
            let words: Vec<&str> =
                tokens.iter().filter(|t| t.kind != WordKind::Line).map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), left, "{text}");
        }
    }
}
