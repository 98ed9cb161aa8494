# SPDX-License-Identifier: BSD-3-Clause
"""The drag closures of src/drag, written out a second time and in another form: as the sources print
them, each in its own convention, and not scaled by Stokes' drag.

Every function returns beta/(1 - eps) [kg/(m3 s)] from the void fraction eps, the slip |u - v| > 0 [m/s]
between the gas in the voids and the particles, diameter d [m], density rho [kg/m3] and viscosity mu
[Pa s]. `m` is what the numbers are made of, with mpf, sqrt, exp, log, log10, pi: DOUBLE or PRECISE.
"""
import decimal
import math
from types import SimpleNamespace

DOUBLE = SimpleNamespace(mpf=float, sqrt=math.sqrt, exp=math.exp, log=math.log, log10=math.log10,
                         pi=math.pi)
#: As many digits as decimal.getcontext() asks for, up to 60.
PRECISE = SimpleNamespace(mpf=decimal.Decimal, sqrt=decimal.Decimal.sqrt, exp=decimal.Decimal.exp,
                          log=decimal.Decimal.ln, log10=decimal.Decimal.log10,
                          pi=decimal.Decimal("3.14159265358979323846264338327950288419716939937510582097494459"))


def syamlal_obrien(m, eps, slip, d, rho, mu):
    n = m.mpf
    reynolds = d * slip * rho / mu
    a = eps ** n("4.14")
    b = n("0.8") * eps ** n("1.28") if eps <= 0.85 else eps ** n("2.65")
    x = n("0.06") * reynolds
    terminal = (a - x + m.sqrt(x * x + 2 * x * (2 * b - a) + a * a)) / 2
    coefficient = (n("0.63") + n("4.8") * m.sqrt(terminal / reynolds)) ** 2
    return 3 * eps * rho * coefficient * slip / (4 * terminal**2 * d)


def ergun_pressure_gradient(m, eps, velocity, d, rho, mu):
    """Loss of pressure per length [Pa/m] at a superficial velocity [m/s]: Ergun's equation."""
    return (150 * (1 - eps) ** 2 / eps**3 * mu * velocity / d**2
            + m.mpf("1.75") * (1 - eps) / eps**3 * rho * velocity**2 / d)


def drag_coefficient(m, reynolds):
    """C_D of Schiller and Naumann."""
    if reynolds >= 1000:
        return m.mpf("0.44")
    return 24 / reynolds * (1 + m.mpf("0.15") * reynolds ** m.mpf("0.687"))


def ergun_wen_yu(m, eps, slip, d, rho, mu, n="4.65"):
    if eps < 0.8:
        # Steady flow, model A: eps grad p = -beta slip
        return eps * ergun_pressure_gradient(m, eps, eps * slip, d, rho, mu) / slip / (1 - eps)
    return wen_yu(m, eps, slip, d, rho, mu, n)


def wen_yu(m, eps, slip, d, rho, mu, n="4.65"):
    coefficient = drag_coefficient(m, eps * slip * d * rho / mu)
    return (m.mpf(3) / 4 * coefficient * eps * rho * slip / d) * eps ** (2 - m.mpf(n))


def ergun_rowe_henwood(m, eps, slip, d, rho, mu):
    if eps < 0.8:
        return ergun_wen_yu(m, eps, slip, d, rho, mu)
    velocity = eps * slip
    single = drag_coefficient(m, velocity * d * rho / mu) * rho * m.pi / 8 * d**2 * velocity**2
    total = single * eps ** -m.mpf("4.7")
    return eps * total / slip / (m.pi / 6 * d**3)


def di_felice(m, eps, slip, d, rho, mu):
    n = m.mpf
    velocity = eps * slip
    reynolds = velocity * d * rho / mu
    coefficient = (n("0.63") + n("4.8") / m.sqrt(reynolds)) ** 2
    chi = n("3.7") - n("0.65") * m.exp(-((n("1.5") - m.log10(reynolds)) ** 2) / 2)
    drag = coefficient * rho * m.pi / 8 * d**2 * velocity**2 * eps**-chi
    return drag / slip / (m.pi / 6 * d**3)


def hill_koch_ladd(m, eps, slip, d, rho, mu):
    n = m.mpf
    radius, velocity, phi = d / 2, eps * slip, 1 - eps
    if phi >= 0.4:
        still = 10 * phi / (1 - phi) ** 3
    else:
        logarithm = phi * m.log(phi) if phi > 0 else 0
        still = ((1 + 3 / m.sqrt(n(2)) * m.sqrt(phi) + n(135) / 64 * logarithm + n("17.14") * phi)
                 / (1 + n("0.681") * phi - n("8.48") * phi**2 + n("8.16") * phi**3))
    inertia = n("0.0673") + n("0.212") * phi + n("0.0232") / (1 - phi) ** 5
    total = 6 * m.pi * mu * radius * velocity * (still + inertia * rho * velocity * radius / mu)
    return eps * total / slip / (m.pi / 6 * d**3)


def beetstra(m, eps, slip, d, rho, mu):
    n = m.mpf
    phi, velocity = 1 - eps, eps * slip
    reynolds = velocity * d * rho / mu
    scaled = (10 * phi / (1 - phi) ** 2 + (1 - phi) ** 2 * (1 + n("1.5") * m.sqrt(phi))
              + n("0.413") * reynolds / (24 * (1 - phi) ** 2)
              * (1 / (1 - phi) + 3 * phi * (1 - phi) + n("8.4") * reynolds ** -n("0.343"))
              / (1 + 10 ** (3 * phi) * reynolds ** (-(1 + 4 * phi) / 2)))
    return 3 * m.pi * mu * d * velocity * scaled / slip / (m.pi / 6 * d**3)


def tenneti(m, eps, slip, d, rho, mu):
    """As a force, which they scale with the superficial velocity, and the drag that is eps of it."""
    n = m.mpf
    phi, velocity = 1 - eps, eps * slip
    reynolds = velocity * d * rho / mu
    single = drag_coefficient(m, reynolds) * rho * m.pi / 8 * d**2 * velocity**2
    of_solid = n("5.81") * phi / (1 - phi) ** 3 + n("0.48") * phi ** (n(1) / 3) / (1 - phi) ** 4
    of_both = phi**3 * reynolds * (n("0.95") + n("0.61") * phi**3 / (1 - phi) ** 2)
    total = single / (1 - phi) ** 3 + 3 * m.pi * mu * d * velocity * (of_solid + of_both)
    return eps * total / slip / (m.pi / 6 * d**3)


def tang(m, eps, slip, d, rho, mu):
    """From a Reynolds number of 1000 on a force with the square of the slip, as src/drag/tang.h says."""
    n = m.mpf
    phi, velocity = 1 - eps, eps * slip
    reynolds = velocity * d * rho / mu
    if reynolds > 1000:
        return tang(m, eps, 1000 / reynolds * slip, d, rho, mu) * reynolds / 1000
    scaled = (10 * phi / (1 - phi) ** 2 + (1 - phi) ** 2 * (1 + n("1.5") * m.sqrt(phi))
              + (n("0.11") * phi * (1 + phi) - n("0.00456") / (1 - phi) ** 4
                 + (n("0.169") * (1 - phi) + n("0.0644") / (1 - phi) ** 4) * reynolds ** -n("0.343"))
              * reynolds)
    return 3 * m.pi * mu * d * velocity * scaled / slip / (m.pi / 6 * d**3)


def rong(m, eps, slip, d, rho, mu):
    n = m.mpf
    velocity = eps * slip
    reynolds = velocity * d * rho / mu
    coefficient = (n("0.63") + n("4.8") / m.sqrt(reynolds)) ** 2
    chi = (n("2.65") * (eps + 1)
           - (n("5.3") - n("3.5") * eps) * eps**2 * m.exp(-((n("1.5") - m.log10(reynolds)) ** 2) / 2))
    return m.pi / 8 * coefficient * rho * d**2 * velocity**2 * eps**-chi / slip / (m.pi / 6 * d**3)


CLOSURES = {
    "syamlalOBrien": syamlal_obrien,
    "ergunWenYu": ergun_wen_yu,
    "ergunRoweHenwood": ergun_rowe_henwood,
    "diFelice": di_felice,
    "hillKochLadd": hill_koch_ladd,
    "beetstra": beetstra,
    "tenneti": tenneti,
    "tang": tang,
    "wenYu": wen_yu,
    "rong": rong,
}
