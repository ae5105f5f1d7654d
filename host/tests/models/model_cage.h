// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_MODELS_MODEL_CAGE_H
#define CAGEWRIGHT_HOST_TESTS_MODELS_MODEL_CAGE_H

#include <filesystem>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/tests/models/surface.h"
#include "host/tests/run_program.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {

// A model that testdata/slides has a slides file for, and what its cage must be.
struct Model {
  const char* name;
  bool is_own;
  int slides, parts, genus;
  int most_iterations;  // of the refinement

  std::filesystem::path file() const;
  std::filesystem::path slides_file() const;
  // Why the tests on this model have to be skipped; nothing where its file is there.
  std::optional<std::string> why_missing() const;
};

void PrintTo(const Model& model, std::ostream* out);

const std::vector<Model>& all_models();
const Model& model_named(const std::string& name);

// What one run of `cagewright cage` left; empty where it failed.
struct CageRun {
  ProgramRun run;
  std::string report_bytes, cage_bytes;
  Surface cage;

  nlohmann::json report() const { return nlohmann::json::parse(report_bytes); }
};

// `cagewright cage MODEL --slides SLIDES` with the plug-in that the program finds by itself. Its files are in `folder`,
// as cage.obj and report.json; they overwrite older ones.
CageRun make_cage(const TemporaryFolder& folder, const std::filesystem::path& model,
                  const std::filesystem::path& slides, const std::vector<std::string>& more_arguments = {});

}  // namespace cagewright::host

#endif
