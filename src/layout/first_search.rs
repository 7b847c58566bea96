//! Searches that the attempts at a room share.

use super::environment::Environment;
use super::known::{Found, Known};

/// Lets `take` choose of what the first attempt at a room finds: what is known, or what `search` finds now. Only for searches that
/// all attempts begin in the same room.
pub(crate) fn of_first_search<'a, T, R>(
    environment: &mut Environment<'a>,
    known: &Known<T>,
    search: impl FnOnce(&mut Environment<'a>) -> Found<T>,
    take: impl FnOnce(&Environment<'a>, &[T]) -> R,
) -> R {
    let before = environment.steps();
    let noted;
    let found = if environment.trace.is_some() {
        // Found once more, for the notes of what the agents meet.
        noted = search(environment);
        &noted
    } else {
        known.get_or_init(|| search(environment))
    };
    // As many as if it was searched for: what comes of a room does not depend on what was made of it before.
    environment.count_steps(before + found.steps - environment.steps());
    take(environment, &found.best_first)
}
