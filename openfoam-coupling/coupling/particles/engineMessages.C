// SPDX-License-Identifier: GPL-3.0-or-later
#include "engineMessages.H"

#include "Pstream.H"
#include "prefixOSstream.H"

using cohesion::coupling::Severity;


std::function<void(Severity, const std::string&)> Foam::engineMessages(const word& engine)
{
    return [engine](const Severity severity, const std::string& text)
    {
        const bool first = Pstream::master();
        if (severity == Severity::note)
        {
            Sout<< "Particle engine " << engine << ", " << text.c_str() << endl;
        }
        else
        {
            OSstream& log = severity == Severity::error ? (first ? Serr : Perr) : (first ? Sout : Pout);
            log << nl << "--> Particle engine " << engine << ':' << nl << text.c_str() << nl << endl;
        }
    };
}
