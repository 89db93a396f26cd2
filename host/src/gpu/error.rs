//! What can go wrong on a GPU.

use super::misfit::Misfit;
use crate::tree::ON_LATTICE;
use crate::{MeshError, RefitError, ViewError};
use thiserror::Error;

/// Why a GPU did not do what it was asked for.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum GpuError {
    /// There is no GPU, or none of that name.
    #[error(transparent)]
    NoAdapter(#[from] AdapterError),
    /// The driver refused to open the adapter.
    #[error("cannot open the GPU {adapter:?}: {reason}")]
    Refused {
        /// The adapter's name.
        adapter: String,
        /// What the driver says.
        reason: String,
    },
    /// Something is larger than the adapter takes.
    #[error(
        "{what} would take {bytes} bytes, but {limit} of {adapter:?} is {limit_bytes}; {advice}"
    )]
    TooLarge {
        /// What is too large.
        what: &'static str,
        /// Its size.
        bytes: u64,
        /// Name of the limit, as wgpu has it.
        limit: &'static str,
        /// The limit.
        limit_bytes: u64,
        /// The adapter's name.
        adapter: String,
        /// What to do.
        advice: &'static str,
    },
    /// The adapter is too small for the kernels.
    #[error("{adapter:?} cannot run the kernels: its {limit} is {has}, and {needs} is needed")]
    TooSmall {
        /// The adapter's name.
        adapter: String,
        /// Name of the limit, as wgpu has it.
        limit: &'static str,
        /// What it has.
        has: u64,
        /// What is needed.
        needs: u64,
    },
    /// Something of the caller's does not fit its use.
    #[error("{what} {fault}")]
    Unfit {
        /// What it is.
        what: &'static str,
        /// What is wrong with it.
        fault: Misfit,
    },
    /// The GPU has no memory left.
    #[error("{adapter:?} is out of memory; render a smaller scene or picture, or use the CPU")]
    OutOfMemory {
        /// The adapter's name.
        adapter: String,
    },
    /// The GPU went away: its driver crashed, was reset, or it was unplugged.
    #[error("{adapter:?} was lost ({reason}); try again, or use the CPU")]
    Lost {
        /// The adapter's name.
        adapter: String,
        /// What the driver says.
        reason: String,
    },
    /// The driver found fault with a command.
    #[error("{adapter:?} refused a command: {reason}")]
    Invalid {
        /// The adapter's name.
        adapter: String,
        /// What the driver says.
        reason: String,
    },
    /// A web page cannot wait for its GPU: the browser goes on only when the page's code returns.
    #[error(
        "a web page cannot block until its GPU is done; await `open_async`, `wait_async` or `read_async` instead"
    )]
    CannotBlock,
    /// The nodes' codec is one of the laboratory's that the CPU alone has.
    #[error("{nodes} nodes are for the CPU only; use {ON_LATTICE} nodes for a lattice on a GPU")]
    Codec {
        /// The codec's name.
        nodes: &'static str,
    },
    /// Only the laboratory asks for this, so that it is not compiled in.
    #[error("{what} are traced on the CPU only, unless slimbvh is built with the feature `lab`")]
    LabKernel {
        /// What was asked for: a kernel, or a codec.
        what: &'static str,
    },
    /// The GPU has no kernels for trees that are clustered.
    #[error("clustered trees are built on the CPU only; the GPU builds radix trees")]
    Tree,
    /// The mesh is unfit.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The hierarchy cannot be moved to this mesh.
    #[error(transparent)]
    Refit(#[from] RefitError),
    /// The camera or a light is unfit.
    #[error(transparent)]
    View(#[from] ViewError),
}

/// Why no adapter was chosen.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum AdapterError {
    /// None at all.
    #[error(
        "there is no GPU that can be used: no driver for Vulkan, Metal, Direct3D 12 or WebGPU was found; use the CPU"
    )]
    None,
    /// Only those that compute on the CPU.
    #[error("there is no GPU, only software: {names}; use the CPU, or choose one of these by name")]
    OnlySoftware {
        /// What there is.
        names: String,
    },
    /// None of that name.
    #[error("no GPU has {wanted:?} in its name; there is {names}")]
    NoSuchName {
        /// What was asked for.
        wanted: String,
        /// What there is.
        names: String,
    },
}
