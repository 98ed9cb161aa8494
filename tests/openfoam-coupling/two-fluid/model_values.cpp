// SPDX-License-Identifier: GPL-3.0-or-later
// Makes models of twoPhaseEulerFoam by their names, as the solver does, and prints what they give
// in every cell of the case in which it is started, a line each: model, name, quantity, values.
// constant/models names them; the libraries of the case come with its controlDict.
#include "argList.H"
#include "dragModel.H"
#include "fvMesh.H"
#include "granularPressureModel.H"
#include "orderedPhasePair.H"
#include "radialModel.H"
#include "twoPhaseSystem.H"
#include "uniformDimensionedFields.H"

#include <cstdio>
#include <memory>

using namespace Foam;
using namespace Foam::kineticTheoryModels;

namespace {

void print(const char* model, const word& name, const char* quantity, const volScalarField& field) {
  std::printf("%s %s %s", model, name.c_str(), quantity);
  for (const scalar value : field.primitiveField()) std::printf(" %.17g", value);
  std::printf("\n");
}

volScalarField read(const char* name, const fvMesh& mesh) {
  return volScalarField(IOobject(name, mesh.time().timeName(), mesh, IOobject::MUST_READ), mesh);
}

/// The dictionary of settings with `name` under `entry`.
dictionary named(const dictionary& settings, const char* entry, const word& name) {
  dictionary dict(settings);
  dict.set(entry, name);
  return dict;
}

void print_drags(const dictionary& settings, const fvMesh& mesh, const dimensionedVector& g) {
  twoPhaseSystem fluid(mesh, g);
  phasePair::scalarTable sigma;
  sigma.insert(phasePairKey("particles", "air", false), 0);
  const orderedPhasePair pair(fluid.phase1(), fluid.phase2(), g, sigma, phasePair::dictTable());
  for (const word& name : settings.get<wordList>("drag")) {
    const auto drag = dragModel::New(named(settings, "type", name), pair);
    print("drag", name, "CdRe", drag->CdRe());
    print("drag", name, "K", drag->K());
  }
}

void print_kinetic_theory(const dictionary& settings, const fvMesh& mesh) {
  // Theta is looked up by its name.
  const volScalarField alpha(read("alpha.particles", mesh)), g0(read("g0", mesh)),
      slope(read("g0prime", mesh)), theta(read("Theta.particles", mesh)),
      rho(read("rho.particles", mesh));
  const dimensionedScalar e("e", dimless, settings), least("least", dimless, 0.5),
      most("alphaMax", dimless, settings);
  for (const word& name : settings.get<wordList>("radial")) {
    const dictionary dict(named(settings, "radialModel", name));
    const auto radial = radialModel::New(dict);
    print("radial", name, "g0", radial->g0(alpha, least, most));
    print("radial", name, "g0prime", radial->g0prime(alpha, least, most));
  }
  for (const word& name : settings.get<wordList>("pressure")) {
    const dictionary dict(named(settings, "granularPressureModel", name));
    const auto pressure = granularPressureModel::New(dict);
    print("pressure", name, "PsCoeff", pressure->granularPressureCoeff(alpha, g0, rho, e));
    print("pressure", name, "PsCoeffPrime",
          pressure->granularPressureCoeffPrime(alpha, g0, slope, rho, e));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const argList args(argc, argv);
  Time runTime(Time::controlDictName, args);
  const fvMesh mesh(
      IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ));
  const IOdictionary models(IOobject("models", runTime.constant(), mesh, IOobject::MUST_READ));
  const uniformDimensionedVectorField g(
      IOobject("g", runTime.constant(), mesh, IOobject::MUST_READ));
  print_drags(models, mesh, dimensionedVector(g));
  print_kinetic_theory(models, mesh);
}
