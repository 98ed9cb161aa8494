// SPDX-License-Identifier: GPL-3.0-or-later
#include "writeParticleCloud.H"

#include "Cloud.H"
#include "IOField.H"
#include "passiveParticle.H"

namespace
{

template<class Type>
bool writeField
(
    const Foam::Cloud<Foam::passiveParticle>& cloud,
    const Foam::word& name,
    const Foam::UList<Type>& values
)
{
    return Foam::IOField<Type>
    (
        Foam::IOobject(name, cloud.time().timeName(), cloud, Foam::IOobject::NO_READ, Foam::IOobject::NO_WRITE),
        Foam::Field<Type>(values)
    ).write();
}

} // End anonymous namespace


bool Foam::writeParticleCloud(const polyMesh& mesh, const particleRows& particles)
{
    // What passiveParticleCloud is made from has changed with the releases, what its base class is made from has not.
    Cloud<passiveParticle> cloud(mesh, "particles", IDLList<passiveParticle>());
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
