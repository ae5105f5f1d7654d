// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/tests/slide_file.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace cagewright::testdata {
namespace {

using Json = nlohmann::json;

Eigen::Vector3d vector_of(const Json& numbers) {
  if (!numbers.is_array() || numbers.size() != 3) throw std::runtime_error("a point is not three numbers");
  Eigen::Vector3d vector;
  for (int axis = 0; axis < 3; ++axis) vector[axis] = numbers[static_cast<std::size_t>(axis)].get<double>();
  if (!vector.allFinite()) throw std::runtime_error("a number is not finite");
  return vector;
}

void fit_stroke(const Json& stroke, Slide& slide) {
  if (stroke.size() < 5) throw std::runtime_error("the stroke has fewer than 5 points");
  std::vector<Eigen::Vector3d> points;
  for (const Json& point : stroke) points.push_back(vector_of(point));
  slide.point.setZero();
  for (const Eigen::Vector3d& p : points) slide.point += p / static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) scatter += (p - slide.point) * (p - slide.point).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  if (axes.eigenvalues()[1] < 1e-4 * axes.eigenvalues()[2]) throw std::runtime_error("the stroke runs along a line");
  slide.normal = axes.eigenvectors().col(0);
}

Slide slide_of(const Json& entry) {
  std::set<std::string> keys;
  for (const auto& item : entry.items()) keys.insert(item.key());
  Slide slide{entry.at("name").get<std::string>(), SlideKind::kStroke, {}, {}};
  if (slide.name.empty()) throw std::runtime_error("its name is empty");
  if (keys == std::set<std::string>{"name", "stroke"}) {
    fit_stroke(entry["stroke"], slide);
  } else if (keys == std::set<std::string>{"name", "point", "normal"}) {
    slide.kind = SlideKind::kPointNormal;
    slide.point = vector_of(entry["point"]);
    slide.normal = vector_of(entry["normal"]);
  } else if (keys == std::set<std::string>{"name", "center", "u", "v"}) {
    slide.kind = SlideKind::kEllipse;
    slide.point = vector_of(entry["center"]);
    slide.normal = vector_of(entry["u"]).cross(vector_of(entry["v"]));
  } else {
    throw std::runtime_error("it is neither a stroke, nor a point and a normal, nor a center, u and v");
  }
  if (slide.normal.norm() == 0) throw std::runtime_error("its plane has no normal");
  slide.normal.normalize();
  return slide;
}

}  // namespace

std::vector<Slide> read_slides(const std::filesystem::path& file) {
  const Json document = Json::parse(std::ifstream(file));
  if (document.at("version") != 1) throw std::runtime_error("the version is not 1");
  std::vector<Slide> slides;
  std::set<std::string> names;
  for (const Json& entry : document.at("slides")) {
    try {
      slides.push_back(slide_of(entry));
    } catch (const std::exception& error) {
      throw std::runtime_error("slide " + entry.value("name", "without a name") + ": " + error.what());
    }
    if (!names.insert(slides.back().name).second)
      throw std::runtime_error("slide " + slides.back().name + ": another slide has that name");
  }
  return slides;
}

}  // namespace cagewright::testdata
