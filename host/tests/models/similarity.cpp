// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/models/similarity.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

namespace cagewright::host {
namespace {

using nlohmann::json;

// What std::mt19937_64 gives is fixed by the standard; what its distributions make of it is not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  std::size_t below(std::size_t count) { return engine_() % count; }
  std::vector<std::size_t> order(std::size_t count) {
    std::vector<std::size_t> result(count);
    std::iota(result.begin(), result.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(result[i - 1], result[below(i)]);
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

Eigen::Vector3d vector_of(const json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}
json json_of(const Eigen::Vector3d& v) { return json::array({v.x(), v.y(), v.z()}); }

}  // namespace

Similarity random_similarity(std::uint64_t seed, double length) {
  Random random(seed);
  // Uniform over all rotations (Shoemake).
  const double u = random.between(0, 1), around = random.between(0, 2 * std::numbers::pi),
               about = random.between(0, 2 * std::numbers::pi);
  const Eigen::Quaterniond rotation(std::sqrt(u) * std::cos(about), std::sqrt(1 - u) * std::sin(around),
                                    std::sqrt(1 - u) * std::cos(around), std::sqrt(u) * std::sin(about));
  Similarity motion{rotation.normalized().toRotationMatrix(), std::pow(10, random.between(-3, 3)), Eigen::Vector3d()};
  for (double& x : motion.translation) x = random.between(-2, 2) * length * motion.scale;
  return motion;
}

Surface moved(const Surface& surface, const Similarity& motion) {
  Surface result = surface;
  for (Eigen::Vector3d& point : result.vertices) point = motion.point(point);
  return result;
}

json moved_slides(const json& slides_file, const Similarity& motion) {
  json result = slides_file;
  for (json& slide : result.at("slides")) {
    for (const char* name : {"point", "center"}) {
      if (slide.contains(name)) slide[name] = json_of(motion.point(vector_of(slide[name])));
    }
    for (const char* name : {"u", "v"}) {
      if (slide.contains(name)) slide[name] = json_of(motion.scale * (motion.rotation * vector_of(slide[name])));
    }
    if (slide.contains("normal")) slide["normal"] = json_of(motion.rotation * vector_of(slide["normal"]));
    if (!slide.contains("stroke")) continue;
    for (json& point : slide["stroke"]) point = json_of(motion.point(vector_of(point)));
  }
  return result;
}

Surface shuffled(const Surface& surface, std::uint64_t seed) {
  Random random(seed);
  Surface result;
  std::vector<std::size_t> new_index(surface.vertices.size());
  for (const std::size_t old : random.order(surface.vertices.size())) {
    new_index[old] = result.vertices.size();
    result.vertices.push_back(surface.vertices[old]);
  }
  for (const std::size_t old : random.order(surface.triangles.size())) {
    const std::size_t turn = random.below(3);
    auto& triangle = result.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = new_index[surface.triangles[old][(k + turn) % 3]];
  }
  return result;
}

}  // namespace cagewright::host
