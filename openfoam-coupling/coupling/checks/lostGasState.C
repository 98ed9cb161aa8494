// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "PstreamReduceOps.H"

#include "drag/gas_on_particle.h"


void Foam::warnOfLostGasState(const dictionary& dict, cohesion::coupling::DemEngine& engine)
{
    const label n = engine.particles().count;
    const cohesion::drag::GasOnParticle* const gas = engine.gas();
    bool found = false;
    for (label i = 0; gas && i < n && !found; ++i)
    {
        // The drag coefficient of a particle that a gas step has moved is above zero.
        found = gas[i].drag_coefficient > 0;
    }
    if (returnReduce(n, sumOp<label>()) == 0 || returnReduce(found, orOp<bool>()))
    {
        return;
    }
    IOWarningInFunction(dict)
        << "the particle script has lost the forces of the gas that its restart file contains: the continued run differs"
        << " slightly from one that was not interrupted" << nl
        << "    Put 'fix gas/coupling' before any 'run' of the script: 'run' discards the state of fixes that are not"
        << " defined yet" << endl;
}
