// SPDX-License-Identifier: GPL-3.0-or-later
#include "reportParticles.H"

#include "bed/geldart.h"
#include "sphere.h"

#include "coupling/sixDigits.H"
#include "coupledParticles.H"

namespace
{

using namespace Foam;

//- Largest over smallest diameter above which spheres are a mixture of sizes: sieves sort no finer.
constexpr scalar mixtureFrom = 1.05;

//- Smallest and largest value of all particles
struct ValueRange
{
    scalar least = GREAT;
    scalar most = -GREAT;

    void add(const scalar value)
    {
        least = min(least, value);
        most = max(most, value);
    }

    //- Takes in the values of the other ranks. All ranks call it.
    void reduce()
    {
        Foam::reduce(least, minOp<scalar>());
        Foam::reduce(most, maxOp<scalar>());
    }

    //- Whether the two differ in six digits
    bool wide() const
    {
        return most > (1 + 1e-5)*least;
    }

    friend Ostream& operator<<(Ostream& os, const ValueRange& range)
    {
        if (range.wide())
        {
            os  << sixDigits(range.least).c_str() << " to ";
        }
        return os << sixDigits(range.most).c_str();
    }
};

//- Sums and ranges over all particles
struct ParticleTotals
{
    label number = 0;
    scalar mass = 0;
    scalar volume = 0;
    scalar squares = 0;     // of radii
    ValueRange diameter;
    ValueRange density;

    explicit ParticleTotals(const coupledParticles& particles)
    {
        const UList<scalar> radii(particles.radii());
        const UList<scalar> masses(particles.masses());
        number = radii.size();
        forAll(radii, i)
        {
            const scalar sphere = cohesion::sphere_volume(radii[i]);
            mass += masses[i];
            volume += sphere;
            squares += radii[i]*radii[i];
            diameter.add(2*radii[i]);
            density.add(masses[i]/sphere);
        }
        reduce(number, sumOp<label>());
        reduce(mass, sumOp<scalar>());
        reduce(volume, sumOp<scalar>());
        reduce(squares, sumOp<scalar>());
        diameter.reduce();
        density.reduce();
    }

    //- Sum d^3 over sum d^2
    scalar sauter() const
    {
        return 2*volume/cohesion::sphere_volume(1)/squares;
    }

    scalar meanDensity() const
    {
        return mass/volume;
    }
};

//- ratio: largest over smallest diameter
void reportMixture(const scalar ratio, const cohesion::drag::MixtureLaw& law)
{
    Info<< (ratio > mixtureFrom ? "    A mixture, largest" : "    Largest") << " over smallest diameter "
        << sixDigits(ratio).c_str() << ": the drag of each sphere is ";
    if (law.mixes)
    {
        Info<< "that of dragMixture " << law.name.data() << " over the closure, by its diameter over the"
            << " Sauter mean of its cells";
        if (law.cubic > 0)
        {
            Info<< ", of equal ones up to " << sixDigits(1 + law.cubic).c_str() << " times the closure's";
        }
        if (ratio > cohesion::drag::largest_mixed_ratio)
        {
            Info<< "; the law was fitted for ratios up to " << cohesion::drag::largest_mixed_ratio;
        }
    }
    else
    {
        Info<< "the closure's for its own diameter and the void fraction of its cells. That is no law for"
            << " mixtures: it may be off by a factor of about three at a size ratio of four. For one add an entry"
            << " dragMixture to constant/couplingProperties:";
        const char* between = " ";
        for (const auto& row : cohesion::drag::mixture_laws)
        {
            if (row.mixes)
            {
                Info<< between << row.name.data();
                between = " or ";
            }
        }
    }
    Info<< endl;
}

} // End anonymous namespace


void Foam::reportParticles
(
    const coupledParticles& particles,
    const scalar rho,
    const cohesion::drag::MixtureLaw& mixture,
    const cohesion::powder::Parcels& parcels
)
{
    const ParticleTotals all(particles);
    const bool sizes = all.diameter.wide();
    const bool densities = all.density.wide();
    Info<< "Particles: " << all.number << ", diameter " << all.diameter << " m";
    if (sizes)
    {
        Info<< ", Sauter mean " << sixDigits(all.sauter()).c_str() << " m";
    }
    Info<< ", density " << all.density << " kg/m3";
    if (densities)
    {
        Info<< ", mean " << sixDigits(all.meanDensity()).c_str() << " kg/m3";
    }
    // The lines between the groups are those of particles that are heavier than the gas.
    if (all.meanDensity() > rho)
    {
        Info<< "; by both" << (sizes || densities ? " means" : "") << ", in ambient air, Geldart's group "
            << char(cohesion::bed::geldart_group(all.meanDensity() - rho, parcels.drag_diameter(all.sauter())));
    }
    Info<< endl;
    if (parcels.ratio() > 1)
    {
        Info<< "    coarseGraining " << sixDigits(parcels.ratio()).c_str() << ": each sphere stands for "
            << sixDigits(parcels.grains()).c_str() << " grains of " << sixDigits(1/parcels.ratio()).c_str()
            << " of its diameter; drag and Geldart's group are theirs" << endl;
    }
    if (mixture.mixes || all.diameter.most > mixtureFrom*all.diameter.least)
    {
        reportMixture(all.diameter.most/all.diameter.least, mixture);
    }
}
