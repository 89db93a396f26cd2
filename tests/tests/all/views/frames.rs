//! View sets from frame to frame.

use super::rays::{answers, rays_of};
use super::{config, meshes, targets};
use slimbvh::reduce::Reduce;
use slimbvh::{Change, Cpu, FrameConfig, Mesh, ViewSets, ViewTarget};
use slimbvh_tests::gpu::done;

fn twisted(mesh: &Mesh, angle: f32) -> Mesh {
    let mut mesh = mesh.clone();
    for [x, y, z] in &mut mesh.vertices {
        let (sin, cos) = (angle * *y).sin_cos();
        (*x, *z) = (cos * *x - sin * *z, sin * *x + cos * *z);
    }
    mesh
}

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
