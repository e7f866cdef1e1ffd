#include "contact/proximity/separation_rounds.hpp"

#include <string>

namespace weft::contact {

Result<SeparationRounds> SeparationRounds::create(gpu::Device& device, const std::string& path,
                                                  std::size_t count, std::uint32_t workgroup_size) {
  SeparationRounds made;
  made.rounds_.resize(count);
  for (std::size_t round = 0; round < count; ++round) {
    const gpu::Constant number{"kRound", separation_number(round, count)};
    const gpu::Constant is_first{"kFirst", round == 0 ? 1.0 : 0.0};
    WEFT_SET(made.rounds_[round].count.kernel,
             gpu::Kernel::create(device, path, {number, is_first}, workgroup_size));
    WEFT_SET(made.rounds_[round].give.kernel,
             gpu::Kernel::create(device, path, {number, is_first, {"kGives", 1}}, workgroup_size));
  }
  return made;
}

Result<void> SeparationRounds::bind(std::size_t parity, std::initializer_list<gpu::Binding> buffers) {
  for (Round& round : rounds_)
    for (Part* part : {&round.count, &round.give}) WEFT_SET(part->groups[parity], part->kernel.bind(buffers));
  return {};
}

}  // namespace weft::contact
