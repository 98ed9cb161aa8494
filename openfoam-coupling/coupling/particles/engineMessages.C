// SPDX-License-Identifier: GPL-3.0-or-later
#include "engineMessages.H"

#include "Pstream.H"
#include "prefixOSstream.H"

using cohesion::coupling::MessageLevel;


std::function<void(MessageLevel, const std::string&)> Foam::engineMessages(const word& engine)
{
    return [engine](const MessageLevel level, const std::string& text)
    {
        const bool first = Pstream::master();
        if (level == MessageLevel::note)
        {
            Sout<< "Particle engine " << engine << ", " << text.c_str() << endl;
        }
        else
        {
            OSstream& log = level == MessageLevel::error ? (first ? Serr : Perr) : (first ? Sout : Pout);
            log << nl << "--> Particle engine " << engine << ':' << nl << text.c_str() << nl << endl;
        }
    };
}
