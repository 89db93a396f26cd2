use super::*;
use crate::geometry::ray::{Hit, Ray};
use crate::geometry::triangle::Triangle;
use crate::shade::{Environment, Path, ambient_light};
use proptest::prelude::*;

const GLASS: Material = Material {
    base_color: [1.0; 3],
    mirror: 0.0,
    transmission: 1.0,
    ior: 1.5,
    padding: [0; 2],
};

/// A point of the floor y = 0, whose front faces up.
fn floor(direction: Vec3, normals: [Vec3; 3]) -> Surface {
    let triangle = Triangle {
        v0: Vec3::new(0.0, 0.0, 0.0),
        v1: Vec3::new(0.0, 0.0, 1.0),
        v2: Vec3::new(1.0, 0.0, 0.0),
    };
    let hit = Hit {
        t: 1.0,
        u: 0.25,
        v: 0.5,
        primitive: 3,
    };
    Surface::new(triangle, &hit, direction, normals)
}

fn flat(material: &Material, direction: Vec3) -> Onward {
    material.onward(&floor(direction, [Vec3::ZERO; 3]), direction)
}

fn assert_near(found: Vec3, expected: [f32; 3]) {
    let expected = Vec3::from_array(expected);
    assert!(
        (found - expected).length() < 1e-6,
        "{found}, not {expected}"
    );
}

#[test]
fn rays_bend_by_snells_law() {
    // 45° into 1.5: the sine is √½ / 1.5 = 0.4714045, 28.1255°.
    let down = flat(&GLASS, Vec3::new(2.0, -2.0, 0.0));
    assert_near(down.direction, [0.471_404_5, -0.881_917_1, 0.0]);
    assert!(down.origin.y < 0.0);
    // And back out of it at 45°.
    let up = flat(&GLASS, Vec3::new(0.471_404_5, 0.881_917_1, 0.0));
    assert_near(up.direction, [0.707_106_77, 0.707_106_77, 0.0]);
    assert!(up.origin.y > 0.0);
    // 30° out of 1.5: the sine is 0.75, 48.5904°.
    let out = flat(&GLASS, Vec3::new(0.0, 0.866_025_4, -0.5));
    assert_near(out.direction, [0.0, 0.661_437_8, -0.75]);
    // Straight on, and where nothing changes.
    assert_near(
        flat(&GLASS, Vec3::new(0.0, -4.0, 0.0)).direction,
        [0.0, -1.0, 0.0],
    );
    let air = Material { ior: 1.0, ..GLASS };
    assert_near(
        flat(&air, Vec3::new(3.0, -4.0, 0.0)).direction,
        [0.6, -0.8, 0.0],
    );
}

#[test]
fn beyond_the_critical_angle_glass_mirrors_from_inside() {
    // The sine of the critical angle is 1 / 1.5, the angle 41.8103°.
    let at = |degrees: f32| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        flat(&GLASS, Vec3::new(sin, cos, 0.0))
    };
    let passed = at(41.8);
    assert!(passed.direction.y > 0.0 && passed.direction.y < 0.03);
    assert!(passed.origin.y > 0.0);
    for degrees in [41.82_f32, 60.0, 89.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let mirrored = at(degrees);
        assert_near(mirrored.direction, [sin, -cos, 0.0]);
        assert!(mirrored.origin.y < 0.0);
    }
    // From outside all passes, however flat.
    let grazing = flat(&GLASS, Vec3::new(1.0, -1e-4, 0.0));
    assert!(grazing.direction.y < -0.7 && grazing.origin.y < 0.0);
}

#[test]
fn glass_counts_before_mirrors_and_tints() {
    let both = Material {
        base_color: [0.5, 1.0, 0.25],
        mirror: 0.75,
        transmission: 0.5,
        ..GLASS
    };
    assert_eq!(both.onward_share(), 0.5);
    assert_eq!(both.onward_color(), Vec3::new(0.25, 0.5, 0.125));
    assert!(flat(&both, Vec3::new(0.0, -1.0, 0.0)).direction.y < 0.0);
    let mirror = Material {
        transmission: 0.0,
        ..both
    };
    assert_eq!(mirror.onward_color(), Vec3::splat(0.75));
    assert!(flat(&mirror, Vec3::new(0.0, -1.0, 0.0)).direction.y > 0.0);
}

fn share() -> impl Strategy<Value = f32> {
    prop_oneof![Just(0.0), Just(1.0), 0.0f32..1.0]
}

fn vector() -> impl Strategy<Value = Vec3> {
    proptest::array::uniform3(-1.0f32..1.0).prop_map(Vec3::from_array)
}

proptest! {
    /// Where light of 1 comes from everywhere, no more than 1 goes on and is reflected to all sides together.
    #[test]
    fn no_light_is_created(base_color in proptest::array::uniform3(share()), mirror in share(), transmission in share(), ior in 0.25f32..4.0, direction in vector()) {
        let material = Material { base_color, mirror, transmission, ior, padding: [0; 2] };
        let environment = Environment { ambient: [core::f32::consts::PI; 3], ..Environment::default() };
        let direction = Vec3::new(direction.x, -direction.y.abs() - 1e-3, direction.z);
        let path = Path::new(Ray::new([0.0, 1.0, 0.0], direction.to_array()), 0);
        let next = path.scattered(&floor(direction, [Vec3::ZERO; 3]), &material, 3);
        let scattered = ambient_light(&material, &environment);
        for channel in 0..3 {
            let sum = next.throughput[channel] * f32::from(u8::from(next.is_alive())) + scattered[channel];
            prop_assert!(sum <= 1.0 + 1e-6, "{sum}");
        }
        prop_assert!(!next.is_alive() || next.skip == 3);
    }

    /// On the right side of the triangle, whatever the smooth normal; of unit length where bent.
    #[test]
    fn paths_go_on_where_they_may(ior in 0.25f32..4.0, direction in vector(), normal in vector()) {
        prop_assume!(direction.y.abs() > 1e-3);
        let material = Material { ior, ..GLASS };
        let surface = floor(direction, [normal; 3]);
        let Onward { origin, direction: next } = material.onward(&surface, direction);
        let (origin, side) = (origin.dot(surface.normal), next.dot(surface.normal));
        prop_assert!(origin * side > 0.0, "{origin} {side}");
        if side < 0.0 {
            prop_assert!((next.length() - 1.0).abs() < 1e-5);
            // There and back again, where the normal is the triangle's.
            let flat = floor(direction, [Vec3::ZERO; 3]);
            let there = material.onward(&flat, direction).direction;
            if there.dot(flat.normal) < -1e-2 {
                let back = material.onward(&floor(-there, [Vec3::ZERO; 3]), -there).direction;
                prop_assert!((back + normalize(direction)).length() < 1e-3, "{back} {direction}");
            }
        }
    }
}
