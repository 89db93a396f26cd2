//! Cases from meshes of one's own.

use super::Effort;
use super::families::Case;
use slimbvh::internals::SolidAngle;
use slimbvh::topology::Topology;
use slimbvh::{Builder, CodeBits, Mesh, MeshError, Ray};

/// The number of exact tests of a ray and a triangle that a case may take, about: 250 rays through 100,000 triangles. Larger
/// meshes get fewer rays.
const TESTS: [u64; 2] = [5_000_000, 25_000_000];

/// The most rays, as for built-in scenes, and the least.
const MOST_RAYS: [u32; 2] = [600, 5000];
const LEAST_RAYS: u64 = 48;

/// The number of triangles that are tried for a point inside.
const TRIES: usize = 64;

impl Case {
    /// A mesh of one's own under this name. Its number of rays falls with its number of triangles.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`].
    pub fn own(name: String, mesh: Mesh, effort: Effort) -> Result<Self, MeshError> {
        mesh.validate()?;
        let which = usize::from(effort == Effort::Full);
        let count = mesh.indices.len().max(1) as u64;
        let rays = (TESTS[which] / count).clamp(LEAST_RAYS, MOST_RAYS[which].into());
        Ok(Self {
            family: name.into(),
            magnitude: format!("{count} triangles"),
            inside: point_inside(&mesh)?,
            mesh,
            code_bits: CodeBits::Bits30,
            eye: None,
            ray_count: rays as usize,
        })
    }
}

/// A point inside, if all surfaces are closed and wound alike; `None` if none is found. The judge checks it again, exactly.
fn point_inside(mesh: &Mesh) -> Result<Option<[f32; 3]>, MeshError> {
    let topology = Topology::new(mesh);
    let facts = topology.facts();
    if facts.is_empty() || !facts.iter().all(|facts| facts.reducible) {
        return Ok(None);
    }
    let bvh = Builder::default().build(mesh)?;
    let step = mesh.indices.len().div_ceil(TRIES).max(1);
    let candidates = mesh.indices.iter().step_by(step);
    let mut between = candidates.filter_map(|&face| {
        // Through the triangle's middle, against its normal: the next hit is the other side of the solid.
        let [a, b, c] = face.map(|v| mesh.vertices[v as usize].map(f64::from));
        let middle = [0, 1, 2].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0);
        let (e1, e2) = (minus(b, a), minus(c, a));
        let normal = [0, 1, 2].map(|axis| {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            e1[j] * e2[k] - e1[k] * e2[j]
        });
        let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        let bounds = mesh.bounds()?;
        let size = f64::from((bounds.max - bounds.min).max_element());
        let way = normal.map(|x| x / length * size);
        let origin = [0, 1, 2].map(|axis| (middle[axis] + way[axis]) as f32);
        let ray = Ray::new(origin, way.map(|x| -x as f32));
        let hits = bvh.all_hits(ray);
        // From hit to hit the ray is inside and outside by turns; the longest way has the most room.
        let gaps = hits.windows(2).map(|pair| [pair[0].t, pair[1].t]);
        let longest = gaps.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
        let t = 0.5 * (longest[0] + longest[1]);
        let point = [0, 1, 2].map(|axis| ray.origin[axis] + t * ray.direction[axis]);
        is_around(mesh, point).then_some(point)
    });
    Ok(between.next())
}

/// Whether the surfaces certainly wind around a point.
fn is_around(mesh: &Mesh, point: [f32; 3]) -> bool {
    let triangles = mesh.indices.iter();
    let triangles = triangles.map(|face| face.map(|v| mesh.vertices[v as usize]));
    let turns = SolidAngle::of(triangles, point.map(f64::from)).winding_number();
    turns.is_some_and(|turns| turns != 0)
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use slimbvh::generate::{icosphere, soup};

    #[test]
    fn points_inside_are_found_in_solids_only() {
        let ball = icosphere(Vec3::new(5.0, -3.0, 2.0), 1.0, 3);
        let case = Case::own("ball.ply".into(), ball.clone(), Effort::Quick).expect("it is sound");
        let inside = case.inside.map(Vec3::from).expect("it is closed");
        assert!(
            (inside - Vec3::new(5.0, -3.0, 2.0)).length() < 0.9,
            "{inside}"
        );
        assert_eq!((&*case.family, case.ray_count), ("ball.ply", 600));
        // One triangle less, and there is no inside.
        let mut open = ball;
        open.indices.pop();
        assert_eq!(point_inside(&open), Ok(None));
        assert_eq!(point_inside(&soup(100, 1)), Ok(None));
    }

    #[test]
    fn larger_meshes_get_fewer_rays() {
        let of = |count, effort| {
            let case = Case::own(String::new(), soup(count, 1), effort);
            case.expect("it is sound").ray_count
        };
        assert_eq!([of(100, Effort::Quick), of(100, Effort::Full)], [600, 5000]);
        assert_eq!(of(50_000, Effort::Quick), 100);
        assert_eq!(of(50_000, Effort::Full), 500);
        assert_eq!(of(200_000, Effort::Quick), 48);
    }
}
