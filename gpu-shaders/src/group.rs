//! What an entry point shares with the other threads of its group or dispatch: barriers and atomics. The host has neither:
//! there a barrier does nothing and an atomic is a plain load and store, so that entry points compile, and are proven unable
//! to panic, without a GPU.

/// Waits for all threads of the workgroup. Their stores to workgroup memory before it are seen after it.
#[inline(always)]
pub(crate) fn barrier() {
    #[cfg(target_arch = "spirv")]
    spirv_std::arch::workgroup_memory_barrier_with_group_sync();
}

/// Adds, in no order with other memory. Returns what was there.
///
/// # Safety
/// The word is accessed by atomics only, as long as the dispatch lasts.
#[inline(always)]
#[expect(unsafe_code, reason = "rust-gpu has no safe atomics")]
pub(crate) unsafe fn atomic_add(word: &mut u32, amount: u32) -> u32 {
    #[cfg(target_arch = "spirv")]
    {
        use spirv_std::memory::{Scope, Semantics};
        const SCOPE: u32 = Scope::QueueFamily as u32;
        const UNORDERED: u32 = Semantics::NONE.bits();
        // SAFETY: the caller's promise.
        unsafe { spirv_std::arch::atomic_i_add::<u32, SCOPE, UNORDERED>(word, amount) }
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        let old = *word;
        *word = old.wrapping_add(amount);
        old
    }
}
