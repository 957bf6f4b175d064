using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>Casts rays against the current shapes.</summary>
internal sealed class RayPort(SimulatedGame game) : IRayCaster
{
    private SceneRayCaster? _caster;

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        RenderScene shapes = game.ShapesForRays;
        _caster ??= new SceneRayCaster(shapes);
        return _caster.Cast(ray, maxDistance, ignoredEntity);
    }
}
