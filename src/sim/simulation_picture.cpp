// What pictures show of a run beside its cloth.
#include "sim/simulation.h"

namespace nuno {

LastPass Simulation::last_pass() const
{
    LastPass pass;
    pass.level = last_level_;
    if (pass.level == CollisionLevel::discrete) pass.contacts = collision_->contacts();
    if (pass.level == CollisionLevel::spheres) pass.sphere_pairs = collision_->sphere_pairs();
    if (sees_ahead(pass.level) && layers_) pass.foreseen = layers_->foreseen();
    if (pass.level >= CollisionLevel::continuous && layers_) pass.impacts = layers_->impacts();
    return pass;
}

}  // namespace nuno
