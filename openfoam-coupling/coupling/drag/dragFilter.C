// SPDX-License-Identifier: GPL-3.0-or-later
#include "dragFilter.H"

#include "coupling/drag/cellSizes.H"
#include "coupling/input/selectRow.H"

using namespace cohesion;


Foam::dragFilter::dragFilter(const dictionary& dict, const fvMesh& mesh, const scalar mu, const scalar g)
:
    law_(selectRow(dict, "dragFilter", drag::drag_filters, "none")),
    mu_(mu),
    g_(g),
    grain_{0, 0},
    rho_(0),
    length_(0)
{
    if (!active())
    {
        return;
    }
    if (!(g > 0))
    {
        FatalIOErrorInFunction(dict)
            << "dragFilter " << law_.name.data() << " goes by the speed at which grains fall, and constant/g is zero:"
            << " remove the entry" << exit(FatalIOError);
    }
    sizes_ = cellSizes(mesh);
    Info<< "Drag filtered by dragFilter " << law_.name.data() << ", in cells of " << gMin(sizes_) << " to "
        << gMax(sizes_) << " m" << endl;
}


Foam::scalar Foam::dragFilter::lengthOf(const powder::Grain& grain, const scalar rho) const
{
    if (grain.diameter != grain_.diameter || grain.density != grain_.density || rho != rho_)
    {
        try
        {
            length_ = drag::filter_length(powder::terminal_speed(grain, {rho, mu_}, g_), grain.diameter, g_);
        }
        catch (const InvalidParameter& error)
        {
            FatalErrorInFunction << "dragFilter " << law_.name.data() << ": " << error.what() << exit(FatalError);
        }
        grain_ = grain;
        rho_ = rho;
    }
    return length_;
}


Foam::scalar Foam::dragFilter::factor
(
    const label i,
    const scalar voidFraction,
    const powder::Grain& grain,
    const scalar rho
) const
{
    return law_.factor(1 - voidFraction, sizeAt_[i]/lengthOf(grain, rho));
}
