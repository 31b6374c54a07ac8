"""A plain implementation of `brdfplot eval MATERIAL -q lambda`: Smith's Lambda of Beckmann as printed (Heitz 2014,
Eq. 69) for every row of theta_o,phi_o, with numpy and scipy.

    eval_peer.py ROWS.csv OUT.csv ALPHA
"""

import sys

import numpy
from scipy.special import erf

rows = numpy.loadtxt(sys.argv[1], delimiter=",", skiprows=1)
a = 1 / (float(sys.argv[3]) * numpy.tan(rows[:, 0]))
values = 0.5 * (erf(a) - 1) + numpy.exp(-a * a) / (2 * a * numpy.sqrt(numpy.pi))
numpy.savetxt(sys.argv[2], numpy.column_stack([rows, values]), delimiter=",", header="theta_o,phi_o,lambda", comments="")
