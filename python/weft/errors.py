"""What can fail, by the engine's kinds. The text of each exception is one sentence with the value and its limit."""


class Error(Exception):
    """Anything that failed; of this class itself where no other fits, as a file that cannot be written."""


class InputError(Error, ValueError):
    """A scene, key, mesh, node or place is wrong or missing. The world is as before the call."""


class ShapeError(Error, ValueError):
    """An array is not as long as the world's. The world is as before the call."""


class LimitError(Error):
    """Larger than this GPU, or weft, allows. The world is as before the call."""


class DivergedError(Error):
    """A node is no longer finite. The state of the frame before can be read and drawn; `reset` begins again."""


class NoAdapterError(Error):
    """There is no GPU, or none of that name; `adapters` lists them."""


class DeviceError(Error):
    """The GPU gave up: only a new world goes on."""


class DeviceLostError(DeviceError):
    """The device is gone."""


class OutOfMemoryError(DeviceError):
    """The GPU has no memory left."""


class ShaderError(DeviceError):
    """A kernel does not compile, or a call of the GPU is invalid."""
