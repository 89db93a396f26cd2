use super::methods::Method;
use super::*;
use crate::measure::counts::count;
use crate::measure::step::Step;
use crate::measure::walks::Walks;
use slimbvh::{Builder, Bvh, LatticeBits, Picture, RenderSettings, Renderer, Trees, WideStore};

const SETTINGS: RenderSettings = RenderSettings {
    size: [48, 32],
    sample_count: 1,
    view: slimbvh::View::Color,
    mirror_depth: 8,
    dark_rays: false,
};

/// The counted rays are as many as the rendered ones, of every kind.
#[test]
fn the_rays_counted_are_those_of_the_picture() {
    let subject = Subject::new(SceneName::Shiny, None, SETTINGS.size).unwrap();
    let wide = Method::WideMesh(WideStore::Packed, Step::Pixels(0.5));
    for method in [Method::Plain, Method::Node, Method::JUDGED, wide] {
        let prepared = method.prepare(&subject.scene, &SETTINGS);
        let mut bvh = Bvh::default();
        let mesh = &prepared.scene.mesh;
        Builder::new(prepared.config)
            .build_into(mesh, &mut bvh)
            .unwrap();
        let walks = Walks::new(&Trees::all(&bvh, prepared.scene.lights.len()));
        let counts = count(&prepared.scene, &walks, &SETTINGS).unwrap();
        let mut picture = Picture::default();
        let rendered =
            Renderer::new().render(&prepared.scene, &bvh, &SETTINGS, &mut picture, |_| {});
        let report = rendered.unwrap();
        assert_eq!(counts.eye.rays, report.primary_ray_count);
        assert_eq!(counts.shadow.rays, report.shadow_ray_count);
        assert_eq!(counts.secondary.rays, report.mirror_ray_count);
        let hits = counts.seen.iter().filter(|seen| seen.is_anything()).count();
        assert_eq!(hits as u64, report.primary_hit_count);
        assert!(counts.secondary.rays > 500);
    }
}

/// Bytes read per lattice triangle lie between those of the smallest and the largest leaf, and fall with a coarser step.
#[test]
fn coarser_meshes_are_less_to_read() {
    let protocol = Protocol {
        size: SETTINGS.size,
        rounds: 1,
        aimed_rays: 2000,
        mirror_depth: 0,
    };
    let subject = Subject::new(SceneName::Bunny, None, SETTINGS.size).unwrap();
    let record = measure(subject, &Chosen::Cpu, &protocol).unwrap();
    let of = |method| record.of(method).unwrap();
    let read = |method| {
        of(method).counts.all().triangle_bytes as f64 / of(method).counts.all().triangles as f64
    };
    let steps = [Step::Finest, Step::Pixels(0.1), Step::Pixels(0.5)];
    let exact = |step| Method::WideMesh(WideStore::Exact, step);
    let stores: [fn(Step) -> Method; 2] = [Method::LatticeMesh, exact];
    for store in stores {
        let [finest, fine, coarse] = steps.map(|step| read(store(step)));
        assert!(
            finest <= 40.0 && finest > fine && fine >= coarse && coarse >= 16.0,
            "{finest} {fine} {coarse}"
        );
    }
    // Where corners are shared, triangles are stored in fewer bytes, but a ray reads two or four more of each.
    let packed = |step| Method::WideMesh(WideStore::Packed, step);
    let stored = |method| of(method).triangle_bytes;
    let [finest, fine, coarse] = steps.map(|step| stored(packed(step)));
    // All corners are narrow at both coarse steps, over leaves that are not quite the same.
    assert!(finest > fine && finest > coarse, "{finest} {fine} {coarse}");
    for step in steps {
        assert!(
            4 * stored(packed(step)) < 3 * stored(exact(step)),
            "{step:?}"
        );
        let more = read(packed(step)) - read(exact(step));
        assert!(more > 0.0 && more < 4.0, "{more}");
    }
    assert_eq!(read(Method::Plain), 40.0);
    assert_eq!(read(Method::NodeMesh), 16.0);

    // Nodes of any bits change no pixel, and our codecs leave no cracks.
    let is_same = |own: &measure::MethodRecord| {
        own.differences.changed + own.differences.lost + own.differences.gained == 0
    };
    for bits in LatticeBits::ALL {
        assert!(is_same(of(Method::Lattice(bits))), "{bits:?}");
    }
    for store in [WideStore::Full, WideStore::Exact] {
        assert!(is_same(of(Method::Wide(store))), "{store:?}");
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
    // Fewer bits open more nodes.
    let nodes = |bits| of(Method::Lattice(bits)).counts.all().nodes;
    assert!(nodes(LatticeBits::Q4) > nodes(LatticeBits::Q10));
    assert!(nodes(LatticeBits::Q10) >= nodes(LatticeBits::Q21));

    // Nodes of four children are opened less often and test more boxes each. They are read again for leaves on the lattice alone.
    let all = |method| of(method).counts.all();
    let plain = all(Method::Plain);
    assert_eq!(plain.boxes, 2 * plain.nodes);
    let full = all(Method::WIDE);
    assert!(full.nodes < plain.nodes && full.boxes > 2 * full.nodes);
    assert!(full.boxes <= 4 * full.nodes);
    for (method, bytes) in [(Method::WIDE, 128), (Method::Wide(WideStore::Exact), 64)] {
        assert_eq!(all(method).node_bytes, bytes * all(method).nodes);
    }
    let packed = all(Method::WideMesh(WideStore::Packed, Step::Finest));
    assert!(packed.node_bytes > 48 * packed.nodes);
    assert!(packed.node_bytes.is_multiple_of(48));
}

/// Any adapter, limited to bindings of one mebibyte. Without one the test is skipped with a notice, or fails under
/// `REQUIRE_GPU`.
#[cfg(feature = "gpu")]
fn short_sighted() -> Option<slimbvh::gpu::Gpu> {
    use slimbvh::gpu::{Gpu, wgpu};
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::PRIMARY));
    let Some(adapter) = adapters.into_iter().next() else {
        let is_required = std::env::var_os("REQUIRE_GPU").is_some_and(|value| value != "0");
        assert!(!is_required, "REQUIRE_GPU, but there is none");
        eprintln!("THE TESTS OF THE PAPERS ON A GPU ARE SKIPPED: there is none");
        return None;
    };
    let mut required_limits = adapter.limits();
    required_limits.max_storage_buffer_binding_size = 1 << 20;
    let opened = adapter.request_device(&wgpu::DeviceDescriptor {
        label: Some("slimbvh tests"),
        required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
        required_limits,
        ..wgpu::DeviceDescriptor::default()
    });
    let (device, queue) = pollster::block_on(opened).unwrap();
    Some(Gpu::from_device(device, queue).unwrap())
}

/// A scene that the GPU cannot hold is left out if it was not named, and is an error if it was.
#[cfg(feature = "gpu")]
#[test]
fn what_the_gpu_does_not_take_is_left_out_and_all_else_measured() {
    use clap::Parser;
    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        arguments: CompressedArguments,
    }
    let Some(gpu) = short_sighted() else { return };
    let chosen = Chosen::Gpu(gpu);
    let protocol = Protocol {
        size: SETTINGS.size,
        rounds: 1,
        aimed_rays: 2000,
        mirror_depth: 2,
    };
    let parse = |words: &[&str]| Line::parse_from(words).arguments.options;
    let named = parse(&["compressed", "--only", "bunny"]);
    let refused = measure_all(&named, &chosen, &protocol, &[]);
    let error = refused.map(|_| ()).unwrap_err();
    assert!(is_too_large(&error), "{error:#}");

    let all = parse(&["compressed", "--quick"]);
    let (records, left_out) = measure_all(&all, &chosen, &protocol, &[]).unwrap();
    let scenes: Vec<&str> = left_out.iter().map(|it| it.scene.as_str()).collect();
    assert_eq!((records.len(), scenes), (1, vec!["bunny", "dragon"]));
    assert!(left_out[0].why.contains("1048576"), "{}", left_out[0].why);
    for own in &records[0].methods {
        // Only methods that the GPU has are there.
        assert!(!own.name.starts_with('q'), "{}", own.name);
        assert!(!own.rounds.0.is_empty(), "{}", own.name);
        let on_gpu = own.on_gpu.unwrap();
        assert!(on_gpu.buffers.tree >= own.bytes() as u64);
        assert!(on_gpu.likeness.rays > 1000 && on_gpu.likeness.pixels == 48 * 32);
        let is_coded = own.method != Method::Plain;
        let frames = own.rounds.0.iter().map(|round| &round.own);
        for frame in frames {
            assert_eq!(frame.encoding > 0.0, is_coded, "{}", own.name);
            assert!(frame.construction > 0.0 && frame.rendering > 0.0);
        }
    }
    let report = Report::new(&all, &chosen, protocol, (records, left_out));
    let text = report.sheet().text();
    for part in ["left out", "bunny: the nodes would take"] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    assert!(!text.contains("q10"), "{text}");
    assert!(!text.contains("NaN"), "{text}");
}

/// Negative control: a tree in another codec, and a tree over a scene that was moved a little, differ from the counted one.
#[cfg(feature = "gpu")]
#[test]
fn what_the_gpu_timed_is_compared_with_what_was_counted() {
    use crate::reproduce::steps::Steps;
    use bench::agreement;
    use slimbvh::Cpu;
    let Some(gpu) = short_sighted() else { return };
    let scene = Subject::new(SceneName::Shiny, None, SETTINGS.size)
        .unwrap()
        .scene;
    let mut other = scene.clone();
    for [x, ..] in &mut other.mesh.vertices {
        *x *= 1.25;
    }
    let exact = Method::Wide(WideStore::Exact);
    let compare = |on_gpu: (Method, &slimbvh::Scene), on_cpu: (Method, &slimbvh::Scene)| {
        let [a, b] = [on_gpu, on_cpu].map(|(method, scene)| method.prepare(scene, &SETTINGS));
        let mut steps = Steps::new(&gpu, a.config, &a.scene, None).unwrap();
        let mut own = Steps::new(Cpu, b.config, &b.scene, None).unwrap();
        steps.build_all().unwrap();
        steps.render_all(&SETTINGS).unwrap();
        own.build_all().unwrap();
        own.render_all(&SETTINGS).unwrap();
        agreement::record(&steps, &own, &SETTINGS)
    };
    let likeness = compare((exact, &scene), (exact, &scene)).unwrap().likeness;
    assert!(likeness.pixels_unlike <= likeness.pixels / 1000);
    let said = |result: Result<bench::GpuRecord>| result.map(|_| ()).unwrap_err().to_string();
    let bytes = said(compare((exact, &scene), (Method::Plain, &scene)));
    assert!(bytes.contains("bytes on the GPU"), "{bytes}");
    let either = said(compare((exact, &other), (exact, &scene)));
    let is_told = ["bytes on the GPU", "count different"];
    assert!(is_told.iter().any(|part| either.contains(part)), "{either}");
}
