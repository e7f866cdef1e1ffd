#include "contact/pushes/collision.hpp"

#include "contact/pushes/object_triangles.hpp"
#include "contact/pushes/push_scale.hpp"
#include "contact/rules/max_push.hpp"

namespace weft::contact {

Result<Collision> Collision::create(gpu::Device& device, const Model& model, const State& state,
                                    const Contacts& contacts, const CollisionSetup& setup) {
  Collision collision;
  collision.thickness_ = static_cast<float>(setup.thickness);
  if (setup.method == scene::ContactMethod::None) return collision;

  WEFT_TRY(triangles, object_triangles(setup.objects));
  collision.object_triangle_count_ = static_cast<std::uint32_t>(triangles.size());
  const double longest = weft::max_push(model.host, setup.thickness);
  collision.max_push_ = static_cast<float>(longest);
  collision.push_scale_ = contact::push_scale(
      {triangles_at_vertex(model.host), triangles.size(), setup.spheres.size() + setup.planes.size()},
      longest);

  if (!triangles.empty() && setup.method == scene::ContactMethod::Paper) {
    WEFT_TRY(paper, PairsPaper::create(device, model, state, contacts, triangles, setup.max_pairs,
                                       setup.workgroup_size));
    collision.paper_ = std::move(paper);
  }
  if (!triangles.empty() && setup.method == scene::ContactMethod::Bvh) {
    WEFT_TRY(bvh, PairsBvh::create(device, model, state, contacts, triangles, setup.workgroup_size,
                                   setup.triangles_each));
    collision.bvh_ = std::move(bvh);
  }
  if (!setup.spheres.empty() || !setup.planes.empty()) {
    WEFT_TRY(analytic, CollidersAnalytic::create(device, state, contacts, setup.spheres, setup.planes,
                                                 setup.workgroup_size));
    collision.analytic_ = std::move(analytic);
  }
  return collision;
}

void Collision::record(gpu::ComputePass& pass) const {
  if (paper_) paper_->record(pass);
  if (bvh_) bvh_->record(pass);
  if (analytic_) analytic_->record(pass);
}

std::size_t Collision::dispatch_count() const {
  return (paper_ ? paper_->dispatch_count() : 0) + (bvh_ ? 1 : 0) + (analytic_ ? 1 : 0);
}

}  // namespace weft::contact
