/// \file
/// What each kind of file may hold.
#pragma once

#include "config/json_file.hpp"
#include "config/schema.hpp"

#include "analysis/properties.hpp"
#include "brdf/material.hpp"

namespace brdfplot::config {

/// A material inside another file, or (`top`) a file of its own.
ShapePtr material_shape(bool top);
ShapePtr figure_shape();
ShapePtr report_shape();
ShapePtr scene_shape();
ShapePtr advice_shape();

/// What a file is, by its keys: "figure", "report", "scene" or "material". \throws InputError when it is no object
std::string kind_of_file(const JsonFile& file);

/// \throws InputError where a file is clearly of another kind: which, and what takes it.
void expect_kind(const JsonFile& file, const std::string& kind);

/// A material at `pointer` of `file`, which has been checked against material_shape. Built once, so that what only
/// building finds (two alternatives at once, shadowing that masking does not allow) is told with its place.
MaterialDescription read_material(const JsonFile& file, const Json& value, const std::string& pointer);

/// A row of a table of properties, as report.json and `check --json` have it.
Json property_row(const PropertyRow& row);

/// A number or an angle with a unit.
double to_number(const Json& value);

} // namespace brdfplot::config
