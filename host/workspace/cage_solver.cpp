// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/cage_solver.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>

#include "host/workspace/solved_cage.h"

namespace cagewright::host {

namespace {

// One processor is left to whoever draws the cage.
unsigned threads_while_editing() { return std::max(2u, std::thread::hardware_concurrency()) - 1; }

}  // namespace

struct CageSolver::State {
  std::shared_ptr<const Plugin> plugin;
  std::function<void()> has_news;

  mutable std::mutex mutex;  // of what follows
  std::condition_variable changed;
  std::optional<SolveRequest> waiting;
  std::optional<SolveResult> result;
  bool is_running = false, runs_for_editing = false, is_waited_for = false, is_ending = false;
  SolveProgress progress;
  std::atomic<bool> is_cancelled = false;  // of what runs

  // Of the thread alone.
  std::unique_ptr<Session> session;
  std::shared_ptr<const TriangleMesh> mesh;  // that the session has
  std::thread thread;

  void tell() const {
    if (has_news) has_news();
  }

  bool goes_on(double fraction, const std::string& stage) {
    constexpr double worth_telling = 0.01, almost_done = 0.999;  // it is done when its cage can be taken
    fraction = std::min(fraction, almost_done);
    bool is_news = false;
    {
      const std::lock_guard lock(mutex);
      is_news = !runs_for_editing && (stage != progress.stage || fraction >= progress.fraction + worth_telling);
      if (is_news) progress = {true, fraction, stage};
    }
    if (is_news) tell();
    return !is_cancelled;
  }

  void set_mesh(const SolveRequest& request) {
    if (!session) {
      SessionListener listener;
      listener.may_continue = [this](double fraction, const std::string& stage) { return goes_on(fraction, stage); };
      session = std::make_unique<Session>(plugin, std::move(listener));
    }
    if (mesh == request.mesh) return;
    mesh.reset();
    session->set_mesh(*request.mesh);
    mesh = request.mesh;
  }

  void set_parameters(const SolveRequest& request) {
    for (const Parameter& parameter : plugin->parameters()) {
      double value = parameter.default_value;
      for (const auto& [id, set] : request.parameters) {
        if (id == parameter.id) value = set;
      }
      session->set_parameter(parameter.id, value);
    }
  }

  void throw_if_cancelled() const {
    if (is_cancelled) throw Cancelled();
  }

  SolveResult solve(const SolveRequest& request) {
    SolveResult made{request.mesh_node, request.revision, false, {}};
    const auto begin = std::chrono::steady_clock::now();
    bool has_slides = false;
    const auto fail = [&](std::vector<Problem> problems) {
      made.state = {};
      made.state.is_of_editing = request.editing;
      made.state.failed = true;
      made.state.problems = std::move(problems);
    };
    try {
      set_mesh(request);
      throw_if_cancelled();
      set_parameters(request);
      std::vector<Slide> slides;
      for (const auto& [id, slide] : request.slides) slides.push_back(slide);
      session->set_slides(slides);
      has_slides = true;
      session->solve(request.editing ? threads_while_editing() : 0, request.editing);
      throw_if_cancelled();
      made.state = read_cage_state(*plugin, *session, request);
      made.state.problems = problems_of(made.state, request);
      made.state.is_of_now = true;
    } catch (const Cancelled&) {
      made.was_cancelled = true;
    } catch (const PluginError& error) {
      fail(problems_of(error, has_slides ? session.get() : nullptr, request));
    } catch (const std::bad_alloc&) {
      fail({{"there is not enough memory for this cage", {}, {}}});
    } catch (const std::exception& error) {
      fail({{std::string("the cage cannot be made: ") + error.what(), {}, {}}});
    }
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    made.state.milliseconds = time.count();
    made.state.asked = request.asked;
    return made;
  }

  // A cage for editing that nobody has taken yet is not overtaken: the processor is the drawing's until then.
  bool may_begin() const {
    return waiting && !(waiting->editing && result && result->state.is_of_editing && !is_waited_for);
  }

  void run() {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [this] { return is_ending || may_begin(); });
      if (is_ending) return;
      const SolveRequest request = std::move(*waiting);
      waiting.reset();
      is_running = true;
      runs_for_editing = request.editing;
      is_cancelled = false;
      progress = {true, 0, ""};
      lock.unlock();
      tell();
      SolveResult made = solve(request);
      lock.lock();
      is_running = false;
      progress = {waiting.has_value(), waiting ? 0.0 : 1.0, ""};
      // A result that nobody has taken yet is more than none.
      if (!made.was_cancelled || !result) result = std::move(made);
      changed.notify_all();
      lock.unlock();
      tell();
      lock.lock();
    }
  }
};

CageSolver::CageSolver(std::shared_ptr<const Plugin> plugin, std::function<void()> has_news)
    : state_(std::make_unique<State>()) {
  state_->plugin = std::move(plugin);
  state_->has_news = std::move(has_news);
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

CageSolver::~CageSolver() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->waiting.reset();
    state_->is_ending = true;
    state_->is_cancelled = true;
  }
  state_->changed.notify_all();
  state_->thread.join();
}

void CageSolver::request(SolveRequest request) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->waiting = std::move(request);
    if (state_->is_running && !state_->runs_for_editing) state_->is_cancelled = true;
    state_->progress.is_solving = true;
    if (!state_->is_running) state_->progress.fraction = 0;
  }
  state_->changed.notify_all();
}

void CageSolver::cancel() {
  const std::lock_guard lock(state_->mutex);
  state_->waiting.reset();
  if (state_->is_running) state_->is_cancelled = true;
  state_->progress.is_solving = state_->is_running;
  state_->changed.notify_all();
}

std::optional<SolveResult> CageSolver::take_result() {
  std::optional<SolveResult> taken;
  {
    const std::lock_guard lock(state_->mutex);
    taken = std::exchange(state_->result, std::nullopt);
  }
  state_->changed.notify_all();
  return taken;
}

SolveProgress CageSolver::progress() const {
  const std::lock_guard lock(state_->mutex);
  SolveProgress progress = state_->progress;
  progress.is_solving = progress.is_solving || state_->result;
  return progress;
}

void CageSolver::wait() {
  std::unique_lock lock(state_->mutex);
  state_->is_waited_for = true;
  state_->changed.notify_all();
  state_->changed.wait(lock, [this] { return !state_->is_running && !state_->waiting; });
  state_->is_waited_for = false;
}

}  // namespace cagewright::host
