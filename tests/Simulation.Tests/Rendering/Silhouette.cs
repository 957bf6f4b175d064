using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>The pixels of an entity in a rendered picture.</summary>
internal static class Silhouette
{
    public static int Count(RenderTarget target, int handle) => target.Handles.Count(own => own == handle);

    /// <summary>The box around the pixels that show the entity; null if none does.</summary>
    public static Box2D? BoxOf(RenderTarget target, int handle)
    {
        Box2D? box = null;
        for (int pixel = 0; pixel < target.Handles.Length; pixel++)
        {
            if (target.Handles[pixel] == handle)
            {
                int column = pixel % target.Width;
                int row = pixel / target.Width;
                var own = new Box2D(column, row, column + 1, row + 1);
                box = box?.Union(own) ?? own;
            }
        }

        return box;
    }
}
