//! Error scopes, whose answers a browser gives only when the page's code has returned.

use std::future::Future;
use std::pin::Pin;
use std::sync::{Mutex, PoisonError};
use std::task::{Context, Poll, Waker};

/// A future of the error of popped scopes. Browsers' futures stay on their thread.
trait Answer: Future<Output = Option<wgpu::Error>> + wgpu::WasmNotSend {}

impl<F: Future<Output = Option<wgpu::Error>> + wgpu::WasmNotSend> Answer for F {}

/// Popped scopes that are not answered yet. Drivers answer at once, so that natively there are none.
#[derive(Default)]
pub struct Unanswered(Mutex<Vec<Pin<Box<dyn Answer>>>>);

impl Unanswered {
    /// The error of popped scopes, if it is known at once; otherwise it is kept.
    pub fn error_of(
        &self,
        popped: impl Future<Output = Option<wgpu::Error>> + wgpu::WasmNotSend + 'static,
    ) -> Option<wgpu::Error> {
        let mut popped: Pin<Box<dyn Answer>> = Box::pin(popped);
        match poll_once(&mut popped) {
            Poll::Ready(error) => error,
            Poll::Pending => {
                self.with(|kept| kept.push(popped));
                None
            }
        }
    }

    /// The first error among the answers that came meanwhile.
    pub fn answered(&self) -> Option<wgpu::Error> {
        let mut first = None;
        self.with(|kept| {
            kept.retain_mut(|popped| match poll_once(popped) {
                Poll::Ready(error) => {
                    first = first.take().or(error);
                    false
                }
                Poll::Pending => true,
            });
        });
        first
    }

    /// Waits for all answers. Returns the first error.
    pub async fn all(&self) -> Option<wgpu::Error> {
        let mut first = None;
        for popped in self.with(std::mem::take) {
            let error = popped.await;
            first = first.or(error);
        }
        first
    }

    fn with<R>(&self, work: impl FnOnce(&mut Vec<Pin<Box<dyn Answer>>>) -> R) -> R {
        work(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl std::fmt::Debug for Unanswered {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let count = self.with(|kept| kept.len());
        f.debug_tuple("Unanswered").field(&count).finish()
    }
}

fn poll_once(popped: &mut Pin<Box<dyn Answer>>) -> Poll<Option<wgpu::Error>> {
    let mut context = Context::from_waker(Waker::noop());
    popped.as_mut().poll(&mut context)
}

#[cfg(test)]
mod tests {
    use super::Unanswered;
    use crate::gpu::signal::signal;
    use pollster::block_on;

    fn error(text: &str) -> wgpu::Error {
        wgpu::Error::Internal {
            source: text.into(),
            description: text.into(),
        }
    }

    fn text(error: Option<wgpu::Error>) -> Option<String> {
        error.map(|error| match error {
            wgpu::Error::Internal { description, .. } => description,
            other => other.to_string(),
        })
    }

    #[test]
    fn an_answer_at_once_is_not_kept() {
        let scopes = Unanswered::default();
        let at_once = scopes.error_of(async { Some(error("now")) });
        assert_eq!(text(at_once).as_deref(), Some("now"));
        assert_eq!(format!("{scopes:?}"), "Unanswered(0)");
    }

    #[test]
    fn late_answers_come_back_with_a_later_call() {
        let scopes = Unanswered::default();
        let (first, first_error) = signal();
        let (second, second_error) = signal::<Option<wgpu::Error>>();
        let popped = [first_error, second_error];
        for received in popped {
            let at_once = scopes.error_of(async { received.await.flatten() });
            assert_eq!(text(at_once), None);
        }
        assert_eq!(format!("{scopes:?}"), "Unanswered(2)");
        assert_eq!(text(scopes.answered()), None);

        second.send(Some(error("second")));
        assert_eq!(text(scopes.answered()).as_deref(), Some("second"));
        assert_eq!(format!("{scopes:?}"), "Unanswered(1)");
        first.send(Some(error("first")));
        assert_eq!(text(block_on(scopes.all())).as_deref(), Some("first"));
        assert_eq!(text(block_on(scopes.all())), None);
    }
}
