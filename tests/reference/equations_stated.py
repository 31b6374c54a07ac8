"""The texts of the table of equations, and what is said of the numbers that no model names as its source."""

# How `brdfplot list` names a text, its heading on the page, and the numbers that it has.
TEXTS = {
    "Heitz 2014": (("Heitz 2014",), "Heitz 2014", range(1, 132)),
    "Kelemen and Szirmay-Kalos 2001": (("Kelemen and Szirmay-Kalos 2001",), "Kelemen and Szirmay-Kalos 2001",
                                       range(1, 10)),
    "Akenine-Moller et al. 2018": (("Akenine-Moller et al. 2018", "RTR4"),
                                   "Real-Time Rendering, 4th edition, sections 9.6 to 9.13 (Akenine-Möller et al. 2018)",
                                   range(21, 77)),
}

NONE = "–"

# (first, last, what it is, where what it says is computed or tested; a dash: nowhere, it defines or derives)
STATED = {
    "Heitz 2014": [
        (1, 1, "radiance of a patch as a mean over projected areas", f"{NONE} defines; of facets it is 17"),
        (2, 2, "distribution of normals as a density of area", "quantity `d`"),
        (3, 6, "integrals over the microsurface as integrals over normals", f"{NONE} property of 2"),
        (7, 8, "statistical functions of a spatial one", f"{NONE} define"),
        (10, 10, "projected area of the geometric surface, cos θ_o", f"{NONE} the left side of 14"),
        (15, 15, "radiance of the patch as an integral over what is visible", f"{NONE} a step towards 17"),
        (17, 17, "the same with visible normals as its weight", "quantity `mean_fresnel`, where the radiance is F"),
        (19, 19, "the weight integrates to one", "property `eq18`"),
        (20, 25, "from the light on a facet to the BRDF", f"{NONE} steps towards 26"),
        (32, 33, "BSDF: with what is transmitted", f"{NONE} nothing is transmitted here; without it 33 is 34"),
        (44, 48, "the two facets of a V-cavity", f"{NONE} steps towards 49, masking `v_cavity`"),
        (50, 54, "what a V-cavity shows of its facets", f"{NONE} consequences of 49, masking `v_cavity`"),
        (61, 62, "slope of a normal, normal of a slope", f"{NONE} between quantity `p22` and quantity `d`"),
        (63, 63, "slopes are normalised", "property `normalized`, as 9"),
        (64, 64, "D from the density of slopes", "quantity `d`"),
        (65, 66, "shapes that alpha stretches", "distribution `custom`, alpha"),
        (74, 79, "what stretching a surface does to roughness and direction (74 is misprinted)",
         f"{NONE} steps towards 80; property `stretch_invariance`"),
        (89, 93, "norm of a slope and projected roughness with correlation (92 is misprinted)",
         f"{NONE} steps from the correlation of 88; figure variable `a`"),
        (95, 97, "the same with a mean slope", f"{NONE} steps from the mean slope of 94; figure variable `a`"),
        (102, 104, "single and multiple scattering add to one", "measure `bounces`; series `smith_walk`; property `energy`"),
        (106, 124, "appendix A: Λ as an integral over slopes", f"{NONE} derive 43; Λ of distribution `custom` is that integral"),
        (125, 131, "appendix B: masking at a height, and the height-correlated form",
         "series `smith_walk`; shadowing `height_correlated`"),
    ],
    "Kelemen and Szirmay-Kalos 2001": [
        (8, 9, "appendix: densities of half vector and of reflected direction, 1 / (4 cos β)",
         f"{NONE} in quantity `pdf`, strategy half vectors"),
    ],
    "Akenine-Moller et al. 2018": [
        (33, 33, "half vector", "figure variable `theta_h`"),
        (43, 43, "GGX with height-correlated masking in one fraction",
         "distribution `ggx` with shadowing `height_correlated`, written so"),
        (48, 48, "frame of a normal map", f"{NONE} of a mesh, which this has not"),
    ],
}
