//! The facts that depend on positions: each component's box, and the sign of its volume.

use super::Facts;
use super::budget::Spending;
use crate::Mesh;
use crate::analysis::{NONE, Volume, middle, seen_from};
use crate::parallel::prelude::*;
use glam::Vec3;
use slimbvh_core::Aabb;
use std::ops::Range;

/// One component.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    /// Its spans.
    pub(super) spans: Range<u32>,
    /// The number of triangles, seams included.
    pub(super) triangle_count: u32,
    /// The number of its triangles that are seams.
    pub(super) seam_count: u32,
    was_closed: bool,
    /// Whether every directed edge meets its reverse.
    pub(super) closed: bool,
    /// Whether the front sides face outward; `None` if open or uncertain.
    pub(super) outward: Option<bool>,
    /// Whether its seams are unknown: `outward` was at the search for them, or the search was given up.
    pub(super) barred: bool,
    /// Steps of the search for seams.
    pub(super) spending: Spending,
    /// The box around it.
    pub(super) bounds: Aabb,
}

impl Shape {
    /// The public facts.
    pub(super) fn facts(&self) -> Facts {
        Facts {
            triangle_count: self.triangle_count as usize,
            closed: self.closed,
            outward: self.outward,
            reducible: self.outward.is_some() && !self.barred,
            search_given_up: self.spending.is_exceeded(),
            seam_count: self.seam_count as usize,
        }
    }

    /// Records that an edge has come apart.
    pub(super) fn open(&mut self) {
        self.closed = false;
        self.outward = None;
    }

    /// Whether it may be reduced at any vertex positions at which it is closed and has an outer side.
    pub(super) fn may_be_reduced(&self) -> bool {
        self.was_closed && !self.barred
    }

    /// The side that faces outward: 1 for the front, −1 for the back.
    pub(super) fn side(&self) -> Option<i32> {
        self.outward.map(|is_front| if is_front { 1 } else { -1 })
    }
}

/// A run of faces of one component: work for one thread, summed in an order that does not depend on the number of threads.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    component: u32,
    first: u32,
    count: u32,
}

impl Span {
    const LONGEST: usize = 4096;

    /// Its part of all faces.
    pub(super) fn faces<'a>(&self, faces: &'a [[u32; 3]]) -> &'a [[u32; 3]] {
        &faces[self.first as usize..(self.first + self.count) as usize]
    }
}

/// Sorts a mesh's triangles by component, without measures.
pub(super) fn group(
    mesh: &Mesh,
    labels: &[u32],
    closed: &[bool],
) -> (Vec<Shape>, Vec<Span>, Vec<[u32; 3]>) {
    let mut starts = vec![0_u32; closed.len() + 1];
    let labelled = || {
        let all = labels.iter().zip(&mesh.indices);
        all.filter(|(label, _)| **label != NONE)
    };

    // A counting sort by label, from the front: `starts[label + 1]` ends up as the end.
    for (&label, _) in labelled() {
        starts[label as usize + 1] += 1;
    }
    let mut total = 0;
    for start in &mut starts {
        total += *start;
        *start = total;
    }
    let mut next = starts.clone();
    let mut faces = vec![[0; 3]; total as usize];
    for (&label, &triangle) in labelled() {
        let place = &mut next[label as usize];
        faces[*place as usize] = triangle;
        *place += 1;
    }

    let mut spans = Vec::new();
    let mut shapes = Vec::with_capacity(closed.len());
    for (component, (range, &closed)) in (0_u32..).zip(starts.windows(2).zip(closed)) {
        let first_span = spans.len() as u32;
        for first in (range[0]..range[1]).step_by(Span::LONGEST) {
            spans.push(Span {
                component,
                first,
                count: (range[1] - first).min(Span::LONGEST as u32),
            });
        }
        shapes.push(Shape {
            spans: first_span..spans.len() as u32,
            triangle_count: range[1] - range[0],
            seam_count: 0,
            was_closed: closed,
            closed,
            outward: None,
            barred: false,
            spending: Spending::default(),
            bounds: Aabb::EMPTY,
        });
    }
    (shapes, spans, faces)
}

/// Measures all components, treating those as closed that were closed at first.
pub(super) fn measure(
    shapes: &mut [Shape],
    spans: &[Span],
    faces: &[[u32; 3]],
    vertices: &[[f32; 3]],
) {
    // Boxes first, because volumes are relative to their middle.
    let boxes: Vec<Aabb> = spans
        .par_iter()
        .map(|span| {
            let corners = span.faces(faces).as_flattened().iter();
            let points = corners.map(|&vertex| Vec3::from_array(vertices[vertex as usize]));
            points.fold(Aabb::EMPTY, Aabb::union_point)
        })
        .collect();
    for shape in &mut *shapes {
        let range = shape.spans.start as usize..shape.spans.end as usize;
        shape.bounds = boxes[range].iter().copied().fold(Aabb::EMPTY, Aabb::union);
        shape.closed = shape.was_closed;
    }

    // Sum the tetrahedra between the middle and each triangle.
    let volumes: Vec<Volume> = spans
        .par_iter()
        .map(|span| {
            let mut volume = Volume::default();
            let shape = &shapes[span.component as usize];
            if shape.closed {
                let center = middle(&shape.bounds);
                for triangle in span.faces(faces) {
                    let corners = triangle.map(|vertex| vertices[vertex as usize]);
                    let [a, b, c] = seen_from(center, corners);
                    volume += Volume::tetrahedron(a, b, c);
                }
            }
            volume
        })
        .collect();
    for shape in shapes {
        let mut sum = Volume::default();
        let range = shape.spans.start as usize..shape.spans.end as usize;
        volumes[range].iter().for_each(|&volume| sum += volume);
        shape.outward = sum.outward();
    }
}
