// SPDX-License-Identifier: GPL-3.0-or-later
#include "gasStep.H"

#include "coupling/input/readPositive.H"


Foam::gasStep::gasStep(coupledTime& time, const scalar particleStep, const bool continued)
:
    time_(time),
    particleStep_(particleStep)
{
    const scalar dt = time_.deltaTValue();
    const scalar steps = dt/particleStep_;
    // Both steps are decimal numbers: their ratio is whole to round-off when it is meant to be. But
    // OpenFOAM writes an adjusted step with writePrecision digits.
    const bool rounded = adjustable() && continued;
    if (!rounded && (steps < 0.5 || mag(steps - std::round(steps)) > 1e-9*steps))
    {
        FatalIOErrorInFunction(time_.controlDict())
            << "deltaT = " << dt << " s of the gas is " << steps << " steps of the particles, "
            << particleStep_ << " s: make it a whole multiple, for instance "
            << max(scalar(1), std::round(steps))*particleStep_ << exit(FatalIOError);
    }
    subSteps_ = max(label(1), label(std::round(steps)));
    if (rounded)
    {
        time.setDeltaT(subSteps_*particleStep_, false);
    }
    if (adjustable())
    {
        // Both read their entries of the case: what is wrong there stops the run as it begins.
        allowedSteps(0);
        stepsToNextOutput();
    }
}


bool Foam::gasStep::adjustable() const
{
    return time_.controlDict().getOrDefault("adjustTimeStep", false);
}


void Foam::gasStep::requireEntries(const Time& time)
{
    const dictionary& control = time.controlDict();
    if (control.getOrDefault("adjustTimeStep", false))
    {
        for (const char* entry : {"maxCo", "maxDeltaT"})
        {
            if (control.found(entry))
            {
                readPositive(control, entry);
            }
        }
    }
}


Foam::scalar Foam::gasStep::allowedSteps(const scalar courant)
{
    const dictionary& control = time_.controlDict();
    const scalar maxCo = control.found("maxCo") ? readPositive(control, "maxCo") : 1;
    scalar steps = max(subSteps_ + 1, label(1.2*subSteps_));
    if (courant > 0)
    {
        steps = min(steps, maxCo/courant*subSteps_);
    }
    if (control.found("maxDeltaT"))
    {
        // It may be meant to be a multiple.
        steps = min(steps, readPositive(control, "maxDeltaT")/particleStep_*(1 + 1e-9));
    }
    if (steps < 1 && warning_.due())
    {
        WarningOnceInFunction(warning_)
            << "maxCo and maxDeltaT ask for a gas step of " << steps*particleStep_
            << " s, shorter than the particles' " << particleStep_ << " s, which is taken; printed"
            << " once" << endl;
    }
    return max(scalar(1), std::floor(steps));
}


Foam::scalar Foam::gasStep::stepsToNextOutput() const
{
    const scalar start = time_.writtenFrom();
    scalar next = time_.endTime().value();
    const dictionary& control = time_.controlDict();
    // Time's own table of names is used: some of its controls have two.
    const auto writes = Time::writeControlNames.getOrDefault("writeControl", control, Time::wcTimeStep);
    if (writes == Time::wcAdjustableRunTime)
    {
        const scalar interval = readPositive(control, "writeInterval");
        // A time is met by the nearest particle step, that may be before it.
        const scalar since = time_.value() - start + 0.5*particleStep_;
        const scalar written = std::floor(since/interval + 1e-6);
        next = min(next, start + (written + 1)*interval);
    }
    return max(scalar(1), std::round((next - time_.value())/particleStep_));
}


void Foam::gasStep::adjust(Time& time, const scalar courant)
{
    if (!adjustable())
    {
        return;
    }
    // A time to be written is met in equal steps, the last ten of them.
    const scalar most = allowedSteps(courant);
    const scalar rest = stepsToNextOutput();
    subSteps_ = label(rest > 10*most ? most : std::floor(rest/std::ceil(rest/most)));
    // Time's own adjustment knows nothing of the particles' step.
    time.setDeltaT(subSteps_*particleStep_, false);
    Info<< "deltaT = " << time.deltaTValue() << ", " << subSteps_ << " steps of the particles" << endl;
}


void Foam::gasStep::requireSame(const scalar particleStep) const
{
    const scalar dt = time_.deltaTValue();
    if (mag(dt - subSteps_*particleStep) > 1e-9*dt)
    {
        FatalIOErrorInFunction(time_.controlDict())
            << "the gas step is now deltaT = " << dt << " s and that of the particles "
            << particleStep << " s, while it was set to " << subSteps_
            << " steps of the particles of " << particleStep_ << " s" << nl
            << "    Keep both while the case runs ('runTimeModifiable no;' for the gas); to change one,"
            << " stop, and continue with 'startFrom latestTime;'. 'adjustTimeStep yes;' adjusts the gas's"
            << exit(FatalIOError);
    }
}
