// SPDX-License-Identifier: GPL-3.0-or-later
#include "inletVoidFraction.H"

#include "vector2D.H"
#include "volFields.H"

#include "boundary-conditions/superficialVelocityFvPatchVectorField.H"

namespace
{

//- Difference of the void fractions, up to which there is no warning. Dilute flow that comes in without particles
//  has less: the resistance between cell and patch, which goes with 1/eps^2 in form A and 1/eps in B (pEqn.H), is
//  less than a tenth off.
constexpr Foam::scalar warnAbove = 0.05;

//- A patch blows as one of several jets when its gas is faster by this factor than if all that faces as the patch
//  does blew alike.
constexpr Foam::scalar jetsFrom = 1/0.9;


//- Whether a patch is one of jets, as its share says
bool hasShare(const Foam::fvPatchVectorField& U)
{
    using Foam::superficialVelocityFvPatchVectorField;
    return
        Foam::isA<superficialVelocityFvPatchVectorField>(U)
     && Foam::refCast<const superficialVelocityFvPatchVectorField>(U).share() < 1;
}


//- Whether a patch is a jet by itself in a boundary that is closed beside it, or blows less. All ranks call it.
bool isJet(const Foam::label patchi, const Foam::volScalarField& voidFraction, const Foam::volVectorField& U)
{
    using namespace Foam;
    vector outwards(sum(U.boundaryField()[patchi].patch().Sf()));
    reduce(outwards, sumOp<vector>());
    outwards.normalise();

    // Area and volume of gas per time, of the patch and of all that faces as it does
    vector2D own(Zero);
    vector2D all(Zero);
    forAll(U.boundaryField(), i)
    {
        const auto& velocity = U.boundaryField()[i];
        if (velocity.coupled())
        {
            continue;
        }
        const auto& eps = voidFraction.boundaryField()[i];
        const vectorField& faces = velocity.patch().Sf();
        forAll(velocity, k)
        {
            const scalar area = faces[k] & outwards;
            if (area > 0)
            {
                const vector2D one(area, eps[k]*(velocity[k] & faces[k]));
                all += one;
                own += i == patchi ? one : vector2D(Zero);
            }
        }
    }
    reduce(own, sumOp<vector2D>());
    reduce(all, sumOp<vector2D>());
    return mag(own.y())*all.x() > jetsFrom*mag(all.y())*own.x();
}

} // End anonymous namespace


Foam::inletVoidFraction::inletVoidFraction(const volScalarField& voidFraction)
{
    for (const auto& values : voidFraction.boundaryField())
    {
        if (values.fixesValue() && !values.coupled())
        {
            inlets_.append(FixedVoidFraction{values.patch().index(), {}});
        }
    }
}


Foam::scalar Foam::inletVoidFraction::difference
(
    const label patchi,
    const volScalarField& voidFraction,
    const volVectorField& U
)
{
    const auto& values = voidFraction.boundaryField()[patchi];
    const auto& velocity = U.boundaryField()[patchi];
    if (hasShare(velocity))
    {
        return 0;
    }
    const scalarField& areas = values.patch().magSf();
    vector sums
    (
        sum(areas),
        sum(areas*mag(values - values.patchInternalField())),
        sum(mag(velocity & values.patch().Sf()))
    );
    reduce(sums, sumOp<vector>());
    const scalar off = sums[1]/max(sums[0], VSMALL);
    return sums[2] > 0 && off > warnAbove && !isJet(patchi, voidFraction, U) ? off : 0;
}


void Foam::inletVoidFraction::check(const volScalarField& voidFraction, const volVectorField& U)
{
    onceWarning* first = nullptr;
    OStringStream patches;
    for (FixedVoidFraction& inlet : inlets_)
    {
        if (!inlet.warning.due())
        {
            continue;
        }
        const scalar off = difference(inlet.patch, voidFraction, U);
        if (off > 0)
        {
            patches
                << (first ? ", " : "") << voidFraction.boundaryField()[inlet.patch].patch().name()
                << " (" << off << ')';
            first = first ? first : &inlet.warning;
            inlet.warning.skip();
        }
    }
    if (first)
    {
        warn(*first, patches.str());
    }
}


void Foam::inletVoidFraction::warn(onceWarning& warning, const string& patches)
{
    WarningOnceInFunction(warning)
        << "particles are at patches where the case fixes another void fraction than that of the cells beside"
        << " them; by how much, in the mean: " << patches.c_str() << nl
        << "    On its last half cell the gas then resists and accelerates as with the void fraction of the patch,"
        << " and the pressure on the patch, with a pressure drop that is taken from there, is off. That is meant"
        << " for jets in a plate that is closed between them, on a patch of their own or by superficialVelocity"
        << " with a share below 1. Where gas comes through all of a patch take 'type zeroGradient;' in the file"
        << " voidFraction, and superficialVelocity in U; printed once for each patch" << endl;
}
