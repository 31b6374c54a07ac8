#!/usr/bin/env python3
"""The Python module beside the same formula in NumPy: nanoseconds a value, in one run.

    PYTHONPATH=build/python bench/python_module.py
"""

import time

import brdfplot
import numpy as np


def ggx(wo, wi, alpha):
    """The BRDF of GGX with height-correlated masking and shadowing, F = 1."""
    h = wo + wi
    h /= np.linalg.norm(h, axis=1, keepdims=True)
    a2 = alpha * alpha
    d = a2 / (np.pi * (h[:, 2] ** 2 * (a2 - 1) + 1) ** 2)
    co, ci = wo[:, 2], wi[:, 2]
    return d * 0.5 / (co * np.sqrt(a2 + (1 - a2) * ci * ci) + ci * np.sqrt(a2 + (1 - a2) * co * co))


def best(f, times=15):
    took = []
    for _ in range(times):
        start = time.perf_counter()
        f()
        took.append(time.perf_counter() - start)
    return min(took)


def main():
    n = 200_000
    random = np.random.default_rng(1)
    wo, wi = (v / np.linalg.norm(v, axis=1, keepdims=True)
              for v in (np.abs(random.normal(size=(n, 3))), np.abs(random.normal(size=(n, 3)))))
    material = brdfplot.Material({"distribution": {"type": "ggx", "alpha": 0.4}})
    out = np.empty(n)
    module, numpy = best(lambda: material.brdf(wo, wi, out=out)), best(lambda: ggx(wo, wi, 0.4))
    assert np.allclose(out, ggx(wo, wi, 0.4))
    print(f"brdfplot {module / n * 1e9:.1f} ns, NumPy {numpy / n * 1e9:.1f} ns: {numpy / module:.1f} times")


if __name__ == "__main__":
    main()
