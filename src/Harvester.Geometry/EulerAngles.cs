namespace Harvester.Geometry;

/// <summary>
/// A rotation as the game's scripting API gives it (rotation order 2), in degrees: R = Rz(yaw) · Rx(pitch) · Ry(roll).
/// Forward is +y at rest. Only the edges of the program speak in these; inside, a rotation is <see cref="Axes"/>.
/// </summary>
/// <param name="PitchDegrees">About the x axis (right); positive lifts the nose.</param>
/// <param name="RollDegrees">About the y axis (forward).</param>
/// <param name="YawDegrees">About the z axis (up); counter-clockwise from north.</param>
public readonly record struct EulerAngles(double PitchDegrees, double RollDegrees, double YawDegrees);
