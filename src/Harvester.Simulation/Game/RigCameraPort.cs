using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>Makes the simulated camera each camera of a rig in turn.</summary>
internal sealed class RigCameraPort(SimulatedGame game) : IRigCamera
{
    public void Show(RigCamera camera, Pose mount) =>
        game.View = new MountedView(
            mount,
            camera.VerticalFovDegrees,
            camera.Image.Aspect,
            new RenderLens(camera.Lens.FocalScale, camera.Lens.CentreOffsetX, camera.Lens.CentreOffsetY, camera.Lens.K1, camera.Lens.K2)
        );
}
