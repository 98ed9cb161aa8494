# SPDX-License-Identifier: BSD-3-Clause
"""Where the images of particles stand in a box that is sheared along x with the gradient along y, and
how fast they are: the lattice of images that every engine's box has to show."""

import numpy


class ShearedImages:
    def __init__(self, box, rate, tilt=0.0):
        """box: its three sides; tilt: shift of the image above at time 0."""
        self.box, self.rate, self.tilt = numpy.array(box, dtype=float), rate, tilt

    def nearest(self, motion, time):
        """Places and velocities of one particle from another, six numbers in each row: of the nearest
        image."""
        motion = numpy.array(motion)
        count = numpy.rint(motion[..., 1] / self.box[1])
        motion[..., 0] -= count * (self.tilt + self.rate * time * self.box[1])
        motion[..., 1] -= count * self.box[1]
        motion[..., 3] -= count * self.rate * self.box[1]
        for k in (0, 2):
            motion[..., k] -= self.box[k] * numpy.rint(motion[..., k] / self.box[k])
        return motion

    def apart(self, one, other, time):
        """Largest difference of places and velocities (six columns), up to the choice of the image."""
        return numpy.abs(self.nearest(other - one, time)).max()

    def off_free_flight(self, places, velocities, x0, v0, time):
        """How far places and velocities are from those of images of particles that fly straight from
        x0 with v0, and how often one has crossed the sheared faces at most."""
        free = x0 + time * v0
        count = numpy.rint((free - places)[:, 1] / self.box[1])
        off = self.nearest(numpy.hstack([free - places, v0 - velocities]), time)
        return numpy.abs(off[:, :3]).max(), numpy.abs(off[:, 3:]).max(), numpy.abs(count).max()
