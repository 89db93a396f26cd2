//! Links: pairs of vertices that must stay at one position.

use crate::Mesh;
use crate::analysis::{Edges, Side};
use crate::parallel::prelude::*;

/// Two vertices of a closed component that weld to one. While all its links hold, every directed edge of the component
/// meets its reverse; if every edge has two triangles, as in most meshes, only while they hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Link {
    pub(super) component: u32,
    pub(super) vertices: [u32; 2],
}

/// The links of all closed components, by component. `triangles` are those of the mesh over welded vertices; `closed`
/// returns the closed component of a triangle, if any.
pub(super) fn links(
    mesh: &Mesh,
    triangles: &[[u32; 3]],
    edges: &Edges,
    closed: impl Fn(u32) -> Option<u32>,
) -> Vec<Link> {
    let mut links = Vec::new();
    let mut join = |component, a: u32, b: u32| {
        if a != b {
            let vertices = [a.min(b), a.max(b)];
            links.push(Link {
                component,
                vertices,
            });
        }
    };

    // All sides of an edge run between the same two positions.
    edges.for_each(|sides| {
        let Some(component) = closed(sides[0].triangle()) else {
            return;
        };
        let [first, others @ ..] = sides else {
            return;
        };
        let ends = |side: &Side| {
            let number = side.triangle() as usize;
            let corners = side.corners(triangles[number]);
            corners.map(|corner| mesh.indices[number][corner])
        };
        let [a, b] = ends(first);
        for side in others {
            let [c, d] = ends(side);
            join(component, a, c);
            join(component, b, d);
        }
    });

    // A side from a position to itself is not an edge, as long as its vertices stay together.
    for (number, (welded, own)) in (0_u32..).zip(triangles.iter().zip(&mesh.indices)) {
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            if welded[from] == welded[to]
                && let Some(component) = closed(number)
            {
                join(component, own[from], own[to]);
            }
        }
    }
    links.par_sort_unstable();
    links.dedup();
    links.shrink_to_fit();
    links
}

/// The components with a broken link; a component may occur more than once.
pub(super) fn broken(links: &[Link], vertices: &[[f32; 3]]) -> Vec<u32> {
    let is_broken = |link: &&Link| {
        let [a, b] = link.vertices.map(|vertex| vertices[vertex as usize]);
        a != b
    };
    let broken = links.par_iter().filter(is_broken);
    broken.map(|link| link.component).collect()
}
