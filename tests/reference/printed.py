"""Equations of Kelemen and Szirmay-Kalos (2001) and of Real-Time Rendering, chapter 9, as they are printed, in mpmath.

Nothing is rewritten: the precision absorbs what cancels. What the print gets wrong is said where it is put right. A
case is a material and a quantity with its value as a function of the directions, for the equations that it is of;
printed_equations.py writes them to printed_equations.csv and holds brdfplot to them.
"""

from itertools import product

from mpmath import acos, cos, erf, exp, inf, log, mp, mpf, pi, quad, sin, sqrt, tan

mp.dps = 50

KELEMEN, RTR = "Kelemen and Szirmay-Kalos 2001", "Real-Time Rendering"

# Directions are angles in radians, in doubles: the polar angle and the azimuth.
VIEWERS = [(0.0, 0.0), (0.4, 0.3), (1.1, 2.0), (1.5, -1.0), (1.57, 0.5)]
PAIRS = [((0.0, 0.0), (0.7, 0.4)), ((0.4, 0.3), (0.4, 0.3)), ((0.4, 0.3), (1.1, 2.0)), ((1.3, 0.2), (1.25, 3.2)),
         ((1.5, -1.0), (0.3, 1.0)), ((1.57, 0.5), (1.55, 1.5))]
NORMALS = [(0.0, 0.0), (0.05, 0.4), (0.5, 2.2), (1.2, -0.7), (1.56, 0.1)]


class Vector(tuple):
    def __matmul__(self, other):
        return sum(u * v for u, v in zip(self, other))

    def __add__(self, other):
        return Vector(u + v for u, v in zip(self, other))

    def normalised(self):
        length = sqrt(self @ self)
        return Vector(u / length for u in self)


def direction(angles):
    theta, phi = map(mpf, angles)
    return Vector((sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)))


def half(l, v):
    """9.33"""
    return (l + v).normalised()


def mirrored(l, v, f, g2, d):
    """9.34, of F(h.l), G2 / (4 |n.l| |n.v|) or G2, and D(h)."""
    return f * g2 * d / (4 * abs(l[2]) * abs(v[2]))


# Distributions, of the normal m.


def d_beckmann(m, a):
    """9.35"""
    c = m[2]
    return exp((c**2 - 1) / (a**2 * c**2)) / (pi * a**2 * c**4)


def d_shape(m, a, g):
    """9.36 and 9.49"""
    c = m[2]
    return g(sqrt(1 - c**2) / (a * c)) / (a**2 * c**4)


def d_phong(m, power):
    """9.40"""
    return (power + 2) / (2 * pi) * m[2]**power


def d_ggx(m, a):
    """9.41"""
    return a**2 / (pi * (1 + m[2]**2 * (a**2 - 1))**2)


def d_gtr(m, a, gamma):
    """9.46 and 9.47"""
    if a == 1:
        k = mpf(1)
    elif gamma == 1:
        k = (a**2 - 1) / log(a**2)
    else:
        k = (gamma - 1) * (a**2 - 1) / (1 - (a**2)**(1 - gamma))
    return k / (pi * (1 + m[2]**2 * (a**2 - 1))**gamma)


def d_anisotropic_shape(m, ax, ay, g):
    """9.50"""
    return g(sqrt(m[0]**2 / ax**2 + m[1]**2 / ay**2) / m[2]) / (ax * ay * m[2]**4)


def d_anisotropic_beckmann(m, ax, ay):
    """9.52"""
    return exp(-(m[0]**2 / ax**2 + m[1]**2 / ay**2) / m[2]**2) / (pi * ax * ay * m[2]**4)


def d_anisotropic_ggx(m, ax, ay):
    """9.53"""
    return 1 / (pi * ax * ay * (m[0]**2 / ax**2 + m[1]**2 / ay**2 + m[2]**2)**2)


def d_velvet(m, a, amplitude):
    """9.73. The print in the project's source has a minus too many: D is finite at the normal."""
    c2 = m[2]**2
    bump = exp(-c2 / (a**2 * (1 - c2))) / (1 - c2)**2 if c2 < 1 else mpf(0)
    return (1 + amplitude * bump) / (pi * (1 + amplitude * a**2))


def d_sheen(m, a):
    """9.75"""
    return (2 + 1 / a) * (1 - m[2]**2)**(1 / (2 * a)) / (2 * pi)


# Masking.


def a_of(s, alpha):
    """9.37; at the normal Lambda is 0."""
    return s[2] / (alpha * sqrt(1 - s[2]**2)) if s[2] < 1 else inf


def a_anisotropic(s, ax, ay):
    """9.51"""
    width = sqrt(ax**2 * s[0]**2 + ay**2 * s[1]**2)
    return s[2] / width if width else inf


def lambda_beckmann(a):
    """9.38"""
    return (erf(a) - 1) / 2 + exp(-a**2) / (2 * a * sqrt(pi)) if a < inf else mpf(0)


def lambda_rational(a):
    """9.39"""
    n = lambda digits: mpf(digits)
    if a >= n("1.6"):
        return mpf(0)
    return (1 - n("1.259") * a + n("0.396") * a**2) / (n("3.535") * a + n("2.181") * a**2)


def lambda_ggx(a):
    """9.42"""
    return (-1 + sqrt(1 + 1 / a**2)) / 2


def g1_smith(s, m, lam):
    """9.24 and 9.25"""
    return 1 / (1 + lam) if m @ s > 0 else mpf(0)


def g1_karis(s, alpha):
    """9.44"""
    return 2 * s[2] / (s[2] * (2 - alpha) + alpha)


def factor_ashikhmin(phi):
    """9.29"""
    return 1 - exp(-mpf("7.3") * phi**2)


def factor_ginneken(phi):
    """9.30"""
    return mpf("4.41") * phi / (mpf("4.41") * phi + 1)


def azimuth_difference(o, i):
    """In [0, pi]; of the doubles that are given, as one that is 0 is."""
    turn = abs(mpf(o[1]) - mpf(i[1]))
    return 2 * pi - turn if turn > pi else turn


# Reflectances.


def schlick(f0, f90, p, c):
    """9.18, whose exponent is 1 / p"""
    return f0 + (f90 - f0) * (1 - c)**(1 / p)


def fifth(f0, c):
    return f0 + (1 - f0) * (1 - c)**5


def dielectric(eta, c):
    c_t = sqrt(1 - (1 - c**2) / eta**2)
    s, p = (c - eta * c_t) / (c + eta * c_t), (eta * c - c_t) / (eta * c + c_t)
    return (s**2 + p**2) / 2


# The albedo of mirrors on GGX with alpha = 1, where D is 1 / pi and G2 is 2 (n.l)(n.v) / (n.l + n.v): R_sF1 of 9.8 with
# F = 1, and of 9.57 and 9.8 the mean.


def r_ggx_1(mu):
    """int_0^1 x / (mu + x) dx, which is what is left of 9.34 in 9.8"""
    return 1 - mu * log(1 + 1 / mu)


def mean_of(r):
    """9.57, and of a reflectance 9.58"""
    return 2 * quad(lambda mu: r(mu) * mu, [0, mpf(1) / 8, mpf(1) / 2, 1])


CASES = []


def case(text, equations, material, quantity, inputs, value, bound=1e-12, strategy=""):
    """`inputs`: tuples of directions, by the names o, i and m; `value` is a function of them, in angles. `bound` is on the
    relative error, and on that beside 1e-3 of the largest value among the inputs."""
    CASES.append((text, equations, material, quantity, strategy, inputs, value, bound))


def of_distribution(distribution, **more):
    return of_term({"type": "mirror", "distribution": distribution, **more})


def of_term(term):
    return {"terms": [term]}


def pairs(directions=None):
    return [{"o": o, "i": i} for o, i in directions or PAIRS]


def normals():
    return [{"m": m} for m in NORMALS]


def viewers():
    return [{"o": o} for o in VIEWERS]


def add_density(text, equations, distribution, d, bound=1e-12):
    case(text, equations, of_distribution(distribution), "d", normals(), lambda at: d(direction(at["m"])), bound)


def add_pairs(text, equations, material, rho, bound=1e-12, quantity="brdf", directions=None):
    """rho(l, v) of vectors."""
    case(text, equations, material, quantity, pairs(directions), lambda at: rho(direction(at["i"]), direction(at["o"])), bound)


def add_masking(text, equations, material, g1, bound=1e-12):
    """g1(s, m) of vectors, of a normal that faces the viewer and of one that does not."""
    inputs = [{"o": o, "m": m} for o in VIEWERS for m in [(0.0, 0.0), (1.2, 2.3)]]
    case(text, equations, material, "g1", inputs,
         lambda at: g1(direction(at["o"]), direction(at["m"])) if direction(at["o"]) @ direction(at["m"]) > 0 else mpf(0), bound)


def quartic(t):
    """A shape that is no other distribution's: exp(-t^4) over its integral, pi^(3/2) / 2."""
    return 2 * exp(-t**4) / pi**mpf("1.5")


QUARTIC = {"type": "custom", "shape": "exp(-t2 * t2)"}


def add_distributions():
    for alpha in (0.05, 0.5, 2.0):
        a = mpf(alpha)
        add_density(RTR, [35], {"type": "beckmann", "alpha": alpha}, lambda m, a=a: d_beckmann(m, a), 1e-10)
        add_density(RTR, [41], {"type": "ggx", "alpha": alpha}, lambda m, a=a: d_ggx(m, a))
        add_density(RTR, [36, 49], {**QUARTIC, "alpha": alpha}, lambda m, a=a: d_shape(m, a, quartic), 1e-8)
        for amplitude in (0.0, 4.0):
            add_density(RTR, [73], {"type": "velvet", "alpha": alpha, "amplitude": amplitude},
                        lambda m, a=a, k=mpf(amplitude): d_velvet(m, a, k), 1e-11)
        add_density(RTR, [75], {"type": "sheen", "alpha": alpha}, lambda m, a=a: d_sheen(m, a))
        for gamma in (0.5, 1.0, 2.0, 3.5):
            add_density(RTR, [46, 47], {"type": "gtr", "alpha": alpha, "gamma": gamma},
                        lambda m, a=a, g=mpf(gamma): d_gtr(m, a, g))
    add_density(RTR, [46, 47], {"type": "gtr", "alpha": 1.0, "gamma": 3.5}, lambda m: d_gtr(m, mpf(1), mpf("3.5")))
    for power in (-0.5, 0.0, 7.0, 1e4):
        add_density(RTR, [40], {"type": "phong", "exponent": power}, lambda m, n=mpf(power): d_phong(m, n), 1e-10)
    add_density(RTR, [40], {"type": "phong", "alpha": 0.3}, lambda m: d_phong(m, 2 / mpf(0.3)**2 - 2))
    for alpha_x, alpha_y in ((0.1, 0.6), (2.0, 0.3)):
        ax, ay = mpf(alpha_x), mpf(alpha_y)
        of = lambda kind, x=alpha_x, y=alpha_y: {"type": kind, "alpha_x": x, "alpha_y": y}
        add_density(RTR, [52], of("beckmann"), lambda m, x=ax, y=ay: d_anisotropic_beckmann(m, x, y), 1e-10)
        add_density(RTR, [53], of("ggx"), lambda m, x=ax, y=ay: d_anisotropic_ggx(m, x, y))
        add_density(RTR, [50], {**of("custom"), "shape": QUARTIC["shape"]},
                    lambda m, x=ax, y=ay: d_anisotropic_shape(m, x, y, quartic), 1e-8)
    for r, k in ((0.5, 0.0), (0.7, 0.8), (0.3, 1.0)):
        aspect = sqrt(1 - mpf("0.9") * mpf(k))
        add_density(RTR, [54], {"type": "ggx", "roughness": r, "disney_anisotropy": k},
                    lambda m, r=mpf(r), q=aspect: d_anisotropic_ggx(m, r**2 / q, r**2 * q))
    for r, k in ((0.5, 0.0), (0.7, 0.8), (0.3, -0.99)):
        add_density(RTR, [55], {"type": "ggx", "roughness": r, "imageworks_anisotropy": k},
                    lambda m, r=mpf(r), k=mpf(k): d_anisotropic_ggx(m, r**2 * (1 + k), r**2 * (1 - k)))
    toksvig = lambda power, length: length * power / (length + power * (1 - length))
    for power, length in ((10.0, 0.7), (1e4, 0.999), (3.0, 1.0)):
        add_density(RTR, [76], {"type": "phong", "exponent": power, "mean_normal_length": length},
                    lambda m, n=mpf(power), k=mpf(length): d_phong(m, toksvig(n, k)), 1e-11)
        add_density(RTR, [76], {"type": "ggx", "alpha": 0.2, "mean_normal_length": length},
                    lambda m, k=mpf(length): d_ggx(m, sqrt(2 / (toksvig(2 / mpf(0.2)**2 - 2, k) + 2))), 1e-11)
    # Integrals of what is no density: what the properties find missing.
    short = {"type": "custom", "alpha": 1.0, "shape": "exp(-t2) / 4", "normalised": False}
    lost = lambda at: abs(quad(lambda t: d_shape(direction((0, 0)), 1, lambda _: exp(-t**2) / 4) * 2 * pi * t, [0, 1, 3, inf]) - 1)
    case(RTR, [21], of_distribution(short), "check normalized", [{"o": (0.0, 0.0)}], lost, 1e-9)
    case(RTR, [22], of_distribution(short), "check eq9_22", [{"o": (0.0, 0.0)}], lost, 1e-9)


def add_masking_functions():
    for alpha in (0.05, 0.5, 2.0):
        a = mpf(alpha)
        beckmann, ggx = ({"type": kind, "alpha": alpha} for kind in ("beckmann", "ggx"))
        smith = {"masking": {"type": "smith"}}
        add_masking(RTR, [24, 25, 38], of_distribution(beckmann, **smith),
                    lambda s, m, a=a: g1_smith(s, m, lambda_beckmann(a_of(s, a))))
        add_masking(RTR, [24, 25, 42], of_distribution(ggx, **smith), lambda s, m, a=a: g1_smith(s, m, lambda_ggx(a_of(s, a))))
        add_masking(RTR, [39], of_distribution(beckmann, masking={"type": "smith_rational"}),
                    lambda s, m, a=a: g1_smith(s, m, lambda_rational(a_of(s, a))))
        add_masking(RTR, [44], of_distribution(ggx, masking={"type": "karis"}), lambda s, m, a=a: g1_karis(s, a))
        add_masking(RTR, [37], of_distribution(ggx, masking={"type": "custom", "lambda": "1 / (2 * a)"}),
                    lambda s, m, a=a: g1_smith(s, m, 1 / (2 * a_of(s, a))))
        # 9.23 of a masking function that does not conserve: what it makes of the area.
        case(RTR, [23], of_distribution(ggx, masking={"type": "karis"}), "projected_area", viewers(),
             lambda at, a=a: projected_by_karis(direction(at["o"]), a), 1e-8)
    case(RTR, [23], of_distribution({"type": "ggx", "alpha": 0.5}, masking={"type": "karis"}), "check eq14", [{"o": CHECKED}],
         lambda at: abs(projected_by_karis(direction(at["o"]), mpf(0.5)) / direction(at["o"])[2] - 1), 1e-8)
    ax, ay = mpf(0.1), mpf(0.6)
    of = lambda kind: {"type": kind, "alpha_x": 0.1, "alpha_y": 0.6}
    add_masking(RTR, [51], of_distribution(of("ggx"), masking={"type": "custom", "lambda": "1 / (2 * a)"}),
                lambda s, m: g1_smith(s, m, 1 / (2 * a_anisotropic(s, ax, ay))))
    add_masking(RTR, [51, 52], of_distribution(of("beckmann")), lambda s, m: g1_smith(s, m, lambda_beckmann(a_anisotropic(s, ax, ay))))
    add_masking(RTR, [51, 53], of_distribution(of("ggx")), lambda s, m: g1_smith(s, m, lambda_ggx(a_anisotropic(s, ax, ay))))


# Where `brdfplot check` finds the largest residual of its viewers for Karis's masking.
CHECKED = (1.3089969389957472, 0.0)


def projected_by_karis(v, alpha):
    """The left side of 9.23: with a G1 that does not know m it is G1 int (v.m)+ D dm, and that is (n.v)(1 + Lambda) by
    9.23 with 9.24."""
    return g1_karis(v, alpha) * v[2] * (1 + lambda_ggx(a_of(v, alpha)))


def add_shadowing():
    ggx = {"type": "ggx", "alpha": 0.5}
    a = mpf(0.5)
    lam = lambda s: lambda_ggx(a_of(s, a))
    g1 = lambda s: 1 / (1 + lam(s))

    def add(equations, shadowing, g2):
        case(RTR, equations, of_distribution(ggx, shadowing=shadowing), "g2", pairs(),
             lambda at: g2(direction(at["i"]), direction(at["o"]), azimuth_difference(at["o"], at["i"])))

    add([27], {"type": "separable"}, lambda l, v, phi: g1(v) * g1(l))
    add([31], {"type": "height_correlated"}, lambda l, v, phi: 1 / (1 + lam(v) + lam(l)))
    for name, number, factor in (("ashikhmin", 29, factor_ashikhmin), ("ginneken", 30, factor_ginneken)):
        add([28, number], {"type": "direction_correlated", "lambda": name},
            lambda l, v, phi, k=factor: k(phi) * g1(v) * g1(l) + (1 - k(phi)) * min(g1(v), g1(l)))
        add([32, number], {"type": "height_direction_correlated", "lambda": name},
            lambda l, v, phi, k=factor: 1 / (1 + max(lam(v), lam(l)) + k(phi) * min(lam(v), lam(l))))


def add_mirrors():
    for alpha in (0.05, 0.5, 2.0):
        a = mpf(alpha)
        ggx, beckmann = ({"type": kind, "alpha": alpha} for kind in ("ggx", "beckmann"))
        fresnel = {"type": "schlick", "f0": 0.04}
        f = lambda l, v: fifth(mpf(0.04), half(l, v) @ l)
        # Of 1 / alpha^2 roundings of h a narrow lobe makes so many of D.
        bound = 1e-12 + 1e-14 / alpha**2
        add_pairs(RTR, [33, 34], of_distribution(beckmann, fresnel=fresnel, shadowing={"type": "height_correlated"}),
                  lambda l, v, a=a: mirrored(l, v, f(l, v), 1 / (1 + lambda_beckmann(a_of(l, a)) + lambda_beckmann(a_of(v, a))),
                                             d_beckmann(half(l, v), a)), 100 * bound)
        add_pairs(RTR, [43], of_distribution(ggx, shadowing={"type": "height_correlated"}),
                  lambda l, v, a=a: d_ggx(half(l, v), a) * lagarde(l[2], v[2], a), bound)
        if alpha <= 1:
            add_pairs(RTR, [45], of_distribution(ggx, shadowing={"type": "hammon"}),
                      lambda l, v, a=a: d_ggx(half(l, v), a) * mpf("0.5") / (
                          2 * l[2] * v[2] * (1 - a) + (l[2] + v[2]) * a), bound)
        add_pairs(KELEMEN, [1], of_distribution(beckmann, fresnel=fresnel, masking={"type": "v_cavity"}, shadowing={"type": "minimum"}),
                  lambda l, v, a=a: mirrored(l, v, f(l, v), torrance(l, v), d_beckmann(half(l, v), a)), 100 * bound)
        # Equation 2 stands for G / ((n.l)(n.v)), where the print has halved it: with 1 / (4 ...) it makes 3.
        add_pairs(KELEMEN, [2], of_distribution(beckmann, fresnel=fresnel, masking={"type": "kelemen"}),
                  lambda l, v, a=a: f(l, v) * d_beckmann(half(l, v), a) / (2 * (1 + l @ v)), 100 * bound)
        term = {"type": "kelemen", "distribution": {"type": "ward", "alpha": alpha}, "density": "normalised", "fresnel": fresnel}
        add_pairs(KELEMEN, [3, 4], of_term(term),
                  lambda l, v, a=a: ward(half(l, v), a) * f(l, v) / (2 * (1 + l @ v)), 1e-9)
        term = {"type": "kelemen", "distribution": beckmann, "fresnel": fresnel}
        add_pairs(KELEMEN, [3], of_term(term),
                  lambda l, v, a=a: d_beckmann(half(l, v), a) * half(l, v)[2] * f(l, v) / (2 * (1 + l @ v)), 100 * bound)
        add_density(KELEMEN, [4], {"type": "ward", "alpha": alpha},
                    lambda m, a=a: ward(m, a) / quad(lambda t: ward(direction((mp.atan(t), 0)), a) * 2 * pi * t / (1 + t**2)**2,
                                                     [0, a / 2, a, 3 * a, 10 * a]), 1e-9)
        case(KELEMEN, [8, 9], of_distribution(beckmann), "pdf", pairs(), lambda at, a=a: density_of_light(at, a), 100 * bound,
             "half_vector")
    for power in (0.0, 7.0, 1e3):
        term = {"type": "kelemen", "distribution": {"type": "phong", "exponent": power}, "density": "normalised"}
        add_pairs(KELEMEN, [3, 5], of_term(term),
                  lambda l, v, n=mpf(power): (n + 1) / (2 * pi) * half(l, v)[2]**n / (2 * (1 + l @ v)), 1e-9)
    # A figure over theta_h, whose ends are given here as normals; theta_d and phi_d are in its quantity.
    case(RTR, [33], of_distribution({"type": "ggx", "alpha": 0.5}), "plot theta_h theta_d=0.4 phi_d=2.0",
         [{"m": (0.2, 0.3)}, {"m": (1.0, 0.3)}], lambda at: along_half(at, mpf(0.5)))
    # 9.74's denominator under another D.
    add_pairs(RTR, [74], of_distribution({"type": "velvet", "alpha": 0.3}, shadowing={"type": "neubelt"}),
              lambda l, v: d_velvet(half(l, v), mpf(0.3), 4) / (4 * (l[2] + v[2] - l[2] * v[2])), 1e-11)


def along_half(at, alpha):
    """rho of 9.33, 9.34 and 9.43 with theta_d = 0.4 and phi_d = 2 about the half vector (Rusinkiewicz 1998): l = sin
    theta_d (cos phi_d x + sin phi_d y) + cos theta_d h, x that way in which theta_h grows, y horizontal."""
    theta_h, phi_h = map(mpf, at["m"])
    theta_d, phi_d = mpf(0.4), mpf(2)
    x = Vector((cos(theta_h) * cos(phi_h), cos(theta_h) * sin(phi_h), -sin(theta_h)))
    y = Vector((-sin(phi_h), cos(phi_h), mpf(0)))
    h = direction(at["m"])
    l, v = (Vector(sign * sin(theta_d) * (cos(phi_d) * p + sin(phi_d) * q) + cos(theta_d) * r for p, q, r in zip(x, y, h))
            for sign in (1, -1))
    return d_ggx(half(l, v), alpha) * lagarde(l[2], v[2], alpha)


def lagarde(mu_i, mu_o, a):
    """9.43"""
    return mpf("0.5") / (mu_o * sqrt(a**2 + mu_i * (mu_i - a**2 * mu_i)) + mu_i * sqrt(a**2 + mu_o * (mu_o - a**2 * mu_o)))


def torrance(l, v):
    """The G of Kelemen's Eq. 1"""
    h = half(l, v)
    return min(2 * h[2] * v[2] / (v @ h), 2 * h[2] * l[2] / (l @ h), mpf(1))


def ward(h, m):
    """Kelemen's Eq. 4"""
    return exp(-(1 / h[2]**2 - 1) / m**2) / (pi * m**2 * h[2]**3)


def density_of_light(at, alpha):
    """Kelemen's Eqs. 8 and 9: P(h) / (4 cos beta), where P of `half_vector` is D cos."""
    l, v = direction(at["i"]), direction(at["o"])
    h = half(l, v)
    return d_beckmann(h, alpha) * h[2] / (4 * (h @ l))


def add_reflectances():
    ggx = {"type": "ggx", "alpha": 0.5}
    for f0, f90, exponent in ((0.04, 1.0, 5.0), (0.9, 0.5, 2.5), (0.0, 1.0, 1.0), (0.2, 0.9, 1000.0)):
        f = lambda c, f0=mpf(f0), f90=mpf(f90), p=1 / mpf(exponent): schlick(f0, f90, p, c)
        material = of_distribution(ggx, fresnel={"type": "schlick", "f0": f0, "f90": f90, "exponent": exponent})
        case(RTR, [18], material, "fresnel", [{"o": o, "m": (0.0, 0.0)} for o in VIEWERS], lambda at, f=f: f(direction(at["o"])[2]))
        p = 1 / mpf(exponent)
        case(RTR, [58, 59], material, "average_fresnel", [{"o": VIEWERS[1]}],
             lambda at, f0=mpf(f0), f90=mpf(f90), p=p: (2 * p**2 * f90 + (3 * p + 1) * f0) / (2 * p**2 + 3 * p + 1), 1e-8)
    for f0 in (0.0, 0.04, 1.0):
        case(RTR, [60], of_distribution(ggx, fresnel={"type": "schlick", "f0": f0}), "average_fresnel", [{"o": VIEWERS[1]}],
             lambda at, f0=mpf(f0): mpf(20) / 21 * f0 + mpf(1) / 21, 1e-8)
    for eta in (1.01, 1.5, 4.0):
        case(RTR, [58], of_distribution(ggx, fresnel={"type": "dielectric", "eta": eta}), "average_fresnel", [{"o": VIEWERS[1]}],
             lambda at, eta=mpf(eta): mean_of(lambda mu: dielectric(eta, mu)), 1e-8)


def add_coupled():
    """9.56 to 9.58, 9.65, and Kelemen's matte part, on GGX with alpha = 1."""
    mirror = {"type": "mirror", "distribution": {"type": "ggx", "alpha": 1.0}, "shadowing": {"type": "height_correlated"}}
    r, mean_r = r_ggx_1, mean_of(r_ggx_1)
    left = lambda l, v: (1 - r(l[2])) * (1 - r(v[2]))
    table = 1e-6  # what the tables of albedo state
    for k in (0.6, 1.0):
        matte = of_term({"type": "complement", "of": mirror, "color": k})
        add_pairs(KELEMEN, [6], matte, lambda l, v, k=mpf(k): k * left(l, v) / (pi * (1 - mean_r)), table)
        case(KELEMEN, [7], matte, "albedo", viewers()[1:], lambda at, k=mpf(k): k * (1 - r(direction(at["o"])[2])), table)
        add_pairs(RTR, [65], matte, lambda l, v, k=mpf(k): k * left(l, v) / (pi * (1 - mean_r)), table)
    for f0 in (0.04, 0.9):
        mean_f = mean_of(lambda mu, f0=mpf(f0): fifth(f0, mu))
        of = {**mirror, "fresnel": {"type": "schlick", "f0": f0}}
        # As printed with the mean of F; by the series of bounces with its square.
        for reading, power in (("printed", 1), ("energy", 2)):
            add_pairs(RTR, [56, 57, 58], of_term({"type": "multiple_bounce", "of": of, "mean_fresnel": reading}),
                      lambda l, v, f=mean_f, n=power: f**n * mean_r / (pi * (1 - mean_r) * (1 - f * (1 - mean_r))) * left(l, v), table)


def add_diffuse():
    rho = mpf(0.5)
    inverse = rho / pi
    add_pairs(RTR, [61], of_term({"type": "lambert", "albedo": 0.5}), lambda l, v: inverse)
    for f0 in (0.0, 0.04, 1.0):
        f = mpf(f0)
        add_pairs(RTR, [62], of_term({"type": "fresnel_lambert", "albedo": 0.5, "f0": f0, "at": "normal"}),
                  lambda l, v, f=f: (1 - fifth(f, l[2])) * inverse)
        add_pairs(RTR, [63], of_term({"type": "fresnel_lambert", "albedo": 0.5, "f0": f0, "at": "half"}),
                  lambda l, v, f=f: (1 - fifth(f, half(l, v) @ l)) * inverse)
        add_pairs(RTR, [64], of_term({"type": "shirley", "albedo": 0.5, "f0": f0}), lambda l, v, f=f: rho / pi * smooth(f, l, v))
        for alpha in (0.0, 0.4, 1.0):
            add_pairs(RTR, [68, 69], of_term({"type": "hammon_diffuse", "albedo": 0.5, "f0": f0, "alpha": alpha}),
                      lambda l, v, f=f, a=mpf(alpha): inverse * ((1 - a) * smooth(f, l, v) + a * rough(l, v) + rho * mpf("0.3641") * a))
    for alpha, k, printed in product((0.0, 0.25, 1.0), (0.0, 0.4, 1.0), (False, True)):
        term = {"type": "disney_diffuse", "albedo": 0.5, "alpha": alpha, "subsurface": k, "printed": printed}
        add_pairs(RTR, [66, 67], of_term(term), lambda l, v, a=mpf(alpha), k=mpf(k), p=printed: inverse * disney(l, v, a, k, p))
    o, i = (0.0, 0.0), (0.8, 0.2)
    case(RTR, [26], of_term({"type": "facet_diffuse", "distribution": {"type": "ggx", "alpha": 1.0}}), "brdf", [{"o": o, "i": i}],
         lambda at: facets(direction(at["i"])), 1e-8)


def smooth(f0, l, v):
    """9.64 and 9.69, without the albedo over pi"""
    return mpf(21) / 20 * (1 - f0) * (1 - (1 - l[2])**5) * (1 - (1 - v[2])**5)


def rough(l, v):
    """9.69"""
    facing, nh = mpf("0.5") + mpf("0.5") * (l @ v), half(l, v)[2]
    return facing * (mpf("0.9") - mpf("0.4") * facing) * (mpf("0.5") + nh) / nh


def disney(l, v, alpha, k, printed):
    """9.66 and 9.67; f_ss as printed, or with 1 / (n.l + n.v), as its source has it"""
    lh = half(l, v) @ l
    rim = lambda f90: (1 + (f90 - 1) * (1 - l[2])**5) * (1 + (f90 - 1) * (1 - v[2])**5)
    f_d = rim(mpf("0.5") + 2 * sqrt(alpha) * lh**2)
    f_ss = (1 / (l[2] * v[2] if printed else l[2] + v[2]) - mpf("0.5")) * rim(sqrt(alpha) * lh**2) + mpf("0.5")
    return (1 - k) * f_d + mpf("1.25") * k * f_ss


def facets(l):
    """9.26 of diffuse facets seen from the normal, alpha = 1: D is 1 / pi, G2 2 (n.l) / (1 + n.l)."""
    mp.dps = 20
    theta_l = acos(l[2])

    def over(phi):
        """Normals at this azimuth from the light's, up to where they turn away from it."""
        facing = lambda theta: cos(theta) * l[2] + sin(theta) * cos(phi) * sin(theta_l)
        end = pi / 2 if cos(phi) >= 0 else mp.atan(-1 / (tan(theta_l) * cos(phi)))
        return quad(lambda theta: facing(theta) * cos(theta) * sin(theta), [0, end])

    sum_of = 2 * quad(over, [0, pi / 2, pi])
    mp.dps = 50
    return sum_of / pi / pi * 2 * l[2] / (1 + l[2]) / l[2]


def add_cloth():
    rho = mpf(0.5)
    clamp = lambda x: min(max(x, mpf(0)), mpf(1))
    for rim, inner in ((2.5, 0.7), (0.0, 1000.0)):
        term = {"type": "uncharted2", "albedo": 0.5, "rim": 0.3, "rim_power": rim, "inner": 0.2, "inner_power": inner, "diffuse": 0.1}
        add_pairs(RTR, [70], of_term(term), lambda l, v, x=mpf(rim), y=mpf(inner): rho / pi * (
            mpf(0.3) * v[2]**x + mpf(0.2) * (1 - v[2])**y + mpf(0.1)))
    below = PAIRS + [((0.4, 0.3), (1.8, 1.0)), ((1.2, 0.3), (2.2, 1.0))]
    for w, scatter in product((0.0, 0.5, 1.0), (0.0, 0.4, 1.0)):
        readings = {"printed": lambda x, w: clamp(x) / (1 + w), "ratio": lambda x, w: clamp(x / (1 + w)),
                    "conserving": lambda x, w: max(x, mpf(0)) / (1 + w)**2}
        for form, reading in readings.items():
            term = {"type": "wrap", "albedo": 0.5, "w": w, "scatter": scatter, "form": form}
            add_pairs(RTR, [71], of_term(term), lambda l, v, w=mpf(w), s=mpf(scatter), f=reading: rho / pi * clamp(
                s + max(l[2], mpf(0))) * f(l[2] + w, w), 1e-12, "brdf_cos", below)
    add_pairs(RTR, [72], of_term({"type": "disney_sheen", "color": 0.5}), lambda l, v: rho * (1 - half(l, v) @ l)**5)
    for alpha, f0, amplitude in product((0.05, 0.5, 1.0), (0.0, 0.04, 1.0), (0.0, 4.0)):
        term = {"type": "velvet_cloth", "albedo": 0.5, "alpha": alpha, "f0": f0, "amplitude": amplitude}
        add_pairs(RTR, [74], of_term(term), lambda l, v, a=mpf(alpha), f0=mpf(f0), k=mpf(amplitude): cloth(l, v, rho, a, f0, k), 1e-11)


def cloth(l, v, rho, alpha, f0, amplitude):
    """9.74"""
    h = half(l, v)
    f = fifth(f0, h @ l)
    return (1 - f) * rho / pi + f * d_velvet(h, alpha, amplitude) / (4 * (l[2] + v[2] - l[2] * v[2]))


for add_all in (add_distributions, add_masking_functions, add_shadowing, add_mirrors, add_reflectances, add_coupled, add_diffuse, add_cloth):
    add_all()
