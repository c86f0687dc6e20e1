//! Reading a file that may be anything: a pipe that nobody writes, a device without end, a file that grows.

use std::fs::{File, Metadata, OpenOptions};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// Larger files are not read (bytes).
pub const MOST: u64 = 64 << 20;
/// The same for files of numbers: GLB, which holds meshes and pictures, and the arrays of NumPy.
const MOST_NUMBERS: u64 = 512 << 20;
const NUMBERS: [&str; 2] = ["glb", "npy"];

/// The bytes of a regular file; `path` has no links in it.
pub fn regular(path: &Path) -> io::Result<Vec<u8>> {
    // Some devices do something when they are opened.
    refuse(&path.metadata()?)?;
    let file = open(path)?;
    // What was looked at may have been replaced; what is open is what is read.
    let data = file.metadata()?;
    refuse(&data)?;
    let numbers = path.extension().is_some_and(|e| NUMBERS.iter().any(|known| e.eq_ignore_ascii_case(known)));
    let most = if numbers { MOST_NUMBERS } else { MOST };
    let large = || io::Error::new(ErrorKind::FileTooLarge, format!("more than {} MB is not read", most >> 20));
    if data.len() > most {
        return Err(large());
    }
    let mut bytes = Vec::with_capacity(usize::try_from(data.len()).unwrap_or(0));
    file.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(large()) } else { Ok(bytes) }
}

#[cfg(unix)]
fn open(path: &Path) -> io::Result<File> {
    use rustix::fs::OFlags;
    use std::os::unix::fs::OpenOptionsExt;
    // Opening a pipe waits for somebody who writes it, unless told not to.
    let flags = OFlags::NONBLOCK | OFlags::NOCTTY | OFlags::NOFOLLOW;
    OpenOptions::new().read(true).custom_flags(flags.bits().cast_signed()).open(path)
}

#[cfg(not(unix))]
fn open(path: &Path) -> io::Result<File> {
    OpenOptions::new().read(true).open(path)
}

/// Refuses what is not a regular file.
fn refuse(data: &Metadata) -> io::Result<()> {
    let kind = data.file_type();
    if kind.is_file() {
        return Ok(());
    }
    if kind.is_dir() {
        return Err(io::Error::new(ErrorKind::IsADirectory, "it is a directory"));
    }
    Err(io::Error::new(ErrorKind::InvalidInput, format!("it is {}, not a regular file", special(data))))
}

#[cfg(unix)]
fn special(data: &Metadata) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    let kind = data.file_type();
    match () {
        () if kind.is_fifo() => "a pipe",
        () if kind.is_socket() => "a socket",
        () if kind.is_char_device() || kind.is_block_device() => "a device",
        () => "something else",
    }
}

#[cfg(not(unix))]
fn special(_: &Metadata) -> &'static str {
    "something else"
}
