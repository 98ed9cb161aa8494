# SPDX-License-Identifier: BSD-3-Clause
"""Kinetic theory of smooth inelastic hard spheres that cool freely, of diameter and mass 1: n = 6 phi/pi spheres per
volume, temperature T = <v^2>/3.

    g0    = (1 - phi/2)/(1 - phi)^3                                     Carnahan, Starling 1969: pairs at contact
    omega = 4 sqrt(pi) n g0 sqrt(T) (1 - a2/16)                         Enskog: collisions of a sphere per time
    zeta  = (1 - e^2)/3 4 sqrt(pi) n g0 sqrt(T) (1 + 3 a2/16)           dT/dt = -zeta T
    a2    = 16 (1 - e)(1 - 2 e^2)/(81 - 17 e + 30 e^2 (1 - e))          van Noije, Ernst 1998: no Gaussian
    T     = T0/(1 + t/tau)^2,  tau = 2/zeta(T0)                         Haff 1983
    nu    = 5 sqrt(T)/(16 sqrt(pi) n) ((1 + 8/5 phi g0)^2/g0 + 768/(25 pi) phi^2 g0)
                                                                        Enskog: viscosity over density, elastic

A mode of shear with the wave number k decays in units of the speed of the spheres as nu k^2 - zeta/2. So it grows in
a box longer than 2 pi sqrt(2 nu/zeta), and below that holds more energy than T, for the noise that feeds it goes with
nu k^2: 1/((k/k_c)^2 - 1) more (Brey, Ruiz-Montero 2007: fluctuations of the vorticity). What is common motion of
neighbours is not lost in their collisions. That is not in zeta, which takes those that collide as strangers.

With wells of depth D and few spheres, those that meet from afar collide with the energy of the well added: a
collision takes in the mean over all meetings 1 + D/T + (D/T)^2/2 of what it takes without, as long as the well is
wide enough to catch all that it turns towards the core."""

import math

import numpy as np


class Gas:
    """At a temperature of 1."""

    def __init__(self, phi, e):
        self.phi, self.e = phi, e
        self.n = 6 * phi / math.pi
        self.g0 = (1 - phi / 2) / (1 - phi)**3
        self.a2 = 16 * (1 - e) * (1 - 2 * e**2) / (81 - 17 * e + 30 * e**2 * (1 - e))
        without_a2 = 4 * math.sqrt(math.pi) * self.n * self.g0
        self.frequency = without_a2 * (1 - self.a2 / 16)
        self.zeta = (1 - e**2) / 3 * without_a2 * (1 + 3 * self.a2 / 16)
        self.tau = 2 / self.zeta
        enskog = (1 + 8 / 5 * phi * self.g0)**2 / self.g0 + 768 / (25 * math.pi) * phi**2 * self.g0
        self.viscosity = 5 / (16 * math.sqrt(math.pi) * self.n) * enskog
        self.critical = 2 * math.pi * math.sqrt(2 * self.viscosity / self.zeta)  # length of the box

    def side(self, count):
        """Of the box of so many spheres."""
        return (count / self.n)**(1 / 3)

    def free_path(self):
        return math.sqrt(8 / math.pi) / self.frequency

    def haff(self, t):
        return (1 + t / self.tau)**-2

    def with_wells(self, t, D):
        """T(t) of a dilute gas with wells to first order in D/T: dT/dt = -zeta T (1 + D/T)."""
        root = math.sqrt(D)
        return (root / np.tan(root * np.asarray(t) / self.tau + math.atan(root)))**2

    def shear_energy(self, count, cooled=math.inf):
        """Of a longest mode of shear in the box, over T, which was 1 before; `cooled`: 1 + t/tau."""
        above = (self.critical / self.side(count))**2 - 1
        return 1 + (1 - cooled**(-2 * above)) / above

    def common_motion(self, count):
        """Share of T that is motion of shear beyond 1 per mode, over all modes longer than 2 pi free paths, below which
        there is no viscosity. Good to a factor of 2: that bound is none sharply, and modes of sound are left out."""
        length, reach = self.side(count), 1 / self.free_path()
        most = math.ceil(reach * length / (2 * math.pi))
        row = np.arange(-most, most + 1) * 2 * math.pi / length
        k2 = row[:, None, None]**2 + row[None, :, None]**2 + row[None, None, :]**2
        k2 = k2[(k2 > 0) & (k2 < reach**2)]
        return 2 / (3 * count) * float(np.sum(1 / (k2 * (self.critical / (2 * math.pi))**2 - 1)))

    def scatter(self, count, cooled):
        """Standard deviation of the rate of one run, (1/sqrt(T) - 1)/t, over its mean. Collisions are events of a
        Poisson process, each takes m T in the mean, m = 2/3 (1 - e^2)/count, and has the deviation of its mean: s =
        1/sqrt(T) grows by m s/2 per collision, with the variance m^2 s^2/2; summed up to s = `cooled`."""
        m = 2 / 3 * (1 - self.e**2) / count
        return math.sqrt(m / 2 * (cooled + 1) / (cooled - 1))
