// The rows of benchmarks as lines for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/contact.hpp"
#include "bench/copy.hpp"
#include "bench/largest.hpp"
#include "bench/methods.hpp"
#include "bench/multigrid.hpp"
#include "bench/row.hpp"

namespace weft::cli {

nlohmann::ordered_json json_of(const bench::Timing& timing);

/// The kernels of each part of a frame on a line of its own.
void print_kernels(const std::vector<sim::KernelTime>& kernels);
/// Adds `kernels`, where the adapter has timestamps.
void add_kernels(nlohmann::ordered_json& json, const std::vector<sim::KernelTime>& kernels);

void print_head();
void print(const bench::Row& row);
nlohmann::ordered_json json_of(const bench::Row& row);

void print_contact_head();
void print(const bench::ContactRow& row);
nlohmann::ordered_json json_of(const bench::ContactRow& row);

void print(const bench::CopyRow& row);
nlohmann::ordered_json json_of(const bench::CopyRow& row);

void print_sheet_head();
void print(const bench::SheetRow& row);
nlohmann::ordered_json json_of(const bench::SheetRow& row);

void print(const bench::LargestRow& row);
nlohmann::ordered_json json_of(const bench::LargestRow& row);

}  // namespace weft::cli
