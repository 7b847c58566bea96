//! Catches faults of the program itself, so that one bad room does not stop a city.

use std::cell::{Cell, RefCell};
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};

thread_local! {
    static IS_CATCHING: Cell<bool> = const { Cell::new(false) };
    static CAUGHT: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Runs `work`; if it panics, says what happened and, after [`collect_panics`], where.
pub(crate) fn catch_bug<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    let was_catching = IS_CATCHING.replace(true);
    // Values that `work` was changing are dropped with it; shared state is behind locks that are never held here.
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    IS_CATCHING.set(was_catching);
    result.map_err(|payload| {
        let place = CAUGHT.take();
        place.unwrap_or_else(|| message(payload.as_ref()).to_owned())
    })
}

/// Makes panics that a bake catches silent and remembers their place; all others are shown as ever.
///
/// For programs: a library does not change how its host reports panics.
pub fn collect_panics() {
    let default = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        if IS_CATCHING.get() {
            CAUGHT.set(Some(describe(info)));
        } else {
            default(info);
        }
    }));
}

fn describe(info: &PanicHookInfo<'_>) -> String {
    let message = message(info.payload());
    info.location().map_or_else(|| message.to_owned(), |place| format!("{message} ({place})"))
}

fn message(payload: &(dyn std::any::Any + Send)) -> &str {
    payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("no message")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_its_message() {
        let caught = catch_bug(|| -> u32 { panic!("chair {} has no legs", 7) });
        assert!(caught.unwrap_err().starts_with("chair 7 has no legs"));
        assert_eq!(catch_bug(|| 3), Ok(3));
    }
}
