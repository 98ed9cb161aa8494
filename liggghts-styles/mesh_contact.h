// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_MESH_CONTACT_H
#define COHESION_MESH_CONTACT_H

namespace LAMMPS_NS {
class FixMeshSurface;
}  // namespace LAMMPS_NS

// A mesh as one wall. The engine calls a contact model for each triangle that a particle is near;
// of triangles that lie in one plane it mostly does so for one. A wall attracts where its distance
// from the centre of the particle is smallest among the points around: once above a plane of any
// number of triangles, once above a ridge or a peak, and for each side of a groove.

namespace LIGGGHTS {
namespace Cohesion {

/// Whether the point of `triangle` that is nearest to the centre x of `particle` is such a place: a
/// point of its face always is, one of its border only when no triangle that meets it there comes
/// nearer. A point that the engine takes for one of several faces counts as the first one's.
bool carries_contact(LAMMPS_NS::FixMeshSurface& fix, int triangle, int particle, double* x,
                     double radius);

/// What the particle remembers of the triangle from which `triangle`, which carries the contact
/// now, has taken it over: one that carried it in step `last_step`, as the history value at
/// `step_offset` says, and whose nearest point has moved to its border with `triangle`. Null: none.
double* history_before(LAMMPS_NS::FixMeshSurface& fix, int triangle, int particle, double* x,
                       double radius, int step_offset, double last_step);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
