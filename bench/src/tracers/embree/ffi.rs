//! The functions of Embree 3 that the tracer needs, with safe wrappers.
//!
//! Declared after the headers of version 3.13 as Debian builds it (one level of instances, no minimal widths).

// A C library.
#![allow(unsafe_code)]

use anyhow::{Result, ensure};
use std::ffi::{CString, c_char, c_int, c_uint, c_void};
use std::marker::PhantomData;
use std::ptr::null_mut;
use std::sync::atomic::{AtomicIsize, Ordering};

/// The way to build a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub enum Quality {
    /// By Morton codes.
    Low = 0,
    /// By binned surface areas.
    Medium = 1,
}

/// `RTCRay`.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
pub struct Ray1 {
    pub origin: [f32; 3],
    pub near: f32,
    pub direction: [f32; 3],
    pub time: f32,
    /// After a query for any hit: below 0 if there is one.
    pub far: f32,
    pub mask: u32,
    pub id: u32,
    pub flags: u32,
}

/// `RTCRayHit`.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
pub struct RayHit1 {
    pub ray: Ray1,
    pub normal: [f32; 3],
    pub uv: [f32; 2],
    pub primitive: u32,
    /// [`MISS`] for a miss.
    pub geometry: u32,
    pub instance: u32,
}

/// `RTCRay16`: as [`Ray1`], sixteen of each.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub struct Ray16 {
    pub origin: [[f32; 16]; 3],
    pub near: [f32; 16],
    pub direction: [[f32; 16]; 3],
    pub time: [f32; 16],
    pub far: [f32; 16],
    pub mask: [u32; 16],
    pub id: [u32; 16],
    pub flags: [u32; 16],
}

/// `RTCRayHit16`: as [`RayHit1`], sixteen of each.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub struct RayHit16 {
    pub ray: Ray16,
    pub normal: [[f32; 16]; 3],
    pub uv: [[f32; 16]; 2],
    pub primitive: [u32; 16],
    pub geometry: [u32; 16],
    pub instance: [u32; 16],
}

const _: () = assert!(size_of::<RayHit1>() == 80 && size_of::<RayHit16>() == 1280);

/// -1 for each of sixteen rays that is valid, else 0.
#[repr(C, align(64))]
pub struct Valid(pub [i32; 16]);

/// No geometry.
pub const MISS: u32 = u32::MAX;

/// `RTCIntersectContext`.
#[repr(C)]
struct Context {
    flags: c_int,
    filter: *const c_void,
    instance: [c_uint; 1],
}

impl Context {
    fn new(flags: c_int) -> Self {
        Self {
            flags,
            filter: std::ptr::null(),
            instance: [MISS],
        }
    }
}

const INCOHERENT: c_int = 0;
const COHERENT: c_int = 1;
const ROBUST: c_int = 1 << 2;
const TRIANGLES: c_int = 0;
const INDEX_BUFFER: c_int = 0;
const VERTEX_BUFFER: c_int = 1;
const UINT3: c_int = 0x5003;
const FLOAT3: c_int = 0x9003;

type Pointer = *mut c_void;
type Monitor = extern "C" fn(Pointer, isize, bool) -> bool;

unsafe extern "C" {
    fn rtcNewDevice(config: *const c_char) -> Pointer;
    fn rtcReleaseDevice(device: Pointer);
    fn rtcGetDeviceError(device: Pointer) -> c_int;
    fn rtcSetDeviceMemoryMonitorFunction(device: Pointer, monitor: Monitor, user: Pointer);
    fn rtcNewScene(device: Pointer) -> Pointer;
    fn rtcReleaseScene(scene: Pointer);
    fn rtcSetSceneBuildQuality(scene: Pointer, quality: c_int);
    fn rtcSetSceneFlags(scene: Pointer, flags: c_int);
    fn rtcCommitScene(scene: Pointer);
    fn rtcAttachGeometry(scene: Pointer, geometry: Pointer) -> c_uint;
    fn rtcNewGeometry(device: Pointer, kind: c_int) -> Pointer;
    fn rtcReleaseGeometry(geometry: Pointer);
    fn rtcSetGeometryBuildQuality(geometry: Pointer, quality: c_int);
    fn rtcCommitGeometry(geometry: Pointer);
    fn rtcUpdateGeometryBuffer(geometry: Pointer, buffer: c_int, slot: c_uint);
    fn rtcSetSharedGeometryBuffer(
        geometry: Pointer,
        buffer: c_int,
        slot: c_uint,
        format: c_int,
        data: *const c_void,
        offset: usize,
        stride: usize,
        count: usize,
    );
    fn rtcIntersect1(scene: Pointer, context: *mut Context, ray: *mut RayHit1);
    fn rtcOccluded1(scene: Pointer, context: *mut Context, ray: *mut Ray1);
    fn rtcIntersect16(
        valid: *const Valid,
        scene: Pointer,
        context: *mut Context,
        rays: *mut RayHit16,
    );
    fn rtcOccluded16(valid: *const Valid, scene: Pointer, context: *mut Context, rays: *mut Ray16);
}

/// Embree, with threads of its own for building.
pub struct Device {
    device: Pointer,
    /// Bytes that Embree has allocated, by its own count.
    bytes: Box<AtomicIsize>,
}

extern "C" fn count(bytes: Pointer, change: isize, _after: bool) -> bool {
    // SAFETY: the pointer was given with this function, and the number lives as long as the device.
    let bytes = unsafe { &*bytes.cast::<AtomicIsize>() };
    bytes.fetch_add(change, Ordering::Relaxed);
    true
}

impl Device {
    pub fn new(threads: usize) -> Result<Self> {
        let config = CString::new(format!("threads={threads}"))?;
        // SAFETY: the text ends with a zero, and is copied.
        let device = unsafe { rtcNewDevice(config.as_ptr()) };
        ensure!(!device.is_null(), "Embree does not start");
        let bytes = Box::new(AtomicIsize::new(0));
        let user = std::ptr::from_ref::<AtomicIsize>(&bytes);
        // SAFETY: the device lives, the function has the type that is asked for, and the number outlives the device.
        unsafe { rtcSetDeviceMemoryMonitorFunction(device, count, user.cast_mut().cast()) };
        Ok(Self { device, bytes })
    }

    /// Bytes that Embree has allocated.
    pub fn bytes(&self) -> usize {
        self.bytes
            .load(Ordering::Relaxed)
            .try_into()
            .unwrap_or_default()
    }

    fn check(&self) -> Result<()> {
        // SAFETY: the device lives.
        let error = unsafe { rtcGetDeviceError(self.device) };
        ensure!(error == 0, "Embree reports error {error}");
        Ok(())
    }
}

impl Drop for Device {
    fn drop(&mut self) {
        // SAFETY: it is not used after. Scenes keep Embree's own count of it.
        unsafe { rtcReleaseDevice(self.device) };
    }
}

// SAFETY: Embree's devices may be used from any thread.
unsafe impl Send for Device {}
// SAFETY: Embree allows all calls through a shared reference from many threads at once.
unsafe impl Sync for Device {}

/// One mesh, and a tree over it.
pub struct Scene<'a> {
    scene: Pointer,
    geometry: Pointer,
    /// The buffers are the caller's.
    mesh: PhantomData<&'a [[f32; 3]]>,
}

impl<'a> Scene<'a> {
    /// A scene without a tree. The last vertex is not used: Embree reads four numbers of each.
    ///
    /// # Errors
    /// If Embree refuses the mesh, or if an index is out of range.
    pub fn new(
        device: &Device,
        quality: Quality,
        vertices: &'a [[f32; 3]],
        indices: &'a [[u32; 3]],
    ) -> Result<Self> {
        let count = vertices.len().saturating_sub(1);
        let are_there = indices.as_flattened().iter().all(|&i| (i as usize) < count);
        ensure!(are_there, "a triangle's vertex is not there");
        // SAFETY: the device lives. Both objects are released when this is dropped.
        let (scene, geometry) = unsafe {
            (
                rtcNewScene(device.device),
                rtcNewGeometry(device.device, TRIANGLES),
            )
        };
        let new = Self {
            scene,
            geometry,
            mesh: PhantomData,
        };
        device.check()?;
        let buffers = [
            (INDEX_BUFFER, UINT3, indices.as_ptr().cast(), indices.len()),
            (VERTEX_BUFFER, FLOAT3, vertices.as_ptr().cast(), count),
        ];
        for (buffer, format, data, count) in buffers {
            // SAFETY: the buffer has so many items of three numbers of four bytes, four more bytes can be read after the
            // last vertex, and it is borrowed for as long as this lives.
            unsafe {
                rtcSetSharedGeometryBuffer(geometry, buffer, 0, format, data, 0, 12, count);
            }
        }
        // SAFETY: both objects live. Only with both qualities low does Embree build by Morton codes.
        unsafe {
            rtcSetGeometryBuildQuality(geometry, quality as c_int);
            rtcSetSceneBuildQuality(scene, quality as c_int);
            rtcSetSceneFlags(scene, ROBUST);
            rtcAttachGeometry(scene, geometry);
        }
        device.check()?;
        Ok(new)
    }

    /// Builds the tree, in place of the one before.
    ///
    /// # Errors
    /// If Embree refuses the build.
    pub fn build(&mut self, device: &Device) -> Result<()> {
        // SAFETY: both objects live, and no thread traces meanwhile, as this is borrowed mutably. Marking the vertices as
        // changed makes Embree build again.
        unsafe {
            rtcUpdateGeometryBuffer(self.geometry, VERTEX_BUFFER, 0);
            rtcCommitGeometry(self.geometry);
            rtcCommitScene(self.scene);
        }
        device.check()
    }

    #[inline]
    pub fn intersect1(&self, ray: &mut RayHit1) {
        let mut context = Context::new(INCOHERENT);
        // SAFETY: the scene was committed before it was given out, and ray and context have the layout that Embree expects.
        unsafe { rtcIntersect1(self.scene, &raw mut context, ray) };
    }

    #[inline]
    pub fn occluded1(&self, ray: &mut Ray1) {
        let mut context = Context::new(INCOHERENT);
        // SAFETY: as above.
        unsafe { rtcOccluded1(self.scene, &raw mut context, ray) };
    }

    #[inline]
    pub fn intersect16(&self, valid: &Valid, rays: &mut RayHit16) {
        let mut context = Context::new(COHERENT);
        // SAFETY: as above.
        unsafe { rtcIntersect16(valid, self.scene, &raw mut context, rays) };
    }

    #[inline]
    pub fn occluded16(&self, valid: &Valid, rays: &mut Ray16) {
        let mut context = Context::new(COHERENT);
        // SAFETY: as above.
        unsafe { rtcOccluded16(valid, self.scene, &raw mut context, rays) };
    }
}

impl Drop for Scene<'_> {
    fn drop(&mut self) {
        for (object, release) in [
            (
                &mut self.geometry,
                rtcReleaseGeometry as unsafe extern "C" fn(Pointer),
            ),
            (&mut self.scene, rtcReleaseScene),
        ] {
            let object = std::mem::replace(object, null_mut());
            if !object.is_null() {
                // SAFETY: it is released once, and not used after.
                unsafe { release(object) };
            }
        }
    }
}

// SAFETY: Embree's scenes may be used from any thread.
unsafe impl Send for Scene<'_> {}
// SAFETY: a shared reference only traces rays, which Embree allows from many threads at once.
unsafe impl Sync for Scene<'_> {}
