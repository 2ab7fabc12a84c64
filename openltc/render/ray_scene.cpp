// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/ray_scene.h"

#include "openltc/base/address_space.h"
#include "openltc/base/parallel.h"
#include "openltc/base/quote.h"
#include "openltc/render/embree.h"
#include "openltc/render/surface_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <mutex>

namespace openltc::render {

namespace {

/// A query's context with the place where filters collect transmittance.
struct ShadowQuery {
  QueryContext base; // first: Embree hands its address to the filters
  float transmittance[RayPacket::k_size];
};

struct MeshUserData {
  const scene::Scene* scene;
  const TextureSet* textures;
  std::uint32_t mesh;
};

bool is_blended(const scene::Material& m) { return m.alpha_mode == scene::AlphaMode::blend; }
bool needs_filter(const scene::Material& m) { return m.alpha_mode != scene::AlphaMode::opaque; }

float alpha_at(const MeshUserData& data, std::uint32_t triangle, float u, float v) {
  return surface_alpha(*data.scene, *data.textures, data.mesh, triangle, u, v);
}

const scene::Material& material_of(const MeshUserData& data) {
  const scene::Mesh& mesh = data.scene->meshes[data.mesh];
  return data.scene->materials[std::size_t(mesh.material)];
}

// Passes camera rays through masked-out texels.
void intersect_filter(const RTCFilterFunctionNArguments* arguments) {
  const auto& data = *static_cast<const MeshUserData*>(arguments->geometryUserPtr);
  const scene::Material& material = material_of(data);
  if (material.alpha_mode != scene::AlphaMode::mask) return;
  const unsigned n = arguments->N;
  for (unsigned i = 0; i < n; ++i) {
    if (arguments->valid[i] != -1) continue;
    const float alpha = alpha_at(data, RTCHitN_primID(arguments->hit, n, i),
                                 RTCHitN_u(arguments->hit, n, i), RTCHitN_v(arguments->hit, n, i));
    if (alpha < material.alpha_cutoff) arguments->valid[i] = 0;
  }
}

// Collects transmittance of blended surfaces and goes on until nothing is left.
void occluded_filter(const RTCFilterFunctionNArguments* arguments) {
  const auto& data = *static_cast<const MeshUserData*>(arguments->geometryUserPtr);
  const scene::Material& material = material_of(data);
  // The address of the base is that of the whole: it is the first member of a plain struct.
  auto& query = *reinterpret_cast<ShadowQuery*>(arguments->context);
  const unsigned n = arguments->N;
  for (unsigned i = 0; i < n; ++i) {
    if (arguments->valid[i] != -1) continue;
    const float alpha = alpha_at(data, RTCHitN_primID(arguments->hit, n, i),
                                 RTCHitN_u(arguments->hit, n, i), RTCHitN_v(arguments->hit, n, i));
    if (material.alpha_mode == scene::AlphaMode::mask) {
      if (alpha < material.alpha_cutoff) arguments->valid[i] = 0;
      continue;
    }
    float& left = query.transmittance[RTCRayN_id(arguments->ray, n, i)];
    left *= 1.0f - alpha;
    if (left > 1.0e-4f) arguments->valid[i] = 0;
  }
}

// The process's Embree, null where it cannot start. It is never ended: where memory is short,
// Embree 3 waits for its threads for ever.
RTCDevice embree_device() {
  static std::mutex mutex;
  static RTCDevice device = nullptr;
  const std::lock_guard lock(mutex);
  if (!device) device = rtcNewDevice(nullptr);
  return device;
}

} // namespace

struct RayScene::State {
  RTCScene scene = nullptr;
  std::vector<MeshUserData> user_data;

  ~State() {
    if (scene) rtcReleaseScene(scene);
  }
};

RayScene::RayScene() : state_(std::make_unique<State>()) {}
RayScene::~RayScene() = default;

Result<std::unique_ptr<RayScene>> RayScene::create(const scene::Scene& scene,
                                                   const TextureSet& textures) {
  std::unique_ptr<RayScene> result(new RayScene);
  State& state = *result->state_;
  // Embree that gets no memory for its threads, of 8 MiB of stack each, waits for ever.
  const auto threads = std::uint64_t(thread_count());
  if (!has_address_space((std::uint64_t(64) << 20) + threads * (std::uint64_t(16) << 20)))
    return Error{"not enough memory to start Embree; raise the limit (ulimit -v)"};
  const RTCDevice device = embree_device();
  if (!device)
    return Error{fmt::format("Embree cannot start on this machine (error {})",
                             int(rtcGetDeviceError(nullptr)))};
  rtcGetDeviceError(device); // forgets an earlier scene's
  state.scene = rtcNewScene(device);
  rtcSetSceneFlags(state.scene, RTC_SCENE_FLAG_ROBUST);
  // High quality may split a triangle in two and then call the filter for each part, which is no
  // matter to an alpha test but would dim a shadow ray twice.
  const bool has_blended = std::any_of(scene.materials.begin(), scene.materials.end(), is_blended);
  rtcSetSceneBuildQuality(state.scene,
                          has_blended ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_HIGH);

  state.user_data.reserve(scene.meshes.size());
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    const scene::Mesh& mesh = scene.meshes[m];
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec3f), std::max<std::size_t>(mesh.positions.size(), 1));
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(std::uint32_t), mesh.triangles.size());
    if (!mesh.triangles.empty() && (!vertices || !indices)) {
      rtcReleaseGeometry(geometry);
      return Error{fmt::format("mesh \"{}\": not enough memory for {} triangles", quote(mesh.name),
                               mesh.triangles.size())};
    }
    if (!mesh.triangles.empty()) {
      std::memcpy(vertices, mesh.positions.data(), mesh.positions.size() * sizeof(Vec3f));
      std::memcpy(indices, mesh.triangles.data(),
                  mesh.triangles.size() * 3 * sizeof(std::uint32_t));
    }
    state.user_data.push_back({&scene, &textures, std::uint32_t(m)});
    rtcSetGeometryUserData(geometry, &state.user_data.back());
    if (needs_filter(scene.materials[std::size_t(mesh.material)])) {
      rtcSetGeometryIntersectFilterFunction(geometry, intersect_filter);
      rtcSetGeometryOccludedFilterFunction(geometry, occluded_filter);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(state.scene, geometry, unsigned(m));
    rtcReleaseGeometry(geometry);
  }

  // One thread builds: a parallel build may order triangles differently from run to run, and where
  // surfaces coincide the picture would follow. (Ubuntu 22.04's Embree links an older TBB than ours
  // and does not notice; only there coincident surfaces may differ from run to run.)
  parallel_for(1, 1, [&](std::int64_t) { rtcCommitScene(state.scene); });
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE)
    return Error{fmt::format("Embree cannot build the scene (error {})", int(error))};
  return result;
}

HitPacket RayScene::intersect(const RayPacket& rays) const {
  constexpr int n = RayPacket::k_size;
  alignas(64) RTCRayHit16 query;
  alignas(64) int valid[n];
  std::memcpy(valid, rays.active, sizeof(valid));
  std::memcpy(query.ray.org_x, rays.origin[0], sizeof(query.ray.org_x));
  std::memcpy(query.ray.org_y, rays.origin[1], sizeof(query.ray.org_y));
  std::memcpy(query.ray.org_z, rays.origin[2], sizeof(query.ray.org_z));
  std::memcpy(query.ray.dir_x, rays.direction[0], sizeof(query.ray.dir_x));
  std::memcpy(query.ray.dir_y, rays.direction[1], sizeof(query.ray.dir_y));
  std::memcpy(query.ray.dir_z, rays.direction[2], sizeof(query.ray.dir_z));
  std::memcpy(query.ray.tnear, rays.near, sizeof(query.ray.tnear));
  std::memcpy(query.ray.tfar, rays.far, sizeof(query.ray.tfar));
  for (int i = 0; i < n; ++i) {
    query.ray.time[i] = 0;
    query.ray.mask[i] = ~0u;
    query.ray.id[i] = unsigned(i);
    query.ray.flags[i] = 0;
    query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  QueryContext context;
  init_query(context);
  intersect_16(valid, state_->scene, context, true, query);

  HitPacket hits;
  for (int i = 0; i < n; ++i) {
    const bool hit = valid[i] && query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    hits.mesh[i] = hit ? int(query.hit.geomID[i]) : -1;
    hits.triangle[i] = query.hit.primID[i];
    hits.distance[i] = query.ray.tfar[i];
    hits.u[i] = query.hit.u[i];
    hits.v[i] = query.hit.v[i];
  }
  return hits;
}

void RayScene::trace_shadows(const ShadowRays& rays) const {
  constexpr int n = RayPacket::k_size;
  alignas(64) RTCRay16 query;
  alignas(64) int valid[n];
  ShadowQuery context;
  init_query(context.base);
  for (int i = 0; i < n; ++i) {
    const bool used = i < rays.count && rays.active[i] != 0;
    const int from = i < rays.count ? i : 0;
    valid[i] = used ? -1 : 0;
    context.transmittance[i] = 1.0f;
    query.org_x[i] = rays.origin[0][from];
    query.org_y[i] = rays.origin[1][from];
    query.org_z[i] = rays.origin[2][from];
    query.dir_x[i] = rays.direction[0][from];
    query.dir_y[i] = rays.direction[1][from];
    query.dir_z[i] = rays.direction[2][from];
    query.tnear[i] = 0;
    query.tfar[i] = 1;
    query.time[i] = 0;
    query.mask[i] = ~0u;
    query.id[i] = unsigned(i);
    query.flags[i] = 0;
  }
  occluded_16(valid, state_->scene, context.base, query);
  for (int i = 0; i < rays.count; ++i) {
    if (!rays.active[i]) continue;
    // Embree sets tfar to -infinity where something blocks.
    rays.transmittance[i] = query.tfar[i] < 0 ? 0.0f : context.transmittance[i];
  }
}

} // namespace openltc::render
