//! The GPU adapter that the tests use.

use std::sync::OnceLock;

/// The name of the preferred adapter. Without an adapter the tests are skipped with a notice, or fail under `REQUIRE_GPU`.
pub fn adapter() -> Option<&'static str> {
    static ADAPTER: OnceLock<Option<String>> = OnceLock::new();
    let found = ADAPTER.get_or_init(|| {
        let adapters = slimbvh::gpu::adapters();
        let name = adapters.first().map(|adapter| adapter.name.clone());
        let is_required = std::env::var_os("REQUIRE_GPU").is_some_and(|value| value != "0");
        assert!(
            name.is_some() || !is_required,
            "REQUIRE_GPU, but there is none"
        );
        if name.is_none() {
            eprintln!("THE TESTS OF THE BINARY ON A GPU ARE SKIPPED: there is none");
        }
        name
    });
    found.as_deref()
}
