// What is known to be the same for all invocations of a workgroup, so that barriers may follow.
var<workgroup> is_one_idle : u32;

// Of the first invocation, for all.
fn are_all_idle(local : u32, is_idle : bool) -> bool {
  if (local == 0u) { is_one_idle = select(0u, 1u, is_idle); }
  return workgroupUniformLoad(&is_one_idle) == 1u;
}
