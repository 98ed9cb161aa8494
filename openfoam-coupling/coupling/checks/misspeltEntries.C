// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "Time.H"

#include "coupling/input/knownEntries.H"

namespace
{

//- What decides how the gas is solved
const Foam::Keywords pimpleWords
{
    {"nCorrectors"}, {"nOuterCorrectors"}, {"nNonOrthogonalCorrectors"}, {"momentumPredictor"},
    {"turbOnFinalIterOnly"}, {"pRefCell"}, {"pRefPoint"}, {"pRefValue"}
};

const Foam::Keywords controlWords{{"adjustTimeStep"}, {"maxCo"}, {"maxDeltaT"}};

//- Of other solvers
const Foam::Keywords otherControlWords{{"minDeltaT"}, {"maxDi"}};

const Foam::Keywords transportWords{{"transportModel"}, {"density"}, {"idealGas"}, {"rho"}, {"nu"}};

} // End anonymous namespace


void Foam::warnOfMisspeltEntries(const Time& time, const dictionary& pimple, const dictionary& transportProperties)
{
    warnOfMisspeltEntries(pimple, pimpleWords);
    warnOfMisspeltEntries(time.controlDict(), controlWords, otherControlWords);
    warnOfMisspeltEntries(transportProperties, transportWords);
}
