//! What rays of one origin may skip: which triangles belong to closed surfaces, and which side of those faces out.
//!
//! A ray from outside a closed surface meets it from outside first. So of a component that is closed, whose volume has a
//! certain sign and that the target is certainly outside of, the triangles that certainly face away may be left out: all
//! but its *seams* ([`Topology::find_seams`]), where even a ray from outside may arrive from behind. Whatever is not
//! certain stays.
//!
//! Materials with holes or glass will have to keep their components whole too; there are none yet.

mod contact;
mod crossing;
mod distance;
mod links;
mod runs;
mod seams;
mod shape;
mod sides;
pub(crate) mod solid_angle;
mod within;

#[cfg(all(test, feature = "scenes"))]
mod tests;

use crate::Mesh;
use crate::analysis::{Edges, Labels, NONE, excess, weld};
use links::Link;
use shape::{Shape, Span};

pub(crate) use runs::Runs;
pub use sides::Target;

/// What a mesh's indices and positions say about its surfaces. Made once; [`Self::update`] follows moving vertices.
#[derive(Clone, Debug)]
pub struct Topology {
    /// See [`Topology::components`].
    components: Vec<u32>,
    /// One a component.
    shapes: Vec<Shape>,
    /// Runs of one component's `faces`, all of them by component.
    spans: Vec<Span>,
    /// The mesh's triangles, by component. Those of no component are missing.
    faces: Vec<[u32; 3]>,
    /// The mesh's positions.
    vertices: Vec<[f32; 3]>,
    /// Vertices whose equality keeps components closed.
    links: Vec<Link>,
    /// Seams with their own component, by triangle.
    seams: Vec<(u32, u32)>,
}

/// What is known of one component. Triangles that hang together by shared edges between welded vertices make one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facts {
    /// How many triangles it has, seams included.
    pub triangle_count: usize,
    /// Whether every directed edge occurs as often as its reverse.
    pub closed: bool,
    /// Whether the front sides face out, by the sign of the volume; `None` when not closed, or when rounding could have
    /// turned the sign.
    pub outward: Option<bool>,
    /// Whether it may be reduced, for targets outside: `outward` is known now, and was when seams were last looked for.
    pub reducible: bool,
    /// How many of its triangles are seams.
    pub seam_count: usize,
}

impl Topology {
    /// Takes stock of a mesh in O(n log n). No triangle is a seam: call [`Self::find_seams`], unless the mesh is known to
    /// be a solid that does not cut itself.
    ///
    /// # Panics
    /// If a triangle names a vertex that is not there; [`Mesh::validate`] finds that.
    #[must_use]
    pub fn new(mesh: &Mesh) -> Self {
        let triangles = welded_triangles(mesh);
        let edges = Edges::new(&triangles, mesh.vertices.len());
        let Labels { of: labels, count } = Labels::new(&edges, &triangles);

        // A component is closed where every edge is, for as long as its vertices stay together.
        let mut closed = vec![true; count as usize];
        edges.for_each(|sides| {
            closed[labels[sides[0].triangle() as usize] as usize] &= excess(sides) == 0;
        });
        let links = links::links(mesh, &triangles, &edges, |triangle| {
            let label = labels[triangle as usize];
            (label != NONE && closed[label as usize]).then_some(label)
        });

        let (shapes, spans, faces) = shape::group(mesh, &labels, &closed);
        let components = labels.iter().map(|&label| label.min(count)).collect();
        let mut topology = Self {
            components,
            shapes,
            spans,
            faces,
            vertices: mesh.vertices.clone(),
            links,
            seams: Vec::new(),
        };
        topology.measure();
        topology
    }

    /// Follows the mesh's vertices, in O(n): boxes, volumes, and whether what was closed still is. A component is open as
    /// long as vertices that its closed edges need together lie apart; one that was open from the start stays so. Seams
    /// stay as they were found: who deforms a mesh promises that none arise, or looks for them again.
    ///
    /// # Panics
    /// If it is another mesh, as far as the counts tell.
    pub fn update(&mut self, mesh: &Mesh) {
        let counts = (mesh.vertices.len(), mesh.indices.len());
        let expected = (self.vertices.len(), self.components.len());
        assert_eq!(counts, expected, "vertices and triangles of another mesh");
        self.vertices.copy_from_slice(&mesh.vertices);
        self.measure();
    }

    fn measure(&mut self) {
        shape::measure(&mut self.shapes, &self.spans, &self.faces, &self.vertices);
        for component in links::broken(&self.links, &self.vertices) {
            self.shapes[component as usize].open();
        }
    }

    /// The links of a component.
    fn links_of(&self, component: u32) -> &[Link] {
        let first = |component| {
            self.links
                .partition_point(|link| link.component < component)
        };
        &self.links[first(component)..first(component + 1)]
    }

    /// How many vertices the mesh has.
    pub(crate) fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// The component of each triangle, numbered in the order of their first triangles; [`Self::component_count`] for
    /// triangles that are always kept: seams, and those that welding makes a point.
    #[must_use]
    pub fn components(&self) -> &[u32] {
        &self.components
    }

    /// How many components there are, open ones included.
    #[must_use]
    pub fn component_count(&self) -> u32 {
        self.shapes.len() as u32
    }

    /// What is known of each component.
    #[must_use]
    pub fn facts(&self) -> Vec<Facts> {
        self.shapes.iter().map(Shape::facts).collect()
    }

    /// How many triangles are seams.
    #[must_use]
    pub fn seam_count(&self) -> usize {
        self.seams.len()
    }

    /// Bytes of all that is held.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(self.components.as_slice())
            + size_of_val(self.shapes.as_slice())
            + size_of_val(self.spans.as_slice())
            + size_of_val(self.faces.as_slice())
            + size_of_val(self.vertices.as_slice())
            + size_of_val(self.links.as_slice())
            + size_of_val(self.seams.as_slice())
    }
}

/// The mesh's triangles over welded vertices.
fn welded_triangles(mesh: &Mesh) -> Vec<[u32; 3]> {
    let ids = weld(&mesh.vertices);
    let weld_corners = |triangle: &[u32; 3]| triangle.map(|vertex| ids[vertex as usize]);
    mesh.indices.iter().map(weld_corners).collect()
}
