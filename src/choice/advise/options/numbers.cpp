#include "choice/advise/options/numbers.hpp"

#include "choice/advise/single.hpp"

#include <algorithm>

namespace brdfplot::choice {

Option SingleNumbers::of() {
  return {"numbers", {{"numbers: single precision (was double)", [](Draft& draft) {
                         if (!std::ranges::all_of(draft.material.terms, has_single_form)) return false;
                         draft.precision = Precision::single;
                         return true;
                       }}}};
}

} // namespace brdfplot::choice
