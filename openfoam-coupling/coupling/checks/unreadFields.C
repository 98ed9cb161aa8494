// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "IFstream.H"
#include "fvMesh.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include "Time.H"

namespace
{

using namespace Foam;

//- What the case says of sources and function objects, as one text
std::string laterReaders(const fvMesh& mesh)
{
    OStringStream text;
    mesh.time().controlDict().subOrEmptyDict("functions").write(text, false);
    for (const word& folder : {mesh.time().constant(), mesh.time().system()})
    {
        const fileName file(mesh.time().globalPath()/folder/"fvOptions");
        if (isFile(file))
        {
            IFstream stream(file);
            dictionary(stream).write(text, false);
        }
    }
    return text.str();
}

//- Whether the name is a whole word of the text
bool names(const std::string& text, const std::string& name)
{
    const auto inWord = [&](const std::size_t at)
    {
        return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_');
    };
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
    {
        if (!(at > 0 && inWord(at - 1)) && !inWord(at + name.size()))
        {
            return true;
        }
    }
    return false;
}

} // End anonymous namespace


void Foam::warnOfUnreadFields(const fvMesh& mesh)
{
    if (!Pstream::master())
    {
        return;
    }
    const std::string later(laterReaders(mesh));
    std::string unread;
    for (const fileName& file : readDir(mesh.time().timePath(), fileName::FILE))
    {
        const word name(file);
        if (!file.hasExt("orig") && !mesh.thisDb().foundObject<regIOobject>(name) && !names(later, name))
        {
            unread += (unread.empty() ? "" : ", ") + name;
        }
    }
    if (unread.size())
    {
        Warning
            << "nothing reads the fields " << unread.c_str() << " in " << mesh.time().timePath().c_str() << nl
            << "    The gas has one temperature, and fields of a turbulence model are read with a"
            << " constant/turbulenceProperties that names it. Remove the files that are of another case" << nl << endl;
    }
}
