//! Data in files of Python's `pickle`, protocols 2 to 5: numbers, texts, lists, dictionaries and arrays of NumPy.
//!
//! A pickle is a program for a stack machine that can call any Python function. Here nothing is called: what a call would
//! return is kept as the name of the function with its arguments, and only NumPy's arrays and numbers are interpreted. All
//! values are in one list and refer to each other by their place in it, so shared values are never copied, and deep nesting
//! cannot exhaust the stack.

use crate::limits;
use crate::npy::{Array, Kind};
use rustc_hash::FxHashMap;
use serde_json::{Map, Number, Value};
use std::borrow::Cow;

/// The place of a value in the list of a pickle.
pub(crate) type Id = usize;

#[derive(Debug)]
enum Node<'a> {
    None,
    Bool(bool),
    Int(i64),
    Float(f64),
    Text(&'a str),
    Bytes(&'a [u8]),
    List(Vec<Id>),
    Dict(Vec<(Id, Id)>),
    /// A function or a class: its module and its name.
    Name(&'a str, &'a str),
    /// What a call would return, and the state that it would be given.
    Called {
        what: Id,
        with: Id,
        state: Option<Id>,
    },
}

/// A file, taken apart.
#[derive(Debug)]
pub(crate) struct Pickle<'a> {
    nodes: Vec<Node<'a>>,
    pub root: Id,
}

/// Whether bytes begin like a pickle of a protocol that is read.
pub(crate) fn is_pickle(bytes: &[u8]) -> bool {
    matches!(bytes, [0x80, 2..=5, ..])
}

impl<'a> Pickle<'a> {
    /// Takes a file apart.
    ///
    /// # Errors
    /// What is wrong with it, to be said after its name.
    pub fn read(bytes: &'a [u8]) -> Result<Self, String> {
        if !is_pickle(bytes) {
            return Err("it is not a pickle of protocol 2 to 5".to_owned());
        }
        let mut machine = Machine { rest: &bytes[2..], ..Machine::default() };
        while machine.step()? {}
        let root = machine.stack.pop().ok_or("it contains no value")?;
        Ok(Self { nodes: machine.nodes, root })
    }

    /// The value of a text key in a dictionary.
    pub fn get(&self, dict: Id, key: &str) -> Option<Id> {
        let Node::Dict(items) = &self.nodes[dict] else { return None };
        items.iter().rev().find(|(k, _)| self.text(*k) == Some(key)).map(|(_, value)| *value)
    }

    fn text(&self, id: Id) -> Option<&'a str> {
        match self.nodes[id] {
            Node::Text(text) => Some(text),
            _ => None,
        }
    }

    fn int(&self, id: Id) -> Option<usize> {
        match self.nodes[id] {
            Node::Int(number) => usize::try_from(number).ok(),
            _ => None,
        }
    }

    fn list(&self, id: Id) -> Option<&[Id]> {
        match &self.nodes[id] {
            Node::List(items) => Some(items),
            _ => None,
        }
    }

    /// A list of texts.
    pub fn texts(&self, id: Id) -> Option<Vec<String>> {
        self.list(id)?.iter().map(|item| self.text(*item).map(str::to_owned)).collect()
    }

    /// Bytes, also as Python 3 writes them in protocol 2: as a text that is to be encoded in Latin-1.
    fn bytes(&self, id: Id) -> Option<Cow<'a, [u8]>> {
        match &self.nodes[id] {
            Node::Bytes(bytes) => Some(Cow::Borrowed(bytes)),
            Node::Called { with, .. } => {
                let (("_codecs", "encode"), [text, ..]) = (self.called(id)?, self.list(*with)?) else { return None };
                self.text(*text)?
                    .chars()
                    .map(|c| u8::try_from(u32::from(c)).ok())
                    .collect::<Option<Vec<u8>>>()
                    .map(Cow::Owned)
            }
            _ => None,
        }
    }

    /// Which function a value is the result of.
    fn called(&self, id: Id) -> Option<(&'a str, &'a str)> {
        match self.nodes[id] {
            Node::Called { what, .. } => match self.nodes[what] {
                Node::Name(module, name) => Some((module, name)),
                _ => None,
            },
            _ => None,
        }
    }

    /// The same data as JSON. Bytes and what Python functions return are null, except numbers of NumPy.
    ///
    /// # Errors
    /// It is nested too deeply or, with all shared values copied, too large.
    pub fn json(&self) -> Result<Value, String> {
        self.value(self.root, limits::DEPTH, &mut { limits::VALUES })
    }

    fn value(&self, id: Id, depth: usize, left: &mut usize) -> Result<Value, String> {
        let depth = depth.checked_sub(1).ok_or("it is nested too deeply")?;
        *left = left.checked_sub(1).ok_or_else(too_many)?;
        let float = |x| Number::from_f64(x).map_or(Value::Null, Value::Number);
        Ok(match &self.nodes[id] {
            Node::None | Node::Bytes(_) | Node::Name(..) => Value::Null,
            Node::Bool(is) => Value::Bool(*is),
            Node::Int(number) => Value::Number((*number).into()),
            Node::Float(x) => float(*x),
            Node::Text(text) => Value::String((*text).to_owned()),
            Node::List(items) => {
                Value::Array(items.iter().map(|item| self.value(*item, depth, left)).collect::<Result<_, _>>()?)
            }
            Node::Dict(items) => {
                let mut map = Map::new();
                for (key, value) in items {
                    if let Some(key) = self.text(*key) {
                        map.insert(key.to_owned(), self.value(*value, depth, left)?);
                    }
                }
                Value::Object(map)
            }
            Node::Called { .. } => self.scalar(id).map_or(Value::Null, float),
        })
    }

    /// A number of NumPy: `scalar(dtype, bytes)`.
    fn scalar(&self, id: Id) -> Option<f64> {
        let Node::Called { with, .. } = self.nodes[id] else { return None };
        let (("numpy.core.multiarray" | "numpy._core.multiarray", "scalar"), [dtype, bytes]) =
            (self.called(id)?, self.list(with)?)
        else {
            return None;
        };
        let number = self.dtype(*dtype).ok()?.numbers(&self.bytes(*bytes)?).first().copied()?;
        Some(f64::from(number))
    }

    /// An array of NumPy.
    ///
    /// # Errors
    /// It is none, or none of those that are supported.
    pub fn array(&self, id: Id) -> Result<Array, String> {
        let none = || "it is not an array of NumPy".to_owned();
        let Node::Called { with, state, .. } = self.nodes[id] else { return Err(none()) };
        let (dtype, shape, bytes, is_fortran) = match (self.called(id).ok_or_else(none)?, state) {
            // The state is (version, shape, dtype, is in Fortran order, bytes).
            (("numpy.core.multiarray" | "numpy._core.multiarray", "_reconstruct"), Some(state)) => {
                let Some([_, shape, dtype, fortran, bytes]) = self.list(state) else { return Err(none()) };
                (*dtype, *shape, *bytes, !matches!(self.nodes[*fortran], Node::Bool(false)))
            }
            // Protocol 5: `_frombuffer(bytes, dtype, shape, order)`.
            (("numpy.core.numeric" | "numpy._core.numeric", "_frombuffer"), _) => {
                let Some([bytes, dtype, shape, order]) = self.list(with) else { return Err(none()) };
                (*dtype, *shape, *bytes, self.text(*order) != Some("C"))
            }
            _ => return Err(none()),
        };
        if is_fortran {
            return Err("it is in Fortran order; use numpy.ascontiguousarray(array)".to_owned());
        }
        let shape = self.list(shape).and_then(|s| s.iter().map(|extent| self.int(*extent)).collect::<Option<Vec<_>>>());
        Array::new(self.dtype(dtype)?, shape.ok_or_else(none)?, &self.bytes(bytes).ok_or_else(none)?)
    }

    /// How the numbers of an array are written: `dtype(name, …)` with the state `(version, byte order, …)`.
    fn dtype(&self, id: Id) -> Result<Kind, String> {
        let unknown = || "its type of number is not known".to_owned();
        let Node::Called { with, state, .. } = self.nodes[id] else { return Err(unknown()) };
        let ("numpy", "dtype") = self.called(id).ok_or_else(unknown)? else { return Err(unknown()) };
        let name = self.list(with).and_then(|a| self.text(*a.first()?)).ok_or_else(unknown)?;
        let order = state.and_then(|s| self.text(*self.list(s)?.get(1)?)).unwrap_or("<");
        Kind::named(&format!("{order}{name}"))
    }
}

fn too_many() -> String {
    format!("it contains more than {} values", limits::VALUES)
}

/// The machine that a pickle is written for.
#[derive(Default)]
struct Machine<'a> {
    rest: &'a [u8],
    nodes: Vec<Node<'a>>,
    stack: Vec<Id>,
    /// How high the stack was at each mark.
    marks: Vec<usize>,
    memo: FxHashMap<usize, Id>,
    /// How many values were put on the stack.
    pushed: usize,
}

impl<'a> Machine<'a> {
    /// Carries out one instruction; `false` at the end.
    fn step(&mut self) -> Result<bool, String> {
        let [code] = self.fixed()?;
        match code {
            b'.' => return Ok(false),
            // A frame only says how much comes next.
            0x95 => drop(self.fixed::<8>()?),
            b'(' => self.marks.push(self.stack.len()),
            b'0' => drop(self.pop()?),
            b'1' => drop(self.marked()?),
            b'2' => {
                let top = self.top()?;
                self.refer(top)?;
            }
            b'N' => self.push(Node::None)?,
            0x88 | 0x89 => self.push(Node::Bool(code == 0x88))?,
            b'K' | b'M' | b'J' | 0x8a | 0x8b | b'G' => self.number(code)?,
            b'X' | 0x8c | 0x8d | b'B' | b'C' | 0x8e | 0x96 | b'U' | b'T' => self.string(code)?,
            b']' | b')' => self.push(Node::List(Vec::new()))?,
            b'}' => self.push(Node::Dict(Vec::new()))?,
            b'l' | b't' => {
                let items = self.marked()?;
                self.push(Node::List(items))?;
            }
            0x85..=0x87 => {
                let items = self.last(usize::from(code - 0x84))?;
                self.push(Node::List(items))?;
            }
            b'd' => {
                let items = pairs(&self.marked()?)?;
                self.push(Node::Dict(items))?;
            }
            b'a' | b'e' | b's' | b'u' => self.add(code)?,
            b'q' | b'r' | 0x94 | b'h' | b'j' => self.remember(code)?,
            b'c' | 0x93 | b'R' | 0x81 | b'b' => self.call(code)?,
            _ => return Err(format!("its instruction 0x{code:02x} is not supported")),
        }
        Ok(true)
    }

    fn number(&mut self, code: u8) -> Result<(), String> {
        let node = match code {
            b'K' => Node::Int(self.fixed::<1>()?[0].into()),
            b'M' => Node::Int(u16::from_le_bytes(self.fixed()?).into()),
            b'J' => Node::Int(i32::from_le_bytes(self.fixed()?).into()),
            b'G' => Node::Float(f64::from_be_bytes(self.fixed()?)),
            _ => {
                let count = if code == 0x8a { self.fixed::<1>()?[0].into() } else { self.length::<4>()? };
                let digits = self.take(count)?;
                let sign = if digits.last().is_some_and(|b| b & 0x80 > 0) { 0xff } else { 0 };
                if digits.iter().skip(8).any(|b| *b != sign) {
                    return Err("it contains an integer of more than 64 bits".to_owned());
                }
                let mut wide = [sign; 8];
                wide[..count.min(8)].copy_from_slice(&digits[..count.min(8)]);
                Node::Int(i64::from_le_bytes(wide))
            }
        };
        self.push(node)
    }

    fn string(&mut self, code: u8) -> Result<(), String> {
        let count = match code {
            0x8c | b'C' | b'U' => self.fixed::<1>()?[0].into(),
            b'X' | b'B' | b'T' => self.length::<4>()?,
            _ => self.length::<8>()?,
        };
        let bytes = self.take(count)?;
        let is_text = matches!(code, b'X' | 0x8c | 0x8d);
        match std::str::from_utf8(bytes) {
            Ok(text) if is_text => self.push(Node::Text(text)),
            Err(_) if is_text => Err("it contains a text that is not valid UTF-8".to_owned()),
            _ => self.push(Node::Bytes(bytes)),
        }
    }

    /// Adds items to the list or the dictionary below them.
    fn add(&mut self, code: u8) -> Result<(), String> {
        let items = match code {
            b'a' => self.last(1)?,
            b's' => self.last(2)?,
            _ => self.marked()?,
        };
        let to = self.top()?;
        match (&mut self.nodes[to], code) {
            (Node::List(list), b'a' | b'e') => list.extend(items),
            (Node::Dict(dict), b's' | b'u') => dict.extend(pairs(&items)?),
            _ => return Err("it adds something to a value that is neither a list nor a dictionary".to_owned()),
        }
        Ok(())
    }

    fn remember(&mut self, code: u8) -> Result<(), String> {
        let place = match code {
            b'q' | b'h' => self.fixed::<1>()?[0].into(),
            b'r' | b'j' => self.length::<4>()?,
            _ => self.memo.len(),
        };
        if matches!(code, b'h' | b'j') {
            let id = *self.memo.get(&place).ok_or("it refers to a value that it does not have")?;
            self.refer(id)?;
        } else {
            self.memo.insert(place, self.top()?);
        }
        Ok(())
    }

    /// Notes a name, a call or a state.
    fn call(&mut self, code: u8) -> Result<(), String> {
        match code {
            b'c' => {
                let (module, name) = (self.line()?, self.line()?);
                self.push(Node::Name(module, name))
            }
            0x93 => match self.last(2)?[..] {
                [module, name] => match (&self.nodes[module], &self.nodes[name]) {
                    (Node::Text(module), Node::Text(name)) => self.push(Node::Name(module, name)),
                    _ => Err("it has a name that is not a text".to_owned()),
                },
                _ => Err(early()),
            },
            b'b' => {
                let given = self.pop()?;
                let to = self.top()?;
                if let Node::Called { state, .. } = &mut self.nodes[to] {
                    *state = Some(given);
                }
                Ok(())
            }
            _ => {
                let (with, what) = (self.pop()?, self.pop()?);
                self.push(Node::Called { what, with, state: None })
            }
        }
    }

    fn push(&mut self, node: Node<'a>) -> Result<(), String> {
        self.nodes.push(node);
        self.refer(self.nodes.len() - 1)
    }

    /// Puts a value on the stack.
    fn refer(&mut self, id: Id) -> Result<(), String> {
        self.pushed += 1;
        self.stack.push(id);
        if self.pushed > limits::VALUES { Err(too_many()) } else { Ok(()) }
    }

    fn top(&self) -> Result<Id, String> {
        self.stack.last().copied().ok_or_else(early)
    }

    fn pop(&mut self) -> Result<Id, String> {
        self.stack.pop().ok_or_else(early)
    }

    /// The last values of the stack.
    fn last(&mut self, count: usize) -> Result<Vec<Id>, String> {
        let at = self.stack.len().checked_sub(count).ok_or_else(early)?;
        Ok(self.stack.split_off(at))
    }

    /// The values after the last mark.
    fn marked(&mut self) -> Result<Vec<Id>, String> {
        let at = self.marks.pop().filter(|at| *at <= self.stack.len()).ok_or_else(early)?;
        Ok(self.stack.split_off(at))
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], String> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or("it ends early")?;
        self.rest = rest;
        Ok(taken)
    }

    fn fixed<const N: usize>(&mut self) -> Result<[u8; N], String> {
        self.take(N)?.try_into().map_err(|_| "it ends early".to_owned())
    }

    /// A length of so many bytes.
    fn length<const N: usize>(&mut self) -> Result<usize, String> {
        let mut wide = [0; 8];
        wide[..N].copy_from_slice(&self.fixed::<N>()?);
        usize::try_from(u64::from_le_bytes(wide)).map_err(|_| "it ends early".to_owned())
    }

    fn line(&mut self) -> Result<&'a str, String> {
        let end = self.rest.iter().position(|b| *b == b'\n').ok_or("it ends early")?;
        let line = self.take(end + 1)?;
        std::str::from_utf8(&line[..end]).map_err(|_| "it has a name that is not valid UTF-8".to_owned())
    }
}

/// An instruction that needs more values than there are.
fn early() -> String {
    "it has an instruction for a value that is not there".to_owned()
}

fn pairs(items: &[Id]) -> Result<Vec<(Id, Id)>, String> {
    let whole = items.len().is_multiple_of(2);
    let pairs = items.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
    whole.then_some(pairs).ok_or_else(|| "it has a dictionary with a key without a value".to_owned())
}
