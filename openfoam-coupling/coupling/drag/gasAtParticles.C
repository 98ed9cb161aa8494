// SPDX-License-Identifier: GPL-3.0-or-later
#include "gasAtParticles.H"

#include "interpolationCellPoint.H"

#include "coupling/input/selectRow.H"

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
    const particleExchange& exchange
)
{
    const interpolationCellPoint<scalar> voidFractionAt(voidFraction);
    const interpolationCellPoint<vector> velocityAt(U);
    const labelList& cells = exchange.cells();
    const List<point>& positions = exchange.positions();
    scalarList voidFractions(cells.size(), Zero);
    List<vector> velocities(cells.size(), Zero);
    forAll(cells, k)
    {
        if (cells[k] >= 0)
        {
            // A mean of numbers up to 1 with weights that add up to 1 only to round-off
            voidFractions[k] = min(voidFractionAt.interpolate(positions[k], cells[k]), scalar(1));
            velocities[k] = velocityAt.interpolate(positions[k], cells[k]);
        }
    }
    voidFraction_ = exchange.sumParts(std::move(voidFractions));
    velocity_ = exchange.sumParts(std::move(velocities));
}


void Foam::gasAtParticles::set
(
    const volScalarField& voidFraction,
    const volVectorField& U,
    particleAveraging& averaging
)
{
    voidFraction_ = averaging.gather(voidFraction.primitiveField());
    velocity_ = averaging.gather(U.primitiveField());
    offset_.setSize(velocity_.size());
    offset_ = Zero;
    if (interpolated_)
    {
        const vectorField gathered(velocity_);
        interpolate(voidFraction, U, averaging.exchange());
        offset_ = velocity_ - gathered;
    }
}
