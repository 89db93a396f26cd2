//! SPIR-V entry points of slimbvh, one file a stage, named as in `slimbvh_core`. An entry point unpacks its bindings,
//! calls core and stores what that returns; it has no arithmetic of its own beyond indices. The GPU backend brings them.
#![cfg_attr(target_arch = "spirv", no_std)]
