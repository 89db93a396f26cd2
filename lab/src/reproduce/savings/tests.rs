use super::*;
use slimbvh::generate::{TorusKnot, torus_knot};
use slimbvh::topology::Topology;

/// A small model that casts shadows on itself.
fn subject() -> Subject {
    let mesh = torus_knot(&TorusKnot {
        segments: 128,
        sides: 16,
        ..TorusKnot::default()
    });
    let mut scene = Scene {
        mesh,
        ..Scene::default()
    };
    scene.complete(scene.mesh.bounds(), [64; 2]);
    Subject {
        name: "knot".into(),
        printed: None,
        topology: Topology::new(&scene.mesh).into(),
        scene,
        stand_in: None,
        is_own: false,
        is_uniform: true,
    }
}

fn protocol() -> Protocol {
    Protocol {
        size: [64; 2],
        saving_rounds: 1,
        ..Protocol::quick()
    }
}

/// Without a saving exactly the work that it saves appears.
#[test]
fn each_saving_saves_what_it_is_for() {
    let records = measure(&subject(), &protocol()).unwrap();
    let names: Vec<&str> = records.iter().map(|record| &*record.saving).collect();
    assert_eq!(names.len(), Saving::ALL.len() + 1);
    for (saved, record) in Saved::all().zip(&records) {
        let (with, without) = (&record.with, &record.without);
        let facts = |way: &Way| (way.triangles, way.tree_bytes, way.shadow_rays);
        let context = format!("{saved:?}: {:?}, {:?}", facts(with), facts(without));
        assert_eq!(record.saving, saved.name());
        assert_eq!([with, without].map(|way| way.rounds.0.len()), [1; 2]);
        let [fewer_triangles, fewer_bytes, fewer_rays] = [
            with.triangles < without.triangles,
            with.tree_bytes < without.tree_bytes,
            with.shadow_rays < without.shadow_rays,
        ];
        let expected = match saved {
            Saved::Plan(Saving::Frustum) => [true, true, false],
            // Either set may be the larger one.
            Saved::Plan(Saving::Away) => {
                assert_ne!(with.triangles, without.triangles, "{context}");
                continue;
            }
            Saved::Plan(Saving::Groups) => [true, fewer_bytes, false],
            Saved::Plan(Saving::Turns) => [false, true, false],
            // The visible light has a set of its own either way, and both sets are deferred.
            Saved::Plan(Saving::Unseen) => [true, fewer_bytes, false],
            Saved::Plan(Saving::Alone) => [false; 3],
            Saved::DarkRays => [false, false, true],
        };
        assert_eq!(
            [fewer_triangles, fewer_bytes, fewer_rays],
            expected,
            "{context}"
        );
    }
}

/// A plan sorts a set alone only with the saving [`Saving::Alone`]. Apart from this field only times show it.
#[test]
fn the_camera_alone_has_one_set() {
    let subject = subject();
    let Stage { scene, .. } = Stage::new(Saved::Plan(Saving::Alone), &subject);
    let settings = settings(&protocol(), 1);
    for (savings, sorts_alone) in [
        (Savings::ALL, true),
        (Savings::ALL.without(Saving::Alone), false),
    ] {
        let plan = plan(&subject, &scene, &(settings, savings)).unwrap();
        assert_eq!(plan.sorts_alone, sorts_alone);
    }
}
