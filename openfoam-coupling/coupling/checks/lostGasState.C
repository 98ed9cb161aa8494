// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "PstreamReduceOps.H"

#include "drag/gas_on_particle.h"

namespace
{

//- Whether a gas step has acted on the particle. The coefficient alone may be 0: without slip, in a quadratic law.
bool felt(const cohesion::drag::GasOnParticle& gas)
{
    const auto any = [](const double (&of)[3]) { return of[0] != 0 || of[1] != 0 || of[2] != 0; };
    return gas.drag_coefficient != 0 || any(gas.velocity) || any(gas.pressure_gradient);
}

} // End anonymous namespace


void Foam::warnOfLostGasState(const dictionary& dict, cohesion::coupling::DemEngine& engine)
{
    const label n = engine.particles().count;
    const cohesion::drag::GasOnParticle* const gas = engine.gas();
    bool found = false;
    for (label i = 0; gas && i < n && !found; ++i)
    {
        found = felt(gas[i]);
    }
    if (returnReduce(n, sumOp<label>()) == 0 || returnReduce(found, orOp<bool>()))
    {
        return;
    }
    IOWarningInFunction(dict)
        << "the particle script has lost the forces of the gas that its restart file contains: the continued run"
        << " differs slightly from one that was not interrupted" << nl
        << "    Put 'fix gas/coupling' before any 'run' of the script: 'run' discards the state of fixes that are not"
        << " defined yet" << endl;
}
