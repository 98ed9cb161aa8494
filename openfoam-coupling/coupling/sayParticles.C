// SPDX-License-Identifier: GPL-3.0-or-later
#include "sayParticles.H"

#include "coupledParticles.H"

#include "bed/geldart.h"
#include "sphere.h"


void Foam::sayParticles(const coupledParticles& particles, const scalar rho)
{
    const UList<scalar> radii(particles.radii());
    label n = radii.size();
    scalar mass = sum(particles.masses());
    scalar volume = 0;
    scalar squares = 0;
    for (const scalar radius : radii)
    {
        volume += cohesion::sphere_volume(radius);
        squares += radius*radius;
    }
    reduce(n, sumOp<label>());
    reduce(mass, sumOp<scalar>());
    reduce(volume, sumOp<scalar>());
    reduce(squares, sumOp<scalar>());

    // Sum d^3 over sum d^2
    const scalar diameter = 2*volume/cohesion::sphere_volume(1)/squares;
    const scalar density = mass/volume;
    Info<< "Particles: " << n << ", Sauter mean diameter " << diameter << " m, density " << density
        << " kg/m3";
    // The lines between the groups are of heavier ones.
    if (density > rho)
    {
        Info<< "; by both, in ambient air, Geldart's group "
            << char(cohesion::bed::geldart_group(density - rho, diameter));
    }
    Info<< endl;
}
