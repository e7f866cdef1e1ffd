#include "contact/pushes/pushes.hpp"

#include "contact/pushes/object_triangles.hpp"
#include "contact/pushes/push_scale.hpp"
#include "contact/rules/max_push.hpp"

namespace weft::contact {

Result<Pushes> Pushes::create(gpu::Device& device, const GpuModel& model, const State& state,
                              const Contacts& contacts, const PushSetup& setup) {
  Pushes made;
  WEFT_TRY(triangles, object_triangles(setup.objects));
  const double longest = weft::max_push(model.host, setup.thickness);
  made.max_push_ = static_cast<float>(longest);
  made.push_scale_ = contact::push_scale({triangles_at_vertex(model.host), triangles.size(),
                                          setup.spheres.size() + setup.planes.size(), setup.hulls.size()},
                                         longest);
  if (!triangles.empty() && setup.method == scene::ContactMethod::Paper) {
    WEFT_TRY(paper, PairsPaper::create(device, model, state, contacts, triangles, setup.max_pairs,
                                       setup.workgroup_size));
    made.paper_ = std::move(paper);
  }
  if (!triangles.empty() && setup.method == scene::ContactMethod::Bvh) {
    WEFT_TRY(bvh, PairsBvh::create(device, model, state, contacts, triangles, setup.workgroup_size,
                                   setup.triangles_each));
    made.bvh_ = std::move(bvh);
  }
  if (!setup.spheres.empty() || !setup.planes.empty()) {
    WEFT_TRY(analytic, CollidersAnalytic::create(device, state, contacts, setup.spheres, setup.planes,
                                                 setup.workgroup_size));
    made.analytic_ = std::move(analytic);
  }
  if (!setup.hulls.empty()) {
    WEFT_TRY(convex,
             CollidersConvex::create(device, model, state, contacts, setup.hulls, setup.workgroup_size));
    made.convex_ = std::move(convex);
  }
  WEFT_TRY(response, ContactResponse::create(device, state, contacts, setup.workgroup_size));
  made.response_ = std::move(response);
  return made;
}

void Pushes::measure(gpu::ComputePass& pass) const {
  if (paper_) paper_->record(pass);
  if (bvh_) bvh_->record(pass);
  if (analytic_) analytic_->record(pass);
  if (convex_) convex_->record(pass);
}

void Pushes::hold_back(gpu::ComputePass& pass) const { response_->record(pass); }

}  // namespace weft::contact
