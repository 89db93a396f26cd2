//! Catching a panic of a reader.

use std::any::Any;
use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

thread_local! {
    /// Whether this thread's panics are being caught, so that they are not printed.
    static CONTAINED: Cell<bool> = const { Cell::new(false) };
}

/// Runs the work, or returns the message of its panic. That panic is not printed; panics of other threads are. A program
/// built with `panic = "abort"` still ends.
///
/// # Errors
/// The panic's message.
pub(super) fn contain<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    silence_contained_panics();
    let outer = CONTAINED.replace(true);
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    CONTAINED.set(outer);
    result.map_err(|payload| message(payload.as_ref()))
}

/// Wraps the current panic hook, once in a process.
fn silence_contained_panics() {
    static INSTALL: Once = Once::new();
    INSTALL.call_once(|| {
        let previous = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            // A thread whose locals are gone catches nothing.
            if !CONTAINED.try_with(Cell::get).unwrap_or(false) {
                previous(info);
            }
        }));
    });
}

fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| payload.downcast_ref::<&str>().copied());
    text.unwrap_or("no message").to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panics_become_messages() {
        assert_eq!(contain(|| 7), Ok(7));
        assert_eq!(contain(|| panic!("plain")), Err::<(), _>("plain".into()));
        let number = 3;
        assert_eq!(
            contain(|| panic!("with {number}")),
            Err::<(), _>("with 3".into())
        );
        assert!(!CONTAINED.get());
    }

    #[test]
    fn the_inner_of_two_leaves_the_outer_contained() {
        let inner = contain(|| {
            let _ = contain(|| panic!("inner"));
            CONTAINED.get()
        });
        assert_eq!(inner, Ok(true));
    }
}
