// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizesAtParticles.H"


void Foam::sizesAtParticles::set
(
    const UList<scalar>& radii,
    const scalarField& cellVolumes,
    particleAveraging& averaging
)
{
    scalarField power(radii.size());
    forAll(power, i)
    {
        power[i] = sqr(2*radii[i]);
    }
    for (scalarField& sums : sums_)
    {
        sums = averaging.gather(scalarField(averaging.spread(power)/cellVolumes));
        forAll(power, i)
        {
            power[i] *= 2*radii[i];
        }
    }
}
