//! Keeps a panic inside the reader that has it.

use std::any::Any;
use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

thread_local! {
    /// Whether this thread's panics are caught here, and so are not to be printed.
    static CONTAINED: Cell<bool> = const { Cell::new(false) };
}

/// Does the work, or returns the message that it panicked with. Nothing is printed; panics of other threads print as
/// before. A program built with `panic = "abort"` still ends.
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

/// Puts a hook before the current one, once a process.
fn silence_contained_panics() {
    static INSTALL: Once = Once::new();
    INSTALL.call_once(|| {
        let previous = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            // A thread past its locals contains nothing.
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
