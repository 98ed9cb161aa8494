// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleDrag.H"

#include "drag/stokes_scaled.h"
#include "sphere.h"

#include "coupling/input/readDragLaw.H"
#include "coupling/input/selectRow.H"

using namespace cohesion;

namespace
{

powder::Parcels readParcels(const Foam::dictionary& dict)
{
    try
    {
        return powder::Parcels(dict.getOrDefault<Foam::scalar>("coarseGraining", 1));
    }
    catch (const InvalidParameter& error)
    {
        FatalIOErrorInFunction(dict) << "coarseGraining: " << error.what() << Foam::exit(Foam::FatalIOError);
        throw;
    }
}

//- Drag over what the closure says, of a sphere of this mass [kg] and radius [m] in a fluid of density rho [1]
Foam::scalar ofDensities
(
    const drag::DragLaw& law,
    const Foam::scalar mass,
    const Foam::scalar radius,
    const Foam::scalar rho
)
{
    if (!law.closure().of_densities)
    {
        return 1;
    }
    try
    {
        return law.of_densities(mass/sphere_volume(radius), rho);
    }
    catch (const InvalidParameter& error)
    {
        FatalErrorInFunction << error.what() << Foam::exit(Foam::FatalError);
        throw;
    }
}

} // End anonymous namespace


Foam::particleDrag::particleDrag(const dictionary& dict, const scalar mu)
:
    law_(readDragLaw(dict, selectRow(dict, "drag", drag::all_closures))),
    mixture_(selectRow(dict, "dragMixture", drag::mixture_laws, "none")),
    parcels_(readParcels(dict)),
    mu_(mu)
{}


Foam::particleDrag::Drag Foam::particleDrag::operator()
(
    const DragConditions& sphere,
    const drag::ModelForm& form
) const
{
    const auto& [voidFraction, slip, radius, rho, mass] = sphere;
    const scalar d = parcels_.drag_diameter(2*radius);
    return
    {
        parcels_.grains()*law_.coefficient(voidFraction, slip, d, rho, mu_)*form.drag_over_a(voidFraction)
       *ofDensities(law_, mass, radius, rho),
        drag::superficial_reynolds(voidFraction, slip, d, rho, mu_)
    };
}


Foam::particleDrag::Drag Foam::particleDrag::operator()
(
    const DragConditions& sphere,
    const drag::ModelForm& form,
    const drag::SizesAround& around
) const
{
    const auto& [voidFraction, slip, radius, rho, mass] = sphere;
    const scalar mixed = form.mixed_drag(mixture_, voidFraction, 2*radius, around);
    const scalar d = parcels_.drag_diameter(2*radius);
    const scalar sauter = parcels_.drag_diameter(around.sauter);
    if (!(mixed > 0))
    {
        FatalErrorInFunction
            << "dragMixture " << mixture_.name.data() << " gives a sphere of " << 2*radius << " m no drag: around it"
            << " are spheres of a Sauter mean of " << around.sauter << " m and a spread <d^4>/(<d^2> <d>^2) of "
            << around.spread << ", far beyond sizes of a ratio of four, which it was fitted for" << nl
            << "    Take dragMixture carmanKozeny" << exit(FatalError);
    }
    return
    {
        parcels_.grains()*law_.coefficient_among(mixed, sauter, voidFraction, slip, d, rho, mu_)
       *form.drag_over_a(voidFraction)*ofDensities(law_, mass, radius, rho),
        drag::superficial_reynolds(voidFraction, slip, sauter, rho, mu_)
    };
}
