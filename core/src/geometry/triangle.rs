//! Triangles, as the caller indexes them and as leaves store them.

use crate::geometry::aabb::{Aabb, greater, lesser};
use crate::geometry::float::{abs, max};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// Three corners; counter-clockwise is front.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Triangle {
    /// First corner, the origin of the barycentric coordinates.
    pub v0: Vec3,
    /// Second corner, at u = 1.
    pub v1: Vec3,
    /// Third corner, at v = 1.
    pub v2: Vec3,
}

impl Triangle {
    /// The tight box around the three corners.
    #[inline(always)]
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        Aabb {
            min: lesser(lesser(self.v0, self.v1), self.v2),
            max: greater(greater(self.v0, self.v1), self.v2),
        }
    }

    /// `(v1 - v0) × (v2 - v0)`: points to the front, as long as twice the area.
    #[inline]
    #[must_use]
    pub fn normal(&self) -> Vec3 {
        (self.v1 - self.v0).cross(self.v2 - self.v0)
    }

    /// The same triangle, turned so that it begins at the corner opposite its longest side: the normal of the two shortest sides is
    /// the one with the least rounding. Lengths are compared by their largest component.
    #[inline(always)]
    #[must_use]
    pub fn from_widest_corner(&self) -> Self {
        let size = |v: Vec3| max(max(abs(v.x), abs(v.y)), abs(v.z));
        let Self { v0, v1, v2 } = *self;
        let (opposite_0, opposite_1, opposite_2) = (size(v2 - v1), size(v0 - v2), size(v1 - v0));
        let (v0, v1, v2) = if (opposite_0 >= opposite_1) & (opposite_0 >= opposite_2) {
            (v0, v1, v2)
        } else if opposite_1 >= opposite_2 {
            (v1, v2, v0)
        } else {
            (v2, v0, v1)
        };
        Self { v0, v1, v2 }
    }
}

/// A triangle in a leaf, with its place in the caller's list. 40 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct LeafTriangle {
    /// Bytes 0–35: v0, v1, v2.
    pub vertices: [f32; 9],
    /// Bytes 36–39: the caller's index.
    pub primitive: u32,
}

const _: () = assert!(size_of::<LeafTriangle>() == 40);

impl LeafTriangle {
    /// Stands for the triangle of an index out of range.
    pub(crate) const ABSENT: Self = Self {
        vertices: [0.0; 9],
        primitive: 0,
    };

    /// The three corners.
    #[inline(always)]
    #[must_use]
    pub fn triangle(&self) -> Triangle {
        let v = &self.vertices;
        Triangle {
            v0: Vec3::new(v[0], v[1], v[2]),
            v1: Vec3::new(v[3], v[4], v[5]),
            v2: Vec3::new(v[6], v[7], v[8]),
        }
    }
}

/// The caller's vertices and indices, as they are. Indices out of range stand for the origin.
#[derive(Clone, Copy)]
pub struct IndexedTriangles<'a> {
    /// Positions.
    pub vertices: &'a [[f32; 3]],
    /// Three vertices a triangle.
    pub indices: &'a [[u32; 3]],
}

impl IndexedTriangles<'_> {
    /// A triangle by the caller's index.
    #[inline(always)]
    #[must_use]
    pub fn triangle(&self, primitive: u32) -> Triangle {
        let corners = crate::load(self.indices, primitive, [0; 3]);
        Triangle {
            v0: self.vertex(corners[0]),
            v1: self.vertex(corners[1]),
            v2: self.vertex(corners[2]),
        }
    }

    #[inline(always)]
    fn vertex(&self, vertex: u32) -> Vec3 {
        let [x, y, z] = crate::load(self.vertices, vertex, [0.0; 3]);
        Vec3::new(x, y, z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_and_normal_of_a_known_triangle() {
        let t = Triangle {
            v0: Vec3::new(1.0, 5.0, -2.0),
            v1: Vec3::new(3.0, 4.0, -2.0),
            v2: Vec3::new(2.0, 9.0, -2.0),
        };
        assert_eq!(t.bounds().min, Vec3::new(1.0, 4.0, -2.0));
        assert_eq!(t.bounds().max, Vec3::new(3.0, 9.0, -2.0));
        assert_eq!(t.normal(), Vec3::new(0.0, 0.0, 9.0));
    }

    #[test]
    fn the_widest_corner_is_opposite_the_longest_side() {
        let [a, b, c] = [[0.0, 0.0, 0.0], [1.0, 0.5, 0.0], [9.0, 0.0, 2.0]].map(Vec3::from_array);
        let expected = Triangle {
            v0: b,
            v1: c,
            v2: a,
        };
        for (v0, v1, v2) in [(a, b, c), (b, c, a), (c, a, b)] {
            assert_eq!(Triangle { v0, v1, v2 }.from_widest_corner(), expected);
        }
        let other_way = Triangle {
            v0: c,
            v1: b,
            v2: a,
        }
        .from_widest_corner();
        assert_eq!(
            other_way,
            Triangle {
                v0: b,
                v1: a,
                v2: c
            }
        );
    }
}
