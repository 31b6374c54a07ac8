#include "base/number.hpp"
#include "version.hpp"

#include <iostream>

int main() { std::cout << "brdfplot " << brdfplot::version << ": " << brdfplot::format_number(0.1) << '\n'; }
