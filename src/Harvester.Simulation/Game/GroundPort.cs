using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Labels;

namespace Harvester.Simulation.Game;

/// <summary>The ground that the world was built with.</summary>
internal sealed class GroundPort(SimulatedGame game) : IGround
{
    public BirdsEyeSource Source => BirdsEyeSource.Exact;

    public IReadOnlyList<GroundFace> Near(Vector3D place, double range) => game.World.Ground.Near(place, range);
}
