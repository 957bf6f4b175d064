using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Ports;

/// <summary>
/// A world whose entities can be read in steps, because a reading takes longer than a tick may. While the game is frozen, the steps of one
/// reading may be spread over several ticks.
/// </summary>
public interface IStepwiseWorld : IWorld
{
    /// <summary>Reads what <see cref="IWorld.ReadEntities"/> reads, a few natives at a time.</summary>
    /// <param name="centre">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    /// <param name="entities">Receives the entities.</param>
    IEnumerable<WorkStep> ReadEntitiesInSteps(Vector3D centre, double range, List<EntityState> entities);
}
