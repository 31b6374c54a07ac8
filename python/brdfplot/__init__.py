"""Microfacet BRDFs on NumPy arrays: brdfplot's library.

Directions are arrays (N, 3), or (3,) for one that all rows share; they need not have unit length. Results have a row for
each, and where the material is coloured a last axis of three channels. Mistakes are ValueError, files that cannot be read
OSError, and accuracy that is not reached ArithmeticError, with the text that the command line prints.
"""

from ._core import Figure, __version__
from ._core import Material as _Material

__all__ = ["Figure", "Material", "__version__"]


class Material(_Material):
    """A material: the path of its file, or the same as a dictionary."""

    def brdf(self, wo, wi, *, term="", out=None):
        """The BRDF (1/sr)."""
        return self.evaluate("brdf", wo, wi, term=term, out=out)

    def brdf_cos(self, wo, wi, *, term="", out=None):
        """The BRDF times the cosine of the light."""
        return self.evaluate("brdf_cos", wo, wi, term=term, out=out)

    def g1(self, wo, wm=None, *, term="", out=None):
        """Masking."""
        return self.evaluate("g1", wo, wm=wm, term=term, out=out)

    def g2(self, wo, wi, wm=None, *, term="", out=None):
        """Masking and shadowing."""
        return self.evaluate("g2", wo, wi, wm, term=term, out=out)

    def d(self, wm, *, term="", out=None):
        """The distribution of normals (1/sr)."""
        return self.evaluate("d", wm=wm, term=term, out=out)

    def lambda_(self, wo, *, term="", out=None):
        """Lambda of Smith's masking."""
        return self.evaluate("lambda", wo, term=term, out=out)

    def albedo(self, wo, *, tolerance=1e-9, term="", out=None):
        """The directional albedo, to the tolerance or ArithmeticError."""
        return self.integrate("albedo", wo, tolerance=tolerance, term=term, out=out)
