using Harvester.Geometry;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Ports;

/// <summary>A game's camera that takes the places of all cameras of a rig in turn.</summary>
public interface IRigCamera
{
    /// <summary>
    /// Gives the camera the pose, field of view, shape and lens of a camera of a rig. The picture follows in one of the next ticks, also
    /// while the world is frozen.
    /// </summary>
    /// <param name="camera">The camera of the rig.</param>
    /// <param name="mount">Its pose in the frame of the vehicle's model.</param>
    void Show(RigCamera camera, Pose mount);
}
