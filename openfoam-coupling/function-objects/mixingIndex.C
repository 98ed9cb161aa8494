// SPDX-License-Identifier: GPL-3.0-or-later
#include "mixingIndex.H"

#include "ListOps.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"

#include "coupling/exchange/meshCells.H"

#include <vector>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(mixingIndex, 0);
    addToRunTimeSelectionTable(functionObject, mixingIndex, dictionary);
}
}


Foam::functionObjects::mixingIndex::mixingIndex
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    particleFunctionObject(name, runTime, dict),
    first_(folder()/"places"),
    images_(1, vector::zero),
    up_(Zero),
    cells_(Zero),
    layers_(0)
{
    read(dict);
    writeCommented(file(), "Time");
    writeTabbed(file(), "Lacey index [1]");
    writeTabbed(file(), "cells with particles");
    writeTabbed(file(), "particles");
    file() << endl;
    active();
}


bool Foam::functionObjects::mixingIndex::read(const dictionary& dict)
{
    particleFunctionObject::read(dict);
    warnOfUnknown(dict, {{"cells"}, {"layers"}, {"direction"}});
    up_ = readDirection(dict);
    cells_ = dict.get<Vector<label>>("cells");
    layers_ = dict.getOrDefault<label>("layers", 2);
    if (cmptMin(cells_) < 1)
    {
        FatalIOErrorInFunction(dict)
            << name() << ": cells = " << cells_ << ": must each be at least 1, as in (9 10 1)"
            << exit(FatalIOError);
    }
    if (layers_ < 2)
    {
        FatalIOErrorInFunction(dict)
            << name() << ": layers = " << layers_ << ": must be at least 2" << exit(FatalIOError);
    }
    setColours();
    return true;
}


void Foam::functionObjects::mixingIndex::begin()
{
    images_ = particles().images();
    if (!first_.restore(pastUntil()))
    {
        first_.store(time_.value(), time_.timeName(), particles().ids(), particles().positions());
    }
    Info<< name() << ": particles are coloured by their places at " << first_.time() << " s" << endl;
    setColours();
    if (atStart() && !continued())
    {
        write();
    }
}


void Foam::functionObjects::mixingIndex::setColours()
{
    const scalarField heights(pointField(first_.positions()) & up_);
    labelList order;
    sortedOrder(heights, order);
    colours_.setSize(order.size());
    forAll(order, rank)
    {
        colours_[order[rank]] = label(int64_t(rank)*layers_/order.size());
    }
}


Foam::label Foam::functionObjects::mixingIndex::cell(const point& position) const
{
    const boundBox& box = mesh_.bounds();
    // The particle engine takes particles back through periodic faces only now and then.
    const point inside(position + meshCells::minimumImageShift(images_, position - box.midpoint()));
    label cell = 0;
    for (direction d = 3; d-- > 0; )
    {
        // Centres on the outermost faces are of the outermost cells.
        const label i((inside[d] - box.min()[d])/box.span()[d]*cells_[d]);
        cell = cell*cells_[d] + max(label(0), min(i, cells_[d] - 1));
    }
    return cell;
}


cohesion::bed::Mixing Foam::functionObjects::mixingIndex::mixing() const
{
    const UList<point> positions(particles().positions());
    const UList<int> ids(particles().ids());
    labelList counts(cmptProduct(cells_)*layers_, Zero);
    forAll(positions, i)
    {
        const label index = first_.index(ids[i]);
        if (index >= 0)
        {
            ++counts[cell(positions[i])*layers_ + colours_[index]];
        }
    }
    Pstream::listCombineGather(counts, plusEqOp<label>());
    return cohesion::bed::lacey_index
    (
        std::vector<long>(counts.begin(), counts.end()),
        std::size_t(layers_)
    );
}


bool Foam::functionObjects::mixingIndex::write()
{
    if (active())
    {
        const auto found = mixing();
        writeCurrentTime(file());
        file()
            << tab << found.index << tab << label(found.cells) << tab << label(found.particles)
            << endl;
    }
    return true;
}
