//! Which triangles rays may skip: components that are closed surfaces, and the side of each that faces outward.
//!
//! A ray from outside a closed surface hits its outer side first. So a set for a target may leave out triangles that
//! certainly face away, if their component is closed, the sign of its volume is certain, and the target is certainly
//! outside of it. *Seams* ([`Topology::find_seams`]) stay, because even a ray from outside may hit them from behind. In
//! doubt, a triangle stays.
//!
//! There are no materials with holes, whose components would have to stay whole too.

mod budget;
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

/// The facts about a mesh's surfaces, from indices and positions. Made once; [`Self::update`] follows moving vertices.
#[derive(Clone, Debug)]
pub struct Topology {
    /// See [`Topology::components`].
    components: Vec<u32>,
    /// One a component.
    shapes: Vec<Shape>,
    /// Runs of `faces` of one component, by component.
    spans: Vec<Span>,
    /// The mesh's triangles, by component. Triangles without a component are absent.
    faces: Vec<[u32; 3]>,
    /// The mesh's positions.
    vertices: Vec<[f32; 3]>,
    /// Pairs of vertices whose equality keeps components closed.
    links: Vec<Link>,
    /// Seams with their component, by triangle.
    seams: Vec<(u32, u32)>,
}

/// The facts of one component: triangles connected by shared edges between welded vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facts {
    /// The number of triangles, seams included.
    pub triangle_count: usize,
    /// Whether every directed edge occurs as often as its reverse.
    pub closed: bool,
    /// Whether the front sides face outward, by the sign of the volume. `None` if open, or if rounding could change the
    /// sign.
    pub outward: Option<bool>,
    /// Whether sets may leave out its triangles, for targets outside: `outward` is known now, and was at the latest search
    /// for seams, which was not given up.
    pub reducible: bool,
    /// Whether the latest search for seams was given up in this component, because too many of its triangles are near each
    /// other. Then it stays whole.
    pub search_given_up: bool,
    /// The number of its triangles that are seams.
    pub seam_count: usize,
}

impl Topology {
    /// Finds the surfaces of a mesh in O(n log n), without seams. Call [`Self::find_seams`] next, unless the mesh is known
    /// to be a solid that does not intersect itself.
    ///
    /// # Panics
    /// If a triangle refers to a vertex that does not exist; [`Mesh::validate`] checks that.
    #[must_use]
    pub fn new(mesh: &Mesh) -> Self {
        let triangles = welded_triangles(mesh);
        let edges = Edges::new(&triangles, mesh.vertices.len());
        let Labels { of: labels, count } = Labels::new(&edges, &triangles);

        // A component is closed if every edge is, as long as its linked vertices stay together.
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

    /// Follows the mesh's vertices, in O(n): boxes, volumes, and whether closed components still are. A component is open
    /// while linked vertices are apart; one that was open at first stays open. Seams stay as they were found: a caller who
    /// deforms a mesh guarantees that no new ones arise, or searches again.
    ///
    /// # Panics
    /// If the counts show that it is another mesh.
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

    /// The number of vertices in the mesh.
    pub(crate) fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// The component of each triangle, numbered in the order of their first triangles; [`Self::component_count`] for
    /// triangles that always stay: seams, and triangles whose corners all weld to one vertex.
    #[must_use]
    pub fn components(&self) -> &[u32] {
        &self.components
    }

    /// The number of components, open ones included.
    #[must_use]
    pub fn component_count(&self) -> u32 {
        self.shapes.len() as u32
    }

    /// The facts of each component.
    #[must_use]
    pub fn facts(&self) -> Vec<Facts> {
        self.shapes.iter().map(Shape::facts).collect()
    }

    /// The number of seam triangles.
    #[must_use]
    pub fn seam_count(&self) -> usize {
        self.seams.len()
    }

    /// Bytes of memory held.
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
