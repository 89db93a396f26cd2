//! The GPU's results equal the CPU's: single kernels, whole builds and pictures; and the GPU's own buffers, limits and errors.

mod asynchronous;
mod browsers;
mod buffers;
mod builds;
mod chain;
mod codecs;
mod contract;
mod decisions;
mod dispatches;
mod encoders;
mod filtered;
mod generated;
mod kernels;
mod layouts;
mod limits;
mod lost;
mod order;
mod overflow;
mod own_shaders;
mod pictures;
mod scans;
mod set_memory;
mod shading;
mod slow_shapes;
mod sorts;
mod source_hash;
mod textures;
mod trace;
mod uploads;
mod view_sets;
mod views;
mod warm_up;
mod waves;

/// Sizes at and around the borders of words, workgroups, blocks and rows of blocks.
const SIZES: [u32; 19] = [
    1, 3, 4, 5, 31, 32, 33, 63, 64, 65, 1023, 1024, 1025, 2047, 2048, 2049, 65535, 65536, 65537,
];
