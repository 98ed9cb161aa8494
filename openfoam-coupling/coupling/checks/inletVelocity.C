// SPDX-License-Identifier: GPL-3.0-or-later
#include "inletVelocity.H"

#include "volFields.H"
#include "wallPolyPatch.H"

#include "boundary-conditions/superficialVelocityFvPatchVectorField.H"
#include "coupling/sixDigits.H"

namespace
{

//- Normal over whole velocity, up to which a velocity lies in the plane of its patch: numbers of six digits
constexpr Foam::scalar inPlane = 1e-5;

//- Void fraction at a patch, from which on the velocity between the particles is nearly the superficial one
constexpr Foam::scalar nearlyEmpty = 0.9;


//- The superficial velocity that a patch has by its type; else null
const Foam::superficialVelocityFvPatchVectorField* superficial(const Foam::fvPatchVectorField& U)
{
    using Type = Foam::superficialVelocityFvPatchVectorField;
    return Foam::isA<Type>(U) ? &Foam::refCast<const Type>(U) : nullptr;
}


//- Mean over the area of a patch. All ranks call it.
Foam::vector mean(const Foam::vectorField& values, const Foam::scalarField& areas)
{
    return Foam::gSum(Foam::vectorField(areas*values))/Foam::max(Foam::gSum(areas), Foam::VSMALL);
}

} // End anonymous namespace


Foam::inletVelocity::inletVelocity(const volScalarField& voidFraction)
{
    for (const auto& values : voidFraction.boundaryField())
    {
        const polyPatch& patch = values.patch().patch();
        if (!values.coupled() && !isA<wallPolyPatch>(patch))
        {
            inlets_.append(VelocityInlet{patch.index(), {}, {}});
        }
    }
}


void Foam::inletVelocity::checkAlongPlane(VelocityInlet& inlet, const volVectorField& U)
{
    const auto& values = U.boundaryField()[inlet.patch];
    const auto* byFlux = superficial(values);
    // The value of that type is known from the first step on.
    const vectorField velocity
    (
        byFlux ? vectorField(values.size(), byFlux->velocity()) : static_cast<const vectorField&>(values)
    );
    const scalarField& areas = values.patch().magSf();
    const scalar passing = gSum(scalarField(mag(velocity & values.patch().Sf())));
    const scalar moving = gSum(scalarField(areas*mag(velocity)));
    if (!(moving > 0) || passing > inPlane*moving)
    {
        return;
    }
    // Without zeros of a negative sign
    const vector inwards = vector::zero - mean(vectorField(values.patch().nf()), areas);
    const vector given = mean(velocity, areas);
    WarningOnceInFunction(inlet.alongPlane)
        << "patch " << values.patch().name() << ": the velocity in the file U, " << sixDigits(given).c_str()
        << " m/s, lies in the plane of the patch, so that no gas passes" << nl
        << "    Gas that is to enter needs a component along " << sixDigits(inwards).c_str()
        << "; where the patch is meant as a moving wall, make it one of type wall" << endl;
}


void Foam::inletVelocity::checkBetweenParticles
(
    VelocityInlet& inlet,
    const volScalarField& voidFraction,
    const volVectorField& U
)
{
    const auto& values = U.boundaryField()[inlet.patch];
    if (superficial(values))
    {
        return;
    }
    const scalarField entering(max(-(values & values.patch().Sf()), scalar(0)));
    const scalar all = gSum(entering);
    const scalar share = gSum(scalarField(voidFraction.boundaryField()[inlet.patch]*entering))/max(all, VSMALL);
    if (!(all > 0) || share > nearlyEmpty)
    {
        return;
    }
    const vector given = mean(values, values.patch().magSf());
    WarningOnceInFunction(inlet.betweenParticles)
        << "patch " << values.patch().name() << ": gas enters with the velocity " << sixDigits(given).c_str()
        << " m/s between the particles, by type " << values.type() << " in the file U, and the void fraction there is "
        << sixDigits(share).c_str() << ": its superficial velocity is " << sixDigits(share*given).c_str() << " m/s"
        << nl << "    Where the given velocity is meant as the superficial one, take 'type superficialVelocity;"
        << " superficialVelocity " << sixDigits(given).c_str() << ";'; printed once for each patch" << endl;
}


void Foam::inletVelocity::check(const volScalarField& voidFraction, const volVectorField& U)
{
    for (VelocityInlet& inlet : inlets_)
    {
        if (const auto* byFlux = superficial(U.boundaryField()[inlet.patch]))
        {
            byFlux->requireVoidFraction();
        }
        if (!U.boundaryField()[inlet.patch].fixesValue())
        {
            continue;
        }
        if (inlet.alongPlane.due())
        {
            checkAlongPlane(inlet, U);
        }
        if (inlet.betweenParticles.due())
        {
            checkBetweenParticles(inlet, voidFraction, U);
        }
    }
}
