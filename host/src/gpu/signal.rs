//! A value that a callback of wgpu sends to a future.

use std::future::Future;
use std::pin::Pin;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Poll, Waker};

/// Both ends of a new signal.
pub fn signal<T>() -> (Sender<T>, Received<T>) {
    let shared = Arc::new(Mutex::new(Shared {
        value: None,
        is_open: true,
        waker: None,
    }));
    (Sender(Arc::clone(&shared)), Received(shared))
}

/// The callback's end.
pub struct Sender<T>(Arc<Mutex<Shared<T>>>);

/// A future of the value; `None` if the callback was dropped unused.
pub struct Received<T>(Arc<Mutex<Shared<T>>>);

struct Shared<T> {
    value: Option<T>,
    is_open: bool,
    waker: Option<Waker>,
}

impl<T> Sender<T> {
    /// Sends the value.
    pub fn send(self, value: T) {
        lock(&self.0).value = Some(value);
    }
}

impl<T> Drop for Sender<T> {
    fn drop(&mut self) {
        let waker = {
            let mut shared = lock(&self.0);
            shared.is_open = false;
            shared.waker.take()
        };
        if let Some(waker) = waker {
            waker.wake();
        }
    }
}

impl<T> Future for Received<T> {
    type Output = Option<T>;

    fn poll(self: Pin<&mut Self>, context: &mut Context) -> Poll<Option<T>> {
        let mut shared = lock(&self.0);
        if shared.is_open {
            shared.waker = Some(context.waker().clone());
            return Poll::Pending;
        }
        Poll::Ready(shared.value.take())
    }
}

fn lock<T>(shared: &Mutex<Shared<T>>) -> MutexGuard<'_, Shared<T>> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::signal;
    use std::future::Future;
    use std::pin::pin;
    use std::task::{Context, Poll, Waker};

    #[test]
    fn a_value_arrives_and_a_dropped_callback_is_noticed() {
        let mut context = Context::from_waker(Waker::noop());
        let (sender, received) = signal();
        let mut received = pin!(received);
        assert_eq!(received.as_mut().poll(&mut context), Poll::Pending);
        sender.send(7);
        assert_eq!(received.as_mut().poll(&mut context), Poll::Ready(Some(7)));

        let (sender, received) = signal::<u32>();
        drop(sender);
        assert_eq!(pin!(received).poll(&mut context), Poll::Ready(None));
    }

    #[test]
    fn a_waiting_thread_is_woken() {
        let (sender, received) = signal();
        let sending = std::thread::spawn(move || sender.send("done"));
        assert_eq!(pollster::block_on(received), Some("done"));
        sending.join().expect("it sends");
    }
}
