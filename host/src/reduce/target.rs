//! View targets: where the rays of one kind come from, or where they lead.

use super::Costs;
use super::group::joined_target;
use crate::scene::{camera_target, frustum, light_target};
use crate::{Camera, Light, RenderSettings, Scene, View, ViewError};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;

/// Which end of the rays is known.
///
/// ```
/// use slimbvh::ViewTarget;
/// use slimbvh::reduce::TargetKind;
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// assert_eq!(ViewTarget::rays_from([0.0, 1.0, 5.0], 0.0)?.kind(), TargetKind::From);
/// assert_eq!(ViewTarget::rays_to([0.0, 9.0, 0.0], 0.0)?.kind(), TargetKind::To);
/// assert_eq!(ViewTarget::other_rays().kind(), TargetKind::Other);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetKind {
    /// They come from the target: a camera.
    From,
    /// They lead to the target: a light. The question is whether anything is in the way.
    To,
    /// Neither: mirrors, bounces, probes anywhere.
    Other,
}

/// Where the rays of one kind come from, or where they lead: a camera, a light, a group of lights, a ball, or anywhere. No
/// scene, material or picture is needed.
///
/// ```
/// use slimbvh::{Camera, Light, Projection, ViewTarget};
/// # fn main() -> Result<(), slimbvh::ViewError> {
/// let camera = Camera {
///     eye: [0.0, 1.0, 5.0],
///     target: [0.0; 3],
///     up: [0.0, 1.0, 0.0],
///     projection: Projection::Perspective { vertical_fov: 40.0 },
/// };
/// let sun = Light::Directional { direction: [0.3, -1.0, 0.2], color: [1.0; 3] };
/// let targets = [
///     ViewTarget::camera(&camera, [1280, 720])?,
///     ViewTarget::light(&sun)?,
///     ViewTarget::rays_from([2.0, 1.0, 0.0], 0.5)?.named("a probe").expecting(4096),
///     ViewTarget::other_rays(),
/// ];
/// # assert_eq!(targets.len(), 4);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ViewTarget {
    pub(super) kind: TargetKind,
    /// `None` for a camera or light that the plan numbers.
    pub(super) name: Option<String>,
    /// In the mesh's unit.
    pub(super) target: Target,
    /// The region that its rays cross. It bounds the set only.
    pub(super) frustum: Frustum,
    /// Rays expected in a frame.
    pub(super) ray_count: f64,
    /// Whether there are such rays.
    pub(super) is_used: bool,
    /// Whether all of its rays start where rays of the only target of kind [`TargetKind::From`] hit, and leave the surface on
    /// the side that these came from. Then L− may answer them. A renderer takes care of that; a caller could not be held to it.
    pub(super) starts_at_hits: bool,
}

/// Rays of a target whose caller gives no number: a picture's, 1280 by 720.
const USUAL_RAYS: f64 = 1280.0 * 720.0;

impl ViewTarget {
    fn new(kind: TargetKind, target: Target) -> Self {
        Self {
            kind,
            name: None,
            target,
            frustum: Frustum::EVERYWHERE,
            ray_count: USUAL_RAYS,
            is_used: true,
            starts_at_hits: false,
        }
    }

    /// Rays from a camera, or from its lens, through a picture of this width and height in pixels. Its set leaves out what is
    /// certainly outside the picture, so it is for rays of [`Camera`] alone; [`Self::rays_from`] is for others from its eye.
    ///
    /// ```
    /// # use slimbvh::{Camera, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let bounds = mesh.bounds().ok_or("no triangles")?;
    /// let (camera, size) = (Camera::facing(&bounds, 16.0 / 9.0), [1280, 720]);
    /// let eye = ViewTarget::camera(&camera, size)?;
    /// // Its rays.
    /// let middle = camera.ray([640, 360], size)?;
    /// # assert_eq!((eye.target().point, middle.origin), (camera.eye, camera.eye));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// For a camera that cannot be rendered, and an empty picture.
    pub fn camera(camera: &Camera, size: [u32; 2]) -> Result<Self, ViewError> {
        Self::sampled(camera, size, 1)
    }

    fn sampled(camera: &Camera, size: [u32; 2], sample_count: u32) -> Result<Self, ViewError> {
        let core = camera.to_core(size, sample_count)?;
        let [width, height] = size.map(f64::from);
        Ok(Self {
            frustum: frustum(&core),
            ray_count: width * height * f64::from(sample_count),
            ..Self::new(TargetKind::From, camera_target(&core))
        })
    }

    /// Rays to a light, from anywhere on it: do they meet anything? For a directional light, rays without an end.
    ///
    /// ```
    /// # use slimbvh::{Light, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let lights = [Light::Directional { direction: [0.0, -1.0, 0.0], color: [1.0; 3] }];
    /// let shadows = lights.iter().map(ViewTarget::light).collect::<Result<Vec<_>, _>>()?;
    /// assert_eq!(shadows.len(), lights.len());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// For a light that cannot be rendered.
    pub fn light(light: &Light) -> Result<Self, ViewError> {
        let core = light.to_core(0)?;
        Ok(Self::new(TargetKind::To, light_target(&core)))
    }

    /// Rays that start in a ball, in any direction. A radius of 0 is a point.
    ///
    /// ```
    /// # use slimbvh::ViewTarget;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// // A lidar whose mirrors turn within 10 cm.
    /// let lidar = ViewTarget::rays_from([0.0, 1.8, 0.0], 0.1)?.named("lidar").expecting(64 * 2048);
    /// # assert_eq!(lidar.target().radius, 0.1);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If a number is not finite, or the radius is below 0.
    pub fn rays_from(center: [f32; 3], radius: f32) -> Result<Self, ViewError> {
        Ok(Self::new(TargetKind::From, ball(center, radius)?))
    }

    /// Parallel rays in this direction that start outside the scene.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Ray, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// // Heights, seen from above.
    /// let down = [0.0, -1.0, 0.0];
    /// views.update(&mesh, &[ViewTarget::rays_along(down)?], Change::Scene)?;
    /// let hit = views.trees()[0].closest_hit(Ray::new([0.25, 8.0, 0.25], down));
    /// assert!(hit.is_hit() && hit.t > 7.0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the direction is zero or not finite.
    pub fn rays_along(direction: [f32; 3]) -> Result<Self, ViewError> {
        let backward = checked_direction(direction)?.map(|x| -x);
        Ok(Self::new(TargetKind::From, Target::direction(backward)))
    }

    /// Rays that end in a ball: do they meet anything?
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Ray, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// // From where is the goal in sight?
    /// let goal = [0.0, 0.0, 4.0];
    /// views.update(&mesh, &[ViewTarget::rays_to(goal, 0.0)?], Change::Scene)?;
    /// let places = [[0.0, 2.0, 0.0], [0.0, 0.0, -2.0]];
    /// let is_hidden = places.map(|place| views.trees()[0].any_hit(Ray::between(place, goal)));
    /// assert_eq!(is_hidden, [false, true]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If a number is not finite, or the radius is below 0.
    pub fn rays_to(center: [f32; 3], radius: f32) -> Result<Self, ViewError> {
        Ok(Self::new(TargetKind::To, ball(center, radius)?))
    }

    /// Parallel rays in this direction without an end, as to the sun: do they meet anything?
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Ray, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// let to_sun = [0.3, 1.0, 0.2];
    /// views.update(&mesh, &[ViewTarget::rays_toward(to_sun)?], Change::Scene)?;
    /// let is_in_shadow = views.trees()[0].any_hit(Ray::new([0.0, -2.0, 0.0], to_sun));
    /// assert!(is_in_shadow);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the direction is zero or not finite.
    pub fn rays_toward(direction: [f32; 3]) -> Result<Self, ViewError> {
        let direction = checked_direction(direction)?;
        Ok(Self::new(TargetKind::To, Target::direction(direction)))
    }

    /// All other rays: they may hit every triangle, so they need the whole tree.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Ray, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// let targets = [ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?, ViewTarget::other_rays()];
    /// views.update(&mesh, &targets, Change::Scene)?;
    /// // A ray from inside meets triangles that face away from the eye.
    /// let inside = Ray::new([0.0; 3], [0.0, 0.0, -1.0]);
    /// assert!(views.trees()[1].closest_hit(inside).is_hit());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn other_rays() -> Self {
        Self::new(TargetKind::Other, Target::position([0.0; 3]))
    }

    /// Rays to the ball around several lights or balls that rays lead to. The plan groups near lights by itself where one set
    /// costs less than two; this forces it.
    ///
    /// ```
    /// # use slimbvh::ViewTarget;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let candles = [-0.25, 0.25].map(|x| ViewTarget::rays_to([x, 2.0, 0.0], 0.0));
    /// let [left, right] = candles;
    /// // One set for all rays to the chandelier.
    /// let chandelier = ViewTarget::group(&[left?, right?])?.named("chandelier");
    /// assert!(chandelier.target().radius >= 0.25);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If there is none, or rays do not lead to a position in each.
    pub fn group(targets: &[Self]) -> Result<Self, ViewError> {
        let fault = ViewError::Target {
            fault: "group needs at least one light or ball, and none of directional lights, cameras or other rays",
        };
        let is_fit =
            |target: &Self| target.kind == TargetKind::To && target.target.is_position == 1;
        let (Some((first, rest)), true) = (targets.split_first(), targets.iter().all(is_fit))
        else {
            return Err(fault);
        };
        let joined = rest.iter().fold(first.target, |ball, other| {
            joined_target(&ball, &other.target)
        });
        Ok(Self {
            ray_count: targets.iter().map(|target| target.ray_count).sum(),
            starts_at_hits: targets.iter().all(|target| target.starts_at_hits),
            ..Self::new(TargetKind::To, joined)
        })
    }

    /// The same with a name for reports. Without one, cameras and lights are numbered.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// let ear = ViewTarget::rays_from([0.0, 0.0, 4.0], 0.1)?.named("left ear");
    /// views.update(&mesh, &[ear], Change::Scene)?;
    /// assert_eq!(views.sizes()?.sets[0].name, "left ear");
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self {
            name: Some(name.into()),
            ..self
        }
    }

    /// The same with the number of rays expected in a frame: whether a set pays depends on it, no answer does. Default: a
    /// ray a pixel for a camera, else 921,600.
    ///
    /// ```
    /// # use slimbvh::ViewTarget;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// // A few rays do not pay for a set of their own.
    /// let cursor = ViewTarget::rays_from([0.0, 1.0, 5.0], 0.0)?.expecting(1);
    /// // A picture with 16 rays a pixel does sooner.
    /// let eye = ViewTarget::rays_from([0.0, 1.0, 5.0], 0.0)?.expecting(16 * 1280 * 720);
    /// # assert_ne!(cursor, eye);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn expecting(self, ray_count: u64) -> Self {
        Self {
            ray_count: ray_count as f64,
            ..self
        }
    }

    /// Which end of the rays is known.
    ///
    /// ```
    /// # use slimbvh::ViewTarget;
    /// # use slimbvh::reduce::TargetKind;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let targets = [ViewTarget::rays_toward([0.0, 1.0, 0.0])?, ViewTarget::other_rays()];
    /// let shadows = targets.iter().filter(|target| target.kind() == TargetKind::To);
    /// assert_eq!(shadows.count(), 1);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn kind(&self) -> TargetKind {
        self.kind
    }

    /// The ball that rays start or end in, or the direction of parallel ones, in the mesh's unit.
    ///
    /// ```
    /// # use slimbvh::ViewTarget;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let lamp = ViewTarget::rays_to([0.0, 3.0, 0.0], 0.25)?.target();
    /// assert_eq!((lamp.point, lamp.radius), ([0.0, 3.0, 0.0], 0.25));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn target(&self) -> Target {
        self.target
    }
}

fn ball(center: [f32; 3], radius: f32) -> Result<Target, ViewError> {
    let numbers = [center[0], center[1], center[2], radius];
    if numbers.iter().all(|x| x.is_finite()) && radius >= 0.0 {
        Ok(Target::ball(center, radius))
    } else {
        Err(ViewError::Target {
            fault: "ball needs a finite center, and a finite radius of 0 or more",
        })
    }
}

fn checked_direction(direction: [f32; 3]) -> Result<[f32; 3], ViewError> {
    let unit = crate::scene::unit(direction).ok_or(ViewError::Target {
        fault: "direction needs finite numbers that are not all 0",
    })?;
    Ok(unit.to_array())
}

/// The targets of a frame.
///
/// ```
/// use slimbvh::ViewTarget;
/// use slimbvh::reduce::{PlanConfig, Planner, Views};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let views = Views::from(&[ViewTarget::rays_from([0.0, 1.0, 5.0], 0.0)?][..]);
/// let planner = Planner::new(slimbvh::BuildConfig::default(), PlanConfig::default());
/// // A mesh of 100 triangles.
/// let plan = planner.plain(100, &views);
/// assert_eq!(plan.target_count, 1);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Views {
    /// The targets, in the caller's order.
    pub targets: Vec<ViewTarget>,
    /// The number of a picture's samples, if sets of lights may be built while it is rendered. `None` if all sets must
    /// exist at once.
    pub samples: Option<u64>,
}

impl From<&[ViewTarget]> for Views {
    /// Targets whose sets all exist at once.
    fn from(targets: &[ViewTarget]) -> Self {
        Self {
            targets: targets.to_vec(),
            samples: None,
        }
    }
}

impl Views {
    /// The targets of a picture: the scene's first camera, then each light, then mirrors and glass if paths may continue
    /// there.
    ///
    /// ```
    /// use slimbvh::RenderSettings;
    /// use slimbvh::reduce::{TargetKind, Views};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = slimbvh::generate::default_scene();
    /// let views = Views::of_picture(&scene, &RenderSettings::default())?;
    /// let lights = views.targets.iter().filter(|target| target.kind() == TargetKind::To);
    /// assert_eq!(lights.count(), scene.lights.len());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered.
    pub fn of_picture(scene: &Scene, settings: &RenderSettings) -> Result<Self, ViewError> {
        let RenderSettings {
            size,
            sample_count,
            view,
            dark_rays,
            ..
        } = *settings;
        let camera = scene.cameras.first().ok_or(ViewError::NoCamera)?;
        let camera = ViewTarget::sampled(camera, size, sample_count)?;
        let ray_count = camera.ray_count * Costs::MEASURED.shadow_rays;
        let has_mirrors = has_mirrors(scene, settings);
        let mut targets = vec![camera];
        for (index, light) in scene.lights.iter().enumerate() {
            let core = light.to_core(index)?;
            targets.push(ViewTarget {
                ray_count,
                is_used: view == View::Color && (dark_rays || core.color != [0.0; 3]),
                // Shadow rays that start behind mirrors or inside glass have unknown origins.
                starts_at_hits: !has_mirrors,
                ..ViewTarget::new(TargetKind::To, light_target(&core))
            });
        }
        if has_mirrors {
            targets.push(ViewTarget::other_rays().named("mirrors and glass"));
        }
        let [width, height] = size.map(u64::from);
        Ok(Self {
            targets,
            samples: Some(width * height * u64::from(sample_count)),
        })
    }

    /// Whether the whole tree is needed for rays of no known end.
    pub(super) fn has_others(&self) -> bool {
        let mut targets = self.targets.iter();
        targets.any(|target| target.kind == TargetKind::Other && target.is_used)
    }
}

/// Whether any path may continue at a mirror or through glass.
fn has_mirrors(scene: &Scene, settings: &RenderSettings) -> bool {
    let mut materials = scene.materials.iter();
    settings.view == View::Color
        && settings.mirror_depth > 0
        && materials.any(|material| material.mirror > 0.0 || material.transmission > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_ball_or_direction_is_refused() {
        for (center, radius) in [
            ([0.0; 3], -1.0),
            ([0.0, f32::NAN, 0.0], 1.0),
            ([0.0; 3], f32::INFINITY),
        ] {
            assert!(ViewTarget::rays_from(center, radius).is_err());
            assert!(ViewTarget::rays_to(center, radius).is_err());
        }
        for direction in [[0.0; 3], [f32::NAN, 1.0, 0.0]] {
            assert!(ViewTarget::rays_along(direction).is_err());
            assert!(ViewTarget::rays_toward(direction).is_err());
        }
    }

    #[test]
    fn a_group_is_of_balls_that_rays_lead_to() {
        let ball = |x: f32| ViewTarget::rays_to([x, 0.0, 0.0], 0.5).expect("a ball");
        let group = ViewTarget::group(&[ball(0.0), ball(4.0).expecting(8)]).expect("a group");
        assert!((group.target.point[0] - 2.0).abs() < 1e-5 && group.target.radius >= 2.5);
        assert_eq!(group.ray_count, USUAL_RAYS + 8.0);
        let sun = ViewTarget::rays_toward([0.0, 1.0, 0.0]).expect("a direction");
        let eye = ViewTarget::rays_from([0.0; 3], 0.0).expect("a point");
        for unfit in [
            vec![],
            vec![ball(1.0), sun],
            vec![eye],
            vec![ViewTarget::other_rays()],
        ] {
            assert!(ViewTarget::group(&unfit).is_err());
        }
    }
}
