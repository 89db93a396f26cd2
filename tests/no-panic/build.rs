//! Nothing but the C library is linked, and nothing may stay undefined.

fn main() {
    for argument in [
        "-nostartfiles",
        "-nodefaultlibs",
        "-lc",
        "-lm",
        "-Wl,-z,defs",
    ] {
        println!("cargo::rustc-cdylib-link-arg={argument}");
    }
}
