#include "method/contact_answer.hpp"

#include "contact/rules/contact_steps.hpp"

namespace weft {

Result<ContactAnswer> ContactAnswer::create(const SolverInputs& inputs, scene::SolverKind kind) {
  ContactAnswer made;
  if (inputs.contacts == nullptr) return made;
  if (inputs.contacts->pairs) {
    WEFT_TRY(respond, ContactRespond::create(inputs.device, inputs.state, *inputs.contacts->pairs,
                                             search_interval(kind), inputs.workgroup_size));
    made.respond_ = std::move(respond);
    return made;
  }
  WEFT_TRY(response,
           ContactResponse::create(inputs.device, inputs.state, *inputs.contacts, inputs.workgroup_size));
  made.response_ = std::move(response);
  return made;
}

Result<void> ContactAnswer::bind_lists(const State& state, const ContactPairs& pairs) {
  return respond_ ? respond_->bind(state, pairs) : Result<void>{};
}

void ContactAnswer::record(gpu::ComputePass& pass) const {
  if (response_) response_->record(pass);
  if (respond_) respond_->record(pass);
}

}  // namespace weft
