//! Jobs: scenes and the views in which their frames are counted.

use super::options::Options;
use anyhow::{Context, Result};
use glam::Vec3;
use slimbvh::reduce::{Cull, Reduce, Seams};
use slimbvh::{Camera, Light, Mesh, Projection, Scene, generate};
use slimbvh_bench::meshes::SUBJECTS;

/// The values of `--reduce`, in the order of the tables.
pub const MODES: [Reduce; 3] = [Reduce::Off, Reduce::Auto, Reduce::On];

/// A scene by name.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// The name in tables.
    pub name: &'static str,
    make: fn(&str) -> Result<Option<Scene>>,
}

/// All scenes. Files are read from the folder of real meshes.
pub const SCENES: [Source; 13] = [
    scene("default scene", |_| Ok(Some(generate::default_scene()))),
    scene("armadillo", subject),
    scene("bunny", subject),
    scene("elephant", subject),
    scene("dragon, 2nd level", |_| file("dragon_res2.ply")),
    scene("dragon, 3rd level", |_| file("dragon_res3.ply")),
    scene("sponza", subject),
    scene("icosphere", subject),
    scene("torus knot", subject),
    scene("terrain", subject),
    scene("grid of spheres", subject),
    scene("small sphere", |_| {
        Ok(of_mesh(generate::icosphere(Vec3::ZERO, 1.0, 3)))
    }),
    scene("box", |_| {
        Ok(of_mesh(generate::cuboid(
            Vec3::ZERO,
            Vec3::new(1.0, 2.0, 3.0),
        )))
    }),
];

/// The viewpoint of the camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Viewpoint {
    /// Outside, with the whole scene in view.
    Outside,
    /// At 0.4 of that distance.
    Close,
    /// In the scene's middle.
    Inside,
    /// As [`Self::Outside`], with parallel rays.
    Parallel,
}

/// A view: camera, lights and options of a frame.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The name in tables.
    pub name: &'static str,
    /// The viewpoint of the camera.
    pub place: Viewpoint,
    /// The number of lights: a sun, then lamps.
    pub light_count: usize,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The value of `--cull`.
    pub cull: Option<Cull>,
    /// [`Seams::None`] is `--solid`.
    pub seams: Seams,
    /// The number of frames that share a survey.
    pub frame_count: u32,
}

const PLAIN: View = View {
    name: "outside, 1 light",
    place: Viewpoint::Outside,
    light_count: 1,
    size: [160, 90],
    cull: None,
    seams: Seams::Find,
    frame_count: 1,
};

/// All views.
pub const VIEWS: [View; 12] = [
    PLAIN,
    View {
        name: "outside, no light",
        light_count: 0,
        ..PLAIN
    },
    View {
        name: "outside, 4 lights",
        light_count: 4,
        ..PLAIN
    },
    View {
        name: "close, 1 light",
        place: Viewpoint::Close,
        ..PLAIN
    },
    View {
        name: "inside, 4 lights",
        place: Viewpoint::Inside,
        light_count: 4,
        ..PLAIN
    },
    View {
        name: "parallel, 1 light",
        place: Viewpoint::Parallel,
        ..PLAIN
    },
    View {
        name: "outside, 1 light, 640x360",
        size: [640, 360],
        ..PLAIN
    },
    View {
        name: "outside, no light, 640x360, solid",
        light_count: 0,
        size: [640, 360],
        seams: Seams::None,
        ..PLAIN
    },
    View {
        name: "outside, 1 light, cull",
        cull: Some(Cull::On),
        ..PLAIN
    },
    View {
        name: "outside, 4 lights, cull, 100 frames",
        light_count: 4,
        cull: Some(Cull::On),
        frame_count: 100,
        ..PLAIN
    },
    View {
        name: "outside, no light, 100 frames",
        light_count: 0,
        frame_count: 100,
        ..PLAIN
    },
    View {
        name: "close, 1 light, solid, 100 frames",
        place: Viewpoint::Close,
        seams: Seams::None,
        frame_count: 100,
        ..PLAIN
    },
];

/// A scene and a view.
#[derive(Clone, Copy, Debug)]
pub struct Job {
    /// The scene.
    pub scene: Source,
    /// The view.
    pub view: View,
}

/// All jobs that the options select and whose files exist.
pub fn jobs(options: &Options) -> Result<Vec<Job>> {
    let mut jobs = Vec::new();
    for scene in SCENES.iter().filter(|scene| options.wants(scene.name)) {
        if scene.load()?.is_some() {
            jobs.extend(VIEWS.map(|view| Job {
                scene: *scene,
                view,
            }));
        }
    }
    Ok(jobs)
}

impl Source {
    fn load(&self) -> Result<Option<Scene>> {
        (self.make)(self.name)
    }
}

impl Job {
    /// The scene with the view's camera and lights.
    pub fn scene(&self) -> Result<Scene> {
        let scene = self.scene.load()?;
        let mut scene = scene.with_context(|| format!("{} is gone", self.scene.name))?;
        let bounds = scene.mesh.bounds().context("the mesh is empty")?;
        let [width, height] = self.view.size;
        let outside = Camera::facing(&bounds, width as f32 / height as f32);
        let (eye, center) = (Vec3::from(outside.eye), Vec3::from(outside.target));
        let diagonal = (bounds.max - bounds.min).length();
        let camera = match self.view.place {
            Viewpoint::Outside => outside,
            Viewpoint::Close => Camera {
                eye: (center + (eye - center) * 0.4).to_array(),
                ..outside
            },
            Viewpoint::Inside => Camera {
                eye: center.to_array(),
                target: (center + Vec3::new(1.0, 0.1, 0.3) * diagonal).to_array(),
                projection: Projection::Perspective { vertical_fov: 60.0 },
                ..outside
            },
            Viewpoint::Parallel => Camera {
                projection: Projection::Orthographic {
                    height: 0.8 * diagonal,
                },
                ..outside
            },
        };
        // Lamps stand around the scene, or around an eye inside of it.
        let reach = match self.view.place {
            Viewpoint::Inside => 0.05,
            _ => 1.0,
        };
        let lamps = [[1.0, 0.6, 0.2], [-0.8, 0.9, 0.5], [0.1, 1.2, -0.9]];
        let lamp = |offset: [f32; 3]| Light::Point {
            position: (center + Vec3::from(offset) * (reach * diagonal)).to_array(),
            color: [diagonal * diagonal; 3],
            range: f32::INFINITY,
        };
        let lights = [Light::beside(&outside)].into_iter().chain(lamps.map(lamp));
        scene.lights = lights.take(self.view.light_count).collect();
        scene.cameras = vec![camera];
        Ok(scene)
    }
}

const fn scene(name: &'static str, make: fn(&str) -> Result<Option<Scene>>) -> Source {
    Source { name, make }
}

fn of_mesh(mesh: Mesh) -> Option<Scene> {
    Some(Scene {
        mesh,
        ..Scene::default()
    })
}

/// The mesh of this name among the meshes of all records.
fn subject(name: &str) -> Result<Option<Scene>> {
    let subject = SUBJECTS.iter().find(|subject| subject.name == name);
    let subject = subject.with_context(|| format!("there is no mesh {name:?}"))?;
    Ok(subject.mesh()?.and_then(of_mesh))
}

fn file(file: &'static str) -> Result<Option<Scene>> {
    Ok(slimbvh_bench::Subject::file("", file)
        .mesh()?
        .and_then(of_mesh))
}
