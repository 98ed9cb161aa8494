// SPDX-License-Identifier: GPL-3.0-or-later
// What the coupling prints: cells that are too dense, the balance of each step, where the time went.
#include "gasParticleCoupling.H"

#include "void_fraction/sphere_overlap.h"

#include "sixDigits.H"
#include "stability/rankOfLargest.H"

#include <string>

using namespace cohesion;


void Foam::gasParticleCoupling::requireMinVoidFraction() const
{
    label tooDense = 0;
    scalar excess = 0;
    scalar lowest = GREAT;
    label lowestCell = -1;
    forAll(voidFraction_, celli)
    {
        if (voidFraction_[celli] < minVoidFraction_)
        {
            ++tooDense;
            excess += (minVoidFraction_ - voidFraction_[celli])*volume(celli);
            if (voidFraction_[celli] < lowest)
            {
                lowest = voidFraction_[celli];
                lowestCell = celli;
            }
        }
    }
    if (!returnReduce(tooDense, sumOp<label>()))
    {
        return;
    }
    const scalar ofRank = lowest;
    reduce(lowest, minOp<scalar>());
    const bool mine = isRankOfLargest(-ofRank, -lowest);
    const point where = valueOfRank(mine, mine ? mesh_.C()[lowestCell] : point::zero);
    const scalar size = valueOfRank(mine, mine ? mesh_.V()[lowestCell] : 0);
    const label number = valueOfRank(mine, lowestCell);
    const label rank = valueOfRank(mine, Pstream::myProcNo());
    reduce(tooDense, sumOp<label>());
    reduce(excess, sumOp<scalar>());
    const std::string whose(Pstream::parRun() ? " of rank " + std::to_string(rank) : "");
    const std::string cure(denseCellCure(size));

    FatalIOErrorInFunction(dict_)
        << tooDense << " cells have a void fraction below minVoidFraction = " << minVoidFraction_
        << "; the lowest is " << lowest << ", of cell " << number << whose.c_str() << " at " << where << ", of "
        << sixDigits(size).c_str() << " m3" << nl
        << "    The solid beyond the limit is " << excess << " m3, " << 100*excess/spreadVolume_
        << " % of all particles; nothing is clipped. " << cure.c_str() << exit(FatalIOError);
}


std::string Foam::gasParticleCoupling::denseCellCure(const scalar size) const
{
    const std::string larger(dict_.found("smoothingWidth") ? "larger " : "");
    const scalar mean = gSum(mesh_.V().field())/mesh_.globalData().nTotalCells();
    if (size < 0.5*mean)
    {
        const scalar diameter = 2*gMax(scalarField(coupledParticles_.radii()));
        return "The cell has " + sixDigits(100*size/mean) + " % of the mean cell volume, " + sixDigits(mean) + " m3: a"
            " cell that a wall or a refinement cuts this small may lie within particles. A " + larger
          + "smoothingWidth of one particle diameter, " + sixDigits(diameter) + " m, cures it, or,"
            " where such cells are few, a lower minVoidFraction; or larger cells at the wall";
    }
    const bool overlap = dict_.get<word>("voidFraction") == void_fraction::SphereOverlap::name;
    return std::string("Cells of a few particle diameters cure it") + (overlap ? "" : ", voidFraction sphereOverlap")
      + ", or, in a bed twenty widths high and more, a " + larger + "smoothingWidth";
}


void Foam::gasParticleCoupling::reportBalance
(
    const volVectorField& U,
    const volVectorField& gradP,
    const vector& deferredBefore
) const
{
    const scalar dt = mesh_.time().deltaTValue();

    // The gas, from the terms of its own equation. Of the mixture's eps rho g - grad p it takes
    // s (rho g - grad p); the rest is what the particles must have been given.
    vector gasDrag = Zero;
    vector gasPressure = Zero;
    scalar solidDeposited = 0;
    forAll(U, celli)
    {
        const scalar fraction = form_.shares_pressure ? voidFraction_[celli] : 1;
        gasDrag +=
            (
                (dragSource_[celli] - dragRate_[celli]*U[celli])*rho_
              - transmittedFraction_[celli]*gradP[celli]
            )*volume(celli)*dt;
        if (liquid_.active())
        {
            gasDrag += liquid_.onCell(celli, U[celli], dt)*rho_*volume(celli)*dt;
        }
        gasPressure +=
            (
                (1 - fraction)*gradP[celli]
              + (fraction - voidFraction_[celli])*rho_*density_.ratio(celli)*g_
            )*volume(celli)*dt;
        solidDeposited += (1 - voidFraction_[celli])*volume(celli);
    }

    // The particles, from the engine's own sum of the forces it put on
    const auto felt = engine_->gas_impulse();
    vector drag(felt.drag[0], felt.drag[1], felt.drag[2]);
    vector pressure(felt.pressure[0], felt.pressure[1], felt.pressure[2]);
    vector deferred = sum(deferredImpulse()) - deferredBefore;

    reduce(gasDrag, sumOp<vector>());
    reduce(gasPressure, sumOp<vector>());
    reduce(drag, sumOp<vector>());
    reduce(pressure, sumOp<vector>());
    reduce(deferred, sumOp<vector>());
    reduce(solidDeposited, sumOp<scalar>());

    const scalar size = mag(drag) + mag(pressure) + VSMALL;
    Info<< "Exchange: drag on particles " << drag/dt << " N, pressure " << pressure/dt
        << " N, not yet charged to the gas " << deferred/dt
        << " N, imbalance "
        << mag(gasDrag + drag - deferred + gasPressure + pressure + turnover_.undelivered())/size
        << ", solid volume error " << mag(solidDeposited - spreadVolume_)/max(spreadVolume_, VSMALL) << endl;
}


void Foam::gasParticleCoupling::report(const scalar total)
{
    kept_.end();
    turnover_.report(*engine_);
    monitor_.report();
    bound_.report();
    if (Pstream::parRun())
    {
        averaging_.exchange().traffic().report();
    }

    scalar particles = seconds_.particles;
    scalar exchange = seconds_.exchange;
    reduce(particles, maxOp<scalar>());
    reduce(exchange, maxOp<scalar>());

    const auto row = [total](const char* name, const scalar seconds)
    {
        Info<< "    " << name << sixDigits(seconds).c_str() << " s, " << sixDigits(100*seconds/total).c_str() << " %"
            << nl;
    };
    Info<< nl << "Where the time went (" << Pstream::nProcs() << " ranks)" << nl;
    row("particles  ", particles);
    row("gas        ", total - particles - exchange);
    row("exchange   ", exchange);
    row("all        ", total);
    Info<< endl;
}
