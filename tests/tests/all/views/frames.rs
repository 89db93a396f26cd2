//! View sets from frame to frame.

use super::rays::{answers, rays_of};
use super::{config, meshes, targets, twisted};
use slimbvh::reduce::Reduce;
use slimbvh::{Change, Cpu, FrameConfig, Mesh, ViewSets, ViewTarget};
use slimbvh_tests::gpu::done;

/// Trees that were kept, refitted or built again answer as new ones.
#[test]
fn trees_that_follow_answer_as_new_ones() {
    for mesh in meshes() {
        for reduce in [Reduce::On, Reduce::Off] {
            let mut views = ViewSets::new(Cpu, config(reduce));
            for (angle, change) in [
                (0.0, Change::View), // the first builds, whatever it is told
                (0.0, Change::View),
                (0.1, Change::Vertices),
                (0.2, Change::Vertices),
                (0.2, Change::View),
                (0.9, Change::Scene),
            ] {
                let mesh = twisted(&mesh, angle);
                done(views.update(&mesh, &targets(), change));
                let mut fresh = ViewSets::new(Cpu, config(reduce));
                done(fresh.update(&mesh, &targets(), Change::Scene));
                let rays = rays_of(&mesh, &fresh);
                assert_eq!(answers(&views, &rays), answers(&fresh, &rays), "{angle}");
            }
        }
    }
}

/// Targets may move, come and go while the mesh stays.
#[test]
fn targets_may_change_from_frame_to_frame() {
    let mesh = &meshes()[1];
    let mut views = ViewSets::new(Cpu, config(Reduce::On));
    done(views.update(mesh, &targets()[..1], Change::Scene));
    assert_eq!(views.trees().len(), 1);
    done(views.update(mesh, &targets(), Change::View));
    let mut fresh = ViewSets::new(Cpu, config(Reduce::On));
    done(fresh.update(mesh, &targets(), Change::Scene));
    let rays = rays_of(mesh, &fresh);
    assert_eq!(answers(&views, &rays), answers(&fresh, &rays));
    done(views.update(mesh, &[], Change::View));
    assert!(views.trees().is_empty());
}

/// A caller who forgets to say that the mesh is another one gets its trees all the same, where the counts tell.
#[test]
fn another_mesh_is_noticed_by_its_counts() {
    let [first, .., last] = &meshes()[..] else {
        unreachable!()
    };
    let mut views = ViewSets::new(Cpu, config(Reduce::On));
    done(views.update(first, &targets(), Change::Scene));
    done(views.update(last, &targets(), Change::View));
    let mut fresh = ViewSets::new(Cpu, config(Reduce::On));
    done(fresh.update(last, &targets(), Change::Scene));
    let rays = rays_of(last, &fresh);
    assert_eq!(answers(&views, &rays), answers(&fresh, &rays));
}

/// Without a promise that no part comes to intersect itself, nothing is left out once vertices have moved.
#[test]
fn a_mesh_that_bends_stays_whole_without_a_promise() {
    let mesh = &meshes()[0];
    let mut settings = config(Reduce::On);
    settings.plan.switches.seams = slimbvh::reduce::Seams::Find;
    let mut views = ViewSets::new(Cpu, settings);
    let mut is_plain = |angle, change| {
        done(views.update(&twisted(mesh, angle), &targets(), change));
        views.plan().is_some_and(slimbvh::reduce::Plan::is_plain)
    };
    assert!(!is_plain(0.0, Change::Scene));
    assert!(!is_plain(0.0, Change::View));
    assert!(is_plain(0.1, Change::Vertices));
    assert!(is_plain(0.1, Change::View));
    assert!(!is_plain(0.1, Change::Scene));
}

#[test]
fn a_mesh_that_is_unfit_is_refused_and_the_next_one_is_built() {
    let mut broken = meshes().swap_remove(0);
    let mut views = ViewSets::new(Cpu, FrameConfig::default());
    done(views.update(&broken, &targets(), Change::Scene));
    broken.vertices[3] = [f32::NAN, 0.0, 0.0];
    let refused = views.update(&broken, &targets(), Change::Vertices);
    let message = refused.expect_err("it is not finite").to_string();
    assert!(message.contains("vertex 3"), "{message}");
    assert!(views.trees().is_empty());
    let mesh = &meshes()[0];
    done(views.update(mesh, &targets(), Change::View));
    let one: Vec<ViewTarget> = targets();
    assert_eq!(views.trees().len(), one.len());
}

fn on_cpu(mesh: &Mesh, targets: &[ViewTarget], settings: FrameConfig) -> ViewSets<Cpu> {
    let mut views = ViewSets::new(Cpu, settings);
    done(views.update(mesh, targets, Change::Scene));
    views
}

/// A tree that was a set, then the whole one for another target, and is asked for the first target's rule, has that rule.
#[test]
fn a_rule_is_that_of_the_present_target() {
    let mesh = &meshes()[1];
    let mut views = ViewSets::new(Cpu, config(Reduce::Auto));
    let probe = |x: f32, count: u64| {
        let target = done(ViewTarget::rays_from([x, 0.4, 1.0], 0.3));
        [target.expecting(count), ViewTarget::other_rays()]
    };
    // Few rays take the whole tree, which is there for others, many a set.
    for (x, count, change) in [
        (-2.0, 1 << 30, Change::Scene),
        (2.0, 1, Change::View),
        (-2.0, 1, Change::View),
    ] {
        done(views.update(mesh, &probe(x, count), change));
        let has_set = views.trees()[0].rule.is_none();
        assert_eq!(has_set, count > 1, "{}", views.explain());
        let mut fresh = config(Reduce::Off);
        fresh.plan.switches.cull = Some(slimbvh::reduce::Cull::On);
        let fresh = on_cpu(mesh, &probe(x, count), fresh);
        let mut random = slimbvh_tests::random::Random::new(3);
        for _ in 0..500 {
            let direction = [0; 3].map(|_| 2.0 * random.unit() - 1.0);
            let ray = slimbvh::Ray::new([x, 0.4, 1.0], direction);
            let [hit, expected] = [&views, &fresh].map(|views| views.trees()[0].closest_hit(ray));
            assert_eq!(hit, expected, "{x}");
        }
    }
}

/// A set that was the only tree may be sorted alone; what comes after it takes all triangles again.
#[test]
fn a_set_that_was_sorted_alone_is_not_the_order_of_the_next_frame() {
    let mesh = &meshes()[0];
    let mut settings = FrameConfig::default().reducing().promising_solids();
    settings.update = slimbvh::animate::Update::Auto;
    let eye = |x: f32| [done(ViewTarget::rays_from([x, 0.7, 3.0], 0.0))];
    let mut views = on_cpu(mesh, &eye(-2.0), settings);
    for (x, angle, change) in [
        (2.0, 0.0, Change::View),
        (2.0, 0.1, Change::Vertices),
        (-2.0, 0.1, Change::View),
    ] {
        let mesh = twisted(mesh, angle);
        done(views.update(&mesh, &eye(x), change));
        let expected = on_cpu(&mesh, &eye(x), settings);
        let counts = [&views, &expected].map(|views| views.trees()[0].bvh.triangle_count());
        assert_eq!(counts[0], counts[1], "{x} {angle}");
    }
}

/// Vertices that were refitted in a whole tree are where sets find them that are built later.
#[test]
fn sets_after_a_refit_are_of_the_present_vertices() {
    let mesh = &meshes()[1];
    let few = [ViewTarget::other_rays().expecting(1)];
    let mut settings = config(Reduce::Auto);
    settings.plan.switches.cull = None;
    let mut views = on_cpu(mesh, &few, settings);
    assert!(views.plan().is_some_and(slimbvh::reduce::Plan::is_plain));
    let mut moved = twisted(mesh, 0.2);
    for x in moved.vertices.as_flattened_mut() {
        *x *= 3.0;
    }
    done(views.update(&moved, &few, Change::Vertices));
    let many = |target: ViewTarget| target.expecting(1 << 30);
    let many: Vec<ViewTarget> = targets().into_iter().map(many).collect();
    done(views.update(&moved, &many, Change::View));
    let fresh = on_cpu(&moved, &many, config(Reduce::On));
    let rays = rays_of(&moved, &fresh);
    for (tree, fresh) in views.trees().iter().zip(fresh.trees()) {
        assert_eq!(tree.bvh.bounds(), fresh.bvh.bounds());
    }
    assert_eq!(answers(&views, &rays), answers(&fresh, &rays));
}

/// Fewer vertices or more are another mesh, whatever the caller says.
#[test]
fn other_numbers_of_vertices_are_another_mesh() {
    let mesh = &meshes()[0];
    let mut more = twisted(mesh, 0.3);
    more.vertices.push([0.0; 3]);
    let mut views = on_cpu(mesh, &targets(), config(Reduce::On));
    done(views.update(&more, &targets(), Change::Vertices));
    let fresh = on_cpu(&more, &targets(), config(Reduce::On));
    let rays = rays_of(&more, &fresh);
    assert_eq!(answers(&views, &rays), answers(&fresh, &rays));
}

/// After an update that failed, the next one builds anew.
#[test]
fn nothing_is_kept_after_an_error() {
    let mesh = &meshes()[0];
    let mut views = on_cpu(mesh, &targets(), config(Reduce::On));
    let mut other = twisted(mesh, 0.4);
    let good = other.vertices[3];
    other.vertices[3] = [f32::NAN, 0.0, 0.0];
    assert!(views.update(&other, &targets(), Change::Scene).is_err());
    assert!(views.trees().is_empty());
    other.vertices[3] = good;
    done(views.update(&other, &targets(), Change::View));
    let fresh = on_cpu(&other, &targets(), config(Reduce::On));
    let rays = rays_of(&other, &fresh);
    assert_eq!(answers(&views, &rays), answers(&fresh, &rays));
}
