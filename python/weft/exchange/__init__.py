"""Files of other programs: a run's meshes as an animation, and meshes of USD (docs/export.md)."""
