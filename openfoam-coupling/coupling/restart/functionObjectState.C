// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjectState.H"

#include "IOdictionary.H"
#include "Time.H"
#include "functionObjectList.H"
#include "timeControlFunctionObject.H"

namespace
{

//- The function object itself, without the wrapper that controls when it is executed
Foam::functionObject& unwrapped(Foam::functionObject& object)
{
    using Foam::functionObjects::timeControl;
    const timeControl* const wrapper = dynamic_cast<const timeControl*>(&object);
    return wrapper ? const_cast<Foam::functionObject&>(wrapper->filter()) : object;
}

//- Whether writing leaves the averages as they are
bool continuesAfterWrite(const Foam::Time& time, const Foam::word& name)
{
    const Foam::dictionary* const functions = time.controlDict().findDict("functions");
    const Foam::dictionary* const entries = functions ? functions->findDict(name) : nullptr;
    return !entries || !entries->getOrDefault("restartOnOutput", false);
}

//- Removes the state of averages that have not begun: a continued run would count from it.
void removeNotBegun(Foam::dictionary& state, const Foam::word& name)
{
    Foam::dictionary* const averages = state.findDict(name);
    if (!averages)
    {
        return;
    }
    for (const Foam::word& field : averages->toc())
    {
        const Foam::dictionary* const average = averages->findDict(field);
        if (average && average->getOrDefault<Foam::label>("totalIter", 1) < 1)
        {
            averages->remove(field);
        }
    }
}

} // End anonymous namespace


bool Foam::writeFunctionObjectState(const Time& time)
{
    functionObjectList& list = const_cast<functionObjectList&>(time.functionObjects());
    IOdictionary& state = list.stateDict();
    bool written = true;
    for (label i = 0; i < list.size(); ++i)
    {
        functionObject& object = unwrapped(list[i]);
        if (object.type() == "fieldAverage" && continuesAfterWrite(time, object.name()))
        {
            const bool log = object.log;
            object.log = false;
            written = object.write() && written;
            object.log = log;
            removeNotBegun(state, object.name());
        }
    }
    // All digits of the times
    const unsigned int digits = IOstream::defaultPrecision();
    IOstream::defaultPrecision(max(digits, 17u));
#if OPENFOAM >= 2012
    written = state.regIOobject::writeObject(IOstreamOption(IOstream::ASCII), true) && written;
#else
    written = state.regIOobject::writeObject
    (
        IOstream::ASCII, IOstream::currentVersion, time.writeCompression(), true
    )
     && written;
#endif
    IOstream::defaultPrecision(digits);
    return written;
}
