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


bool Foam::writeParticleCloud(const polyMesh& mesh, const particleRows& particles)
{
    passiveParticleCloud cloud(mesh, "particles", IDLList<passiveParticle>());
    forAll(particles.cells, i)
    {
        cloud.addParticle(new passiveParticle(mesh, particles.positions[i], particles.cells[i]));
    }
    bool written = cloud.write();
    written = writeField(cloud, "U", particles.velocities) && written;
    written = writeField(cloud, "radius", particles.radii) && written;
    written = writeField(cloud, "id", particles.ids) && written;
    written = writeField(cloud, "type", particles.types) && written;
    return writeField(cloud, "gasForce", particles.gasForces) && written;
}
