#include "simulation/tracer.hpp"

#include "base/threads/interruptible.hpp"

#if BRDFPLOT_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

namespace brdfplot::simulation {

namespace {

/// How far above its facet a ray starts, and how far a piece of a ray reaches over the side of the period, in cells.
/// Coordinates up to 4096 are rounded to 2^-13; the height of a point is rounded to 2^-18 at most.
constexpr float lift = 1e-4F;
constexpr float overlap = 1e-3F;

constexpr std::size_t lanes = 8;

/// A call's view of its rays, which lie near each other or do not: Embree 3 has it in a context, 4 in arguments.
class RayQuery {
public:
#if BRDFPLOT_EMBREE == 3
  explicit RayQuery(bool coherent) {
    rtcInitIntersectContext(&context_);
    context_.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
  void trace(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &context_, &ray); }
  void trace(RTCScene scene, const int* valid, RTCRayHit8& rays) { rtcIntersect8(valid, scene, &context_, &rays); }

private:
  RTCIntersectContext context_;
#else
  explicit RayQuery(bool coherent) {
    rtcInitIntersectArguments(&arguments_);
    arguments_.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }
  void trace(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &ray, &arguments_); }
  void trace(RTCScene scene, const int* valid, RTCRayHit8& rays) { rtcIntersect8(valid, scene, &rays, &arguments_); }

private:
  RTCIntersectArguments arguments_;
#endif
};

/// Never freed before the process ends: Embree's threads live as long.
RTCDevice device() {
  static RTCDevice shared = [] {
    RTCDevice made = rtcNewDevice(nullptr);
    if (made == nullptr) throw std::runtime_error("Embree gives no device");
    return made;
  }();
  return shared;
}

/// Where a ray is that has passed through some periods, in double precision so that the periods add no error.
struct Place {
  double x, y, z;
};

/// The box of one period.
struct Period {
  double nx, ny, lowest, highest;
};

/// A direction with the inverses of its components: all rays of a packet share them.
struct Aim {
  explicit Aim(const Direction& direction) : d(direction), x(1 / d.x), y(1 / d.y), z(1 / d.z) {}
  Direction d;
  double x, y, z;
};

/// Moves a ray to the side by which it leaves, and in again at the opposite one.
void reenter(Place& place, const Direction& d, const Period& period, double length, bool along_x) {
  place = {place.x + length * d.x, place.y + length * d.y, place.z + length * d.z};
  if (along_x) {
    place.x = d.x > 0 ? 0 : period.nx;
    place.y = std::clamp(place.y, 0.0, period.ny);
  } else {
    place.y = d.y > 0 ? 0 : period.ny;
    place.x = std::clamp(place.x, 0.0, period.nx);
  }
}

/// One piece of a ray, within one period: its lengths until it leaves by a side and until it is above the highest or
/// below the lowest point.
struct Piece {
  double side, end;
  bool along_x;
  bool last() const { return end <= side; }
  double length() const { return std::min(side, end); }
};

Piece piece_of(const Place& place, const Aim& aim, const Period& period) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const double x = aim.d.x > 0 ? (period.nx - place.x) * aim.x : aim.d.x < 0 ? -place.x * aim.x : far;
  const double y = aim.d.y > 0 ? (period.ny - place.y) * aim.y : aim.d.y < 0 ? -place.y * aim.y : far;
  const double z = aim.d.z > 0   ? (period.highest - place.z) * aim.z
                   : aim.d.z < 0 ? (period.lowest - place.z) * aim.z
                                 : far;
  return {std::max(std::min(x, y), 0.0), std::max(z, 0.0), x <= y};
}

/// Lanes of a packet as Embree wants them: origin a little behind the side by which the ray came in.
template <class Rays>
void set_lane(Rays& rays, std::size_t k, const Place& place, const Direction& d, const Piece& piece, bool entered) {
  const double back = entered ? overlap : 0;
  rays.org_x[k] = static_cast<float>(place.x - back * d.x);
  rays.org_y[k] = static_cast<float>(place.y - back * d.y);
  rays.org_z[k] = static_cast<float>(place.z - back * d.z);
  rays.dir_x[k] = static_cast<float>(d.x);
  rays.dir_y[k] = static_cast<float>(d.y);
  rays.dir_z[k] = static_cast<float>(d.z);
  rays.tnear[k] = 0;
  rays.tfar[k] = static_cast<float>(piece.length() + back) + overlap;
  rays.time[k] = 0;
  rays.mask[k] = 0xFFFFFFFF;
  rays.id[k] = static_cast<unsigned>(k);
  rays.flags[k] = 0;
}

Place lifted(const SurfacePoint& point) { return {point.x, point.y, static_cast<double>(point.z) + lift}; }

} // namespace

void start_embree() { device(); }

TraceCounts& TraceCounts::operator+=(const TraceCounts& other) {
  coherent += other.coherent;
  incoherent += other.incoherent;
  lost += other.lost;
  coherent_seconds += other.coherent_seconds;
  incoherent_seconds += other.incoherent_seconds;
  return *this;
}

struct Tracer::Scene {
  RTCScene scene = nullptr;
  Period period{};

  explicit Scene(const HeightField& field)
      : period{static_cast<double>(field.nx()), static_cast<double>(field.ny()), field.lowest(), field.highest()} {
    scene = rtcNewScene(device());
    if (scene == nullptr) throw std::bad_alloc();
    try {
      build(field);
    } catch (...) {
      rtcReleaseScene(scene);
      throw;
    }
  }
  ~Scene() { rtcReleaseScene(scene); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

private:
  void build(const HeightField& field) {
    // Robust: without it rays slip through between facets, and a ray below the surface is lost.
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    // A build of millions of facets takes long: it is given up after Ctrl-C.
    rtcSetSceneProgressMonitorFunction(
        scene, [](void*, double) { return !interrupted(); }, nullptr);
    const std::unique_ptr<RTCGeometryTy, void (*)(RTCGeometry)> mesh(
        rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_QUAD), [](RTCGeometry made) { rtcReleaseGeometry(made); });
    if (mesh == nullptr) throw std::bad_alloc();
    fill(mesh.get(), field);
    rtcCommitGeometry(mesh.get());
    rtcAttachGeometry(scene, mesh.get());
    const bool large = field.heights().size() > std::size_t{1} << 18;
    const RTCError error = large ? commit_interruptibly() : commit(scene);
    throw_if_interrupted();
    if (error != RTC_ERROR_NONE) throw std::bad_alloc();
  }

  /// Embree keeps its errors by thread.
  static RTCError commit(RTCScene scene) {
    rtcCommitScene(scene);
    return rtcGetDeviceError(device());
  }

  /// Between its calls of the progress monitor Embree takes seconds for some stages of a large tree.
  RTCError commit_interruptibly() const {
    rtcRetainScene(scene);
    return interruptible([scene = scene, threads = tbb::this_task_arena::max_concurrency()] {
      RTCError error = RTC_ERROR_NONE;
      tbb::task_arena(threads).execute([&] { error = commit(scene); });
      rtcReleaseScene(scene);
      return error;
    });
  }

  /// Quads, which Embree cuts like HeightField: grids take less memory and are built faster, but were traced at two
  /// thirds of the speed. Columns and rows nx, ny are those of the next period.
  static void fill(RTCGeometry mesh, const HeightField& field) {
    const auto nx = static_cast<unsigned>(field.nx());
    const auto ny = static_cast<unsigned>(field.ny());
    const std::size_t vertices = (std::size_t{nx} + 1) * (std::size_t{ny} + 1);
    auto* vertex = static_cast<float*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices));
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
                                                                 4 * sizeof(unsigned), std::size_t{nx} * ny));
    if (vertex == nullptr || index == nullptr) throw std::bad_alloc();
    for (unsigned iy = 0; iy <= ny; ++iy) {
      throw_if_interrupted();
      for (unsigned ix = 0; ix <= nx; ++ix) {
        *vertex++ = static_cast<float>(ix);
        *vertex++ = static_cast<float>(iy);
        *vertex++ = field.height(static_cast<int>(ix % nx), static_cast<int>(iy % ny));
      }
    }
    for (unsigned iy = 0; iy < ny; ++iy)
      for (unsigned ix = 0; ix < nx; ++ix) {
        const unsigned corner = iy * (nx + 1) + ix;
        for (const unsigned k : {corner, corner + 1, corner + nx + 2, corner + nx + 1}) *index++ = k;
      }
  }
};

Tracer::Tracer(const HeightField& field)
    : scene_(std::make_unique<Scene>(field)), shadow_rays_(field), field_(&field) {}
Tracer::~Tracer() = default;

void Tracer::visible(std::span<const SurfacePoint> points, const Direction& direction, unsigned char* visible) const {
  shadow_rays_.trace(points, direction, lift, visible);
}

void Tracer::first_hits(std::span<SurfacePoint> points, const Direction& direction, unsigned char* hit) const {
  RayQuery query(true);
  const Period& period = scene_->period;
  const Direction down = -1.0 * direction;
  const Aim downwards(down);
  const auto nx = static_cast<unsigned>(field_->nx());
  for (std::size_t begin = 0; begin < points.size(); begin += lanes) {
    const std::size_t count = std::min(lanes, points.size() - begin);
    alignas(32) RTCRayHit8 rays;
    alignas(32) std::array<int, lanes> valid{};
    std::array<Place, lanes> place{};
    std::array<Piece, lanes> piece{};
    std::size_t left = count;
    const auto send = [&](std::size_t k, bool entered) {
      piece[k] = piece_of(place[k], downwards, period);
      set_lane(rays.ray, k, place[k], down, piece[k], entered);
      rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    };
    for (std::size_t k = 0; k < lanes; ++k) {
      const SurfacePoint& point = points[begin + std::min(k, count - 1)];
      place[k] = {point.x, point.y, period.highest + 2 * static_cast<double>(overlap)};
      valid[k] = k < count ? -1 : 0;
      send(k, false);
    }
    while (left > 0) {
      query.trace(scene_->scene, valid.data(), rays);
      for (std::size_t k = 0; k < count; ++k) {
        if (valid[k] == 0) continue;
        const bool found = rays.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        if (found || piece[k].last()) {
          hit[begin + k] = found ? 1 : 0;
          if (found) {
            const unsigned cell = rays.hit.primID[k];
            points[begin + k] = field_->on_facet(static_cast<int>(cell % nx), static_cast<int>(cell / nx),
                                                 rays.hit.u[k] + rays.hit.v[k] > 1, rays.hit.u[k], rays.hit.v[k]);
          }
          valid[k] = 0;
          --left;
          continue;
        }
        reenter(place[k], down, period, piece[k].side, piece[k].along_x);
        send(k, true);
      }
    }
  }
}

Tracer::Fate Tracer::next_hit(SurfacePoint& point, const Direction& direction) const {
  RayQuery query(false);
  const Period& period = scene_->period;
  const auto nx = static_cast<unsigned>(field_->nx());
  const Direction& d = direction;
  const Aim aim(d);
  Place place = lifted(point);
  double back = 0;
  // A horizontal ray along a valley of a surface that has straight ones would never end.
  for (int k = 0; k < 10000; ++k) {
    const Piece piece = piece_of(place, aim, period);
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(place.x - back * d.x);
    ray.ray.org_y = static_cast<float>(place.y - back * d.y);
    ray.ray.org_z = static_cast<float>(place.z - back * d.z);
    ray.ray.dir_x = static_cast<float>(d.x);
    ray.ray.dir_y = static_cast<float>(d.y);
    ray.ray.dir_z = static_cast<float>(d.z);
    ray.ray.tfar = static_cast<float>(piece.length() + back) + overlap;
    ray.ray.mask = 0xFFFFFFFF;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    for (;;) {
      query.trace(scene_->scene, ray);
      if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) break;
      const unsigned cell = ray.hit.primID;
      const SurfacePoint found = field_->on_facet(static_cast<int>(cell % nx), static_cast<int>(cell / nx),
                                                  ray.hit.u + ray.hit.v > 1, ray.hit.u, ray.hit.v);
      if (projected_area(found.slope, d) < 0) {
        point = found;
        return Fate::hit;
      }
      // A facet met from below: the ray had started beneath it by rounding, and comes out here.
      ray.ray.tnear = ray.ray.tfar + lift;
      ray.ray.tfar = static_cast<float>(piece.length() + back) + overlap;
      ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      if (!(ray.ray.tnear < ray.ray.tfar)) break;
    }
    if (piece.last()) return d.z > 0 ? Fate::escaped : Fate::lost;
    reenter(place, d, period, piece.side, piece.along_x);
    back = overlap;
  }
  return Fate::lost;
}

} // namespace brdfplot::simulation
