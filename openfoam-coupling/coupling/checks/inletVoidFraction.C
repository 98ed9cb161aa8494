// SPDX-License-Identifier: GPL-3.0-or-later
#include "inletVoidFraction.H"

#include "vector2D.H"
#include "volFields.H"

#include "boundary-conditions/superficialVelocityFvPatchVectorField.H"

namespace
{

//- Dilute flow that comes in without particles: the resistance between cell and patch, which goes with 1/eps^2 in
//  form A and 1/eps in B (pEqn.H), is less than a tenth off
constexpr Foam::scalar worthSaying = 0.05;

//- A patch blows as one of several jets when its gas is faster than if all that faces as it does blew alike, by this
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
        const auto& share = voidFraction.boundaryField()[i];
        const vectorField& faces = velocity.patch().Sf();
        forAll(velocity, k)
        {
            const scalar area = faces[k] & outwards;
            if (area > 0)
            {
                const vector2D one(area, share[k]*(velocity[k] & faces[k]));
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
            patches_.append(values.patch().index());
        }
    }
}


void Foam::inletVoidFraction::look(const volScalarField& voidFraction, const volVectorField& U)
{
    DynamicList<label> left;
    OStringStream said;
    for (const label patchi : patches_)
    {
        const auto& values = voidFraction.boundaryField()[patchi];
        const auto& velocity = U.boundaryField()[patchi];
        if (hasShare(velocity))
        {
            continue;
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
        if (sums[2] > 0 && off > worthSaying && !isJet(patchi, voidFraction, U))
        {
            said<< (said.str().empty() ? "" : ", ") << values.patch().name() << " (" << off << ')';
        }
        else
        {
            left.append(patchi);
        }
    }
    patches_.transfer(left);
    if (said.str().size())
    {
        WarningInFunction
            << "particles are at patches where the case fixes another void fraction than that of the cells beside"
            << " them; by how much, in the mean: " << said.str().c_str() << nl
            << "    On its last half cell the gas then resists and accelerates as with the void fraction of the patch,"
            << " and the pressure on the patch, with a pressure drop that is taken from there, is off. That is meant"
            << " for jets in a plate that is closed between them, on a patch of their own or by superficialVelocity"
            << " with a share below 1. Where gas comes through all of a patch take 'type zeroGradient;' in the file"
            << " voidFraction, and superficialVelocity in U; this is said once for each patch" << endl;
    }
}
