using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>Casts rays against the current shapes.</summary>
internal sealed class RayPort(SimulatedGame game) : ISurfaceRays
{
    private (RenderScene Shapes, SceneRayCaster Caster)? _current;

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => Reported(Current.Cast(ray, maxDistance, ignoredEntity));

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity, out Vector3D normal) =>
        Reported(Current.Cast(ray, maxDistance, ignoredEntity, out normal));

    private RayHit? Reported(RayHit? hit) => game.Quirks.HidesMaterials && hit is { } found ? found with { Material = 0 } : hit;

    private SceneRayCaster Current
    {
        get
        {
            RenderScene shapes = game.ShapesForRays;
            if (_current is not { } current || current.Shapes != shapes)
            {
                _current = current = (shapes, new SceneRayCaster(shapes));
            }

            return current.Caster;
        }
    }
}
