// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "mixedFvPatchFields.H"
#include "volFields.H"

#include "coupling/sixDigits.H"


void Foam::requireFreePressure(const volScalarField& p, const volVectorField& U)
{
    for (const auto& values : p.boundaryField())
    {
        const auto& velocity = U.boundaryField()[values.patch().index()];
        // Mixed conditions, those of a free stream, change from one kind to the other.
        const bool given = values.fixesValue() && !values.coupled() && !isA<mixedFvPatchScalarField>(values);
        if (given && !velocity.assignable())
        {
            FatalErrorInFunction
                << "patch " << values.patch().name() << ": the file p gives the pressure, by type " << values.type()
                << ", and the file U the flux, by type " << velocity.type() << ": the pressure would drive gas through"
                << " the patch beside that of U" << nl
                << "    At inlets and walls take 'type fixedFluxPressure; value uniform 0;' in the file p; where the"
                << " pressure is to be given, 'type pressureInletOutletVelocity; value uniform (0 0 0);' in the file U"
                << exit(FatalError);
        }
    }
}


void Foam::requireShareOfVolume(const volScalarField& voidFraction)
{
    // Round-off of what a run has written
    constexpr scalar tolerance = 1e-9;
    for (const auto& values : voidFraction.boundaryField())
    {
        // Ranks differ in their coupled patches.
        if (values.coupled())
        {
            continue;
        }
        const scalar lowest = returnReduce(min(values), minOp<scalar>());
        const scalar highest = returnReduce(max(values), maxOp<scalar>());
        if (!(lowest > 0 && highest <= 1 + tolerance))
        {
            FatalErrorInFunction
                << "patch " << values.patch().name() << ": the void fraction is "
                << sixDigits(lowest > 0 ? highest : lowest).c_str() << ", by type " << values.type() << " in "
                << voidFraction.objectPath().c_str() << "; it is a share of the volume, above 0 and at most 1" << nl
                << "    Take 'type zeroGradient;', or 'type fixedValue; value uniform 1;' for jets in a closed plate"
                << exit(FatalError);
        }
    }
}
