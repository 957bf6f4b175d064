using Harvester.Geometry;

namespace Harvester.Simulation.Settings;

/// <summary>Where something is at one step of a replay.</summary>
/// <param name="Centre">Centre of its box, metres, world. The replay puts it onto the ground below; the height only tells which road that
/// is where one passes over another.</param>
/// <param name="Heading">Direction of its front on the ground, radians counter-clockwise from the x axis.</param>
/// <param name="Velocity">On the ground, metres per second, world.</param>
public readonly record struct ReplayState(Vector3D Centre, double Heading, Vector2D Velocity);
