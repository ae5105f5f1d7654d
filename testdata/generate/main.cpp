// SPDX-License-Identifier: BSD-3-Clause
// cagewright_testdata OUTDIR [--resolution N] [--only NAME]: writes the models of our own as .off files.
#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "testdata/generate/figures.h"
#include "testdata/generate/mesh_facts.h"
#include "testdata/generate/surface.h"

namespace cagewright::testdata {
namespace {

constexpr const char* kUsage = "usage: cagewright_testdata OUTDIR [--resolution N] [--only NAME]";

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Options {
  std::filesystem::path folder;
  int resolution = 0;  // 0: each model's own
  std::string only;
};

int parse_resolution(std::string_view text) {
  int resolution = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), resolution);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || resolution < 40 || resolution > 2000)
    throw UsageError("--resolution '" + std::string(text) + "' is not a whole number from 40 to 2000");
  return resolution;
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--resolution" || argument == "--only") {
      if (++i == argc) throw UsageError(std::string(argument) + " needs a value");
      if (argument == "--only")
        options.only = argv[i];
      else
        options.resolution = parse_resolution(argv[i]);
    } else if (argument.starts_with("-") || !options.folder.empty()) {
      throw UsageError("'" + std::string(argument) + "' is not understood");
    } else {
      options.folder = argument;
    }
  }
  if (options.folder.empty()) throw UsageError("OUTDIR is missing");
  return options;
}

void write_figure(const Figure& figure, const Options& options) {
  const int resolution = options.resolution > 0 ? options.resolution : figure.resolution;
  const TriangleMesh mesh = mesh_surface(figure.field, resolution);
  const MeshFacts facts = count_facts(mesh);
  const std::filesystem::path file = options.folder / (figure.name + ".off");
  const std::string complaint = broken_promise(facts, figure.genus);
  if (!complaint.empty())
    throw std::runtime_error("the model '" + figure.name + "' " + complaint + " at resolution " +
                             std::to_string(resolution) + "; " + file.string() + " was not written");
  write_off(file, mesh);
  std::printf("%s: %zu vertices, %zu triangles, genus %d, volume %.4f\n", file.string().c_str(), facts.vertices,
              facts.triangles, facts.genus, facts.volume);
}

void run(const Options& options) {
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  if (error) throw FileError(options.folder.string() + ": cannot be made: " + error.message());
  bool found = false;
  for (const Figure& figure : all_figures()) {
    if (!options.only.empty() && options.only != figure.name) continue;
    found = true;
    write_figure(figure, options);
  }
  if (!found)
    throw UsageError("--only '" + options.only +
                     "' names no model; there are biped, quadruped, octopus, genus3, blob, "
                     "legs");
}

// Exit status: 0 done; 2 wrong usage; 3 a model breaks its promise, or a file cannot be written.
int exit_status(int argc, char** argv) {
  try {
    run(parse(argc, argv));
    return 0;
  } catch (const UsageError& error) {
    std::fprintf(stderr, "cagewright_testdata: %s\n%s\n", error.what(), kUsage);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cagewright_testdata: %s\n", error.what());
    return 3;
  }
}

}  // namespace
}  // namespace cagewright::testdata

int main(int argc, char** argv) { return cagewright::testdata::exit_status(argc, argv); }
