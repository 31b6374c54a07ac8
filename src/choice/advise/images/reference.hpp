/// \file
/// Materials in full with the pictures that models are held against.
#pragma once

#include "choice/advise/images/render.hpp"

#include <memory>
#include <vector>

namespace brdfplot::choice {

/// How the picture of a model is made.
struct Drawing {
  LightModel light;
  Precision precision = Precision::full;
};

/// A variant with the picture that it has in full, in double.
struct Reference {
  MaterialDescription material;
  std::unique_ptr<Renderer> renderer;
  Picture picture;
  std::size_t rings = 0;

  /// At places of this fineness (places.hpp), with so many rings for each disc, or, for 0, as many as it needs.
  Reference(const MaterialDescription& of, const AdviceScene& scene, double scale, std::size_t with_rings, int threads);

  PictureErrors errors(const MaterialDescription& other, const Drawing& how, const AdviceScene& scene,
                       bool remember) const;
};

/// Of the variant that is farthest off.
PictureErrors largest_errors(const std::vector<Reference>& references,
                             const std::vector<MaterialDescription>& materials, const Drawing& how,
                             const AdviceScene& scene, bool remember = false);

} // namespace brdfplot::choice
