// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plugin/tests/loaded_plugin.h"

namespace {

using namespace cagewright::plugin::test;

std::map<std::string, cgw_parameter> all_parameters() {
  std::map<std::string, cgw_parameter> parameters;
  for (std::uint32_t k = 0; k < api().parameter_count; ++k) {
    cgw_parameter parameter = CGW_PARAMETER_INIT;
    EXPECT_EQ(api().parameter_info(k, &parameter), CGW_OK);
    parameters[parameter.id] = parameter;
  }
  return parameters;
}

double get(const Session& session, const char* id) {
  double value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(api().get_parameter(session, id, &value), CGW_OK) << session.error();
  return value;
}

TEST(AbiParameters, ListWhatTheCommandLineReliesOn) {
  const auto parameters = all_parameters();
  EXPECT_EQ(parameters.size(), api().parameter_count) << "ids are unique";
  EXPECT_EQ(parameters.at("orient.lambda").default_value, 4);
  EXPECT_EQ(parameters.at("refine.delta").default_value, 0);
  EXPECT_STREQ(parameters.at("refine.delta").unit, "diagonal");
  EXPECT_EQ(parameters.at("refine.iterations").default_value, 30);
  EXPECT_EQ(parameters.at("refine.iterations").type, CGW_PARAM_INTEGER);
  EXPECT_EQ(parameters.at("refine.editing_iterations").default_value, 10);
  EXPECT_EQ(parameters.at("refine.in_plane").type, CGW_PARAM_BOOLEAN);
  EXPECT_EQ(parameters.at("refine.damping").type, CGW_PARAM_REAL);
  EXPECT_EQ(parameters.at("refine.push").default_value, 8);
  const cgw_parameter& scope = parameters.at("refine.scope");
  ASSERT_EQ(scope.choice_count, 2u);
  EXPECT_STREQ(scope.choices[0], "local");
  EXPECT_STREQ(scope.choices[1], "part");
  const cgw_parameter& enclose = parameters.at("enclose.mode");
  ASSERT_EQ(enclose.choice_count, 2u);
  EXPECT_STREQ(enclose.choices[0], "off");
  EXPECT_STREQ(enclose.choices[1], "certify");
  EXPECT_EQ(enclose.default_value, 1);
  EXPECT_EQ(parameters.at("enclose.in_plane").default_value, 1);
  EXPECT_EQ(parameters.at("enclose.corner_angle").default_value, 15);
  EXPECT_EQ(parameters.at("enclose.tighten").default_value, 1);
  EXPECT_EQ(parameters.at("enclose.merge").default_value, 1);
}

TEST(AbiParameters, AreInTheReferenceWithTheirDefaults) {
  std::ifstream file(CAGEWRIGHT_ROOT "/docs/c-abi.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  const char* const types[] = {"real", "integer", "boolean", "choice"};
  for (const auto& [id, parameter] : all_parameters()) {
    std::ostringstream row;
    row << "| `" << id << "` | " << types[parameter.type] << " | ";
    if (parameter.type == CGW_PARAM_CHOICE) {
      row << parameter.choices[static_cast<int>(parameter.default_value)];
    } else if (parameter.type == CGW_PARAM_BOOLEAN) {
      row << (parameter.default_value == 0 ? "false" : "true");
    } else {
      row << parameter.default_value;
    }
    row << " |";
    EXPECT_NE(page.find(row.str()), std::string::npos) << "docs/c-abi.md has no row " << row.str();
  }
}

TEST(AbiParameters, DescribeThemselvesCompletely) {
  const Session session;
  for (const auto& [id, parameter] : all_parameters()) {
    EXPECT_GT(std::strlen(parameter.label), 0u) << id;
    EXPECT_GT(std::strlen(parameter.doc), 0u) << id;
    EXPECT_EQ(std::strchr(parameter.doc, '\n'), nullptr) << id;
    EXPECT_NE(parameter.unit, nullptr) << id;
    EXPECT_LE(parameter.minimum, parameter.default_value) << id;
    EXPECT_LE(parameter.default_value, parameter.maximum) << id;
    EXPECT_EQ(parameter.type == CGW_PARAM_CHOICE, parameter.choice_count > 0) << id;
    EXPECT_EQ(get(session, id.c_str()), parameter.default_value) << id;
    EXPECT_EQ(api().set_parameter(session, id.c_str(), parameter.default_value), CGW_OK) << id;
  }
}

TEST(AbiParameters, TakeTheirWholeRangeAndNothingBeyond) {
  const Session session;
  for (const auto& [id, parameter] : all_parameters()) {
    for (const double value : {parameter.minimum, parameter.maximum}) {
      EXPECT_EQ(api().set_parameter(session, id.c_str(), value), CGW_OK) << id;
      EXPECT_EQ(get(session, id.c_str()), value) << id;
    }
    const double kept = get(session, id.c_str());
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {parameter.minimum - 1, parameter.maximum * 2 + 1, infinity, -infinity, std::nan("")}) {
      EXPECT_EQ(api().set_parameter(session, id.c_str(), value), CGW_ERROR_PARAMETER_OUT_OF_RANGE) << id << value;
      EXPECT_NE(session.error().find(id), std::string::npos) << session.error();
      EXPECT_EQ(get(session, id.c_str()), kept) << id;
    }
  }
}

TEST(AbiParameters, WithoutFractionsRefuseThem) {
  const Session session;
  for (const char* id : {"refine.iterations", "refine.in_plane", "refine.scope"}) {
    EXPECT_EQ(api().set_parameter(session, id, 0.5), CGW_ERROR_PARAMETER_OUT_OF_RANGE) << id;
    EXPECT_NE(session.error().find(id), std::string::npos) << session.error();
  }
}

TEST(AbiParameters, ReadTheirText) {
  const Session session;
  const auto set = [&](const char* id, const char* text) { return api().set_parameter_text(session, id, text); };
  EXPECT_EQ(set("refine.delta", "1.5e-2"), CGW_OK);
  EXPECT_EQ(get(session, "refine.delta"), 0.015);
  EXPECT_EQ(set("refine.iterations", "12"), CGW_OK);
  EXPECT_EQ(get(session, "refine.iterations"), 12);
  EXPECT_EQ(set("refine.in_plane", "false"), CGW_OK);
  EXPECT_EQ(get(session, "refine.in_plane"), 0);
  EXPECT_EQ(set("refine.in_plane", "true"), CGW_OK);
  EXPECT_EQ(get(session, "refine.in_plane"), 1);
  EXPECT_EQ(set("refine.scope", "part"), CGW_OK);
  EXPECT_EQ(get(session, "refine.scope"), 1);
  EXPECT_EQ(set("enclose.mode", "off"), CGW_OK);
}

TEST(AbiParameters, RefuseTextThatIsNoValueAndQuoteIt) {
  const Session session;
  for (const auto& [id, text] : std::vector<std::pair<const char*, const char*>>{{"refine.delta", "wide"},
                                                                                 {"refine.delta", ""},
                                                                                 {"refine.delta", "0.1 "},
                                                                                 {"refine.delta", "0,1"},
                                                                                 {"refine.delta", "nan"},
                                                                                 {"refine.delta", "true"},
                                                                                 {"refine.iterations", "3.5"},
                                                                                 {"refine.iterations", "1e999"},
                                                                                 {"refine.in_plane", "2"},
                                                                                 {"refine.scope", "global"}}) {
    EXPECT_EQ(api().set_parameter_text(session, id, text), CGW_ERROR_PARAMETER_OUT_OF_RANGE) << id << " " << text;
    EXPECT_NE(session.error().find(id), std::string::npos) << session.error();
    EXPECT_NE(session.error().find(std::string("'").append(text).append("'")), std::string::npos) << session.error();
  }
  EXPECT_NE(session.error().find("local or part"), std::string::npos) << session.error();
}

TEST(AbiParameters, ThatAreUnknownAreNamedWithThoseThatAreNot) {
  const Session session;
  double value = 0;
  cgw_parameter parameter = CGW_PARAMETER_INIT;
  EXPECT_EQ(api().set_parameter(session, "refine.detla", 0), CGW_ERROR_UNKNOWN_PARAMETER);
  EXPECT_NE(session.error().find("'refine.detla'"), std::string::npos) << session.error();
  EXPECT_NE(session.error().find("refine.delta"), std::string::npos) << session.error();
  EXPECT_EQ(api().set_parameter_text(session, "", "1"), CGW_ERROR_UNKNOWN_PARAMETER);
  EXPECT_EQ(api().get_parameter(session, "lambda", &value), CGW_ERROR_UNKNOWN_PARAMETER);
  EXPECT_EQ(api().parameter_info(api().parameter_count, &parameter), CGW_ERROR_UNKNOWN_PARAMETER);
}

}  // namespace
