// SPDX-License-Identifier: BSD-3-Clause
// How quickly the cage follows a slide that is dragged: the workspace as the window uses it, without the window. See
// usage().
#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/workspace/workspace.h"

namespace cagewright::host {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* usage =
    "usage: cagewright_drag_bench PLUGIN MODEL SLIDES.json [SECONDS]\n"
    "Each slide in turn is dragged to and fro along its normal, as far as a tenth of its larger radius, and turned by\n"
    "as many radians, in small steps. First every new cage is answered by the next step at once, then steps come 125\n"
    "times a second, as from a mouse, whatever the cage does. Prints updates a second and, in milliseconds, the time\n"
    "from a step to its cage: median, 95th percentile, most; and the time of all processors for a cage.\n";

// Sleeps until the solver's thread has news.
class News {
 public:
  void tell() {
    const std::lock_guard lock(mutex_);
    is_there_ = true;
    changed_.notify_one();
  }
  bool wait_until(Clock::time_point end) {
    std::unique_lock lock(mutex_);
    const bool came = changed_.wait_until(lock, end, [this] { return is_there_; });
    is_there_ = false;
    return came;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_there_ = false;
};

struct Vector {
  double x, y, z;
};
Vector of(const Point3& p) { return {p[0], p[1], p[2]}; }
double length(const Vector& a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Point3 along(const Point3& from, double s, const Vector& by) {
  return {from[0] + s * by.x, from[1] + s * by.y, from[2] + s * by.z};
}

// Where the slide is at this phase of its drag.
Slide::Ellipse dragged(const Slide::Ellipse& start, double phase) {
  const double by = 0.1 * std::sin(2 * std::numbers::pi * phase);
  const Vector u = of(start.u), v = of(start.v);
  const Vector w = cross(u, v);
  const double size = length(u) / length(w);  // w becomes as long as u
  Slide::Ellipse slide = start;
  slide.center = along(start.center, by * size, w);
  for (std::size_t i = 0; i < 3; ++i) {
    const double along_normal = (i == 0 ? w.x : i == 1 ? w.y : w.z) * size;
    slide.u[i] = std::cos(by) * start.u[i] + std::sin(by) * along_normal;
  }
  return slide;
}

struct Figures {
  std::vector<double> milliseconds;  // from step to cage
  double seconds = 0, processor_seconds = 0;
  int failures = 0;  // steps without a cage: slides that touch, for instance
};

class Watch {
 public:
  void stop(Figures& figures) const {
    figures.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    figures.processor_seconds = static_cast<double>(std::clock() - clock_) / CLOCKS_PER_SEC;
  }

 private:
  Clock::time_point begin_ = Clock::now();
  std::clock_t clock_ = std::clock();
};

double at(const std::vector<double>& sorted, double share) {
  return sorted.empty() ? 0 : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void print(const std::string& what, Figures figures) {
  std::vector<double>& sorted = figures.milliseconds;
  std::sort(sorted.begin(), sorted.end());
  std::printf("%-24s %7.1f %9.1f %9.1f %9.1f %9.1f %7zu %7d\n", what.c_str(),
              static_cast<double>(sorted.size()) / figures.seconds, at(sorted, 0.5), at(sorted, 0.95), at(sorted, 1),
              1000 * figures.processor_seconds / static_cast<double>(std::max<std::size_t>(sorted.size(), 1)),
              sorted.size(), figures.failures);
}

class DragBench {
 public:
  DragBench(const std::string& plugin, const std::string& model, const std::string& slides)
      : workspace_(Plugin::load(plugin), [this] { news_.tell(); }) {
    workspace_.listen([this](WorkspaceChange change) { has_cage_ = has_cage_ || change == WorkspaceChange::cage; });
    workspace_.open(model);
    for (const Slide& slide : read_slides(slides)) workspace_.add_slide(slide);
    workspace_.wait_for_cage();
  }

  void run(double seconds) {
    const std::vector<const SceneSlide*> slides = workspace_.slides();
    std::printf("%zu triangles, %zu slides\n%-24s %7s %9s %9s %9s %9s %7s %7s\n",
                workspace_.mesh().triangles.size() / 3, slides.size(), "slide", "/s", "median ms", "95 % ms", "most ms",
                "cpu ms", "cages", "failed");
    Figures closed, open;
    const double each = seconds / static_cast<double>(2 * std::max<std::size_t>(slides.size(), 1));
    for (const SceneSlide* slide : slides) {
      const Figures of_slide = answer_every_cage(*slide, each);
      print(slide->name, of_slide);
      add(of_slide, closed);
      add(move_like_a_mouse(*slide, each), open);
    }
    print("all, cage after cage", closed);
    print("all, 125 steps a second", open);
  }

 private:
  static constexpr int steps_of_a_drag = 100;  // to and fro

  static void add(const Figures& some, Figures& all) {
    all.milliseconds.insert(all.milliseconds.end(), some.milliseconds.begin(), some.milliseconds.end());
    all.seconds += some.seconds;
    all.processor_seconds += some.processor_seconds;
    all.failures += some.failures;
  }

  void step(const SceneSlide& slide, int number) {
    workspace_.set_preview({{slide.id, dragged(slide.ellipse, static_cast<double>(number) / steps_of_a_drag)}});
  }

  // Whether a cage came by then.
  bool poll_until(Clock::time_point end) {
    has_cage_ = false;
    while (!has_cage_ && news_.wait_until(end)) workspace_.poll();
    return has_cage_;
  }

  void end_drag() {
    workspace_.clear_preview();
    workspace_.wait_for_cage();
  }

  void take(Clock::time_point now, Figures& figures) {
    if (workspace_.cage().failed)
      ++figures.failures;
    else
      figures.milliseconds.push_back(std::chrono::duration<double, std::milli>(now - workspace_.cage().asked).count());
  }

  Figures answer_every_cage(const SceneSlide& slide, double seconds) {
    Figures figures;
    const Watch watch;
    const auto begin = Clock::now();
    const auto end = begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    for (int number = 1; Clock::now() < end; ++number) {
      step(slide, number);
      if (!poll_until(Clock::now() + std::chrono::seconds(10)))
        throw std::runtime_error("no cage of slide '" + slide.name + "' came within ten seconds");
      take(Clock::now(), figures);
    }
    watch.stop(figures);
    end_drag();
    return figures;
  }

  Figures move_like_a_mouse(const SceneSlide& slide, double seconds) {
    Figures figures;
    const Watch watch;
    const auto begin = Clock::now();
    constexpr std::chrono::milliseconds interval(8);
    const int count = static_cast<int>(1000 * seconds / static_cast<double>(interval.count()));
    for (int number = 1; number <= count; ++number) {
      step(slide, number);
      while (poll_until(begin + number * interval)) take(Clock::now(), figures);
    }
    watch.stop(figures);
    end_drag();
    return figures;
  }

  News news_;
  bool has_cage_ = false;
  Workspace workspace_;
};

}  // namespace
}  // namespace cagewright::host

int main(int argc, char** argv) {
  if (argc < 4 || argc > 5) {
    std::fputs(cagewright::host::usage, stderr);
    return 2;
  }
  const double seconds = argc > 4 ? std::atof(argv[4]) : 20;
  if (!(seconds > 0)) {
    std::fputs(cagewright::host::usage, stderr);
    return 2;
  }
  try {
    cagewright::host::DragBench(argv[1], argv[2], argv[3]).run(seconds);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cagewright_drag_bench: %s\n", error.what());
    return 3;
  }
  return 0;
}
