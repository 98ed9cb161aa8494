// SPDX-License-Identifier: GPL-2.0-or-later
#include "normal_model_probe.h"

// The engine's headers need these three before all others.
#include <mpi.h>
// clang-format off
#include "fix_insert_stream.h"
#include "global_properties.h"
// clang-format on
#include <cmath>

#include "common/message.h"
#include "contact_model_base.h"
#include "contact_models.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace ContactModels;

/// Owner of a model that is only asked: has no history and counts no heat.
class NormalModelProbe::Quiet : public IContactHistorySetup, public ContactModelBase {
 public:
  explicit Quiet(LAMMPS* engine) : ContactModelBase(engine, false) {}
  int add_history_value(std::string, std::string) override { return 0; }
  void tally_pp(double, int, int, int) override {}
  void tally_pw(double, int, int, int) override {}
};

namespace {

using Maker = std::unique_ptr<NormalModelBase> (*)(LAMMPS*, IContactHistorySetup*,
                                                   ContactModelBase*);

template <int model>
std::unique_ptr<NormalModelBase> make(LAMMPS* lmp, IContactHistorySetup* history,
                                      ContactModelBase* base) {
  return std::unique_ptr<NormalModelBase>(new NormalModel<model>(lmp, history, base));
}

struct SupportedModel {
  const char* name;
  Maker maker;
};
/// The models of model-lists/style_normal_model.h, in which all must stand.
constexpr SupportedModel supported_models[] = {{"hooke", &make<HOOKE>},
                                               {"hooke/stiffness", &make<HOOKE_STIFFNESS>},
                                               {"hertz", &make<HERTZ>},
                                               {"hertz/stiffness", &make<HERTZ_STIFFNESS>}};

/// Over the radius: small against what contacts have, large against rounding.
constexpr double probe_overlap = 1e-4;

}  // namespace

NormalModelProbe::NormalModelProbe(LAMMPS* lmp, const std::function<bool(const char*)>& has)
    : quiet_(new Quiet(lmp)) {
  for (const SupportedModel& supported : supported_models) {
    if (!has(supported.name)) continue;
    name_ = supported.name;
    model_ = supported.maker(lmp, quiet_.get(), quiet_.get());
  }
  if (!model_)
    LAMMPS_NS::stop(lmp, FLERR,
                    "cohesion: the normal model of this contact stands in "
                    "model-lists/style_normal_model.h, but not among known_models in "
                    "liggghts-styles/normal_model_probe.cpp: add it there");
  // A restart file keeps no settings; some models leave theirs unset until they have registered.
  Settings defaults(lmp);
  model_->registerSettings(defaults);
}

NormalModelProbe::~NormalModelProbe() = default;

void NormalModelProbe::registerSettings(Settings& settings) { model_->registerSettings(settings); }

void NormalModelProbe::connect(PropertyRegistry& registry) {
  model_->connectToProperties(registry);
}

std::string_view NormalModelProbe::material_keyword() const {
  return has_pair_stiffness()    ? "material_stiffness"
         : has_elastic_modulus() ? "material_modulus"
                                 : "";
}

std::string_view NormalModelProbe::material_words() const {
  return has_pair_stiffness() ? "'material_stiffness on' with fix property/global materialStiffness"
         : has_elastic_modulus()
             ? "'material_modulus on' with fix property/global materialYoungsModulus"
             : "";
}

/// Of particles of radius 1: neither number depends on their size.
double NormalModelProbe::stiffness(int itype, int jtype, bool is_wall) const {
  const ProbedContact pair{itype, jtype, 1.0, 1.0, 1.0, 0.0, is_wall};
  if (has_pair_stiffness()) return springs(pair).stiffness;
  if (!has_elastic_modulus()) return 0.0;
  return springs(pair).hertz(pair.reduced_mass).reduced_modulus(is_wall ? 1.0 : 0.5);
}

double NormalModelProbe::exponent() const { return model_->stressStrainExponent(); }

/// What the model makes of a contact.
SurfacesIntersectData NormalModelProbe::contact_data(const ProbedContact& pair,
                                                     double overlap) const {
  SurfacesIntersectData contact;
  contact.is_wall = pair.is_wall;
  contact.itype = pair.itype;
  contact.jtype = pair.jtype;
  contact.radi = pair.radius_i;
  contact.radj = pair.radius_j;
  contact.radsum = pair.radius_i + (pair.is_wall ? 0.0 : pair.radius_j);
  contact.meff = contact.mi = contact.mj = pair.reduced_mass;
  contact.deltan = overlap > 0.0 ? overlap : probe_overlap * pair.radius_i;
  contact.r = contact.radsum - contact.deltan;
  contact.vn = -pair.speed;
  contact.en[0] = 1.0;
  contact.en[1] = contact.en[2] = 0.0;
  contact.computeflag = contact.shearupdate = 0;
  ForceData on_i, on_j;
  model_->surfacesIntersect(contact, on_i, on_j);

  return contact;
}

cohesion::advice::ContactSprings NormalModelProbe::springs(const ProbedContact& pair,
                                                           double overlap) const {
  const SurfacesIntersectData contact = contact_data(pair, overlap);
  cohesion::advice::ContactSprings springs{contact.kn, contact.gamman};
  springs.tangential_stiffness = springs.rolling_stiffness = contact.kt;
  springs.tangential_damping = contact.gammat;
  springs.exponent = exponent();
  springs.overlap = contact.deltan;
  // At 16 times the overlap a dashpot of the square root is 4 times as strong, one of the fourth
  // root twice.
  if (springs.exponent == 1.5 &&
      contact_data(pair, 16.0 * contact.deltan).gamman > 3.0 * contact.gamman)
    springs.power = cohesion::contact::HertzSpringDashpot::Damping::square_root;
  return springs;
}

cohesion::contact::NormalLaw NormalModelProbe::law(const ProbedContact& pair) const {
  using cohesion::contact::LinearSpringDashpot;
  const auto s = springs(pair);
  if (s.exponent == 1.0) return LinearSpringDashpot(s.stiffness, s.damping, pair.reduced_mass);
  cohesion::require(s.exponent == 1.5, "exponent of the spring", s.exponent,
                    "is neither 1, linear, nor 1.5, Hertz's");
  return s.hertz(pair.reduced_mass);
}

bool NormalModelProbe::dashpot_varies(int itype, int jtype) const {
  const auto damping = [&](double speed) {
    return springs({itype, jtype, 1.0, 1.0, 1.0, speed, false}).damping;
  };
  return damping(1.0) != damping(2.0);
}

bool NormalModelProbe::limits_force(int itype, int jtype) const {
  ProbedContact parting{itype, jtype, 1.0, 1.0, 1.0, 0.0, false};
  const double overlap = 1e-9;
  const auto springs_of = springs(parting, overlap);
  if (springs_of.damping == 0.0) return false;
  parting.speed = -2.0 * springs_of.stiffness * overlap / springs_of.damping;
  return contact_data(parting, overlap).Fn >= 0.0;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
