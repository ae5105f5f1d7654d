// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/models/model_cage.h"

#include <ostream>
#include <stdexcept>

namespace cagewright::host {
namespace {

constexpr const char* own_models = CAGEWRIGHT_OWN_MODELS;
constexpr const char* real_models = CAGEWRIGHT_REAL_MODELS;

}  // namespace

std::filesystem::path Model::file() const {
  return std::filesystem::path(is_own ? own_models : real_models) / (std::string(name) + ".off");
}

std::filesystem::path Model::slides_file() const {
  return std::filesystem::path(CAGEWRIGHT_SLIDE_FILES) / (std::string(name) + ".slides.json");
}

std::optional<std::string> Model::why_missing() const {
  const bool is_given = *(is_own ? own_models : real_models) != '\0';
  if (is_given) return std::nullopt;  // then a file that is not there is a failure
  return std::string(name) + (is_own ? " is not made: configure with -DCAGEWRIGHT_BUILD_TESTDATA=ON"
                                     : " is a real model: configure with -DCAGEWRIGHT_REAL_MODELS=DIR");
}

void PrintTo(const Model& model, std::ostream* out) { *out << model.name; }

const std::vector<Model>& all_models() {
  // As many iterations as the paper allows; for the armadillo as many as it needed (figure 11).
  static const std::vector<Model> models = {
      {"biped", true, 17, 18, 0, 30},     {"quadruped", true, 23, 24, 0, 30}, {"octopus", true, 34, 35, 0, 30},
      {"genus3", true, 18, 16, 3, 30},    {"blob", true, 11, 12, 0, 30},      {"armadillo", false, 23, 24, 0, 16},
      {"elk", false, 20, 20, 1, 30},      {"man", false, 23, 24, 0, 30},      {"bunny00", false, 14, 15, 0, 30},
      {"elephant", false, 21, 19, 3, 30},
  };
  return models;
}

const Model& model_named(const std::string& name) {
  for (const Model& model : all_models()) {
    if (model.name == name) return model;
  }
  throw std::runtime_error("no model " + name);
}

CageRun make_cage(const TemporaryFolder& folder, const std::filesystem::path& model,
                  const std::filesystem::path& slides, const std::vector<std::string>& more_arguments) {
  std::vector<std::string> arguments = {"cage",     model.string(),
                                        "--slides", slides.string(),
                                        "-o",       (folder / "cage.obj").string(),
                                        "--report", (folder / "report.json").string()};
  arguments.insert(arguments.end(), more_arguments.begin(), more_arguments.end());
  CageRun result;
  result.run = run_program(arguments);
  if (result.run.exit_code != 0) return result;
  result.report_bytes = folder.read("report.json");
  result.cage_bytes = folder.read("cage.obj");
  result.cage = obj_surface(result.cage_bytes);
  return result;
}

}  // namespace cagewright::host
