#include "contact/proximity/round_kernel.hpp"

namespace weft::contact {

std::vector<Round> separation_rounds(std::size_t count) {
  std::vector<Round> rounds;
  for (std::size_t round = 0; round < count; ++round) {
    const auto number = static_cast<std::uint32_t>(kMostSeparations + 1 + round - count);
    rounds.push_back({.number = number, .since = round == 0 ? 0 : number - 1});
  }
  return rounds;
}

std::vector<Round> holding_rounds(bool self) {
  std::vector<Round> rounds;
  std::uint32_t number = kMostSeparations + 1, since = kMostSeparations;
  for (std::size_t round = 0; round < (self ? kRounds : 1); ++round) {
    rounds.push_back({.number = number,
                      .is_first = round == 0 ? 1U : 0U,
                      .is_last = self && round + 1 == kRounds ? 1U : 0U,
                      .since = since});
    since = number;
    number += round == 0 ? kShortenings + 1 : 1;
  }
  return rounds;
}

std::vector<Round> shortening_rounds() {
  std::vector<Round> rounds;
  for (std::size_t round = 0; round < kShortenings; ++round) {
    const auto number = static_cast<std::uint32_t>(kMostSeparations + 2 + round);
    rounds.push_back({.number = number,
                      .is_last = round + 1 == kShortenings ? 1U : 0U,
                      .since = round == 0 ? 0 : number - 1});
  }
  return rounds;
}

Result<RoundKernel> RoundKernel::create(gpu::Device& device, const std::string& path,
                                        std::vector<gpu::Constant> constants, std::span<const Round> rounds,
                                        std::uint32_t workgroup_size) {
  RoundKernel made;
  WEFT_SET(made.kernel_, gpu::Kernel::create(device, path, std::move(constants), workgroup_size));
  for (const Round& round : rounds) {
    WEFT_TRY(buffer, gpu::create_uniform(device, round, "round"));
    made.rounds_.push_back(std::move(buffer));
  }
  return made;
}

Result<void> RoundKernel::bind(std::size_t parity, std::initializer_list<gpu::Binding> buffers) {
  groups_[parity].clear();
  for (const gpu::RawBuffer& round : rounds_) {
    std::vector<gpu::Binding> all = {round};
    all.insert(all.end(), buffers.begin(), buffers.end());
    WEFT_TRY(group, kernel_.bind(all));
    groups_[parity].push_back(std::move(group));
  }
  return {};
}

Result<SeparationRounds> SeparationRounds::create(gpu::Device& device, const std::string& path,
                                                  std::size_t rounds, std::uint32_t workgroup_size) {
  SeparationRounds made;
  const std::vector<Round> all = separation_rounds(rounds);
  WEFT_SET(made.count, RoundKernel::create(device, path, {}, all, workgroup_size));
  WEFT_SET(made.give, RoundKernel::create(device, path, {{"kGives", 1}}, all, workgroup_size));
  return made;
}

Result<void> SeparationRounds::bind(std::size_t parity, std::initializer_list<gpu::Binding> buffers) {
  WEFT_CHECK(count.bind(parity, buffers));
  return give.bind(parity, buffers);
}

}  // namespace weft::contact
