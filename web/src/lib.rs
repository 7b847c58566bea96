//! Roomwright as WebAssembly: a plan goes in, and the answers of `roomwright view` come out.
//!
//! Plain functions with numbers, so that no generated binding is needed. The caller allocates texts, hands them over by place and
//! length, and frees them; an answer stays where it is until the next call. Statuses are those of HTTP.

// Places and lengths from outside are what this crate is for; all of it is here.
#![allow(unsafe_code)]

use std::cell::RefCell;

use roomwright::internals::view::PlanPage;

/// What the module holds: it runs on one thread.
#[derive(Default)]
struct State {
    page: Option<PlanPage>,
    answer: Vec<u8>,
}

thread_local! {
    static STATE: RefCell<State> = RefCell::default();
}

const FOUND: u32 = 200;
const NOT_FOUND: u32 = 404;
const REFUSED: u32 = 422;

/// Memory for a text.
#[unsafe(no_mangle)]
pub extern "C" fn roomwright_allocate(bytes: usize) -> *mut u8 {
    let memory = vec![0_u8; bytes].into_boxed_slice();
    Box::into_raw(memory).cast()
}

/// Gives the memory of a text back.
///
/// # Safety
/// The memory comes from [`roomwright_allocate`] with this length, and is given back once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn roomwright_free(memory: *mut u8, bytes: usize) {
    // SAFETY: that of the caller.
    drop(unsafe { Box::from_raw(core::ptr::slice_from_raw_parts_mut(memory, bytes)) });
}

/// Opens a plan in YAML or JSON; 422 with its faults as the answer where nothing of it can be read. A seed that is no whole number
/// from 0 on is none: then the plan's own or 1 is taken.
///
/// # Safety
/// Each place and length is a text that lives as long as the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn roomwright_open(
    name: *const u8,
    name_bytes: usize,
    text: *const u8,
    text_bytes: usize,
    seed: f64,
) -> u32 {
    // SAFETY: that of the caller.
    let (name, text) = unsafe { (text_at(name, name_bytes), text_at(text, text_bytes)) };
    let seed = (seed >= 0.0 && seed.fract() == 0.0 && seed < 9_007_199_254_740_992.0).then_some(seed as u64);
    let (status, page, answer) = match PlanPage::open(&name, &text, seed) {
        Ok(page) => (FOUND, Some(page), Vec::new()),
        Err(faults) => (REFUSED, None, faults.into_bytes()),
    };
    STATE.set(State { page, answer });
    status
}

/// Answers a question as the server of `roomwright view` does: an address below its token, and a body.
///
/// # Safety
/// Each place and length is a text that lives as long as the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn roomwright_ask(
    address: *const u8,
    address_bytes: usize,
    body: *const u8,
    body_bytes: usize,
) -> u32 {
    // SAFETY: that of the caller.
    let (address, body) = unsafe { (text_at(address, address_bytes), text_at(body, body_bytes)) };
    answered(|page| {
        let (status, answer) = page.ask(&address, &body);
        (u32::from(status), answer)
    })
}

/// All rooms of a level as one binary glTF file, the one that a bake writes.
///
/// # Safety
/// Each place and length is a text that lives as long as the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn roomwright_level(
    building: *const u8,
    building_bytes: usize,
    level: *const u8,
    level_bytes: usize,
) -> u32 {
    // SAFETY: that of the caller.
    let (building, level) = unsafe { (text_at(building, building_bytes), text_at(level, level_bytes)) };
    answered(|page| match page.level_glb(&building, &level) {
        Ok(file) => (FOUND, file),
        Err(error) => (NOT_FOUND, error.into_bytes()),
    })
}

/// Where the answer of the last call is.
#[unsafe(no_mangle)]
pub extern "C" fn roomwright_answer() -> *const u8 {
    STATE.with_borrow(|state| state.answer.as_ptr())
}

/// Bytes of the answer of the last call.
#[unsafe(no_mangle)]
pub extern "C" fn roomwright_answer_length() -> usize {
    STATE.with_borrow(|state| state.answer.len())
}

fn answered(ask: impl FnOnce(&PlanPage) -> (u32, Vec<u8>)) -> u32 {
    STATE.with_borrow_mut(|state| {
        let nothing = || (NOT_FOUND, b"no plan is open".to_vec());
        let (status, answer) = state.page.as_ref().map_or_else(nothing, ask);
        state.answer = answer;
        status
    })
}

/// A text of the caller; what is no UTF-8 in it is replaced.
///
/// # Safety
/// Place and length are memory that may be read.
unsafe fn text_at(place: *const u8, bytes: usize) -> String {
    // SAFETY: that of the caller.
    let bytes = unsafe { core::slice::from_raw_parts(place, bytes) };
    String::from_utf8_lossy(bytes).into_owned()
}
