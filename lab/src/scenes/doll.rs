//! A doll of wood.

use glam::{Quat, Vec3};
use slimbvh::generate::concatenate;
use slimbvh::generate::{RoundCone, icosphere, round_cone};
use slimbvh::{Camera, Light, Material, Mesh, Projection, Scene};

/// An artist's doll with ball joints, 2 high, in mid-step, as a scene with a camera and a light. Head, chest, hips, hands
/// and feet are ellipsoids, joints are balls, limbs are [`round_cone`]s: 29 solids, which overlap at the joints. About
/// `1116 * 4^subdivisions` triangles, for subdivisions of 1 or more; of 3: 71 424, where the wood doll of Wong, Cheng and
/// Lii ("Reduced BVHs for GPU Ray Tracing", 2012) has 71 450. Half of them face any eye outside.
#[must_use]
pub fn doll(subdivisions: u32) -> Scene {
    let mut doll = Doll {
        subdivisions: subdivisions.max(1),
        mesh: Mesh::default(),
    };
    doll.add_trunk();
    for arm in ARMS {
        doll.add_limb(&arm);
    }
    for leg in LEGS {
        doll.add_limb(&leg);
    }
    let mut scene = Scene {
        mesh: doll.mesh,
        materials: vec![
            Material {
                base_color: [0.78, 0.55, 0.32],
                mirror: 0.03,
                ..Material::default()
            },
            Material {
                base_color: [0.42, 0.24, 0.12],
                mirror: 0.06,
                ..Material::default()
            },
        ],
        cameras: vec![Camera {
            eye: [1.5, 1.35, 3.7],
            target: [0.0, 1.0, 0.0],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 34.0 },
        }],
        ..Scene::default()
    };
    scene.lights.push(Light::beside(&scene.cameras[0]));
    scene
}

/// What solids are made of.
const WOOD: u32 = 0;
const JOINT: u32 = 1;

/// An arm or a leg: shoulder, elbow and wrist, or hip, knee and ankle.
struct Limb {
    joints: [Vec3; 3],
    joint_radii: [f32; 3],
    /// Of the limb's two parts, at both ends.
    radii: [[f32; 2]; 2],
    /// The hand or the foot, from the last joint.
    end: Vec3,
    end_half: Vec3,
    /// Turn of the end about x.
    end_turn: f32,
}

const ARM: Limb = Limb {
    joints: [Vec3::ZERO; 3],
    joint_radii: [0.075, 0.052, 0.038],
    radii: [[0.068, 0.050], [0.054, 0.036]],
    end: Vec3::ZERO,
    end_half: Vec3::new(0.030, 0.095, 0.048),
    end_turn: 0.0,
};

const LEG: Limb = Limb {
    joints: [Vec3::ZERO; 3],
    joint_radii: [0.092, 0.072, 0.048],
    radii: [[0.098, 0.068], [0.074, 0.046]],
    end: Vec3::new(0.0, -0.045, 0.085),
    end_half: Vec3::new(0.055, 0.042, 0.145),
    end_turn: 0.0,
};

/// One raised in greeting, one swung back.
const ARMS: [Limb; 2] = [
    Limb {
        joints: [
            Vec3::new(0.27, 1.52, 0.0),
            Vec3::new(0.56, 1.43, 0.06),
            Vec3::new(0.68, 1.70, 0.12),
        ],
        end: Vec3::new(0.035, 0.105, 0.02),
        end_turn: 0.15,
        ..ARM
    },
    Limb {
        joints: [
            Vec3::new(-0.27, 1.52, 0.0),
            Vec3::new(-0.39, 1.22, -0.07),
            Vec3::new(-0.40, 0.95, 0.10),
        ],
        end: Vec3::new(-0.005, -0.10, 0.065),
        end_turn: -0.55,
        ..ARM
    },
];

/// One in front, one behind on its toes.
const LEGS: [Limb; 2] = [
    Limb {
        joints: [
            Vec3::new(0.13, 0.93, 0.01),
            Vec3::new(0.15, 0.52, -0.05),
            Vec3::new(0.15, 0.14, -0.27),
        ],
        end: Vec3::new(0.0, -0.07, 0.045),
        end_turn: 0.65,
        ..LEG
    },
    Limb {
        joints: [
            Vec3::new(-0.13, 0.93, 0.01),
            Vec3::new(-0.15, 0.52, 0.16),
            Vec3::new(-0.15, 0.09, 0.16),
        ],
        ..LEG
    },
];

/// The solids so far.
struct Doll {
    subdivisions: u32,
    mesh: Mesh,
}

impl Doll {
    fn add_trunk(&mut self) {
        let fine = self.subdivisions + 1;
        let upright = |y: f32| Vec3::new(0.0, y, 0.0);
        let nod = Quat::from_rotation_y(0.25) * Quat::from_rotation_x(0.06);
        let head = Vec3::new(0.0, 1.86, 0.015);
        self.add_ellipsoid(head, Vec3::new(0.105, 0.145, 0.125), nod, fine, WOOD);
        let none = Quat::IDENTITY;
        self.add_ellipsoid(
            upright(1.40),
            Vec3::new(0.215, 0.235, 0.135),
            none,
            fine,
            WOOD,
        );
        self.add_ellipsoid(
            upright(0.98),
            Vec3::new(0.180, 0.140, 0.125),
            none,
            fine,
            WOOD,
        );
        self.add_ball(upright(1.675), 0.062);
        self.add_ball(upright(1.15), 0.105);
    }

    fn add_limb(&mut self, limb: &Limb) {
        for (joint, radius) in limb.joints.iter().zip(limb.joint_radii) {
            self.add_ball(*joint, radius);
        }
        for (part, radii) in limb.radii.into_iter().enumerate() {
            let [from, to] = [limb.joints[part], limb.joints[part + 1]];
            // Parts begin and end inside the joints.
            let ends = [from.lerp(to, 0.12), from.lerp(to, 0.90)];
            self.add_part(&round_cone(&RoundCone {
                ends,
                radii,
                sides: 6 << self.subdivisions,
                bands: (11 << self.subdivisions) / 2,
            }));
        }
        let end = limb.joints[2] + limb.end;
        let turn = Quat::from_rotation_x(limb.end_turn);
        self.add_ellipsoid(end, limb.end_half, turn, self.subdivisions, WOOD);
    }

    fn add_part(&mut self, part: &Mesh) {
        self.add(part, WOOD);
    }

    fn add_ball(&mut self, center: Vec3, radius: f32) {
        self.add(&icosphere(center, radius, self.subdivisions), JOINT);
    }

    fn add_ellipsoid(&mut self, center: Vec3, half: Vec3, turn: Quat, subdivisions: u32, of: u32) {
        let mut ball = icosphere(Vec3::ZERO, 1.0, subdivisions);
        for vertex in &mut ball.vertices {
            *vertex = (center + turn * (half * Vec3::from(*vertex))).to_array();
        }
        for normal in &mut ball.normals {
            *normal = (turn * (Vec3::from(*normal) / half)).normalize().to_array();
        }
        self.add(&ball, of);
    }

    fn add(&mut self, solid: &Mesh, material: u32) {
        concatenate(&mut self.mesh, solid);
        let count = self.mesh.indices.len();
        self.mesh.materials.resize(count, material);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::internals::{assert_solid, assert_unit_normals};

    #[test]
    fn every_part_is_solid() {
        let mesh = doll(1).mesh;
        assert_unit_normals(&mesh);
        assert_eq!(assert_solid(&mesh).len(), 29);
        let bounds = mesh.bounds().unwrap();
        assert!(
            bounds.min.y.abs() < 0.03 && (bounds.max.y - 2.0).abs() < 0.02,
            "{bounds:?}"
        );
        // Joined: every part's box meets another's.
        let components = assert_solid(&mesh);
        for (i, a) in components.iter().enumerate() {
            let meets = |b: &slimbvh::analysis::Component| {
                let (a, b) = (a.bounds, b.bounds);
                a.min.cmple(b.max).all() && b.min.cmple(a.max).all()
            };
            let others = components.iter().enumerate().filter(|(j, _)| *j != i);
            assert!(others.map(|(_, b)| b).any(meets));
        }
    }

    #[test]
    fn triangles() {
        assert_eq!(doll(3).mesh.indices.len(), 71_424);
        assert_eq!(doll(3).mesh.validate(), Ok(()));
    }
}
