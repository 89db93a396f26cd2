//! The inputs of kernels that measure moved vertices.

use super::Topology;
use super::shape::Shape;
use slimbvh_core::decide::{Component, Span, Surfaces};
use slimbvh_core::launch::BLOCK;

/// Components that may be reduced while they are closed and have an outer side, with their faces and links in runs.
#[derive(Clone, Debug, Default)]
pub struct Runs {
    /// The components, by their numbers.
    pub components: Vec<Component>,
    /// Their spans, by component; each is the work of one workgroup.
    pub spans: Vec<Span>,
    /// Their faces, by component.
    pub faces: Vec<[u32; 3]>,
    /// Their links, by component.
    pub links: Vec<[u32; 2]>,
}

impl Runs {
    /// The runs with the present vertices.
    pub fn surfaces<'a>(&'a self, vertices: &'a [[f32; 3]]) -> Surfaces<'a> {
        Surfaces {
            vertices,
            faces: &self.faces,
            links: &self.links,
        }
    }
}

impl Topology {
    /// The facts that do not depend on positions. Leaves out components that were never closed and those without known
    /// seams.
    pub(crate) fn runs(&self) -> Runs {
        let mut runs = Runs::default();
        let shapes = (0_u32..).zip(&self.shapes);
        for (number, shape) in shapes.filter(|(_, shape)| shape.may_be_reduced()) {
            let links = self.links_of(number);
            let first_span = runs.spans.len() as u32;
            self.add_spans(&mut runs, shape, links.len() as u32);
            runs.components.push(Component {
                number,
                first_span,
                span_count: runs.spans.len() as u32 - first_span,
            });
            let spans = &self.spans[shape.spans.start as usize..shape.spans.end as usize];
            let faces = spans.iter().flat_map(|span| span.faces(&self.faces));
            runs.faces.extend(faces);
            runs.links.extend(links.iter().map(|link| link.vertices));
        }
        runs
    }

    /// Cuts a component's faces into spans, and distributes its links among them.
    fn add_spans(&self, runs: &mut Runs, shape: &Shape, link_count: u32) {
        let (first_face, first_link) = (runs.faces.len() as u32, runs.links.len() as u32);
        let face_count = shape.triangle_count;
        let span_count = face_count.div_ceil(BLOCK);
        let links_each = link_count.div_ceil(span_count.max(1));
        let first = shape.spans.start as usize;
        let reference = self.spans[first].faces(&self.faces)[0][0];
        for i in 0..span_count {
            let (face, link) = (i * BLOCK, (i * links_each).min(link_count));
            runs.spans.push(Span {
                reference,
                first_face: first_face + face,
                face_count: BLOCK.min(face_count - face),
                first_link: first_link + link,
                link_count: links_each.min(link_count - link),
            });
        }
    }
}
