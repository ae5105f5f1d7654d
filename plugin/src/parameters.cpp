// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/parameters.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>

#include "plugin/src/barrier.h"

namespace cagewright::plugin {

namespace {

enum Index : std::size_t {
  lambda,
  delta,
  iterations,
  editing_iterations,
  scope,
  in_plane,
  damping,
  push,
  enclose_mode,
  enclose_in_plane,
  enclose_corner_angle,
  enclose_tighten,
  enclose_merge,
  orient_minimum
};

constexpr double default_lambda = PipelineOptions{}.lambda;
constexpr RefineOptions default_refine{};
constexpr EncloseOptions default_enclose{};

constexpr const char* scope_names[] = {"local", "part"};       // in the order of RefineScope
constexpr const char* minimum_names[] = {"linear", "angles"};  // in the order of OrientMinimum
constexpr const char* enclose_names[] = {"off", "certify"};

constexpr cgw_parameter number(std::int32_t type, const char* id, const char* label, const char* doc, const char* unit,
                               double default_value, double minimum, double maximum) {
  return {sizeof(cgw_parameter), type, id, label, doc, unit, default_value, minimum, maximum, nullptr, 0, 0};
}

template <std::size_t n>
constexpr cgw_parameter choice(const char* id, const char* label, const char* doc, const char* const (&names)[n],
                               double default_value) {
  return {sizeof(cgw_parameter), CGW_PARAM_CHOICE, id, label, doc, "", default_value, 0, n - 1, names, n, 0};
}

constexpr std::array<cgw_parameter, Parameters::count> parameters = {
    number(CGW_PARAM_REAL, "orient.lambda", "Alignment",
           "How strongly sections follow their slide's ellipse rather than their neighbours (equation 5)", "",
           default_lambda, 0, 1e9),
    number(CGW_PARAM_REAL, "refine.delta", "Distance",
           "How far the cage stays from the model: kept by enclosing, else aimed at by equation 9", "diagonal",
           default_refine.delta, 0, 1),
    number(CGW_PARAM_INTEGER, "refine.iterations", "Iterations", "Refinement steps at most", "",
           default_refine.iterations, 0, 1000),
    number(CGW_PARAM_INTEGER, "refine.editing_iterations", "Iterations while editing",
           "Refinement steps at most while a slide is being moved", "", 10, 0, 1000),
    choice("refine.scope", "Outermost vertices",
           "Which vertices a cage triangle has to clear: those seen through it (local) or all of its part's (part)",
           scope_names, static_cast<double>(default_refine.scope)),
    number(
        CGW_PARAM_BOOLEAN, "refine.in_plane", "Sections in plane",
        "Keep the corners of every section in the plane of its slide while refining, as enclose.in_plane does anyway",
        "", default_refine.in_plane ? 1 : 0, 0, 1),
    number(CGW_PARAM_REAL, "refine.damping", "Damping",
           "Share of the trace of equation (8) that holds cage vertices back; more is slower and safer", "",
           default_refine.damping, 1e-9, 1),  // without any, equation (8) has no unique solution
    number(CGW_PARAM_REAL, "refine.push", "Push",
           "Weight in equation (8) of triangles that still have to move over those that bound; 1 is the paper", "",
           default_refine.push, 1, 1e6),
    choice("enclose.mode", "Certificate",
           "Move the cage until it provably encloses the model (certify), or leave it as the paper's refinement does "
           "(off)",
           enclose_names, 1),
    number(
        CGW_PARAM_BOOLEAN, "enclose.in_plane", "Sections in plane",
        "Keep the corners of every section in the plane of its slide, and its angles near right ones, while enclosing",
        "", default_enclose.in_plane ? 1 : 0, 0, 1),
    number(CGW_PARAM_REAL, "enclose.corner_angle", "Corner angle",
           "How far the angles of sections that stay in plane may be from right ones", "degree",
           default_enclose.corner_angle, 0, 60),
    number(CGW_PARAM_BOOLEAN, "enclose.tighten", "Tighten",
           "Take volume off the enclosing cage again while its certificate holds", "", default_enclose.tighten ? 1 : 0,
           0, 1),
    number(CGW_PARAM_BOOLEAN, "enclose.merge", "Merge limbs",
           "Merge limbs whose cages run into each other, where nothing else encloses the model", "",
           default_enclose.merge ? 1 : 0, 0, 1),
    choice("orient.minimum", "Minimum",
           "Of equation (1): that of the linear solve, as in the paper (linear), or over the angles of the sections "
           "(angles)",
           minimum_names, static_cast<double>(PipelineOptions{}.orient_minimum)),
};

std::string to_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string quoted(std::string_view text) { return std::string("'").append(text).append("'"); }

std::string choices_of(const cgw_parameter& parameter) {
  std::string names;
  for (std::uint32_t k = 0; k < parameter.choice_count; ++k) {
    if (k > 0) names += k + 1 == parameter.choice_count ? " or " : ", ";
    names += parameter.choices[k];
  }
  return names;
}

// What a value has to be, as sentences say it.
std::string range_of(const cgw_parameter& parameter) {
  const std::string range = " from " + to_text(parameter.minimum) + " to " + to_text(parameter.maximum);
  switch (parameter.type) {
    case CGW_PARAM_BOOLEAN:
      return "true or false";
    case CGW_PARAM_CHOICE:
      return choices_of(parameter);
    case CGW_PARAM_INTEGER:
      return "a whole number" + range;
    default:
      return "a number" + range;
  }
}

[[noreturn]] void refuse(const cgw_parameter& parameter, const std::string& given) {
  throw AbiError(CGW_ERROR_PARAMETER_OUT_OF_RANGE, "parameter '" + std::string(parameter.id) + "': " + given +
                                                       " will not do; it has to be " + range_of(parameter));
}

std::size_t index_of(std::string_view id) {
  std::string known;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    if (id == parameters[k].id) return k;
    known += (k > 0 ? ", " : "") + std::string(parameters[k].id);
  }
  throw AbiError(CGW_ERROR_UNKNOWN_PARAMETER,
                 "there is no parameter '" + std::string(id) + "'; those of this plug-in are " + known);
}

void check(std::size_t index, double value, const std::string& given) {
  const cgw_parameter& parameter = parameters[index];
  if (!(value >= parameter.minimum && value <= parameter.maximum)) refuse(parameter, given);
  if (parameter.type != CGW_PARAM_REAL && value != std::floor(value)) refuse(parameter, given);
}

double parse(const cgw_parameter& parameter, std::string_view text) {
  for (std::uint32_t k = 0; k < parameter.choice_count; ++k) {
    if (text == parameter.choices[k]) return k;
  }
  if (parameter.type == CGW_PARAM_BOOLEAN && text == "true") return 1;
  if (parameter.type == CGW_PARAM_BOOLEAN && text == "false") return 0;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) refuse(parameter, quoted(text));
  return value;
}

}  // namespace

std::span<const cgw_parameter, Parameters::count> Parameters::list() noexcept { return parameters; }

Parameters::Parameters() noexcept {
  for (std::size_t k = 0; k < count; ++k) values_[k] = parameters[k].default_value;
}

void Parameters::set(std::string_view id, double value) {
  const std::size_t index = index_of(id);
  check(index, value, to_text(value));
  values_[index] = value;
}

void Parameters::set_text(std::string_view id, std::string_view text) {
  const std::size_t index = index_of(id);
  const double value = parse(parameters[index], text);
  check(index, value, quoted(text));
  values_[index] = value;
}

double Parameters::get(std::string_view id) const { return values_[index_of(id)]; }

PipelineOptions Parameters::options(bool editing) const {
  PipelineOptions options;
  options.lambda = values_[lambda];
  options.orient_minimum = static_cast<OrientMinimum>(values_[orient_minimum]);
  options.refine.delta = values_[delta];
  options.refine.iterations = static_cast<int>(values_[editing ? editing_iterations : iterations]);
  options.refine.scope = static_cast<RefineScope>(static_cast<int>(values_[scope]));
  options.refine.in_plane = values_[in_plane] != 0;
  options.refine.damping = values_[damping];
  options.refine.push = values_[push];
  options.certify = values_[enclose_mode] != 0;
  options.enclose.delta = values_[delta];
  options.enclose.in_plane = values_[enclose_in_plane] != 0;
  options.enclose.corner_angle = values_[enclose_corner_angle];
  options.enclose.tighten = values_[enclose_tighten] != 0;
  options.enclose.merge = values_[enclose_merge] != 0;
  return options;
}

}  // namespace cagewright::plugin
