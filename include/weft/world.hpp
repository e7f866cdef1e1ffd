#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "weft/adapter.hpp"
#include "weft/image.hpp"
#include "weft/placement.hpp"
#include "weft/report.hpp"
#include "weft/result.hpp"
#include "weft/scene.hpp"
#include "weft/totals.hpp"
#include "weft/vec.hpp"
#include "weft/view.hpp"

namespace weft {

/// The GPUs of this machine that weft can use, software rasterizers among them; none where there is no driver.
Result<std::vector<AdapterInfo>> adapters();

struct WorldOptions {
  std::string adapter;  // part of the GPU's name, in any case; empty: the fastest kind there is
};

// Of weft/native.hpp, for programs that use the GPU themselves.
struct NativeBuffer;
struct NativeDevice;
struct NativeTarget;

struct RunningWorld;  // what a World hides

/// One of a world's buffers on the GPU. Its elements are the nodes of all cloths, cloth after cloth: row by row on a
/// grid (node j * nx + i), in the order of its vertices on a mesh. Valid for as long as its World lives, also when
/// that is moved; reading always gives the state at the end of the last frame.
class Buffer {
 public:
  std::size_t count() const;  ///< elements
  std::size_t width() const;  ///< floats of an element: 3 of a vector, 1 of a number

  /// Copies the whole buffer to the host, element after element, and waits for it.
  /// Errors  Shape: values.size() is not count() * width(). DeviceLost, OutOfMemory.
  Result<void> read(std::span<float> values) const;
  /// The same for a buffer of vectors. Errors  Shape too where its width is not 3.
  Result<void> read(std::span<Vec3f> values) const;

  /// The buffer itself, for the caller's own GPU commands (weft/native.hpp). Nothing is waited for.
  NativeBuffer native() const;

 private:
  friend class World;
  friend struct RunningWorld;
  enum class Quantity { Position, Velocity, Normal, Stretch };
  Buffer(RunningWorld* world, Quantity quantity) : world_(world), quantity_(quantity) {}
  RunningWorld* world_;
  Quantity quantity_;
};

/// A running scene on a GPU device of its own, or on one of the caller's. It can be moved but not copied. Of one World,
/// one thread at a time may call functions; Worlds of different devices need no lock between them. A World that was
/// moved from may only be assigned to or destroyed.
class World {
 public:
  /// Opens the GPU, reads the scene's meshes and makes all that a frame needs. State: at rest, time 0.
  /// Errors  NoAdapter: there is no GPU of this name. Input: a mesh is missing or malformed, or the model cannot be
  ///         built. Limit: larger than the GPU allows. OutOfMemory, Shader, DeviceLost.
  static Result<World> create(const Scene& scene, const WorldOptions& options = {});
  /// The same on a device that the caller made and goes on using (weft/native.hpp).
  /// Errors  Input: a handle is null. Limit: a limit of the device is less than weft needs, which is named with both
  ///         numbers. The rest as create.
  static Result<World> create_on(const NativeDevice& device, const Scene& scene);
  World(World&& other) noexcept;
  World& operator=(World&& other) noexcept;
  ~World();

  /// Simulates frames: each of describe().frame_seconds. They are handed to the GPU; the host waits only where more
  /// than three are under way. Before a frame that sews cloth or tears it, nodes and triangles become others: buffers
  /// have their new numbers from then on, and native handles and triangles() are to be asked for again.
  /// Errors  Diverged: a node of an earlier frame is not finite; the state is that before this frame, and stays.
  ///         DeviceLost, OutOfMemory: only a new World goes on.
  Result<void> advance(std::uint32_t frames = 1);
  /// Waits until all frames are done and have reported. Errors  as advance.
  Result<void> finish();
  /// Back to the rest state at time 0, without grabs; values of change() stay. Errors  DeviceLost, OutOfMemory.
  Result<void> reset();

  std::uint32_t frame() const;  ///< frames so far
  double time() const;          ///< simulated [s]

  /// Changes a value of the running scene from the next frame on, as Scene::set: gravity, external_force, drag, wind
  /// and, where the scene has it, air.
  /// Errors  Input: not a valid scene, or the key cannot change while the cloth moves. Limit: the drag makes the step
  ///         unstable. The world stays as it was.
  Result<void> change(const std::string& key, const std::string& value);

  /// Grabs a free node and pulls it to `target` [m] from the next frame on, with limited speed; the cloth follows.
  /// Errors  Input: no such node; it is pinned, moved or grabbed already; the target is not finite. Limit: 1,024
  ///         nodes are grabbed.
  Result<void> grab(std::uint32_t node, const Vec3d& target);
  /// Pulls a grabbed node elsewhere [m]. Errors  Input: it is not grabbed, or the target is not finite.
  Result<void> drag(std::uint32_t node, const Vec3d& target);
  /// Lets a grabbed node go on with its velocity. Errors  Input: it is not grabbed.
  Result<void> release(std::uint32_t node);

  /// Sets the positions of all nodes [m], where the next frame begins; velocities stay. Waits for the frames before.
  /// The next frame begins as the first does: it knows no step before it, and no contact.
  /// Errors  Shape: positions.size() is not position().count(). Input: one is not finite, or a pinned or moved node
  ///         would leave its place. The state stays as it was. As finish.
  Result<void> set_positions(std::span<const Vec3f> positions);
  /// Sets the velocities of the free nodes [m/s]; those of pinned and moved nodes are not read. Waits for the frames
  /// before. Errors  as set_positions.
  Result<void> set_velocities(std::span<const Vec3f> velocities);
  /// Adds an impulse to each free node [N·s], at once: a force F that acts for a frame is F * frame_seconds. Waits for
  /// the frames before. Errors  as set_positions.
  Result<void> push(std::span<const Vec3f> impulses);

  /// Moves nodes of the scene's motions of kind "given" to places in the world [m]: straight and evenly through the
  /// next frame, and there they stay, as the others do where they are. Waits for the frames before.
  /// Errors  Shape: places.size() is not nodes.size(). Input: a node is not given; a place is not finite, or farther
  ///         than the motion's speed reaches in a frame. No node moves then. As finish.
  Result<void> move(std::span<const std::uint32_t> nodes, std::span<const Vec3f> places);
  /// The nodes that move() takes, in rising order.
  std::vector<std::uint32_t> given_nodes() const;

  /// Moves a collider of the scene that has a motion of kind "given", with all that is attached to it, to a place from
  /// where the scene puts it: through the next frame, at constant velocity and spin, which cloth in contact feels, and
  /// there it stays. Waits for nothing; called again before that frame, it counts instead.
  /// Errors  Input: `collider`, its place in the scene's list, has no such motion; a number is not finite, or the
  ///         rotation no unit quaternion; a point of it would go faster than the motion's speed. It does not move then.
  Result<void> set_collider(std::size_t collider, const Placement& placement);
  /// The colliders that set_collider() takes, in rising order.
  std::vector<std::size_t> given_colliders() const;

  Buffer position() const;  ///< [m]
  Buffer velocity() const;  ///< [m/s]
  Buffer normal() const;    ///< unit vectors
  Buffer stretch() const;   ///< length / rest length of the most stretched edge at the node
  /// The triangles of all cloths; they number nodes as the buffers do.
  std::span<const Triangle> triangles() const;
  /// The same on the GPU (weft/native.hpp).
  NativeBuffer native_triangles() const;

  /// XXH3-64 of the bits of all positions and velocities, as 16 hexadecimal digits: the same for the same scene,
  /// GPU, driver and version. Errors  DeviceLost, OutOfMemory.
  Result<std::string> state_hash();
  /// The present shape as a file of the format "obj", "ply" or "glb", with normals and texture coordinates.
  /// Errors  Input: another format. DeviceLost, OutOfMemory.
  Result<std::vector<std::byte>> mesh_file(const std::string& format);

  /// The whole state as bytes once all frames have reported, to go on from in a world of the same scene, now or on
  /// another day: positions, velocities, forces of contact, time, gusts, grabs, totals; 32 to some 200 bytes a node.
  /// Errors  as finish.
  Result<std::vector<std::byte>> save_state();
  /// Goes on from such bytes, also where this world has diverged. True where they come from this version of the
  /// library and this GPU: then the run ends in the bits of one that never stopped.
  /// Errors  Input: cut off, spoiled, no such bytes, or of another scene; the world stays as it was. Limit, DeviceLost,
  ///         OutOfMemory.
  Result<bool> open_state(std::span<const std::byte> bytes);

  /// What was loaded, and what was chosen for it.
  Description describe() const;
  /// Sums over the frames that have reported: after finish(), all.
  const Totals& totals() const;
  const AdapterInfo& adapter() const;
  /// The device that this world is on, whoever made it (weft/native.hpp).
  NativeDevice native_device() const;
  std::uint64_t gpu_bytes() const;  ///< that this world's device holds

  /// Draws the state at the end of the last frame, and waits for the picture. The first call of a size and view makes
  /// what it needs, later ones use it.
  /// Errors  Input: a side is 0, or the scene lacks what the view shows. Limit: larger than the GPU can draw.
  ///         DeviceLost, OutOfMemory, Shader.
  Result<Image> draw(const PictureOptions& options = {});

  /// Draws into a texture of the caller's, all of it, without a legend (weft/native.hpp). The commands go to the
  /// device's queue, after the frames that were handed over; nothing is waited for. The first call of a format, size
  /// and view makes what it needs, later ones use it.
  /// Errors  Input: the texture cannot be drawn into, or the scene lacks what the view shows. Shader: the texture is
  ///         of another device. Limit, DeviceLost, OutOfMemory.
  Result<void> draw_into(const NativeTarget& target, const ViewOptions& options = {});

  /// The first cloth that a ray meets, from either side, in the state at the end of the last frame, and waits for it;
  /// none where there is no cloth. Obstacles hide nothing, and triangles are those of the nodes, also where
  /// render.subdivide shows finer ones.
  /// Errors  Input: a coordinate is not finite, or the direction is 0. DeviceLost, OutOfMemory.
  Result<std::optional<Picked>> pick(const Ray& ray);
  /// The same along the ray through the place (x, y) of the picture that draw(options) makes: from the left and from
  /// the top [pixel], so that a pixel's middle is at half numbers.
  /// Errors  Input: a side is 0, or the place is outside the picture. DeviceLost, OutOfMemory.
  Result<std::optional<Picked>> pick(double x, double y, const PictureOptions& options = {});

 private:
  explicit World(std::unique_ptr<RunningWorld> running);
  std::unique_ptr<RunningWorld> running_;
};

/// Writes a picture as a PNG file, whole or not at all. Errors  Failure: the place cannot be written.
Result<void> write_png(const std::string& path, const Image& image);

}  // namespace weft
