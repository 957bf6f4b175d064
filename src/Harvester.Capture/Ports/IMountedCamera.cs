using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>A camera that the harvester can move on the vehicle that carries it.</summary>
public interface IMountedCamera
{
    /// <summary>
    /// Moves the camera away from its mounting point; <see cref="Vector3D.Zero"/> moves it back. The picture follows in one of the next
    /// ticks, or once a frozen world resumes.
    /// </summary>
    /// <param name="offset">Offset from the mounting point, vehicle frame, metres.</param>
    void Shift(Vector3D offset);
}
