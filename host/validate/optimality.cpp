// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/optimality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <set>

#include "host/plugin_client/plugin_error.h"
#include "host/validate/tighter_step.h"

namespace cagewright::host {
namespace {

// Over the diagonal.
constexpr double margin = 2e-6;       // kept from everything, as the plug-in does
constexpr double on_plane = 1e-6;     // corners so near to it are in their slide's plane
constexpr double first_step = 0.005;  // of a vertex whose share in the volume's gradient is the mean one
constexpr double longest_step = 0.02;
constexpr double least_reach = 0.005;  // model and cage so near to each other are watched
constexpr double least_gain = 1e-4;    // of the volume, in so many rounds; less: settled
constexpr std::size_t rounds_of_gain = 8;
constexpr int retries = 3;   // with what a step ran into as new contacts
constexpr int halvings = 4;  // of a step that is not certified

class Tightening {
 public:
  Tightening(const Plugin& plugin, const ObservedCage& seen, const TriangleMesh& model, std::uint32_t threads)
      : plugin_(plugin), model_(model), threads_(threads), scale_(seen.diagonal), origin_(seen.model.front()) {
    for (const Eigen::Vector3d& v : to_points(model.points)) points_.push_back((v - origin_) / scale_);
    for (const Eigen::Vector3d& v : seen.vertices) start_.push_back((v - origin_) / scale_);
    problem_.triangles = seen.triangles;
    problem_.plane_normals.assign(seen.vertices.size(), Eigen::Vector3d::Zero());
    problem_.margin = margin;
    for (const Corners& t : seen.triangles) cage_.triangles.insert(cage_.triangles.end(), t.begin(), t.end());
  }

  // Sections that are in their slides' planes stay there, and in shape.
  void keep_shape(const ObservedCage& seen) {
    for (std::size_t k = 0; k < seen.sections.size(); ++k) {
      const ObservedSection& section = seen.sections[k];
      bool is_in_plane = true;
      for (std::size_t i = 0; i < 4; ++i) {
        const double off = (seen.vertices[4 * k + i] - section.center).dot(section.normal) / scale_;
        is_in_plane = is_in_plane && std::abs(off) <= on_plane;
      }
      if (!is_in_plane) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        problem_.plane_normals[4 * k + i] = section.normal;
        add_corner(seen, static_cast<int>(4 * k + i), static_cast<int>(4 * k + (i + 3) % 4),
                   static_cast<int>(4 * k + (i + 1) % 4));
      }
    }
  }

  TighterCage run(double seconds, double model_volume, const std::function<bool(double)>& goes_on) {
    const auto began = std::chrono::steady_clock::now();
    const auto elapsed = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    };
    PointList best = start_;
    std::vector<double> volumes = {volume_of(best, problem_.triangles)};
    TighterCage found;
    step_ = first_step;
    while (elapsed() < seconds && !found.settled) {
      if (!goes_on(std::min(1.0, elapsed() / seconds))) throw Cancelled();
      found.certified += round(best) ? 1 : 0;
      ++found.rounds;
      volumes.push_back(volume_of(best, problem_.triangles));
      const std::size_t before = volumes.size() > rounds_of_gain ? volumes.size() - 1 - rounds_of_gain : 0;
      found.settled = before > 0 && volumes.back() > (1 - least_gain) * volumes[before];
    }
    found.seconds = elapsed();
    found.volume_ratio = volumes.back() * scale_ * scale_ * scale_ / model_volume;
    found.gap = volumes.front() / volumes.back() - 1;
    found.vertices = in_model_units(best);
    return found;
  }

 private:
  void add_corner(const ObservedCage& seen, int at, int before, int after) {
    const auto point = [&](int i) { return seen.vertices[static_cast<std::size_t>(i)]; };
    const double now = (point(before) - point(at)).normalized().dot((point(after) - point(at)).normalized());
    const double asked = std::sin(seen.corner_angle * std::numbers::pi / 180);
    problem_.corners.push_back({at, before, after, std::max(std::abs(now), asked)});
  }

  std::vector<double> in_model_units(const PointList& vertices) const {
    std::vector<double> rows;
    for (const Eigen::Vector3d& v : vertices) {
      const Eigen::Vector3d p = origin_ + scale_ * v;
      rows.insert(rows.end(), p.begin(), p.end());
    }
    return rows;
  }

  Certificate certify(const PointList& vertices) {
    cage_.points = in_model_units(vertices);
    return plugin_.evaluate(model_, cage_, threads_).certificate;
  }

  // The weight of squared steps under which a vertex of mean gradient goes as far as step_.
  double restraint(const PointList& from) const {
    PointList gradient(from.size(), Eigen::Vector3d::Zero());
    for (const Corners& t : problem_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d &b = from[static_cast<std::size_t>(t[(i + 1) % 3])],
                              &c = from[static_cast<std::size_t>(t[(i + 2) % 3])];
        gradient[static_cast<std::size_t>(t[i])] += b.cross(c) / 6;
      }
    }
    double mean = 0;
    for (const Eigen::Vector3d& g : gradient) mean += g.norm() / static_cast<double>(from.size());
    return mean / volume_of(from, problem_.triangles) / step_;
  }

  // What steps ran into stays a contact in later rounds.
  void remember_hits(const Certificate& certificate) {
    const auto add = [](auto& hits, const auto& pairs) { hits.insert(pairs.begin(), pairs.end()); };
    add(model_hits_, certificate.model_cage_intersections);
    add(own_hits_, certificate.self_intersections);
  }

  Contacts contacts_of(const PointList& from) const {
    Contacts contacts = find_contacts(points_, from, problem_.triangles, std::max(3 * step_, least_reach));
    for (const auto& [model_triangle, cage_triangle] : model_hits_) {
      std::array<Eigen::Vector3d, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = points_[model_.triangles[3 * model_triangle + i]];
      keep_apart(corners, from, problem_.triangles[cage_triangle], contacts);
    }
    for (const auto& [first, second] : own_hits_)
      keep_apart(from, problem_.triangles[first], problem_.triangles[second], contacts);
    return contacts;
  }

  static PointList between(const PointList& from, const PointList& to, double share) {
    PointList points;
    for (std::size_t j = 0; j < from.size(); ++j) points.push_back(from[j] + share * (to[j] - from[j]));
    return points;
  }

  // One step from `best`, which is certified, to one that is, too, and has less volume. False where there is none.
  bool round(PointList& best) {
    const double volume = volume_of(best, problem_.triangles);
    PointList next;
    for (int attempt = 0; attempt <= retries; ++attempt) {
      next = tighter_step(problem_, best, contacts_of(best), restraint(best));
      const Certificate certificate = certify(next);
      if (certificate.encloses && volume_of(next, problem_.triangles) < volume) {
        best = next;
        step_ = attempt == 0 ? std::min(1.5 * step_, longest_step) : step_;
        return true;
      }
      remember_hits(certificate);
    }
    double share = 1;
    for (int i = 0; i < halvings; ++i) {
      share /= 2;
      const PointList part = between(best, next, share);
      if (volume_of(part, problem_.triangles) >= volume || !certify(part).encloses) continue;
      best = part;
      step_ /= 1.5;
      return true;
    }
    step_ /= 3;
    return false;
  }

  const Plugin& plugin_;
  const TriangleMesh& model_;
  std::uint32_t threads_;
  double scale_;
  Eigen::Vector3d origin_;
  PointList points_, start_;  // of the model and of the cage, over the diagonal
  TighterProblem problem_;
  TriangleMesh cage_;
  double step_ = first_step;
  std::set<std::array<std::uint32_t, 2>> model_hits_, own_hits_;  // model and cage triangle; cage triangles
};

}  // namespace

Optimality find_optimality(const Plugin& plugin, const ObservedCage& seen, const TriangleMesh& model, double seconds,
                           std::uint32_t threads, const std::function<bool(double)>& goes_on) {
  const double model_volume = volume_of(seen.model, seen.model_triangles);
  Optimality optimality;
  optimality.volume_ratio = volume_of(seen.vertices, seen.triangles) / model_volume;
  Tightening shaped(plugin, seen, model, threads);
  shaped.keep_shape(seen);
  optimality.shaped = shaped.run(seconds / 2, model_volume, [&](double share) { return goes_on(share / 2); });
  Tightening free(plugin, seen, model, threads);
  optimality.free = free.run(seconds / 2, model_volume, [&](double share) { return goes_on(0.5 + share / 2); });
  return optimality;
}

}  // namespace cagewright::host
