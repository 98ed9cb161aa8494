// SPDX-License-Identifier: GPL-3.0-or-later
// What the coupling prints: cells that are too dense, the balance of each step, where the time went.
#include "gasParticleCoupling.H"

#include "void_fraction/sphere_overlap.h"

#include "sixDigits.H"

using namespace cohesion;


void Foam::gasParticleCoupling::requireMinVoidFraction() const
{
    label tooDense = 0;
    scalar excess = 0;
    scalar lowest = GREAT;
    point where = point::max;
    forAll(voidFraction_, celli)
    {
        if (voidFraction_[celli] < minVoidFraction_)
        {
            ++tooDense;
            excess += (minVoidFraction_ - voidFraction_[celli])*volume(celli);
            if (voidFraction_[celli] < lowest)
            {
                lowest = voidFraction_[celli];
                where = mesh_.C()[celli];
            }
        }
    }
    if (!returnReduce(tooDense, sumOp<label>()))
    {
        return;
    }
    const scalar mine = lowest;
    reduce(tooDense, sumOp<label>());
    reduce(excess, sumOp<scalar>());
    reduce(lowest, minOp<scalar>());
    where = mine == lowest ? where : point::max;
    reduce(where, minOp<point>());
    const std::string overlap(void_fraction::SphereOverlap::name);

    FatalIOErrorInFunction(dict_)
        << tooDense << " cells have a void fraction below minVoidFraction = " << minVoidFraction_
        << "; the lowest is " << lowest << ", of the cell at " << where << nl
        << "    The solid beyond the limit is " << excess << " m3, " << 100*excess/spreadVolume_
        << " % of all particles; nothing is clipped. Cells of a few particle diameters cure it"
        << (dict_.get<word>("voidFraction") == overlap ? "" : ", voidFraction sphereOverlap")
        << ", or, in a bed twenty widths high and more, a" << (dict_.found("smoothingWidth") ? " larger" : "")
        << " smoothingWidth" << exit(FatalIOError);
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
        const scalar fraction = form_.gas_takes_all ? 1 : voidFraction_[celli];
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
