/// \file
/// The Python module: materials and figures. What is computed is the library's; here are arrays and errors alone.

#include "analysis/integrals.hpp"
#include "arrays.hpp"
#include "base/errors.hpp"
#include "base/threads/parallel.hpp"
#include "brdf/evaluate.hpp"
#include "config/load.hpp"
#include "draw/model.hpp"
#include "figure/description.hpp"
#include "models/parameters.hpp"
#include "sampling/weights.hpp"
#include "version.hpp"

#include <pybind11/stl.h>

#include <algorithm>

namespace py = pybind11;

namespace brdfplot::python {

namespace {

constexpr std::size_t block = 1024; ///< rows that are columns at a time

Quantity quantity_by(const std::string& name) {
  std::vector<std::string> names;
  for (const QuantityInfo& info : quantities()) {
    if (info.name == name) return info.quantity;
    names.push_back(info.name);
  }
  throw InputError("quantity", unknown_name("quantity", name, names));
}

std::string json_of(const py::object& source) {
  return py::module_::import("json").attr("dumps")(source).cast<std::string>();
}

std::string path_of(const py::object& source) {
  return py::module_::import("os").attr("fspath")(source).cast<std::string>();
}

/// A new array for results of n rows (none: of one, without an axis for it), or `out` when it is of that shape.
py::array_t<double> results(const py::object& out, std::optional<std::size_t> rows, std::size_t channels) {
  std::vector<py::ssize_t> shape;
  if (rows) shape.push_back(static_cast<py::ssize_t>(*rows));
  if (channels > 1) shape.push_back(static_cast<py::ssize_t>(channels));
  if (out.is_none()) return py::array_t<double>(shape);
  if (!py::array_t<double, py::array::c_style>::check_(out))
    throw InputError("out", "accepted: an array of float64 in C order");
  auto array = py::reinterpret_borrow<py::array_t<double>>(out);
  if (!std::equal(shape.begin(), shape.end(), array.shape(), array.shape() + array.ndim()) || !array.writeable())
    throw InputError("out", "accepted: an array of the shape of the result that can be written to");
  return array;
}

Columns columns_of(const std::array<std::vector<double>, 3>& columns) {
  return {columns[0].data(), columns[1].data(), columns[2].data()};
}

/// A material with its methods.
class PyMaterial {
public:
  explicit PyMaterial(const py::object& source)
      : material_(build(py::isinstance<py::dict>(source) ? config::material_from_text(json_of(source), "material")
                                                         : config::load_material(path_of(source)))) {}

  const std::string& name() const { return material_.name; }
  int channels() const { return material_.channels(); }

  py::array_t<double> evaluated(const std::string& name, const std::optional<Array>& wo, const std::optional<Array>& wi,
                                const std::optional<Array>& wm, const std::string& term, const py::object& out) const {
    const Quantity quantity = quantity_by(name);
    require(material_, info_of(quantity), wo.has_value(), wi.has_value(), wm.has_value(), term);
    const auto o = directions(wo, "wo"), i = directions(wi, "wi"), m = directions(wm, "wm");
    std::vector<const Directions*> given;
    for (const auto* one : {&o, &i, &m})
      if (*one) given.push_back(&**one);
    const std::optional<std::size_t> rows = common_rows(given);
    const auto channels = static_cast<std::size_t>(channels_of(material_, quantity, term));
    py::array_t<double> array = results(out, rows, channels);
    double* const to = array.mutable_data();
    const py::gil_scoped_release free_others;
    std::array<std::array<std::vector<double>, 3>, 3> columns;
    std::vector<double> values;
    for (std::size_t first = 0, all = rows.value_or(1); first < all; first += block) {
      const std::size_t n = std::min(block, all - first);
      Batch batch{n, {}, {}, {}};
      if (o) o->read(first, n, columns[0]), batch.o = columns_of(columns[0]);
      if (i) i->read(first, n, columns[1]), batch.i = columns_of(columns[1]);
      if (m) m->read(first, n, columns[2]), batch.m = columns_of(columns[2]);
      values.resize(channels * n);
      evaluate(material_, quantity, used_by(quantity, batch), values.data(), term);
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t c = 0; c < channels; ++c) to[(first + k) * channels + c] = values[c * n + k];
    }
    return array;
  }

  py::array_t<double> integrated(const std::string& name, const Array& wo, double tolerance, const std::string& term,
                                 const py::object& out) const {
    const auto info = std::ranges::find(integrals(), name, &IntegralInfo::name);
    if (info == integrals().end()) {
      std::vector<std::string> names;
      for (const IntegralInfo& one : integrals()) names.push_back(one.name);
      throw InputError("integral", unknown_name("integral", name, names));
    }
    if (!(tolerance > 0)) throw InputError("tolerance", "accepted: a number > 0");
    require(material_, *info, term);
    const Directions o(wo, "wo");
    const std::size_t channels = info->coloured && material_.channels() > 1 ? 3 : 1;
    py::array_t<double> array = results(out, o.rows(), channels);
    double* const to = array.mutable_data();
    const py::gil_scoped_release free_others;
    parallel_for(o.rows().value_or(1), hardware_threads(), [&](std::size_t k) {
      const Rgb values = compute_channels_or_throw(info->integral, material_, o.at(k), tolerance, term);
      std::copy_n(values.begin(), channels, to + k * channels);
    });
    return array;
  }

  py::tuple sampled(const Array& wo, const Array& u, const std::string& strategy) const {
    const Sampler sampler(material_, strategy, "strategy");
    const Directions o(wo, "wo");
    if (u.ndim() != 2 || u.shape(1) != 3) throw InputError("u", "accepted: points in [0, 1)^3 as an array (N, 3)");
    const auto n = static_cast<std::size_t>(u.shape(0)), channels = static_cast<std::size_t>(material_.channels());
    if (o.rows() && *o.rows() != n) throw InputError("wo", "accepted: one direction, or as many as there are points");
    std::vector<SamplePoint> points(n);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t c = 0; c < 3; ++c) {
        points[k][c] = u.data()[3 * k + c];
        if (!(points[k][c] >= 0 && points[k][c] < 1)) throw InputError("u", "accepted: numbers in [0, 1)");
      }
    py::array_t<double> wi = results(py::none(), n, 3), pdf = results(py::none(), n, 1),
                        weight = results(py::none(), n, channels);
    double *const wi_to = wi.mutable_data(), *const pdf_to = pdf.mutable_data(),
                  *const weight_to = weight.mutable_data();
    {
      const py::gil_scoped_release free_others;
      WeightedSamples drawn;
      const std::size_t each = o.rows() ? 1 : block;
      for (std::size_t first = 0; first < n; first += each) {
        const std::size_t count = std::min(each, n - first);
        const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
        draw(material_, sampler, o.at(first), {begin, begin + static_cast<std::ptrdiff_t>(count)}, drawn);
        for (std::size_t k = 0; k < count; ++k) {
          const Direction d = drawn.lights.view()[k];
          std::copy_n(std::array{d.x, d.y, d.z}.begin(), 3, wi_to + 3 * (first + k));
          pdf_to[first + k] = drawn.pdf[k];
          for (std::size_t c = 0; c < channels; ++c)
            weight_to[(first + k) * channels + c] = drawn.weights[c * count + k];
        }
      }
    }
    return py::make_tuple(wi, pdf, weight);
  }

  py::array_t<double> densities(const Array& wo, const Array& wi, const std::string& strategy,
                                const py::object& out) const {
    const Sampler sampler(material_, strategy, "strategy");
    const Directions o(wo, "wo"), i(wi, "wi");
    const std::optional<std::size_t> rows = common_rows({&o, &i});
    py::array_t<double> array = results(out, rows, 1);
    double* const to = array.mutable_data();
    const py::gil_scoped_release free_others;
    std::array<std::vector<double>, 3> of_o, of_i;
    for (std::size_t first = 0, all = rows.value_or(1); first < all; first += block) {
      const std::size_t n = std::min(block, all - first);
      o.read(first, n, of_o);
      i.read(first, n, of_i);
      sampler.densities(n, columns_of(of_o), columns_of(of_i), to + first);
    }
    return array;
  }

private:
  static std::optional<Directions> directions(const std::optional<Array>& array, const std::string& name) {
    return array ? std::optional<Directions>(std::in_place, *array, name) : std::nullopt;
  }

  Material material_;
};

/// A figure, computed when it is made.
class PyFigure {
public:
  explicit PyFigure(const py::object& source) {
    const config::FigureFile file = py::isinstance<py::dict>(source)
                                        ? config::figure_from_text(json_of(source), "figure")
                                        : config::load_figure(path_of(source));
    const py::gil_scoped_release free_others;
    const plot::Figure figure = plot::compute(file.figure);
    svg_ = plot::to_svg(figure);
    csv_ = plot::to_csv(figure);
    caption_ = figure.description;
  }
  const std::string& svg() const { return svg_; }
  const std::string& csv() const { return csv_; }
  const std::string& caption() const { return caption_; }

private:
  std::string svg_, csv_, caption_;
};

/// The library's errors as Python's, with their text.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const FileError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  } catch (const AccuracyError& error) {
    PyErr_SetString(PyExc_ArithmeticError, error.what());
  } catch (const Error& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  }
}

} // namespace

} // namespace brdfplot::python

PYBIND11_MODULE(_core, module) {
  using namespace brdfplot::python;
  py::register_exception_translator(translate);
  module.attr("__version__") = std::string(brdfplot::version);
  py::class_<PyMaterial>(module, "Material")
      .def(py::init<py::object>(), py::arg("source"))
      .def_property_readonly("name", &PyMaterial::name)
      .def_property_readonly("channels", &PyMaterial::channels)
      .def("evaluate", &PyMaterial::evaluated, py::arg("quantity"), py::arg("wo") = py::none(),
           py::arg("wi") = py::none(), py::arg("wm") = py::none(), py::kw_only(), py::arg("term") = "",
           py::arg("out") = py::none())
      .def("integrate", &PyMaterial::integrated, py::arg("quantity"), py::arg("wo"), py::kw_only(),
           py::arg("tolerance") = brdfplot::default_tolerance, py::arg("term") = "", py::arg("out") = py::none())
      .def("sample", &PyMaterial::sampled, py::arg("wo"), py::arg("u"), py::kw_only(), py::arg("strategy") = "default")
      .def("pdf", &PyMaterial::densities, py::arg("wo"), py::arg("wi"), py::kw_only(), py::arg("strategy") = "default",
           py::arg("out") = py::none());
  py::class_<PyFigure>(module, "Figure")
      .def(py::init<py::object>(), py::arg("source"))
      .def_property_readonly("svg", &PyFigure::svg)
      .def_property_readonly("csv", &PyFigure::csv)
      .def_property_readonly("caption", &PyFigure::caption)
      .def("_repr_svg_", &PyFigure::svg);
}
