// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// In the order in which --help lists them.

#include "cli/render/render_options.h"

#include "cli/options/choice.h"
#include "cli/options/number.h"
#include "cli/options/pose_options.h"
#include "cli/options/reading_options.h"
#include "cli/options/shape_options.h"

#include <limits>

namespace openltc::cli {

namespace {

void add_files(CLI::App& command, RenderArguments& a) {
  command.add_option("scene", a.scene, "The scene, .gltf or .glb")->required()->type_name("FILE");
  command
      .add_option("-o,--output", a.outputs,
                  "File to write, may be repeated; .exr and .hdr hold scene-linear radiance in "
                  "nits, .png an exposed, tone-mapped picture [SCENE.png in this folder]")
      ->allow_extra_args(false)
      ->type_name("FILE");
}

void add_sampling(CLI::App& command, RenderArguments& a) {
  const Choices<render::Integrator> integrators = {{"ltc", render::Integrator::ltc},
                                                   {"reference", render::Integrator::reference}};
  add_choice(command, "--integrator", a.integrator,
             "ltc: closed form times sampled shadows; reference: unbiased sampling with "
             "the true BRDF, and a layer \"stderr\" with its standard error [ltc]",
             integrators);
  command
      .add_option("--samples", a.samples,
                  "Camera samples per pixel [8; reference 256, each with one light sample]")
      ->transform(whole_number(1, 1 << 20))
      ->type_name("N");
  command
      .add_option(
          "--shadow-samples", a.shadow_samples,
          "Shadow rays per pixel and area light: half of them where neighbours agree, three times "
          "as many in penumbrae; 0 turns all shadows off")
      ->transform(whole_number(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--light-error", a.light_error,
                  "Scenes of many area lights: how far a surface's light may be from that of all "
                  "lights one by one, as a fraction of what surfaces there reflect, shadows "
                  "included, and of what they emit. Within it, lights are left out or "
                  "taken in groups; 0 shades all")
      ->check(number(0, 1))
      ->type_name("FRACTION")
      ->capture_default_str();
  const Choices<render::PixelFilter> filters = {
      {"blackman-harris", render::PixelFilter::blackman_harris},
      {"none", render::PixelFilter::none}};
  add_choice(command, "--filter", a.filter,
             "Reconstruction filter; none: all rays through the middle of the pixel, to "
             "compare light without edges [blackman-harris]",
             filters);
  const Choices<render::PunctualForm> forms = {{"exact", render::PunctualForm::exact},
                                               {"ltc", render::PunctualForm::ltc}};
  add_choice(command, "--point-lights", a.point_lights,
             "Point, spot and directional lights by the exact BRDF or by the density of "
             "its LTC lobe [exact]",
             forms);
  const Choices<render::SpecularForm> specular = {{"lobe", render::SpecularForm::lobe},
                                                  {"ratio", render::SpecularForm::ratio},
                                                  {"exact", render::SpecularForm::exact},
                                                  {"adaptive", render::SpecularForm::adaptive}};
  add_choice(command, "--specular", a.specular,
             "Specular light of area lights by the fitted lobe alone; times the ratio of the BRDF "
             "to it in the direction of each light: small lights are exact then, and mean errors a "
             "third; by GGX itself with its Fresnel reflectance: exact, polygons in three to eight "
             "times the time; or adaptive: by GGX itself, but by the ratio large polygons on "
             "surfaces that are not seen at a grazing angle [adaptive; "
             "lobe with a --table of another BRDF than ggx and from 64 area lights on]",
             specular);
}

void add_lights(CLI::App& command, RenderArguments& a) {
  const Choices<render::LightsFrom> choices = {{"auto", render::LightsFrom::automatic},
                                               {"scene", render::LightsFrom::scene},
                                               {"studio", render::LightsFrom::studio},
                                               {"both", render::LightsFrom::both}};
  add_choice(command, "--lights", a.lights,
             "Which lights: those of the scene, a studio rig of three soft boxes, or both "
             "[scene; studio where it says nothing of lights]",
             choices);
  add_shape_options(command, a.emissive);
  add_reading_options(command, a.reading);
  add_pose_options(command, a.reading.pose);
}

void add_frames(CLI::App& command, RenderArguments& a) {
  CLI::Option* frames =
      command
          .add_option(
              "--frames", a.frames,
              "Frames of the file's animation, such as 1-240, 1-240x10 or 1-24,48. Frame N shows "
              "it "
              "at N / fps seconds; #### in -o becomes its number. Frames that are there, made of "
              "the same files by the same options and version, are not made again")
          ->excludes("--time")
          ->type_name("FRAMES");
  command.add_option("--fps", a.frames_per_second, "With --frames: frames per second")
      ->check(number(1e-3, 1e6))
      ->needs(frames)
      ->type_name("N")
      ->capture_default_str();
  command
      .add_flag("--list-missing", a.list_missing,
                "With --frames: print those that are still to be made, and make none")
      ->needs(frames);
  command
      .add_option("--scheduler", a.scheduler,
                  "With --frames: have the workers of this Dask scheduler make them, which see the "
                  "same folders; by the command of the Python package, openltc[cluster]")
      ->needs(frames)
      ->type_name("ADDRESS");
}

void add_view(CLI::App& command, RenderArguments& a) {
  command
      .add_option(
          "--camera", a.camera,
          "Camera by name or number from 0; \"frame\" shows what the scene is of, without its "
          "ground and sky, from where most of it is seen [the first]")
      ->type_name("NAME|N|frame");
  command.add_option("--size", a.size, "WIDTHxHEIGHT in pixels [height 720, the camera's aspect]")
      ->type_name("WxH");
  command
      .add_option("--background", a.background,
                  "Radiance where nothing is hit, in nits: one number or R,G,B [0; with the "
                  "studio rig alone 0.07, a dark grey]")
      ->type_name("NITS");
}

void add_display(CLI::App& command, RenderArguments& a) {
  command
      .add_option(
          "--exposure", a.exposure,
          "EV100 or \"auto\", from the picture or for the studio rig, 99 % of the pixels below "
          "white; for .png only")
      ->capture_default_str()
      ->type_name("EV100|auto");
  const Choices<image::Tonemap> tonemaps = {{"neutral", image::Tonemap::neutral},
                                            {"aces", image::Tonemap::aces},
                                            {"none", image::Tonemap::none}};
  add_choice(command, "--tonemap", a.display.tonemap,
             "For .png: Khronos PBR Neutral, ACES, or none [neutral]", tonemaps);
  command.add_flag("--half", a.half, "Write .exr in half precision, which ends at 65504 nits");
}

void add_lobes(CLI::App& command, RenderArguments& a) {
  const Choices<table::LobeForm> forms_of_lobes = {
      {"table", table::LobeForm::table},
      {"polynomial", table::LobeForm::polynomial},
      {"two-lobe", table::LobeForm::two_lobe},
      {"two-lobe-polynomial", table::LobeForm::two_lobe_polynomial}};
  add_choice(
      command, "--lobes", a.lobes,
      "Lobes of the LTC integrator from a table or a polynomial, of one lobe or of two, half the "
      "error for half as much time again [what --table holds; two-lobe, from 64 area lights on "
      "table]",
      forms_of_lobes);
  command
      .add_option(
          "--table", a.table,
          "Lobes from openltc fit: a table (.json .ktx2 .dds .exr .npy) or a polynomial (.json) "
          "[built-in GGX]")
      ->type_name("FILE");
}

void add_running(CLI::App& command, RenderArguments& a) {
  command.add_option("--seed", a.seed, "Seed of the sampling")
      ->transform(whole_number(0, std::numeric_limits<std::uint32_t>::max()))
      ->capture_default_str()
      ->type_name("N");
  command
      .add_option("--threads", a.threads,
                  "Threads, 0 for all cores; the picture is the same for any number")
      ->transform(whole_number(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--kernel", a.kernel,
                  "Shading kernel, to compare: auto, scalar, sse4, avx2, avx512, neon")
      ->check(CLI::IsMember({"auto", "scalar", "sse4", "avx2", "avx512", "neon"}).description(""))
      ->type_name("NAME")
      ->capture_default_str();
  command.add_flag("--json", a.json, "Print what was done and the times as JSON on stdout");
  command.add_flag("--quiet", a.quiet, "No progress, warnings and messages on stderr");
}

} // namespace

void add_render_options(CLI::App& command, RenderArguments& arguments) {
  command.footer(
      "Area lights are integrated in closed form with linearly transformed cosines (LTC), so the\n"
      "light itself has no noise; shadows are sampled. Lights come from the file: emissive\n"
      "surfaces, KHR_lights_punctual, EXT_lights_area, openltc_light in a node's extras. A file\n"
      "that says nothing of lights gets a studio rig, a file without camera is framed.\n"
      "\n"
      "Examples:\n"
      "  openltc render helmet.glb                          writes helmet.png here\n"
      "  openltc render room.glb -o room.exr -o room.png    radiance and a picture to look at\n"
      "  openltc render room.glb --shadow-samples 0 --samples 64 -o clean.png\n"
      "  openltc render room.glb --integrator reference --samples 1024 -o truth.exr\n"
      "  openltc compare room.exr truth.exr\n"
      "  openltc render walk.glb --frames 1-240 --fps 24 -o walk.####.exr");
  add_files(command, arguments);
  add_sampling(command, arguments);
  add_lights(command, arguments);
  add_frames(command, arguments);
  add_view(command, arguments);
  add_display(command, arguments);
  add_lobes(command, arguments);
  add_running(command, arguments);
}

} // namespace openltc::cli
