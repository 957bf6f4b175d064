using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>An actor to put into a game's world.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Model">Name of the game's model, or of a class of models such as car; see docs/scenarios.md.</param>
/// <param name="Ground">Where its model's origin stands, on the ground, metres, world.</param>
/// <param name="HeadingDegrees">Direction in which it looks, degrees counter-clockwise from north.</param>
/// <param name="Speed">Its speed at the beginning, m/s, in that direction; 0 or more.</param>
/// <param name="Number">Chooses one of several models or colours, the same for the same number.</param>
public sealed record StageActor(StageKind Kind, string Model, Vector3D Ground, double HeadingDegrees, double Speed, int Number);
