/// \file
/// Texts that are equal where what they tell of is: keys of what is kept.
#pragma once

#include "models/parameters.hpp"

#include <string>

namespace brdfplot {

/// A value with all its digits.
std::string text_of_value(const Value& value);

/// A model: its type, and all values that are given.
std::string text_of_model(const ModelChoice& choice);

} // namespace brdfplot
