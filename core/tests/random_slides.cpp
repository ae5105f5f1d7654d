// SPDX-License-Identifier: BSD-3-Clause
// Random sets of slides through the whole road, with default options: whatever the slides are, the cage is certified,
// or a sentence names a slide. See usage() and `./dev random-slides`.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error/error.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/off_file.h"
#include "core/tests/shapes.h"
#include "core/tests/slide_sets.h"
#include "testdata/oracle/oracle.h"

namespace cagewright {
namespace {

struct Settings {
  int count = 0, first = 0, judge_every = 1;
  unsigned seed = 1;
  double most_seconds = 10;  // for one cage
  std::string oracle;
  std::filesystem::path keep;
  std::vector<std::filesystem::path> models;
};

struct Body {
  std::string name;
  Model model;
  std::filesystem::path file;               // of the mesh as it was given, for the oracle
  std::unique_ptr<TemporaryOff> temporary;  // where it is none of the user's
};

enum class Outcome { in_plane, released, sentence, failed };
constexpr const char* outcome_names[] = {"certified in plane", "certified, sections released",
                                         "not certified, with a sentence", "FAILED"};

struct Verdict {
  Outcome outcome = Outcome::failed;
  std::string sentence;  // ours where not all is well, or what failed
  double seconds = 0;
  double processor_seconds = 0;  // of all threads: to tell a busy machine from a slow solve
  bool is_judged = false;
};

struct Tally {
  std::map<Outcome, int> outcomes;
  int sets = 0, judged = 0, too_few = 0, worst_set = 0;
  std::size_t slides = 0;
  double worst_seconds = 0, seconds = 0;
};

// Those of the plug-in.
PipelineOptions default_options() {
  PipelineOptions options;
  options.refine.delta = 0;
  options.refine.in_plane = options.enclose.in_plane;
  options.last_stage = Stage::enclose;
  return options;
}

bool names_a_slide(const std::string& sentence, const std::vector<Slide>& slides) {
  return std::any_of(slides.begin(), slides.end(),
                     [&](const Slide& slide) { return sentence.find("'" + slide.name + "'") != std::string::npos; });
}

Verdict failed(const std::string& why, double seconds = 0) { return {Outcome::failed, why, seconds}; }

// Empty where the oracle agrees that the cage encloses the model.
std::string denial(const Settings& settings, const Body& body, const IndexedMesh& cage) {
  const TemporaryOff file(cage, "random_slides_cage");
  try {
    const nlohmann::json answer = ask_oracle(settings.oracle, body.file, file.path());
    return OracleVerdict(answer).encloses() ? "" : "the oracle denies the certificate: " + answer.dump();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

Verdict solve(const Settings& settings, const Body& body, const std::vector<Slide>& slides, int set) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  Verdict verdict;
  PipelineResult result;
  try {
    result = make_cage(body.model, slides, default_options());
    verdict.seconds = elapsed();
    verdict.sentence = result.enclosure->shortfall;
    verdict.outcome = !result.enclosure->certificate.encloses()      ? Outcome::sentence
                      : result.enclosure->sections_off_plane.empty() ? Outcome::in_plane
                                                                     : Outcome::released;
  } catch (const Error& error) {
    verdict = {Outcome::sentence, error.what(), elapsed()};
  } catch (const std::exception& error) {
    return failed(std::string("an exception that is no Error: ") + error.what(), elapsed());
  }
  if (verdict.outcome != Outcome::in_plane && !names_a_slide(verdict.sentence, slides))
    return failed("the sentence names no slide: " + verdict.sentence, verdict.seconds);
  if (verdict.outcome != Outcome::sentence && !settings.oracle.empty() && set % settings.judge_every == 0) {
    verdict.is_judged = true;
    const std::string why = denial(settings, body, {result.cage->points, result.cage->triangles});
    if (!why.empty()) return failed(why, verdict.seconds);
  }
  if (verdict.seconds <= settings.most_seconds) return verdict;
  return failed("it takes too long; " + std::string(outcome_names[static_cast<std::size_t>(verdict.outcome)]),
                verdict.seconds);
}

// As the program reads them.
void keep(const Settings& settings, const Body& body, const std::vector<Slide>& slides, int set) {
  const auto numbers = [](const Vector3& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
  nlohmann::json document = {{"version", 1}, {"slides", nlohmann::json::array()}};
  for (const Slide& slide : slides) {
    const auto& plane = std::get<PointNormalDefinition>(slide.definition);
    document["slides"].push_back(
        {{"name", slide.name}, {"point", numbers(plane.point)}, {"normal", numbers(plane.normal)}});
  }
  std::filesystem::create_directories(settings.keep);
  std::ofstream(settings.keep / (body.name + "-" + std::to_string(set) + ".slides.json")) << document.dump(1) << '\n';
}

void run_set(const Settings& settings, const Body& body, const SlideSets& sets, int set, Tally& tally) {
  Random random(settings.seed * 1'000'003u + static_cast<unsigned>(set));
  std::cout << body.name << ' ' << set << ": " << std::flush;  // first, so that a crash shows where
  const std::vector<Slide> slides = sets.make_set(random);
  if (slides.size() < 2) {
    ++tally.too_few;
    std::cout << "fewer than two slides fit" << std::endl;
    return;
  }
  const std::clock_t before = std::clock();
  Verdict verdict = solve(settings, body, slides, set);
  verdict.processor_seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  ++tally.sets;
  ++tally.outcomes[verdict.outcome];
  tally.judged += verdict.is_judged;
  tally.slides += slides.size();
  tally.seconds += verdict.seconds;
  if (verdict.seconds > tally.worst_seconds) {
    tally.worst_seconds = verdict.seconds;
    tally.worst_set = set;
  }
  std::cout << slides.size() << " slides, " << verdict.seconds << " s (processors: " << verdict.processor_seconds
            << " s), " << outcome_names[static_cast<std::size_t>(verdict.outcome)];
  if (!verdict.sentence.empty()) std::cout << ": " << verdict.sentence;
  std::cout << std::endl;
  if (!settings.keep.empty() && verdict.outcome >= Outcome::sentence) keep(settings, body, slides, set);
}

std::string summary(const Body& body, const Tally& tally) {
  std::ostringstream text;
  const double sets = std::max(1, tally.sets);
  text.precision(3);
  text << body.name << ": " << tally.sets << " sets of " << static_cast<double>(tally.slides) / sets
       << " slides on average";
  for (const Outcome outcome : {Outcome::in_plane, Outcome::released, Outcome::sentence, Outcome::failed}) {
    const auto found = tally.outcomes.find(outcome);
    const int count = found == tally.outcomes.end() ? 0 : found->second;
    text << "\n  " << outcome_names[static_cast<std::size_t>(outcome)] << ": " << count << " (" << 100 * count / sets
         << " %)";
  }
  text << "\n  certificates that the oracle was asked about: " << tally.judged << "\n  time: " << tally.seconds / sets
       << " s on average, " << tally.worst_seconds << " s at worst (set " << tally.worst_set << ")";
  if (tally.too_few > 0) text << "\n  left out, for fewer than two slides fitted: " << tally.too_few;
  return text.str();
}

std::vector<Body> bodies_of(const Settings& settings) {
  std::vector<Body> bodies;
  for (const std::filesystem::path& path : settings.models)
    bodies.push_back({path.stem().string(), prepare_model(read_off(path)), path, nullptr});
  if (!bodies.empty()) return bodies;
  for (const shapes::SlidBody& own : shapes::slid_bodies()) {
    auto file = std::make_unique<TemporaryOff>(own.mesh, "random_slides_model" + std::to_string(bodies.size()));
    const std::filesystem::path path = file->path();
    bodies.push_back({own.name, prepare_model(own.mesh), path, std::move(file)});
  }
  return bodies;
}

int usage() {
  std::cerr
      << "core_random_slides [OPTION]... COUNT [MODEL.off]...\n\n"
         "Makes cages of COUNT random sets of slides on each model (none named: small bodies of our own) and says\n"
         "how they end. Exit: 0; 1 where one is neither certified nor has a sentence that names a slide, takes\n"
         "more than --seconds, ends with anything else, or has a certificate that the oracle denies.\n\n"
         "  --oracle PROGRAM   a judge, PROGRAM MODEL CAGE; without it certificates are taken for granted\n"
         "  --judge-every N    asks it about every so manieth set only (1)\n"
         "  --seconds N        for one cage, with nothing else going on (10)\n"
         "  --keep FOLDER      writes the slides of sets without a certificate there\n"
         "  --seed N           other sets (1)\n"
         "  --first N          starts with that set (0): with COUNT 1 it is done again\n";
  return 2;
}

// False where the arguments will not do.
bool read_arguments(const std::vector<std::string>& arguments, Settings& settings) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& option = arguments[i];
    if (option.rfind("--", 0) != 0) {
      others.push_back(option);
      continue;
    }
    if (++i == arguments.size()) return false;
    const std::string& value = arguments[i];
    if (option == "--oracle")
      settings.oracle = value;
    else if (option == "--keep")
      settings.keep = value;
    else if (option == "--judge-every")
      settings.judge_every = std::atoi(value.c_str());
    else if (option == "--seconds")
      settings.most_seconds = std::atof(value.c_str());
    else if (option == "--seed")
      settings.seed = static_cast<unsigned>(std::atoi(value.c_str()));
    else if (option == "--first")
      settings.first = std::atoi(value.c_str());
    else
      return false;
  }
  if (others.empty()) return false;
  settings.count = std::atoi(others.front().c_str());
  settings.models.assign(others.begin() + 1, others.end());
  return settings.count > 0 && settings.judge_every > 0 && settings.first >= 0;
}

int run(const Settings& settings) {
  std::string text;
  bool any_failed = false;
  for (const Body& body : bodies_of(settings)) {
    const SlideSets sets(body.model);
    Tally tally;
    for (int set = settings.first; set < settings.first + settings.count; ++set)
      run_set(settings, body, sets, set, tally);
    text += summary(body, tally) + "\n";
    any_failed = any_failed || tally.outcomes.contains(Outcome::failed);
  }
  std::cout << '\n' << text;
  return any_failed ? 1 : 0;
}

}  // namespace
}  // namespace cagewright

int main(int count, char** arguments) {
  cagewright::Settings settings;
  if (!cagewright::read_arguments({arguments + 1, arguments + count}, settings)) return cagewright::usage();
  try {
    return cagewright::run(settings);
  } catch (const std::exception& error) {
    std::cerr << "core_random_slides: " << error.what() << '\n';
    return 1;
  }
}
