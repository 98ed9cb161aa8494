// SPDX-License-Identifier: GPL-3.0-or-later
// What the coupling prints: the balance of each step, where the time went.
#include "gasParticleCoupling.H"

#include "coupling/exchange/cellVolume.H"
#include "coupling/exchange/exchangeTraffic.H"
#include "sixDigits.H"

using namespace cohesion;


Foam::gasParticleCoupling::GasTotals Foam::gasParticleCoupling::gasTotals
(
    const volVectorField& U,
    const volVectorField& gradP
) const
{
    // From the terms of the gas's own equation. Of the mixture's eps rho g - grad p it takes s (rho g - grad p); the
    // rest is what the particles must have been given.
    const scalar dt = mesh_.time().deltaTValue();
    GasTotals totals;
    forAll(U, celli)
    {
        const scalar volume = cellVolume(mesh_, depthRatio_, celli);
        const scalar eps = voidFraction()[celli];
        const scalar fraction = form_.shares_pressure ? eps : 1;
        totals.drag += sources_.dragOnGas(celli, U[celli], gradP[celli])*volume*dt;
        if (liquid_.active())
        {
            totals.drag += liquid_.onCell(celli, U[celli], dt)*rho_*volume*dt;
        }
        totals.pressure +=
            (
                (1 - fraction)*gradP[celli]
              + (fraction - eps)*rho_*density_.ratio(celli)*g_
            )*volume*dt;
        totals.solid += (1 - eps)*volume;
    }
    reduce(totals.drag, sumOp<vector>());
    reduce(totals.pressure, sumOp<vector>());
    reduce(totals.solid, sumOp<scalar>());
    return totals;
}


void Foam::gasParticleCoupling::reportBalance
(
    const volVectorField& U,
    const volVectorField& gradP,
    const vector& deferredBefore
) const
{
    const scalar dt = mesh_.time().deltaTValue();
    const GasTotals gas(gasTotals(U, gradP));

    // The particles, from the engine's own sum of the forces it put on
    const auto felt = engine_->gas_impulse();
    vector drag(felt.drag[0], felt.drag[1], felt.drag[2]);
    vector pressure(felt.pressure[0], felt.pressure[1], felt.pressure[2]);
    vector deferred = sum(deferredImpulse()) - deferredBefore;

    reduce(drag, sumOp<vector>());
    reduce(pressure, sumOp<vector>());
    reduce(deferred, sumOp<vector>());

    const scalar size = mag(drag) + mag(pressure) + VSMALL;
    Info<< "Exchange: drag on particles " << drag/dt << " N, pressure " << pressure/dt
        << " N, not yet charged to the gas " << deferred/dt
        << " N, imbalance "
        << mag(gas.drag + drag - deferred + gas.pressure + pressure + turnover_.undelivered())/size
        << ", solid volume error " << voidFraction_.errorOf(gas.solid) << endl;
}


void Foam::gasParticleCoupling::report(const scalar total)
{
    kept_.end();
    turnover_.report(*engine_);
    monitor_.report();
    bound_.report();
    if (Pstream::parRun())
    {
        exchangeTraffic::ofRank().report();
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
