//! What a page calls: it asks for memory, writes a request there, and is told where the answer is. Each instance of the
//! module has one session and one thread.
#![allow(unsafe_code, reason = "exported names and pointers that a page hands over are unsafe to Rust")]

use crate::Session;
use std::cell::RefCell;

thread_local! {
    static SESSION: RefCell<Session> = RefCell::default();
    /// The answer to the last request: its length in four bytes, and itself.
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Memory for a request of so many bytes. It belongs to the page until that calls [`scenelang_call`] with it.
#[unsafe(no_mangle)]
pub extern "C" fn scenelang_memory(length: usize) -> *mut u8 {
    Box::into_raw(vec![0_u8; length].into_boxed_slice()).cast()
}

/// Answers a request. The answer stays where it is until the next one.
///
/// # Safety
/// `request` comes from [`scenelang_memory`] with the same length, and has not been handed over before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scenelang_call(request: *mut u8, length: usize) -> *const u8 {
    // SAFETY: the page keeps to what is said above; `playground/src/engine.ts` is the only caller.
    let request = unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(request, length)) };
    let answer = SESSION.with_borrow_mut(|session| session.call(&request));
    ANSWER.with_borrow_mut(|kept| {
        kept.clear();
        kept.extend_from_slice(&(answer.len() as u32).to_le_bytes());
        kept.extend_from_slice(&answer);
        kept.as_ptr()
    })
}
