#include "config/shapes.hpp"

namespace brdfplot::config {

std::string kind_of_file(const JsonFile& file) {
  const Json& root = file.root();
  if (!root.is_object()) file.fail("", "found " + show(root) + ", accepted: an object");
  if (root.contains("panels") || root.contains("kind")) return "figure";
  if (root.contains("entries")) return "report";
  if (root.contains("surface") || root.contains("measures")) return "scene";
  if (root.contains("materials")) return "advice";
  return "material";
}

namespace {

std::string with_article(const std::string& kind) {
  return kind == "advice" ? "a scene with materials and lights" : "a " + kind;
}

} // namespace

void expect_kind(const JsonFile& file, const std::string& kind) {
  const std::string found = kind_of_file(file);
  const Json& root = file.root();
  // A file without a key that tells is of the kind that is wanted.
  if (found == kind || (found == "material" && !root.contains("distribution") && !root.contains("terms"))) return;
  const std::string takes = found == "figure"   ? "plot"
                            : found == "report" ? "report"
                            : found == "scene"  ? "simulate"
                            : found == "advice" ? "advise"
                                                : "eval, plot -q, check, fit, sample";
  file.fail("", "found " + with_article(found) + " (brdfplot " + takes + "), accepted: " + with_article(kind));
}

} // namespace brdfplot::config
