"""The module against the command line, and against formulas in NumPy."""

import csv
import io
import json
import os
import subprocess
from pathlib import Path

import brdfplot
import numpy as np
import pytest

GGX = {"distribution": {"type": "ggx", "alpha": 0.4}}
GOLD = {"distribution": {"type": "ggx", "alpha_x": 0.2, "alpha_y": 0.5},
        "fresnel": {"type": "schlick", "f0": [1, 0.71, 0.29]}}


def directions(n, seed):
    v = np.random.default_rng(seed).normal(size=(n, 3))
    v[:, 2] = np.abs(v[:, 2])
    return v / np.linalg.norm(v, axis=1, keepdims=True)


def of_command(tmp_path, material, quantity, wo, wi=None):
    """What `brdfplot eval` prints of the same rows."""
    (tmp_path / "m.json").write_text(json.dumps(material))
    columns = {"x_o": wo[:, 0], "y_o": wo[:, 1], "z_o": wo[:, 2]}
    if wi is not None:
        columns |= {"x_i": wi[:, 0], "y_i": wi[:, 1], "z_i": wi[:, 2]}
    rows = [",".join(columns)] + [",".join(repr(float(x)) for x in row) for row in zip(*columns.values())]
    done = subprocess.run([os.environ["BRDFPLOT"], "eval", tmp_path / "m.json", "-q", quantity],
                          input="\n".join(rows) + "\n", capture_output=True, text=True, check=True)
    table = list(csv.reader(io.StringIO(done.stdout)))
    return np.array([[float(x) for x in row[len(columns):]] for row in table[1:]])


def test_brdf_is_what_the_command_line_prints(tmp_path):
    wo, wi = directions(2500, 1), directions(2500, 2)
    np.testing.assert_allclose(brdfplot.Material(GOLD).brdf(wo, wi), of_command(tmp_path, GOLD, "brdf", wo, wi), rtol=1e-14)
    np.testing.assert_allclose(brdfplot.Material(GGX).brdf(wo, wi),
                               of_command(tmp_path, GGX, "brdf", wo, wi)[:, 0], rtol=1e-14)


def test_albedo_is_what_the_command_line_prints(tmp_path):
    wo = directions(7, 3)
    np.testing.assert_allclose(brdfplot.Material(GOLD).albedo(wo), of_command(tmp_path, GOLD, "albedo", wo), atol=1e-9)


def test_ggx_is_ggx():
    wm = directions(100, 4)
    a2, cos2 = 0.16, wm[:, 2] ** 2
    np.testing.assert_allclose(brdfplot.Material(GGX).d(wm), a2 / (np.pi * (cos2 * (a2 - 1) + 1) ** 2), rtol=1e-12)
    lam = brdfplot.Material(GGX).lambda_(wm)
    np.testing.assert_allclose(brdfplot.Material(GGX).g1(wm), 1 / (1 + lam), rtol=1e-14)


def test_shapes():
    material, gold = brdfplot.Material(GGX), brdfplot.Material(GOLD)
    wo, wi = directions(5, 5), directions(5, 6)
    assert material.channels == 1 and gold.channels == 3
    assert material.brdf(wo, wi).shape == (5,)
    assert gold.brdf(wo, wi).shape == (5, 3)
    assert material.brdf(wo[0], wi).shape == (5,)
    assert gold.brdf(wo[0], wi[0]).shape == (3,)
    assert material.brdf([0, 0, 2], (1, 0, 1)).shape == ()  # lists, of any length
    assert material.brdf([0, 0, 2], (1, 0, 1)) == material.brdf([0, 0, 1], np.array([1, 0, 1]) / np.sqrt(2))
    np.testing.assert_array_equal(gold.brdf(wo.astype(np.float32), wi), gold.brdf(wo.astype(np.float32).astype(float), wi))
    np.testing.assert_array_equal(material.brdf(wo[::-1], wi[::-1]), material.brdf(wo, wi)[::-1])
    assert material.brdf(np.empty((0, 3)), np.empty((0, 3))).shape == (0,)


def test_out_is_written_to():
    material, wo, wi = brdfplot.Material(GGX), directions(5, 7), directions(5, 8)
    out = np.zeros(5)
    assert material.brdf(wo, wi, out=out) is out
    np.testing.assert_array_equal(out, material.brdf(wo, wi))
    for wrong in (np.zeros(4), np.zeros(5, dtype=np.float32), np.zeros(10)[::2], [0] * 5):
        with pytest.raises(ValueError):
            material.brdf(wo, wi, out=wrong)


@pytest.mark.parametrize("strategy", ["default", "cosine"])
def test_samples_have_their_density_and_weight(strategy):
    material = brdfplot.Material(GOLD)
    u = np.random.default_rng(9).random((3000, 3))
    wo = np.array([0.6, 0, 0.8])
    wi, pdf, weight = material.sample(wo, u, strategy=strategy)
    assert wi.shape == (3000, 3) and pdf.shape == (3000,) and weight.shape == (3000, 3)
    np.testing.assert_allclose(material.pdf(wo, wi, strategy=strategy), pdf, rtol=1e-8)
    above = (wi[:, 2] > 0) & (pdf > 0)
    np.testing.assert_allclose(weight[above], material.brdf_cos(wo, wi[above]) / pdf[above, None], rtol=1e-8)
    error = weight.std(axis=0) / np.sqrt(len(weight))
    assert (np.abs(weight.mean(axis=0) - material.albedo(wo)) < 4 * error).all()
    # A viewer for each point.
    many, _, _ = material.sample(np.tile(wo, (10, 1)), u[:10], strategy=strategy)
    np.testing.assert_allclose(many, wi[:10], atol=1e-12)


def test_mistakes_are_value_errors_with_the_library_text(tmp_path):
    material = brdfplot.Material(GGX)
    up = [0.0, 0, 1]
    for call, text in ((lambda: brdfplot.Material({"distribution": {"type": "ggx", "alpha": -1}}), "alpha"),
                       (lambda: brdfplot.Material({"distribution": {"type": "gxg", "alpha": 1}}), 'did you mean "ggx"'),
                       (lambda: material.evaluate("fnord", up), "unknown quantity"),
                       (lambda: material.evaluate("brdf", up), "theta_i"),
                       (lambda: material.brdf([0.0, 0, 0], up), "row 0"),
                       (lambda: material.brdf(np.zeros((2, 2)), up), r"\(2, 2\)"),
                       (lambda: material.brdf(np.ones((2, 3)), np.ones((3, 3))), "2 and 3"),
                       (lambda: material.sample(up, [[0, 0, 1.0]]), r"\[0, 1\)"),
                       (lambda: material.sample(up, [[0, 0, 0.5]], strategy="eon"), "strategy"),
                       (lambda: material.albedo(up, tolerance=0), "tolerance")):
        with pytest.raises(ValueError, match=text):
            call()
    with pytest.raises(OSError, match="missing.json"):
        brdfplot.Material(tmp_path / "missing.json")


def test_figures_are_shown_by_notebooks():
    figure = brdfplot.Figure({"id": "f", "kind": "lines", "title": "G1", "caption": "c",
                              "x": {"variable": "theta_o", "from": 0, "to": "89deg"}, "y": {"label": "G_1"},
                              "panels": [{"series": [{"label": "GGX", "quantity": "g1", "material": GGX}]}]})
    assert figure._repr_svg_().startswith("<svg")
    assert figure.csv.count("\n") > 20
    with pytest.raises(ValueError, match="kind"):
        brdfplot.Figure({"id": "f", "kind": "fnord"})


def test_the_example_notebook_runs():
    """Its cells, one after the other, without a notebook."""
    notebook = json.loads((Path(__file__).parents[2] / "docs" / "example.ipynb").read_text(encoding="utf-8"))
    scope = {}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            exec("".join(cell["source"]), scope)
    assert abs(1 - scope["weight"].mean() - (1 - scope["ggx"].albedo(scope["wo"][2]))) < 0.01
