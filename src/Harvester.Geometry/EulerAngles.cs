namespace Harvester.Geometry;

/// <summary>
/// A rotation as the game's scripting API gives it (rotation order 2), in degrees: R = Rz(yaw) · Rx(pitch) · Ry(roll). With all angles 0,
/// forward is +y. Used only where the program meets the game, the command line and files; inside, a rotation is <see cref="Axes"/>.
/// </summary>
/// <param name="PitchDegrees">About the x axis (right); positive raises the nose.</param>
/// <param name="RollDegrees">About the y axis (forward).</param>
/// <param name="YawDegrees">About the z axis (up); counter-clockwise from north.</param>
public readonly record struct EulerAngles(double PitchDegrees, double RollDegrees, double YawDegrees);
