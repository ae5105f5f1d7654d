// SPDX-License-Identifier: BSD-3-Clause
// cagewright_baselines METHOD MODEL TRIANGLES CAGE.off: the tightest cage of a model, with that many triangles or
// fewer, that a way other than ours makes; METHOD is wrap, offset or voxels. Prints what was found as a JSON object.
// Ends with 0 whether the cage encloses or not, 1 where there is none, 2 for wrong usage, 3 for files.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <string>

#include "host/bench/baselines/cage_search.h"
#include "host/bench/baselines/stopwatch.h"

namespace cagewright::bench {
namespace {

using Search = void (*)(BestCage&, const Judge&, std::size_t);

const std::map<std::string, Search> kMethods = {
    {"wrap", search_alpha_wraps}, {"offset", search_decimated_offsets}, {"voxels", search_voxel_grids}};

int run(Search search, const char* model_file, std::size_t triangles, const char* cage_file) {
  const Surface model = read_surface(model_file);
  const Judge judge(model);
  const Stopwatch searching;
  BestCage best(judge, triangles);
  search(best, judge, triangles);
  if (!best.best()) {
    std::fprintf(stderr, "cagewright_baselines: none of %zu cages has %zu triangles or fewer\n", best.tried(),
                 triangles);
    return 1;
  }
  const FoundCage& found = *best.best();
  write_surface(cage_file, found.cage);
  std::printf(
      "{\"triangles\": %zu, \"encloses\": %s, \"volume_ratio\": %.17g, \"parameters\": \"%s\", \"seconds\": %.3f, "
      "\"tried\": %zu, \"search_seconds\": %.3f}\n",
      triangle_count(found.cage), found.encloses ? "true" : "false", found.volume_ratio, found.parameters.c_str(),
      found.seconds, best.tried(), searching.seconds());
  return 0;
}

int main_of(int argc, char** argv) {
  constexpr const char* usage = "usage: cagewright_baselines wrap|offset|voxels MODEL TRIANGLES CAGE.off\n";
  std::size_t triangles = 0;
  const char* end = argc == 5 ? argv[3] + std::strlen(argv[3]) : nullptr;
  if (argc != 5 || !kMethods.contains(argv[1]) || std::from_chars(argv[3], end, triangles).ptr != end ||
      triangles < 4) {
    std::fputs(usage, stderr);
    return 2;
  }
  try {
    return run(kMethods.at(argv[1]), argv[2], triangles, argv[4]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cagewright_baselines: %s\n", error.what());
    return 3;
  }
}

}  // namespace
}  // namespace cagewright::bench

int main(int argc, char** argv) { return cagewright::bench::main_of(argc, argv); }
