// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "IFstream.H"
#include "Time.H"
#include "argList.H"

#include "coupling/input/readPositive.H"
#include "coupling/sixDigits.H"

void Foam::requireTimes(const argList& args)
{
    // All ranks read it, as OpenFOAM's Time does.
    IFstream file(args.globalPath()/"system"/Time::controlDictName);
    if (!file.good())
    {
        return;
    }
    const dictionary control(file);
    // Time itself asks for what is missing.
    for (const char* entry : {"deltaT", "writeInterval", "writeFrequency"})
    {
        if (control.found(entry))
        {
            readPositive(control, entry);
        }
    }
}


bool Foam::hasTimeLeft(const Time& time, const bool continued)
{
    const scalar start = time.startTime().value();
    const scalar end = time.endTime().value();
    if (end > start + 0.5*time.deltaTValue())
    {
        return true;
    }
    const std::string ends(sixDigits(end));
    if (continued && end > start - 0.5*time.deltaTValue())
    {
        Info<< "The case has reached endTime = " << ends.c_str() << " s: there is nothing left to compute" << nl
            << "    A later endTime in system/controlDict continues it" << nl << "End" << nl << endl;
        return false;
    }
    FatalIOErrorInFunction(time.controlDict())
        << "endTime = " << ends.c_str() << " s is not after the start at " << sixDigits(start).c_str()
        << " s: no step would be computed" << nl << "    Give an endTime that is at least one deltaT = "
        << sixDigits(time.deltaTValue()).c_str() << " s later, or another start" << exit(FatalIOError);
    return false;
}
