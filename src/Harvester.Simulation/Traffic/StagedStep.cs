using Harvester.Geometry;

namespace Harvester.Simulation.Traffic;

/// <summary>Where a staged actor is after a time step.</summary>
/// <param name="Ground">Its place on the ground, metres, world.</param>
/// <param name="Forward">Horizontal unit direction in which it looks.</param>
/// <param name="Along">Metres along its path.</param>
/// <param name="Speed">Metres per second.</param>
internal readonly record struct StagedStep(Vector3D Ground, Vector3D Forward, double Along, double Speed);
