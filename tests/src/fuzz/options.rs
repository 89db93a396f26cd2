//! For any text as the value of any option, the parser returns an error of one sentence or a value that keeps the option's
//! promise; a parsed camera or light then makes a picture or an error.

use slimbvh::{
    BuildConfig, Builder, Picture, RenderSettings, Renderer, Scene, Tolerance, View, generate,
};
use slimbvh_cli::options::{CameraOption, LightOption, light, share, size, tolerance, whole};

/// See the module. The first byte chooses the option.
///
/// # Panics
/// If a parsed value breaks its option's promise.
pub fn options(data: &[u8]) {
    let Some((&option, text)) = data.split_first() else {
        return;
    };
    let text = &String::from_utf8_lossy(text);
    let refused = match option % 6 {
        0 => text.parse().map(see).err(),
        1 => light(text).map(shine).err(),
        2 => tolerance(text).map(is_a_tolerance).err(),
        3 => size(text).map(is_a_size).err(),
        4 => {
            let range = u32::from(option / 6)..=65536;
            let number = whole(text, range.clone());
            number.map(|number| assert!(range.contains(&number))).err()
        }
        _ => {
            let share = share(text);
            share
                .map(|share| assert!((0.0..=1.0).contains(&share)))
                .err()
        }
    };
    assert!(refused.is_none_or(|sentence| !sentence.is_empty()));
}

fn is_a_size([width, height]: [u32; 2]) {
    assert!(width > 0 && height > 0);
    assert!(u64::from(width) * u64::from(height) <= 1 << 27);
}

fn is_a_tolerance(tolerance: Tolerance) {
    let (Tolerance::Length(number) | Tolerance::Pixels(number)) = tolerance;
    assert!(number > 0.0 && number.is_finite());
    let scene = small_scene();
    let step = tolerance.step_exponent(&scene, &SETTINGS);
    assert!(step.is_none_or(|step| step >= scene.mesh.finest_step()));
}

fn see(option: CameraOption) {
    let mut scene = small_scene();
    if option.apply(&mut scene).is_ok() {
        render(&scene);
    }
}

fn shine(light: LightOption) {
    let mut scene = small_scene();
    scene.lights = vec![light.in_scene(&scene)];
    render(&scene);
}

const SETTINGS: RenderSettings = RenderSettings {
    size: [3, 2],
    sample_count: 1,
    view: View::Color,
    mirror_depth: 1,
    dark_rays: false,
};

fn small_scene() -> Scene {
    let mesh = generate::soup(6, 1);
    let bounds = mesh.bounds();
    let mut scene = Scene {
        mesh,
        ..Scene::default()
    };
    scene.complete(bounds, SETTINGS.size);
    scene
}

fn render(scene: &Scene) {
    let built = Builder::new(BuildConfig::default()).build(&scene.mesh);
    let bvh = built.expect("the mesh is sound");
    let mut picture = Picture::default();
    let rendered = Renderer::new().render(scene, &bvh, &SETTINGS, &mut picture, |_| {});
    assert!(rendered.is_err() || picture.pixels.len() == 6);
}
