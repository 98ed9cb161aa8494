// SPDX-License-Identifier: GPL-3.0-or-later
#include "inletVoidFraction.H"

#include "volFields.H"

#include "boundary-conditions/superficialVelocityFvPatchVectorField.H"

namespace
{

//- The resistance between cell and patch goes with 1/eps^2 or 1/eps (pEqn.H): where both void fractions differ by
//  less, by less than a tenth in dilute flow, where a patch without particles is meant
constexpr Foam::scalar worthSaying = 0.05;

bool jets(const Foam::fvPatchVectorField& U)
{
    using Foam::superficialVelocityFvPatchVectorField;
    return
        Foam::isA<superficialVelocityFvPatchVectorField>(U)
     && Foam::refCast<const superficialVelocityFvPatchVectorField>(U).share() < 1;
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
    DynamicList<word> names;
    DynamicList<scalar> differences;
    for (const label patchi : patches_)
    {
        const auto& values = voidFraction.boundaryField()[patchi];
        const auto& velocity = U.boundaryField()[patchi];
        if (jets(velocity))
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
        if (sums[2] > 0 && off > worthSaying)
        {
            names.append(values.patch().name());
            differences.append(off);
        }
        else
        {
            left.append(patchi);
        }
    }
    patches_.transfer(left);
    if (names.size())
    {
        WarningInFunction
            << "the case fixes the void fraction of the patches " << flatOutput(names) << ", and that of the cells"
            << " at them differs by " << flatOutput(differences) << " in the mean: particles are there. The last"
            << " half cell resists as with the void fraction of the patch, and the pressure on the patch is off by"
            << " that. It is meant for jets in a plate that is closed between them (superficialVelocity with a"
            << " share below 1). Where gas comes through all of a patch, take 'type zeroGradient;' in the file"
            << " voidFraction, and superficialVelocity in U. This is said once for each patch" << endl;
    }
}
