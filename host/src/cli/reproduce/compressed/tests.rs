use super::methods::{Method, Step};
use super::*;
use slimbvh::{Builder, Bvh, LatticeBits, Picture, RenderSettings, Renderer};

const SETTINGS: RenderSettings = RenderSettings {
    size: [48, 32],
    sample_count: 1,
    view: slimbvh::View::Color,
    mirror_depth: 8,
    dark_rays: false,
};

/// As many rays are counted as are rendered, of every kind.
#[test]
fn the_rays_counted_are_those_of_the_picture() {
    let subject = Subject::new(SceneName::Shiny, None, SETTINGS.size).unwrap();
    for method in [Method::Plain, Method::Node, Method::JUDGED] {
        let prepared = method.prepare(&subject.scene, &SETTINGS);
        let mut bvh = Bvh::default();
        let mesh = &prepared.scene.mesh;
        Builder::new(prepared.config)
            .build_into(mesh, &mut bvh)
            .unwrap();
        let decoded = bvh.decoded();
        let counts = counts::count(&prepared, (&bvh, Some(&decoded)), &SETTINGS).unwrap();
        let mut picture = Picture::default();
        let rendered =
            Renderer::new().render(&prepared.scene, &bvh, &SETTINGS, &mut picture, |_| {});
        let report = rendered.unwrap();
        assert_eq!(counts.eye.rays, report.primary_ray_count);
        assert_eq!(counts.shadow.rays, report.shadow_ray_count);
        assert_eq!(counts.secondary.rays, report.mirror_ray_count);
        let hits = counts.hits.iter().filter(|hit| **hit).count();
        assert_eq!(hits as u64, report.primary_hit_count);
        assert!(counts.secondary.rays > 500);
    }
}

/// What is read of triangles on the lattice is between the least and the most that a leaf takes, and less the coarser it is.
#[test]
fn coarser_meshes_are_less_to_read() {
    let protocol = Protocol {
        size: SETTINGS.size,
        rounds: 1,
        aimed_rays: 2000,
        mirror_depth: 0,
    };
    let subject = Subject::new(SceneName::Bunny, None, SETTINGS.size).unwrap();
    let record = measure(subject, &protocol).unwrap();
    let of = |method| record.of(method).unwrap();
    let read = |method| {
        of(method).counts.all().triangle_bytes as f64 / of(method).counts.all().triangles as f64
    };
    let [finest, fine, coarse] = [Step::Finest, Step::Pixels(0.1), Step::Pixels(0.5)]
        .map(|step| read(Method::LatticeMesh(step)));
    assert!(
        finest <= 40.0 && finest > fine && fine >= coarse && coarse >= 16.0,
        "{finest} {fine} {coarse}"
    );
    assert_eq!(read(Method::Plain), 40.0);
    assert_eq!(read(Method::NodeMesh), 16.0);

    // Nodes change nothing, in whatever bits, and nothing of ours lets rays in.
    let is_same = |own: &measure::MethodRecord| {
        own.differences.changed + own.differences.lost + own.differences.gained == 0
    };
    for bits in LatticeBits::ALL {
        assert!(is_same(of(Method::Lattice(bits))), "{bits:?}");
    }
    assert!(is_same(of(Method::Node)));
    let leaked = |method| of(method).cracks.unwrap().leaked;
    for own in &record.methods {
        assert_eq!(
            leaked(own.method) > 0,
            own.method == Method::NodeMesh,
            "{}",
            own.name
        );
        if let Some([moved, bound]) = own.moved {
            assert!(
                moved > 0.0 && moved <= bound,
                "{}: {moved} {bound}",
                own.name
            );
        }
    }
    // Fewer bits let more through.
    let nodes = |bits| of(Method::Lattice(bits)).counts.all().nodes;
    assert!(nodes(LatticeBits::Q4) > nodes(LatticeBits::Q10));
    assert!(nodes(LatticeBits::Q10) >= nodes(LatticeBits::Q21));
}
