// SPDX-License-Identifier: GPL-3.0-or-later
#include "gasAtParticles.H"

#include "interpolationCellPoint.H"

#include "selectRow.H"

#include <array>

namespace
{

struct Slip
{
    std::string_view name;
    bool interpolated;
};

constexpr std::array slips{Slip{"cell", false}, Slip{"interpolated", true}};

} // End anonymous namespace


Foam::gasAtParticles::gasAtParticles(const dictionary& dict)
:
    interpolated_(selectRow(dict, "slip", slips, "cell").interpolated)
{}


void Foam::gasAtParticles::interpolate
(
    const volScalarField& voidFraction,
    const volVectorField& U,
    const labelUList& cells,
    const UList<point>& positions
)
{
    const interpolationCellPoint<scalar> voidFractionAt(voidFraction);
    const interpolationCellPoint<vector> velocityAt(U);
    voidFraction_.setSize(cells.size());
    offset_.setSize(cells.size());
    forAll(cells, i)
    {
        const label celli = cells[i];
        // A mean of numbers up to 1 with weights that add up to 1 only to round-off
        voidFraction_[i] =
            min(voidFractionAt.interpolate(positions[i], celli), scalar(1));
        offset_[i] = velocityAt.interpolate(positions[i], celli) - U[celli];
    }
}
