// SPDX-License-Identifier: GPL-3.0-or-later
#include "writeParticleCloud.H"

#include "IOField.H"
#include "passiveParticleCloud.H"

namespace
{

template<class Type>
bool writeField
(
    const Foam::passiveParticleCloud& cloud,
    const Foam::word& name,
    const Foam::UList<Type>& values
)
{
    return Foam::IOField<Type>
    (
        cloud.fieldIOobject(name, Foam::IOobject::NO_READ),
        Foam::Field<Type>(values)
    ).write();
}

} // End anonymous namespace


bool Foam::writeParticleCloud
(
    const polyMesh& mesh,
    const labelUList& cells,
    const UList<vector>& positions,
    const UList<vector>& velocities,
    const UList<scalar>& radii,
    const labelUList& ids
)
{
    passiveParticleCloud cloud(mesh, "particles", IDLList<passiveParticle>());
    forAll(cells, i)
    {
        cloud.addParticle(new passiveParticle(mesh, positions[i], cells[i]));
    }
    bool written = cloud.write();
    written = writeField(cloud, "U", velocities) && written;
    written = writeField(cloud, "radius", radii) && written;
    return writeField(cloud, "id", ids) && written;
}
