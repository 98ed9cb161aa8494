// SPDX-License-Identifier: GPL-3.0-or-later
#include "courantLimit.H"

#include "coupling/sixDigits.H"

namespace
{

//- Courant number of the gas, in steps of one length, above which there is a warning. One is advised (maxCo); bubbles
//  that burst are faster for a moment.
constexpr Foam::scalar largestCourant = 2;

} // End anonymous namespace


void Foam::courantLimit::check(const Time& time, const scalar courant)
{
    if (!due() || !(courant > largestCourant))
    {
        return;
    }
    WarningOnceInFunction(warning_)
        << "the Courant number of the gas is " << sixDigits(courant).c_str() << " at time " << time.timeName()
        << ": in a step of deltaT = " << time.deltaTValue() << " s it crosses that many cells, and what it does"
        << " within fewer is lost" << nl
        << "    Take a deltaT of at most " << sixDigits(time.deltaTValue()/courant).c_str()
        << " s, or 'adjustTimeStep yes; maxCo 1;' in system/controlDict; printed once" << endl;
}
