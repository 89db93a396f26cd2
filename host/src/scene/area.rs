//! Area lights.

use super::view::unit;
use super::{AreaShape, Light};
use crate::dvec3::{cross, dot, normalized};
use glam::Vec3;
use slimbvh_core::light::{DISC, RECTANGLE};

impl Light {
    /// A round light around `center` that shines to the side that `normal` points to. The color is as in [`Light::Area`]. A
    /// light with a zero normal has no area and cannot be rendered.
    #[must_use]
    pub fn disc(center: [f32; 3], normal: [f32; 3], radius: f32, color: [f32; 3]) -> Self {
        let (right, up) = unit(normal).map_or((Vec3::ZERO, Vec3::ZERO), Vec3::any_orthonormal_pair);
        Self::Area {
            center,
            half_edges: [right, up].map(|edge| (edge * radius).to_array()),
            shape: AreaShape::Disc,
            color,
            range: f32::INFINITY,
        }
    }
}

impl AreaShape {
    /// The outline as a tag of core.
    pub(super) const fn to_core(self) -> u32 {
        match self {
            Self::Disc => DISC,
            Self::Rectangle => RECTANGLE,
        }
    }
}

/// The unit vector perpendicular to both edges; `None` if they are parallel within a millionth of their length.
pub(super) fn normal([a, b]: [[f32; 3]; 2]) -> Option<[f32; 3]> {
    let [a, b] = [a, b].map(|edge| edge.map(f64::from));
    let across = cross(a, b);
    let least = 1e-12 * dot(a, a) * dot(b, b);
    (dot(across, across) > least).then(|| normalized(across).map(|x| x as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_shines_along_its_normal() {
        for n in [
            [0.0, -2.0, 0.0],
            [0.0, 0.0, -1.0],
            [3.0, 4.0, 0.0],
            [-1e-20, 1e-20, 2e-20],
        ] {
            let Light::Area {
                half_edges: [a, b], ..
            } = Light::disc([1.0, 2.0, 3.0], n, 2.5, [1.0; 3])
            else {
                panic!("it is an area");
            };
            let (a, b) = (Vec3::from(a), Vec3::from(b));
            assert!((a.length() - 2.5).abs() < 1e-6 && (b.length() - 2.5).abs() < 1e-6);
            assert!(a.dot(b).abs() < 1e-5);
            let found = normal([a.to_array(), b.to_array()]).map(Vec3::from);
            let expected = Vec3::from(n.map(|x| x * 1e20_f32.sqrt())).normalize();
            assert!(
                found.is_some_and(|found| (found - expected).length() < 1e-6),
                "{n:?}"
            );
        }
    }

    #[test]
    fn edges_along_each_other_have_no_normal() {
        assert_eq!(normal([[1.0, 2.0, 3.0], [0.1, 0.2, 0.3]]), None);
        assert_eq!(normal([[0.0; 3], [1.0, 0.0, 0.0]]), None);
        assert_eq!(
            normal([[2e-30, 0.0, 0.0], [0.0, 1e30, 0.0]]),
            Some([0.0, 0.0, 1.0])
        );
    }
}
