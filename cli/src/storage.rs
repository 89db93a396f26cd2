//! The options of codecs, and the sizes of a stored hierarchy.

use super::output::bytes;
use super::reduce::ReduceArguments;
use crate::options;
use anyhow::{Result, bail};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use slimbvh::{
    BuildConfig, CodeBits, Mesh, MeshCodec, NodeCodec, Processor, RenderSettings, Scene, Tolerance,
    TreeKind, check_codecs,
};

#[derive(Debug, Args)]
pub struct StorageArguments {
    /// Codec of inner nodes: full precision, paper10 (10 bits a plane, after the paper on NODE and NODE+MESH), or up to four children
    /// (w4: full precision; w4-64 and w4-48: 8 bits on a lattice). The picture stays the same
    #[arg(long, value_parser = node_codecs(), default_value = AUTO)]
    nodes: Nodes,

    /// Codec of triangles: full precision, 10 bits a coordinate in the leaf's box as in that paper (surfaces crack), or on a
    /// lattice. Default: full precision, or the lattice if there is a --tolerance
    #[arg(long, value_parser = mesh_codecs())]
    mesh: Option<MeshCodec>,

    /// How far vertices may move onto the lattice: a length, or pixels at the scene's nearest point, as in 0.5px. Default: the
    /// finest lattice that holds the scene
    #[arg(long, value_name = "LENGTH|Npx", value_parser = options::tolerance)]
    tolerance: Option<Tolerance>,
}

/// The codec of nodes; `None` is chosen by the backend and the codec of triangles.
#[derive(Clone, Copy, Debug)]
struct Nodes(Option<NodeCodec>);

/// The name of `Nodes(None)`.
const AUTO: &str = "auto";

/// Parses the name of a codec of nodes.
fn node_codecs() -> impl TypedValueParser<Value = Nodes> {
    let auto = PossibleValue::new(AUTO).help("By the backend and the codec of triangles");
    let codecs = NodeCodec::all().map(|codec| {
        let help = format!("{} bytes", codec.node_bytes());
        PossibleValue::new(codec.name()).help(help)
    });
    let names = PossibleValuesParser::new([auto].into_iter().chain(codecs));
    names.map(|name| Nodes(NodeCodec::named(&name)))
}

/// Parses the name of a codec of triangles.
fn mesh_codecs() -> impl TypedValueParser<Value = MeshCodec> {
    let codecs = MeshCodec::ALL.map(|codec| PossibleValue::new(codec.name()).help(codec.summary()));
    let names = PossibleValuesParser::new(codecs);
    // The parser before this accepts only names of codecs.
    names.map(|name| MeshCodec::named(&name).unwrap_or_default())
}

/// The codecs of a picture's trees.
#[derive(Clone, Copy, Debug)]
pub struct Storage {
    pub nodes: NodeCodec,
    pub mesh: MeshCodec,
}

impl StorageArguments {
    /// Rejects options that contradict each other.
    pub fn check(&self) -> Result<()> {
        self.triangles().map(|_| ())
    }

    /// Rejects reduction with a codec that moves triangles after the decision.
    pub fn check_reduction(&self, reduce: &ReduceArguments) -> Result<()> {
        let mesh = self.triangles()?;
        if mesh.moves_vertices() && reduce.is_asked_for() {
            bail!(
                "--mesh {} moves triangles after the plan has chosen which to leave out; leave --reduce on and --cull on out",
                mesh.name()
            );
        }
        Ok(())
    }

    /// Rejects options that differ from `codecs`, those of the saved tree.
    pub fn check_saved(&self, codecs: (NodeCodec, MeshCodec), name: &str) -> Result<()> {
        if self.tolerance.is_some() {
            bail!(
                "--tolerance moves vertices before a build; \"{name}\" is built already, leave it out"
            );
        }
        let [nodes, mesh] = [codecs.0.name(), codecs.1.name()];
        if self.nodes.0.is_some_and(|asked| asked != codecs.0) {
            bail!(
                "\"{name}\" has nodes of {nodes}, --nodes asks for others; leave it out, or build the scene again"
            );
        }
        if self.mesh.is_some_and(|asked| asked.name() != mesh) {
            bail!(
                "\"{name}\" has triangles of {mesh}, --mesh asks for others; leave it out, or build the scene again"
            );
        }
        Ok(())
    }

    /// Whether the codec of triangles excludes reduced trees and culling.
    pub fn forbids_reduction(&self) -> bool {
        self.mesh.is_some_and(MeshCodec::moves_vertices)
    }

    /// The codec of triangles, which goes with the nodes that are asked for; the step of a lattice is not known yet.
    fn triangles(&self) -> Result<MeshCodec> {
        let lattice = MeshCodec::ALL.into_iter();
        let mut lattice = lattice.filter(|codec| codec.step_exponent().is_some());
        let mesh = match (self.mesh, self.tolerance) {
            (Some(mesh), Some(_)) if mesh.step_exponent().is_none() => {
                bail!("--tolerance moves vertices onto a lattice; it goes with --mesh lattice")
            }
            (Some(mesh), _) => mesh,
            (None, Some(_)) => lattice.next().unwrap_or_default(),
            (None, None) => MeshCodec::default(),
        };
        let checked = self.nodes.0.map(|nodes| check_codecs(nodes, mesh));
        if let Some(Err(error)) = checked {
            let names: Vec<&str> = mesh.nodes().map(NodeCodec::name).collect();
            let (mesh, names) = (mesh.name(), names.join(", "));
            bail!("{error}: --mesh {mesh} goes with --nodes {names}");
        }
        Ok(mesh)
    }

    /// Chooses the codecs. Moves the scene's vertices onto the lattice, if there is one.
    pub fn apply(
        &self,
        scene: &mut Scene,
        settings: &RenderSettings,
        processor: Processor,
    ) -> Result<Storage> {
        let step_exponent = self.step_exponent(scene, settings);
        let storage = self.on_lattice(step_exponent, processor)?;
        storage.snap(scene);
        Ok(storage)
    }

    /// As [`Self::apply`] for a scene with one pose for each time: chooses one lattice for all poses. The caller moves the
    /// vertices of each pose onto it.
    pub fn for_all(
        &self,
        settings: &RenderSettings,
        times: impl Iterator<Item = f64>,
        mut pose: impl FnMut(f64, &mut Scene),
        scene: &mut Scene,
        processor: Processor,
    ) -> Result<Storage> {
        if self.triangles()?.step_exponent().is_none() {
            return self.on_lattice(None, processor);
        }
        let (mut finest, mut wanted) = (i32::MIN, Some(i32::MAX));
        for time in times {
            pose(time, scene);
            finest = finest.max(scene.mesh.finest_step());
            let here = self.step_exponent(scene, settings);
            wanted = here.zip(wanted).map(|(here, wanted)| wanted.min(here));
        }
        let step_exponent = wanted.map_or(finest, |wanted| wanted.max(finest));
        self.on_lattice(Some(step_exponent), processor)
    }

    /// The lattice's step for the scene as it is; `None` if the tolerance is finer than `f32` can represent.
    fn step_exponent(&self, scene: &Scene, settings: &RenderSettings) -> Option<i32> {
        match self.tolerance {
            Some(tolerance) => tolerance.step_exponent(scene, settings),
            None => Some(scene.mesh.finest_step()),
        }
    }

    /// The same build where another backend takes over.
    #[cfg(feature = "gpu")]
    #[must_use]
    pub fn moved(&self, config: BuildConfig, processor: Processor) -> BuildConfig {
        let nodes = self.nodes_for(config.mesh, processor);
        BuildConfig { nodes, ..config }
    }

    /// The codec of nodes over these triangles.
    fn nodes_for(&self, mesh: MeshCodec, processor: Processor) -> NodeCodec {
        self.nodes.0.unwrap_or(mesh.nodes_for(processor))
    }

    /// The codecs with a lattice of this step; with `None` triangles stay in full precision.
    fn on_lattice(&self, step_exponent: Option<i32>, processor: Processor) -> Result<Storage> {
        let mesh = self.triangles()?.with_step(step_exponent);
        let nodes = self.nodes_for(mesh, processor);
        Ok(Storage { nodes, mesh })
    }
}

impl Storage {
    /// Moves a scene's vertices onto the lattice, if there is one.
    pub fn snap(&self, scene: &mut Scene) {
        if let Some(step_exponent) = self.mesh.step_exponent() {
            scene.mesh.snap(step_exponent);
        }
    }

    /// The settings of a build with these codecs.
    #[must_use]
    pub fn config(&self, code_bits: CodeBits, tree: TreeKind) -> BuildConfig {
        BuildConfig {
            code_bits,
            tree,
            nodes: self.nodes,
            mesh: self.mesh,
        }
    }
}

/// Sizes of the lists of a hierarchy and its mesh.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    pub triangle_count: usize,
    pub node_bytes: usize,
    pub triangle_bytes: usize,
    pub mesh_bytes: usize,
    pub scratch_bytes: usize,
}

impl Sizes {
    /// The sizes as text.
    #[must_use]
    pub fn describe(&self) -> String {
        let per_triangle = |bytes: usize| bytes as f64 / self.triangle_count.max(1) as f64;
        format!(
            "{} nodes ({:.1} a triangle), {} leaf triangles ({:.1}), {} mesh, {} scratch",
            bytes(self.node_bytes),
            per_triangle(self.node_bytes),
            bytes(self.triangle_bytes),
            per_triangle(self.triangle_bytes),
            bytes(self.mesh_bytes),
            bytes(self.scratch_bytes)
        )
    }
}

/// The size of a mesh's lists in bytes.
#[must_use]
pub fn mesh_bytes(mesh: &Mesh) -> usize {
    size_of_val(mesh.vertices.as_slice())
        + size_of_val(mesh.indices.as_slice())
        + size_of_val(mesh.normals.as_slice())
        + size_of_val(mesh.materials.as_slice())
}

/// The names of the codecs, with the step of a lattice.
pub fn describe((nodes, mesh): (NodeCodec, MeshCodec)) -> String {
    let step = mesh.step_exponent();
    let step = step.map_or_else(String::new, |exponent| format!(" of step 2^{exponent}"));
    format!("nodes {}, triangles {}{step}", nodes.name(), mesh.name())
}
