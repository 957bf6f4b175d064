using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Simulation.Game;

/// <summary>Moves the simulated camera on its car.</summary>
internal sealed class MountedCameraPort(SimulatedGame game) : IMountedCamera
{
    private Vector3D _offset;

    public void Shift(Vector3D offset)
    {
        Pose mount = game.CameraMount;
        game.CameraMount = mount with { Position = mount.Position - _offset + offset };
        _offset = offset;
    }
}
