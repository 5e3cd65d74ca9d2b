// SPDX-License-Identifier: MIT
// Rays through Embree, which is seen in this file alone.
#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/parallel/for_blocks.hpp"
#include "core/picture/render.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

constexpr float infinitely_far = std::numeric_limits<float>::infinity();

/// What light does to a colour is computed in linear light, not in screen values.
struct Light {
  double red = 0.0, green = 0.0, blue = 0.0;
};
Light operator+(const Light& a, const Light& b) {
  return {a.red + b.red, a.green + b.green, a.blue + b.blue};
}
Light operator*(double factor, const Light& a) {
  return {factor * a.red, factor * a.green, factor * a.blue};
}
Light operator*(const Light& a, const Light& b) {
  return {a.red * b.red, a.green * b.green, a.blue * b.blue};
}

double to_linear(double shown) {
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}
double to_shown(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

const Light sun_light{1.75, 1.65, 1.45};
const Light sky_light{0.55, 0.63, 0.75};
const Light ground_colour{0.42, 0.44, 0.36};
const Light horizon{0.86, 0.90, 0.95};
constexpr double sun_azimuth_deg = 50.0, sun_elevation_deg = 48.0, sun_half_width_deg = 2.0;

struct FreeDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct FreeScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

/// A mesh as the filter and the shader need it.
struct Surface {
  const SceneObject* object;
  Image texture;
  std::array<double, 256> linear;  // of a texture's byte

  const Pixel& texel(const TexturePoint& at) const {
    const auto wrapped = [](double value, int size) {
      const double share = value - std::floor(value);
      return std::min(static_cast<int>(share * size), size - 1);
    };
    return texture.at(wrapped(at.u, texture.width()), wrapped(1.0 - at.v, texture.height()));
  }

  template <class T>
  static T between(const T& a, const T& b, const T& c, double u, double v) {
    if constexpr (std::is_same_v<T, TexturePoint>) {
      const double w = 1.0 - u - v;
      return {w * a.u + u * b.u + v * c.u, w * a.v + u * b.v + v * c.v};
    } else {
      return (1.0 - u - v) * a + u * b + v * c;
    }
  }

  TexturePoint texture_point(unsigned triangle, double u, double v) const {
    const Triangle& t = object->mesh.triangles[triangle];
    const auto& points = object->mesh.texture_points;
    return between(points[t[0]], points[t[1]], points[t[2]], u, v);
  }
  Vector3 normal(unsigned triangle, double u, double v) const {
    const Triangle& t = object->mesh.triangles[triangle];
    const auto& normals = object->mesh.normals;
    return between(normals[t[0]], normals[t[1]], normals[t[2]], u, v);
  }
};

/// Lets rays pass where a texture is transparent.
void pass_transparency(const RTCFilterFunctionNArguments* arguments) {
  const auto& surface = *static_cast<const Surface*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const TexturePoint at = surface.texture_point(RTCHitN_primID(arguments->hit, arguments->N, i),
                                                  RTCHitN_u(arguments->hit, arguments->N, i),
                                                  RTCHitN_v(arguments->hit, arguments->N, i));
    if (surface.texel(at)[3] < 128) arguments->valid[i] = 0;
  }
}

class Scene {
 public:
  explicit Scene(const std::vector<SceneObject>& objects)
      : device_(rtcNewDevice("isa=avx2")), scene_(make_scene()) {
    for (const SceneObject& object : objects) add(object);
    on_one_thread([this] { rtcCommitScene(scene_.get()); });  // the same tree everywhere
    if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE)
      throw EnvironmentError("the picture's scene could not be built; free some memory");
  }

  struct Hit {
    const Surface* surface = nullptr;
    double distance = 0.0;
    Vector3 geometric_normal;
    unsigned triangle = 0;
    double u = 0.0, v = 0.0;
  };

  Hit nearest(const Vector3& from, const Vector3& direction) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray = ray(from, direction);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {surfaces_[query.hit.geomID].get(),
            query.ray.tfar,
            {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z},
            query.hit.primID,
            query.hit.u,
            query.hit.v};
  }

  bool is_blocked(const Vector3& from, const Vector3& direction) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = ray(from, direction);
    rtcOccluded1(scene_.get(), &context, &query);
    return query.tfar < 0.0f;
  }

 private:
  RTCScene make_scene() {
    if (!device_) throw EnvironmentError("Embree could not be started on this processor");
    return rtcNewScene(device_.get());
  }

  static RTCRay ray(const Vector3& from, const Vector3& direction) {
    RTCRay query{};
    query.org_x = static_cast<float>(from.x);
    query.org_y = static_cast<float>(from.y);
    query.org_z = static_cast<float>(from.z);
    query.dir_x = static_cast<float>(direction.x);
    query.dir_y = static_cast<float>(direction.y);
    query.dir_z = static_cast<float>(direction.z);
    query.tfar = infinitely_far;
    query.mask = ~0u;
    return query;
  }

  void add(const SceneObject& object) {
    auto surface = std::make_unique<Surface>();
    surface->object = &object;
    surface->texture = parse_png(object.texture_png, object.material);
    for (int i = 0; i < 256; ++i)
      surface->linear[static_cast<std::size_t>(i)] = to_linear(i / 255.0);
    const TriangleMesh& mesh = object.mesh;
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertex_count()));
    auto* const corners = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangle_count()));
    if (vertices == nullptr || corners == nullptr) throw std::bad_alloc();
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
      vertices[3 * i] = static_cast<float>(mesh.positions[i].x);
      vertices[3 * i + 1] = static_cast<float>(mesh.positions[i].y);
      vertices[3 * i + 2] = static_cast<float>(mesh.positions[i].z);
    }
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i)
      std::copy_n(mesh.triangles[i].data(), 3, corners + 3 * i);
    rtcSetGeometryUserData(geometry, surface.get());
    if (object.has_transparency) {
      rtcSetGeometryIntersectFilterFunction(geometry, pass_transparency);
      rtcSetGeometryOccludedFilterFunction(geometry, pass_transparency);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_.get(), geometry, static_cast<unsigned>(surfaces_.size()));
    rtcReleaseGeometry(geometry);
    surfaces_.push_back(std::move(surface));
  }

  std::unique_ptr<RTCDeviceTy, FreeDevice> device_;
  std::unique_ptr<RTCSceneTy, FreeScene> scene_;
  std::vector<std::unique_ptr<Surface>> surfaces_;
};

/// Random numbers of one sample of one pixel. What is drawn in pairs is spread over the samples of
/// the pixel: each takes its own slice of the first number, and turns on by the golden ratio in the
/// second.
class SampleNumbers {
 public:
  SampleNumbers(std::size_t pixel, int sample, int samples)
      : pixel_(pixel), sample_(sample), samples_(samples) {}

  struct Pair {
    double a, b;
  };
  Pair next() {
    constexpr double golden_ratio = 0.61803398874989485;
    const std::uint64_t first = 64 * pixel_ + 4 * pairs_++;
    const double shift = random_unit(0, picture_stream, first);
    const double slice = wrapped(shift + static_cast<double>(sample_) / samples_);
    const double jitter = random_unit(pairs_, picture_stream, 256 * pixel_ + unsigned_sample());
    return {wrapped(slice + jitter / samples_),
            wrapped(random_unit(0, picture_stream, first + 1) + golden_ratio * sample_)};
  }

 private:
  static double wrapped(double value) { return value - std::floor(value); }
  std::uint64_t unsigned_sample() const { return static_cast<std::uint64_t>(sample_); }

  static constexpr std::uint64_t picture_stream = 121;
  std::uint64_t pixel_;
  int sample_, samples_;
  std::uint64_t pairs_ = 0;
};

class Renderer {
 public:
  Renderer(const std::vector<SceneObject>& objects, const Camera& camera,
           const RenderOptions& options)
      : scene_(objects), camera_(camera), frame_(view_frame(camera)), options_(options) {
    const Vector3 extent = box_of(objects).extent();
    size_ = std::max({extent.x, extent.y, extent.z, 1e-6});
    const Camera sun{.azimuth_deg = camera.azimuth_deg + sun_azimuth_deg,
                     .elevation_deg = sun_elevation_deg};
    const ViewFrame from_sun = view_frame(sun);
    to_sun_ = -1.0 * from_sun.forward;
    sun_right_ = from_sun.right;
    sun_up_ = from_sun.up;
  }

  Image run() {
    Image image(options_.width, options_.height);
    constexpr int band = 16;
    for (int first = 0; first < options_.height; first += band) {
      const int last = std::min(first + band, options_.height);
      for_tasks(static_cast<std::size_t>(last - first), options_.threads,
                [&](std::size_t row) { draw_row(first + static_cast<int>(row), image); });
      if (options_.progress && !options_.progress(static_cast<double>(last) / options_.height))
        throw Interrupted();
    }
    return image;
  }

 private:
  void draw_row(int row, Image& image) const {
    for (int column = 0; column < options_.width; ++column)
      image.at(column, row) = pixel(column, row);
  }

  Pixel pixel(int column, int row) const {
    const auto number = static_cast<std::size_t>(row) * static_cast<std::size_t>(options_.width) +
                        static_cast<std::size_t>(column);
    const int samples = options_.samples * options_.samples;
    Light sum;
    for (int i = 0; i < samples; ++i) {
      SampleNumbers numbers(number, i, samples);
      const SampleNumbers::Pair place = numbers.next();
      const double x = column + (i % options_.samples + place.a) / options_.samples;
      const double y = row + (i / options_.samples + place.b) / options_.samples;
      sum = sum + light_along(direction_through(x, y), numbers);
    }
    const double share = 1.0 / samples;
    return to_pixel(
        Colour{to_shown(share * sum.red), to_shown(share * sum.green), to_shown(share * sum.blue)});
  }

  Vector3 direction_through(double x, double y) const {
    const double half_height = std::tan(0.5 * camera_.view_angle_deg * std::numbers::pi / 180.0);
    const double per_pixel = 2.0 * half_height / options_.height;
    const Vector3 v = frame_.forward + per_pixel * (x - 0.5 * options_.width) * frame_.right -
                      per_pixel * (y - 0.5 * options_.height) * frame_.up;
    return v / norm(v);
  }

  Light light_along(const Vector3& direction, SampleNumbers& numbers) const {
    const Vector3 from = camera_.position();
    const Scene::Hit hit = scene_.nearest(from, direction);
    const double to_ground = options_.ground && direction.y < 0.0
                                 ? -from.y / direction.y
                                 : std::numeric_limits<double>::infinity();
    if (to_ground > 0.0 && std::isfinite(to_ground) &&
        (hit.surface == nullptr || to_ground < hit.distance))
      return ground_light(from + to_ground * direction, numbers);
    if (hit.surface == nullptr) return horizon;
    return surface_light(hit, from + hit.distance * direction, direction, numbers);
  }

  /// The ground fades into the horizon, so that the picture has no edge.
  Light ground_light(const Vector3& at, SampleNumbers& numbers) const {
    const Light lit = ground_colour * received(at, {0.0, 1.0, 0.0}, numbers);
    const double away = norm({at.x - camera_.target.x, 0.0, at.z - camera_.target.z}) / size_;
    const double fade = std::clamp((away - 0.5) / 2.0, 0.0, 1.0);
    return (1.0 - fade) * lit + fade * horizon;
  }

  Light surface_light(const Scene::Hit& hit, const Vector3& at, const Vector3& direction,
                      SampleNumbers& numbers) const {
    const Surface& surface = *hit.surface;
    Vector3 normal = surface.normal(hit.triangle, hit.u, hit.v);
    normal = normal / std::max(norm(normal), 1e-12);
    if (dot(normal, direction) > 0.0) normal = -1.0 * normal;
    const Pixel& texel = surface.texel(surface.texture_point(hit.triangle, hit.u, hit.v));
    const Light colour{surface.linear[texel[0]], surface.linear[texel[1]],
                       surface.linear[texel[2]]};
    return colour * received(at, normal, numbers);
  }

  /// What falls on a small surface: one ray to a point of the sun, one into the sky.
  Light received(const Vector3& at, const Vector3& normal, SampleNumbers& numbers) const {
    const Vector3 from = at + 1e-4 * size_ * normal;
    const double spread = std::tan(sun_half_width_deg * std::numbers::pi / 180.0);
    const SampleNumbers::Pair on_sun = numbers.next();
    const double radius = spread * std::sqrt(on_sun.a);
    const double turn = 2.0 * std::numbers::pi * on_sun.b;
    const Vector3 sun =
        to_sun_ + radius * std::cos(turn) * sun_right_ + radius * std::sin(turn) * sun_up_;
    const Vector3 to_sun = sun / norm(sun);
    Light light;
    const double facing = dot(normal, to_sun);
    if (facing > 0.0 && !scene_.is_blocked(from, to_sun)) light = facing * sun_light;
    const Vector3 to_sky = towards_sky(normal, numbers);
    if (to_sky.y > 0.0 || !options_.ground) {
      if (!scene_.is_blocked(from, to_sky)) light = light + sky_light;
    } else {
      light = light + 0.4 * (sky_light * ground_colour);  // sky that the ground throws back
    }
    return light;
  }

  /// A direction about `normal`, more often near it, as a matt surface looks.
  static Vector3 towards_sky(const Vector3& normal, SampleNumbers& numbers) {
    const SampleNumbers::Pair on_disc = numbers.next();
    const double radius_squared = on_disc.a;
    const double turn = 2.0 * std::numbers::pi * on_disc.b;
    const Vector3 across = any_perpendicular(normal), along = cross(normal, across);
    const double radius = std::sqrt(radius_squared);
    return radius * std::cos(turn) * across + radius * std::sin(turn) * along +
           std::sqrt(1.0 - radius_squared) * normal;
  }

  Scene scene_;
  Camera camera_;
  ViewFrame frame_;
  RenderOptions options_;
  double size_ = 1.0;
  Vector3 to_sun_, sun_right_, sun_up_;
};

}  // namespace

bool can_render() {
  return true;
}

std::string renderer_name() {
  return "Embree " RTC_VERSION_STRING;
}

Image render(const std::vector<SceneObject>& objects, const Camera& camera,
             const RenderOptions& options) {
  PHYTOBENCH_EXPECT(options.samples >= 1 && options.samples <= 16);
  return Renderer(objects, camera, options).run();
}

}  // namespace phytobench
