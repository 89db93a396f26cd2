//! Frames that build a set for the rays from an eye and one for those to a lamp, and trace through both: by hand, and by view sets.

use slimbvh::generate::{TorusKnot, torus_knot};
use slimbvh::reduce::{Reduce, Saving, Savings, Seams};
use slimbvh::topology::{self, Topology};
use slimbvh::{
    BuildConfig, Builder, Bvh, Change, Cpu, FrameConfig, Hit, Mesh, Ray, Subset, Tree, ViewSets,
    ViewTarget, animate,
};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use slimbvh_tests::gpu::done;

const EYE: [f32; 3] = [0.5, 0.7, 3.5];
const LAMP: [f32; 3] = [2.5, 4.0, 1.5];

/// 98,304 triangles.
fn knot() -> Mesh {
    torus_knot(&TorusKnot {
        segments: 1536,
        ..TorusKnot::default()
    })
}

/// 10,000 rays, and one to the lamp from each point that they hit.
fn trace(mesh: &Mesh, eye: &Tree, lamp: &Tree) -> usize {
    let ray = |i: u16| {
        let place = |i: u16| f32::from(i) * 0.03 - 1.5;
        Ray::new(
            EYE,
            [place(i % 100) - EYE[0], place(i / 100) - EYE[1], -EYE[2]],
        )
    };
    let rays: Vec<Ray> = (0..10_000).map(ray).collect();
    let mut hits = Vec::new();
    eye.closest_hits(&rays, &mut hits);
    let points = rays.iter().zip(&hits).filter(|(_, hit)| hit.is_hit());
    let points = points.filter_map(|(ray, hit): (&Ray, &Hit)| eye.surface(mesh, ray, hit));
    let dark = points.filter(|point| lamp.any_hit(Ray::between(point, LAMP)));
    dark.count()
}

fn check(rounds: usize, dark: usize) {
    assert!(rounds == 0 || dark > 500 * rounds, "{dark}");
}

/// A caller who knows which sides count sorts, builds both sets, and traces.
pub fn by_hand(rounds: usize) {
    let mesh = knot();
    let topology = Topology::new(&mesh);
    let targets = [EYE, LAMP].map(|point| {
        let sides = topology.sides(&topology::Target::Point(point));
        (Target::position(point), sides)
    });
    let mut builder = Builder::new(BuildConfig::default());
    let (mut bvhs, mut dark) = ([Bvh::default(), Bvh::default()], 0);
    for _ in 0..rounds {
        done(builder.sort(&mesh));
        for ((target, sides), bvh) in targets.iter().zip(&mut bvhs) {
            let set = VisibleSet {
                sides: Sides {
                    components: topology.components(),
                    sides,
                },
                target: *target,
                frustum: Frustum::EVERYWHERE,
            };
            builder.build_sorted(&mesh, Subset::Of(set), bvh);
        }
        let [eye, lamp] = bvhs.each_ref().map(Tree::all);
        dark += trace(&mesh, &eye, &lamp);
    }
    check(rounds, dark);
}

/// The same sets, but that view sets decide.
pub fn by_view_sets(rounds: usize) {
    let mesh = knot();
    let targets = [
        done(ViewTarget::rays_from(EYE, 0.0)),
        done(ViewTarget::rays_to(LAMP, 0.0)),
    ];
    let mut config = FrameConfig::for_frames(1000);
    config.update = animate::Update::Rebuild;
    config.finds_cost = false;
    config.plan.switches.reduce = Reduce::On;
    config.plan.switches.seams = Seams::None;
    config.plan.switches.savings = Savings::ALL.without(Saving::Groups);
    let mut views = ViewSets::new(Cpu, config);
    // The survey is made once.
    done(views.update(&mesh, &targets, Change::Scene));
    let mut dark = 0;
    for _ in 0..rounds {
        done(views.update(&mesh, &targets, Change::View));
        let trees = views.trees();
        dark += trace(&mesh, &trees[0], &trees[1]);
    }
    check(rounds, dark);
}
