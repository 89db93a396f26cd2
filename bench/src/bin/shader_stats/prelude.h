// What naga's Metal text of a compute kernel needs, for NVIDIA's NVRTC.
typedef unsigned int uint;
#define thread
#define constant const
#define device
#define threadgroup

template <class To, class From> inline To as_type(From from) {
    return __builtin_bit_cast(To, from);
}

namespace metal {
using ::uint;

// Vectors: components, and componentwise operations as far as kernels use them.
template <class T> struct vec3 {
    T x, y, z;
    vec3() = default;
    explicit vec3(T a) : x(a), y(a), z(a) {}
    vec3(T a, T b, T c) : x(a), y(b), z(c) {}
    T &operator[](uint i) { return (&x)[i]; }
    const T &operator[](uint i) const { return (&x)[i]; }
};
template <class T> struct alignas(4 * sizeof(T)) vec4 {
    T x, y, z, w;
    vec4() = default;
    explicit vec4(T a) : x(a), y(a), z(a), w(a) {}
    vec4(T a, T b, T c, T d) : x(a), y(b), z(c), w(d) {}
    T &operator[](uint i) { return (&x)[i]; }
    const T &operator[](uint i) const { return (&x)[i]; }
};
template <class T> struct alignas(2 * sizeof(T)) vec2 {
    T x, y;
    vec2() = default;
    explicit vec2(T a) : x(a), y(a) {}
    vec2(T a, T b) : x(a), y(b) {}
    T &operator[](uint i) { return (&x)[i]; }
    const T &operator[](uint i) const { return (&x)[i]; }
};
typedef vec2<float> float2;
typedef vec3<float> float3;
typedef vec4<float> float4;
typedef vec2<uint> uint2;
typedef vec3<uint> uint3;
typedef vec4<uint> uint4;
typedef vec2<int> int2;
typedef vec3<int> int3;
typedef vec4<int> int4;
typedef vec2<bool> bool2;
typedef vec3<bool> bool3;
typedef vec4<bool> bool4;
struct packed_float3 {
    float x, y, z;
    packed_float3() = default;
    packed_float3(float3 v) : x(v.x), y(v.y), z(v.z) {}
    operator float3() const { return float3(x, y, z); }
    float &operator[](uint i) { return (&x)[i]; }
    const float &operator[](uint i) const { return (&x)[i]; }
};
#define COMPONENTWISE(op, R)                                                                        \
    template <class T> inline vec2<R> operator op(vec2<T> a, vec2<T> b) {                           \
        return vec2<R>(a.x op b.x, a.y op b.y);                                                     \
    }                                                                                               \
    template <class T> inline vec3<R> operator op(vec3<T> a, vec3<T> b) {                           \
        return vec3<R>(a.x op b.x, a.y op b.y, a.z op b.z);                                         \
    }                                                                                               \
    template <class T> inline vec4<R> operator op(vec4<T> a, vec4<T> b) {                           \
        return vec4<R>(a.x op b.x, a.y op b.y, a.z op b.z, a.w op b.w);                             \
    }
COMPONENTWISE(+, T) COMPONENTWISE(-, T) COMPONENTWISE(*, T) COMPONENTWISE(/, T)
COMPONENTWISE(&, T) COMPONENTWISE(|, T) COMPONENTWISE(^, T) COMPONENTWISE(<<, T) COMPONENTWISE(>>, T)
COMPONENTWISE(==, bool) COMPONENTWISE(!=, bool)
COMPONENTWISE(<, bool) COMPONENTWISE(<=, bool) COMPONENTWISE(>, bool) COMPONENTWISE(>=, bool)
#define SCALED(V)                                                                                   \
    template <class T> inline V<T> operator*(V<T> a, T b) { return a * V<T>(b); }                   \
    template <class T> inline V<T> operator*(T a, V<T> b) { return V<T>(a) * b; }                   \
    template <class T> inline V<T> operator-(V<T> a) { return V<T>(T(0)) - a; }
SCALED(vec2) SCALED(vec3) SCALED(vec4)
template <class T> inline vec2<T> operator-=(vec2<T> &a, vec2<T> b) { return a = a - b; }
inline bool all(bool2 a) { return a.x && a.y; }
inline bool all(bool3 a) { return a.x && a.y && a.z; }
inline bool any(bool3 a) { return a.x || a.y || a.z; }

template <class T> inline T select(T no, T yes, bool which) { return which ? yes : no; }
template <class T> inline vec3<T> select(vec3<T> no, vec3<T> yes, bool3 which) {
    return vec3<T>(which.x ? yes.x : no.x, which.y ? yes.y : no.y, which.z ? yes.z : no.z);
}
template <class T> inline vec4<T> select(vec4<T> no, vec4<T> yes, bool4 which) {
    return vec4<T>(which.x ? yes.x : no.x, which.y ? yes.y : no.y, which.z ? yes.z : no.z, which.w ? yes.w : no.w);
}
inline float min(float a, float b) { return ::fminf(a, b); }
inline float max(float a, float b) { return ::fmaxf(a, b); }
inline uint min(uint a, uint b) { return ::umin(a, b); }
inline uint max(uint a, uint b) { return ::umax(a, b); }
inline int min(int a, int b) { return ::min(a, b); }
inline int max(int a, int b) { return ::max(a, b); }
#define OF_EACH(f)                                                                                  \
    template <class T> inline vec2<T> f(vec2<T> a, vec2<T> b) {                                     \
        return vec2<T>(f(a.x, b.x), f(a.y, b.y));                                                   \
    }                                                                                               \
    template <class T> inline vec3<T> f(vec3<T> a, vec3<T> b) {                                     \
        return vec3<T>(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z));                                      \
    }                                                                                               \
    template <class T> inline vec4<T> f(vec4<T> a, vec4<T> b) {                                     \
        return vec4<T>(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z), f(a.w, b.w));                         \
    }
OF_EACH(min) OF_EACH(max)
inline float abs(float a) { return ::fabsf(a); }
inline float sqrt(float a) { return ::sqrtf(a); }
inline float pow(float a, float b) { return ::powf(a, b); }
inline float fma(float a, float b, float c) { return ::fmaf(a, b, c); }
inline float floor(float a) { return ::floorf(a); }
inline float ceil(float a) { return ::ceilf(a); }
inline float trunc(float a) { return ::truncf(a); }
inline float clamp(float a, float b, float c) { return ::fminf(::fmaxf(a, b), c); }
inline uint clamp(uint a, uint b, uint c) { return ::umin(::umax(a, b), c); }
inline uint clz(uint a) { return ::__clz(a); }
inline uint ctz(uint a) { return ::__clz(::__brev(a)); }
inline uint popcount(uint a) { return ::__popc(a); }
inline uint reverse_bits(uint a) { return ::__brev(a); }

struct atomic_uint { uint value; };
struct atomic_int { int value; };
enum memory_order { memory_order_relaxed };
enum class mem_flags { mem_none, mem_device, mem_threadgroup };
inline uint atomic_fetch_add_explicit(atomic_uint *a, uint b, memory_order) { return ::atomicAdd(&a->value, b); }
inline uint atomic_fetch_sub_explicit(atomic_uint *a, uint b, memory_order) { return ::atomicSub(&a->value, b); }
inline uint atomic_fetch_or_explicit(atomic_uint *a, uint b, memory_order) { return ::atomicOr(&a->value, b); }
inline uint atomic_fetch_and_explicit(atomic_uint *a, uint b, memory_order) { return ::atomicAnd(&a->value, b); }
inline uint atomic_fetch_min_explicit(atomic_uint *a, uint b, memory_order) { return ::atomicMin(&a->value, b); }
inline uint atomic_fetch_max_explicit(atomic_uint *a, uint b, memory_order) { return ::atomicMax(&a->value, b); }
inline uint atomic_exchange_explicit(atomic_uint *a, uint b, memory_order) { return ::atomicExch(&a->value, b); }
inline uint atomic_load_explicit(const atomic_uint *a, memory_order) { return *(const volatile uint *)&a->value; }
inline void atomic_store_explicit(atomic_uint *a, uint b, memory_order) { *(volatile uint *)&a->value = b; }
inline void threadgroup_barrier(mem_flags) { __syncthreads(); }
inline mem_flags operator|(mem_flags a, mem_flags) { return a; }
} // namespace metal
