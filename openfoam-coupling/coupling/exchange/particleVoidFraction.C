// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleVoidFraction.H"

#include "sphere.h"
#include "void_fraction/sphere_overlap.h"
#include "void_fraction/void_fraction.h"

#include "coupling/checks/requireDimensions.H"
#include "coupling/exchange/cellVolume.H"
#include "coupling/input/readPositive.H"
#include "coupling/sixDigits.H"
#include "coupling/stability/rankOfLargest.H"

using namespace cohesion;


Foam::particleVoidFraction::particleVoidFraction
(
    const fvMesh& mesh,
    const dictionary& dict,
    const scalar& depthRatio
)
:
    mesh_(mesh),
    dict_(dict),
    depthRatio_(depthRatio),
    lowest_(dict.found("minVoidFraction") ? readPositive(dict, "minVoidFraction") : 0.2),
    field_
    (
        IOobject
        (
            "voidFraction",
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    )
{}


void Foam::particleVoidFraction::requireShares() const
{
    requireDimensions(field_, dimless, "a share of the volume, and is set from the particles");
    if (!(lowest_ < 1))
    {
        FatalIOErrorInFunction(dict_)
            << "minVoidFraction = " << lowest_ << ": must be below 1, the void fraction of a cell without"
            << " particles; 0.2 is usual" << exit(FatalIOError);
    }
}


void Foam::particleVoidFraction::setEmpty()
{
    field_.primitiveFieldRef() = 1;
    field_.correctBoundaryConditions();
}


void Foam::particleVoidFraction::set(const UList<scalar>& radii, particleAveraging& averaging)
{
    scalarField volumes(radii.size());
    forAll(volumes, i)
    {
        volumes[i] = sphere_volume(radii[i]);
    }
    spreadVolume_ = returnReduce(sum(volumes), sumOp<scalar>());
    const scalarField solid(averaging.spread(volumes));

    scalarField& voidFraction = field_.primitiveFieldRef();
    forAll(voidFraction, celli)
    {
        voidFraction[celli] =
            void_fraction::void_fraction(solid[celli], mesh_.V()[celli], depthRatio_);
    }
    requireLowest(radii);
    field_.correctBoundaryConditions();
}


Foam::particleVoidFraction::DenseCells Foam::particleVoidFraction::denseCells() const
{
    DenseCells dense;
    forAll(field_, celli)
    {
        if (field_[celli] < lowest_)
        {
            ++dense.count;
            dense.excess += (lowest_ - field_[celli])*cellVolume(mesh_, depthRatio_, celli);
            if (field_[celli] < dense.lowest)
            {
                dense.lowest = field_[celli];
                dense.lowestCell = celli;
            }
        }
    }
    return dense;
}


void Foam::particleVoidFraction::requireLowest(const UList<scalar>& radii) const
{
    const DenseCells dense(denseCells());
    const label count = returnReduce(dense.count, sumOp<label>());
    if (!count)
    {
        return;
    }
    const scalar excess = returnReduce(dense.excess, sumOp<scalar>());
    const scalar lowest = returnReduce(dense.lowest, minOp<scalar>());
    const bool mine = isRankOfLargest(-dense.lowest, -lowest);
    const point where = valueOfRank(mine, mine ? mesh_.C()[dense.lowestCell] : point::zero);
    const scalar size = valueOfRank(mine, mine ? mesh_.V()[dense.lowestCell] : 0);
    const label number = valueOfRank(mine, dense.lowestCell);
    const label rank = valueOfRank(mine, Pstream::myProcNo());
    const std::string whose(Pstream::parRun() ? " of rank " + std::to_string(rank) : "");
    const std::string remedy(cure(size, radii));

    FatalIOErrorInFunction(dict_)
        << count << " cells have a void fraction below minVoidFraction = " << lowest_
        << "; the lowest is " << lowest << ", of cell " << number << whose.c_str() << " at " << where << ", of "
        << sixDigits(size).c_str() << " m3" << nl
        << "    The solid beyond the limit is " << excess << " m3, " << 100*excess/spreadVolume_
        << " % of all particles; nothing is clipped. " << remedy.c_str() << exit(FatalIOError);
}


std::string Foam::particleVoidFraction::cure(const scalar size, const UList<scalar>& radii) const
{
    const std::string larger(dict_.found("smoothingWidth") ? "larger " : "");
    const scalar mean = gSum(mesh_.V().field())/mesh_.globalData().nTotalCells();
    if (size < 0.5*mean)
    {
        const scalar diameter = 2*gMax(scalarField(radii));
        return "The cell has " + sixDigits(100*size/mean) + " % of the mean cell volume, " + sixDigits(mean) + " m3: a"
            " cell that a wall or a refinement cuts this small may lie within particles. A " + larger
          + "smoothingWidth of one particle diameter, " + sixDigits(diameter) + " m, cures it, or,"
            " where such cells are few, a lower minVoidFraction; or larger cells at the wall";
    }
    const bool overlap = dict_.get<word>("voidFraction") == void_fraction::SphereOverlap::name;
    return std::string("Cells of a few particle diameters cure it") + (overlap ? "" : ", voidFraction sphereOverlap")
      + ", or, in a bed twenty widths high and more, a " + larger + "smoothingWidth";
}
