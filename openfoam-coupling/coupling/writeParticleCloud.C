// SPDX-License-Identifier: GPL-3.0-or-later
#include "writeParticleCloud.H"

#include "IOField.H"
#include "passiveParticleCloud.H"

namespace
{

template<class Type>
void writeField
(
    const Foam::passiveParticleCloud& cloud,
    const Foam::word& name,
    const Foam::UList<Type>& values
)
{
    Foam::IOField<Type>
    (
        cloud.fieldIOobject(name, Foam::IOobject::NO_READ),
        Foam::Field<Type>(values)
    ).write();
}

} // End anonymous namespace


void Foam::writeParticleCloud
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
    cloud.write();
    writeField(cloud, "U", velocities);
    writeField(cloud, "radius", radii);
    writeField(cloud, "id", ids);
}
