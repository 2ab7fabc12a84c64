// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "python/src/scene.h"

#include "openltc/base/file_observer.h"
#include "openltc/render/renderer.h"
#include "openltc/render/view/camera_choice.h"
#include "openltc/render/view/studio_choice.h"
#include "openltc/scene/gltf.h"
#include "openltc/table/shading_lobes.h"
#include "python/src/arrays.h"
#include "python/src/job.h"
#include "python/src/scene_check.h"
#include "python/src/vectors.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>
#include <set>

namespace openltc::python {

namespace nb = nanobind;

namespace {

/// Notes which files are read while a scene is loaded; what other threads read just then is among
/// them. It observes as long as the process lives: files may be on their way at any time.
class FilesRead : public FileObserver {
public:
  static FilesRead& of_process() {
    static FilesRead& one = [&]() -> FilesRead& {
      FilesRead& observer = *new FilesRead;
      observe_files(&observer);
      return observer;
    }();
    return one;
  }
  void reads(const std::string& path) override {
    const std::lock_guard lock(mutex_);
    if (noting_) paths_.insert(path);
  }
  /// The files that `work` reads. One such call at a time.
  template <class Work> std::vector<std::string> during(const Work& work) {
    const std::lock_guard alone(one_at_a_time_);
    note(true);
    try {
      work();
    } catch (...) {
      note(false);
      throw;
    }
    note(false);
    return {paths_.begin(), paths_.end()};
  }

private:
  void note(bool noting) {
    const std::lock_guard lock(mutex_);
    noting_ = noting;
    if (noting) paths_.clear();
  }
  std::mutex one_at_a_time_, mutex_;
  std::set<std::string> paths_;
  bool noting_ = false;
};

std::unique_ptr<LoadedScene> load(const std::string& path, std::optional<double> time_seconds,
                                  const std::string& animation, bool recognise_shapes,
                                  bool allow_outside) {
  scene::EmissiveOptions emissive;
  emissive.recognise_shapes = recognise_shapes;
  scene::ReadOptions reading;
  reading.allow_outside = allow_outside;
  reading.pose = {time_seconds, animation};
  auto loaded = std::make_unique<LoadedScene>();
  Job job{nb::none()};
  job.run([&] {
    loaded->files = FilesRead::of_process().during(
        [&] { loaded->scene = take(scene::load_gltf(path, emissive, reading)); });
  });
  return loaded;
}

nb::list lights_of(const LoadedScene& loaded) {
  nb::list all;
  loaded.scene.lights.for_each_area_light(
      [&](const auto& light) { all.append(nb::cast(light, nb::rv_policy::copy)); });
  for (const light::PunctualLight& light : loaded.scene.lights.punctual)
    all.append(nb::cast(light, nb::rv_policy::copy));
  return all;
}

template <class T> bool add_if(nb::handle light, std::vector<T>& to) {
  if (!nb::isinstance<T>(light)) return false;
  to.push_back(nb::cast<T>(light));
  return true;
}

/// What a list of Python holds, with the textures of the file.
light::Lights lights_from(const LoadedScene& loaded, nb::list list) {
  light::Lights lights;
  lights.textures = loaded.scene.lights.textures;
  for (nb::handle light : list)
    if (!(add_if(light, lights.polygons) || add_if(light, lights.ellipses) ||
          add_if(light, lights.spheres) || add_if(light, lights.tubes) ||
          add_if(light, lights.lines) || add_if(light, lights.punctual)))
      throw nb::type_error("lights: a light of the scene or of openltc.lights is wanted");
  take(check_lights(lights));
  return lights;
}

template <class T> nb::list list_of(const std::vector<T>& values) {
  nb::list all;
  for (const T& value : values)
    all.append(nb::cast(value, nb::rv_policy::copy));
  return all;
}

/// What a call asks for, by the names of openltc render's options.
struct Request {
  render::RenderOptions options;
  render::LightsFrom lights = render::LightsFrom::automatic;
  std::string camera_choice;
  std::optional<scene::Camera> camera;
  std::string lobes;
  bool background_given = false;
};

template <class T>
T choice(const std::string& what, const std::string& name,
         std::initializer_list<std::pair<const char*, T>> choices) {
  std::string names;
  for (const auto& [known, value] : choices) {
    if (name == known) return value;
    names += std::string(names.empty() ? "" : ", ") + known;
  }
  throw ToolError(fmt::format("{}={}: choose one of {}", what, name, names));
}

Request request_of(nb::dict given) {
  Request r;
  render::RenderOptions& o = r.options;
  const auto text = [&](const char* name) { return nb::cast<std::string>(given[name]); };
  o.width = nb::cast<int>(given["width"]);
  o.height = nb::cast<int>(given["height"]);
  o.integrator = choice<render::Integrator>(
      "integrator", text("integrator"),
      {{"ltc", render::Integrator::ltc}, {"reference", render::Integrator::reference}});
  o.samples = nb::cast<int>(given["samples"]);
  o.shadow_samples = nb::cast<int>(given["shadow_samples"]);
  o.light_error = nb::cast<float>(given["light_error"]);
  o.seed = nb::cast<std::uint32_t>(given["seed"]);
  o.threads = nb::cast<int>(given["threads"]);
  const std::string specular = text("specular");
  if (specular != "auto")
    o.specular_form = choice<render::SpecularForm>("specular", specular,
                                                   {{"lobe", render::SpecularForm::lobe},
                                                    {"ratio", render::SpecularForm::ratio},
                                                    {"exact", render::SpecularForm::exact},
                                                    {"adaptive", render::SpecularForm::adaptive}});
  o.filter = choice<render::PixelFilter>("filter", text("filter"),
                                         {{"blackman-harris", render::PixelFilter::blackman_harris},
                                          {"none", render::PixelFilter::none}});
  r.lights = choice<render::LightsFrom>("lights", text("lights"),
                                        {{"auto", render::LightsFrom::automatic},
                                         {"scene", render::LightsFrom::scene},
                                         {"studio", render::LightsFrom::studio},
                                         {"both", render::LightsFrom::both}});
  if (!given["background_nits"].is_none()) {
    o.background = nb::cast<Vec3f>(given["background_nits"]);
    r.background_given = true;
  }
  if (!given["window"].is_none()) {
    const auto w = nb::cast<std::array<int, 4>>(given["window"]);
    o.window = render::PixelWindow{w[0], w[1], w[2], w[3]};
  }
  if (nb::isinstance<scene::Camera>(given["camera"]))
    r.camera = nb::cast<scene::Camera>(given["camera"]);
  else
    r.camera_choice = text("camera");
  r.lobes = text("lobes");
  return r;
}

/// Puts the scene's own lights and materials back.
class FileKept {
public:
  explicit FileKept(scene::Scene& scene)
      : scene_(scene), lights_(scene.lights), materials_(scene.materials) {}
  ~FileKept() {
    scene_.lights = std::move(lights_);
    scene_.materials = std::move(materials_);
  }

private:
  scene::Scene& scene_;
  light::Lights lights_;
  std::vector<scene::Material> materials_;
};

render::LobeSource lobes_for(const Request& r, const light::Lights& lights) {
  if (r.options.integrator == render::Integrator::reference) return table::builtin_ggx_table();
  if (r.lobes == "auto") return render::builtin_lobes_for(lights);
  if (r.lobes == "table") return table::builtin_ggx_table();
  if (r.lobes == "polynomial") return table::builtin_ggx_polynomial();
  if (r.lobes == "two-lobe") return table::builtin_ggx_two_lobe_table();
  throw ToolError(fmt::format("lobes={}: choose auto, table, polynomial or two-lobe", r.lobes));
}

nb::dict render(LoadedScene& loaded, nb::list lights, nb::list materials, nb::dict given,
                nb::object progress) {
  const std::unique_lock alone(loaded.in_use, std::try_to_lock);
  if (!alone) throw ToolError("the scene is being rendered by another thread; load it once more");
  Request r = request_of(given);
  scene::Scene& scene = loaded.scene;
  light::Lights wanted = lights_from(loaded, lights);
  auto own_materials = nb::cast<std::vector<scene::Material>>(materials);
  if (own_materials.size() != scene.materials.size())
    throw ToolError(fmt::format("materials: the scene has {}, the list {}", scene.materials.size(),
                                own_materials.size()));
  take(check_materials(own_materials));
  if (r.camera) take(check_camera(*r.camera));
  const FileKept kept(scene);
  scene.lights = std::move(wanted);
  scene.materials = std::move(own_materials);
  render::Picture picture;
  Job job(std::move(progress));
  r.options.progress = job.progress();
  job.run([&] {
    const float aspect = float(r.options.width) / float(r.options.height);
    const scene::Camera camera =
        r.camera ? *r.camera : take(render::choose_camera(scene, r.camera_choice, aspect));
    const render::LightsChosen chosen = take(render::choose_lights(scene, r.lights, camera));
    if (chosen.background_nits && !r.background_given)
      r.options.background = Vec3f(*chosen.background_nits);
    picture = take(render::render(scene, camera, lobes_for(r, scene.lights), r.options));
  });
  nb::dict result;
  result["warnings"] = picture.warnings;
  result["kernel"] = picture.kernel;
  result["seconds"] = picture.render_seconds;
  result["light_error_nits"] = picture.light_error_nits;
  result["radiance"] = array_of_picture(std::move(picture.radiance));
  if (!picture.standard_error.empty())
    result["stderr"] = array_of_picture(std::move(picture.standard_error));
  return result;
}

} // namespace

nb::object array_of_picture(image::Image picture) {
  const auto height = std::size_t(picture.height), width = std::size_t(picture.width);
  const auto channels = std::size_t(picture.channels);
  return nb::cast(array_of(std::move(picture.data), {height, width, channels}));
}

void bind_scene(nb::module_& m) {
  nb::class_<LoadedScene>(m, "LoadedScene")
      .def("lights", &lights_of)
      .def("cameras", [](const LoadedScene& l) { return list_of(l.scene.cameras); })
      .def("materials", [](const LoadedScene& l) { return list_of(l.scene.materials); })
      .def_prop_ro("warnings", [](const LoadedScene& l) { return l.scene.warnings; })
      .def_ro("files", &LoadedScene::files)
      .def_prop_ro("bounds",
                   [](const LoadedScene& l) {
                     return nb::make_tuple(l.scene.bounds.lower, l.scene.bounds.upper);
                   })
      .def_prop_ro("origin",
                   [](const LoadedScene& l) {
                     return nb::make_tuple(l.scene.origin.x, l.scene.origin.y, l.scene.origin.z);
                   })
      .def_prop_ro("triangle_count",
                   [](const LoadedScene& l) {
                     std::size_t count = 0;
                     for (const scene::Mesh& mesh : l.scene.meshes)
                       count += mesh.triangles.size();
                     return count;
                   })
      .def_prop_ro("animations",
                   [](const LoadedScene& l) {
                     nb::list all;
                     for (const scene::Animation& a : l.scene.animations)
                       all.append(nb::make_tuple(a.name, a.duration_seconds));
                     return all;
                   })
      .def("choose_camera",
           [](const LoadedScene& l, const std::string& which, float aspect) {
             return take(render::choose_camera(l.scene, which, aspect));
           })
      .def("render", &render, nb::arg("lights"), nb::arg("materials"), nb::arg("options"),
           nb::arg("progress").none());
  m.def("load_scene", &load, nb::arg("path"), nb::arg("time_seconds").none(), nb::arg("animation"),
        nb::arg("recognise_shapes"), nb::arg("allow_outside"));
}

} // namespace openltc::python
